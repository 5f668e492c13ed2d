#!/usr/bin/python3
"""A robot follows cmd_vel; its odometry, frames, scan and goal are published."""
import math

import support
from geometry_msgs.msg import PoseArray, PoseStamped
from nav_msgs.msg import Odometry
from robots import RobotTestCase, command, scenario
from sensor_msgs.msg import LaserScan, PointCloud2
from tf2_msgs.msg import TFMessage


class DrivingTest(RobotTestCase):
    """Commands and the motion that follows."""

    def test_follows_a_command_until_its_timeout(self):
        self.start_all()
        self.send(self.commander(), command(0.5), 1)
        # The command holds for five ticks of 0.1 s, wherever the steps began.
        state = self.walk(10)
        self.assertAlmostEqual(state.pose.x, 1.25, places=9)
        self.assertEqual(state.twist.linear.x, 0.0)
        self.assertEqual(state.command_timeouts, 1)
        self.assertEqual((state.commands_taken, state.commands_missed), (1, 0))

    def test_is_stopped_by_a_wall(self):
        self.start_all(scenario(more=', cmd_timeout: 100'))
        self.send(self.commander(), command(1.0), 1)
        state = self.walk(60)
        self.assertAlmostEqual(state.pose.x, 4.7, places=6)
        self.assertTrue(any(message.robots[0].blocked for message in self.states.messages))

    def test_bad_commands_are_refused_and_counted(self):
        self.start_all()
        publisher = self.commander()
        for count, bad in enumerate((math.nan, math.inf, -math.inf), 1):
            self.send(publisher, command(bad), count)
        state = self.walk(5)
        self.assertEqual((state.commands_not_finite, state.commands_taken), (3, 0))
        self.assertEqual(state.pose.x, 1.0)
        support.wait_for(lambda: 'not finite' in self.controller.output(), 'a warning')

    def test_of_two_publishers_the_first_one_commands(self):
        self.start_all(scenario(more=', cmd_timeout: 100'))
        self.send(self.commander(), command(0.1), 1)
        other = self.start('other', ['/usr/bin/rostopic', 'pub', '-r', '20', f'{self.namespace}/cmd_vel',
                                     'geometry_msgs/Twist', '{angular: {z: 1.0}}'])
        support.wait_for(lambda: self.walk().commands_of_others > 0, 'a refused command')
        other.stop()
        state = self.walk()
        self.assertEqual(state.twist.angular.z, 0.0)
        self.assertEqual(state.commands_taken, 1)
        support.wait_for(lambda: 'commands this robot' in self.controller.output(), 'a warning')


class TopicsTest(RobotTestCase):
    """What is published after each tick."""

    def test_odometry_and_frames(self):
        self.start_all(publish_clock=True)
        odometry = self.listen('odom', Odometry).wait_connected()
        frames = self.listen('/tf', TFMessage).wait_connected()
        self.step_robots(['tug'], [command(1.0, 0.5)], ticks=10)
        self.step_robots(ticks=1)
        support.wait_for(lambda: len(odometry.messages) >= 11, '11 odometry messages')
        last = odometry.messages[9]
        # An arc: radius 2 m, 0.5 rad.
        self.assertAlmostEqual(last.pose.pose.position.x, 2.0 * math.sin(0.5), places=9)
        self.assertAlmostEqual(last.pose.pose.position.y, 2.0 * (1.0 - math.cos(0.5)), places=9)
        self.assertEqual((last.twist.twist.linear.x, last.twist.twist.angular.z), (1.0, 0.5))
        self.assertEqual((last.header.frame_id, last.child_frame_id), ('odom', 'base_link'))

        def transform(child):
            return [frame for message in list(frames.messages) for frame in message.transforms
                    if frame.child_frame_id == child and frame.header.stamp == last.header.stamp]

        support.wait_for(lambda: transform('base_link') and transform('odom'), 'transforms')
        base, odom = transform('base_link')[0], transform('odom')[0]
        self.assertEqual(base.transform.translation.x, last.pose.pose.position.x)
        self.assertEqual((odom.header.frame_id, base.header.frame_id), ('map', 'odom'))
        self.assertAlmostEqual(odom.transform.translation.x, 1.0, places=9)  # where the robot began
        self.assertAlmostEqual(odom.transform.rotation.w, 1.0, places=9)

    def test_scan_sees_the_wall(self):
        self.start_all(scenario(more=', scan: {rays: 360, angles: [-180, 180], range: [0.1, 10]}'))
        scans = self.listen('scan', LaserScan).wait_connected()
        clouds = self.listen('scan_cloud', PointCloud2).wait_connected()
        self.step()
        scan = scans.wait()
        self.assertEqual(len(scan.ranges), 360)
        self.assertAlmostEqual(scan.ranges[180], 4.0, places=6)
        self.assertAlmostEqual(scan.ranges[180 + 45], 4.0 * math.sqrt(2.0), places=5)
        self.assertEqual(scan.ranges[0], math.inf)
        self.assertEqual(scan.header.frame_id, 'laser')
        self.assertAlmostEqual(scan.angle_increment, math.radians(1.0), places=6)
        hits = sum(math.isfinite(value) for value in scan.ranges)
        self.assertEqual(clouds.wait().width, hits)

    def test_people_and_goal(self):
        self.start_all(scenario(more=', goal: [4, 0]'))
        people = self.listen('people_poses', PoseArray).wait_connected()
        goals = self.listen('goal', PoseStamped).wait_connected()
        self.assertEqual(goals.wait().pose.position.x, 4.0)
        self.step()
        self.assertEqual([pose.position.y for pose in people.wait().poses], [20.0])

    def test_a_new_goal_replaces_the_goal(self):
        self.start_all(scenario(more=', goal: [4, 0]'))
        goals = self.listen('goal', PoseStamped).wait_connected()
        goals.wait()
        publisher = self.publisher('new_goal', PoseStamped)
        for frame, x in (('base_link', 2.0), ('map', math.nan), ('map', 2.0)):
            goal = PoseStamped()
            goal.header.frame_id = frame
            goal.pose.position.x = x
            publisher.publish(goal)
        self.assertEqual(goals.wait(lambda message: message.pose.position.x != 4.0).pose.position.x, 2.0)
        support.wait_for(lambda: 'expected the frame map' in self.controller.output()
                         and 'expected finite numbers' in self.controller.output(), 'two warnings')
        self.assertEqual(self.walk().goal.x, 2.0)

    def test_robots_have_namespaces(self):
        text = scenario() + scenario().split('robots:\n')[1].replace('tug', 'cart').replace('[1, 0]', '[1, 3]')
        self.start_all(text)
        odometry = self.listen('cart/odom', Odometry).wait_connected()
        self.listen('tug/scan', LaserScan).wait_connected()
        self.step()
        message = odometry.wait()
        self.assertEqual((message.header.frame_id, message.child_frame_id), ('cart/odom', 'cart/base_link'))


if __name__ == '__main__':
    support.run('robot_driving_test')
