#!/usr/bin/python3
"""thesis.launch: one agent trains, its table is shared with a crowd, and the figures of the run are printed."""
import itertools
import os
import re
import shutil

import numpy
import support
from launching import EPISODES, LaunchTestCase
from learning_files import QTableFile
from social_crowd.msg import EpisodeResult, LearnerStatus

AGENTS = 6
TRAINING = 5  # episodes with one obstacle; twice as many follow


class ThesisTest(LaunchTestCase):
    """The whole launch, with a short training."""

    def show(self, **arguments):
        """Starts the launch; its files are in the folder of the test."""
        return self.launch('thesis.launch', **dict(
            {'scenario': 'circle6', 'real_time_factor': 'fast', 'episodes': EPISODES, 'training_episodes': TRAINING,
             'data_folder': self.folder, 'seed': 3}, **arguments))

    def rows(self, name):
        """Returns the rows of a table that was saved."""
        return QTableFile(self.path(name)).rows

    def crowd_rows(self):
        """Returns the rows of the tables of all agents of the crowd."""
        return [self.rows(f'crowd_agent_{agent}.txt') for agent in range(AGENTS)]

    def episodes(self, name):
        """Returns the number of episodes in a record."""
        return len({line.split(',')[0] for line in support.read_text(self.path(name)).splitlines()[1:]})

    def check_figures(self, launched, results):
        """Checks the last column of the printed table against the results of the crowd."""
        printed = dict(re.findall(r'^([a-z][^:#\n]*?) {2,}.* (\S+)$', launched.output(), re.MULTILINE))
        agents = [agent for result in results for agent in result.agents]
        rates = {name: f'{100 * sum(getattr(agent, field) for agent in agents) / len(agents):.1f}'
                 for name, field in (('success', 'arrived'), ('collision', 'collided'), ('contact', 'touched'))}
        expected = {
            'episodes': str(len(results)), 'agents': str(AGENTS),
            **{f'{name} [%]': rate for name, rate in rates.items()},
            'distance gained per step [m]': f'{numpy.median([agent.gain_per_tick for agent in agents]):.4f}',
            'path per distance gained': f'{numpy.median([agent.path_per_gain for agent in agents]):.3f}'}
        self.assertEqual(printed, expected)

    def test_all_agents_walk_with_the_shared_table(self):
        """Without learning, the tables do not change, and the crowd walks as it does without ROS. The scenario has the
        name of a record."""
        topic = self.listen('episode_results', EpisodeResult)
        scenario = shutil.copy(support.CIRCLE6, self.path('crowd.yaml'))
        launched = self.show(scenario=scenario)
        self.assert_ends_well(launched)
        self.assert_says(launched.output(), 'the Q-table of agent 0: replaced the table of agents 1, 2, 3, 4, 5',
                         'without learning', self.path('paths.png'), self.path('learning.png'))
        learned = self.rows('learned.txt')
        self.assertGreater(len(learned), 100)
        self.assertEqual(self.crowd_rows(), [learned] * AGENTS)
        self.check_figures(launched, topic.messages)
        self.tool('evaluate', '--q-table', self.path('learned.txt'), '--episodes', EPISODES, '--seed', 3, '--record',
                  self.path('headless.csv'), '--trajectories', self.path('headless'), scenario)
        self.assertEqual(support.read_text(self.path('crowd.csv')), support.read_text(self.path('headless.csv')))
        self.assertEqual(support.read_text(self.path('trajectories/crowd.csv')),
                         support.read_text(self.path('headless/crowd.csv')))
        for picture in ('paths.png', 'learning.png'):
            self.assertGreater(os.path.getsize(self.path(picture)), 10_000)

    def test_watched_training_and_a_crowd_that_goes_on_learning(self):
        """The training gives the table that the program train gives; then each agent learns in its own table."""
        topic, status = self.listen('episode_results', EpisodeResult), self.listen('learner_status', LearnerStatus)
        launched = self.show(state_set=1, training='watched', learning='true', crowd_epsilon=0.125, episodes=1)
        self.assert_ends_well(launched)
        self.assert_says(launched.output(), 'and goes on learning')
        self.check_figures(launched, topic.messages[-1:])
        self.tool('train', self.path('single_obstacle.yaml'), '--output', self.path('single.txt'))
        self.tool('train', self.path('training_field.yaml'), '--q-table', self.path('single.txt'), '--output',
                  self.path('both.txt'))
        learned = self.rows('learned.txt')
        self.assertEqual(learned, self.rows('both.txt'))
        # All results are in the records; the first ones may come before this test is connected.
        self.assertEqual([self.episodes(name) for name in ('one_obstacle.csv', 'several_obstacles.csv', 'crowd.csv')],
                         [TRAINING, 2 * TRAINING, 1])
        self.assertEqual([name for name, _ in itertools.groupby(result.scenario for result in topic.messages)],
                         ['single_obstacle', 'training_field', 'circle6'])
        tables = self.crowd_rows()
        self.assertTrue(all(a != b for i, a in enumerate(tables) for b in [learned, *tables[:i]]))
        self.assertEqual((status.messages[-1].mode, status.messages[-1].epsilon), ('training', 0.125))

    def test_interrupted(self):
        """Ctrl-C while the crowd walks: the tables are saved, and the figures of the finished episodes are printed."""
        topic = self.listen('episode_results', EpisodeResult)
        launched = self.show(ends='false', episodes=1000)
        topic.wait(what='of the crowd')
        self.assertEqual(launched.stop(), 0)
        self.assert_no_complaint(launched, 'WARN|ERROR|FATAL')
        self.assertEqual(self.crowd_rows(), [self.rows('learned.txt')] * AGENTS)
        self.assert_says(launched.output(), 'distance gained per step [m]')

    def test_crowd_walks_on_after_the_figures(self):
        """With ends:=false the launch stays."""
        topic = self.listen('episode_results', EpisodeResult)
        launched = self.show(ends='false', episodes=1.0)
        topic.wait(lambda _: 'the crowd walks on' in launched.output() and len(topic.messages) > 1, 'after the figures')
        self.assertEqual(launched.stop(), 0)
        self.assertEqual(launched.output().count('distance gained per step [m]'), 1)

    def test_wrong_arguments(self):
        """All of them are named, before anything is trained."""
        launched = self.show(state_set='true', scenario='circle_6', training='slow', training_episodes=0,
                             learning='maybe', real_time_factor=-1, crowd_epsilon=2, epsilon='{from: 0.3')
        self.assert_ends_with(
            launched, "~state_set: expected 1 or 2, got 'True'", "no scenario 'circle_6', did you mean 'circle6'?",
            "~training: expected fast or watched, got 'slow'",
            "~training_episodes: expected a whole number from 1, got '0'", '~learning: expected true or false',
            "~real_time_factor: expected 'fast' or a number from 0", '~crowd_epsilon: expected a number from 0 to 1',
            '~epsilon: not YAML: ')
        self.assertNotIn('trains alone', launched.output())

    def test_wrong_epsilon(self):
        """It is refused by the learner, as a part of the training configuration."""
        self.assert_ends_with(self.show(epsilon=2), 'learning.epsilon', "got '2'")


if __name__ == '__main__':
    support.run('thesis_launch_test')
