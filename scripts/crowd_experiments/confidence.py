"""Confidence intervals of means."""
import math
import statistics

import numpy

LEVEL = 0.95
# Quantiles 0.975 of Student's t distribution for 1, 2, ... 30 degrees of freedom.
QUANTILES = [12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228,
             2.201, 2.179, 2.160, 2.145, 2.131, 2.120, 2.110, 2.101, 2.093, 2.086,
             2.080, 2.074, 2.069, 2.064, 2.060, 2.056, 2.052, 2.048, 2.045, 2.042]
RESAMPLES = 2000


def t_quantile(freedom):
    """Returns the quantile 0.975 of Student's t distribution."""
    if freedom <= len(QUANTILES):
        return QUANTILES[freedom - 1]
    z = statistics.NormalDist().inv_cdf(0.5 + LEVEL / 2)
    return z + (z**3 + z) / (4 * freedom)  # first term of the expansion about the normal distribution


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
