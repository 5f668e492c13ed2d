"""Ways to judge what the thesis claims of its rewards and of training, from the records of the runs."""
import math

import numpy

from crowd_experiments.records import spread_text

from . import reward_runs as runs
from .claim import Judgement, decide, decide_all, decide_each, decide_greater, decide_near, versus
from .names import REWARD_NAMES
from .reward_runs import MODES, REWARDS, THESIS_SUCCESS, Variant, per_seed

GAIN, COSINE = (Variant(reward) for reward in REWARDS)
DIFFERENT = 5.0  # [points] by which two rates differ that do not depict each other
SIMILAR = 10.0  # [points] by which two rates differ that are similar
WIDTH, LEAST_SIDE = 0.005, 0.05  # a separation: a gap of so much [m], with such a share of the episodes on either side


def compare(measure, mode, greater, decimals=2):
    """Judges that a measure is greater with the one reward than with the other."""
    def judge(setting):
        other = COSINE if greater is GAIN else GAIN
        first, second = (per_seed(setting, variant, mode, measure) for variant in (greater, other))
        return Judgement(versus(REWARD_NAMES[greater.reward], first, REWARD_NAMES[other.reward], second, decimals),
                         decide_greater(first, second))
    return judge


def each(variant, mode, measure, condition, decimals=2):
    """Judges that a measure fulfils a condition."""
    def judge(setting):
        values = per_seed(setting, variant, mode, measure)
        return Judgement(f'{REWARD_NAMES[variant.reward]} {spread_text(values, decimals)}',
                         decide_each(values, condition))
    return judge


def both(*judges):
    """Judges a claim that has parts."""
    def judge(setting):
        parts = [part(setting) for part in judges]
        return Judgement('. '.join(part.measured for part in parts), decide_all(*(part.verdict for part in parts)))
    return judge


def number(variant, mode):
    """Judges a rate of success that the thesis reports."""
    def judge(setting):
        values, reported = per_seed(setting, variant, mode, runs.success), THESIS_SUCCESS[variant.reward, mode]
        return Judgement(f'{REWARD_NAMES[variant.reward]}: thesis {reported:.2f}, here {spread_text(values)}',
                         decide_near(values, reported))
    return judge


def softer(setting):
    """Turning without an obstacle, in the seeds in which both rewards lead to arrivals."""
    pairs = numpy.array([per_seed(setting, variant, 'free', runs.turning) for variant in (COSINE, GAIN)])
    first, second = pairs[:, numpy.isfinite(pairs).all(axis=0)]
    if not len(first):
        return Judgement('no seed with arrivals for both', decide(False, [False]))
    return Judgement('turning [rad/m], arrivals only: ' + versus('cos³', first, 'distance gained', second),
                     decide_greater(first, second))


def separated(record):
    """Whether the distances gained per step lie in two groups."""
    gains = numpy.sort(record['gain_per_tick'])
    side = max(1, math.ceil(LEAST_SIDE * len(gains)))
    return float(numpy.diff(gains)[side - 1:len(gains) - side].max(initial=0.0) >= WIDTH)


def separation(variant):
    """Judges that the charts show a separation: with most seeds, as the thesis had one run."""
    def judge(setting):
        flags = per_seed(setting, variant, 'demo', separated)
        return Judgement(f'{REWARD_NAMES[variant.reward]}: in {sum(flags):.0f} of {len(flags)} seeds',
                         decide(numpy.mean(flags) > 0.5, flags))
    return judge


def less_in_demo(variant):
    """Judges that success is lower in demo than in training."""
    def judge(setting):
        training, demo = (per_seed(setting, variant, mode, runs.success) for mode in MODES)
        return Judgement(f'{REWARD_NAMES[variant.reward]}: {versus("training", training, "demo", demo)}',
                         decide_greater(training, demo))
    return judge


def longer(variant, measure, is_better_greater):
    """Judges that more training betters a rate in demo."""
    def judge(setting):
        usual, more = (per_seed(setting, Variant(variant.reward, is_longer=is_longer), 'demo', measure)
                       for is_longer in (False, True))
        name, usual_name = (f'{setting.count(*numbers):,} episodes'
                            for numbers in ((runs.LONGER_EPISODES, 80), (runs.EPISODES, 40)))
        return Judgement(f'{REWARD_NAMES[variant.reward]}: {versus(name, more, usual_name, usual)}',
                         decide_greater(more, usual) if is_better_greater else decide_greater(usual, more))
    return judge


def more_decisions(variant):
    """Judges that more decisions in an episode better the success in demo; the same episodes with both."""
    def judge(setting):
        patient = per_seed(setting, variant, 'patient', runs.success)
        usual = per_seed(setting, variant, 'demo', lambda record: runs.success(
            {name: column[:setting.count(runs.PATIENT_EPISODES, 5)] for name, column in record.items()}))
        return Judgement(f'{REWARD_NAMES[variant.reward]}: ' + versus(
            f'{runs.PATIENT_DURATION:,} decisions', patient, '2,000 decisions', usual), decide_greater(patient, usual))
    return judge


def quarter(measure, last):
    """A rate in the first or the last quarter of the episodes."""
    def measured(record):
        length = len(record['arrived']) // 4
        part = slice(-length, None) if last else slice(length)
        return measure({name: column[part] for name, column in record.items()})
    return measured


def in_course(variant, measure, falls):
    """Judges that a rate falls, or rises, in the course of training."""
    def judge(setting):
        first, last = (per_seed(setting, variant, 'training', quarter(measure, is_last)) for is_last in (False, True))
        text = versus('first quarter', first, 'last quarter', last)
        return Judgement(f'{REWARD_NAMES[variant.reward]}: {text}',
                         decide_greater(first, last) if falls else decide_greater(last, first))
    return judge


def training_differs(variant):
    """Judges that success in training does not depict success in demo."""
    def judge(setting):
        training, demo = (numpy.array(per_seed(setting, variant, mode, runs.success)) for mode in MODES)
        difference = training - demo
        return Judgement(f'{REWARD_NAMES[variant.reward]}: training minus demo {spread_text(difference)} points',
                         decide_each(numpy.abs(difference), lambda points: points > DIFFERENT))
    return judge


def similar_success(setting):
    """Judges that both rewards have similar rates of success in demo."""
    gain, cosine = (numpy.array(per_seed(setting, variant, 'demo', runs.success)) for variant in (GAIN, COSINE))
    difference = cosine - gain
    return Judgement(f'cos³ minus distance gained: {spread_text(difference)} points',
                     decide(abs(difference.mean()) <= SIMILAR, numpy.abs(difference) <= SIMILAR))


def mostly_free(variant):
    """Judges that most states in training are without an obstacle."""
    def judge(setting):
        shares = runs.free_share(setting, variant)
        return Judgement(f'{REWARD_NAMES[variant.reward]}: {spread_text(shares, 1)} % without',
                         decide_each(shares, lambda share: share > 50.0))
    return judge


def of_both(make, *arguments):
    """Judges the same of both rewards."""
    return both(*(make(variant, *arguments) for variant in (GAIN, COSINE)))
