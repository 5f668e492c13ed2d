"""One agent learns, many use what it learned: how long is the pioneer to learn before it shares?"""
import numpy

from crowd_experiments import style
from crowd_experiments.chapter import Chapter
from crowd_experiments.records import Spread, rates, read_csv
from crowd_experiments.runs import Run

NAME = 'sharing'
TITLE = 'One agent learns, many use it'
SETS = ('nearest', 'occupancy')
CROWD = 'circle12'
SEEDS = 5
PIONEER_EPISODES = (1, 10, 30, 100, 300, 1000, 3000, 10000)
QUICK_EPISODES = (1, 5)
DEMO_EPISODES = 50
FURTHER_EPISODES = 150  # in which everybody learns on
JUDGED_EPISODES = 50  # of those, the last
DEMO_SEED = 1000
USES = {'fixed': 'the table stays as it is', 'own': 'everybody learns on, in own tables',
        'shared': 'everybody learns on, in one shared table'}
USE_COLOURS = {'fixed': '#0072b2', 'own': '#e69f00', 'shared': '#cc79a7'}
MEASURES = {'success': 0, 'contact': 1}


def episodes_of(setting):
    return setting.count(PIONEER_EPISODES, QUICK_EPISODES)


def run_name(states, seed):
    return f'{states}_{seed:02d}'


def plan(setting):
    """A run for each state set and seed."""
    return [make_run(setting, states, seed) for seed in setting.seeds(SEEDS) for states in SETS]


def make_run(setting, states, seed):
    """Trains a pioneer for so many episodes, lets a crowd walk by its table, then lets the crowd learn on."""
    commands = []
    for episodes in episodes_of(setting):
        table = f'pioneer_{episodes:05d}.txt'
        commands += [
            [setting.tool('train'), setting.recipe(f'sharing_pioneer_{states}'), '--output', table, '--seed', seed,
             '--episodes', episodes],
            [setting.tool('evaluate'), '--q-table', table, '--threads', 1, '--seed', DEMO_SEED + seed, '--episodes',
             setting.count(DEMO_EPISODES, 1), '--record', f'fixed_{episodes:05d}.csv', setting.scenario(CROWD)]]
        for use in ('own', 'shared'):
            commands.append([setting.tool('train'), setting.recipe(f'sharing_crowd_{states}'), '--q-table', table,
                             '--tables', use, '--output', f'{use}.txt', '--seed', seed, '--episodes',
                             setting.count(FURTHER_EPISODES, 2), '--record', f'{use}_{episodes:05d}.csv'])
    return Run(setting.run_folder(NAME, run_name(states, seed)), commands, cost=25.0)


def report(setting):
    """The chapter, from the runs' records."""
    chapter = Chapter(NAME, TITLE)
    chapter.tell(
        'A pioneer learns alone among obstacles, resting and moving, for so many episodes; then twelve agents on a '
        'circle walk to the opposite points by its table. Either the table stays as it is, or everybody goes on '
        f'learning, in a table of its own or all in one, for {setting.count(FURTHER_EPISODES, 2)} episodes, of which '
        'the last '
        f'{JUDGED_EPISODES} are judged; 1 % of the decisions are at random in them. The thesis\'s learning parameters, '
        f'{len(setting.seeds(SEEDS))} seeds.')
    curves = {(states, use): curve(setting, states, use) for states in SETS for use in USES}
    add_figure(chapter, setting, curves)
    add_table(chapter, setting, curves)
    return chapter


def curve(setting, states, use):
    """Success and contact [%] for each number of episodes and each seed: an array (episodes, seeds, 2)."""
    return numpy.array([[judged(setting.run_folder(NAME, run_name(states, seed)) / f'{use}_{episodes:05d}.csv')
                         for seed in setting.seeds(SEEDS)] for episodes in episodes_of(setting)])


def judged(file):
    record = read_csv(file)
    return rates(record, record['episode'] > record['episode'].max() - JUDGED_EPISODES)


def add_figure(chapter, setting, curves):
    figure, axes = style.new_figure(2, 2, 11, 7, sharex=True, sharey='row')
    for column, states in enumerate(SETS):
        for row, (measure, index) in enumerate(MEASURES.items()):
            panel = axes[row][column]
            for use, name in USES.items():
                values = curves[states, use][:, :, index]
                panel.plot(episodes_of(setting), values.mean(axis=1), marker='o', color=USE_COLOURS[use], label=name)
                panel.fill_between(episodes_of(setting), values.min(axis=1), values.max(axis=1), alpha=0.15,
                                   color=USE_COLOURS[use], linewidth=0)
            panel.set_xscale('log')
            panel.set_title(f'{measure}, {style.SET_NAMES[states]}')
    for row, measure in enumerate(MEASURES):
        axes[row][0].set_ylabel(f'{measure} [% of the agents]')
        axes[row][0].set_ylim(0, 105)
    for panel in axes[1]:
        panel.set_xlabel('episodes that the pioneer learned before it shared')
    axes[0][1].legend(loc='lower right')
    chapter.add_figure(style.save(figure, setting.figure_file('sharing')),
                       'Success and contact of a crowd of twelve against the number of episodes that the pioneer '
                       'learned. Lines: mean over the seeds; bands: lowest to highest.')


def add_table(chapter, setting, curves):
    rows = []
    for states in SETS:
        for i, episodes in enumerate(episodes_of(setting)):
            rows.append([f'{style.SET_NAMES[states]}, after episode {episodes}',
                         *(Spread(curves[states, use][i, :, index]).text(1) for use in USES for index in (0, 1))])
    header = ['', *(f'{use}: {measure} %' for use in ('fixed', 'own tables', 'one table') for measure in MEASURES)]
    chapter.add_table("A crowd of twelve with the pioneer's table: mean ± standard deviation over the seeds "
                      '(lowest-highest)', header, rows)
