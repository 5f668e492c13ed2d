#!/usr/bin/python3
"""Lockstep with a robot: each tick waits for its command, or for the deadline."""
import subprocess

import rospy
import support
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from robots import RobotTestCase, command, scenario
from social_crowd.msg import EpisodeResult

TICKS = 40


def answer_to(odometry):
    """Returns a command that depends on the position."""
    return command(0.5, 0.3 - 0.2 * odometry.pose.pose.position.x)


class RobotLockstepTest(RobotTestCase):
    """A controller of the robot that answers each odometry message."""

    def answer(self, publisher):
        """Commands the robot after each odometry message."""
        def drive(message):
            publisher.publish(answer_to(message))

        subscriber = rospy.Subscriber(f'{self.namespace}/odom', Odometry, drive, tcp_nodelay=True)
        self.addCleanup(subscriber.unregister)
        self.listen('odom', Odometry).wait_connected()  # both share a connection

    def begin(self, text=None, **parameters):
        """Starts the nodes and an episode in which commands are awaited from the first tick on. Returns a publisher of
        commands."""
        self.start_all(text, publish_clock=True, robot_lockstep=True,
                       **dict({'command_deadline': 60.0}, **parameters))
        publisher = self.commander()
        self.send(publisher, Twist(), 1)
        self.succeed('crowd_controller/reset', keep_seed=True)
        return publisher

    def exact_pose(self):
        """Returns the pose after TICKS ticks, each with the answer to the odometry at its start."""
        odometry = self.listen('odom', Odometry).wait_connected()
        self.succeed('crowd_controller/reset', keep_seed=True)
        for _ in range(TICKS):
            stamp = self.step_robots(ticks=0).observations[0].header.stamp
            seen = odometry.wait(lambda message, stamp=stamp: message.header.stamp == stamp)
            response = self.step_robots(['tug'], [answer_to(seen)])
        return response.observations[0].pose

    def test_each_tick_has_its_own_command_however_fast_the_crowd_walks(self):
        publisher = self.begin()
        self.answer(publisher)
        self.succeed('crowd_controller/reset', keep_seed=True)  # publishes the first odometry
        last = self.step(TICKS)
        state = self.states.wait_at(last.episode, last.tick).robots[0]
        self.assertEqual((state.commands_taken, state.commands_missed, state.commands_late, state.command_timeouts),
                         (TICKS, 0, 0, 0))
        self.assertEqual(state.pose, self.exact_pose())

    def test_the_answer_to_the_last_odometry_of_an_episode_is_not_a_command_of_the_next_one(self):
        results = self.listen('episode_results', EpisodeResult)
        publisher = self.begin(scenario(duration=1), real_time_factor='fast', episodes=4)
        results.wait_connected()
        self.answer(publisher)
        self.succeed('crowd_controller/reset', keep_seed=True)
        self.succeed('crowd_controller/pause', data=False)
        support.wait_for(lambda: len(results.messages) == 4, 'all results')
        robots = [message.robots[0] for message in results.messages]
        # The rotations differ from tick to tick, so a command of another tick changes their sum.
        self.assertEqual([(robot.commands_taken, robot.commands_missed, robot.commands_late) for robot in robots],
                         [(10, 0, 0)] * 4)
        self.assertEqual([robot.cumulative_heading_changes for robot in robots],
                         [robots[0].cumulative_heading_changes] * 4)

    def test_a_late_command_does_not_shift_those_that_follow(self):
        publisher = self.begin(command_deadline=3.0)
        self.send(publisher, command(0.1), 1)  # tick 0
        self.assertEqual(self.walk().commands_missed, 1)  # tick 1
        publisher.publish(command(0.2))  # of tick 1
        publisher.publish(command(0.3))  # of tick 2
        state = self.walk()
        self.assertEqual(state.command.linear.x, 0.3)
        self.assertEqual((state.commands_taken, state.commands_late, state.commands_missed, state.commands_repeated),
                         (3, 1, 1, 0))
        support.wait_for(lambda: 'came after the 3 s of ~command_deadline' in self.controller.output(), 'a warning')

    def test_of_several_commands_in_a_tick_the_newest_counts(self):
        publisher = self.begin()
        for speed in (0.4, 0.5, 0.6):
            publisher.publish(command(speed))
        support.wait_for(lambda: self.commands_taken() == 3, 'three commands')
        state = self.walk()
        self.assertEqual(state.command.linear.x, 0.6)
        self.assertEqual((state.commands_taken, state.commands_repeated, state.commands_missed), (3, 2, 0))

    def commands_taken(self):
        """Returns the number that a new subscriber gets before the next tick. This process subscribes already."""
        printed = subprocess.run(['rostopic', 'echo', '-n', '1', f'{self.namespace}/robots/robots[0]/commands_taken'],
                                 stdout=subprocess.PIPE, text=True, timeout=support.PATIENCE, check=True).stdout
        return int(printed.split()[0])

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
