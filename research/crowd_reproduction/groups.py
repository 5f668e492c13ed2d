"""Grouping (figures 4.22, 4.23): distances between the agents, with and without a moving obstacle."""
import numpy

from crowd_experiments import style
from crowd_experiments.records import Spread

from . import names, scenario_runs as runs
from .measures import centre_distances, nearest_distances, passing, while_all_are_there

FREE, CROSSED = runs.FAR
APART = 'line6'  # for comparison: agents with the same starts, but different goals
OBSTACLE_RADIUS, VISION = 0.4, 1.0  # [m]
REACH = OBSTACLE_RADIUS + VISION  # [m] within this distance an agent perceives the rim
TIMES = ('before the passage', 'during the passage', 'after the passage', 'at the first arrival')
DESCRIPTION = (
    "The passage of the moving obstacle begins when the first agent perceives it (its rim within 1 m of an agent's "
    'centre) and ends when an agent perceives it for the last time. The goal is at 11 m instead of 5 m, so that the '
    'agents have time to group again.')


def groups_of(setting, table, seed, scenario):
    """Returns the recorded places of each instance before the first arrival."""
    return [while_all_are_there(places) for places in runs.tracks_of(setting, table, seed, scenario).values()]


def spans_of(places, obstacle):
    """Returns the ticks before and during the passage, the tick after it, and the last tick. None if there is no
    passage, if it begins at the first tick, or if it has not ended at the first arrival."""
    times = passing(places, obstacle, REACH)
    if times is None or times[0] == 0 or times[1] + 1 >= len(places):
        return None
    return (slice(0, times[0]), slice(times[0], times[1] + 1), slice(times[1], times[1] + 1),
            slice(len(places) - 1, len(places)))


def companions(places):
    """Returns the distance to the nearest companion at each tick, mean of all agents [m]."""
    return nearest_distances(places).mean(axis=1)


def measured(setting, table, measure):
    """Returns an array (seed, 4, 2): for each seed and each of TIMES the mean with the obstacle, and the mean without
    it at the same ticks [m]. The last of TIMES without the obstacle is the first arrival there."""
    obstacle = runs.obstacle_places(setting, 'same_goal6_mover', 2001)
    seeds = []
    for seed in setting.seeds(runs.SEEDS):
        values = [[] for _ in TIMES]
        for places, free in zip(groups_of(setting, table, seed, CROSSED), groups_of(setting, table, seed, FREE)):
            for time, span in enumerate(spans_of(places, obstacle) or ()):
                same = measure(free)[span if time < len(TIMES) - 1 else slice(-1, None)]
                values[time].append((measure(places)[span].mean(), same.mean() if len(same) else numpy.nan))
        seeds.append([numpy.nanmean(pairs, axis=0) if pairs else (numpy.nan, numpy.nan) for pairs in values])
    return numpy.array(seeds)


def last_metre(setting, table, scenario):
    """Returns the distance to the nearest companion at the start and at the first arrival [m], a pair per seed."""
    return [numpy.mean([companions(places)[[0, -1]] for places in groups_of(setting, table, seed, scenario)], axis=0)
            for seed in setting.seeds(runs.SEEDS)]


def add_table(chapter, setting):
    rows = []
    for parameters in runs.PARAMETERS:
        table = ('agent', 'occupancy', parameters)
        for title, measure in (('nearest companion', companions), ('centre of the group', centre_distances)):
            values = measured(setting, table, measure)
            for i, scenario in enumerate(('with the moving obstacle', 'without it, at the same ticks')):
                rows.append([f'{names.PARAMETER_NAMES[parameters]}, distance to the {title}, {scenario}',
                             *(Spread.of_numbers(values[:, time, i]).text(2) for time in range(len(TIMES)))])
    chapter.add_table(f"Grouping of six agents with one goal [m]; state set 2, one agent's table. {DESCRIPTION} Mean "
                      'over agents, ticks and instances; mean ± standard deviation over the seeds (lowest-highest)',
                      ['', *TIMES], rows, name='groups')
    rows = []
    for parameters in runs.PARAMETERS:
        for scenario in ('same_goal6', 'same_goal6_mover', APART):
            start, end = zip(*last_metre(setting, ('agent', 'occupancy', parameters), scenario))
            rows.append([f'{names.PARAMETER_NAMES[parameters]}, {scenario}', Spread(start).text(2),
                         Spread(end).text(2)])
    chapter.add_table("Distance to the nearest companion [m]; state set 2, one agent's table; mean ± standard "
                      'deviation over the seeds (lowest-highest)',
                      ['', 'at the start', 'at the first arrival'], rows, name='groups_end')


def mean_curve(setting, table, scenario):
    """Returns the distance to the nearest companion at each tick [m], mean over instances and seeds, until the first
    agent has arrived in half of them."""
    curves = [companions(places) for seed in setting.seeds(runs.SEEDS)
              for places in groups_of(setting, table, seed, scenario)]
    length = int(numpy.median([len(curve) for curve in curves]))
    grid = numpy.full((len(curves), length), numpy.nan)
    for line, curve in zip(grid, curves):
        line[:len(curve)] = curve[:length]
    return numpy.nanmean(grid, axis=0)


def typical_passing(setting, table):
    """Returns the median begin and end of the passage over the instances [ticks]."""
    obstacle = runs.obstacle_places(setting, 'same_goal6_mover', 2001)
    spans = [spans_of(places, obstacle) for seed in setting.seeds(runs.SEEDS)
             for places in groups_of(setting, table, seed, CROSSED)]
    spans = [span for span in spans if span]
    return [numpy.median([span[time].start for span in spans]) for time in (1, 2)] if spans else None


def add_figure(chapter, setting):
    figure, axes = style.new_figure(1, len(runs.PARAMETERS), 11, 4, sharey=True)
    for panel, parameters in zip(axes[0], runs.PARAMETERS):
        table = ('agent', 'occupancy', parameters)
        for scenario, colour, label in ((FREE, '#0072b2', 'six to one goal'),
                                        (CROSSED, '#d55e00', 'the same with a moving obstacle'),
                                        (APART, '0.55', 'for comparison: goals apart (line6)')):
            curve = mean_curve(setting, table, scenario)
            panel.plot(0.1 * numpy.arange(len(curve)), curve, color=colour, label=label)
        times = typical_passing(setting, table)
        if times:
            panel.axvspan(0.1 * times[0], 0.1 * times[1], color='#d55e00', alpha=0.12, linewidth=0)
        panel.set_title(names.PARAMETER_NAMES[parameters])
        panel.set_xlabel('time [s]')
    axes[0][0].set_ylabel('distance to the nearest companion [m]')
    axes[0][0].set_ylim(0, None)
    axes[0][0].legend(loc='lower left')
    chapter.add_figure(style.save(figure, setting.figure_file('figure_4_22_4_23_groups')),
                       'Grouping (figures 4.22 and 4.23): distance to the nearest companion, centre to centre, mean '
                       f'over the agents, {setting.count(runs.WALKED, 2)} instances and '
                       f'{len(setting.seeds(runs.SEEDS))} seeds, until the first agent has arrived in half of them. '
                       "Shaded: the passage of the obstacle (medians). State set 2, one agent's table.")
