"""The runs of the twins tests, and functions that read their results."""
import functools

from crowd_experiments.records import of_scenario, rates, read_csv
from crowd_experiments.runs import Run

from . import agent_training

NAME = 'ambiguity'
SETS = agent_training.SETS
PARAMETERS = agent_training.PARAMETERS
SCENES = {'same_state_a': 'a: one obstacle', 'same_state_b': 'b: a wide obstacle', 'same_state_c': 'c: two obstacles'}
TESTS = {'twins_a': 'a: overlapping', 'twins_b': 'b: close', 'twins_c': 'c: gap too small', 'twins_d': 'd: tight gap'}
ALONE = 'twins_apart'  # the agent perceives only one of the two obstacles
TRAININGS = {'single': 'trained as in 4.1', 'field': 'trained further among several obstacles',
             'twins': 'trained on the tests'}
TABLES = {'single': agent_training.SINGLE_TABLE, 'field': agent_training.TABLE, 'twins': agent_training.TABLE}
SEEDS = 10
EPISODES = 100
WALKED = 10  # number of episodes that are recorded to be drawn
TWINS_EPISODES = 4000


def plan(setting):
    """Returns a run for each state set, set of parameters and seed, trained on the tests."""
    return [make_run(setting, states, parameters, seed) for seed in setting.seeds(SEEDS) for states in SETS
            for parameters in PARAMETERS]


def make_run(setting, states, parameters, seed):
    """Returns a run that trains on the tests, then runs them."""
    return Run(folder_of(setting, ('twins', states, parameters), seed), [
        agent_training.train(setting, setting.config_file(f'twins_{states}_{parameters}'), seed,
                             setting.count(TWINS_EPISODES, 40), '--output', agent_training.TABLE),
        *walks(setting, 'twins', seed)], cost=1.0)


def agent_walks(setting, seed):
    """Returns the commands for the tables of an agent that was not trained on the tests; with the first seed also
    those that record its perception in the scenes of figure 4.13."""
    commands = walks(setting, 'single', seed) + walks(setting, 'field', seed)
    if seed == 1:
        commands.append(agent_training.walk(setting, agent_training.SINGLE_TABLE, seed) + [
            '--episodes', 1, '--states', 'scenes', *map(setting.scenario, SCENES)])
    return commands


def walks(setting, training, seed):
    """Returns the commands that record all tests, and some trajectories to be drawn."""
    walk = agent_training.walk(setting, TABLES[training], seed)
    tests = [*map(setting.scenario, [*TESTS, ALONE])]
    return [walk + ['--episodes', setting.count(EPISODES, 5), '--record', f'tests_{training}.csv', *tests],
            walk + ['--episodes', setting.count(WALKED, 2), '--scenes', f'tests_{training}', '--trajectories',
                    f'tests_{training}', *tests]]


def folder_of(setting, agent, seed):
    """Returns the folder of the table of an agent: training, state set and parameters."""
    training, states, parameters = agent
    if training == 'twins':
        return setting.run_folder(NAME, f'{states}_{parameters}_{seed:02d}')
    return agent_training.folder_of(setting, states, parameters, seed)


def drawn_folder(setting, agent, seed):
    """Returns the folder of the trajectories to be drawn, and of their scenes."""
    return folder_of(setting, agent, seed) / f'tests_{agent[0]}'


@functools.lru_cache(maxsize=None)
def records_of(setting, agent):
    """Returns the records of an agent in all tests, of all seeds."""
    return [read_csv(folder_of(setting, agent, seed) / f'tests_{agent[0]}.csv') for seed in setting.seeds(SEEDS)]


def measured(setting, agent, test):
    """Returns success, contact and collision [%], a tuple for each seed."""
    return [rates(record, of_scenario(record, test)) for record in records_of(setting, agent)]
