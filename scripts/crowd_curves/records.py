"""Records and logs of training runs, and their mean curves over windows of episodes with confidence bands."""
import csv
import dataclasses

import numpy
from crowd_drawing.errors import InputError, complete_lines, ended_lines
from crowd_experiments.confidence import mean_interval

WINDOWS = 50  # by default


@dataclasses.dataclass(frozen=True)
class Band:
    """The mean over runs in each window of episodes, with the ends of its 95 % confidence interval; nan where they are
    unknown, as with a single run."""
    label: str
    runs: int
    episodes: numpy.ndarray  # at the end of each window
    mean: numpy.ndarray
    low: numpy.ndarray
    high: numpy.ndarray


def episodes_of(runs):
    """Returns the number of episodes of the longest run."""
    return int(max(run.columns[EPISODE].max() + 1 for run in runs))


def default_window(runs):
    """Returns a number of episodes for which a curve has about fifty points."""
    return max(1, round(episodes_of(runs) / WINDOWS))


def band_of(label, runs, column, window):
    """Returns the Band of a column over runs. In windows that not all runs have reached, it is that of the others."""
    curves = [window_means(run, column, window) for run in runs]
    length = max(map(len, curves))
    table = numpy.full((len(curves), length), numpy.nan)
    for i, curve in enumerate(curves):
        table[i, :len(curve)] = curve
    points = numpy.array([mean_interval(values[numpy.isfinite(values)]) for values in table.T])
    episodes = numpy.minimum(window * numpy.arange(1, length + 1), episodes_of(runs))
    return Band(label, len(runs), episodes, *points.T)


EPISODE, SCENARIO = 'episode', 'scenario'
TEXTS = (SCENARIO, 'robot')


@dataclasses.dataclass(frozen=True)
class Run:
    """A record or log of one training: arrays by the names of its columns, with one entry for every agent of every
    episode, or for every episode."""
    label: str  # of the group of runs that it belongs to
    file: str
    columns: dict
    scenarios: tuple = ()  # of its rows, in alphabetical order; empty without such a column


def read_run(label, file, scenario=None, grows=False):
    """Reads a record of `train --record` or a log of `train --log`, or its rows of one scenario. `grows`: the training
    may still run, so that a last line without an end is left out; otherwise it is an error. Raises InputError,
    OSError."""
    with open(file, newline='', encoding='utf-8', errors='replace') as stream:
        rows = csv.reader(ended_lines(stream) if grows else complete_lines(stream, file))
        names = next(rows, [])
        if EPISODE not in names:
            raise InputError(f'{file}:1: expected a record of `train --record` or a log of `train --log`, with a '
                             f"column '{EPISODE}'")
        chosen, texts, scenarios = [], [i for i, name in enumerate(names) if name in TEXTS], set()
        of_scenario = names.index(SCENARIO) if SCENARIO in names else None
        for row in rows:
            if len(row) != len(names):
                raise InputError(f'{file}:{rows.line_num}: expected {len(names)} values, got {len(row)}')
            if of_scenario is not None:
                scenarios.add(row[of_scenario])
                if scenario not in (None, row[of_scenario]):
                    continue
            chosen.append(numbers_of(file, rows.line_num, names, row, texts))
    if not chosen:
        raise InputError(f'{file}: has no rows' + ('' if scenario is None else
                         f" of a scenario '{scenario}'; there are {', '.join(sorted(scenarios))}"))
    values = numpy.array(chosen)
    return Run(label, file, {name: values[:, i] for i, name in enumerate(names) if i not in texts},
               tuple(sorted(scenarios)) if scenario is None else (scenario,))


def by_scenario(run):
    """Returns a run for each scenario of a run, which may still grow. Raises InputError, OSError."""
    return [read_run(f'{run.label} {scenario}'.strip(), run.file, scenario, grows=True)
            for scenario in run.scenarios] or [run]


def numbers_of(file, line, names, row, texts):
    """Returns the values of a row; texts are replaced by 0."""
    try:
        return [0.0 if i in texts else float(value) for i, value in enumerate(row)]
    except ValueError:
        wrong = next(name for i, name in enumerate(names) if i not in texts and not is_number(row[i]))
        raise InputError(f"{file}:{line}: expected a number in the column '{wrong}'") from None


def is_number(text):
    """Returns whether a text is a number."""
    try:
        float(text)
    except ValueError:
        return False
    return True


def window_means(run, column, window):
    """Returns the mean of the finite values of a column in each window of episodes; nan where there are none."""
    values, windows = run.columns[column], (run.columns[EPISODE] // window).astype(int)
    known = numpy.isfinite(values)
    count = numpy.bincount(windows[known], minlength=windows.max() + 1)
    total = numpy.bincount(windows[known], values[known], minlength=windows.max() + 1)
    return numpy.divide(total, count, out=numpy.full(len(count), numpy.nan), where=count > 0)
