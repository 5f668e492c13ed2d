"""Mean curves of groups of runs, with confidence bands."""
import dataclasses

import numpy
from crowd_curves.records import EPISODE, window_means
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
