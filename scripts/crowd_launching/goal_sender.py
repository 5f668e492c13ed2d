"""Sends the goals of a robot to move_base."""
import actionlib
import rospy
from geometry_msgs.msg import PoseStamped
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal


class GoalSender:
    """Sends the present goal, and sends it again when move_base has given up."""

    def __init__(self):
        self.retry_after = rospy.Duration(rospy.get_param('~retry_after', 1.0))
        self.goal = None  # the last one that was received
        self.client = actionlib.SimpleActionClient('move_base', MoveBaseAction)
        while not self.client.wait_for_server(rospy.Duration(1.0)) and not rospy.is_shutdown():
            rospy.loginfo_throttle(10.0, 'waiting for move_base')
        rospy.Subscriber('goal', PoseStamped, self.take, queue_size=10, tcp_nodelay=True)

    def take(self, goal):
        """Takes a new goal."""
        self.goal = goal
        self.send()

    def send(self):
        """Sends the present goal."""
        sent = self.goal
        self.client.send_goal(MoveBaseGoal(target_pose=sent), done_cb=lambda status, _: self.note_end(sent, status))

    def note_end(self, sent, status):
        """Sends a goal again that move_base could not reach."""
        if status != actionlib.GoalStatus.ABORTED or sent is not self.goal:
            return
        rospy.logwarn('move_base has given up the goal %.2f, %.2f, which is sent again', sent.pose.position.x,
                      sent.pose.position.y)
        rospy.sleep(self.retry_after)
        if sent is self.goal:
            self.send()


def main():
    """Sends goals until the node is shut down."""
    rospy.init_node('goal_sender')
    try:
        GoalSender()
        rospy.spin()
    except rospy.ROSInterruptException:
        pass
