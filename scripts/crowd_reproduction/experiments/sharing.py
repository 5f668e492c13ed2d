"""One agent learns, many use what it learned: how long is the pioneer to learn before it shares?"""
import numpy

from crowd_experiments import style
from crowd_experiments.chapter import Chapter
from crowd_experiments.records import Spread, rates, read_csv
from crowd_experiments.runs import Run

from .. import agent_training

NAME = 'sharing'
TITLE = 'One agent learns, many use it'
SETS = agent_training.SETS
CROWD = 'circle12'
SEEDS = 10
FIELD_EPISODES = (0, 10, 100, 1000, 4000)  # of the pioneer among several obstacles, after its training as in 4.1
QUICK_EPISODES = (0, 5)
DEMO_EPISODES = 50
FURTHER_EPISODES = 100  # in which all learn on
JUDGED_EPISODES = 50  # of those, the last
USES = {'fixed': 'the table stays as it is', 'own': 'all learn on, in own tables',
        'shared': 'all learn on, in one shared table'}
USE_COLOURS = {'fixed': '#0072b2', 'own': '#e69f00', 'shared': '#cc79a7'}
MEASURES = {'success': 0, 'collision': 2, 'contact': 1}


def episodes_of(setting):
    return setting.count(FIELD_EPISODES, QUICK_EPISODES)


def run_name(states, seed):
    return f'{states}_{seed:02d}'


def plan(setting):
    """A run for each state set and seed."""
    return [make_run(setting, states, seed) for seed in setting.seeds(SEEDS) for states in SETS]


def make_run(setting, states, seed):
    """Trains a pioneer for so many episodes, lets a crowd walk by its table, then lets the crowd learn on."""
    commands = [agent_training.learn_single(setting, setting.config_file(f'agent_single_{states}_thesis'), seed)]
    for episodes in episodes_of(setting):
        table = agent_training.SINGLE_TABLE
        if episodes:
            table = f'pioneer_{episodes:05d}.txt'
            commands.append([setting.tool('train'), setting.config_file(f'agent_field_{states}_thesis'), '--q-table',
                             agent_training.SINGLE_TABLE, '--output', table, '--seed', seed, '--episodes', episodes])
        commands.append(agent_training.walk(setting, table, seed) + [
            '--episodes', setting.count(DEMO_EPISODES, 1), '--record', f'fixed_{episodes:05d}.csv',
            setting.scenario(CROWD)])
        for use in ('own', 'shared'):
            commands.append([setting.tool('train'), setting.config_file(f'sharing_crowd_{states}'), '--q-table', table,
                             '--tables', use, '--output', f'{use}.txt', '--seed', seed, '--episodes',
                             setting.count(FURTHER_EPISODES, 2), '--record', f'{use}_{episodes:05d}.csv'])
    return Run(setting.run_folder(NAME, run_name(states, seed)), commands, cost=6.0)


def report(setting):
    """The chapter, from the runs' records."""
    chapter = Chapter(NAME, TITLE)
    chapter.add_text(
        f'A pioneer learns alone, {agent_training.SINGLE_EPISODES:,} episodes with one obstacle (4.1), then for so '
        'many among several, resting and moving (4.3); then twelve agents on a circle walk to the opposite points by '
        'its table. Either the table stays as it is, or all go on learning, each in a table of its own or all in one, '
        f'for {setting.count(FURTHER_EPISODES, 2)} episodes, of which the last {JUDGED_EPISODES} are judged; 1 % of '
        f"the decisions are at random in them. The thesis's parameters, {len(setting.seeds(SEEDS))} seeds.")
    curves = {(states, use): curve(setting, states, use) for states in SETS for use in USES}
    add_figure(chapter, setting, curves)
    add_table(chapter, setting, curves)
    return chapter


def curve(setting, states, use):
    """Success, contact and collision [%] for each number of episodes and seed: an array (episodes, seeds, 3)."""
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
                       'Success, collision and contact of a crowd of twelve against the number of episodes that the '
                       "pioneer learned. Thesis's parameters. Lines: mean over the seeds; bands: lowest to highest.")


def add_table(chapter, setting, curves):
    rows = []
    for states in SETS:
        for i, episodes in enumerate(episodes_of(setting)):
            rows.append([f"{style.SET_NAMES[states]}, thesis's parameters, {episodes:,} episodes among several",
                         *(Spread(curves[states, use][i, :, index]).text(1) for use in USES
                           for index in MEASURES.values())])
    header = ['', *(f'{use}: {measure} %' for use in ('fixed', 'own tables', 'one table') for measure in MEASURES)]
    chapter.add_table("A crowd of twelve with the pioneer's table: mean ± standard deviation over the seeds "
                      '(lowest-highest)', header, rows, name='sharing')
