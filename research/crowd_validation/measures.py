"""Measures of recorded episodes, and their texts."""
import math

import numpy
from crowd_experiments.records import Spread
from scipy.spatial.distance import cdist

FAR = 1e6  # [m] beyond all walls
STANDING = 0.2  # [m] a person who moved less than this in STANDING_TIME stands
STANDING_TIME = 10.0  # [s]


def spread(values, unit='', decimals=1):
    """Returns mean and range over the seeds, such as `30.1 s (29.9-30.4)`. Infinite values are counted apart."""
    values = list(values)
    numbers = Spread.of_numbers(values)
    unit = f' {unit}' if unit else ''
    if math.isnan(numbers.mean):
        return 'never'
    text = f'{numbers.mean:.{decimals}f}{unit}'
    if f'{numbers.low:.{decimals}f}' != f'{numbers.high:.{decimals}f}':
        text += f' ({numbers.low:.{decimals}f}-{numbers.high:.{decimals}f})'
    missing = len(values) - len(numbers.values)
    return text + (f', never in {missing} of {len(values)} seeds' if missing else '')


def counts(values):
    """Returns whole numbers over the seeds, such as `20` or `18-20`."""
    low, high = min(values), max(values)
    return f'{low}' if low == high else f'{low}-{high}'


def arrived(recordings):
    """Returns the number of arrivals, such as `1000 of 1000 arrived`."""
    numbers = [sum(map(math.isfinite, recording.arrivals)) for recording in recordings]
    return f'{counts(numbers)} of {recordings[0].people()} arrived'


def all_arrived(recordings):
    return all(recording.all_arrived() for recording in recordings)


def last(recordings, decimals=0):
    """Returns when the last person arrived, such as `the last after 31.0 s (30.0-32.0)`."""
    return f"the last after {spread((max(recording.arrivals) for recording in recordings), 's', decimals)}"


def problems(recordings, landmarks):
    """Returns a text about people who did not arrive, by the nearest landmark, and about contacts; or an empty one."""
    parts = []
    for seed, recording in enumerate(recordings, 1):
        of_seed = []
        places, standing = left_over(recording)
        if len(places):
            near = nearest_of(places, list(landmarks.values()))
            at = ', '.join(f'{(near == i).sum()} at {name}' for i, name in enumerate(landmarks) if (near == i).any())
            of_seed.append(f'{len(places)} left ({at}), {standing} of them stand')
        if recording.touched.any():
            of_seed.append(f'{recording.touched.sum()} in contact')
        if of_seed:
            parts.append(f'seed {seed}: {", ".join(of_seed)}')
    return '; '.join(parts)


def side(start, end, places):
    """Returns on which side of the line from start to end the places are: positive on the left."""
    (x0, y0), (x1, y1) = start, end
    return (x1 - x0) * (places[..., 1] - y0) - (y1 - y0) * (places[..., 0] - x0)


def crossing_times(recording, gate):
    """Returns when each agent first crosses a segment, interpolated within the tick [s]; inf if it does not."""
    crossed = crossings(recording.tracks, gate)
    times = numpy.full(recording.people(), math.inf)
    for agent in numpy.flatnonzero(crossed.any(axis=0)):
        tick = int(numpy.argmax(crossed[:, agent]))
        before, after = (abs(float(side(*gate, recording.tracks[tick + i, agent]))) for i in (0, 1))
        share = before / (before + after) if before + after > 0 else 0.0
        times[agent] = (tick + share) * recording.tick
    return times


def crossings(tracks, segment):
    """Returns whether each step of each agent crosses a segment: array (tick, agent) of the steps."""
    start, end = numpy.asarray(segment, dtype=float)
    sides = side(start, end, tracks)
    changes = sides[:-1] * sides[1:] < 0
    changes |= (sides[1:] == 0) & (sides[:-1] != 0)  # the step ends on the segment's line
    hits = numpy.zeros(changes.shape, dtype=bool)
    ticks, agents = numpy.nonzero(changes)
    before, after = tracks[ticks, agents], tracks[ticks + 1, agents]
    step = after - before
    of_start = step[:, 0] * (start[1] - before[:, 1]) - step[:, 1] * (start[0] - before[:, 0])
    of_end = step[:, 0] * (end[1] - before[:, 1]) - step[:, 1] * (end[0] - before[:, 0])
    hits[ticks, agents] = of_start * of_end <= 0
    return hits


def through_walls(recording):
    """Returns how many agents' centres crossed a wall."""
    hits = numpy.zeros(recording.people(), dtype=bool)
    for wall in recording.walls:
        hits |= crossings(recording.tracks, wall).any(axis=0)
    return int(hits.sum())


def largest_overlap(recording):
    """Returns by how much two bodies overlapped at most [m]; 0 if none did. For small crowds."""
    reach = recording.radii[:, None] + recording.radii[None]
    numpy.fill_diagonal(reach, -math.inf)
    return max(0.0, *(float(numpy.nanmax(reach - cdist(places, places), initial=0.0)) for places in recording.tracks))


def starts(recording, distance=0.01):
    """Returns the last moment at which each agent was still within a distance [m] of its start [s]; inf if always."""
    away = numpy.hypot(*(recording.tracks - recording.tracks[0]).transpose(2, 0, 1)) > distance
    moved = away.any(axis=0)
    return numpy.where(moved, (numpy.argmax(away, axis=0) - 1) * recording.tick, math.inf)


def mean_speeds(recording, axis, low, high):
    """Returns the mean speed of each agent between two coordinates of an axis [m/s]; nan if it does not pass both."""
    times = []
    for value in (low, high):
        gate = numpy.array([[value, -FAR], [value, FAR]])
        times.append(crossing_times(recording, gate if axis == 0 else gate[:, ::-1]))
    with numpy.errstate(invalid='ignore'):
        return numpy.where(numpy.isfinite(times).all(axis=0), (high - low) / (times[1] - times[0]), numpy.nan)


def left_over(recording):
    """Returns the last places of the agents that did not arrive [m], and how many of them stand."""
    stuck = ~numpy.isfinite(recording.arrivals)
    last = recording.last_places()[stuck]
    earlier = recording.place_at(max(0.0, (len(recording.tracks) - 1) * recording.tick - STANDING_TIME))[stuck]
    return last, int((numpy.hypot(*(last - earlier).T) < STANDING).sum())


def nearest_of(places, points):
    """Returns the index of the point that is nearest to each place."""
    return cdist(places, points).argmin(axis=1)


def slow_people(recording, low, high, share=0.5, period=1.0):
    """Returns at every tick how many people in a box [m] walked at less than a share of their speed in the period."""
    steps = round(period / recording.tick)
    moved = recording.tracks[steps:] - recording.tracks[:-steps]
    now = recording.tracks[steps:]
    slow = numpy.hypot(moved[:, :, 0], moved[:, :, 1]) < share * period * recording.speeds
    inside = ((now >= numpy.asarray(low)) & (now <= numpy.asarray(high))).all(axis=2)
    return numpy.concatenate([numpy.zeros(steps, dtype=int), (slow & inside).sum(axis=1)])


def sustained_peak(counts, ticks):
    """Returns the largest number that `counts` reached or exceeded in this number of consecutive ticks."""
    windows = numpy.lib.stride_tricks.sliding_window_view(counts, min(ticks, len(counts)))
    return int(windows.min(axis=1).max())
