"""Launch files under test."""
import re

import support

EPISODES = 2


class LaunchTestCase(support.CrowdTestCase):
    """Runs roslaunch."""

    def launch(self, file, environment=None, **arguments):
        """Starts a launch file without RViz; its nodes wait for answers as long as it takes on a busy machine."""
        defaults = {'rviz': 'false', 'answer_deadline': 60.0}
        if file == 'replay.launch':
            del defaults['answer_deadline']
        words = [f'{name}:={value}' for name, value in dict(defaults, **arguments).items()]
        return self.start('roslaunch', ['roslaunch', 'social_crowd', file, *words], environment)

    def demo(self, **arguments):
        """Starts demo.launch as fast as it goes, for a few episodes."""
        return self.launch('demo.launch', **dict({'real_time_factor': 'fast', 'episodes': EPISODES}, **arguments))

    def assert_ends_well(self, launched):
        """Checks that a launch ends by itself, that nothing went wrong on the way, and that roslaunch agrees."""
        self.assertEqual(launched.wait(), 0, launched.output())
        self.assertNotRegex(launched.output(), 'REQUIRED process|has died')
        self.assert_no_complaint(launched, 'WARN|ERROR|FATAL')

    def assert_no_complaint(self, launched, levels):
        """Checks that nodes said nothing of these levels, and that all ended as they should."""
        complaints = re.findall(rf'.*\[ ?(?:{levels})\].*|.*(?:exit code|escalating|Traceback).*', launched.output())
        self.assertEqual(complaints, [])

    def assert_ends_with(self, launched, *words):
        """Checks that a launch ends by itself and prints the cause; roslaunch reports it as an error."""
        launched.wait()
        self.assert_says(launched.output(), 'REQUIRED process', 'has died', *words)
