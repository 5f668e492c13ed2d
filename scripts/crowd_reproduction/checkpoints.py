"""A record of learning: the tables that an agent's training leaves on its way, and what they walk."""
from . import agent_training

SAVE_EVERY, QUICK_SAVE_EVERY = 1000, 10
EPISODES = 40
SCENARIOS = {'training_field': 'one agent among obstacles', 'circle6': 'six on a circle'}


def every(setting):
    return setting.count(SAVE_EVERY, QUICK_SAVE_EVERY)


def episodes_of(setting):
    """The numbers of episodes among several obstacles after which the table is kept; 0: before them."""
    return range(0, setting.count(agent_training.FIELD_EPISODES, agent_training.QUICK_EPISODES) + 1, every(setting))


def table_after(episodes):
    """The table kept after so many."""
    return f'q_table_{episodes:06d}.txt' if episodes else agent_training.SINGLE_TABLE


def record_after(episodes):
    """How that table walked."""
    return f'checkpoint_{episodes:06d}.csv'


def saving(setting):
    """The option of `train` that keeps the tables."""
    return ['--save-every', every(setting)]


def walks(setting, seed):
    """The commands by which each of the tables walks the scenarios."""
    return [agent_training.walk(setting, table_after(episodes), seed) + [
        '--episodes', setting.count(EPISODES, 4), '--record', record_after(episodes),
        *map(setting.scenario, SCENARIOS)] for episodes in episodes_of(setting)]
