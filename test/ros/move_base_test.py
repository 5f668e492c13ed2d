#!/usr/bin/python3
"""move_base.launch: the navigation stack drives a robot among people.

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
PATIENCE = 500.0  # [s] for a tour


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
        launched = self.drive('move_base.launch', real_time_factor=20)
        self.wait_until_arrived(PATIENCE)
        self.assertEqual(len(self.goals()), 9)
        self.send_nav_goal(12.0, 8.3)
        self.wait_until_arrived(PATIENCE)
        self.assertLess(abs(self.robots()[0].pose.x - 12.0), 0.31)
        self.assert_nobody_was_touched()
        self.assertEqual(launched.stop(), 0)

    def walk_in_willow(self, seed):
        """Drives to ten goals in willow."""
        file = os.environ.get('SOCIAL_CROWD_WILLOW', support.in_package('..', 'shared', 'data', 'maps', 'willow.yaml'))
        if not os.path.exists(file):
            self.skip(f'there is no {file}')
        goals = ', '.join(['{map: free}'] * GOALS)
        scenario = self.write('willow.yaml', WILLOW.format(map=os.path.abspath(file), goals=goals))
        launched = self.drive('move_base.launch', scenario=scenario, seed=seed, real_time_factor=20, episodes=1)
        self.assertEqual(launched.wait(PATIENCE), 0)
        self.wait_until_arrived()
        self.assertEqual(len(self.goals()), GOALS)
        self.assert_nobody_was_touched()

    def test_reaches_ten_goals_in_willow_among_thirty_people(self):
        self.walk_in_willow(seed=1)

    def test_reaches_ten_other_goals_in_willow(self):
        self.walk_in_willow(seed=3)


if __name__ == '__main__':
    support.run('move_base_test')
