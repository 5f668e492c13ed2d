"""Runs of the program evaluate."""
import csv
import subprocess

import numpy

TICK = 0.1  # [s]


def evaluate(program, table, scenario, folder, *options):
    """Evaluates a Q-table in a scenario file, and writes trajectories and metrics into a folder.

    Returns the row of metrics (texts by name)."""
    metrics = folder / f'{scenario.stem}_metrics.csv'
    subprocess.run([str(program), '--q-table', str(table), '--trajectories', str(folder), '--csv', str(metrics),
                    *map(str, options), str(scenario)], check=True, stdout=subprocess.DEVNULL)
    with open(metrics, newline='', encoding='utf-8') as stream:
        return next(csv.DictReader(stream))


def read_tracks(file):
    """Returns an array (tick, agent, 2) of the positions of each instance of a recording; nan after the arrival."""
    data = numpy.loadtxt(file, delimiter=',', skiprows=1, usecols=(0, 1, 2, 3, 4), ndmin=2)
    tracks = []
    for instance in numpy.unique(data[:, 0]):
        rows = data[data[:, 0] == instance]
        ticks, agents = rows[:, 1].astype(int), rows[:, 2].astype(int)
        track = numpy.full((ticks.max() + 1, agents.max() + 1, 2), numpy.nan)
        track[ticks, agents] = rows[:, 3:5]
        tracks.append(track)
    return tracks
