"""Judges the claims of sections 3 and 5: use of learned tables by other agents and in other scenarios, the effect of
more training, and the stay action."""
import numpy

from crowd_experiments.records import Spread, rates

from . import scenario_runs as runs, surroundings
from .claim import CONFIRMED, PARTLY, NOT_CONFIRMED, Judgement, decide_all, decide_each, decide_greater, versus
from .crowd_verdicts import GOOD, RARE, both, is_good, is_rare, rates_text, seeds
from .experiments import future_work, learning_curves, sharing
from .measures import share


def experience_serves(setting):
    verdicts, texts = [], []
    for scenario in runs.SCENARIOS:
        success, contact, collision = zip(*runs.measured(setting, runs.MAIN, scenario))
        verdicts.append(both((success, contact), (is_good, is_rare)))
        texts.append(f'{scenario} {numpy.mean(success):.0f} / {numpy.mean(contact):.0f} / {numpy.mean(collision):.0f}')
    fine = sum(verdict == CONFIRMED for verdict in verdicts)
    verdict = CONFIRMED if fine == len(verdicts) else PARTLY if fine else NOT_CONFIRMED
    return Judgement('success / contact / collision % in scenarios that were not used in training (means of '
                     f'{seeds(setting)}): {", ".join(texts)}; success at least {GOOD:g} and contact at most {RARE:g} '
                     f'in {fine} of {len(verdicts)}', verdict)


def shared(setting, use, episodes, measure):
    """Returns a measure of the crowd with a pioneer's table, for each seed."""
    place = list(sharing.episodes_of(setting)).index(episodes)
    return sharing.curve(setting, 'occupancy', use)[place, :, sharing.MEASURES[measure]]


def pioneer_serves(setting):
    first, last = sharing.episodes_of(setting)[0], sharing.episodes_of(setting)[-1]
    success, contact = (shared(setting, 'fixed', last, measure) for measure in ('success', 'contact'))
    untrained = shared(setting, 'fixed', first, 'contact')
    verdict = decide_all(decide_each(success, is_good), decide_greater(untrained, contact))
    return Judgement(f'twelve agents: success {Spread(success).text(1)} %; contact {Spread(contact).text(1)} %, after '
                     f'only the first part of the training {Spread(untrained).text(1)} %', verdict)


def crowd_learns_on(setting):
    last = sharing.episodes_of(setting)[-1]
    fixed, shared_on, own = (shared(setting, use, last, 'contact') for use in ('fixed', 'shared', 'own'))
    verdict = decide_all(decide_greater(fixed, shared_on), decide_greater(fixed, own))
    return Judgement(f'contact of twelve agents: {Spread(fixed).text(1)} % with the unchanged table, '
                     f'{Spread(shared_on).text(1)} % if all continue learning in one table, {Spread(own).text(1)} % in '
                     'own tables', verdict)


def incomplete_table(setting):
    texts, verdicts = [], []
    for scenario in runs.WATCHED:
        outcomes = surroundings.visits_measured(setting, runs.MAIN, scenario, surroundings.CROWDED)
        pairs = [(join(line[:2]), join(line[3:])) for line in outcomes]
        pairs = [pair for pair in pairs if numpy.isfinite(sum(pair))]
        rare, often = zip(*pairs)
        texts.append(f'{scenario}: ' + versus('rarely visited', rare, 'often visited', often, 1))
        verdicts.append(decide_greater(rare, often))
    return Judgement(f'{surroundings.CROWDED} or more sectors occupied, contact within {surroundings.SOON} decisions '
                     f'%, rows visited fewer than 10 and at least 100 times in training. {"; ".join(texts)}',
                     decide_all(*verdicts))


def join(outcomes):
    """Returns the share of contacts in several classes together [%]."""
    return share(sum(one.contacts for one in outcomes), sum(one.decisions for one in outcomes))


def more_training(setting):
    curve = learning_curves.Curve(setting, 'occupancy', 'thesis')
    texts, verdicts = [], []
    for scenario in learning_curves.SCENARIOS:
        for measure, index in learning_curves.MEASURES.items():
            first, last = curve.rates[scenario][1, :, index], curve.rates[scenario][-1, :, index]
            texts.append(f'{scenario}, {measure} %: after {curve.episodes[1]:,} episodes {Spread(first).text(1)}, '
                         f'after {curve.episodes[-1]:,} {Spread(last).text(1)}')
            verdicts.append(decide_greater(last, first) if measure == 'success' else decide_greater(first, last))
    return Judgement('; '.join(texts), decide_all(*verdicts))


def more_states(setting):
    curves = {states: learning_curves.Curve(setting, states, 'thesis') for states in learning_curves.SETS}
    shares = {states: 100.0 * curve.rows[-1] / curve.all_rows for states, curve in curves.items()}
    return Judgement('rows visited after all training, % of all rows: ' +
                     versus('set 1', shares['nearest'], 'set 2', shares['occupancy'], 1),
                     decide_greater(shares['nearest'], shares['occupancy']))


def any_number(setting):
    success, contact = zip(*((list(zip(*runs.measured(setting, runs.MAIN, scenario)))[:2])
                             for scenario in ('circle6', 'circle12')))
    return Judgement(f'one table, six: {rates_text(setting, "circle6")}; twelve: {rates_text(setting, "circle12")}',
                     decide_all(both(success, (is_good,) * 2), both(contact, (is_rare,) * 2)))


def future(setting, variation):
    """Returns success and contact [%] of a variation, a tuple for each seed."""
    return [rates(record)[:2] for record in future_work.records_of(setting, variation)]


def staying_pays(setting):
    (without, _), (free, _), (dear, _) = (list(zip(*future(setting, variation)))
                                          for variation in ('thesis', 'stay', 'stay_5'))
    return Judgement(f'success of twelve agents at varied speeds %: {Spread(without).text(1)} without the action, '
                     f'{Spread(free).text(1)} with the action at no cost, {Spread(dear).text(1)} at a cost of 5',
                     decide_all(decide_greater(without, free), decide_greater(dear, free)))


def staying_helps(setting):
    _, without = zip(*future(setting, 'thesis'))
    costs = {'no cost': 'stay', 'cost 0.2': 'stay_02', 'cost 1': 'stay_1', 'cost 5': 'stay_5'}
    texts, verdicts = [], []
    for name, variation in costs.items():
        success, contact = zip(*future(setting, variation))
        texts.append(f'{name} {Spread(contact).text(1)}')
        if is_good(numpy.mean(success)):  # an agent that stays forever has no contacts
            verdicts.append(decide_greater(without, contact))
    return Judgement(f'contact of twelve agents at varied speeds %: {Spread(without).text(1)} without the action; '
                     f'{", ".join(texts)}; judged by the costs at which {GOOD:g} % arrive', decide_all(*verdicts))
