"""Base of the tests of launch files with robots."""
import rospy
import support
from geometry_msgs.msg import PoseStamped
from launching import LaunchTestCase
from social_crowd.msg import RobotState, RobotStates


class RobotLaunchTestCase(LaunchTestCase):
    """Runs a launch file with robots and listens to them."""

    def drive(self, file, **arguments):
        """Starts a launch file and listens to its robots."""
        self.addCleanup(rospy.delete_param, '/use_sim_time')
        self.states = self.listen('robots', RobotStates)
        return self.launch(file, **arguments)

    def send_nav_goal(self, x, y):
        """Publishes a goal as the tool 2D Nav Goal of RViz does, and waits until it is that of the robot."""
        publisher = rospy.Publisher(f'{self.namespace}/move_base_simple/goal', PoseStamped, queue_size=1)
        self.addCleanup(publisher.unregister)
        support.wait_for(lambda: publisher.get_num_connections() > 0, 'a subscriber of move_base_simple/goal')
        goal = PoseStamped()
        goal.header.frame_id = 'map'
        goal.pose.position.x, goal.pose.position.y, goal.pose.orientation.w = x, y, 1.0
        publisher.publish(goal)
        support.wait_for(lambda: self.robots() and (self.robots()[0].goal.x, self.robots()[0].goal.y) == (x, y),
                         'the new goal')

    def robots(self):
        """Returns the present states of all robots; none before the first message."""
        return self.states.messages[-1].robots if self.states.messages else []

    def wait_until_arrived(self, seconds=support.PATIENCE):
        """Waits until all robots are at their last goals."""
        def have_arrived():
            return self.robots() and all(robot.status == RobotState.ARRIVED for robot in self.robots())
        try:
            support.wait_for(have_arrived, 'the arrival of all robots', seconds)
        except AssertionError as error:
            raise AssertionError(f'{error}; tick {self.states.messages[-1:] and self.states.messages[-1].tick}, '
                                 f'robots: {self.robots()}') from None

    def assert_nobody_was_touched(self):
        """Checks that no robot was in contact with people in any tick."""
        touched = {(message.tick, robot.name, robot.contacts) for message in self.states.messages
                   for robot in message.robots if robot.contacts}
        self.assertEqual(touched, set())
