#!/usr/bin/python3
"""PeopleLayer in a costmap of costmap_2d. Skipped where costmap_2d is not built.

The frame odom is turned by 90 degrees in map and lies at (10, 0): (x, y) in odom is (10 - y, x) in map.
"""
import math

import rospkg
import rospy
import support
from geometry_msgs.msg import Point, TransformStamped, Vector3
from nav_msgs.msg import OccupancyGrid
from roslib.packages import find_node
from social_crowd.msg import AgentState, AgentStates
from tf2_msgs.msg import TFMessage

try:
    from people_msgs.msg import People, Person
except ImportError:
    People = None

AHEAD = rospy.Duration(30.0)  # of the stamps, within the timeout: nobody is moved on by the age of the message
SETTINGS = {'amplitude': 200, 'cutoff': 20, 'spread': 0.5, 'stretch': 0.5, 'horizon': 0.0, 'timeout': 60.0}
AMPLITUDE = 200


def published(cost):
    """Returns a cost from 1 to 252 as costmap_2d publishes it."""
    return 1 + 97 * (int(cost) - 1) // 251


def cell_at(info, x, y):
    """Returns column and row of the cell of a grid at a point."""
    return (math.floor((x - info.origin.position.x) / info.resolution),
            math.floor((y - info.origin.position.y) / info.resolution))


def transform(parent, child, x, y, heading):
    """Returns a transform that never changes."""
    message = TransformStamped()
    message.header.frame_id, message.child_frame_id, message.header.stamp = parent, child, rospy.Time.now()
    message.transform.translation = Vector3(x, y, 0)
    message.transform.rotation.z, message.transform.rotation.w = math.sin(heading / 2), math.cos(heading / 2)
    return message


class PeopleLayerTest(support.CrowdTestCase):
    """A rolling costmap of 10 m in the frame odom, around a robot at its origin."""

    def setUp(self):
        super().setUp()
        if 'costmap_2d' not in rospkg.RosPack().list():
            self.skip('costmap_2d is not in the environment in which the package was configured')
        self.frames = rospy.Publisher('/tf_static', TFMessage, queue_size=10, latch=True)
        self.addCleanup(self.frames.unregister)
        self.place_robot(0.0)

    def place_robot(self, x):
        """Publishes all frames, with the robot at (x, 0) in odom."""
        self.frames.publish([transform('map', 'odom', 10.0, 0.0, math.pi / 2),
                             transform('odom', 'base_link', x, 0.0, 0.0)])

    def start_costmap(self, source='agents', **more):
        """Starts a costmap with the layer, and connects to it."""
        layer = f'{self.namespace}/costmap_node/costmap/people'
        costmap = {'global_frame': 'odom', 'robot_base_frame': 'base_link', 'rolling_window': True, 'width': 10.0,
                   'height': 10.0, 'resolution': 0.1, 'update_frequency': 20.0, 'publish_frequency': 20.0,
                   'always_send_full_costmap': True, 'robot_radius': 0.2,
                   'plugins': [{'name': 'people', 'type': 'social_crowd/PeopleLayer'}],
                   'people': {**SETTINGS, 'source': source, **more}}
        rospy.set_param(f'{self.namespace}/costmap_node/costmap', costmap)
        self.layer = layer
        self.node = self.start('costmap', [*find_node('costmap_2d', 'costmap_2d_node')[:1], '__name:=costmap_node'])
        self.costmaps = self.listen('costmap_node/costmap/costmap', OccupancyGrid)
        kind = AgentStates if source == 'agents' else People
        self.people = rospy.Publisher(f'{self.namespace}/{source}', kind, queue_size=1, latch=True)
        self.addCleanup(self.people.unregister)
        support.wait_for(lambda: self.people.get_num_connections() > 0, 'the layer')

    def publish(self, x, y, velocity=(0.0, 0.0), age=-AHEAD, frame='map'):
        """Publishes one person, with its place and velocity in `frame`."""
        message = AgentStates()
        message.header.frame_id, message.header.stamp = frame, rospy.Time.now() - age
        walking = AgentState(status=AgentState.WALKING)
        walking.pose.x, walking.pose.y = x, y
        walking.velocity = Vector3(*velocity, 0.0)
        arrived = AgentState(status=AgentState.ARRIVED)  # is not there
        arrived.pose.x, arrived.pose.y = 9.0, -1.0
        message.agents = [walking, arrived]
        self.people.publish(message)

    def cost(self, x, y):
        """Returns the published cost of the cell at a point in odom; None before the first costmap."""
        if not self.costmaps.messages:
            return None
        grid = self.costmaps.messages[-1]
        column, row = cell_at(grid.info, x, y)
        return grid.data[row * grid.info.width + column]

    def cost_for(self, x, y, place, ahead):
        """Returns what the cost is for a person at `place` who looks along x with the standard deviation `ahead`."""
        info = self.costmaps.messages[-1].info
        column, row = cell_at(info, x, y)
        along = (column + 0.5) * info.resolution + info.origin.position.x - place[0]
        across = (row + 0.5) * info.resolution + info.origin.position.y - place[1]
        along /= ahead if along > 0 else 0.5
        cost = AMPLITUDE * math.exp(-0.5 * (along ** 2 + (across / 0.5) ** 2))
        return published(cost) if cost >= SETTINGS['cutoff'] else 0

    def wait_for_cost(self, x, y, fits, what):
        """Waits until the cost at a point fits."""
        support.wait_for(lambda: self.cost(x, y) is not None and fits(self.cost(x, y)), what)

    def assert_costs(self, place, ahead, points):
        """Checks costs around a person who looks along x of odom; within 1, for the rounding of the cells' centres."""
        for x, y in points:
            self.assertAlmostEqual(self.cost(x, y), self.cost_for(x, y, place, ahead), delta=1, msg=f'{x}, {y}')

    def check_a_walker(self):
        """Checks the costs around a person at (2.05, 1.05) who walks along x with 2 m/s, all in odom."""
        self.wait_for_cost(2.05, 1.05, lambda cost: cost == published(200), 'the cost of the person')
        # The standard deviation ahead is 0.5 m (1 + 0.5 s/m 2 m/s) = 1 m; 200 exp(-1/2) = 121.3.
        self.assertEqual([self.cost(x, y) for x, y in ((3.05, 1.05), (1.55, 1.05), (2.05, 1.55), (2.05, 0.55))],
                         [published(121.3)] * 4)
        self.assertEqual(published(121.3), 47)
        self.assertEqual(self.cost(4.25, 1.05), 0)  # beyond 2.146 standard deviations
        self.assertGreater(self.cost(4.15, 1.05), 0)
        self.assertEqual(self.cost(0.85, 1.05), 0)
        self.assert_costs((2.05, 1.05), 1.0, [(x / 4, y / 4) for x in range(-10, 20) for y in range(-10, 18)])

    def test_people_in_another_frame(self):
        self.start_costmap()
        self.publish(10.0 - 1.05, 2.05, (0.0, 2.0))
        self.check_a_walker()

    def test_people_msgs(self):
        if People is None:
            self.skip('people_msgs is not in the environment in which the package was configured')
        self.start_costmap('people')
        message = People()
        message.header.frame_id, message.header.stamp = 'map', rospy.Time.now() + AHEAD
        message.people = [Person(position=Point(8.95, 2.05, 0), velocity=Point(0, 2, 0)),
                          Person(position=Point(math.nan, 2.05, 0))]
        self.people.publish(message)
        self.check_a_walker()
        self.assert_says(self.node.output(), 'not finite are left out')

    def test_costs_follow_people_and_window(self):
        self.start_costmap()
        self.publish(2.05, 1.05, frame='odom')
        self.wait_for_cost(2.05, 1.05, lambda cost: cost == published(200), 'the cost of the person')
        self.publish(-2.05, 1.05, frame='odom')
        self.wait_for_cost(-2.05, 1.05, lambda cost: cost == published(200), 'the cost of the next place')
        self.assert_costs((-2.05, 1.05), 0.5, [(x / 4, y / 4) for x in range(-18, 20) for y in range(-10, 18)])
        self.place_robot(-3.0)
        support.wait_for(lambda: self.costmaps.messages[-1].info.origin.position.x < -7.5, 'the window to move')
        self.assert_costs((-2.05, 1.05), 0.5, [(x / 4, y / 4) for x in range(-30, 6) for y in range(-10, 18)])

    def test_old_data_are_not_used(self):
        self.start_costmap()
        self.publish(2.05, 1.05, frame='odom')
        self.wait_for_cost(2.05, 1.05, lambda cost: cost == published(200), 'the cost of the person')
        self.publish(2.05, 1.05, frame='odom', age=rospy.Duration(61.0))
        self.wait_for_cost(2.05, 1.05, lambda cost: cost == 0, 'the costs to be cleared')
        self.assert_says(self.node.output(), 'agents: the people are 61.', ' s old and not used')

    def test_people_are_moved_on_by_the_age_of_the_data(self):
        self.start_costmap()
        self.publish(0.05, 1.05, (0.1, 0.0), age=rospy.Duration(20.0), frame='odom')  # 2 m since then, and 0.1 m/s now
        self.wait_for_cost(2.55, 1.05, lambda cost: cost == published(200), 'the person there')

    def test_frames_that_are_not_known(self):
        self.start_costmap()
        self.publish(2.05, 1.05, frame='mars')
        support.wait_for(lambda: 'mars' in self.node.output(), 'a warning')
        self.assert_says(self.node.output(), 'agents: the people are not used: "mars"')
        self.publish(2.05, 1.05, frame='odom')
        self.wait_for_cost(2.05, 1.05, lambda cost: cost == published(200), 'the cost of the person')

    def test_parameters_change(self):
        self.start_costmap(spread=-1, amplitude=300)
        self.assert_says(self.node.output(), 'people/spread: expected a number from', 'got -1; it stays 0.4',
                         'people/amplitude: expected a number from 1 to 252, got 300; it stays 200')
        self.publish(2.05, 1.05, frame='odom')
        self.wait_for_cost(2.05, 1.05, lambda cost: cost == published(200), 'the cost of the person')
        rospy.set_param(f'{self.layer}/amplitude', 100.0)
        self.wait_for_cost(2.05, 1.05, lambda cost: cost == published(100), 'the new amplitude')
        rospy.set_param(f'{self.layer}/enabled', False)
        self.wait_for_cost(2.05, 1.05, lambda cost: cost == 0, 'the costs to be cleared')


if __name__ == '__main__':
    support.run('people_layer_test')
