#!/usr/bin/python3
"""Thousands of random commands and poses, many of them absurd: each is counted, ticks go on, robots stay within their
limits, and afterwards they can be driven as ever."""
import math
import random

import rospy
import support
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from robots import RobotTestCase, command, commands_of, poses_of

# A robot that is driven among people, and one that lives elsewhere.
HALL = """
name: fire
duration: 600
goal_tolerance: 0.3
contact: solid
routes:
  hall: {waypoints: [{place: {box: [[-6, -6], [6, 6]]}}, {place: {box: [[-6, -6], [6, 6]]}}], repeat: true}
agents:
  - {count: 8, position: {box: [[-6, -6], [6, 6]]}, route: hall, speed: 1.2, radius: 0.25}
robots:
  - {name: tug, namespace: tug, position: [0, 0], heading: 0, radius: 0.3, max_speed: 1.0, max_rotation: 1.0,
     acceleration: 100, rotation_acceleration: 100}
  - {name: far, namespace: far, position: [20, 0], heading: 0, radius: 0.3, max_speed: 1.0, max_rotation: 1.0,
     drive: external}
"""
ABSURD = (math.nan, math.inf, -math.inf, 1e308, -1e308, 1e154, 5e-324, -0.0, 0.0, 1e9, 2.0**53, -1e-300)
MESSAGES = 2000  # of each kind
BATCH = 20  # of them between two ticks
SEED = 4


class FireTest(RobotTestCase):
    """Random commands and poses."""

    def value(self):
        """Returns a number, in two of three cases an absurd one."""
        return self.random.choice((self.random.uniform(-2.0, 2.0), self.random.choice(ABSURD),
                                   self.random.choice((-1.0, 1.0)) * 10.0**self.random.uniform(-320.0, 308.0)))

    def command(self):
        """Returns a random command."""
        twist = Twist()
        for part in (twist.linear, twist.angular):
            part.x, part.y, part.z = (self.value() for _ in range(3))
        return twist

    def pose(self):
        """Returns a random pose, of which about half have a valid quaternion."""
        message = Odometry()
        message.header.frame_id = self.random.choice(('map', 'map', '', 'nowhere', '/', 'far/odom', '\u00e4' * 300))
        message.header.stamp = rospy.Time(self.random.choice((0, 1, 2**31, 2**32 - 1)), self.random.randrange(10**9))
        place, turn = message.pose.pose.position, message.pose.pose.orientation
        place.x, place.y, place.z = (self.value() for _ in range(3))
        angle = self.random.uniform(-math.pi, math.pi)
        turn.z, turn.w = self.random.choice(((math.sin(angle), math.cos(angle)), (self.value(), self.value())))
        message.pose.covariance = [self.value() for _ in range(36)]
        return message

    def walk_all(self, ticks):
        """Walks. Returns the states of both robots."""
        response = self.step(ticks)
        return self.states.wait_at(response.episode, response.tick).robots

    def test_random_commands_and_poses(self):
        self.random = random.Random(SEED)
        self.start_all(HALL)
        commands, poses = self.publisher('tug/cmd_vel', Twist), self.publisher('far/odom', Odometry)
        for sent in range(BATCH, MESSAGES + 1, BATCH):
            for _ in range(BATCH):
                commands.publish(self.command())
                poses.publish(self.pose())
            support.wait_for(lambda: self.all_came(sent), f'{sent} commands and poses')
        for message in self.states.messages:
            for state in message.robots:
                self.assertTrue(all(map(math.isfinite, (state.pose.x, state.pose.y, state.pose.theta))), state)
            self.assertLessEqual(abs(message.robots[0].twist.linear.x), 1.0 + 1e-9)
            self.assertLessEqual(abs(message.robots[0].twist.angular.z), 1.0 + 1e-9)
            self.assertLessEqual(abs(message.robots[1].twist.linear.x), 1.5 + 1e-9)
        self.assertGreater(message.robots[0].commands_not_finite, MESSAGES / 10)
        self.assertGreater(message.robots[1].poses_not_finite, MESSAGES / 10)
        support.wait_for(lambda: self.turns(commands), 'a robot that obeys')

    def turns(self, commands):
        """Whether the robot follows a command to turn on the spot, in which nobody can be in its way."""
        commands.publish(command(0.0, 0.5))
        return abs(self.walk_all(1)[0].twist.angular.z - 0.5) < 1e-9

    def all_came(self, sent):
        """Whether this number of commands and of poses has been counted."""
        tug, far = self.walk_all(1)
        return commands_of(tug) + tug.commands_repeated >= sent and poses_of(far) >= sent


if __name__ == '__main__':
    support.run('robot_fire_test')
