"""Judges the claims of the thesis about its rewards and about training, from the records of the runs."""
import math

import numpy

from crowd_experiments.records import spread_text

from . import reward_runs as runs
from .claim import Judgement, decide, decide_all, decide_each, decide_greater, decide_near, versus
from .names import REWARD_NAMES
from .reward_runs import COSINE, GAIN, MODES, THESIS_SUCCESS, Variant, per_seed, records

DIFFERENT = 5.0  # [points] rates that differ by more do not depict each other
SIMILAR = 10.0  # [points] rates that differ by at most this are similar
# A separation is a gap of WIDTH [m], with a share of LEAST_SIDE of the episodes or more on each side, and at most
# MOST_BETWEEN in the gap.
WIDTH, LEAST_SIDE, MOST_BETWEEN = 0.005, 0.05, 0.01
HALF, FOUR_FIFTHS = (25, 75), (10, 90)  # percentiles between which the middle half and four fifths of the values lie


def compare(measure, mode, greater, decimals=2):
    """Judges that a measure is greater with the one reward than with the other."""
    def judge(setting):
        other = COSINE if greater is GAIN else GAIN
        first, second = (per_seed(setting, variant, mode, measure) for variant in (greater, other))
        return Judgement(versus(REWARD_NAMES[greater.reward], first, REWARD_NAMES[other.reward], second, decimals),
                         decide_greater(first, second))
    return judge


def scattered(breadth, mode, greater, decimals=2):
    """Judges that a measure is more scattered with the one reward, by its middle half and its middle four fifths."""
    return named_parts({'middle half': compare(breadth(HALF), mode, greater, decimals),
                        'four fifths': compare(breadth(FOUR_FIFTHS), mode, greater, decimals)})


def named_parts(judges):
    """Judges a claim with several named parts."""
    def judge(setting):
        parts = {name: part(setting) for name, part in judges.items()}
        return Judgement('. '.join(f'{name}: {part.measured}' for name, part in parts.items()),
                         decide_all(*(part.verdict for part in parts.values())))
    return judge


def each(variant, mode, measure, condition, decimals=2):
    """Judges that a measure meets a condition."""
    def judge(setting):
        values = per_seed(setting, variant, mode, measure)
        return Judgement(f'{REWARD_NAMES[variant.reward]} {spread_text(values, decimals)}',
                         decide_each(values, condition))
    return judge


def both(*judges):
    """Judges a claim with several parts."""
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


def curved(setting):
    """Judges that paths without an obstacle bend more with distance gained."""
    gain, cosine = (runs.free_bends(setting, variant)[:, 0] for variant in (GAIN, COSINE))
    return Judgement('sum of the bends [degrees]: ' + versus('distance gained', gain, 'cos³', cosine, 0),
                     decide_greater(gain, cosine))


def softer(setting):
    """Judges that paths with distance gained have less sharp bends and less turning per metre."""
    gain, cosine = (runs.free_bends(setting, variant)[:, 1] for variant in (GAIN, COSINE))
    turning = numpy.array([per_seed(setting, variant, 'free', runs.turning) for variant in (GAIN, COSINE)])
    gain_turning, cosine_turning = turning[:, numpy.isfinite(turning).all(axis=0)]  # seeds with which both arrive
    verdicts = [decide_greater(cosine, gain)]
    text = 'sharpest bend [degrees]: ' + versus('cos³', cosine, 'distance gained', gain, 0)
    if len(gain_turning):
        text += '. Turning [rad/m], arrivals only: ' + versus('cos³', cosine_turning, 'distance gained', gain_turning)
        verdicts.append(decide_greater(cosine_turning, gain_turning))
    return Judgement(text, decide_all(*verdicts))


def separated(record):
    """Returns whether the distances gained per step form two groups."""
    gains = numpy.sort(record['gain_per_tick'])
    side, between = max(1, math.ceil(LEAST_SIDE * len(gains))), int(MOST_BETWEEN * len(gains)) + 1
    gaps = gains[between:] - gains[:-between]
    return bool(gaps[side - 1:len(gaps) + 1 - side].max(initial=0.0) >= WIDTH)


def separation(variant):
    """Judges that the charts show a separation, in runs in which some episodes fail, as in the thesis."""
    def judge(setting):
        flags = [separated(record) for record in records(setting, variant, 'demo')
                 if 100.0 * LEAST_SIDE <= runs.success(record) <= 100.0 * (1.0 - LEAST_SIDE)]
        return Judgement(f'{REWARD_NAMES[variant.reward]}: in {sum(flags)} of the {len(flags)} seeds with success '
                         'between 5 and 95 %', decide(numpy.mean(flags or [0.0]) > 0.5, flags or [False]))
    return judge


def less_in_demo(variant):
    """Judges that success is lower in demo than in training."""
    def judge(setting):
        training, demo = (per_seed(setting, variant, mode, runs.success) for mode in MODES)
        return Judgement(f'{REWARD_NAMES[variant.reward]}: {versus("training", training, "demo", demo)}',
                         decide_greater(training, demo))
    return judge


def longer(variant, measure, is_better_greater):
    """Judges that more training improves a rate in demo."""
    def judge(setting):
        usual, more = (per_seed(setting, Variant(variant.reward, is_longer=is_longer), 'demo', measure)
                       for is_longer in (False, True))
        name, usual_name = (f'{setting.count(*numbers):,} episodes'
                            for numbers in ((runs.LONGER_EPISODES, 80), (runs.EPISODES, 40)))
        return Judgement(f'{REWARD_NAMES[variant.reward]}: {versus(name, more, usual_name, usual)}',
                         decide_greater(more, usual) if is_better_greater else decide_greater(usual, more))
    return judge


def more_decisions(variant):
    """Judges that more decisions per episode improve the success in demo, with the same episodes."""
    def judge(setting):
        patient = per_seed(setting, variant, 'patient', runs.success)
        usual = per_seed(setting, variant, 'demo', lambda record: runs.success(
            {name: column[:setting.count(runs.PATIENT_EPISODES, 5)] for name, column in record.items()}))
        return Judgement(f'{REWARD_NAMES[variant.reward]}: ' + versus(
            f'{runs.PATIENT_DURATION:,} decisions', patient, '2,000 decisions', usual), decide_greater(patient, usual))
    return judge


def quarter(measure, last):
    """Returns a measure of the first or the last quarter of the episodes."""
    def measured(record):
        length = len(record['arrived']) // 4
        part = slice(-length, None) if last else slice(length)
        return measure({name: column[part] for name, column in record.items()})
    return measured


def in_course(variant, measure, falls):
    """Judges that a rate decreases, or increases, in the course of the training."""
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
        return Judgement(f'{REWARD_NAMES[variant.reward]}: {spread_text(shares, 1)} % without an obstacle',
                         decide_each(shares, lambda share: share > 50.0))
    return judge


def of_both(make, *arguments):
    """Judges a claim for both rewards."""
    return both(*(make(variant, *arguments) for variant in (GAIN, COSINE)))
