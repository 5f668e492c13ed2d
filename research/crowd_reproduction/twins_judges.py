"""Judges the claims of section 4.2: the situations that each state set distinguishes, and the twins tests."""
import numpy
from crowd_experiments.records import Spread

from .claim import NOT_CONFIRMED, VERDICTS, Judgement, best_of, compared, decide_all, graded, joined
from .results import SETS
from .twins import ALONE, TESTS, TRAININGS, Agent, mean_of_finite, rows_of


def same_row(setting):
    first, second = (rows_of(setting, states) for states in SETS)
    return Judgement(f'rows of set 1: {first}, of set 2: {second}',
                     VERDICTS[2 - int(len(set(first)) == 1) - int(len(set(second)) == len(second))])


def alone_behaves(setting):
    values = Agent(setting, 'single', 'nearest').clean_shares(ALONE)
    return Judgement(f'set 1 arrives without a collision in {Spread(values).text(1)} % of the episodes', graded(values))


def two_confuse(setting):
    agent = Agent(setting, 'single', 'nearest')
    return compared('set 1, episodes with arrival and without a collision %: ', 'one obstacle perceived',
                    agent.clean_shares(ALONE), 'two', agent.clean_shares(*TESTS), 1)


def handles(setting, test):
    """Judges whether set 2 handles a test, which means that it arrives without a collision."""
    values = {name: Agent(setting, training, 'occupancy').clean_shares(test) for training, name in TRAININGS.items()}
    text = '; '.join(f'{name}: {Spread(of_seeds).text(1)} %' for name, of_seeds in values.items())
    better = Spread(Agent(setting, 'field', 'occupancy', 'better').clean_shares(test)).text(1)
    return Judgement(f'arrives without a collision, {text}; better parameters, {TRAININGS["field"]}: {better} %',
                     best_of(map(graded, values.values())))


def second_set_is_better(setting):
    parts = []
    for training, name in TRAININGS.items():
        first, second = (Agent(setting, training, states).clean_shares(*TESTS) for states in SETS)
        parts.append(compared(f'{name}: ', 'set 2', second, 'set 1', first, 1))
    return joined(parts, '; ', 'all four tests, episodes with arrival and without a collision %. ')


def squeezes(setting):
    found = {name: Agent(setting, training, 'occupancy').passages() for training, name in TRAININGS.items()}
    texts = [f'{name}: between {Spread(between).text(1)} %, around {Spread(around).text(1)} %'
             for name, (between, around) in found.items()]
    return Judgement(f'episodes of test d in which the agent passes: {"; ".join(texts)}',
                     best_of(graded(between) for between, _ in found.values()))


def takes_longer(setting):
    texts, verdicts = [], []
    for training, name in TRAININGS.items():
        *others, tight = (Agent(setting, training, 'occupancy').arrivals(test, 'ticks') for test in TESTS)
        pairs = [pair for pair in zip(tight, mean_of_finite(others)) if numpy.isfinite(sum(pair))]
        if pairs:
            found = compared(f'{name}: ', 'd', next(zip(*pairs)), 'a to c', [other for _, other in pairs], 0)
            texts.append(found.measured)
            verdicts.append(found.verdict)
        else:
            texts.append(f'{name}: no seed arrives in d and in another test')
    return Judgement(f'decisions of the agents that arrive. {"; ".join(texts)}',
                     decide_all(*verdicts) if verdicts else NOT_CONFIRMED)
