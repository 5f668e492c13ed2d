"""Rows and quality of a table against the episodes it has learned."""
import numpy

from crowd_experiments import style
from crowd_experiments.chapter import Chapter
from crowd_experiments.records import Spread, of_scenario, rates, read_csv, read_table_header
from crowd_experiments.runs import Run

from .. import names

NAME = 'learning_curves'
TITLE = 'Learning curves: a record of learning'
SETS = ('nearest', 'occupancy')
PARAMETERS = ('thesis', 'better')
SEEDS = 3
EPISODES, SAVE_EVERY = 10000, 500
QUICK_EPISODES, QUICK_SAVE_EVERY = 20, 10
DEMO_EPISODES = 40
DEMO_SEED = 1000
SCENARIOS = {'training_field': 'one agent among obstacles', 'circle6': 'six on a circle'}
LINES = {'training_field': '-', 'circle6': ':'}


def run_name(states, parameters, seed):
    return f'{states}_{parameters}_{seed:02d}'


def checkpoints(setting):
    """The numbers of episodes after which the table is saved."""
    every = setting.count(SAVE_EVERY, QUICK_SAVE_EVERY)
    return range(every, setting.count(EPISODES, QUICK_EPISODES) + 1, every)


def plan(setting):
    """A run for each state set, set of parameters and seed."""
    return [make_run(setting, states, parameters, seed) for seed in setting.seeds(SEEDS) for states in SETS
            for parameters in PARAMETERS]


def make_run(setting, states, parameters, seed):
    recipe = setting.recipe(f'learning_curves_{states}_{parameters}')
    commands = [[setting.tool('train'), recipe, '--output', 'q_table.txt', '--seed',
                 seed, '--episodes', setting.count(EPISODES, QUICK_EPISODES), '--save-every',
                 setting.count(SAVE_EVERY, QUICK_SAVE_EVERY)]]
    for episodes in checkpoints(setting):
        commands.append([setting.tool('evaluate'), '--q-table', f'q_table_{episodes:06d}.txt', '--threads', 1, '--seed',
                         DEMO_SEED + seed, '--episodes', setting.count(DEMO_EPISODES, 4), '--record',
                         f'demo_{episodes:06d}.csv', *map(setting.scenario, SCENARIOS)])
    return Run(setting.run_folder(NAME, run_name(states, parameters, seed)), commands, cost=20.0)


def report(setting):
    """The chapter, from the runs' records."""
    chapter = Chapter(NAME, TITLE)
    chapter.tell(
        'One agent learns among two to eight obstacles, some of which move (training_field); its table is saved every '
        f'{setting.count(SAVE_EVERY, QUICK_SAVE_EVERY)} episodes, and each of these tables walks, in demo mode, fields '
        f'of obstacles that it has not met, and six agents on a circle. {len(setting.seeds(SEEDS))} seeds. The better '
        'parameters are not better in everything here: they keep contacts near zero, at the price of agents that '
        'dance in front of a gap until time is up.')
    curves = {(states, parameters): Curve(setting, states, parameters) for states in SETS for parameters in PARAMETERS}
    add_figure(chapter, setting, curves)
    add_table(chapter, setting, curves)
    return chapter


class Curve:
    """Of one recipe, for each checkpoint and seed: rows visited, and by scenario success and contact [%]."""

    def __init__(self, setting, states, parameters):
        folders = [setting.run_folder(NAME, run_name(states, parameters, seed)) for seed in setting.seeds(SEEDS)]
        self.episodes = list(checkpoints(setting))
        headers = [[read_table_header(folder / f'q_table_{episodes:06d}.txt') for folder in folders]
                   for episodes in self.episodes]
        self.all_rows = int(headers[0][0]['rows'])
        self.rows = numpy.array([[float(header['visited_rows']) for header in line] for line in headers])
        records = [[read_csv(folder / f'demo_{episodes:06d}.csv') for folder in folders] for episodes in self.episodes]
        self.rates = {scenario: numpy.array([[rates(record, of_scenario(record, scenario)) for record in line]
                                             for line in records]) for scenario in SCENARIOS}


def add_figure(chapter, setting, curves):
    """Rows, success and contact one above the other; the two sets of parameters side by side."""
    figure, axes = style.new_figure(3, len(PARAMETERS), 11, 9, sharex=True, sharey=True)
    for (states, parameters), curve in curves.items():
        panels = axes[:, PARAMETERS.index(parameters)]
        colour = style.SET_COLOURS[states]
        panels[0].plot(curve.episodes, 100.0 * curve.rows.mean(axis=1) / curve.all_rows, color=colour,
                       label=f'{style.SET_NAMES[states]}: of {curve.all_rows:,} rows')
        for scenario, line in LINES.items():
            for panel, index in zip(panels[1:], (0, 1)):
                values = curve.rates[scenario][:, :, index].mean(axis=1)
                panel.plot(curve.episodes, values, color=colour, linestyle=line,
                           label=f'{style.short_set_name(states)}, {SCENARIOS[scenario]}')
    for column, parameters in enumerate(PARAMETERS):
        axes[0][column].set_title(names.PARAMETER_NAMES[parameters])
        axes[-1][column].set_xlabel('training episodes')
    for row, label in enumerate(('rows ever visited [%]', 'success in demo [% of the agents]',
                                 'contact in demo [% of the agents]')):
        axes[row][0].set_ylabel(label)
    axes[0][0].set_ylim(0, 105)
    axes[0][0].legend(loc='center right')
    axes[2][1].legend(loc='upper right')
    chapter.add_figure(style.save(figure, setting.figure_file('learning_curves')),
                       'A record of learning: rows visited, success and contact in demo against the episodes learned; '
                       'mean over the seeds.')


def add_table(chapter, setting, curves):
    rows = []
    for (states, parameters), curve in curves.items():
        chosen = sorted({0, len(curve.episodes) // 4, len(curve.episodes) // 2, len(curve.episodes) - 1})
        for i in chosen:
            rows.append([f'{style.short_set_name(states)}, {names.PARAMETER_NAMES[parameters]}, '
                         f'{curve.episodes[i]} episodes',
                         Spread(curve.rows[i]).text(0),
                         *(Spread(curve.rates[scenario][i, :, index]).text(1) for scenario in SCENARIOS
                           for index in (0, 1))])
    chapter.add_table('Rows and quality: mean ± standard deviation over the seeds (lowest-highest)',
                      ['', 'rows visited', *(f'{scenario}: {measure} %' for scenario in SCENARIOS
                                             for measure in ('success', 'contact'))], rows)
