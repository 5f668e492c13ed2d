#!/usr/bin/python3
"""The launch files: they end by themselves, leave what they promise, and say what is wrong."""
import os
import re

import rospy
import support
from learning_files import QTableFile, recipe_text
from social_crowd.msg import AgentStates, LearnerStatus

SCENARIO = support.data('lockstep.yaml')
EPISODES = 2


class LaunchTestCase(support.CrowdTestCase):
    """Runs roslaunch."""

    def launch(self, file, **arguments):
        """Starts a launch file; its nodes wait for answers as long as it takes on a busy machine."""
        rospy.set_param(f'{self.namespace}/crowd_controller/answer_deadline', 60.0)
        words = [f'{name}:={value}' for name, value in arguments.items()]
        return self.start('roslaunch', ['roslaunch', 'social_crowd', file, 'rviz:=false', *words])

    def demo(self, **arguments):
        """Starts demo.launch as fast as it goes, for a few episodes."""
        return self.launch('demo.launch', **dict({'pace': 'fast', 'episodes': EPISODES}, **arguments))

    def assert_ends_well(self, launched):
        """Checks that a launch ends by itself and that nothing went wrong on the way."""
        self.assertEqual(launched.wait(), 0, launched.output())
        self.assert_no_complaint(launched, 'WARN|ERROR|FATAL')

    def assert_no_complaint(self, launched, levels):
        """Checks that nodes said nothing of these levels, and that all ended as they should."""
        complaints = re.findall(rf'.*\[ ?(?:{levels})\].*|.*(?:exit code|escalating|Traceback).*', launched.output())
        self.assertEqual(complaints, [])

    def assert_ends_with(self, launched, *words):
        """Checks that a launch ends by itself and says why."""
        launched.wait()
        self.assert_says(launched.output(), *words)


class DemoTest(LaunchTestCase):
    """demo.launch."""

    def check(self, **arguments):
        """The recording is that of a run without ROS."""
        launched = self.demo(scenario=SCENARIO, trajectories=self.path('ros'), seed=5, **arguments)
        self.assert_ends_well(launched)
        self.assert_says(launched.output(), 'episode 0 (circle', 'episode 1 (walls_and_movers', f'{EPISODES} episodes')
        return support.read_bytes(self.path('ros/lockstep.csv'))

    def test_one_learner(self):
        recording = self.check(q_table=support.NEAREST_TABLE)
        self.assert_same_recording(recording, self.headless(SCENARIO, episodes=EPISODES, seed=5))

    def test_a_learner_for_each_agent(self):
        recording = self.check(q_table=support.OCCUPANCY_TABLE, learners='per_agent')
        expected = self.headless(SCENARIO, support.OCCUPANCY_TABLE, episodes=EPISODES, seed=5)
        self.assert_same_recording(recording, expected)

    def test_nodelets(self):
        recording = self.check(q_table=support.NEAREST_TABLE, nodelets='true')
        self.assert_same_recording(recording, self.headless(SCENARIO, episodes=EPISODES, seed=5))

    def test_nodelets_stopped_by_hand(self):
        launched = self.launch('demo.launch', nodelets='true')
        rospy.wait_for_service(f'{self.namespace}/learner/set_mode', support.PATIENCE)
        self.listen('agents', AgentStates).wait(what='that they walk')
        self.assertEqual(launched.stop(), 0)
        self.assert_no_complaint(launched, 'ERROR|FATAL')

    def test_training_with_simulated_time_and_frames(self):
        """Everything else that it offers, at once."""
        self.addCleanup(rospy.delete_param, '/use_sim_time')
        self.assert_ends_well(self.demo(scenario=SCENARIO, mode='training', tables='own', learners='per_agent',
                                        tf='true', clock='true'))

    def test_a_demo_that_keeps_learning(self):
        """The argument reaches learners of either kind; without it epsilon is the table's, also after a run with it."""
        status = self.listen('learner_status', LearnerStatus)
        header = QTableFile(support.ANTICIPATION_TABLE).header
        for given, expected in (({'epsilon': 0}, 0.0), ({'epsilon': 0.125, 'learners': 'per_agent'}, 0.125),
                                ({}, header['epsilon']), ({'learners': 'per_agent'}, header['epsilon'])):
            status.messages.clear()
            launched = self.launch('demo.launch', mode='training', **given)
            told = status.wait(what='the status of a learner')
            self.assertEqual((told.mode, told.epsilon), ('training', expected), given)
            self.assertEqual(launched.stop(), 0)

    def test_by_name(self):
        self.assert_ends_well(self.demo(episodes=1))

    def test_stopped_by_hand(self):
        launched = self.launch('demo.launch', learners='per_agent')
        rospy.wait_for_service(f'{self.namespace}/learner_5/set_mode', support.PATIENCE)
        self.assertEqual(launched.stop(), 0)
        self.assert_no_complaint(launched, 'ERROR|FATAL')

    def test_wrong_learners(self):
        self.assert_ends_with(self.demo(learners='two'), 'learners: expected one or per_agent', "'two'")

    def test_no_such_scenario(self):
        file = support.in_package('config', 'scenarios', 'no_such_scenario.yaml')
        self.assert_ends_with(self.demo(scenario='no_such_scenario'), file)

    def test_no_such_q_table(self):
        missing = self.path('missing.txt')
        self.assert_ends_with(self.demo(q_table=missing), f'~q_table: {missing}')

    def test_no_such_q_table_for_a_learner_each(self):
        missing = self.path('missing.txt')
        self.assert_ends_with(self.demo(q_table=missing, learners='per_agent'), f'~q_table: {missing}')


class TrainTest(LaunchTestCase):
    """train.launch."""

    def test_it_leaves_a_table_that_can_be_used(self):
        file = self.path('trained.txt')
        recipe = self.write('recipe.yaml', recipe_text(SCENARIO, 1))
        self.assert_ends_well(self.launch('train.launch', output=file, config=recipe, episodes=3, seed=2))
        table = QTableFile(file)
        self.assertGreater(table.header['decisions'], 100)
        self.assertEqual(table.header['seed'], 2)
        self.assertIn('circle6', self.tool('evaluate', '--q-table', file, '--episodes', 1, support.CIRCLE6))

    def test_it_goes_on_from_a_table(self):
        file = self.path('trained.txt')
        self.assert_ends_well(self.launch('train.launch', output=file, q_table=support.NEAREST_TABLE, episodes=2,
                                          tables='own', save_every=1))
        before = QTableFile(support.NEAREST_TABLE).header['decisions']
        self.assertGreater(QTableFile(self.path('trained_agent_0.txt')).header['decisions'], before)

    def test_output_must_be_given(self):
        launched = self.launch('train.launch')
        self.assertNotEqual(launched.wait(), 0)
        self.assert_says(launched.output(), 'output')

    def test_no_such_configuration(self):
        missing = self.path('missing.yaml')
        launched = self.launch('train.launch', output=self.path('trained.txt'), config=missing, episodes=1)
        self.assert_ends_with(launched, f'~config: {missing}')
        self.assertFalse(os.path.exists(self.path('trained.txt')))


if __name__ == '__main__':
    support.run('launch_files_test')
