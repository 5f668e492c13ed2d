"""Files of the tools (records, trajectories, Q-tables); rates, spreads and confidence intervals of their values."""
import csv
import itertools
import math

import numpy
from crowd_drawing.errors import InputError, complete_lines, ended_lines, opened

TEXTS = ('scenario', 'robot', 'navigation')
LEVEL = 0.95
RESAMPLES = 2000


def read_csv(file, grows=False):
    """Returns the columns of a CSV file by their names: arrays of numbers, lists of texts. Raises InputError if
    there is no header, a row is not complete, or a value is not a number, and OSError. `grows`: the file may still be
    being written, so that a last line without an end is left out; otherwise it is an error."""
    with opened(file, newline='') as stream:
        rows = csv.reader(ended_lines(stream) if grows else complete_lines(stream, file))
        names = next(rows, None)
        if names is None:
            raise InputError(f'{file}: expected a header, got an empty file')
        values = []
        for row in rows:
            if len(row) != len(names):
                raise InputError(f'{file}:{rows.line_num}: expected {len(names)} values, got {len(row)}')
            values.append(row)
    return {name: list(column) if name in TEXTS else numbers_of(column, file, name)
            for name, column in zip(names, zip(*values) if values else [()] * len(names))}


def numbers_of(column, file, name):
    numbers = numpy.empty(len(column))
    for i, text in enumerate(column):
        try:
            numbers[i] = float(text)
        except ValueError:
            raise InputError(f"{file}:{i + 2}: expected a number in the column '{name}', got '{text}'") from None
    return numbers


def read_tracks(file, agents=0):
    """Returns the places of every instance [m]: arrays (tick, agent, 2), nan after an agent has left."""
    try:
        with opened(file) as stream:
            rows = numpy.loadtxt(complete_lines(stream, file), delimiter=',', skiprows=1, ndmin=2)
    except ValueError as error:
        raise InputError(f'{file}: {error}') from None
    tracks = {}
    for instance in numpy.unique(rows[:, 0]):
        of_instance = rows[rows[:, 0] == instance]
        ticks, numbers = of_instance[:, 1].astype(int), of_instance[:, 2].astype(int)
        track = numpy.full((ticks.max() + 1, max(agents, numbers.max() + 1), 2), numpy.nan)
        track[ticks, numbers] = of_instance[:, 3:]
        tracks[int(instance)] = track
    return tracks


def percent(flags):
    """Returns the share of flags that are set [%]."""
    return 100.0 * float(numpy.mean(flags)) if len(flags) else float('nan')


def ratios_per_gain(rows):
    """Returns the path per distance gained of all rows; infinite if no distance was gained."""
    return numpy.where(numpy.isnan(rows['path_per_gain']), numpy.inf, rows['path_per_gain'])


def path_per_gain(rows):
    """Returns the path per distance gained, median over all rows."""
    return float(numpy.median(ratios_per_gain(rows)))


def finite(values):
    return values[numpy.isfinite(values)]


def median(values):
    """Returns the median of the finite values; nan if there are none."""
    numbers = finite(numpy.asarray(values, dtype=float))
    return float(numpy.median(numbers)) if len(numbers) else float('nan')


def read_table_header(file):
    """Returns the header of a Q-table file, as texts by their keys."""
    with open(file, encoding='utf-8') as stream:
        lines = list(itertools.takewhile(lambda line: not line.startswith('---'), stream))
    return dict(map(str.strip, line.split(': ', 1)) for line in lines[1:])


def read_visits(file):
    """Returns the number of visits of each visited row of a Q-table, without those of other sources."""
    with open(file, encoding='utf-8') as stream:
        lines = itertools.dropwhile(lambda line: not line.startswith('---'), stream)
        next(lines)
        rows = [line.split() for line in itertools.takewhile(lambda line: line[0].isdigit(), lines)]
    return {int(row[0]): sum(map(int, row[1::2])) for row in rows}


def spread_text(values, decimals=2):
    """Returns mean ± standard deviation (lowest-highest) of the finite values, and the number of other values."""
    values = numpy.array(list(values), dtype=float)
    text = Spread.of_numbers(values).text(decimals)
    if numpy.isfinite(values).all():
        return text
    kind = 'infinite' if numpy.isinf(values).any() else 'none'
    return f'{text}; {kind} in {(~numpy.isfinite(values)).sum()} of {len(values)} seeds'


class Spread:
    """A value for every seed."""

    def __init__(self, values):
        self.values = numpy.array(list(values), dtype=float)
        if len(self.values) == 0:
            self.values = numpy.array([float('nan')])
        self.mean, self.low, self.high = (float(of(self.values)) for of in (numpy.mean, numpy.min, numpy.max))
        self.deviation = float(numpy.std(self.values, ddof=1)) if len(self.values) > 1 else 0.0

    @classmethod
    def of_numbers(cls, values):
        return cls(finite(numpy.array(list(values), dtype=float)))

    def text(self, decimals=2, deviation=True):
        """Returns mean ± standard deviation (lowest-highest)."""
        if numpy.isnan(self.mean):
            return '-'
        mean, deviated, low, high = (f'{value:.{decimals}f}' for value in
                                     (self.mean, self.deviation, self.low, self.high))
        return f'{mean} ± {deviated} ({low}-{high})' if deviation else f'{mean} ({low}-{high})'


def t_quantile(freedom):
    """Returns the quantile 0.975 of Student's t distribution."""
    from scipy.special import stdtrit  # where it is needed only; scipy.stats would take a second
    return float(stdtrit(freedom, 0.5 + LEVEL / 2))


def mean_interval(values):
    """Returns a mean, and low and high end of its 95 % confidence interval by Student's t; both nan with one value."""
    values = numpy.asarray(values, dtype=float)
    mean = float(values.mean()) if len(values) else math.nan
    if len(values) < 2:
        return mean, math.nan, math.nan
    half = t_quantile(len(values) - 1) * float(values.std(ddof=1)) / math.sqrt(len(values))
    return mean, mean - half, mean + half


def bootstrap_difference(first, second, seed=1):
    """Returns the difference of two means, second less first, and its 95 % interval by bootstrap percentiles: both
    samples are drawn again with replacement. The same seed gives the same interval."""
    first, second = (numpy.asarray(values, dtype=float) for values in (first, second))
    random = numpy.random.default_rng(seed)
    means = [values[random.integers(len(values), size=(RESAMPLES, len(values)))].mean(axis=1)
             for values in (first, second)]
    low, high = numpy.percentile(means[1] - means[0], [50 * (1 - LEVEL), 50 * (1 + LEVEL)])
    return float(second.mean() - first.mean()), float(low), float(high)
