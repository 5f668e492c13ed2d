"""Training of the agent whose table a crowd uses: alone, first as in 4.1, then among several obstacles (4.3).

Tables that are saved meanwhile (checkpoints) are evaluated, too."""
SETS = ('nearest', 'occupancy')
PARAMETERS = ('thesis', 'better')
SEEDS = 10
SINGLE_EPISODES, FIELD_EPISODES = 2000, 4000
QUICK_EPISODES = 20
SINGLE_TABLE, TABLE = 'single.txt', 'q_table.txt'
DEMO_SEED = 1000  # is added to the seed of the training, so that the places differ from those of the training
DESCRIPTION = (
    f'One agent learns alone: {SINGLE_EPISODES:,} episodes with one obstacle between it and its goal (4.1), then '
    f'{FIELD_EPISODES:,} episodes among two to eight obstacles, some of which move (the thesis\'s "more thorough '
    'training", 4.3).')
SAVE_EVERY, QUICK_SAVE_EVERY = 1000, 10
CHECKED_EPISODES = 40  # in which a checkpoint is evaluated
CHECKED = {'training_field': 'one agent among obstacles', 'circle6': 'six on a circle'}  # scenarios


def train(setting, config, seed, episodes, *words):
    """Returns a command that trains, with further words."""
    return [setting.tool('train'), config, *words, '--seed', seed, '--episodes', episodes]


def learn(setting, seed, single, field):
    """Returns the commands of both parts, with their configurations; the second continues from the table of the first
    one."""
    return [train(setting, single, seed, setting.count(SINGLE_EPISODES, QUICK_EPISODES), '--output', SINGLE_TABLE),
            train(setting, field, seed, setting.count(FIELD_EPISODES, QUICK_EPISODES), '--q-table', SINGLE_TABLE,
                  '--output', TABLE)]


def configs(setting, states, parameters):
    """Returns the configurations of both parts."""
    return [setting.config_file(f'agent_{part}_{states}_{parameters}') for part in ('single', 'field')]


def walk(setting, table, seed):
    """Returns the first words of a command that runs scenarios with a table in demo mode."""
    return [setting.tool('evaluate'), '--q-table', table, '--threads', 1, '--seed', DEMO_SEED + seed]


def folder_of(setting, states, parameters, seed):
    """Returns the folder of the run that trains an agent."""
    return setting.run_folder('agents', f'{states}_{parameters}_{seed:02d}')


def save_every(setting):
    """Returns the number of episodes between two checkpoints."""
    return setting.count(SAVE_EVERY, QUICK_SAVE_EVERY)


def checkpoints(setting):
    """Returns the numbers of episodes among several obstacles after which the table is saved; 0: before them."""
    return range(0, setting.count(FIELD_EPISODES, QUICK_EPISODES) + 1, save_every(setting))


def table_after(episodes):
    """Returns the name of the table that is saved after this number of episodes."""
    return f'q_table_{episodes:06d}.txt' if episodes else SINGLE_TABLE


def record_after(episodes):
    """Returns the name of the record of that table."""
    return f'checkpoint_{episodes:06d}.csv'


def checkpoint_walks(setting, seed):
    """Returns the commands that run the scenarios with each of the tables."""
    return [walk(setting, table_after(episodes), seed) + [
        '--episodes', setting.count(CHECKED_EPISODES, 4), '--record', record_after(episodes),
        *map(setting.scenario, CHECKED)] for episodes in checkpoints(setting)]
