"""Scenarios of corridors filled at a density."""
import dataclasses

import numpy

RADIUS = 0.18  # [m]
GAP = 0.02  # between bodies, and to walls, at the start [m]
BEYOND = 300.0  # distance of the goals: no agent arrives [m]


@dataclasses.dataclass(frozen=True)
class Corridor:
    """A long straight corridor, uniformly filled at the start. Speed and density are measured in its middle."""
    name: str
    title: str
    data: str  # file of the measurements
    density_column: str
    width: float  # [m]
    length: float  # of the filled part [m]
    window: float  # length of the measurement area, in the middle [m]
    speeds: tuple  # range of free speeds [m/s]; its mean is the speed measured at low densities
    direction: object  # function of y and a random generator: 1 or -1
    densities: tuple  # at the start, [1/m2], single file [1/m]
    edges: numpy.ndarray  # of the bins of densities
    begin: float  # measured from this time [s]
    end: float

    def per_length(self, density):
        """Number of people per metre of the corridor."""
        return density * (1.0 if self.density_column == 'density_per_m' else self.width)


def one_way(_y, _random):
    """All people walk in one direction."""
    return 1.0


def in_lanes(y, _random):
    """Each direction on its right side of the corridor."""
    return 1.0 if y < 0.0 else -1.0


def mixed(_y, random):
    """Both directions, independent of the place."""
    return 1.0 if random.random() < 0.5 else -1.0


ONE_WAY = Corridor(
    name='one_way_corridor', title='one way, 1.8 m wide', data='one_way_corridor.csv',
    density_column='density_per_m2', width=1.8, length=70.0, window=4.0, speeds=(0.95, 1.25), direction=one_way,
    densities=(0.3, 0.6, 0.9, 1.2, 1.5, 1.8, 2.1, 2.4, 2.7, 3.0, 3.5, 4.0, 4.5, 5.0),
    edges=numpy.arange(0.0, 5.3, 0.25), begin=8.0, end=20.0)
TWO_WAY = Corridor(
    name='two_way_corridor', title='two ways, 3.6 m wide, in lanes at the start', data='two_way_corridor.csv',
    density_column='density_per_m2', width=3.6, length=80.0, window=4.0, speeds=(1.25, 1.75), direction=in_lanes,
    densities=(0.4, 0.7, 1.0, 1.3, 1.6, 1.9, 2.2, 2.5, 2.8, 3.2, 4.0),
    edges=numpy.arange(0.0, 5.3, 0.25), begin=8.0, end=20.0)
TWO_WAY_MIXED = dataclasses.replace(
    TWO_WAY, name='mixed_corridor', title='two ways, 3.6 m wide, mixed at the start', direction=mixed)
SINGLE_FILE = Corridor(
    name='single_file', title='single file', data='single_file.csv', density_column='density_per_m', width=0.42,
    length=70.0, window=4.0, speeds=(1.05, 1.4), direction=one_way,
    densities=(0.4, 0.6, 0.8, 1.0, 1.2, 1.4, 1.6, 1.8, 2.0, 2.2, 2.4),
    edges=numpy.arange(0.0, 3.1, 0.2), begin=8.0, end=20.0)
CORRIDORS = (ONE_WAY, TWO_WAY, TWO_WAY_MIXED, SINGLE_FILE)


def places(corridor, density, random):
    """Returns an array of places (x, y): staggered rows along the corridor, displaced at random without overlap."""
    per_length = corridor.per_length(density)
    free = corridor.width - 2.0 * (RADIUS + GAP)
    single = corridor.density_column == 'density_per_m'
    most = 1 if single else 1 + int(free / (2.0 * RADIUS + GAP))
    rows = int(numpy.clip(round(corridor.width * numpy.sqrt(density)), 1, most))
    spacing = rows / per_length
    points = []
    for row in range(rows):
        y = 0.0 if rows == 1 else free * (row / (rows - 1) - 0.5)
        offset = spacing * (0.25 + 0.5 * (row % 2))
        points += [(x, y) for x in numpy.arange(offset, corridor.length, spacing)]
    return displaced(numpy.array(points), 0.45 * spacing, 0.0 if single else free / 2.0, random)


def displaced(points, along, half_width, random):
    """Moves each point at random, by at most `along` [m] in x and 0.3 m in y, if it stays clear of the others."""
    for _ in range(3):
        for i, point in enumerate(points):
            new = point + random.uniform(-1.0, 1.0, 2) * (along, 0.3)
            new[1] = numpy.clip(new[1], -half_width, half_width)
            others = points[numpy.abs(points[:, 0] - new[0]) < 2.0]
            others = others[(others != point).any(axis=1)]
            if (numpy.hypot(*(others - new).T) > 2.0 * RADIUS + GAP).all():
                points[i] = new
    return points


def document(corridor, density, seed):
    """Returns the scenario of a corridor as a YAML document."""
    random = numpy.random.default_rng([seed, round(1000 * density)])
    half = corridor.width / 2.0
    ends = f'{-2 * BEYOND:g}', f'{2 * BEYOND:g}'
    lines = [f'name: {corridor.name}', f'duration: {corridor.end:g}', 'goal_tolerance: 0.3', 'way_finding: false',
             'walls:'] + [f'  - [[{ends[0]}, {y:g}], [{ends[1]}, {y:g}]]' for y in (-half, half)] + ['agents:']
    for x, y in places(corridor, density, random):
        ahead = corridor.direction(y, random)
        lines.append(f'  - {{position: [{x:.3f}, {y:.3f}], goal: [{x + ahead * BEYOND:.3f}, {y:.3f}], '
                     f'speed: {random.uniform(*corridor.speeds):.3f}, radius: {RADIUS}}}')
    return '\n'.join(lines) + '\n'
