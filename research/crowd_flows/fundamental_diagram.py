"""Speed against density in corridors, beside measurements of people.

Density and speed are measured in an area 4 m long and as wide as the corridor, in the middle of a part that is filled
uniformly at the start, over intervals of 1 s. Density is the mean number of centres inside, divided by the area (single
file: by the length). Speed is the mean over the persons and ticks of the velocity along the corridor, in the direction
of walking. Only intervals from 8 to 20 s are used: later, the ends of the filled part reach the area.
"""
import dataclasses
import pathlib

import numpy
import yaml
from crowd_experiments import style

from .measurements import COLOURS, LEAST_IN_BIN, TICK, bands, read_columns, walk, weidmann

RADIUS = 0.18  # [m]
GAP = 0.02  # between bodies, and to walls, at the start [m]
BEYOND = 300.0  # distance of the goals: no agent arrives [m]
DIRECTIONS = {  # 1 or -1, by y and a random generator
    'one_way': lambda _y, _random: 1.0,
    'in_lanes': lambda y, _random: 1.0 if y < 0.0 else -1.0,  # each on its right side
    'mixed': lambda _y, random: 1.0 if random.random() < 0.5 else -1.0}
INTERVAL = round(1.0 / TICK)  # [ticks]
FIGURE = 'validation_fundamental_diagram.png'
HEADER = ['corridor', 'density', 'speed', 'intervals', 'measured_low', 'measured_median', 'measured_high', 'inside']


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
                  yaml.safe_load(pathlib.Path(__file__).with_name('corridors.yaml').read_text(encoding='utf-8')))
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


def measure(corridor, track):
    """Returns an array of (density, speed), one row per interval."""
    along = track[..., 0]
    direction = numpy.sign(along[1:].mean(axis=0) - along[0])
    velocities = numpy.diff(along, axis=0) / TICK * direction
    inside = numpy.abs(along[1:] - corridor.length / 2.0) < corridor.window / 2.0
    values = []
    for begin in range(round(corridor.begin / TICK), len(velocities) - INTERVAL + 1, INTERVAL):
        present = inside[begin:begin + INTERVAL]
        if present.any():
            density = present.sum() / INTERVAL / corridor.window / corridor.per_length(1.0)
            values.append((density, velocities[begin:begin + INTERVAL][present].mean()))
    return numpy.array(values)


def measure_corridor(program, table, folder, corridor, seeds):
    """Returns an array of (density, speed) of all densities and seeds, and the highest contact rate [%]."""
    values, contact = [], 0.0
    for density in corridor.densities:
        metrics, tracks = walk(program, table, folder / f'{corridor.name}_{density:g}.yaml', '---\n'.join(
            document(corridor, density, seed) for seed in range(1, seeds + 1)))
        contact = max(contact, float(metrics['contact_pct']))
        values += [measure(corridor, track) for track in tracks]
    return numpy.concatenate(values), contact


def rows_of(corridor, values, measured):
    """Returns rows of HEADER, one for each bin of densities with enough intervals."""
    rows = []
    bins = numpy.digitize(values[:, 0], corridor.edges) - 1
    for i, band in enumerate(bands(measured, corridor.edges)):
        speeds = values[bins == i, 1]
        if len(speeds) < LEAST_IN_BIN:
            continue
        band_cells = ['', '', '', ''] if band is None else [
            round(band.low, 2), round(band.median, 2), round(band.high, 2),
            'yes' if band.contains(speeds.mean()) else 'no']
        rows.append([corridor.name, round(middles(corridor)[i], 3), round(float(speeds.mean()), 2), len(speeds),
                     *band_cells])
    return rows


def measure_crowd(program, table, folder, seeds, data, corridors=CORRIDORS):
    """Returns rows of HEADER, the values by the name of the corridor, and the highest contact rate [%] of a crowd."""
    folder.mkdir(parents=True, exist_ok=True)
    rows, values, contact = [], {}, 0.0
    for corridor in corridors:
        found, touched = measure_corridor(program, table, folder, corridor, seeds)
        contact = max(contact, touched)
        measured = read_columns(data / corridor.data, *corridor.columns)
        rows += rows_of(corridor, found, measured)
        values[corridor.name] = found
    return rows, values, contact


def plot(crowds, data, file, corridors=CORRIDORS):
    """Draws the speeds of several crowds (values by name) beside the measurements. Returns the file."""
    figure, axes = style.new_figure(2, 2, 11, 8)
    for panel, corridor in zip(axes.flat, corridors):
        draw_measured(panel, corridor, read_columns(data / corridor.data, *corridor.columns))
        for (name, values), colour in zip(crowds.items(), COLOURS):
            found = values[corridor.name]
            panel.plot(*found.T, '.', color=colour, markersize=2, alpha=0.3)
            bins = numpy.digitize(found[:, 0], corridor.edges) - 1
            means = [(middle, found[bins == i, 1].mean()) for i, middle in enumerate(middles(corridor))
                     if (bins == i).sum() >= LEAST_IN_BIN]
            panel.plot(*zip(*means), 'o-', color=colour, markersize=4, label=name)
        panel.set(title=corridor.title, xlim=(0.0, corridor.edges[-1]), ylim=(0.0, 1.75), ylabel='speed [m/s]',
                  xlabel='density [1/m]' if corridor.is_single else 'density [1/m²]')
    axes[0][0].legend(loc='upper right', fontsize=8)
    return style.save(figure, file)


def draw_measured(panel, corridor, measured):
    panel.plot(*measured.T, '.', color='0.8', markersize=2, label='people')
    known = [(middle, band) for middle, band in zip(middles(corridor), bands(measured, corridor.edges)) if band]
    panel.fill_between([middle for middle, _ in known], [band.low for _, band in known],
                       [band.high for _, band in known], color='0.5', alpha=0.35, linewidth=0,
                       label='people, 10-90 %')
    if not corridor.is_single:
        densities = numpy.linspace(0.1, 5.4, 200)
        panel.plot(densities, weidmann(densities), '--', color=style.REFERENCE, linewidth=1, label='Weidmann')


def middles(corridor):
    return (corridor.edges[:-1] + corridor.edges[1:]) / 2.0
