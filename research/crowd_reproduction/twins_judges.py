"""Judges the claims of section 4.2: the situations that each state set distinguishes, and the twins tests."""
import numpy

from crowd_experiments.records import Spread, of_scenario

from . import twins_runs
from .claim import CONFIRMED, PARTLY, NOT_CONFIRMED, Judgement, decide_all, decide_greater, versus
from .crowd_verdicts import best_of, graded
from .experiments import ambiguity

TWINS = tuple(twins_runs.TESTS)


def same_row(setting):
    rows = {states: ambiguity.rows_of(setting, states) for states in twins_runs.SETS}
    holds = len(set(rows['nearest'])) == 1, len(set(rows['occupancy'])) == len(rows['occupancy'])
    return Judgement(f'rows of set 1: {rows["nearest"]}, of set 2: {rows["occupancy"]}',
                     (NOT_CONFIRMED, PARTLY, CONFIRMED)[sum(holds)])


def clean_shares(setting, agent, test):
    """Returns the share of the episodes [%] in which the agent arrives without a collision, for each seed."""
    return [100.0 * float(numpy.mean((record['arrived'] > 0)[rows] & (record['collided'] == 0)[rows]))
            for record in twins_runs.records_of(setting, agent) for rows in [of_scenario(record, test)]]


SET_1 = ('single', 'nearest', 'thesis')


def alone_behaves(setting):
    values = clean_shares(setting, SET_1, twins_runs.ALONE)
    return Judgement(f'set 1 arrives without a collision in {Spread(values).text(1)} % of the episodes',
                     graded(values))


def two_confuse(setting):
    alone = clean_shares(setting, SET_1, twins_runs.ALONE)
    two = numpy.mean([clean_shares(setting, SET_1, test) for test in TWINS], axis=0)
    return Judgement('set 1, episodes with arrival and without a collision %: '
                     + versus('one obstacle perceived', alone, 'two', two, 1), decide_greater(alone, two))


def set_2(training):
    return training, 'occupancy', 'thesis'


def handles(test):
    """Judges whether set 2 handles a test, which means that it arrives without a collision."""
    def judge(setting):
        values = {training: clean_shares(setting, set_2(training), test) for training in twins_runs.TRAININGS}
        text = '; '.join(f'{twins_runs.TRAININGS[training]}: {Spread(of_seeds).text(1)} %'
                         for training, of_seeds in values.items())
        better = Spread(clean_shares(setting, ('field', 'occupancy', 'better'), test)).text(1)
        return Judgement(f'arrives without a collision, {text}; better parameters, {twins_runs.TRAININGS["field"]}: '
                         f'{better} %', best_of(map(graded, values.values())))
    return judge


def second_set_is_better(setting):
    texts, verdicts = [], []
    for training, name in twins_runs.TRAININGS.items():
        first, second = (numpy.mean([clean_shares(setting, (training, states, 'thesis'), test) for test in TWINS],
                                    axis=0) for states in twins_runs.SETS)
        texts.append(f'{name}: ' + versus('set 2', second, 'set 1', first, 1))
        verdicts.append(decide_greater(second, first))
    return Judgement(f'all four tests, episodes with arrival and without a collision %. {"; ".join(texts)}',
                     decide_all(*verdicts))


def squeezes(setting):
    texts, verdicts = [], []
    for training, name in twins_runs.TRAININGS.items():
        between, around = ambiguity.passages(setting, set_2(training))
        texts.append(f'{name}: between {Spread(between).text(1)} %, around {Spread(around).text(1)} %')
        verdicts.append(graded(between))
    return Judgement(f'episodes of test d in which the agent passes: {"; ".join(texts)}', best_of(verdicts))


def takes_longer(setting):
    texts, verdicts = [], []
    for training, name in twins_runs.TRAININGS.items():
        needed = {test: numpy.array(ambiguity.decisions_needed(setting, set_2(training), test)) for test in TWINS}
        others = [numpy.nanmean(line) if numpy.isfinite(line).any() else numpy.nan
                  for line in numpy.transpose([needed[test] for test in TWINS[:3]])]
        pairs = [(tight, other) for tight, other in zip(needed['twins_d'], others) if numpy.isfinite(tight + other)]
        if pairs:
            verdicts.append(decide_greater(*zip(*pairs)))
            texts.append(f'{name}: ' + versus('d', [a for a, _ in pairs], 'a to c', [b for _, b in pairs], 0))
        else:
            texts.append(f'{name}: no seed arrives in d and in another test')
    return Judgement(f'decisions of the agents that arrive. {"; ".join(texts)}',
                     decide_all(*verdicts) if verdicts else NOT_CONFIRMED)
