"""One agent learns, many use its table: effect of the number of episodes that the pioneer learns before it shares."""
import numpy

from crowd_experiments import style
from crowd_experiments.pages import Chapter
from crowd_experiments.records import Spread, rates, read_csv
from crowd_experiments.runs import Run

from .. import agent_training

NAME = 'sharing'
TITLE = 'One agent learns, many use its table'
SETS = agent_training.SETS
CROWD = 'circle12'
SEEDS = 10
FIELD_EPISODES = (0, 10, 100, 1000, 4000)  # of the pioneer among several obstacles, after its training as in 4.1
QUICK_EPISODES = (0, 5)
DEMO_EPISODES = 50
FURTHER_EPISODES = 100  # in which all agents continue learning
JUDGED_EPISODES = 50  # the last of those
USES = {'fixed': 'unchanged table', 'own': 'all continue learning, own tables',
        'shared': 'all continue learning, one shared table'}
USE_COLOURS = {'fixed': '#0072b2', 'own': '#e69f00', 'shared': '#cc79a7'}
MEASURES = {'success': 0, 'collision': 2, 'contact': 1}


def episodes_of(setting):
    return setting.count(FIELD_EPISODES, QUICK_EPISODES)


def run_name(states, seed):
    return f'{states}_{seed:02d}'


def plan(setting):
    """Returns a run for each state set and seed."""
    return [make_run(setting, states, seed) for seed in setting.seeds(SEEDS) for states in SETS]


def make_run(setting, states, seed):
    """Returns a run that, for each number of episodes, trains a pioneer, evaluates a crowd with its table, and lets the
    crowd continue learning."""
    commands = [agent_training.learn(setting, seed, *agent_training.configs(setting, states, 'thesis'))[0]]
    for episodes in episodes_of(setting):
        table = agent_training.SINGLE_TABLE
        if episodes:
            table = f'pioneer_{episodes:05d}.txt'
            commands.append(agent_training.train(setting, setting.config_file(f'agent_field_{states}_thesis'), seed,
                                                 episodes, '--q-table', agent_training.SINGLE_TABLE, '--output', table))
        commands.append(agent_training.walk(setting, table, seed) + [
            '--episodes', setting.count(DEMO_EPISODES, 1), '--record', f'fixed_{episodes:05d}.csv',
            setting.scenario(CROWD)])
        for use in ('own', 'shared'):
            commands.append(agent_training.train(
                setting, setting.config_file(f'sharing_crowd_{states}'), seed, setting.count(FURTHER_EPISODES, 2),
                '--q-table', table, '--tables', use, '--output', f'{use}.txt', '--record', f'{use}_{episodes:05d}.csv'))
    return Run(setting.run_folder(NAME, run_name(states, seed)), commands, cost=6.0)


def report(setting):
    """Returns the chapter, from the runs' records."""
    chapter = Chapter(NAME, TITLE)
    chapter.add_text(
        f'A pioneer learns alone, in {agent_training.SINGLE_EPISODES:,} episodes with one obstacle (4.1), then in a '
        'varied number of episodes among several static and moving obstacles (4.3). Then twelve agents on a circle '
        'walk to the opposite points with its table. Either the table does not change, or all agents continue '
        f'learning, in own tables or in one, for {setting.count(FURTHER_EPISODES, 2)} episodes with an epsilon of '
        f"0.01, of which the last {JUDGED_EPISODES} are evaluated. The thesis's parameters, "
        f'{len(setting.seeds(SEEDS))} seeds.')
    curves = {(states, use): curve(setting, states, use) for states in SETS for use in USES}
    add_figure(chapter, setting, curves)
    add_table(chapter, setting, curves)
    return chapter


def curve(setting, states, use):
    """Returns an array (episodes, seeds, 3) of success, contact and collision [%]."""
    return numpy.array([[judged(setting.run_folder(NAME, run_name(states, seed)) / f'{use}_{episodes:05d}.csv')
                         for seed in setting.seeds(SEEDS)] for episodes in episodes_of(setting)])


def judged(file):
    record = read_csv(file)
    return rates(record, record['episode'] > record['episode'].max() - JUDGED_EPISODES)


def add_figure(chapter, setting, curves):
    figure, axes = style.new_figure(len(MEASURES), 2, 11, 9, sharex=True, sharey='row')
    places = range(len(episodes_of(setting)))
    for column, states in enumerate(SETS):
        for row, (measure, index) in enumerate(MEASURES.items()):
            panel = axes[row][column]
            for use, name in USES.items():
                values = curves[states, use][:, :, index]
                panel.plot(places, values.mean(axis=1), marker='o', color=USE_COLOURS[use], label=name)
                panel.fill_between(places, values.min(axis=1), values.max(axis=1), alpha=0.15, color=USE_COLOURS[use],
                                   linewidth=0)
            panel.set_title(f'{measure}, {style.SET_NAMES[states]}')
    for row, measure in enumerate(MEASURES):
        axes[row][0].set_ylabel(f'{measure} [% of the agents]')
        axes[row][0].set_ylim(0, 105)
    for panel in axes[-1]:
        panel.set_xticks(places, [f'{episodes:,}' for episodes in episodes_of(setting)])
        panel.set_xlabel('episodes among several obstacles before the pioneer shared')
    axes[0][1].legend(loc='lower right')
    chapter.add_figure(style.save(figure, setting.figure_file('sharing')),
                       'Success, collision and contact of a crowd of twelve agents against the number of training '
                       "episodes of the pioneer. Thesis's parameters. Lines: mean over the seeds; bands: lowest to "
                       'highest.')


def add_table(chapter, setting, curves):
    rows = []
    for states in SETS:
        for i, episodes in enumerate(episodes_of(setting)):
            rows.append([f"{style.SET_NAMES[states]}, thesis's parameters, {episodes:,} episodes among several "
                         'obstacles',
                         *(Spread(curves[states, use][i, :, index]).text(1) for use in USES
                           for index in MEASURES.values())])
    header = ['', *(f'{use}: {measure} %' for use in ('unchanged table', 'own tables', 'one table')
                    for measure in MEASURES)]
    chapter.add_table("A crowd of twelve agents with the pioneer's table: mean ± standard deviation over the seeds "
                      '(lowest-highest)', header, rows, name='sharing')
