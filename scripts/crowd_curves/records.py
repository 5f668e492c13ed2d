"""Records and logs of training runs, and their mean curves over windows of episodes with confidence bands."""
import dataclasses

import numpy
import pandas
from crowd_drawing.errors import InputError
from crowd_experiments.confidence import mean_interval
from crowd_experiments.records import read_csv

EPISODE, SCENARIO = 'episode', 'scenario'
WINDOWS = 50  # by default


@dataclasses.dataclass(frozen=True)
class Run:
    """The numbers of a record or log of one training, with a row for every agent or every episode."""
    label: str  # of the group of runs that it belongs to
    file: str
    columns: pandas.DataFrame
    scenarios: tuple = ()  # of its rows, in alphabetical order; empty without such a column


@dataclasses.dataclass(frozen=True)
class Band:
    """The mean over runs in each window of episodes, with its 95 % confidence interval; nan where that is unknown."""
    label: str
    runs: int
    episodes: numpy.ndarray  # at the end of each window
    mean: numpy.ndarray
    low: numpy.ndarray
    high: numpy.ndarray


def read_run(label, file, scenario=None, grows=False):
    """Reads a record or log of `train`, maybe of one scenario. `grows`: see read_csv(). Raises InputError, OSError."""
    with open(file, encoding='utf-8', errors='replace') as stream:
        if EPISODE not in next(stream, '').rstrip('\r\n').split(','):
            raise InputError(f'{file}:1: expected a record of `train --record` or a log of `train --log`, with a '
                             f"column '{EPISODE}'")
    rows = pandas.DataFrame(read_csv(file, grows))
    scenarios = sorted(set(rows.get(SCENARIO, ())))
    if scenario is not None and scenarios:
        rows = rows[rows[SCENARIO] == scenario]
    if rows.empty:
        raise InputError(f'{file}: has no rows' + ('' if scenario is None else
                         f" of a scenario '{scenario}'; there are {', '.join(scenarios)}"))
    return Run(label, file, rows.select_dtypes('number'), tuple(scenarios) if scenario is None else (scenario,))


def by_scenario(run):
    """Returns a run for each scenario of a run, which may still grow. Raises InputError, OSError."""
    return [read_run(f'{run.label} {scenario}'.strip(), run.file, scenario, grows=True)
            for scenario in run.scenarios] or [run]


def window_means(run, column, window):
    """Returns the mean of the finite values of a column in each window of episodes; nan where there are none."""
    windows = (run.columns[EPISODE] // window).astype(int)
    values = run.columns[column].where(numpy.isfinite(run.columns[column]))
    return values.groupby(windows).mean().reindex(range(windows.max() + 1)).to_numpy()


def episodes_of(runs):
    """Returns the number of episodes of the longest run."""
    return int(max(run.columns[EPISODE].max() + 1 for run in runs))


def default_window(runs):
    """Returns a number of episodes for which a curve has about fifty points."""
    return max(1, round(episodes_of(runs) / WINDOWS))


def band_of(label, runs, column, window):
    """Returns the Band of a column over runs. In windows that not all runs have reached, it is that of the others."""
    curves = pandas.DataFrame([window_means(run, column, window).tolist() for run in runs])
    points = numpy.array([mean_interval(values.dropna()) for _, values in curves.items()])
    episodes = numpy.minimum(window * numpy.arange(1, len(points) + 1), episodes_of(runs))
    return Band(label, len(runs), episodes, *points.T)
