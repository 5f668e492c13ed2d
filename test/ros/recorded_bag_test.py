#!/usr/bin/python3
"""A bag that was recorded as docs/running.md says shows everything when it is replayed."""
import re
import shlex

import rospy
import support
from geometry_msgs.msg import Point
from launching import LaunchTestCase
from nav_msgs.msg import OccupancyGrid
from recording import RecordingTestCase
from sensor_msgs.msg import LaserScan
from social_crowd.msg import AgentStates
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import MarkerArray

# The gate is open from 1 s on.
SCENE = """
name: scene
duration: 600
goal_tolerance: 0.3
map: {map}
agents:
  - {{position: [20, 10], goal: [24, 10], speed: 0.5, radius: 0.25}}
obstacles:
  - {{position: [20, 12], radius: 0.4, velocity: [0.1, 0]}}
gates:
  door: {{wall: [[18, 9], [18, 11]], open: [[1, 600]]}}
robots:
  - {{name: tug, position: [22, 12], radius: 0.3, max_speed: 1, namespace: ''}}
"""
GATE = {(18.0, 9.0), (18.0, 11.0)}
ADDED = {(28.0, 9.0), (28.0, 11.0)}
TICKS = 30
STANDS = 2.0  # [s] for which the crowd stands in the bag, so that its picture is drawn when it is replayed
HEARD = ('agents', 'robots', 'scan', 'walls', 'map', 'scenario')


def places_in(array, namespace):
    """Returns the places of the markers of a namespace: of their points, or of themselves."""
    places = set()
    for marker in array.markers:
        if marker.ns == namespace:
            for point in marker.points or [marker.pose.position]:
                places.add((round(point.x, 3), round(point.y, 3)))
    return places


def middle_of(places):
    """Returns the middle of the box around places; None without places."""
    if not places:
        return None
    return tuple(round((min(values) + max(values)) / 2, 2) for values in zip(*places))


class RecordedBagTest(LaunchTestCase, RecordingTestCase):
    """Record and replay."""

    def record(self):
        """Records a crowd that is stepped, and to which a wall is added. Returns where its agent was at the end."""
        page = support.read_text(support.in_package('docs', 'running.md'))
        words = shlex.split(re.search('^    (rosbag record .*)$', page, re.MULTILINE)[1])
        words[words.index('walk.bag')] = self.path('walk.bag')
        self.start_learner(q_table=support.ANTICIPATION_TABLE)
        floor = support.in_package('config', 'maps', 'station.yaml')
        self.start_controller(self.write('scene.yaml', SCENE.format(map=floor)), paused=True,
                              real_time_factor=1.0)
        self.call_later('crowd_controller/pause', data=True).result()
        recorder = self.start('rosbag', [*words, '__name:=recorder'])
        support.wait_for(lambda: all(self.is_heard('crowd_controller', f'{self.namespace}/{name}') for name in HEARD),
                         'rosbag to listen')
        states = self.listen('agents', AgentStates)
        self.step(5)
        begin, end = (Point(*place, 0) for place in sorted(ADDED))
        self.succeed('crowd_controller/add_wall', begin=begin, end=end)
        rospy.sleep(STANDS)  # with the closed gate
        self.step(TICKS - 5)
        last = states.wait_at(0, TICKS)
        rospy.sleep(STANDS)
        self.step(1)  # so that the messages of the tick before are in the bag
        self.assertEqual(recorder.stop(), 0)
        self.assertEqual(self.clean_up(), '')
        return last

    def test_all_is_shown_again(self):
        last = self.record()
        topics = {'recording/scan': LaserScan, 'recording/map': OccupancyGrid, '/tf': TFMessage}
        ears = {name: self.listen(name, kind) for name, kind in topics.items()}
        markers = self.listen('recording/markers', MarkerArray)
        launched = self.launch('replay.launch', bag=self.path('walk.bag'), rate=2.0)
        body = (round(last.agents[0].pose.x, 3), round(last.agents[0].pose.y, 3))
        obstacle = (round(last.obstacles[0].position.x, 2), round(last.obstacles[0].position.y, 2))
        markers.wait(lambda array: middle_of(places_in(array, 'obstacles')) == obstacle, 'with the obstacle at its end')
        for name, namespace, places in (('the agent at its end', 'figures', {body}), ('the added wall', 'walls', ADDED),
                                        ('the closed gate', 'walls', GATE)):
            markers.wait(lambda array, where=namespace, what=places: what <= places_in(array, where), f'with {name}')
        self.assertTrue(any(places_in(array, 'robots') for array in markers.messages))
        self.assert_ends_well(launched)
        self.assertFalse(GATE & places_in(markers.messages[-1], 'walls'), 'the gate has opened')
        self.assertGreaterEqual(len(ears['recording/scan'].messages), 10)
        self.assertEqual(len(ears['recording/map'].messages), 1)
        frames = {transform.child_frame_id for message in ears['/tf'].messages for transform in message.transforms}
        self.assertLessEqual({'odom', 'base_link'}, frames)


if __name__ == '__main__':
    support.run('recorded_bag_test')
