#!/usr/bin/python3
"""robot_lab.launch with move_base: the navigation stack drives a robot among people.

Skipped where move_base is not built. In willow skipped without its map: that of the variable SOCIAL_CROWD_WILLOW, or
../shared/data/maps/willow.yaml beside the package.
"""
import os

import rospkg
import support
from robot_launching import RobotLaunchTestCase

GOALS = 10
WILLOW = """
name: willow
duration: 3000
goal_tolerance: 0.3
contact: solid
ends: robots
map: {map}
free_radius: 0.4
agents:
  - {{count: 30, position: {{map: free}}, route: walk, speed: [1.0, 1.5], radius: 0.2}}
routes:
  walk: {{repeat: true, waypoints: [{{place: {{map: free}}}}]}}
robots:
  - {{name: tug, position: {{map: free}}, goals: [{goals}], radius: 0.25, max_speed: 1}}
"""
# In willow, a robot at a wall; the way to the goal leads round the end of this wall.
AT_WALL = """
name: at_wall
duration: 300
goal_tolerance: 0.3
contact: solid
ends: robots
map: {map}
agents:
  - {{position: [30, 23], goal: [31, 23], speed: 1, radius: 0.2}}
robots:
  - {{name: tug, position: [23.855910092929747, 23.750000000000004], heading: {{radians: 0.3207410594324909}},
     goal: [25.070992518336414, 19.533664217575726], radius: 0.25, max_speed: 1}}
"""
# Two robots change places in a hall with four people; a wall is between them.
SWAP = """
name: swap
duration: 120
goal_tolerance: 0.1
contact: solid
ends: robots
agents:
  - {{count: 4, position: {{box: [[-5, -5], [5, -3]]}}, goal: {{box: [[-5, 3], [5, 5]]}}, speed: 1.0, radius: 0.25}}
walls:
  - [[0, -1], [0, 0.5]]
robots:
  - {{name: tug, position: [-5, 0], goal: [5, 0], radius: 0.3, max_speed: 1}}
  - {{name: cart, position: [5, 1], goal: [-5, 1], radius: 0.3, max_speed: 1}}
"""
PATIENCE = 1000.0  # [s] for a tour, on a busy machine


class MoveBaseTest(RobotLaunchTestCase):
    """A robot that move_base drives."""

    def setUp(self):
        super().setUp()
        if 'move_base' not in rospkg.RosPack().list():
            self.skip('move_base is not in the environment in which the package was configured')

    def goals(self):
        """Returns the goals that the robot has had."""
        goals = [(message.robots[0].goal.x, message.robots[0].goal.y) for message in self.states.messages]
        return list(dict.fromkeys(goals))

    def test_goes_round_an_office_and_where_it_is_sent(self):
        launched = self.drive('robot_lab.launch', navigation='move_base', scenario='office_courier',
                              real_time_factor=20)
        self.wait_until_arrived(PATIENCE)
        self.assertEqual(len(self.goals()), 9)
        self.send_nav_goal(12.0, 8.3)
        self.wait_until_arrived(PATIENCE)
        self.assertLess(abs(self.robots()[0].pose.x - 12.0), 0.31)
        self.assert_nobody_was_touched()
        self.assertEqual(launched.stop(), 0)

    def willow(self, text):
        """Writes a scenario in willow. Returns its file."""
        file = os.environ.get('SOCIAL_CROWD_WILLOW', support.in_package('..', 'shared', 'data', 'maps', 'willow.yaml'))
        if not os.path.exists(file):
            self.skip(f'there is no {file}')
        goals = ', '.join(['{map: free}'] * GOALS)
        return self.write('willow.yaml', text.format(map=os.path.abspath(file), goals=goals))

    def walk(self, **arguments):
        """Drives through an episode, at the end of which all robots are at their last goals and nobody was touched."""
        launched = self.drive('robot_lab.launch', navigation='move_base',
                              **dict({'real_time_factor': 20, 'episodes': 1}, **arguments))
        self.assertEqual(launched.wait(PATIENCE), 0)
        self.assertNotIn('crashed', launched.output())
        self.wait_until_arrived()
        self.assert_nobody_was_touched()
        return launched

    def walk_in_willow(self, seed):
        """Drives to ten goals in willow."""
        self.walk(scenario=self.willow(WILLOW), seed=seed)
        self.assertEqual(len(self.goals()), GOALS)

    def test_reaches_ten_goals_in_willow_among_thirty_people(self):
        self.walk_in_willow(seed=15)

    def test_reaches_ten_other_goals_in_willow(self):
        self.walk_in_willow(seed=16)

    def test_is_not_held_by_a_wall(self):
        """With a footprint in the local costmap that is 0.02 m smaller, it drives against the end of the wall."""
        self.walk(scenario=self.willow(AT_WALL))

    def test_people_layer_without_a_map(self):
        launched = self.walk(scenario='robot_crossing', people_layer='true', seed=2)
        self.assertEqual(launched.output().count('Using plugin "people"'), 2)

    def test_two_robots_with_a_small_tolerance(self):
        self.walk(scenario=self.write('swap.yaml', SWAP.format()))


if __name__ == '__main__':
    support.run('move_base_test')
