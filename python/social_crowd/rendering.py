"""Pictures of a robot and its surroundings, drawn with NumPy."""
import numpy

PIXELS = 480  # height and width of a picture
WIDTH = 12.0  # that it shows [m]
GROUND, WALL, PERSON, ROBOT, NOSE, GOAL, HIT = (
    (250, 250, 250), (60, 60, 60), (70, 110, 190), (210, 90, 50), (255, 255, 255), (60, 160, 80), (200, 60, 60))
WALL_WIDTH, POINT, GOAL_RADIUS = 0.06, 0.04, 0.2  # [m]


class Picture:
    """An image around a place, north up."""

    def __init__(self, centre):
        self._centre = numpy.asarray(centre)
        self._scale = PIXELS / WIDTH
        self.image = numpy.empty((PIXELS, PIXELS, 3), numpy.uint8)
        self.image[:] = GROUND

    def disc(self, place, radius, colour):
        """Draws a disc [m]."""
        self._draw(place, place, radius, colour)

    def line(self, start, end, width, colour):
        """Draws a line with round ends [m]."""
        self._draw(start, end, 0.5 * width, colour)

    def _draw(self, start, end, radius, colour):
        """Draws all that is not farther than a radius from a line [m]."""
        start, end = self._pixels(start), self._pixels(end)
        radius = max(0.7, radius * self._scale)
        low = numpy.maximum(0, numpy.floor(numpy.minimum(start, end) - radius - 1)).astype(int)
        high = numpy.minimum(PIXELS, numpy.ceil(numpy.maximum(start, end) + radius + 2)).astype(int)
        if (low >= high).any():
            return
        x, y = numpy.meshgrid(numpy.arange(low[0], high[0]), numpy.arange(low[1], high[1]))
        way = end - start
        share = 0.0
        if way.any():
            share = numpy.clip(((x - start[0]) * way[0] + (y - start[1]) * way[1]) / (way @ way), 0.0, 1.0)
        distance = numpy.hypot(x - start[0] - share * way[0], y - start[1] - share * way[1])
        cover = numpy.clip(radius - distance + 0.5, 0.0, 1.0)[..., None]
        part = self.image[low[1]:high[1], low[0]:high[0]]
        part[:] = numpy.rint(part + cover * (numpy.array(colour) - part.astype(float))).astype(numpy.uint8)

    def _pixels(self, place):
        x, y = (numpy.asarray(place, float) - self._centre) * self._scale
        return numpy.array([0.5 * PIXELS + x, 0.5 * PIXELS - y])


def draw_robot(task, element):
    """Returns a picture of the surroundings of a robot. task: a RobotTask"""
    known = {name: array[element] for name, array in task.backend.arrays.items()}
    x, y, heading = known['pose']
    picture = Picture((x, y))
    positions, radii, walls = task.backend.scene(element)
    for wall in walls:
        picture.line(wall[:2], wall[2:], WALL_WIDTH, WALL)
    if known['has_goal']:
        picture.disc(_in_map(known['pose'], known['goal']), GOAL_RADIUS, GOAL)
    for position, radius in zip(positions, radii):
        picture.disc(position, radius, PERSON)
    if 'scan' in known:
        for point in _hits(task.robot, known['scan']):
            picture.disc(_in_map(known['pose'], point), POINT, HIT)
    radius = task.robot['radius']
    picture.disc((x, y), radius, ROBOT)
    picture.line((x, y), (x + radius * numpy.cos(heading), y + radius * numpy.sin(heading)), 0.25 * radius, NOSE)
    return picture.image


def _in_map(pose, place):
    x, y, heading = pose
    c, s = numpy.cos(heading), numpy.sin(heading)
    return x + c * place[0] - s * place[1], y + s * place[0] + c * place[1]


def _hits(robot, ranges):
    """Returns the points that rays hit, as seen from the scanner, which is drawn at the centre of the robot."""
    hit = numpy.isfinite(ranges)
    bearings = robot['first_angle'] + numpy.flatnonzero(hit) * robot['angle_increment']
    return numpy.stack([ranges[hit] * numpy.cos(bearings), ranges[hit] * numpy.sin(bearings)], axis=1)
