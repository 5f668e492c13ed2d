"""Measures of episodes with one agent and at most one obstacle (4.1): functions of the rows of a record."""
import functools

import numpy
from crowd_experiments.records import (median, path_per_gain, percent,  # noqa: F401: also a measure of claims.yaml
                                       ratios_per_gain)

from .declared import THESIS
from .results import RATES, Runs, per_seed

MODES = ('training', 'demo')
LEG = 20  # [decisions] length of the legs of a path, whose directions are compared
SPEED = 0.03  # [m per decision]
GOAL_SECTORS = 8  # of state set 1; its first rows are those without an obstacle (3.2)
# Rates that the thesis reports [%].
THESIS_SUCCESS = {('distance_gained', 'training'): 92.25, ('cosine_cubed', 'training'): 99.60,
                  ('distance_gained', 'demo'): 73.80, ('cosine_cubed', 'demo'): 79.10}
success, collision, contact = (
    functools.partial(lambda column, rows: percent(rows[column]), column) for column in RATES.values())


def learned(setting, reward, parameters=THESIS):
    return Runs.of(setting, 'learned', reward=reward, parameters=parameters)


def of_mode(runs, mode, measure):
    """Returns a measure for each seed; mode: training, demo, free or patient."""
    return per_seed(runs.record(f'{mode}.csv'), measure)


def gain_per_step(rows):
    """Returns the distance gained per step [m], median over all episodes."""
    return median(rows['gain_per_tick'])


def shortfall(rows):
    """Returns the difference between the agent's velocity and the distance gained per step [m], median of all."""
    return median(numpy.abs(SPEED - rows['gain_per_tick']))


def ratio_peak(rows):
    """Returns the path per distance gained that one of a hundred episodes exceeds."""
    return float(numpy.percentile(ratios_per_gain(rows), 99, method='nearest'))


def breadth(values, percentiles):
    """Returns the difference of two percentiles; small values mean a compact distribution."""
    low, high = numpy.percentile(values, percentiles, method='nearest')
    return float(high - low) if numpy.isfinite(high) else float('inf')


def gain_breadth(percentiles):
    """Returns a measure of the scatter of the distance gained per step [m]."""
    return lambda rows: breadth(rows['gain_per_tick'], percentiles)


def ratio_breadth(percentiles):
    """Returns a measure of the scatter of the path per distance gained."""
    return lambda rows: breadth(ratios_per_gain(rows), percentiles)


def path_ratio(rows):
    """Returns the path ratio, median over arrivals only; nan without arrivals."""
    return median(rows['path_ratio'][rows['arrived'] > 0])


def turning(rows):
    """Returns the turning [rad/m], median over arrivals only; nan without arrivals."""
    return median(rows['turn_per_metre'][rows['arrived'] > 0])


def free_share(runs):
    """Returns the share of the decisions in training that were made without a perceived obstacle [%], per seed."""
    return [100.0 * visits[:GOAL_SECTORS].sum() / visits.sum() for visits in map(runs.visits, runs.seeds())]


def bends(places):
    """Returns sum and greatest of a path's bends from leg to leg [degrees]. Places: (ticks, 2), nan after the end."""
    legs = numpy.diff(places[numpy.isfinite(places[:, 0])][::LEG], axis=0)
    turns = numpy.degrees(numpy.abs(numpy.diff(numpy.unwrap(numpy.arctan2(legs[:, 1], legs[:, 0])))))
    return float(turns.sum()), float(turns.max(initial=0.0))


def free_bends(runs):
    """Returns an array (seeds, 2): medians of both values of bends() over the drawn episodes without an obstacle."""
    return numpy.array([numpy.median([bends(track[:, 0]) for track in runs.tracks(seed, 'single_free.csv').values()],
                                     axis=0) for seed in runs.seeds()])
