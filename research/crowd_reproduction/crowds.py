"""The scenarios of section 4.3: their runs, groups in them (4.22, 4.23), and surrounded agents (4.25)."""
import numpy

from . import measures
from .results import Runs, obstacle_places

SCENARIOS = {
    'dummies': 'a field of static dummies', 'circle6': 'six agents on a circle, each walks to the opposite point',
    'circle6_obstacle': 'six agents on a circle around an obstacle',
    'line6': 'six agents side by side, all paths cross',
    'line6_mover': 'six agents side by side, all paths cross, with a moving obstacle',
    'same_goal6': 'six agents with one goal', 'same_goal6_mover': 'six agents with one goal, with a moving obstacle',
    'circle12': 'twelve agents on a circle', 'circle12_varied': 'twelve agents on a circle, at varied speeds'}
WATCHED = ('circle12', 'circle12_varied')  # every decision is recorded
EXACT = ('circle12_exact', 'circle12_exact_simultaneous')
FREE, CROSSED = 'same_goal6_far', 'same_goal6_mover_far'
APART = 'line6'  # agents with the same starts as in these, but different goals
RECORDS = {'dummies_wide': 'wide.csv', **dict.fromkeys(EXACT, 'exact.csv')}  # of the others: demo.csv
OBSTACLE_RADIUS, VISION = 0.4, 1.0  # [m]
REACH = OBSTACLE_RADIUS + VISION  # [m] within this distance an agent perceives the rim
TIMES = ('before the passage', 'during the passage', 'after the passage', 'at the first arrival')
LEAST_SECTORS = 7  # of 8 occupied: "in almost every single angle interval"
SOON = 10  # [ticks], in which an agent walks 0.3 m, which is more than its radius
VISIT_CLASSES = {0: 'never', 1: '1-9 times', 10: '10-99 times', 100: '100 times or more'}
CROWDED = 3  # sectors


def agents(setting, parameters='thesis', states='occupancy'):
    """Returns the runs of agents that learned alone. Figures 4.17-4.25 show those with state set 2."""
    return Runs.of(setting, 'agents', states=states, parameters=parameters)


def record_file(scenario):
    return RECORDS.get(scenario, 'demo.csv')


def rates(runs, scenario):
    return runs.rates(record_file(scenario), scenario)


def groups_of(runs, seed, scenario):
    """Returns the recorded places of each instance before the first arrival."""
    return [measures.while_all_are_there(places) for places in runs.tracks(seed, f'{scenario}.csv').values()]


def spans_of(places, obstacle):
    """Returns the ticks before and during the passage, the tick after it, and the last tick. None if there is no
    passage, if it begins at the first tick, or if it has not ended at the first arrival."""
    times = measures.passing(places, obstacle, REACH)
    if times is None or times[0] == 0 or times[1] + 1 >= len(places):
        return None
    return (slice(0, times[0]), slice(times[0], times[1] + 1), slice(times[1], times[1] + 1),
            slice(len(places) - 1, len(places)))


def companions(places):
    """Returns the distance to the nearest companion at each tick, mean of all agents [m]."""
    return measures.nearest_distances(places).mean(axis=1)


GROUPING = {'nearest companion': companions, 'centre of the group': measures.centre_distances}


def phases(runs, measure):
    """Returns an array (seed, 4, 2): for each seed and each of TIMES the mean with the obstacle, and the mean without
    it at the same ticks [m]. The last of TIMES without the obstacle is the first arrival there."""
    obstacle = obstacle_places(runs.setting, 'same_goal6_mover', 2001)
    seeds = []
    for seed in runs.seeds():
        values = [[] for _ in TIMES]
        for places, free in zip(groups_of(runs, seed, CROSSED), groups_of(runs, seed, FREE)):
            for time, span in enumerate(spans_of(places, obstacle) or ()):
                same = measure(free)[span if time < len(TIMES) - 1 else slice(-1, None)]
                values[time].append((measure(places)[span].mean(), same.mean() if len(same) else numpy.nan))
        seeds.append([numpy.nanmean(pairs, axis=0) if pairs else (numpy.nan, numpy.nan) for pairs in values])
    return numpy.array(seeds)


def last_metre(runs, scenario):
    """Returns distances to the nearest companion at the start and at the first arrival [m], a pair for each seed."""
    return numpy.array([numpy.mean([companions(places)[[0, -1]] for places in groups_of(runs, seed, scenario)], axis=0)
                        for seed in runs.seeds()])


def surrounded(runs, scenario, instances=numpy.inf):
    """Returns a Surrounded for each seed, from the first recorded instances."""
    found = []
    record = runs.record('demo.csv', scenario)
    arrivals = record[record['arrived'] > 0]
    for seed in runs.seeds():
        decisions, there = runs.decisions(seed, scenario), arrivals[arrivals['seed'] == seed]
        found.append(measures.surrounded(decisions[decisions['instance'] < instances],
                                         set(zip(there['episode'], there['agent'])), LEAST_SECTORS, SOON))
    return found


def by_visits(runs, scenario, least_sectors):
    return [measures.by_visits(runs.decisions(seed, scenario), runs.visits(seed), list(VISIT_CLASSES), SOON,
                               least_sectors) for seed in runs.seeds()]
