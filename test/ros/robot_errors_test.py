#!/usr/bin/python3
"""Invalid robots in scenarios: the error names the robot's line and what is expected; a running crowd is not affected.
Invalid commands are in robot_driving_test.py, invalid poses in robot_poses_test.py."""
import support
from robots import RobotTestCase, scenario

BOW_TIE = 'footprint: [[-0.5, -0.5], [0.5, 0.5], [0.5, -0.5], [-0.5, 0.5]]'


def bad_scenarios():
    """Returns, by name, a scenario with an invalid robot and the words that the error contains."""
    second = scenario().split('robots:\n')[1]
    return {
        'two_of_one_name': (scenario() + second.replace('[1, 0]', '[1, 3]'), ["two robots 'tug'", 'robots']),
        'crosses_itself': (scenario().replace('radius: 0.3', BOW_TIE), ['footprint', 'cross']),
        'in_a_wall': (scenario().replace('[1, 0]', '[5.1, 0]'), ['robots[0]', 'walls[0]', 'overlap']),
        'in_a_robot': (scenario() + second.replace('tug', 'cart').replace('[1, 0]', '[1.2, 0]'),
                       ['robots[1]', 'robots[0]', 'overlap']),
        'not_finite': (scenario().replace('[1, 0]', '[.nan, 0]'), ['position']),
    }


class RobotErrorsTest(RobotTestCase):
    """Scenarios that cannot be used."""

    def test_a_controller_does_not_start_with_them(self):
        for name, (text, words) in bad_scenarios().items():
            controller = self.start_controller(self.write(f'{name}.yaml', text))
            self.assertEqual(controller.wait(), 1, name)
            self.assert_says(controller.output(), f'{name}.yaml', *words)

    def test_a_crowd_that_walks_continues(self):
        self.start_all()
        before = self.walk(3)
        for name, (text, words) in bad_scenarios().items():
            words = [word.replace("'tug'", "'...'") for word in words]  # answers of services quote no file
            self.refuse('crowd_controller/load_scenario', *words, scenario=self.write(f'{name}.yaml', text))
        after = self.walk()
        self.assertEqual(self.states.messages[-1].tick, 4)
        self.assertEqual((after.name, after.pose), (before.name, before.pose))


if __name__ == '__main__':
    support.run('robot_errors_test')
