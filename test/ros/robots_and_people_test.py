#!/usr/bin/python3
"""People walk round robots through ROS as they do without ROS."""
import support
from walking import WalkTestCase

# Ten people cross in both directions a place where two robots stand; people give way to the first one only.
CROSSING = """
name: crossing
duration: 30
goal_tolerance: 0.3
contact: solid
agents:
  - {count: 5, position: {box: [[-8, -1], [-4, 1]]}, goal: [8, 0], speed: 1.2, radius: 0.25}
  - {count: 5, position: {box: [[4, -1], [8, 1]]}, goal: [-8, 0], speed: 1.2, radius: 0.25}
robots:
  - {name: tug, position: [-1, 0.2], radius: 0.4, max_speed: 1.0}
  - {name: cart, position: [1, -0.2], radius: 0.4, max_speed: 1.0, yields: nobody}
"""


class RobotsAndPeopleTest(WalkTestCase):
    """Compares the recording of the run through ROS with that of `evaluate`."""

    def test_same_recording(self):
        scenario = self.write('crossing.yaml', CROSSING)
        expected = self.headless(scenario, support.ANTICIPATION_TABLE, episodes=4, seed=5)
        # A learner that does not know what room people give to the robots walks differently.
        close = self.write('close.yaml', CROSSING.replace('max_speed: 1.0', 'max_speed: 1.0, comfort: 0'))
        self.assertNotEqual(self.headless(close, support.ANTICIPATION_TABLE, episodes=4, seed=5), expected)
        self.start_learner(q_table=support.ANTICIPATION_TABLE)
        self.assert_same_recording(self.walk(scenario, episodes=4), expected)


if __name__ == '__main__':
    support.run('robots_and_people_test')
