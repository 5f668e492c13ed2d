"""The runs of the twins tests, and what they left."""
import functools

from crowd_experiments.records import of_scenario, rates, read_csv
from crowd_experiments.runs import Run

from . import agent_training

NAME = 'ambiguity'
SETS = agent_training.SETS
PARAMETERS = agent_training.PARAMETERS
SCENES = {'same_state_a': 'a: one obstacle', 'same_state_b': 'b: a wide obstacle', 'same_state_c': 'c: two obstacles'}
TESTS = {'twins_a': 'a: overlapping', 'twins_b': 'b: close', 'twins_c': 'c: gap too small', 'twins_d': 'd: tight gap'}
ALONE = 'twins_apart'  # only one of the two comes into sight
TRAININGS = {'single': 'trained as in 4.1', 'field': 'trained further among several obstacles',
             'twins': 'trained on the tests'}
TABLES = {'single': agent_training.SINGLE_TABLE, 'field': agent_training.TABLE, 'twins': agent_training.TABLE}
SEEDS = 10
EPISODES = 100
WALKED = 10  # of them are recorded to be drawn
TWINS_EPISODES = 4000


def plan(setting):
    """A run for each state set, set of parameters and seed, trained on the tests."""
    return [make_run(setting, states, parameters, seed) for seed in setting.seeds(SEEDS) for states in SETS
            for parameters in PARAMETERS]


def make_run(setting, states, parameters, seed):
    """Trains on the tests, then walks them."""
    return Run(folder_of(setting, ('twins', states, parameters), seed), [
        [setting.tool('train'), setting.config_file(f'twins_{states}_{parameters}'), '--output', agent_training.TABLE,
         '--seed', seed, '--episodes', setting.count(TWINS_EPISODES, 40)], *walks(setting, 'twins', seed)], cost=1.0)


def agent_walks(setting, seed):
    """What the tables of an agent that was not trained on the tests walk, and, with the first seed, what it sees in the
    scenes of figure 4.13."""
    commands = walks(setting, 'single', seed) + walks(setting, 'field', seed)
    if seed == 1:
        commands.append(agent_training.walk(setting, agent_training.SINGLE_TABLE, seed) + [
            '--episodes', 1, '--states', 'scenes', *map(setting.scenario, SCENES)])
    return commands


def walks(setting, training, seed):
    """The tests, all of them into a record, and some to be drawn."""
    walk = agent_training.walk(setting, TABLES[training], seed)
    tests = [*map(setting.scenario, [*TESTS, ALONE])]
    return [walk + ['--episodes', setting.count(EPISODES, 5), '--record', f'tests_{training}.csv', *tests],
            walk + ['--episodes', setting.count(WALKED, 2), '--scenes', f'tests_{training}', '--trajectories',
                    f'tests_{training}', *tests]]


def folder_of(setting, agent, seed):
    """Where the table of an agent lies: training, state set and parameters."""
    training, states, parameters = agent
    if training == 'twins':
        return setting.run_folder(NAME, f'{states}_{parameters}_{seed:02d}')
    return agent_training.folder_of(setting, states, parameters, seed)


def table_of(setting, agent, seed):
    """The Q-table of an agent."""
    return folder_of(setting, agent, seed) / TABLES[agent[0]]


def drawn_folder(setting, agent, seed):
    """Where the walks to be drawn, and their scenes, are."""
    return folder_of(setting, agent, seed) / f'tests_{agent[0]}'


@functools.lru_cache(maxsize=None)
def record_of(setting, agent, seed):
    """How an agent fared in all tests."""
    return read_csv(folder_of(setting, agent, seed) / f'tests_{agent[0]}.csv')


def records_of(setting, agent):
    """Of all seeds."""
    return [record_of(setting, agent, seed) for seed in setting.seeds(SEEDS)]


def measured(setting, agent, test):
    """Success, contact and collision [%], a tuple for each seed."""
    return [rates(record, of_scenario(record, test)) for record in records_of(setting, agent)]
