"""Visited rows and success of a table against the number of training episodes."""
import numpy

from crowd_experiments import style
from crowd_experiments.pages import Chapter
from crowd_experiments.records import Spread, of_scenario, rates, read_csv, read_table_header

from .. import agent_runs, agent_training, names

NAME = 'learning_curves'
TITLE = 'Learning curves'
SETS = agent_training.SETS
PARAMETERS = agent_training.PARAMETERS
SEEDS = agent_training.SEEDS
SCENARIOS = agent_training.CHECKED
LINES = {'training_field': '-', 'circle6': ':'}
MEASURES = {'success': 0, 'collision': 2, 'contact': 1}

plan = agent_runs.plan


def report(setting):
    """Returns the chapter, from the runs' records."""
    chapter = Chapter(NAME, TITLE)
    chapter.add_text(
        f'{agent_training.DESCRIPTION} In the second part the table is saved every '
        f'{agent_training.save_every(setting)} episodes. Each of these tables is evaluated in demo mode, in fields of '
        'obstacles that were not used in training (training_field), and with six agents on a circle. '
        f'{len(setting.seeds(SEEDS))} seeds.')
    curves = {(states, parameters): Curve(setting, states, parameters) for states in SETS for parameters in PARAMETERS}
    add_figure(chapter, setting, curves)
    add_table(chapter, curves)
    return chapter


class Curve:
    """Results of one training configuration for each checkpoint and seed: visited rows; success, contact and
    collision [%] by scenario."""

    def __init__(self, setting, states, parameters):
        folders = [agent_training.folder_of(setting, states, parameters, seed) for seed in setting.seeds(SEEDS)]
        self.episodes = list(agent_training.checkpoints(setting))
        headers = [[read_table_header(folder / agent_training.table_after(episodes)) for folder in folders]
                   for episodes in self.episodes]
        self.all_rows = int(headers[0][0]['rows'])
        self.rows = numpy.array([[float(header['visited_rows']) for header in line] for line in headers])
        records = [[read_csv(folder / agent_training.record_after(episodes)) for folder in folders]
                   for episodes in self.episodes]
        self.rates = {scenario: numpy.array([[rates(record, of_scenario(record, scenario)) for record in line]
                                             for line in records]) for scenario in SCENARIOS}


def add_figure(chapter, setting, curves):
    """Adds the figure of rows, success, collision and contact (from top to bottom) for both sets of parameters."""
    figure, axes = style.new_figure(1 + len(MEASURES), len(PARAMETERS), 11, 11, sharex=True, sharey=True)
    for (states, parameters), curve in curves.items():
        panels = axes[:, PARAMETERS.index(parameters)]
        colour = style.SET_COLOURS[states]
        panels[0].plot(curve.episodes, 100.0 * curve.rows.mean(axis=1) / curve.all_rows, color=colour,
                       label=f'{style.SET_NAMES[states]}: of {curve.all_rows:,} rows')
        for scenario, line in LINES.items():
            for panel, index in zip(panels[1:], MEASURES.values()):
                values = curve.rates[scenario][:, :, index].mean(axis=1)
                panel.plot(curve.episodes, values, color=colour, linestyle=line,
                           label=f'{style.short_set_name(states)}, {SCENARIOS[scenario]}')
    for column, parameters in enumerate(PARAMETERS):
        axes[0][column].set_title(names.PARAMETER_NAMES[parameters])
        axes[-1][column].set_xlabel('training episodes among several obstacles')
    labels = ['rows ever visited [%]', *(f'{measure} in demo [% of the agents]' for measure in MEASURES)]
    for row, label in enumerate(labels):
        axes[row][0].set_ylabel(label)
    axes[0][0].set_ylim(0, 105)
    axes[0][0].legend(loc='center right')
    axes[-1][1].legend(loc='upper right')
    chapter.add_figure(style.save(figure, setting.figure_file('learning_curves')),
                       'Learning curves: visited rows, success, collision and contact in demo against the number of '
                       'training episodes among several obstacles, after 2,000 with one obstacle; mean over the seeds.')


def add_table(chapter, curves):
    rows = []
    for (states, parameters), curve in curves.items():
        for i in sorted({0, 1, len(curve.episodes) // 2, len(curve.episodes) - 1}):
            rows.append([f'{style.short_set_name(states)}, {names.PARAMETER_NAMES[parameters]}, '
                         f'{curve.episodes[i]:,} episodes among several obstacles',
                         Spread(curve.rows[i]).text(0),
                         *(Spread(curve.rates[scenario][i, :, index]).text(1) for scenario in SCENARIOS
                           for index in MEASURES.values())])
    chapter.add_table('Rows and rates: mean ± standard deviation over the seeds (lowest-highest)',
                      ['', 'rows visited', *(f'{scenario}: {measure} %' for scenario in SCENARIOS
                                             for measure in MEASURES)], rows, name='curves')
