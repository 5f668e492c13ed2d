"""Judges the claims of the thesis about its rewards and about training, from the records of the runs. The thesis's
parameters are used; measures are functions of reward_measures, given by their names."""
import math
import operator

import numpy
from crowd_experiments.records import spread_text

from . import reward_measures as measures
from .claim import (CONFIRMED, Judgement, LEAST_SHARE, NOT_CONFIRMED, PARTLY, VERDICTS, best_of, compared, decide,
                    decide_each, decide_near, joined, number_text)
from .declared import REWARDS
from .results import Runs, REWARD_NAMES, per_seed
from .reward_measures import MODES, THESIS_SUCCESS, learned, of_mode

DIFFERENT = 5.0  # [points] rates that differ by more do not depict each other
SIMILAR = 10.0  # [points] rates that differ by at most this are similar
# A separation is a gap of WIDTH [m], with a share of LEAST_SIDE of the episodes or more on each side, and at most
# MOST_BETWEEN in the gap.
WIDTH, LEAST_SIDE, MOST_BETWEEN = 0.005, 0.05, 0.01
# Percentiles between which the middle half and four fifths of the values lie.
MIDDLES = {'middle half': (25, 75), 'four fifths': (10, 90)}
CONDITIONS = {'<=': operator.le, '<': operator.lt, '>': operator.gt, '>=': operator.ge}


UNITS = {'success': ' %', 'collision': ' %', 'gain_per_step': ' m', 'shortfall': ' m', 'turning': ' rad/m'}


def unit_of(measure):
    return UNITS.get(measure, '') if isinstance(measure, str) else ''


def measured(setting, reward, mode, measure):
    """Returns a measure, given by its name or as a function, for each seed."""
    return of_mode(learned(setting, reward), mode, getattr(measures, measure) if isinstance(measure, str) else measure)


def compare(setting, measure, mode, greater, decimals=2):
    """Judges that a measure is greater with the one reward than with the other."""
    other = next(reward for reward in REWARDS if reward != greater)
    return compared('', REWARD_NAMES[greater], measured(setting, greater, mode, measure), REWARD_NAMES[other],
                    measured(setting, other, mode, measure), decimals, unit=unit_of(measure))


def scattered(setting, breadth, mode, greater, decimals=2):
    """Judges that a measure is more scattered with the one reward, by its middle half and its middle four fifths."""
    parts = {name: compare(setting, getattr(measures, breadth)(percentiles), mode, greater, decimals)
             for name, percentiles in MIDDLES.items()}
    return joined([Judgement(f'{name}: {part.measured}', part.verdict, f'{name} {part.number}')
                   for name, part in parts.items()], '. ')


def each(setting, reward, mode, measure, sign, limit):
    values = measured(setting, reward, mode, measure)
    return Judgement(f'{REWARD_NAMES[reward]} {spread_text(values)}',
                     decide_each(values, lambda value: CONDITIONS[sign](value, limit)),
                     f'{REWARD_NAMES[reward]} {number_text(values, 2, unit_of(measure))}')


def number(setting, reward, mode):
    values, reported = measured(setting, reward, mode, 'success'), THESIS_SUCCESS[reward, mode]
    return Judgement(f'{REWARD_NAMES[reward]}: thesis {reported:.2f}, here {spread_text(values)}',
                     decide_near(values, reported),
                     f'{REWARD_NAMES[reward]} {number_text(values)} (thesis {reported:.2f})')


def curved(setting):
    """Judges that paths without an obstacle bend more with distance gained."""
    gain, cosine = (measures.free_bends(learned(setting, reward))[:, 0] for reward in REWARDS)
    return compared('sum of the bends [degrees]: ', 'distance gained', gain, 'cos³', cosine, 0)


def softer(setting):
    """Judges that paths with distance gained have less sharp bends and less turning per metre."""
    gain, cosine = (measures.free_bends(learned(setting, reward))[:, 1] for reward in REWARDS)
    parts = [compared('sharpest bend [degrees]: ', 'cos³', cosine, 'distance gained', gain, 0)]
    turning = numpy.array([measured(setting, reward, 'free', 'turning') for reward in REWARDS])
    gain, cosine = turning[:, numpy.isfinite(turning).all(axis=0)]  # seeds with which both arrive
    if len(gain):
        parts.append(compared('Turning [rad/m], arrivals only: ', 'cos³', cosine, 'distance gained', gain))
    return joined(parts, '. ')


def separated(record):
    gains = numpy.sort(record['gain_per_tick'])
    side, between = max(1, math.ceil(LEAST_SIDE * len(gains))), int(MOST_BETWEEN * len(gains)) + 1
    gaps = gains[between:] - gains[:-between]
    return bool(gaps[side - 1:len(gaps) + 1 - side].max(initial=0.0) >= WIDTH)


def separation(setting, reward):
    """Judges that the charts show a separation, in runs in which some episodes fail, as in the thesis."""
    found = measured(setting, reward, 'demo', lambda rows: (measures.success(rows), separated(rows)))
    flags = [flag for success, flag in found if 100.0 * LEAST_SIDE <= success <= 100.0 * (1.0 - LEAST_SIDE)]
    return Judgement(f'{REWARD_NAMES[reward]}: in {sum(flags)} of the {len(flags)} seeds with success between 5 and '
                     '95 %', decide(numpy.mean(flags or [0.0]) > 0.5, flags or [False]),
                     f'{REWARD_NAMES[reward]} in {sum(flags)} of {len(flags)} seeds with success 5-95 %')


def less_in_demo(setting, reward):
    training, demo = (measured(setting, reward, mode, 'success') for mode in MODES)
    return compared(f'{REWARD_NAMES[reward]}: ', 'training', training, 'demo', demo, unit=' %')


def longer(setting, reward, measure, rises):
    """Judges that more training improves a rate in demo."""
    more = of_mode(Runs.of(setting, 'longer', reward=reward), 'demo', getattr(measures, measure))
    name, usual_name = (f'{number:,} episodes' for number in setting.count((8000, 2000), (80, 40)))
    return compared(f'{REWARD_NAMES[reward]}, {measure}: ', name, more, usual_name,
                    measured(setting, reward, 'demo', measure), falls=not rises, unit=unit_of(measure))


def inconclusive(setting, measure, mode):
    """Judges that a measure decides for neither of the rewards."""
    gain, cosine = (compare(setting, measure, mode, reward) for reward in REWARDS)
    better = best_of([gain.verdict, cosine.verdict])
    return Judgement(cosine.measured, {CONFIRMED: NOT_CONFIRMED, PARTLY: PARTLY, NOT_CONFIRMED: CONFIRMED}[better],
                     cosine.number)


def more_is_needed(setting, reward):
    """Judges that more episodes, or more decisions in an episode, improve the success in demo."""
    episodes, decisions = longer(setting, reward, 'success', True), more_decisions(setting, reward)
    best = episodes if episodes.verdict == best_of([episodes.verdict, decisions.verdict]) else decisions
    return Judgement(f'{episodes.measured}. {decisions.measured}', best.verdict, best.number)


def relative_helps(setting):
    """Judges that directions relative to the heading make paths with less turning, that are shorter."""
    relative, absolute = (Runs.of(setting, 'directions', reward='cosine_cubed', variation=variation)
                          for variation in ('relative', 'absolute'))
    parts = []
    for mode, place in (('free', 'without an obstacle'), ('demo', 'with one')):
        for measure, name in (('turning', 'turning [rad/m]'), ('path_ratio', 'path ratio')):
            values = numpy.array([of_mode(runs, mode, getattr(measures, measure)) for runs in (absolute, relative)])
            pairs = values[:, numpy.isfinite(values).all(axis=0)]
            if pairs.shape[1]:
                parts.append(compared(f'{name} {place}: ', 'absolute', pairs[0], 'relative', pairs[1]))
    return joined(parts, '. ') if parts else Judgement('no agent arrives', NOT_CONFIRMED)


def more_decisions(setting, reward):
    """Judges that more decisions per episode improve the success in demo, with the same episodes."""
    patient = learned(setting, reward).record('patient.csv')
    usual = measured(setting, reward, 'demo', lambda rows: measures.success(rows[:patient['episode'].nunique()]))
    return compared(f'{REWARD_NAMES[reward]}: ', '8,000 decisions', per_seed(patient, measures.success),
                    '2,000 decisions', usual, unit=' %')


def quarter(measure, last):
    """Returns a measure of the first or the last quarter of the episodes."""
    def of_part(rows):
        length = len(rows) // 4
        return measure(rows[-length:] if last else rows[:length])
    return of_part


def in_course(setting, reward, measure, falls):
    """Judges that a rate decreases, or increases, in the course of the training."""
    first, last = (measured(setting, reward, 'training', quarter(getattr(measures, measure), is_last))
                   for is_last in (False, True))
    return compared(f'{REWARD_NAMES[reward]}: ', 'first quarter', first, 'last quarter', last, falls=not falls,
                    unit=unit_of(measure))


def training_differs(setting, reward):
    """Judges that success in training does not necessarily depict success in demo: it differs in a quarter of the
    seeds."""
    training, demo = (numpy.array(measured(setting, reward, mode, 'success')) for mode in MODES)
    differs = numpy.abs(training - demo) > DIFFERENT
    return Judgement(f'{REWARD_NAMES[reward]}: training minus demo {spread_text(training - demo)} points',
                     VERDICTS[2 - int(differs.any()) - int(differs.mean() >= 1.0 - LEAST_SHARE)],
                     f'{REWARD_NAMES[reward]} {number_text(training - demo, unit=" points")}')


def similar_success(setting):
    """Judges that both rewards have similar rates of success in demo."""
    gain, cosine = (numpy.array(measured(setting, reward, 'demo', 'success')) for reward in REWARDS)
    return Judgement(f'cos³ minus distance gained: {spread_text(cosine - gain)} points',
                     decide(abs((cosine - gain).mean()) <= SIMILAR, numpy.abs(cosine - gain) <= SIMILAR),
                     f'cos³ less distance gained {number_text(cosine - gain, unit=" points")}')


def mostly_free(setting, reward):
    shares = measures.free_share(learned(setting, reward))
    return Judgement(f'{REWARD_NAMES[reward]}: {spread_text(shares, 1)} % without an obstacle',
                     decide_each(shares, lambda share: share > 50.0),
                     f'{REWARD_NAMES[reward]} {number_text(shares)}')
