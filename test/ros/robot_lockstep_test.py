#!/usr/bin/python3
"""Lockstep with a robot: each tick waits for its command, or for the deadline."""
import rospy
import support
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from robots import RobotTestCase, command, scenario

TICKS = 40


class RobotLockstepTest(RobotTestCase):
    """A controller of the robot that answers each odometry message."""

    def answer(self, publisher):
        """Commands the robot after each odometry message, by its position."""
        def drive(message):
            publisher.publish(command(0.5, 0.3 - 0.2 * message.pose.pose.position.x))

        subscriber = rospy.Subscriber(f'{self.namespace}/odom', Odometry, drive, tcp_nodelay=True)
        self.addCleanup(subscriber.unregister)
        support.wait_for(lambda: subscriber.get_num_connections() > 0, 'odometry')
        return subscriber

    def test_no_command_is_missed_however_fast_the_crowd_walks(self):
        self.start_all(publish_clock=True, robot_lockstep=True, command_deadline=60.0)
        publisher = self.commander()
        self.answer(publisher)
        publisher.publish(Twist())
        first = self.step(1)
        self.walk_until_heard()
        last = self.step(TICKS)
        state = self.states.wait_at(last.episode, last.tick).robots[0]
        self.assertEqual((state.commands_missed, state.command_timeouts), (0, 0))
        self.assertGreaterEqual(state.commands_taken, TICKS)
        self.assertGreater(state.pose.x, 1.0 + 0.5 * 0.1 * TICKS * 0.5)
        self.assertEqual(last.episode, first.episode)

    def walk_until_heard(self):
        """Walks until the first command has arrived; from then on commands are awaited."""
        support.wait_for(lambda: self.walk().commands_taken > 0, 'the first command')

    def test_a_robot_that_is_silent_is_absent_until_its_next_command(self):
        self.start_all(publish_clock=True, robot_lockstep=True, command_deadline=0.05, misses_until_absent=2)
        publisher = self.commander()
        self.send(publisher, command(0.1), 1)
        self.walk(10)
        state = self.walk(10)
        self.assertEqual(state.commands_missed, 2)
        support.wait_for(lambda: 'not waited for' in self.controller.output(), 'a warning')
        self.send(publisher, command(0.1), 2)
        self.assertEqual(self.walk(10).commands_missed, 4)

    def test_lockstep_needs_simulated_time(self):
        controller = self.start_controller(self.write('robot.yaml', scenario()), robot_lockstep=True)
        self.assertEqual(controller.wait(), 1)
        self.assert_says(controller.output(), 'robot_lockstep', 'publish_clock')


if __name__ == '__main__':
    support.run('robot_lockstep_test')
