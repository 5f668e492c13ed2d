#!/usr/bin/python3
"""robot_lab.launch with AMCL, and with a map of map_server. Skipped where these, or move_base, are not built."""
import math

import numpy
import rospkg
import support
from nav_msgs.msg import OccupancyGrid
from robot_launching import RobotLaunchTestCase
from social_crowd.msg import AgentStates
from tf2_msgs.msg import TFMessage

PATIENCE = 300.0  # [s] for a tour, on a busy machine
CELL = 0.05  # [m]
LENGTH, WIDTH = 12.0, 8.0  # of the hall [m]; its corner is at the origin
# The robot's tour is 29 m long; errors of its odometry are so large that it would be lost without AMCL.
LAB = """
name: lab
duration: 600
goal_tolerance: {tolerance}
contact: solid
ends: robots
map: lab.yaml
free_radius: 0.4
agents:
  - {{count: 8, position: {{map: free}}, route: walk, speed: [1.0, 1.5], radius: 0.25}}
routes:
  walk: {{repeat: true, waypoints: [{{place: {{map: free}}}}]}}
robots:
  - {{name: tug, position: [1.5, 1.5], heading: 0, goals: [[10.5, 1.5], [10.5, 6.5], [2, 6.5], [2, 1.5]], radius: 0.25,
     max_speed: 1, odometry: {{distance: 0.03, rotation: 0.05, heading_per_metre: 0.05}},
     scan: {{range: [0.1, 10], noise: 0.02, people: legs}}}}
"""
START = (1.5, 1.5, 0.0)  # of the robot in LAB: x, y [m], heading
TOLERANCE = 0.3  # of goals [m]
# move_base stops at most 0.2 m (two thirds of the tolerance) from a goal by the localised pose: with a larger error the
# robot is not at its goal.
LARGEST_ERROR = TOLERANCE / 3
# The scenario's own map has a door at the top, the other one at the bottom of the wall between the two rooms.
DOORS = """
name: doors
duration: 300
goal_tolerance: 0.3
contact: solid
ends: robots
map: top.yaml
agents:
  - {{position: [11, 2], goal: [1, 2], speed: 1.0, radius: 0.25}}
  - {{position: [11, 6], goal: [1, 6], speed: 1.0, radius: 0.25}}
robots:
  - {{name: tug, position: [1.5, 4], goal: [10.5, 4], radius: 0.25, max_speed: 1}}
"""


def hall(*boxes):
    """Returns the cells of the hall, the lowest row first, with outer walls and boxes ((x, y), (x, y))."""
    cells = numpy.zeros((round(WIDTH / CELL), round(LENGTH / CELL)), dtype=bool)
    cells[[0, -1], :] = cells[:, [0, -1]] = True
    for low, high in boxes:
        (left, bottom), (right, top) = ((round(x / CELL), round(y / CELL)) for x, y in (low, high))
        cells[bottom:top, left:right] = True
    return cells


def moved(pose, by):
    """Returns the pose `by`, (x, y, heading), of the frame `pose`, in the frame of `pose`'s parent."""
    (x, y, heading), (ahead, left, turn) = pose, by
    cos, sin = math.cos(heading), math.sin(heading)
    return x + cos * ahead - sin * left, y + sin * ahead + cos * left, heading + turn


class LabTestCase(RobotLaunchTestCase):
    """A hall of 12 m x 8 m."""

    def require(self, *packages):
        """Skips the test where a package is missing."""
        missing = set(packages) - set(rospkg.RosPack().list())
        if missing:
            self.skip(f'not in the environment in which the package was configured: {", ".join(sorted(missing))}')

    def write_map(self, name, cells):
        """Writes a map as NAME.pgm and NAME.yaml. Returns the latter."""
        rows = [' '.join('0' if cell else '254' for cell in row) for row in cells[::-1]]
        height, width = cells.shape
        self.write(f'{name}.pgm', f'P2\n{width} {height}\n255\n' + '\n'.join(rows) + '\n')
        return self.write(f'{name}.yaml', f'image: {name}.pgm\nresolution: {CELL}\norigin: [0, 0, 0]\nnegate: 0\n'
                          'occupied_thresh: 0.65\nfree_thresh: 0.196\n')


class LocalisationTest(LabTestCase):
    """AMCL localises a robot that move_base drives."""

    def test_the_robot_knows_where_it_is_among_people(self):
        self.require('amcl', 'move_base')
        self.write_map('lab', hall(((4, 3), (5, 5)), ((7.5, 3.5), (8.5, 4)), ((5.8, 7), (6.2, 8)),
                                   ((0, 4), (0.8, 4.4))))
        frames = self.listen('/tf', TFMessage)
        launched = self.drive('robot_lab.launch', localisation='amcl', navigation='move_base', real_time_factor=2,
                              episodes=1, scenario=self.write('scene.yaml', LAB.format(tolerance=TOLERANCE)))
        self.assertEqual(launched.wait(PATIENCE), 0)
        self.assertNotIn('crashed', launched.output())
        self.wait_until_arrived()
        self.assert_nobody_was_touched()
        localised, odometry = self.errors(frames)
        found = (f'error in {len(localised)} ticks: {localised.mean():.3f} m, in 95 % below '
                 f'{numpy.percentile(localised, 95):.3f} m; of the odometry up to {odometry.max():.2f} m')
        print(found)
        self.assertGreater(len(localised), 0.8 * len(self.states.messages), found)
        self.assertLess(numpy.percentile(localised, 95), LARGEST_ERROR, found)
        self.assertGreater(odometry.max(), 3 * LARGEST_ERROR, found)

    def errors(self, frames):
        """Returns the distances of the localised pose from the true one, and those by the odometry alone, in the ticks
        in which both are known [m]."""
        truth = {message.header.stamp: message.robots[0].pose for message in self.states.messages}
        correction, localised, odometry = None, [], []
        for frame in (frame for message in list(frames.messages) for frame in message.transforms):
            place, rotation = frame.transform.translation, frame.transform.rotation
            pose = (place.x, place.y, 2 * math.atan2(rotation.z, rotation.w))
            if frame.child_frame_id == 'odom':
                correction = pose
            elif frame.child_frame_id == 'base_link' and correction and frame.header.stamp in truth:
                true = truth[frame.header.stamp]
                for errors, parent in ((localised, correction), (odometry, START)):
                    x, y, _ = moved(parent, pose)
                    errors.append(math.hypot(x - true.x, y - true.y))
        return numpy.array(localised), numpy.array(odometry)


class MapTest(LabTestCase):
    """The map of map_server, in place of that of the scenario."""

    def test_robot_and_people_walk_through_the_door_of_the_other_map(self):
        self.require('map_server', 'move_base')
        self.write_map('top', hall(((5.8, 0), (6.2, 6.4))))
        other = hall(((5.8, 1.6), (6.2, 8)))
        file = self.write_map('bottom', other)
        grids = self.listen('map', OccupancyGrid)
        agents = self.listen('agents', AgentStates)
        launched = self.drive('robot_lab.launch', map=file, navigation='move_base', real_time_factor=10,
                              episodes=1, scenario=self.write('doors.yaml', DOORS.format()))
        self.assertEqual(launched.wait(PATIENCE), 0)
        self.assertNotIn('crashed', launched.output())
        self.wait_until_arrived()
        self.assert_nobody_was_touched()
        robot = [(message.robots[0].pose.x, message.robots[0].pose.y) for message in self.states.messages]
        people = [[(message.agents[i].pose.x, message.agents[i].pose.y) for message in agents.messages] for i in (0, 1)]
        for way in (robot, *people):
            self.assert_passes_below(way)
        grid = grids.messages[-1]
        self.assertEqual((grid.info.width, grid.info.height), (240, 160))
        self.assertTrue(numpy.array_equal(numpy.array(grid.data).reshape(160, 240) == 100, other))

    def assert_passes_below(self, way):
        """Checks that a way leads from one room to the other through the door at the bottom. People are not published
        in all ticks."""
        self.assertTrue(min(x for x, _ in way) < 5 and max(x for x, _ in way) > 7)
        x, y = min(way, key=lambda place: abs(place[0] - 6))
        self.assertLess(abs(x - 6), 1.0)
        self.assertLess(y, 3.0)


if __name__ == '__main__':
    support.run('robot_lab_test')
