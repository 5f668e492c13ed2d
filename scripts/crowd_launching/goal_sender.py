"""Sends the goals of a robot to move_base."""
import math
import threading

import actionlib
import rospy
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseStamped
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal

from .back_off import BackOff

PERIOD = 0.01  # [s] between two checks, wall clock


class GoalSender:
    """Sends the present goal, and sends it again when move_base has given it up, or is done elsewhere. A robot whose
    goal was given up backs off before.

    move_base, when its goal changes, may finish a plan to the goal before, reach that, and report success.
    """

    def __init__(self):
        self.retry_after = rospy.Duration(rospy.get_param('~retry_after', 1.0))
        self.lock = threading.Lock()
        self.goal = None  # the last one that was received
        self.is_new = False  # and has not been sent
        self.ended_at = None  # simulated time at which move_base ended without being at the goal
        self.tolerance = rospy.get_param('~tolerance', 0.3)
        self.place = None  # of the robot, as move_base says
        self.back_off = BackOff()
        self.client = actionlib.SimpleActionClient('move_base', MoveBaseAction)
        while not self.client.wait_for_server(rospy.Duration(1.0)) and not rospy.is_shutdown():
            rospy.loginfo_throttle(10.0, 'waiting for move_base')
        rospy.Subscriber('goal', PoseStamped, self.take, queue_size=10, tcp_nodelay=True)

    def take(self, goal):
        with self.lock:
            self.goal = goal
            self.is_new = True

    def run(self):
        """Sends goals until the node is shut down. The callbacks of the action must not send."""
        while not rospy.is_shutdown():
            if self.must_send():
                self.client.send_goal(MoveBaseGoal(target_pose=self.goal), feedback_cb=self.note_place)
            threading.Event().wait(PERIOD)

    def note_place(self, feedback):
        self.place = feedback.base_position.pose.position

    def must_send(self):
        with self.lock:
            is_new, self.is_new = self.is_new, False
        if is_new or self.goal is None or not self.has_failed():
            self.ended_at = None
            self.back_off.stop()
            return is_new
        if self.ended_at is None:
            self.ended_at = rospy.get_rostime()
            rospy.logwarn('move_base has ended away from the goal %.2f, %.2f, which is sent again',
                          self.goal.pose.position.x, self.goal.pose.position.y)
        if rospy.get_rostime() - self.ended_at < self.retry_after:
            return False
        return self.client.get_state() != GoalStatus.ABORTED or self.back_off.is_done()

    def has_failed(self):
        """Returns whether move_base has ended and is not at the goal."""
        state = self.client.get_state()
        if state != GoalStatus.SUCCEEDED or self.place is None:
            return state == GoalStatus.ABORTED
        goal = self.goal.pose.position
        return math.hypot(self.place.x - goal.x, self.place.y - goal.y) > self.tolerance


def main():
    rospy.init_node('goal_sender')
    try:
        GoalSender().run()
    except rospy.ROSInterruptException:
        pass
