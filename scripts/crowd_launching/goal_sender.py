"""Sends the goals of a robot to move_base."""
import threading

import actionlib
import rospy
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseStamped
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal

PERIOD = 0.01  # [s] between two checks, wall clock


class GoalSender:
    """Sends the present goal, and sends it again when move_base has given it up."""

    def __init__(self):
        self.retry_after = rospy.Duration(rospy.get_param('~retry_after', 1.0))
        self.lock = threading.Lock()
        self.goal = None  # the last one that was received
        self.is_new = False  # and has not been sent
        self.given_up_at = None  # simulated time
        self.client = actionlib.SimpleActionClient('move_base', MoveBaseAction)
        while not self.client.wait_for_server(rospy.Duration(1.0)) and not rospy.is_shutdown():
            rospy.loginfo_throttle(10.0, 'waiting for move_base')
        rospy.Subscriber('goal', PoseStamped, self.take, queue_size=10, tcp_nodelay=True)

    def take(self, goal):
        """Takes a new goal."""
        with self.lock:
            self.goal = goal
            self.is_new = True

    def run(self):
        """Sends goals until the node is shut down. The callbacks of the action must not send."""
        while not rospy.is_shutdown():
            if self.must_send():
                self.client.send_goal(MoveBaseGoal(target_pose=self.goal))
            threading.Event().wait(PERIOD)

    def must_send(self):
        """Returns whether the goal is to be sent now."""
        with self.lock:
            is_new, self.is_new = self.is_new, False
        if is_new or self.goal is None or self.client.get_state() != GoalStatus.ABORTED:
            self.given_up_at = None
            return is_new
        if self.given_up_at is None:
            self.given_up_at = rospy.get_rostime()
            rospy.logwarn('move_base has given up the goal %.2f, %.2f, which is sent again',
                          self.goal.pose.position.x, self.goal.pose.position.y)
        return rospy.get_rostime() - self.given_up_at >= self.retry_after


def main():
    """Sends goals until the node is shut down."""
    rospy.init_node('goal_sender')
    try:
        GoalSender().run()
    except rospy.ROSInterruptException:
        pass
