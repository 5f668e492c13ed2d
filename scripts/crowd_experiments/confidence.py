"""Confidence intervals."""
import math

import numpy

LEVEL = 0.95
RESAMPLES = 2000


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
