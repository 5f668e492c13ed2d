"""Base of the tests of launch files."""
import re

import support

EPISODES = 2
# How warnings end that are right: a master that is busy when many nodes start refuses some of roscpp's requests, which
# roscpp repeats; learners that need more than 3 s to start are waited for; of nodelets and their manager, which are
# interrupted together, the manager may end first.
FINE = ('Retrying...', 'They stay in place', 'perhaps the manager is already shut down')


class LaunchTestCase(support.CrowdTestCase):
    """Runs roslaunch."""

    def launch(self, file, environment=None, **arguments):
        """Starts a launch file without RViz, with deadlines that suffice on a busy machine."""
        defaults = {'rviz': 'false', 'answer_deadline': 60.0}
        if file == 'replay.launch':
            del defaults['answer_deadline']
        words = [f'{name}:={value}' for name, value in dict(defaults, **arguments).items()]
        return self.start('roslaunch', ['roslaunch', 'social_crowd', file, *words], environment, support.Launch)

    def demo(self, **arguments):
        """Starts demo.launch for a few episodes, as fast as possible."""
        return self.launch('demo.launch', **dict({'real_time_factor': 'fast', 'episodes': EPISODES}, **arguments))

    def assert_ends_well(self, launched):
        """Checks that a launch ends without intervention and without errors, also according to roslaunch."""
        self.assertEqual(launched.wait(), 0, launched.output())
        self.assertNotRegex(launched.output(), 'REQUIRED process|has died')
        self.assert_no_complaint(launched, 'WARN|ERROR|FATAL')

    def assert_no_complaint(self, launched, levels):
        """Checks that nodes logged no messages of these levels, except FINE ones, and that all ended properly."""
        complaints = re.findall(rf'.*\[ ?(?:{levels})\].*|.*(?:exit code|escalating|Traceback).*', launched.output())
        self.assertEqual([line for line in complaints if not line.endswith(FINE)], [])

    def assert_ends_with(self, launched, *words):
        """Checks that a launch ends without intervention and prints the cause, and that roslaunch reports an error."""
        launched.wait()
        self.assert_says(launched.output(), 'REQUIRED process', 'has died', *words)
