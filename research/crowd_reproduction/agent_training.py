"""Training of the agent whose table a crowd uses: alone, first as in 4.1, then among several obstacles (4.3)."""
SETS = ('nearest', 'occupancy')
PARAMETERS = ('thesis', 'better')
SINGLE_EPISODES, FIELD_EPISODES = 2000, 4000
QUICK_EPISODES = 20
SINGLE_TABLE, TABLE = 'single.txt', 'q_table.txt'
DEMO_SEED = 1000  # is added to the seed of the training, so that the places differ from those of the training
DESCRIPTION = (
    f'One agent learns alone: {SINGLE_EPISODES:,} episodes with one obstacle between it and its goal (4.1), then '
    f'{FIELD_EPISODES:,} episodes among two to eight obstacles, some of which move (the thesis\'s "more thorough '
    'training", 4.3).')


def learn_single(setting, config, seed):
    """Returns the command of the first part, which writes SINGLE_TABLE."""
    return [setting.tool('train'), config, '--output', SINGLE_TABLE, '--seed', seed, '--episodes',
            setting.count(SINGLE_EPISODES, QUICK_EPISODES)]


def learn_field(setting, config, seed):
    """Returns the command of the second part, which continues from SINGLE_TABLE and writes TABLE."""
    return [setting.tool('train'), config, '--q-table', SINGLE_TABLE, '--output', TABLE, '--seed', seed, '--episodes',
            setting.count(FIELD_EPISODES, QUICK_EPISODES)]


def learn(setting, states, parameters, seed):
    """Returns the commands of both parts."""
    return [learn_single(setting, setting.config_file(f'agent_single_{states}_{parameters}'), seed),
            learn_field(setting, setting.config_file(f'agent_field_{states}_{parameters}'), seed)]


def walk(setting, table, seed):
    """Returns the first words of a command that runs scenarios with a table in demo mode."""
    return [setting.tool('evaluate'), '--q-table', table, '--threads', 1, '--seed', DEMO_SEED + seed]


def folder_of(setting, states, parameters, seed):
    """Returns the folder of the run that trains an agent."""
    return setting.run_folder('agents', f'{states}_{parameters}_{seed:02d}')
