#!/usr/bin/python3
"""robot_lab.launch: robots that are driven by their laser scans arrive, without touching people."""
import support
from robot_launching import RobotLaunchTestCase

# Two robots pass on both sides of a wall in a hall with six people. Head-on the rule has no way past its own kind.
PASSING = """
name: passing
duration: 90
goal_tolerance: 0.3
contact: solid
ends: robots
agents:
  - {count: 6, position: {box: [[-5, -5], [5, -2]]}, goal: {box: [[-5, 2], [5, 5]]}, speed: 1.0, radius: 0.25}
walls:
  - [[0, -1.5], [0, 0]]
robots:
  - {name: tug, position: [-5, 1.5], goal: [5, 1.5], radius: 0.3, max_speed: 1}
  - {name: cart, position: [5, -3], goal: [-5, -3], radius: 0.3, max_speed: 1}
"""


class RobotControllerTest(RobotLaunchTestCase):
    """The example controller."""

    def test_crosses_a_hall_with_people(self):
        launched = self.drive('robot_lab.launch', real_time_factor='fast', episodes=1, seed=3,
                              command_deadline=support.PATIENCE)
        self.assert_ends_well(launched)
        self.wait_until_arrived()
        self.assert_nobody_was_touched()
        # Each tick waits for its command, however fast the crowd walks.
        robot = self.robots()[0]
        self.assertEqual((robot.commands_missed, robot.command_timeouts), (0, 0))
        # Ticks do not wait before the first command. The scans on their way then (one on the wire, one in the queue,
        # one in work) are answered, too.
        self.assertLessEqual(robot.commands_repeated, 3)
        self.assertGreater(robot.commands_taken, 100)

    def test_goes_where_2d_nav_goal_sends_it(self):
        launched = self.drive('robot_lab.launch', real_time_factor=5, seed=3)
        support.wait_for(self.robots, 'the robot')
        self.send_nav_goal(self.robots()[0].pose.x, self.robots()[0].pose.y + 1.0)
        self.assertEqual(launched.stop(), 0)

    def test_two_robots_in_namespaces(self):
        launched = self.drive('robot_lab.launch', scenario=self.write('passing.yaml', PASSING), real_time_factor='fast',
                              episodes=1, command_deadline=support.PATIENCE)
        self.assert_ends_well(launched)
        self.wait_until_arrived()
        self.assert_nobody_was_touched()

    def test_invalid_parameters(self):
        node = self.start_node('robot_controller', 'robot_controller', {'drive': 'car', 'radius': -1.0, 'speed': 2.0})
        self.assertEqual(node.wait(), 1)
        support.assert_says(node.output(), "~drive: expected differential, holonomic or ackermann, got 'car'",
                            '~radius', "~speed: there is no such parameter")


if __name__ == '__main__':
    support.run('robot_controller_test')
