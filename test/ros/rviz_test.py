#!/usr/bin/python3
"""RViz on a separate screen, with the configuration of the launch files: the picture of a running crowd.

The crowd is far from the origin, and has to be in view all the same.
"""

import os
import shutil
import subprocess
import tempfile
import unittest

import roslib.packages
import rospy
import rostest
from screens import Screen, end
from support import wait_for
from visualization_msgs.msg import Marker, MarkerArray

LIKE = 0.06  # difference of colour channels that still counts as the same colour


def count_like(picture, colour):
    """Returns the number of pixels of a picture [rows, columns, rgb] with approximately this colour."""
    return int((abs(picture[:, :, :3] - colour).max(axis=2) < LIKE).sum())


class RvizTest(unittest.TestCase):
    """Starts a screen and RViz on it."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.screen = Screen('1280x800x24')
        command = roslib.packages.find_node('social_crowd', 'show_crowd')[0]
        self.rviz = subprocess.Popen([command, '__name:=rviz'], env=self.screen.environment)

    def tearDown(self):
        end(self.rviz)
        self.screen.close()
        self.folder.cleanup()

    def screenshot(self):
        """Returns the pixels of the screen, or None if there is no picture yet."""
        return self.screen.picture(os.path.join(self.folder.name, 'shot.png'))

    def shows(self, colour, least):
        """Returns whether the screen has a minimum number of pixels of a colour."""
        self.assertIsNone(self.rviz.poll(), 'RViz has ended')
        picture = self.screenshot()
        return picture is not None and count_like(picture, colour) >= least

    def test_shows_bodies_obstacles_and_paths(self):
        seen = {}

        def note(array):
            for marker in array.markers:
                if marker.action == Marker.ADD:
                    seen[marker.ns] = marker

        rospy.Subscriber('markers', MarkerArray, note)
        wait_for(lambda: {'bodies', 'paths', 'obstacles'} <= set(seen), 'markers of a running crowd')
        for kind in ('bodies', 'obstacles'):
            colour = [getattr(seen[kind].colors[0], channel) for channel in 'rgb']
            wait_for(lambda: self.shows(colour, 100), '%s of colour %s on the screen' % (kind, colour))
        path = [getattr(seen['paths'].colors[0], channel) for channel in 'rgb']
        wait_for(lambda: self.shows(path, 20), 'a path of colour %s on the screen' % path)
        keep = os.environ.get('SOCIAL_CROWD_SCREENSHOT')
        if keep:
            shutil.copy(os.path.join(self.folder.name, 'shot.png'), keep)


if __name__ == '__main__':
    rospy.init_node('rviz_test')
    rostest.rosrun('social_crowd', 'rviz_test', RvizTest)
