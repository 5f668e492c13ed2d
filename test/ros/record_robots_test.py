#!/usr/bin/python3
"""record_robots: results of robots through ROS, in the format of `evaluate --robots-csv`."""
import csv

import rospy
import support
from robot_launching import RobotLaunchTestCase
from social_crowd.msg import EpisodeResult, RobotState, RobotStates
from social_crowd.srv import Reset, ResetResponse

EPISODES = 2


class RecordRobotsTest(RobotLaunchTestCase):
    """The recorder in robot_lab.launch, and alone."""

    def rows(self, name):
        """Returns the header and the rows of a record in the test's folder."""
        with open(self.path(name), newline='', encoding='utf-8') as file:
            reader = csv.DictReader(file)
            return reader.fieldnames, list(reader)

    def test_columns_are_those_of_evaluate_and_values_those_of_the_messages(self):
        scenario = support.in_package('config', 'scenarios', 'robots', 'robot_crossing.yaml')
        results = self.listen('episode_results', EpisodeResult)
        launched = self.drive('robot_lab.launch', scenario=scenario, real_time_factor='fast', episodes=EPISODES, seed=4,
                              robots_csv=self.path('ros.csv'), command_deadline=support.PATIENCE)
        self.assert_ends_well(launched)
        self.tool('evaluate', '--q-table', support.ANTICIPATION_TABLE, '--robot', 'none', '--robots-csv',
                  self.path('headless.csv'), scenario)
        columns, rows = self.rows('ros.csv')
        self.assertEqual(columns, self.rows('headless.csv')[0])
        # The record begins anew with the first instance when the robot is driven.
        self.assertEqual([row['episode'] for row in rows], ['0', '1'])
        # The crowd walks on until the launch has ended: more episodes may be over by then.
        recorded = [message for message in results.messages if message.episode > 0][:EPISODES]
        self.assertEqual(len(recorded), EPISODES)
        for row, result in zip(rows, recorded):
            robot = result.robots[0]
            for name in columns[3:]:
                if name == 'navigation':
                    self.assertEqual((row[name], robot.navigation), ('running', 'running'))
                elif name not in ('people_compared', 'people_delay', 'people_detour'):
                    # As texts, so that nan is equal to nan.
                    self.assertEqual(str(float(row[name])), str(float(getattr(robot, name))), name)
            self.assertEqual((row['scenario'], row['robot'], row['success']), ('robot_crossing', 'robot', '1'))
            self.assertEqual((row['people_compared'], row['people_delay']), ('0', 'nan'))

    def test_without_restart_the_first_episode_counts(self):
        results = rospy.Publisher(f'{self.namespace}/episode_results', EpisodeResult, queue_size=10)
        self.addCleanup(results.unregister)
        recorder = self.start_node('record_robots', 'record_robots', {'file': self.path('robots.csv'), 'episodes': 1})
        support.wait_for(lambda: results.get_num_connections() > 0, 'the recorder')
        results.publish(EpisodeResult())  # an episode without robots
        self.assertEqual(recorder.wait(), 0)
        self.assertEqual(len(self.rows('robots.csv')[1]), 0)

    def test_a_controller_that_refuses_the_restart(self):
        """The message is that of the controller."""
        service = rospy.Service(f'{self.namespace}/crowd_controller/reset', Reset,
                                lambda request: ResetResponse(False, 'not now'))
        self.addCleanup(service.shutdown)
        states = rospy.Publisher(f'{self.namespace}/robots', RobotStates, queue_size=10, latch=True)
        self.addCleanup(states.unregister)
        states.publish(RobotStates(robots=[RobotState(name='tug', commands_taken=1)]))
        recorder = self.start_node('record_robots', 'record_robots', {'file': self.path('a.csv'), 'restart': True})
        self.assertEqual(recorder.wait(), 1)
        self.assert_says(recorder.output(), 'crowd_controller/reset: not now')
        self.assertNotIn('~file', recorder.output())

    def test_a_file_that_cannot_be_written(self):
        recorder = self.start_node('record_robots', 'record_robots', {'file': '/nowhere/robots.csv'})
        self.assertEqual(recorder.wait(), 1)
        self.assert_says(recorder.output(), "~file: [Errno 2] No such file or directory: '/nowhere/robots.csv'")


if __name__ == '__main__':
    support.run('record_robots_test')
