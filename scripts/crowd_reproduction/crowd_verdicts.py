"""What several claims about crowds are judged by."""
import numpy

from crowd_experiments.records import Spread

from . import scenario_runs as runs
from .claim import COMES_OUT, IN_PART, NOT, decide_all, decide_each

GOOD, HALF = 90.0, 50.0  # [%]: what "successfully" is to mean, and what is enough to come out in part
RARE = 10.0  # [%]: what "avoids" leaves


def is_good(value):
    return value >= GOOD


def graded(values):
    """The verdict on 'it succeeds', given the share of successes [%] for each seed."""
    mean = float(numpy.mean(list(values)))
    return COMES_OUT if mean >= GOOD else IN_PART if mean >= HALF else NOT


def is_rare(value):
    return value <= RARE


def both(values, conditions):
    """The verdict on several conditions, each on its own values of the seeds."""
    return decide_all(*(decide_each(of_seeds, condition) for of_seeds, condition in zip(values, conditions)))


def seeds(setting):
    return f'{len(setting.seeds(runs.SEEDS))} seeds'


def best_of(verdicts):
    """The verdict under the reading of the thesis under which a claim fares best."""
    verdicts = set(verdicts)
    return next(verdict for verdict in (COMES_OUT, IN_PART, NOT) if verdict in verdicts)


def rates_text(setting, scenario):
    success, contact, collision = zip(*runs.measured(setting, runs.MAIN, scenario))
    return (f'success {Spread(success).text(1)} %, collision {Spread(collision).text(1)} %, contact '
            f'{Spread(contact).text(1)} %')
