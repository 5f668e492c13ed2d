"""The twins tests (4.2): what agents of several trainings did in them, and the judges of the claims about it."""
import numpy
import pandas
from crowd_experiments.records import Spread, percent

from .claim import Judgement, NOT_CONFIRMED, VERDICTS, compared, decide_all, graded, joined, number_text
from .measures import crossing
from .declared import BETTER, SETS, THESIS
from .results import Runs

SCENES = {'same_state_a': 'a: one obstacle', 'same_state_b': 'b: a wide obstacle', 'same_state_c': 'c: two obstacles'}
TESTS = {'twins_a': 'a: overlapping', 'twins_b': 'b: close', 'twins_c': 'c: gap too small', 'twins_d': 'd: tight gap'}
ALONE = 'twins_apart'  # the agent perceives only one of the two obstacles
TRAININGS = {'single': 'trained as in 4.1', 'field': 'trained further among several obstacles',
             'twins': 'trained on the tests'}
HALF_GAP = 0.95  # [m] of test d: distance of the obstacles' centres from the straight line to the goal


class Agent:
    """The agents of all seeds of a training, with their results in the tests."""

    def __init__(self, setting, training, states, parameters=THESIS):
        self.runs = Runs.of(setting, 'twins' if training == 'twins' else 'agents', states=states, parameters=parameters)
        self.tests, self.file = f'tests_{training}', f'tests_{training}.csv'
        self.table = 'single.txt' if training == 'single' else 'q_table.txt'

    def clean_shares(self, *tests):
        """Returns the share of episodes [%] with an arrival and without a collision of each seed; of tests the mean."""
        of_tests = [record.eval('arrived > 0 and collided == 0').groupby(record['seed']).mean()
                    for record in (self.runs.record(self.file, test) for test in tests)]
        return 100.0 * sum(of_tests) / len(of_tests)

    def passages(self):
        """Returns the shares [%] of episodes of test d that pass between the obstacles, and around, for all seeds."""
        shares = []
        for seed in self.runs.seeds():
            places = [crossing(track[:, 0], 0.0)
                      for track in self.runs.tracks(seed, f'{self.tests}/twins_d.csv').values()]
            shares.append([percent([place is not None and (abs(place) < HALF_GAP) == between for place in places])
                           for between in (True, False)])
        return tuple(zip(*shares))


def first_decision(setting, scene, states):
    """Returns the first decision in a scene of figure 4.13; its row of the Q-table depends only on the state set."""
    return Agent(setting, 'single', states).runs.decisions(1, scene, 'scenes').iloc[0]


def rows_of(setting, states):
    return [int(first_decision(setting, scene, states)['row']) for scene in SCENES]


def same_row(setting):
    first, second = (rows_of(setting, states) for states in SETS)
    return Judgement(f'rows of set 1: {first}, of set 2: {second}',
                     VERDICTS[2 - int(len(set(first)) == 1) - int(len(set(second)) == len(second))],
                     f'{len(set(first))} row of set 1, {len(set(second))} of set 2')


def alone_behaves(setting):
    values = Agent(setting, 'single', 'nearest').clean_shares(ALONE)
    return Judgement(f'set 1 arrives without a collision in {Spread(values).text(1)} % of the episodes', graded(values),
                     number_text(values))


def two_confuse(setting):
    agent = Agent(setting, 'single', 'nearest')
    return compared('set 1, episodes with arrival and without a collision %: ', 'one obstacle perceived',
                    agent.clean_shares(ALONE), 'two', agent.clean_shares(*TESTS), 1)


def handles(setting, test):
    """Judges whether set 2 handles a test, which means that it arrives without a collision. The same training counts
    in all tests: that of 4.1, because 4.3 fills the states with several obstacles only afterwards."""
    values = {name: Agent(setting, training, 'occupancy').clean_shares(test) for training, name in TRAININGS.items()}
    text = '; '.join(f'{name}: {Spread(of_seeds).text(1)} %' for name, of_seeds in values.items())
    better = Spread(Agent(setting, 'field', 'occupancy', BETTER).clean_shares(test)).text(1)
    return Judgement(f'arrives without a collision, {text}; better parameters, {TRAININGS["field"]}: {better} %',
                     graded(values[TRAININGS['single']]), number_text(values[TRAININGS['single']]))


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
    between = found[TRAININGS['single']][0]
    clean = Agent(setting, 'single', 'occupancy').clean_shares('twins_d')
    return Judgement(f'episodes of test d in which the agent passes: {"; ".join(texts)}; {TRAININGS["single"]}, it '
                     f'arrives without a collision in {Spread(clean).text(1)} %',
                     decide_all(graded(between), graded(clean)), f'between {number_text(between)}')


def takes_longer(setting):
    texts, judged = [], Judgement('', NOT_CONFIRMED)
    for training, name in TRAININGS.items():
        agent = Agent(setting, training, 'occupancy')
        *others, tight = (agent.runs.arrivals(agent.file, 'ticks', test) for test in TESTS)
        pairs = [pair for pair in zip(tight, pandas.DataFrame(others).mean()) if numpy.isfinite(sum(pair))]
        if pairs:
            found = compared(f'{name}: ', 'd', next(zip(*pairs)), 'a to c', [other for _, other in pairs], 0)
            texts.append(found.measured)
            judged = found if training == 'single' else judged
        else:
            texts.append(f'{name}: no seed arrives in d and in another test')
    return Judgement(f'decisions of the agents that arrive. {"; ".join(texts)}', judged.verdict, judged.number)
