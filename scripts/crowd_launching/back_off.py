"""Drives a robot back or ahead a little, away from what it touches."""
import math
import threading

import rospy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from sensor_msgs.msg import LaserScan

SPEED = 0.1  # [m/s]
PATIENCE = 3.0  # times as long as the way takes
HELD_AFTER, HELD = rospy.Duration(1.0), 0.02  # a robot that has moved less [m] after this time is held
MARGIN = 0.1  # [m] free behind the robot, or in front of it
SILENCE = rospy.Duration(0.6)  # another node may command the robot when this one was silent for its cmd_timeout


class BackOff:
    """Drives straight back by ~back_off metres, or ahead if something that it touches holds the robot, while nothing is
    in its way. Messages of the odometry are the clock: a command follows each. drive() is called in a thread of rospy,
    the others in that of the goal sender."""

    def __init__(self):
        self.lock = threading.Lock()
        self.way = rospy.get_param('~back_off', 0.3)
        self.radius = rospy.get_param('~radius', 0.25)
        self.start = None  # position [m] in odom
        self.begun = None  # time
        self.direction = -1.0  # 1: ahead
        self.ended = None  # time at which it stopped
        self.is_active = False
        self.scan = None
        self.commands = rospy.Publisher('cmd_vel', Twist, queue_size=1, tcp_nodelay=True)
        rospy.Subscriber('odom', Odometry, self.drive, queue_size=1, tcp_nodelay=True)
        rospy.Subscriber('scan', LaserScan, self.note_scan, queue_size=1, tcp_nodelay=True)

    def note_scan(self, scan):
        self.scan = scan

    def is_done(self):
        """Returns whether the robot has backed off; begins if it has not."""
        if self.way <= 0.0:
            return True
        with self.lock:
            self.is_active = self.ended is None
            return self.ended is not None and rospy.get_rostime() - self.ended > SILENCE

    def stop(self):
        """Stops the robot if it is on the way, so that the next call of is_done() begins again."""
        with self.lock:
            if self.is_active:
                self.commands.publish(Twist())
            self.is_active = False
            self.start = self.ended = None

    def drive(self, odometry):
        """Commands the robot after a message of its odometry."""
        with self.lock:
            if self.is_active:
                self.drive_on(odometry)

    def drive_on(self, odometry):
        place, now = odometry.pose.pose.position, odometry.header.stamp
        if self.start is None:
            self.start, self.begun, self.direction = place, now, -1.0
        command = Twist()
        driven = math.hypot(place.x - self.start.x, place.y - self.start.y)
        if driven < HELD and (now - self.begun > HELD_AFTER or not self.is_free()):
            self.direction = 1.0
        in_time = now - self.begun < rospy.Duration(PATIENCE * self.way / SPEED)
        if driven < self.way and in_time and self.is_free():
            command.linear.x = self.direction * SPEED
        else:
            self.is_active, self.ended = False, now
        self.commands.publish(command)

    def is_free(self):
        """Returns whether the scan has nothing within the margin in the direction of the motion."""
        if self.scan is None:
            return False
        angle = self.scan.angle_min
        for distance in self.scan.ranges:
            ahead, left = self.direction * distance * math.cos(angle), distance * math.sin(angle)
            angle += self.scan.angle_increment
            # Points at the side of the robot, such as on a wall that it touches, do not count.
            if 0.5 * self.radius < ahead < self.radius + MARGIN and abs(left) < self.radius:
                return False
        return True
