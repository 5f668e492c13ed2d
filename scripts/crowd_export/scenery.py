"""Floor, walls, obstacles, gates and robots in a glTF document."""
import numpy
from crowd_drawing.files import OCCUPIED_COLOUR, is_open, place_of
from crowd_figures.shapes import box, ellipse, loft

from .gltf import smoothed
from .people import floor, person_quaternions

FLOOR, WALL, OBSTACLE, GATE, ROBOT = (0.74, 0.74, 0.72), (0.5, 0.53, 0.57), (0.62, 0.6, 0.56), (0.7, 0.2, 0.2), (
    0.95, 0.66, 0.0)
THICKNESS, MARGIN = 0.1, 1.5  # of walls, and of the floor around everything [m]
GATE_HEIGHT, ROBOT_HEIGHT, OBSTACLE_HEIGHT = 1.0, 0.6, 1.0  # [m]


class Scenery:
    """Adds what is not a person to a document, whose animation lasts from 0 to `duration` [s]."""

    def __init__(self, document, times, wall_height):
        self.document, self.times, self.wall_height = document, times, wall_height
        self.shared = None  # accessor of the times

    def add(self, scene, people, start):
        """Adds the surroundings of a Scene; `start`: time of the first frame [s]."""
        walls = [wall_between(*wall, self.wall_height) for wall in scene.walls]
        if scene.map is not None:
            walls += boxes_of(scene.map, self.wall_height)
        places = [person.places() for person in people] + [wall[..., :2].reshape(-1, 2) for wall in walls]
        places += [robot['track'].places for robot in scene.robots if 'track' in robot]
        places = numpy.concatenate(places)
        low, high = places.min(axis=0) - MARGIN, places.max(axis=0) + MARGIN
        self.static('floor', box((*low, -0.05), (*high, 0.0)), FLOOR)
        if walls:
            self.static('walls', numpy.concatenate(walls), WALL)
        for number, obstacle in enumerate(scene.obstacles):
            if obstacle['position'] is not None:
                ways = numpy.array([place_of(obstacle, start + time) for time in self.times])
                self.moving(f'obstacle_{number}', disc(obstacle['radius'], OBSTACLE_HEIGHT), OBSTACLE, ways)
        for number, (wall, periods) in enumerate(scene.population.gates):
            self.gate(f'gate_{number}', wall, [is_open(periods, start + time) for time in self.times])
        for number, robot in enumerate(scene.robots):
            if 'track' in robot:
                ways = numpy.array([robot['track'].place_at(start + time) for time in self.times])
                headings = numpy.array([robot['track'].heading_at(start + time) for time in self.times])
                self.moving(f'robot_{number}', robot_shape(robot['radius']), ROBOT, ways, headings)

    def mesh(self, name, shape, colour):
        points, normals, indices = smoothed(shape)
        primitive = self.document.primitive(floor(points), floor(normals), indices)
        return self.document.add('meshes', {'name': name, 'primitives': [
            {**primitive, 'material': self.document.material(name, colour)}]})

    def static(self, name, shape, colour):
        return self.document.node(name, mesh=self.mesh(name, shape, colour))

    def moving(self, name, shape, colour, ways, headings=None):
        """Adds a body that moves along places, one for each frame."""
        places = floor(numpy.column_stack([ways, numpy.zeros(len(ways))])).astype('float32')
        node = self.document.node(name, mesh=self.mesh(name, shape, colour), translation=places[0].tolist())
        tracks = {'translation': places}
        if headings is not None:
            tracks['rotation'] = person_quaternions(headings - numpy.pi / 2).astype('float32')
        for path, values in tracks.items():
            if numpy.ptp(values, axis=0).max() > 0:
                if self.shared is None:
                    self.shared = self.document.accessor(self.times.astype('float32'), None, True)
                self.document.animate(node, path, self.shared, values)

    def gate(self, name, wall, opened):
        """Adds a gate, which is not there while it is open."""
        node = self.static(name, wall_between(*wall, GATE_HEIGHT), GATE)
        changes = [0, *(frame for frame in range(1, len(opened)) if opened[frame] != opened[frame - 1])]
        if len(changes) > 1 or opened[0]:
            times = self.document.accessor(self.times[changes].astype('float32'), None, True)
            sizes = numpy.array([[0.0 if opened[frame] else 1.0] * 3 for frame in changes], 'float32')
            self.document.animate(node, 'scale', times, sizes, 'STEP')


def wall_between(start, end, height):
    """Returns a box along a wall."""
    start, end = numpy.array(start, float), numpy.array(end, float)
    ahead = (end - start) / max(1e-9, numpy.linalg.norm(end - start)) * THICKNESS / 2
    left = numpy.array([-ahead[1], ahead[0]])
    corners = [start - ahead - left, end + ahead - left, end + ahead + left, start - ahead + left]
    return loft([[(*corner, z) for corner in corners] for z in (0.0, height)])


def boxes_of(picture, height):
    """Returns boxes on the occupied cells of a MapPicture, as large as possible."""
    cells = (picture.pixels[::-1] == OCCUPIED_COLOUR).all(axis=2)
    open_runs, found = {}, []
    for row in range(len(cells) + 1):
        line = cells[row] if row < len(cells) else numpy.zeros(cells.shape[1], bool)
        edges = numpy.flatnonzero(numpy.diff(numpy.r_[False, line, False].astype(int)))
        runs = set(zip(edges[::2].tolist(), edges[1::2].tolist()))
        for run in set(open_runs) - runs:
            found.append((run, open_runs.pop(run), row))
        for run in runs - set(open_runs):
            open_runs[run] = row
    turn, shapes = picture.transform(), []
    for (left, right), low, high in sorted(found):
        shape = box((left * picture.resolution, low * picture.resolution, 0.0),
                    (right * picture.resolution, high * picture.resolution, height))
        shape[..., :2] = turn.transform(shape[..., :2].reshape(-1, 2)).reshape(-1, 3, 2)
        shapes.append(shape)
    return shapes


def disc(radius, height):
    return loft([ellipse((0, 0, z), radius, radius, 24) for z in (0.0, height)])


def robot_shape(radius):
    """A cylinder with a mark that points ahead."""
    nose = box((0.4 * radius, -0.15 * radius, ROBOT_HEIGHT), (0.95 * radius, 0.15 * radius, ROBOT_HEIGHT + 0.08))
    return numpy.concatenate([disc(radius, ROBOT_HEIGHT), nose])
