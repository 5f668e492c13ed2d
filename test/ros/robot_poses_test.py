#!/usr/bin/python3
"""A robot that lives elsewhere: its poses come from odometry or tf. Bad poses are named and counted, and the run goes
on."""
import math

import rospy
import support
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import Odometry
from robots import RobotTestCase, command, poses_of, scenario
from tf2_msgs.msg import TFMessage

TICK = support.TICK


class PosesTestCase(RobotTestCase):
    """A robot that lives elsewhere."""

    def start_external(self, more='', **parameters):
        """Starts the nodes with simulated time."""
        self.start_all(scenario(more=f', drive: external{more}'), publish_clock=True, **parameters)
        self.walk()

    def now(self):
        """Returns the time at the end of the last tick [s]."""
        return self.states.messages[-1].header.stamp.to_sec()

    def count(self):
        """Returns the number of poses that arrived."""
        return poses_of(self.states.messages[-1].robots[0])

    def wait_for_pose(self, count):
        """Walks until this number of poses has arrived. Returns the state of the robot after them."""
        support.wait_for(lambda: poses_of(self.walk()) >= count, f'{count} poses')
        return self.states.messages[-1].robots[0]

    def wait_for_warning(self, *words):
        """Waits for a line of the controller's output that contains all the words."""
        support.wait_for(lambda: any(all(word in line for word in words)
                                     for line in self.controller.output().splitlines()), f'a warning with {words}')


class OdometryTest(PosesTestCase):
    """Poses from the topic odom."""

    def start_external(self, more='', **parameters):
        """Starts the nodes and a publisher of odometry."""
        super().start_external(more, **parameters)
        self.odometry = self.publisher('odom', Odometry)

    def send_pose(self, x, y=0.0, stamp=None, frame='map', heading=0.0, norm=1.0):
        """Publishes a pose, by default with the present time. Returns the state of the robot after it has arrived."""
        message = Odometry()
        message.header.frame_id = frame
        message.header.stamp = rospy.Time.from_sec(self.now() if stamp is None else stamp)
        message.pose.pose.position.x, message.pose.pose.position.y = x, y
        message.pose.pose.orientation.z = norm * math.sin(heading / 2.0)
        message.pose.pose.orientation.w = norm * math.cos(heading / 2.0)
        count = self.count() + 1
        self.odometry.publish(message)
        return self.wait_for_pose(count)

    def test_it_is_where_its_poses_say(self):
        self.start_external()
        state = self.send_pose(3.0, 1.0, heading=1.0)
        self.assertEqual((state.pose.x, state.pose.y), (3.0, 1.0))
        self.assertAlmostEqual(state.pose.theta, 1.0, places=12)
        self.assertEqual((state.poses_taken, state.pose_jumps, state.pose_gaps), (1, 0, 0))

    def test_it_moves_on_with_its_velocity_for_one_tick(self):
        self.start_external()
        before = self.now()
        self.send_pose(2.0, stamp=before)
        state = self.send_pose(2.1, stamp=before + 0.25)
        self.assertAlmostEqual(state.twist.linear.x, 0.4, places=6)
        at = self.states.messages[-1].header.stamp.to_sec()
        self.assertAlmostEqual(state.pose.x, 2.1 + 0.4 * min(max(at - before - 0.25, 0.0), TICK), places=6)
        self.assertEqual((state.pose_jumps, state.pose_gaps), (0, 0))

    def test_a_jump_is_reported_and_the_pose_used(self):
        self.start_external()
        before = self.now()
        self.send_pose(1.0, stamp=before)
        state = self.send_pose(4.0, stamp=before + 0.1)
        self.assertEqual((state.pose.x, state.twist.linear.x, state.pose_jumps), (4.0, 0.0, 1))
        self.wait_for_warning("robot 'tug'", f'{self.namespace}/odom', 'jump')
        state = self.send_pose(1.0, stamp=before + 0.2)
        self.assertEqual((state.pose.x, state.pose_jumps), (1.0, 2))
        self.assertEqual(self.controller.output().count('is a jump'), 1)

    def test_a_gap_is_reported_and_the_pose_used(self):
        self.start_external()
        before = self.now()
        self.send_pose(1.0, stamp=before)
        state = self.send_pose(1.2, stamp=before + 1.0)
        self.assertEqual((state.pose.x, state.twist.linear.x, state.pose_gaps), (1.2, 0.0, 1))
        self.wait_for_warning("robot 'tug'", 'comes 1.00 s after')

    def test_it_stands_still_while_poses_are_stale(self):
        self.start_external()
        before = self.now()
        self.send_pose(1.0, stamp=before)
        self.send_pose(1.04, stamp=before + 0.1)
        state = self.walk(10)
        self.assertEqual((state.pose.x, state.twist.linear.x, state.pose_stale), (1.04, 0.0, 1))
        self.wait_for_warning("robot 'tug' stands still", f'{self.namespace}/odom', 's old')
        self.assertEqual(self.send_pose(1.04).pose_stale, 1)
        self.assertEqual(self.walk(10).pose_stale, 2)

    def test_without_any_pose_it_stays_where_it_is(self):
        self.start_external()
        state = self.walk(10)
        self.assertEqual((state.pose.x, state.pose_stale, state.poses_taken), (1.0, 1, 0))
        self.wait_for_warning("robot 'tug' stands still", 'no pose yet')

    def test_poses_that_are_not_finite_are_refused(self):
        self.start_external()
        self.send_pose(2.0)
        self.send_pose(math.nan)
        self.send_pose(2.0, math.inf)
        state = self.send_pose(2.0, norm=0.0)
        self.assertEqual((state.poses_not_finite, state.poses_taken, state.pose.x), (3, 1, 2.0))
        self.wait_for_warning("robot 'tug'", 'finite numbers')

    def test_poses_that_are_older_than_the_last_one_are_refused(self):
        self.start_external()
        now = self.now()
        self.send_pose(2.0, stamp=now)
        state = self.send_pose(2.01, stamp=now - 0.25)
        self.assertEqual((state.poses_backwards, state.poses_taken, state.pose.x), (1, 1, 2.0))
        self.wait_for_warning("robot 'tug'", '0.25 s before')

    def test_poses_of_another_clock_are_stale(self):
        self.start_external()
        state = self.send_pose(2.0, stamp=1e6)
        self.assertEqual((state.pose.x, state.pose_stale), (2.0, 1))
        self.wait_for_warning("robot 'tug'", 'the same clock')
        state = self.send_pose(3.0)
        self.assertEqual((state.pose.x, state.poses_taken, state.poses_backwards), (3.0, 2, 0))

    def test_poses_in_another_frame_need_a_transform(self):
        self.start_external()
        state = self.send_pose(1.0, frame='elsewhere')
        self.assertEqual((state.poses_without_frame, state.poses_taken, state.pose.x), (1, 0, 1.0))
        self.wait_for_warning("robot 'tug'", 'elsewhere')
        # A frame at (1, 2), turned by a quarter: its x axis points along y.
        frames = rospy.Publisher('/tf_static', TFMessage, queue_size=1, latch=True)
        self.addCleanup(frames.unregister)
        frame = TransformStamped(child_frame_id='elsewhere')
        frame.header.frame_id = 'map'
        frame.transform.translation.x, frame.transform.translation.y = 1.0, 2.0
        frame.transform.rotation.z = frame.transform.rotation.w = math.sqrt(0.5)
        frames.publish(TFMessage([frame]))
        support.wait_for(lambda: self.send_pose(3.0, frame='elsewhere').poses_taken > 0, 'a pose that is used')
        pose = self.walk().pose
        self.assertAlmostEqual(pose.x, 1.0, places=9)
        self.assertAlmostEqual(pose.y, 5.0, places=9)
        self.assertAlmostEqual(pose.theta, math.pi / 2.0, places=9)

    def test_a_pose_in_a_wall_or_in_a_person_is_used(self):
        self.start_external()
        self.assertEqual(self.send_pose(5.0).pose.x, 5.0)
        person = self.send_pose(0.5, 20.0)
        self.assertEqual((person.pose.x, person.pose.y, list(person.contacts)), (0.5, 20.0, [0]))
        self.assertEqual(self.walk(3).pose.y, 20.0)

    def test_an_episode_keeps_the_place_and_forgets_the_counts(self):
        self.start_external()
        self.send_pose(math.nan)
        self.send_pose(3.0)
        self.succeed('crowd_controller/reset', keep_seed=True)
        state = self.walk()
        self.assertEqual((state.pose.x, state.poses_not_finite, state.pose_jumps), (3.0, 0, 0))

    def test_it_takes_no_commands(self):
        self.start_external()
        self.refuse('crowd_controller/step_robots', "'tug' takes no commands", robots=['tug'],
                    commands=[command(0.5)], ticks=1, with_scan=False)


class TransformTest(PosesTestCase):
    """Poses from tf, which stops."""

    def send_pose(self, publisher, x, stamp):
        """Publishes the transform map -> base_link. Returns the state of the robot after it has arrived."""
        frame = TransformStamped(child_frame_id='far/base_link')
        frame.header.frame_id = 'map'
        frame.header.stamp = rospy.Time.from_sec(stamp)
        frame.transform.translation.x = x
        frame.transform.rotation.w = 1.0
        count = self.count() + 1
        publisher.publish(TFMessage([frame]))
        return self.wait_for_pose(count)

    def test_it_follows_tf_until_tf_stops(self):
        self.start_external(', pose_from: tf, namespace: far')
        publisher = rospy.Publisher('/tf', TFMessage, queue_size=10, tcp_nodelay=True)
        self.addCleanup(publisher.unregister)
        support.wait_for(lambda: publisher.get_num_connections() > 0, 'a subscriber of /tf')
        before = self.now()
        self.assertEqual(self.send_pose(publisher, 2.0, before).pose.x, 2.0)
        state = self.send_pose(publisher, 2.1, before + 0.25)
        self.assertAlmostEqual(state.twist.linear.x, 0.4, places=6)
        self.assertEqual((state.poses_taken, state.pose_jumps), (2, 0))
        state = self.walk(10)
        self.assertEqual((state.pose.x, state.twist.linear.x, state.pose_stale), (2.1, 0.0, 1))
        self.wait_for_warning("robot 'tug' stands still", 'map -> far/base_link')
        self.assertEqual(self.send_pose(publisher, 2.1, self.now()).pose_gaps, 1)


if __name__ == '__main__':
    support.run('robot_poses_test')
