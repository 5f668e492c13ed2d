"""Judges the claims of sections 3 and 5: use of learned tables by other agents and in other scenarios, the effect of
more training, and the stay action."""
import numpy
from crowd_experiments.records import Spread

from .claim import (CONFIRMED, GOOD, NOT_CONFIRMED, PARTLY, RARE, Judgement, both, compared, decide_all, decide_each,
                    decide_greater, is_good, is_rare, joined)
from .crowds import CROWDED, SCENARIOS, SOON, WATCHED, agents, by_visits, rates
from .experiments import future_work, learning_curves, sharing
from .measures import share
from .results import RATES, SETS, rates_sentence

COSTS = {'no cost': 'stay', 'cost 0.2': 'stay_02', 'cost 1': 'stay_1', 'cost 5': 'stay_5'}


def experience_serves(setting):
    verdicts, texts = [], []
    for scenario in SCENARIOS:
        found = rates(agents(setting), scenario)
        verdicts.append(both((found.success, found.contact), (is_good, is_rare)))
        means = found[['success', 'contact', 'collision']].mean()
        texts.append(f'{scenario} {" / ".join(f"{value:.0f}" for value in means)}')
    fine = verdicts.count(CONFIRMED)
    return Judgement('success / contact / collision % in scenarios that were not used in training (means of '
                     f'{len(found)} seeds): {", ".join(texts)}; success at least {GOOD:g} and contact at most {RARE:g} '
                     f'in {fine} of {len(verdicts)}',
                     CONFIRMED if fine == len(verdicts) else PARTLY if fine else NOT_CONFIRMED)


def shared(setting, use, place, measure='contact'):
    """Returns a measure of the crowd with a pioneer's table, for each seed; place: of the number of episodes."""
    return sharing.curve(setting, 'occupancy', use)[place, :, list(RATES).index(measure)]


def pioneer_serves(setting):
    success, contact = (shared(setting, 'fixed', -1, measure) for measure in ('success', 'contact'))
    untrained = shared(setting, 'fixed', 0)
    return Judgement(f'twelve agents: success {Spread(success).text(1)} %; contact {Spread(contact).text(1)} %, after '
                     f'only the first part of the training {Spread(untrained).text(1)} %',
                     decide_all(decide_each(success, is_good), decide_greater(untrained, contact)))


def crowd_learns_on(setting):
    fixed, shared_on, own = (shared(setting, use, -1) for use in ('fixed', 'shared', 'own'))
    return Judgement(f'contact of twelve agents: {Spread(fixed).text(1)} % with the unchanged table, '
                     f'{Spread(shared_on).text(1)} % if all continue learning in one table, {Spread(own).text(1)} % in '
                     'own tables', decide_all(decide_greater(fixed, shared_on), decide_greater(fixed, own)))


def incomplete_table(setting):
    parts = []
    for scenario in WATCHED:
        outcomes = by_visits(agents(setting), scenario, CROWDED)
        pairs = [[share(part.contact.sum(), part.decisions.sum()) for part in (classes[:2], classes[3:])]
                 for classes in outcomes]
        rare, often = zip(*(pair for pair in pairs if numpy.isfinite(sum(pair))))
        parts.append(compared(f'{scenario}: ', 'rarely visited', rare, 'often visited', often, 1))
    return joined(parts, '; ', f'{CROWDED} or more sectors occupied, contact within {SOON} decisions %, rows visited '
                  'fewer than 10 and at least 100 times in training. ')


def more_training(setting):
    curve = learning_curves.Curve(setting, 'occupancy', 'thesis')
    parts = []
    for scenario, of_episodes in curve.rates.items():
        for measure, first, last in zip(RATES, of_episodes[1].T, of_episodes[-1].T):
            parts.append(Judgement(
                f'{scenario}, {measure} %: after {curve.episodes[1]:,} episodes {Spread(first).text(1)}, after '
                f'{curve.episodes[-1]:,} {Spread(last).text(1)}',
                decide_greater(last, first) if measure == 'success' else decide_greater(first, last)))
    return joined(parts, '; ')


def more_states(setting):
    first, second = (100.0 * curve.rows[-1] / curve.all_rows for curve in
                     (learning_curves.Curve(setting, states, 'thesis') for states in SETS))
    return compared('rows visited after all training, % of all rows: ', 'set 1', first, 'set 2', second, 1)


def any_number(setting):
    six, twelve = (rates(agents(setting), scenario) for scenario in ('circle6', 'circle12'))
    return Judgement(f'one table, six: {rates_sentence(six)}; twelve: {rates_sentence(twelve)}',
                     decide_all(both((six.success, twelve.success), (is_good,) * 2),
                                both((six.contact, twelve.contact), (is_rare,) * 2)))


def staying_pays(setting):
    without, free, dear = (future_work.rates(setting, variation).success
                           for variation in ('thesis', 'stay', 'stay_5'))
    return Judgement(f'success of twelve agents at varied speeds %: {Spread(without).text(1)} without the action, '
                     f'{Spread(free).text(1)} with the action at no cost, {Spread(dear).text(1)} at a cost of 5',
                     decide_all(decide_greater(without, free), decide_greater(dear, free)))


def staying_helps(setting):
    without = future_work.rates(setting, 'thesis').contact
    found = {name: future_work.rates(setting, variation) for name, variation in COSTS.items()}
    # An agent that stays forever has no contacts.
    verdicts = [decide_greater(without, one.contact) for one in found.values() if is_good(one.success.mean())]
    texts = [f'{name} {Spread(one.contact).text(1)}' for name, one in found.items()]
    return Judgement(f'contact of twelve agents at varied speeds %: {Spread(without).text(1)} without the action; '
                     f'{", ".join(texts)}; judged by the costs at which {GOOD:g} % arrive', decide_all(*verdicts))
