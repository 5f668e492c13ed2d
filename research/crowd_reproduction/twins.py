"""The twins tests (4.2): what agents of several trainings did in them."""
import numpy
from crowd_experiments.records import percent

from .measures import crossing
from .results import Runs

SCENES = {'same_state_a': 'a: one obstacle', 'same_state_b': 'b: a wide obstacle', 'same_state_c': 'c: two obstacles'}
TESTS = {'twins_a': 'a: overlapping', 'twins_b': 'b: close', 'twins_c': 'c: gap too small', 'twins_d': 'd: tight gap'}
ALONE = 'twins_apart'  # the agent perceives only one of the two obstacles
TRAININGS = {'single': 'trained as in 4.1', 'field': 'trained further among several obstacles',
             'twins': 'trained on the tests'}
HALF_GAP = 0.95  # [m] of test d: distance of the obstacles' centres from the straight line to the goal


class Agent:
    """The agents of all seeds of a training, with their results in the tests."""

    def __init__(self, setting, training, states, parameters='thesis'):
        self.runs = Runs.of(setting, 'twins' if training == 'twins' else 'agents', states=states, parameters=parameters)
        self.tests = f'tests_{training}'
        self.table = 'single.txt' if training == 'single' else 'q_table.txt'

    def record(self, test):
        """Returns the record of all seeds in a test."""
        return self.runs.record(f'{self.tests}.csv', test)

    def rates(self, test):
        """Returns the rates of the seeds in a test."""
        return self.runs.rates(f'{self.tests}.csv', test)

    def arrivals(self, test, column):
        """Returns the median of a column over the arrivals in a test, for each seed; nan without arrivals."""
        return self.runs.arrivals(f'{self.tests}.csv', column, test)

    def clean_shares(self, *tests):
        """Returns the share of episodes [%] with an arrival and without a collision of each seed; of tests the mean."""
        of_tests = [self.record(test).eval('arrived > 0 and collided == 0').groupby(self.record(test)['seed']).mean()
                    for test in tests]
        return 100.0 * sum(of_tests) / len(of_tests)

    def drawn(self, seed):
        """Returns the folder of the trajectories to be drawn, and of their scenes."""
        return self.runs.folder(seed) / self.tests

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
    """Returns the rows of the three scenes of figure 4.13."""
    return [int(first_decision(setting, scene, states)['row']) for scene in SCENES]


def mean_of_finite(values):
    """Returns the means of columns over the finite values; nan if there are none."""
    return [numpy.nanmean(line) if numpy.isfinite(line).any() else numpy.nan for line in numpy.transpose(values)]
