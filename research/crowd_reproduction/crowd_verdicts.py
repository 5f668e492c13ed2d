"""Criteria by which several claims about crowds are judged."""
import numpy

from . import names, scenario_runs as runs
from .claim import CONFIRMED, PARTLY, NOT_CONFIRMED, decide_all, decide_each

GOOD, HALF = 90.0, 50.0  # [%] success rates from which a claim is confirmed, and partly confirmed
RARE = 10.0  # [%] highest rate of contacts or collisions with which "avoids" holds


def is_good(value):
    return value >= GOOD


def graded(values):
    """Returns the verdict on 'it succeeds', given the success rate [%] for each seed."""
    mean = float(numpy.mean(list(values)))
    return CONFIRMED if mean >= GOOD else PARTLY if mean >= HALF else NOT_CONFIRMED


def is_rare(value):
    return value <= RARE


def both(values, conditions):
    """Returns the verdict on several conditions, each with its own values of the seeds."""
    return decide_all(*(decide_each(of_seeds, condition) for of_seeds, condition in zip(values, conditions)))


def seeds(setting):
    return f'{len(setting.seeds(runs.SEEDS))} seeds'


def best_of(verdicts):
    """Returns the best of the verdicts, for claims that the thesis leaves open to several readings."""
    verdicts = set(verdicts)
    return next(verdict for verdict in (CONFIRMED, PARTLY, NOT_CONFIRMED) if verdict in verdicts)


def rates_text(setting, scenario):
    return names.rates_sentence(runs.measured(setting, runs.MAIN, scenario))
