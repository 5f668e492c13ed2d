#!/usr/bin/python3
"""Launch files: they end without intervention, write their files, and report errors."""
import os

import rosbag
import rospy
import support
from geometry_msgs.msg import Point, Pose2D
from launching import EPISODES, LaunchTestCase
from learning_files import QTableFile, config_text
from social_crowd.msg import AgentState, AgentStates, LearnerStatus, Scenario
from visualization_msgs.msg import MarkerArray

SCENARIO = support.data('lockstep.yaml')
SCHEDULE = '{from: 0.8, to: 0.1, episodes: 4, shape: exponential}'


class DemoTest(LaunchTestCase):
    """demo.launch."""

    def check(self, **arguments):
        """Runs a demo that writes a recording. Returns the recording."""
        launched = self.demo(scenario=SCENARIO, trajectories=self.path('ros'), seed=5, **arguments)
        self.assert_ends_well(launched)
        self.assert_says(launched.output(), 'episode 0 (circle', 'episode 1 (walls_and_moving_obstacles',
                         f'{EPISODES} episodes')
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

    def test_nodelets_interrupted(self):
        launched = self.launch('demo.launch', nodelets='true')
        rospy.wait_for_service(f'{self.namespace}/learner/set_mode', support.PATIENCE)
        self.listen('agents', AgentStates).wait(what='that they walk')
        self.assertEqual(launched.stop(), 0)
        self.assert_no_complaint(launched, 'ERROR|FATAL')

    def test_training_with_simulated_time_and_frames(self):
        """All other arguments in one launch."""
        self.addCleanup(rospy.delete_param, '/use_sim_time')
        self.assert_ends_well(self.demo(scenario=SCENARIO, mode='training', tables='own', learners='per_agent',
                                        tf='true', clock='true', save_to=self.path('table.txt'), save_every=1,
                                        on_share='merge'))
        self.assertEqual(self.tables(), [f'table_agent_{agent}.txt' for agent in range(6)])

    def tables(self):
        """Returns the names of the existing Q-table files."""
        return sorted(name for name in os.listdir(self.folder) if name.startswith('table'))

    def test_table_is_saved_after_an_interrupt(self):
        launched = self.launch('demo.launch', mode='training', save_to=self.path('table.txt'))
        self.listen('agents', AgentStates).wait(lambda states: states.tick > 5, 'that they walk')
        self.assertEqual(launched.stop(), 0)
        before = QTableFile(support.ANTICIPATION_TABLE).header['decisions']
        self.assertGreater(QTableFile(self.path('table.txt')).header['decisions'], before)
        self.assertNotIn('not be saved', launched.output())

    def test_learners_per_agent_write_different_files(self):
        self.assert_ends_well(self.demo(mode='training', learners='per_agent', save_to=self.path('table.txt'),
                                        episodes=1))
        self.assertEqual(self.tables(), [f'table_agent_{agent}.txt' for agent in range(6)])

    def test_warns_if_nothing_is_saved(self):
        launched = self.demo(mode='training', episodes=1)
        self.assertEqual(launched.wait(), 0, launched.output())
        self.assert_says(launched.output(), 'what is learned will not be saved', 'save_to')

    def test_some_agents_with_another_learner(self):
        """The other learner decides for the other agents, and all agents arrive."""
        self.start_learner('my_learner', agents=[1, 4], q_table=support.ANTICIPATION_TABLE)
        for given in ({}, {'learners': 'per_agent'}):
            status = self.listen('learner_status', LearnerStatus)
            launched = self.demo(agents='[0,2,3,5]', episodes=1, paused='true', **given)

            def served():
                return {agent for message in list(status.messages) if 'my_learner' not in message.node
                        for agent in message.agents}

            # While it is paused: afterwards the learners end.
            support.wait_for(lambda: served() == {0, 2, 3, 5}, 'the status of the learners')
            self.succeed('crowd_controller/pause', data=False)
            self.assert_ends_well(launched)
            self.assert_says(launched.output(), '6 of 6 agents arrived', ' 0 answers missed')
            self.assertEqual(served(), {0, 2, 3, 5})

    def test_passes_on_share_to_the_learner(self):
        self.assert_ends_with(self.demo(on_share='add'), '~on_share', "'add'")

    def test_epsilon_argument_reaches_all_learners(self):
        """The argument, a number or a schedule, reaches one learner and learners per agent; default: the table's."""
        status, agents = self.listen('learner_status', LearnerStatus), self.listen('agents', AgentStates)
        header = QTableFile(support.ANTICIPATION_TABLE).header
        for given, expected in (({'epsilon': 0}, 0.0), ({'epsilon': SCHEDULE, 'learners': 'per_agent'}, 0.8),
                                ({}, header['epsilon']), ({'learners': 'per_agent'}, header['epsilon'])):
            status.messages.clear()
            agents.messages.clear()
            launched = self.launch('demo.launch', mode='training', **given)
            told = status.wait(what='the status of a learner')
            agents.wait(what='a tick')  # a node that is interrupted while it starts ends with an error
            self.assertEqual((told.mode, told.epsilon), ('training', expected), given)
            self.assertEqual(launched.stop(), 0)

    def test_services_use_the_data_folder(self):
        for learners, node in (('one', 'learner'), ('per_agent', 'learner_0')):
            folder = self.path(learners)
            launched = self.launch('demo.launch', learners=learners, data_folder=folder)
            self.succeed(f'{node}/save_q_table', file='table.txt')
            self.succeed('crowd_controller/save_scenario', file='floor.yaml')
            self.assertEqual(sorted(os.listdir(folder)), ['floor.yaml', 'table.txt'])
            self.refuse(f'{node}/load_q_table', '~allow_any_path', file=support.ANTICIPATION_TABLE)
            self.assertEqual(launched.stop(), 0)
            launched = self.launch('demo.launch', learners=learners, data_folder=folder, allow_any_path='true')
            self.succeed(f'{node}/load_q_table', file=support.ANTICIPATION_TABLE)
            self.succeed('crowd_controller/load_scenario', scenario=support.CIRCLE6)
            self.assertEqual(launched.stop(), 0)

    def test_scenario_by_name(self):
        self.assert_ends_well(self.demo(episodes=1))

    def test_interrupted(self):
        launched = self.launch('demo.launch', learners='per_agent')
        rospy.wait_for_service(f'{self.namespace}/learner_5/set_mode', support.PATIENCE)
        self.assertEqual(launched.stop(), 0)
        self.assert_no_complaint(launched, 'ERROR|FATAL')

    def test_wrong_learners(self):
        self.assert_ends_with(self.demo(learners='two'), 'learners: expected one, per_agent or none', "'two'")

    def test_missing_scenario(self):
        self.assert_ends_with(self.demo(scenario='wakers6'), support.in_package('config', 'scenarios'),
                              "no scenario 'wakers6', did you mean 'walkers6'?")

    def test_missing_q_table(self):
        missing = self.path('missing.txt')
        self.assert_ends_with(self.demo(q_table=missing), f'~q_table: {missing}')

    def test_missing_q_table_with_a_learner_for_each_agent(self):
        missing = self.path('missing.txt')
        self.assert_ends_with(self.demo(q_table=missing, learners='per_agent'), f'~q_table: {missing}')


class TrainTest(LaunchTestCase):
    """train.launch."""

    def test_writes_a_usable_table(self):
        file = self.path('trained.txt')
        config = self.write('config.yaml', config_text(SCENARIO, 1))
        self.assert_ends_well(self.launch('train.launch', output=file, config=config, episodes=3, seed=2))
        table = QTableFile(file)
        self.assertGreater(table.header['decisions'], 100)
        self.assertEqual(table.header['seed'], 2)
        self.assertIn('circle6', self.tool('evaluate', '--q-table', file, '--episodes', 1, support.CIRCLE6))

    def test_uses_scenarios_episodes_and_seed_of_the_configuration(self):
        """Training through ROS gives the same table as training without ROS, bit for bit; epsilon is an argument."""
        text = config_text(f'{SCENARIO}, circle6', 3, seed=7, tables='own',
                           learning=f'{{alpha: 0.2, gamma: 0.9, epsilon: {SCHEDULE}}}')
        config = self.write('config.yaml', text)
        without = self.write('without.yaml', text.replace(SCHEDULE, '0'))
        launched = self.launch('train.launch', output=self.path('ros.txt'), config=without, epsilon=SCHEDULE)
        self.assert_ends_well(launched)
        self.assert_says(launched.output(), 'episode 0 (circle,', 'episode 1 (walls_and_moving_obstacles,',
                         'episode 2 (')
        self.tool('train', config, '--output', self.path('headless.txt'))
        self.assertEqual(support.read_text(self.path('ros_agent_0.txt')), support.read_text(self.path('headless.txt')))

    def test_arguments_override_the_configuration(self):
        config = self.write('config.yaml', config_text(SCENARIO, 3, seed=7))
        launched = self.launch('train.launch', output=self.path('table.txt'), config=config, scenario='circle6',
                               episodes=1, seed=5, tables='shared')
        self.assert_ends_well(launched)
        self.assert_says(launched.output(), 'episode 0 (circle6, instance 0)')
        self.assertEqual(QTableFile(self.path('table.txt')).header['seed'], 5)

    def test_refuses_learners_side_by_side(self):
        config = self.write('config.yaml', config_text(SCENARIO, 1).replace('tables: shared', 'side_by_side: 4'))
        launched = self.launch('train.launch', output=self.path('table.txt'), config=config)
        self.assertEqual(launched.wait(), 0, launched.output())
        self.assert_says(launched.output(), '4 learners side by side', "differ from that of 'train'")

    def test_continues_from_a_table(self):
        file = self.path('trained.txt')
        self.assert_ends_well(self.launch('train.launch', output=file, q_table=support.NEAREST_TABLE, episodes=2,
                                          tables='own', save_every=1))
        before = QTableFile(support.NEAREST_TABLE).header['decisions']
        self.assertGreater(QTableFile(self.path('trained_agent_0.txt')).header['decisions'], before)

    def test_requires_output(self):
        launched = self.launch('train.launch')
        self.assertNotEqual(launched.wait(), 0)
        self.assert_says(launched.output(), 'output')

    def test_missing_configuration(self):
        missing = self.path('missing.yaml')
        launched = self.launch('train.launch', output=self.path('trained.txt'), config=missing, episodes=1)
        self.assert_ends_with(launched, f'~config: {missing}')
        self.assertFalse(os.path.exists(self.path('trained.txt')))


class ReplayTest(LaunchTestCase):
    """replay.launch."""

    def record(self):
        """Returns a bag of an agent that walked 0.5 m, and of another agent beside it. Then both stand, so that the
        last picture is drawn before the launch ends."""
        agents = [AgentState(agent=i, pose=Pose2D(0.0, i, 0.0), radius=0.25, goal=Point(3.0, i, 0.0)) for i in range(2)]
        with rosbag.Bag(self.path('walk.bag'), 'w') as bag:
            messages = [('scenario', Scenario(name='two', agents=agents))]
            for tick in range(1, 101):
                moved = [AgentState(agent=i, pose=Pose2D(0.05 * min(tick, 10), i, 0.0), radius=0.25) for i in range(2)]
                messages.append(('agents', AgentStates(tick=tick, agents=moved)))
            for i, (topic, message) in enumerate(messages):
                bag.write(f'{self.namespace}/{topic}', message, rospy.Time(1000.0 + 0.05 * i))
        return self.path('walk.bag')

    def test_shows_a_recording_as_markers(self):
        """Without RViz the launch ends with the recording."""
        markers = self.listen('recording/markers', MarkerArray)
        # Left over from an earlier launch; has no effect.
        rospy.set_param(f'{self.namespace}/recording/crowd_markers/rate', -1.0)
        launched = self.launch('replay.launch', bag=self.record())

        def tip_of_a_path(array):
            points = [point for marker in array.markers if marker.ns == 'paths' for point in marker.points]
            return any(abs(point.x - 0.5) < 1e-6 for point in points)
        markers.wait(tip_of_a_path, 'with a path to the place of the last tick')
        self.assert_ends_well(launched)

    def test_missing_bag(self):
        launched = self.launch('replay.launch', bag=self.path('missing.bag'))
        self.assert_ends_with(launched, f"there is no file {self.path('missing.bag')}")

    def test_relative_path_is_refused_with_the_absolute_path(self):
        launched = self.launch('replay.launch', bag='walk.bag')
        self.assert_ends_with(launched, 'there is no file /', '/walk.bag; give an absolute path')

    def test_file_of_another_format(self):
        launched = self.launch('replay.launch', bag=self.write('no.bag', 'no bag'))
        self.assert_ends_with(launched, f"{self.path('no.bag')} is not a bag")

    def test_requires_a_recording(self):
        self.assert_ends_with(self.launch('replay.launch'), 'no recording is given', 'bag:=FILE or trajectories:=FILE')


if __name__ == '__main__':
    support.run('launch_files_test')
