"""The markers of a topic as RViz would show them, and states of agents for tests."""
import math
import threading

import rospy
from geometry_msgs.msg import Point, Pose2D
from social_crowd.msg import AgentState
from visualization_msgs.msg import Marker, MarkerArray


class Picture:
    """The markers of a topic as RViz would show them."""

    def __init__(self, topic):
        self._lock = threading.Lock()
        self._markers = {}
        self.most_markers = 0  # largest number of markers in a message
        self._subscriber = rospy.Subscriber(topic, MarkerArray, self._take, queue_size=100)

    def _take(self, array):
        with self._lock:
            self.most_markers = max(self.most_markers, len(array.markers))
            for marker in array.markers:
                self._markers.pop((marker.ns, marker.id), None)
                if marker.action == Marker.ADD:
                    self._markers[marker.ns, marker.id] = marker

    def markers(self, kind=None):
        with self._lock:
            return [marker for (ns, _), marker in sorted(self._markers.items()) if kind in (None, ns)]

    def kinds(self):
        return {marker.ns for marker in self.markers()}

    def points(self, kind):
        return [(point.x, point.y) for marker in self.markers(kind) for point in marker.points]

    def colours(self, kind):
        return {(colour.r, colour.g, colour.b) for marker in self.markers(kind) for colour in marker.colors}

    def body_count(self):
        return len(self.points('headings')) // 6  # two triangles each

    def close(self):
        self._subscriber.unregister()


def agent_at(number, x, y, goal=(9.0, 9.0), **others):
    return AgentState(agent=number, pose=Pose2D(x, y, 0.0), max_speed=1.3, radius=0.25, goal=Point(*goal, 0.0),
                      **others)


def sectors_of(points, centre):
    """Ring parts made of triangles: the smallest and largest angle of the triangles' centres [degrees], by outer radius
    [m]."""
    angles = {}
    for i in range(0, len(points), 3):
        triangle = [(x - centre[0], y - centre[1]) for x, y in points[i:i + 3]]
        outer = round(max(math.hypot(x, y) for x, y in triangle), 3)
        middle = [sum(corner[axis] for corner in triangle) / 3 for axis in (0, 1)]
        angles.setdefault(outer, []).append(math.degrees(math.atan2(middle[1], middle[0])))
    return {outer: (min(some), max(some)) for outer, some in angles.items()}


def fills(angles, limits):
    """Returns whether the centres of triangles fill the sector between the limits [degrees]; None: no sector."""
    if angles is None or limits is None:
        return angles is limits
    slack = 6.0  # [degrees]; a triangle is narrower than twice that
    return limits[0] <= angles[0] <= limits[0] + slack and limits[1] - slack <= angles[1] <= limits[1]
