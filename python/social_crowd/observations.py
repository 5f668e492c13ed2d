"""What a robot observes, computed from what the simulator knows of it; the same for Env, VecEnv and CrowdEnv."""
import numpy
from social_crowd.checks import whole_number
from social_crowd.errors import InputError
from social_crowd.spaces import Box, Dict

KINDS = ('scan', 'people', 'grid')
UNKNOWN, FREE, OCCUPIED = 128, 0, 255
PERSON = 5  # x, y, velocity x and y, radius


class Observation:
    """A choice of what a robot observes: `goal`, `velocity`, and one of `scan`, `people` and `grid`.

    All are arrays of float32 in the robot's frame (x ahead, y left), but for the grid:
    goal: x, y [m]; zeros without a goal
    velocity: ahead [m/s], rotation [rad/s]; of a holonomic robot ahead, left, rotation
    scan: a range for each ray [m]; the greatest range where nothing was seen, 0 below the least one
    people: x, y, velocity x and y, radius of each person whom the scanner sees, nearest first; rows of zeros follow
    grid: uint8 of shape (1, cells, cells), as an image: 0 free, 255 occupied, 128 not seen. Row i is at
        x = (i - (cells - 1) / 2) * resolution ahead of the scanner, column j at such a y to its left
    """

    def __init__(self, kind='scan', *, max_people=10, cells=48, resolution=0.1):
        """kind: scan, people or grid; max_people: rows of `people`; cells, resolution [m]: of `grid`"""
        if kind not in KINDS:
            raise InputError(f"observation: expected {', '.join(KINDS[:-1])} or {KINDS[-1]}, got {kind!r}")
        if not 0.0 < resolution < numpy.inf:
            raise InputError(f'resolution: expected a positive number [m], got {resolution!r}')
        self.kind = kind
        self.max_people = whole_number('max_people', max_people, least=1) if kind == 'people' else 0
        self.cells = whole_number('cells', cells, least=1)
        self.resolution = float(resolution)

    @staticmethod
    def of(given):
        """Returns an Observation. given: an Observation, or a kind"""
        return given if isinstance(given, Observation) else Observation(given)

    @property
    def needs_scan(self):
        """Whether the scan is needed."""
        return self.kind != 'people'

    def observer(self, robot):
        """Returns what observes for robots of this description."""
        return Observer(self, robot)


class Observer:
    """Writes the observations of robots that are alike."""

    def __init__(self, observation, robot):
        self._of = observation
        self._robot = robot
        self._parts = (0, 1, 2) if robot['drive'] == 'holonomic' else (0, 2)  # of the twist
        if observation.kind == 'grid':
            self._lay_out_grid()

    @property
    def space(self):
        """The space of one robot's observations."""
        of, far = self._of, numpy.inf
        shapes = {'scan': (self._robot['rays'],), 'people': (of.max_people, PERSON), 'grid': (1, of.cells, of.cells)}
        bounds = {'scan': (0.0, self._robot['max_range']), 'people': (-far, far), 'grid': (0, 255)}
        dtype = numpy.uint8 if of.kind == 'grid' else numpy.float32
        return Dict({
            'goal': Box(-far, far, (2,), numpy.float32),
            'velocity': Box(-far, far, (len(self._parts),), numpy.float32),
            of.kind: Box(*bounds[of.kind], shapes[of.kind], dtype),
        })

    def observe(self, arrays):
        """Returns a dict of new arrays with a row for each robot. arrays: what the simulator knows"""
        return {
            'goal': arrays['goal'].astype(numpy.float32),
            'velocity': arrays['twist'][:, self._parts].astype(numpy.float32),
            self._of.kind: getattr(self, f'_{self._of.kind}')(arrays),
        }

    def _scan(self, arrays):
        far = numpy.float32(self._robot['max_range'])
        return numpy.nan_to_num(arrays['scan'], nan=far, posinf=far, neginf=0.0)

    @staticmethod
    def _people(arrays):
        return arrays['people'].astype(numpy.float32)

    def _lay_out_grid(self):
        """Finds the ray that passes each cell."""
        of, robot = self._of, self._robot
        places = (numpy.arange(of.cells) - 0.5 * (of.cells - 1)) * of.resolution
        ahead, left = numpy.meshgrid(places, places, indexing='ij')
        turn = numpy.arctan2(left, ahead) - robot['first_angle']
        rays = numpy.rint(numpy.mod(turn, 2.0 * numpy.pi) / robot['angle_increment']).astype(int)
        if robot['rays'] * robot['angle_increment'] > 2.0 * numpy.pi - 0.5 * robot['angle_increment']:
            rays %= robot['rays']
        self._passed = rays < robot['rays']
        self._rays = numpy.where(self._passed, rays, 0).ravel()
        self._distances = numpy.hypot(ahead, left).ravel()
        self._seen = self._passed.ravel() & (self._distances <= robot['max_range'])

    def _grid(self, arrays):
        of = self._of
        ranges = numpy.where(arrays['scan'] == -numpy.inf, numpy.float32(0.0), arrays['scan']).take(self._rays, axis=1)
        half = of.resolution * numpy.sqrt(0.5)  # of the diagonal of a cell
        grid = numpy.full(ranges.shape, UNKNOWN, numpy.uint8)
        with numpy.errstate(invalid='ignore'):
            numpy.copyto(grid, FREE, where=self._seen & (self._distances < ranges - half))
            numpy.copyto(grid, OCCUPIED, where=self._seen & (numpy.abs(ranges - self._distances) <= half))
        return grid.reshape(-1, 1, of.cells, of.cells)
