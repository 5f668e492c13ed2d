"""Scenarios of corridors filled at a density."""
import dataclasses
import pathlib

import numpy
import yaml

RADIUS = 0.18  # [m]
GAP = 0.02  # between bodies, and to walls, at the start [m]
BEYOND = 300.0  # distance of the goals: no agent arrives [m]
DIRECTIONS = {  # 1 or -1, by y and a random generator
    'one_way': lambda _y, _random: 1.0,
    'in_lanes': lambda y, _random: 1.0 if y < 0.0 else -1.0,  # each on its right side
    'mixed': lambda _y, random: 1.0 if random.random() < 0.5 else -1.0}


@dataclasses.dataclass(frozen=True)
class Corridor:
    """A long straight corridor of corridors.yaml."""
    name: str
    title: str
    data: str  # file of the measurements
    width: float  # [m]
    length: float  # of the filled part [m]
    speeds: tuple  # [m/s]
    direction: str
    densities: tuple  # at the start
    bins: tuple
    window: float = 4.0  # length of the measurement area [m]
    begin: float = 8.0  # measured from this time [s]
    end: float = 20.0

    @property
    def is_single(self):
        """Whether people walk in single file, so that densities are per metre."""
        return self.name == 'single_file'

    @property
    def columns(self):
        return 'density_per_m' if self.is_single else 'density_per_m2', 'speed_m_per_s'

    @property
    def edges(self):
        return numpy.arange(0.0, *self.bins)

    def per_length(self, density):
        """Returns the number of people per metre of the corridor."""
        return density * (1.0 if self.is_single else self.width)


CORRIDORS = tuple(Corridor(**entry) for entry in
                  yaml.safe_load(pathlib.Path(__file__).with_suffix('.yaml').read_text(encoding='utf-8')))
ONE_WAY, TWO_WAY, TWO_WAY_MIXED, SINGLE_FILE = CORRIDORS


def places(corridor, density, random):
    """Returns an array of places (x, y): staggered rows along the corridor, displaced at random without overlap."""
    free = corridor.width - 2.0 * (RADIUS + GAP)
    most = 1 if corridor.is_single else 1 + int(free / (2.0 * RADIUS + GAP))
    rows = int(numpy.clip(round(corridor.width * numpy.sqrt(density)), 1, most))
    spacing = rows / corridor.per_length(density)
    points = []
    for row in range(rows):
        y = 0.0 if rows == 1 else free * (row / (rows - 1) - 0.5)
        offset = spacing * (0.25 + 0.5 * (row % 2))
        points += [(x, y) for x in numpy.arange(offset, corridor.length, spacing)]
    return displaced(numpy.array(points), 0.45 * spacing, 0.0 if corridor.is_single else free / 2.0, random)


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
    random = numpy.random.default_rng([seed, round(1000 * density)])
    half = corridor.width / 2.0
    ends = f'{-2 * BEYOND:g}', f'{2 * BEYOND:g}'
    lines = [f'name: {corridor.name}', f'duration: {corridor.end:g}', 'goal_tolerance: 0.3', 'way_finding: false',
             'walls:'] + [f'  - [[{ends[0]}, {y:g}], [{ends[1]}, {y:g}]]' for y in (-half, half)] + ['agents:']
    for x, y in places(corridor, density, random):
        ahead = DIRECTIONS[corridor.direction](y, random)
        lines.append(f'  - {{position: [{x:.3f}, {y:.3f}], goal: [{x + ahead * BEYOND:.3f}, {y:.3f}], '
                     f'speed: {random.uniform(*corridor.speeds):.3f}, radius: {RADIUS}}}')
    return '\n'.join(lines) + '\n'
