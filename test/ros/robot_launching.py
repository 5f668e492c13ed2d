"""Base of the tests of launch files with robots."""
import re

import rospy
import support
from launching import LaunchTestCase
from social_crowd.msg import RobotState, RobotStates


class RobotLaunchTestCase(LaunchTestCase):
    """Runs a launch file with robots and listens to them."""

    def drive(self, file, **arguments):
        """Starts a launch file and listens to its robots."""
        self.addCleanup(rospy.delete_param, '/use_sim_time')
        self.states = self.listen('robots', RobotStates)
        return self.launch(file, **arguments)

    def assert_ends_well(self, launched):
        """Checks that a launch ends without errors. Of a controller that starts, two commands may fall into a tick."""
        self.assertEqual(launched.wait(), 0, launched.output())
        self.assertNotRegex(launched.output(), 'REQUIRED process|has died')
        signs = r'.*\[ ?(?:WARN|ERROR|FATAL)\].*|.*(?:exit code|escalating|Traceback).*'
        complaints = re.findall(signs, launched.output())
        twice = 'the robot has a command for this tick already'
        self.assertEqual([text for text in complaints if twice not in text], [])

    def robots(self):
        """Returns the present states of all robots; none before the first message."""
        return self.states.messages[-1].robots if self.states.messages else []

    def wait_until_arrived(self, seconds=support.PATIENCE):
        """Waits until all robots are at their last goals."""
        support.wait_for(lambda: self.robots() and all(robot.status == RobotState.ARRIVED for robot in self.robots()),
                         'the arrival of all robots', seconds)

    def assert_nobody_was_touched(self):
        """Checks that no robot was in contact with people in any tick."""
        touched = {(message.tick, robot.name, robot.contacts) for message in self.states.messages
                   for robot in message.robots if robot.contacts}
        self.assertEqual(touched, set())
