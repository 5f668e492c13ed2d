"""Runs of evaluate, and measurements of people: speed against density in corridors, flow through doors."""

import typing

import numpy
import pandas
from crowd_experiments import records
from crowd_experiments.runs import output_of

TICK = 0.1  # [s]
LEAST_IN_BIN = 5  # values; bins with fewer are left out
COLOURS = ('#d55e00', '#0072b2', '#009e73', '#8e5ea2')  # of the crowds in figures


def evaluate(program, table, scenario, folder, *options):
    """Writes trajectories and metrics of a Q-table in a scenario file into a folder. Returns the row of metrics."""
    metrics = folder / f'{scenario.stem}_metrics.csv'
    output_of([program, '--q-table', table, '--trajectories', folder, '--csv', metrics, *options, scenario])
    return pandas.read_csv(metrics, dtype=str).iloc[0]


def read_tracks(file):
    """Returns the positions of each instance of a recording, arrays (tick, agent, 2); nan after the arrival."""
    return list(records.read_tracks(file).values())


def walk(program, table, scenario, text, *options):
    """Writes a scenario file, and walks it. Returns the row of metrics, and the tracks of its instances."""
    scenario.write_text(text, encoding='utf-8')
    metrics = evaluate(program, table, scenario, scenario.parent, *options)
    recording = scenario.with_suffix('.csv')
    tracks = read_tracks(recording)
    recording.unlink()  # it is large
    return metrics, tracks


class Band(typing.NamedTuple):
    """Distribution of the measured speeds in a bin of densities."""
    low: float  # 10 % of the measurements are below [m/s]
    median: float
    high: float  # 10 % are above
    count: int

    def contains(self, speed):
        """Returns whether a speed is inside, after rounding to hundredths as printed."""
        return round(self.low, 2) <= round(speed, 2) <= round(self.high, 2)


def read_columns(file, *columns):
    """Returns an array (row, column) of columns of numbers of a CSV file."""
    return pandas.read_csv(file, usecols=columns, float_precision='round_trip')[list(columns)].to_numpy(dtype=float)


def band_of(speeds):
    """Returns the Band of some speeds, None if there are too few."""
    if len(speeds) < LEAST_IN_BIN:
        return None
    return Band(*numpy.percentile(speeds, [10, 50, 90]), len(speeds))


def bands(measured, edges):
    """Returns the Band (or None) of each bin of densities. measured: array of (density, speed)."""
    bins = numpy.digitize(measured[:, 0], edges) - 1
    return [band_of(measured[bins == i, 1]) for i in range(len(edges) - 1)]


def weidmann(density):
    """Speed [m/s] at a density [1/m2] (Weidmann 1993)."""
    return 1.34 * (1.0 - numpy.exp(-1.913 * (1.0 / density - 1.0 / 5.4)))


def door_range(measured, width, tolerance=0.051):
    """Returns lowest and highest specific flow [1/s] of doors about as wide, scaled to the width; None without any."""
    near = measured[numpy.abs(measured[:, 0] - width) <= tolerance]
    if len(near) == 0:
        return None
    flows = near[:, 1] * width / near[:, 0]
    return float(flows.min()), float(flows.max())
