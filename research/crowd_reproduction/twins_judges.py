"""Judges the claims of section 4.2: the situations that each state set distinguishes, and the twins tests."""
import numpy
from crowd_experiments.records import Spread, of_scenario

from . import twins_runs
from .claim import NOT_CONFIRMED, VERDICTS, Judgement, best_of, compared, decide_all, graded, joined
from .experiments import ambiguity

TWINS = tuple(twins_runs.TESTS)
SET_1 = ('single', 'nearest', 'thesis')
TRAININGS = twins_runs.TRAININGS


def same_row(setting):
    first, second = (ambiguity.rows_of(setting, states) for states in twins_runs.SETS)
    return Judgement(f'rows of set 1: {first}, of set 2: {second}',
                     VERDICTS[2 - int(len(set(first)) == 1) - int(len(set(second)) == len(second))])


def clean_shares(setting, agent, test):
    """Returns the share of the episodes [%] in which the agent arrives without a collision, for each seed."""
    return [100.0 * float(numpy.mean((record['arrived'] > 0)[rows] & (record['collided'] == 0)[rows]))
            for record in twins_runs.records_of(setting, agent) for rows in [of_scenario(record, test)]]


def of_all_tests(setting, agent):
    """Returns the means of clean_shares() over the four tests."""
    return numpy.mean([clean_shares(setting, agent, test) for test in TWINS], axis=0)


def alone_behaves(setting):
    values = clean_shares(setting, SET_1, twins_runs.ALONE)
    return Judgement(f'set 1 arrives without a collision in {Spread(values).text(1)} % of the episodes', graded(values))


def two_confuse(setting):
    return compared('set 1, episodes with arrival and without a collision %: ', 'one obstacle perceived',
                    clean_shares(setting, SET_1, twins_runs.ALONE), 'two', of_all_tests(setting, SET_1), 1)


def handles(setting, test):
    """Judges whether set 2 handles a test, which means that it arrives without a collision."""
    values = {name: clean_shares(setting, (training, 'occupancy', 'thesis'), test)
              for training, name in TRAININGS.items()}
    text = '; '.join(f'{name}: {Spread(of_seeds).text(1)} %' for name, of_seeds in values.items())
    better = Spread(clean_shares(setting, ('field', 'occupancy', 'better'), test)).text(1)
    return Judgement(f'arrives without a collision, {text}; better parameters, {TRAININGS["field"]}: {better} %',
                     best_of(map(graded, values.values())))


def second_set_is_better(setting):
    parts = []
    for training, name in TRAININGS.items():
        first, second = (of_all_tests(setting, (training, states, 'thesis')) for states in twins_runs.SETS)
        parts.append(compared(f'{name}: ', 'set 2', second, 'set 1', first, 1))
    return joined(parts, '; ', 'all four tests, episodes with arrival and without a collision %. ')


def squeezes(setting):
    found = {name: ambiguity.passages(setting, (training, 'occupancy', 'thesis'))
             for training, name in TRAININGS.items()}
    texts = [f'{name}: between {Spread(between).text(1)} %, around {Spread(around).text(1)} %'
             for name, (between, around) in found.items()]
    return Judgement(f'episodes of test d in which the agent passes: {"; ".join(texts)}',
                     best_of(graded(between) for between, _ in found.values()))


def takes_longer(setting):
    texts, verdicts = [], []
    for training, name in TRAININGS.items():
        agent = training, 'occupancy', 'thesis'
        *others, tight = (ambiguity.decisions_needed(setting, agent, test) for test in TWINS)
        others = [numpy.nanmean(line) if numpy.isfinite(line).any() else numpy.nan for line in numpy.transpose(others)]
        pairs = [pair for pair in zip(tight, others) if numpy.isfinite(sum(pair))]
        if pairs:
            found = compared(f'{name}: ', 'd', next(zip(*pairs)), 'a to c', [other for _, other in pairs], 0)
            texts.append(found.measured)
            verdicts.append(found.verdict)
        else:
            texts.append(f'{name}: no seed arrives in d and in another test')
    return Judgement(f'decisions of the agents that arrive. {"; ".join(texts)}',
                     decide_all(*verdicts) if verdicts else NOT_CONFIRMED)
