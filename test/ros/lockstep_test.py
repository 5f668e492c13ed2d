#!/usr/bin/python3
"""Runs with and without ROS give the same recordings and tables, bit for bit."""
import math

import rospy
import support
from learning_files import QTableFile, checksum_of, config_text
from roslib.packages import find_node
from walking import EPISODES, SCENARIO, WalkTestCase


class DemoTest(WalkTestCase):
    """Demo mode: compares the recording of the run through ROS with that of `evaluate`."""

    def check(self, table):
        """Compares the recordings; learners run already."""
        expected = self.headless(SCENARIO, table, episodes=EPISODES, seed=5)
        self.assert_same_recording(self.walk(), expected)
        if table != support.ANTICIPATION_TABLE:  # agents that anticipate may have no blocked moves
            self.assertGreater(self.blocked, 0, 'the solid scenario should block some moves')

    def check_one_learner(self, table):
        """One learner serves all agents."""
        self.start_learner(q_table=table)
        self.check(table)

    def check_two_learners(self, table):
        """Two learners serve three agents each."""
        self.start_learner('learner_a', q_table=table, agents=[0, 1, 2])
        self.start_learner('learner_b', q_table=table, agents=[3, 4, 5])
        self.check(table)

    def check_crew(self, table):
        """Each agent has its own learner."""
        self.start_node('learner_crew', 'learner_crew', {'learner/q_table': table})
        self.check(table)

    def test_one_learner_nearest(self):
        self.check_one_learner(support.NEAREST_TABLE)

    def test_one_learner_occupancy(self):
        self.check_one_learner(support.OCCUPANCY_TABLE)

    def test_one_learner_anticipation(self):
        self.check_one_learner(support.ANTICIPATION_TABLE)

    def test_two_learners_nearest(self):
        self.check_two_learners(support.NEAREST_TABLE)

    def test_two_learners_occupancy(self):
        self.check_two_learners(support.OCCUPANCY_TABLE)

    def test_two_learners_anticipation(self):
        self.check_two_learners(support.ANTICIPATION_TABLE)

    def test_crew_nearest(self):
        self.check_crew(support.NEAREST_TABLE)

    def test_crew_occupancy(self):
        self.check_crew(support.OCCUPANCY_TABLE)

    def test_crew_in_a_name_space_from_the_command_line(self):
        """The learners are in the name space of the crew."""
        name = f'{self.namespace}/learner_crew'
        rospy.set_param(f'{name}/learner/q_table', support.NEAREST_TABLE)
        command = find_node('social_crowd', 'learner_crew')[:1] + [f'__ns:={self.namespace}']
        self.start('learner_crew', command, {'ROS_NAMESPACE': '/'})
        self.check(support.NEAREST_TABLE)

    def test_another_seed_gives_another_recording(self):
        """Otherwise the tests above would not detect that the controller ignores its seed."""
        recordings = [self.headless(SCENARIO, episodes=EPISODES, seed=seed) for seed in (5, 6)]
        self.assertNotEqual(*recordings)

    def test_occlusion(self):
        """Occlusion, with at most 16 neighbours."""
        table = self.train_anticipation('vision: {occlusion: true}')
        expected = self.headless(SCENARIO, table, episodes=EPISODES, seed=5)
        self.start_learner(q_table=table)
        self.assert_same_recording(self.walk(), expected)

    def test_ties_broken_at_random(self):
        """A table with few visits, so that most values are equal; random numbers depend on the seed only."""
        config = self.write('config.yaml', config_text(support.CIRCLE6, 1, learning='{ties: random}'))
        table = self.path('table.txt')
        self.tool('train', config, '--output', table)
        first = self.write('first.txt', without_random_ties(support.read_text(table)))
        recordings = [self.headless(SCENARIO, file, episodes=EPISODES, seed=5) for file in (first, table)]
        self.assertNotEqual(*recordings)
        self.start_learner('learner_a', q_table=table, seed=5, agents=[0, 1, 2])
        self.start_learner('learner_b', q_table=table, seed=5, agents=[3, 4, 5])
        self.assert_same_recording(self.walk(), recordings[1])

    def test_bodies_at_the_edge_of_vision(self):
        """A body exactly at the radius of vision is perceived in both runs or in neither."""
        scenario = self.write('edge.yaml', edge_scenario())
        self.start_learner()
        expected = self.headless(scenario)
        self.assert_same_recording(self.walk(scenario, episodes=1), expected)


class TrainingTest(support.CrowdTestCase):
    """Training mode: compares the table learned through ROS with that of `train`."""

    EPISODES = 7
    SEED = 3
    LEARNING = '{alpha: 0.2, gamma: 0.9, lambda: 0.8, epsilon: {from: 0.6, to: 0.1, episodes: 4}}'

    def train_headless(self, scenario, tables):
        """Trains without ROS. Returns the paths of configuration and table, and the number of decisions."""
        text = config_text(scenario, self.EPISODES, self.SEED, tables, self.LEARNING)
        config = self.write('config.yaml', text)
        table = self.path('headless.txt')
        self.tool('train', config, '--output', table)
        return config, table, QTableFile(table).header['decisions']

    def walk(self, scenario):
        """Walks the episodes through ROS."""
        controller = self.start_controller(scenario, episodes=self.EPISODES, seed=self.SEED)
        self.assertEqual(controller.wait(), 0)

    def saved_after(self, learner, decisions):
        """Returns the table of agent 0, saved after this number of decisions."""
        self.wait_until_learned(learner, decisions)
        file = self.path('ros.txt')
        self.succeed(f'{learner}/save_q_table', file=file, overwrite=True)
        return file

    def check(self, scenario, tables, **parameters):
        """One learner for all agents: tables saved by service and at the end equal that of `train`, byte for byte."""
        config, headless, decisions = self.train_headless(scenario, tables)
        learner = self.start_learner(mode='training', config=config, tables=tables, seed=self.SEED,
                                     save_to=self.path('at_end.txt'), **parameters)
        self.walk(scenario)
        saved = self.saved_after('learner', decisions)
        self.assertEqual(support.read_text(saved), support.read_text(headless))
        self.assertEqual(learner.stop(), 0)
        return support.read_text(headless)

    def test_one_agent_with_its_own_table(self):
        scenario = support.in_package('config', 'scenarios', 'training_single.yaml')
        expected = self.check(scenario, 'own')
        self.assertEqual(support.read_text(self.path('at_end_agent_0.txt')), expected)

    def test_many_agents_with_a_shared_table(self):
        expected = self.check(SCENARIO, 'shared')
        self.assertEqual(support.read_text(self.path('at_end.txt')), expected)

    def test_many_agents_with_own_tables(self):
        expected = self.check(SCENARIO, 'own')
        self.assertEqual(support.read_text(self.path('at_end_agent_0.txt')), expected)
        others = [support.read_text(self.path(f'at_end_agent_{agent}.txt')) for agent in range(1, 6)]
        self.assertEqual(len(set(others + [expected])), 6, 'each agent should have learned on its own')

    def test_ties_broken_at_random(self):
        self.LEARNING = '{alpha: 0.2, gamma: 0.9, lambda: 0.8, epsilon: 0, ties: random}'
        self.assertIn('\nties: random\n', self.check(SCENARIO, 'shared'))

    def test_a_learner_for_each_agent(self):
        """The rows are the same; each learner counts the decisions of its own agent only."""
        config, headless, _ = self.train_headless(SCENARIO, 'own')
        parameters = {'mode': 'training', 'config': config, 'tables': 'own', 'seed': self.SEED,
                      'data_folder': self.folder}
        self.start_node('learner_crew', 'learner_crew',
                        {f'learner/{name}': value for name, value in parameters.items()})
        self.walk(SCENARIO)
        expected = QTableFile(headless)
        saved = QTableFile(self.saved_after('learner_0', expected.visits()))
        self.assertEqual(saved.rows, expected.rows)
        self.assertEqual(dict(saved.header, decisions=0), dict(expected.header, decisions=0))


def without_random_ties(text):
    """Returns the Q-table file with ties broken by the first action."""
    text = text.rpartition('checksum: ')[0].replace('\nties: random\n', '\n')
    return f'{text}checksum: {checksum_of(text)}\n'


def edge_scenario():
    """Returns a scenario of distant agents, each with an obstacle whose rim is exactly 1 m away, in many directions."""
    lines = ['name: edge', 'duration: 1', 'goal_tolerance: 0.1', 'agents:']
    obstacles = ['obstacles:']
    for i in range(400):
        x, y = 20.0 * (i % 20), 20.0 * (i // 20)
        bearing = 0.1 + 0.0157 * i
        ahead = (x + 1.4 * math.cos(bearing), y + 1.4 * math.sin(bearing))
        goal = (x + 5 * math.cos(bearing), y + 5 * math.sin(bearing))
        lines.append(f'  - {{position: [{x!r}, {y!r}], goal: [{goal[0]!r}, {goal[1]!r}], speed: 0.3, radius: 0.25}}')
        obstacles.append(f'  - {{position: [{ahead[0]!r}, {ahead[1]!r}], radius: 0.4}}')
    return '\n'.join(lines + obstacles) + '\n'


if __name__ == '__main__':
    support.run('lockstep_test')
