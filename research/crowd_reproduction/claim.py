"""A claim of the thesis, and the rules that decide whether our results confirm it."""
import typing

import numpy
from crowd_experiments.records import Spread, spread_text

CONFIRMED, PARTLY, NOT_CONFIRMED = VERDICTS = 'confirmed', 'partly confirmed', 'not confirmed'
LEAST_SHARE = 0.75  # of the seeds for which a claim must hold
NEAR = 5.0  # [points]
GOOD, HALF = 90.0, 50.0  # [%] success rates from which a claim is confirmed, and partly confirmed
RARE = 10.0  # [%] highest rate of contacts or collisions with which "avoids" holds


class Judgement(typing.NamedTuple):
    """Our numbers, as a text with seeds and spread, the resulting verdict, and the number that decides most."""
    measured: str
    verdict: str
    number: str = ''  # with its spread


class Claim(typing.NamedTuple):
    """A statement of the thesis, and the function that judges it."""
    section: str
    says: str  # quotation or summary of the thesis
    judge: typing.Callable  # takes the Setting, returns a Judgement
    reasons: dict = {}  # known reasons, by verdict
    readings: typing.Optional[list] = None  # those under which it is judged; None: all


def all_of(judges):
    """Returns a judge of a claim with several parts: functions of the Setting and of further arguments."""
    return lambda setting: joined([part(setting, *words) for part, words in judges], '. ')


def joined(parts, separator, before='', shown=2):
    """Returns the Judgement on a claim with several parts, with the numbers of the first ones."""
    return Judgement(before + separator.join(part.measured for part in parts),
                     decide_all(*(part.verdict for part in parts)), '; '.join(part.number for part in parts[:shown]))


def compared(before, name, values, other_name, others, decimals=2, falls=False, unit=''):
    """Returns the Judgement on 'the first is greater than the second', or with `falls` less."""
    values, others = list(values), list(others)
    return Judgement(before + versus(name, values, other_name, others, decimals),
                     decide_greater(others, values) if falls else decide_greater(values, others),
                     before + difference_text(name, values, other_name, others, decimals, unit))


def decide(holds_for_mean, holds_for_seeds):
    """Returns the verdict, given whether a claim holds for the mean and for each of the seeds."""
    holds_for_most = numpy.mean(list(map(bool, holds_for_seeds))) >= LEAST_SHARE
    return VERDICTS[2 - int(bool(holds_for_mean)) - int(holds_for_most)]


def decide_greater(first, second):
    """Returns the verdict on 'the first is greater than the second', given both values of the same seeds."""
    first, second = numpy.array(list(first), dtype=float), numpy.array(list(second), dtype=float)
    error = 0.0  # standard error of the mean difference; 0 if a value is infinite
    if len(first) > 1 and numpy.isfinite([first, second]).all():
        error = float(numpy.std(first - second, ddof=1)) / len(first) ** 0.5
    return decide(first.mean() - second.mean() > error, first > second)


def decide_each(values, condition):
    """Returns the verdict on 'the value meets the condition', given a value for each seed."""
    values = list(values)
    return decide(condition(float(numpy.mean(values))), map(condition, values))


def decide_near(values, number):
    """Returns the verdict on a number of the thesis [%]."""
    values = list(values)
    is_near = abs(float(numpy.mean(values)) - number) <= NEAR
    return VERDICTS[2 - int(is_near) - int(min(values) <= number <= max(values))]


def decide_all(*verdicts):
    """Returns the verdict on a claim with several parts."""
    return verdicts[0] if len(set(verdicts)) == 1 else PARTLY


def best_of(verdicts):
    """Returns the best of the verdicts, for claims that the thesis leaves open to several readings."""
    return min(verdicts, key=VERDICTS.index)


def graded(values):
    """Returns the verdict on 'it succeeds', given the success rate [%] for each seed."""
    mean = float(numpy.mean(list(values)))
    return CONFIRMED if mean >= GOOD else PARTLY if mean >= HALF else NOT_CONFIRMED


def is_good(value):
    return value >= GOOD


def good_and_rare(good=(), rare=()):
    """Returns the verdict on rates of the seeds that have to be good, and on others that have to be rare."""
    return decide_all(*(decide_each(of_seeds, is_good) for of_seeds in good),
                      *(decide_each(of_seeds, lambda value: value <= RARE) for of_seeds in rare))


def versus(name, values, other_name, other_values, decimals=2):
    """Returns a text with two values, their spreads, and the number of seeds in which the first is greater."""
    values, other_values = list(values), list(other_values)
    greater = sum(a > b for a, b in zip(values, other_values))
    return (f'{name} {spread_text(values, decimals)}, {other_name} {spread_text(other_values, decimals)}; '
            f'{name} greater in {greater} of {len(values)} seeds')


def number_text(values, decimals=1, unit=' %'):
    """Returns mean ± standard deviation and the number of seeds: 93.7 ± 1.0 %, 20 seeds. With infinite values the
    median (lowest-highest)."""
    values = numpy.array(list(values), dtype=float)
    values = values[~numpy.isnan(values)]
    if numpy.isinf(values).any():
        median, low, high = (f'{of(values):.{decimals}f}' for of in (numpy.median, numpy.min, numpy.max))
        text = f'median {median}{unit} ({low}-{high})'
    else:
        text = f'{Spread(values).mean:.{decimals}f} ± {Spread(values).deviation:.{decimals}f}{unit}'
    return f'{text}, {len(values)} seeds'


def difference_text(name, values, other_name, others, decimals, unit=''):
    """Returns the means of two values, and the standard deviation of their difference over the seeds; with infinite
    values the medians."""
    pairs = [pair for pair in zip(values, others) if not numpy.isnan(pair).any()]
    if not pairs:
        return 'no seed has both'
    first, second = numpy.transpose(pairs)
    if numpy.isinf(pairs).any():
        median, other = (f'{numpy.median(of_seeds):.{decimals}f}{unit}' for of_seeds in (first, second))
        return f'{name} {median}, {other_name} {other} (medians, {len(pairs)} seeds)'
    deviation = Spread(first - second).deviation
    mean, other = (f'{of_seeds.mean():.{decimals}f}{unit}' for of_seeds in (first, second))
    return f'{name} {mean}, {other_name} {other} (± {deviation:.{decimals}f}, {len(pairs)} seeds)'
