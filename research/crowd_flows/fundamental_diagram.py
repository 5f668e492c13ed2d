"""Speed against density in corridors, beside measurements of people.

Density and speed are measured in an area 4 m long and as wide as the corridor, in the middle of a part that is filled
uniformly at the start, over intervals of 1 s. Density is the mean number of centres inside, divided by the area (single
file: by the length). Speed is the mean over the persons and ticks of the velocity along the corridor, in the direction
of walking. Only intervals from 8 to 20 s are used: later, the ends of the filled part reach the area.
"""
import numpy
from crowd_experiments import style

from .corridors import CORRIDORS, document
from .measurements import COLOURS, LEAST_IN_BIN, TICK, bands, read_columns, walk, weidmann

INTERVAL = round(1.0 / TICK)  # [ticks]
FIGURE = 'validation_fundamental_diagram.png'
HEADER = ['corridor', 'density', 'speed', 'intervals', 'measured_low', 'measured_median', 'measured_high', 'inside']


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
