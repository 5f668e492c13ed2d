"""Judges the claims of sections 3 and 5: use of learned tables by other agents and in other scenarios, the effect of
more training, and the stay action."""
import numpy
from crowd_experiments.records import Spread, rates

from . import scenario_runs as runs, surroundings
from .claim import (CONFIRMED, GOOD, NOT_CONFIRMED, PARTLY, RARE, Judgement, both, compared, decide_all, decide_each,
                    decide_greater, is_good, is_rare, joined)
from .crowd_judges import rates_of, rates_text
from .experiments import future_work, learning_curves, sharing
from .measures import share

COSTS = {'no cost': 'stay', 'cost 0.2': 'stay_02', 'cost 1': 'stay_1', 'cost 5': 'stay_5'}


def experience_serves(setting):
    verdicts, texts = [], []
    for scenario in runs.SCENARIOS:
        found = rates_of(setting, scenario)
        verdicts.append(both(found[:2], (is_good, is_rare)))
        texts.append(f'{scenario} {" / ".join(f"{numpy.mean(values):.0f}" for values in found)}')
    fine = verdicts.count(CONFIRMED)
    return Judgement('success / contact / collision % in scenarios that were not used in training (means of '
                     f'{len(setting.seeds(runs.SEEDS))} seeds): {", ".join(texts)}; success at least {GOOD:g} and '
                     f'contact at most {RARE:g} in {fine} of {len(verdicts)}',
                     CONFIRMED if fine == len(verdicts) else PARTLY if fine else NOT_CONFIRMED)


def shared(setting, use, place, measure='contact'):
    """Returns a measure of the crowd with a pioneer's table, for each seed; place: of the number of episodes."""
    return sharing.curve(setting, 'occupancy', use)[place, :, sharing.MEASURES[measure]]


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
    for scenario in runs.WATCHED:
        outcomes = surroundings.visits_measured(setting, runs.MAIN, scenario, surroundings.CROWDED)
        pairs = [(join(line[:2]), join(line[3:])) for line in outcomes]
        rare, often = zip(*(pair for pair in pairs if numpy.isfinite(sum(pair))))
        parts.append(compared(f'{scenario}: ', 'rarely visited', rare, 'often visited', often, 1))
    return joined(parts, '; ', f'{surroundings.CROWDED} or more sectors occupied, contact within {surroundings.SOON} '
                  'decisions %, rows visited fewer than 10 and at least 100 times in training. ')


def join(outcomes):
    """Returns the share of contacts in several classes together [%]."""
    return share(sum(one.contacts for one in outcomes), sum(one.decisions for one in outcomes))


def more_training(setting):
    curve = learning_curves.Curve(setting, 'occupancy', 'thesis')
    parts = []
    for scenario in learning_curves.SCENARIOS:
        for measure, index in learning_curves.MEASURES.items():
            first, last = curve.rates[scenario][1, :, index], curve.rates[scenario][-1, :, index]
            parts.append(Judgement(
                f'{scenario}, {measure} %: after {curve.episodes[1]:,} episodes {Spread(first).text(1)}, after '
                f'{curve.episodes[-1]:,} {Spread(last).text(1)}',
                decide_greater(last, first) if measure == 'success' else decide_greater(first, last)))
    return joined(parts, '; ')


def more_states(setting):
    first, second = (100.0 * curve.rows[-1] / curve.all_rows for curve in
                     (learning_curves.Curve(setting, states, 'thesis') for states in learning_curves.SETS))
    return compared('rows visited after all training, % of all rows: ', 'set 1', first, 'set 2', second, 1)


def any_number(setting):
    success, contact = zip(*(rates_of(setting, scenario)[:2] for scenario in ('circle6', 'circle12')))
    return Judgement(f'one table, six: {rates_text(setting, "circle6")}; twelve: {rates_text(setting, "circle12")}',
                     decide_all(both(success, (is_good,) * 2), both(contact, (is_rare,) * 2)))


def future(setting, variation):
    """Returns success and contact [%] of a variation, each with a value for each seed."""
    return list(zip(*map(rates, future_work.records_of(setting, variation))))[:2]


def staying_pays(setting):
    without, free, dear = (future(setting, variation)[0] for variation in ('thesis', 'stay', 'stay_5'))
    return Judgement(f'success of twelve agents at varied speeds %: {Spread(without).text(1)} without the action, '
                     f'{Spread(free).text(1)} with the action at no cost, {Spread(dear).text(1)} at a cost of 5',
                     decide_all(decide_greater(without, free), decide_greater(dear, free)))


def staying_helps(setting):
    _, without = future(setting, 'thesis')
    found = {name: future(setting, variation) for name, variation in COSTS.items()}
    # An agent that stays forever has no contacts.
    verdicts = [decide_greater(without, contact) for success, contact in found.values() if is_good(numpy.mean(success))]
    texts = [f'{name} {Spread(contact).text(1)}' for name, (_, contact) in found.items()]
    return Judgement(f'contact of twelve agents at varied speeds %: {Spread(without).text(1)} without the action; '
                     f'{", ".join(texts)}; judged by the costs at which {GOOD:g} % arrive', decide_all(*verdicts))
