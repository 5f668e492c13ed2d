"""Checkpoints: the tables that are saved during an agent's training, and the scenarios that are run with them."""
from . import agent_training

SAVE_EVERY, QUICK_SAVE_EVERY = 1000, 10
EPISODES = 40
SCENARIOS = {'training_field': 'one agent among obstacles', 'circle6': 'six on a circle'}


def every(setting):
    return setting.count(SAVE_EVERY, QUICK_SAVE_EVERY)


def episodes_of(setting):
    """Returns the numbers of episodes among several obstacles after which the table is saved; 0: before them."""
    return range(0, setting.count(agent_training.FIELD_EPISODES, agent_training.QUICK_EPISODES) + 1, every(setting))


def table_after(episodes):
    """Returns the name of the table that is saved after this number of episodes."""
    return f'q_table_{episodes:06d}.txt' if episodes else agent_training.SINGLE_TABLE


def record_after(episodes):
    """Returns the name of the record of that table."""
    return f'checkpoint_{episodes:06d}.csv'


def saving(setting):
    """Returns the option of `train` that saves the tables."""
    return ['--save-every', every(setting)]


def walks(setting, seed):
    """Returns the commands that run the scenarios with each of the tables."""
    return [agent_training.walk(setting, table_after(episodes), seed) + [
        '--episodes', setting.count(EPISODES, 4), '--record', record_after(episodes),
        *map(setting.scenario, SCENARIOS)] for episodes in episodes_of(setting)]
