"""Sweeps over widths, densities and radii: figures of a crowd should change steadily with them."""
import itertools
import math
import random

import numpy
from crowd_experiments.records import Spread
from crowd_experiments.style import new_figure, save

from . import plan
from .evaluation import Result
from .measures import all_arrived, crossing_times, problems

WIDTHS = (0.8, 0.9, 1.0, 1.2, 1.4, 1.6, 1.8, 2.0, 2.2, 2.4)  # of doors [m]
CORRIDORS = (1.2, 1.5, 1.8, 2.2, 2.6, 3.0, 3.5, 4.0, 5.0, 6.0)  # widths [m]
DENSITIES = (0.1, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0)  # [1/m2]
RADII = (0.18, 0.2, 0.225, 0.25, 0.275, 0.3, 0.35, 0.4)  # [m]
LENGTH = 20.0  # of corridors [m]
LONGEST = 240  # [s]
SLOWER = 0.1  # share of the flow by which a wider door may be slower, as seeds differ
SPEEDS = (1.0, 1.5)  # free speeds [m/s]
WAYS = (('one way', 1), ('two ways', 2))


def people(seed, count, low, high, goal, radius):
    """Returns people at random places in a box. goal: a function of the place"""
    draw = random.Random(seed)
    return [plan.agent(place, goal(place), draw.uniform(*SPEEDS), radius)
            for place in plan.places(count, low, high, radius, draw)]


def door(seed, width, radius, ways):
    """Returns a door at the origin, 40 people in front of it: all on the left, or half of them on each side."""
    walls = plan.wall((0.0, -6.0), (0.0, 6.0), [(6.0 - width / 2.0, 6.0 + width / 2.0)])
    walls += [*plan.polyline((-12.0, -6.0), (12.0, -6.0)), *plan.polyline((-12.0, 6.0), (12.0, 6.0))]
    left = people(seed, 40 // ways, (-7.0, -3.0), (-1.0, 3.0), lambda place: (9.0, place[1]), radius)
    right = people(seed + 1000, 20, (1.0, -3.0), (7.0, 3.0), lambda place: (-9.0, place[1]), radius)
    return plan.scenario('door', LONGEST, left + (right if ways == 2 else []), walls)


def corridor(seed, width, density, radius, ways=2):
    """Returns a corridor with people at random places, who walk to its ends and beyond; with two ways half to each."""
    walls = [*plan.polyline((-5.0, 0.0), (LENGTH + 5.0, 0.0)), *plan.polyline((-5.0, width), (LENGTH + 5.0, width))]
    sides = itertools.cycle([LENGTH + 4.0, -4.0][:ways])
    count = max(2, round(density * LENGTH * width))
    return plan.scenario('corridor', LONGEST, people(seed, count, (0.0, 0.05), (LENGTH, width - 0.05),
                                                     lambda place: (next(sides), place[1]), radius), walls)


def flow(recording):
    """Returns people per second through the door, from the first to the last one; 0 if somebody stays."""
    times = crossing_times(recording, ((0.0, -3.0), (0.0, 3.0)))
    return (len(times) - 1) / (times.max() - times.min()) if numpy.isfinite(times).all() else 0.0


def share(recording):
    """Returns the mean share of their free speed at which people came to their goals; 0 for those who did not."""
    ways = [math.dist(track[0], track[numpy.flatnonzero(~numpy.isnan(track[:, 0]))[-1]])
            for track in recording.tracks.transpose(1, 0, 2)]
    return float(numpy.mean(ways / (recording.arrivals * recording.speeds)))


def walk(evaluation, series, values):
    """Returns Recordings of each seed, by the label of the series and the value. series: plans of seed and value"""
    keys = {f's{number}_{value:g}'.replace('.', '_'): (label, value)
            for (number, label), value in itertools.product(enumerate(series), values)}
    plans = {name: lambda seed, label=label, value=value: series[label](seed, value)
             for name, (label, value) in keys.items()}
    return {keys[name]: recordings for name, recordings in evaluation.walk(plans).items()}


def draw(spreads, file, labels, values, title):
    """Draws means and ranges over the seeds. spreads: by label and value. Returns the file."""
    figure, ((axes,),) = new_figure(1, 1, 8.0, 4.0)
    for label in labels:
        line = [spreads[label, value] for value in values]
        means, lows, highs = numpy.transpose([(spread.mean, spread.low, spread.high) for spread in line])
        axes.errorbar(values, means, [means - lows, highs - means], label=label, marker='o', capsize=3)
    axes.set(xlabel=title[0], ylabel=title[1], ylim=(0.0, None))
    axes.legend()
    return save(figure, file)


def remarks_of(found):
    """Returns what went wrong, by series and value."""
    texts = {key: problems(recordings, {'the middle': (0.0, 0.0)}) for key, recordings in found.items()}
    return '. '.join(f'{label}, {value:g}: {text}' for (label, value), text in texts.items() if text)


def sweep_doors(evaluation):
    series = {f'{text}, r {radius} m': lambda seed, width, radius=radius, ways=ways: door(seed, width, radius, ways)
              for (text, ways), radius in itertools.product(WAYS, (0.2, 0.25))}
    found = walk(evaluation, series, WIDTHS)
    flows = {key: Spread.of_numbers(map(flow, recordings)) for key, recordings in found.items()}
    slower = [f'{label}: {flows[label, wide].mean:.2f} at {wide:g} m, {flows[label, narrow].mean:.2f} at {narrow:g} m'
              for label in series for narrow, wide in zip(WIDTHS, WIDTHS[1:])
              if flows[label, wide].mean < (1.0 - SLOWER) * flows[label, narrow].mean]
    ends = '; '.join(f'{label}: {flows[label, WIDTHS[0]].mean:.2f} to {flows[label, WIDTHS[-1]].mean:.2f} 1/s'
                     for label in series)
    return Result(f'{ends}; slower: {", ".join(slower) or "none"}',
                  f'no wider door is slower by more than {SLOWER:.0%}; all arrive',
                  not slower and all(map(all_arrived, found.values())), remarks_of(found),
                  (draw(flows, evaluation.folder / 'sweep_doors.png', series, WIDTHS, ('width [m]', 'flow [1/s]')),))


def steady(evaluation, name, series, values, axis):
    """Returns the Result of a sweep in which all are to arrive, with the largest step from one value to the next."""
    found = walk(evaluation, series, values)
    shares = {key: Spread.of_numbers(map(share, recordings)) for key, recordings in found.items()}

    def step(label):
        changes = {(low, high): abs(shares[label, high].mean - shares[label, low].mean)
                   for low, high in zip(values, values[1:])}
        low, high = max(changes, key=changes.get)
        return (f'{label}: {shares[label, values[0]].mean:.2f} to {shares[label, values[-1]].mean:.2f}, largest step '
                f'{changes[low, high]:.2f} ({low:g} to {high:g})')
    return Result('; '.join(map(step, series)), 'all arrive', all(map(all_arrived, found.values())), remarks_of(found),
                  (draw(shares, evaluation.folder / f'{name}.png', series, values, (axis, 'share of the free speed')),))


def sweep_corridors(evaluation):
    series = {f'{text}, {density:g} per m2': lambda seed, width, density=density, ways=ways: corridor(
        seed, width, density, 0.2, ways) for (text, ways), density in itertools.product(WAYS, (0.5, 1.0))}
    return steady(evaluation, 'sweep_corridors', series, CORRIDORS, 'width of the corridor [m]')


def sweep_densities(evaluation):
    series = {text: lambda seed, density, ways=ways: corridor(seed, 4.0, density, 0.2, ways) for text, ways in WAYS}
    return steady(evaluation, 'sweep_densities', series, DENSITIES, 'density [1/m2]')


def sweep_radii(evaluation):
    series = {'corridor of 3 m, two ways, 0.5 per m2': lambda seed, radius: corridor(seed, 3.0, 0.5, radius),
              'door of 1.2 m, two ways': lambda seed, radius: door(seed, 1.2, radius, 2)}
    return steady(evaluation, 'sweep_radii', series, RADII, 'radius [m]')
