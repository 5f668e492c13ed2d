"""Visited rows and success of a table against the number of training episodes."""
import numpy
from crowd_experiments import style
from crowd_experiments.records import Spread

from ..crowds import agents
from ..declared import DRAWN, PARAMETERS, SETS
from ..results import PARAMETER_NAMES, RATES, report_of

SCENARIOS = {'training_field': ('one agent among obstacles', '-'), 'circle6': ('six on a circle', ':')}


def report(setting):
    chapter = report_of('learning_curves', setting, 8)
    curves = {(states, parameters): Curve(setting, states, parameters) for states in SETS
              for parameters in PARAMETERS[states]}
    add_figure(chapter, {(states, parameters): Curve(setting, states, parameters) for states in SETS
                         for parameters in DRAWN})
    chapter.tabulate('curves', ['', 'rows visited', *(f'{scenario}: {measure} %' for scenario in SCENARIOS
                                                      for measure in RATES)], [
        [f'{style.short_set_name(states)}, {PARAMETER_NAMES[parameters]}, '
         f'{curve.episodes[i]:,} episodes among several obstacles', Spread(curve.rows[i]).text(0),
         *(Spread(values).text(1) for scenario in SCENARIOS for values in curve.rates[scenario][i].T)]
        for (states, parameters), curve in curves.items()
        for i in sorted({0, 1, len(curve.episodes) // 2, len(curve.episodes) - 1})])
    return chapter


class Curve:
    """Visited rows, and the rates [%] by scenario, of a training configuration for each checkpoint and seed."""

    def __init__(self, setting, states, parameters):
        runs = agents(setting, parameters, states)
        self.episodes = list(range(0, *setting.count((4001, 1000), (21, 10))))
        tables = ['single.txt', *(f'q_table_{episodes:06d}.txt' for episodes in self.episodes[1:])]
        self.all_rows = int(runs.headers(tables[0], 'rows')[0])
        self.rows = numpy.array([runs.headers(table, 'visited_rows') for table in tables])
        self.rates = {scenario: numpy.array([runs.rates(f'checkpoint_{episodes:06d}.csv', scenario)
                                             for episodes in self.episodes]) for scenario in SCENARIOS}


def add_figure(chapter, curves):
    """Adds the figure of rows, success, collision and contact (from top to bottom) for both sets of parameters."""
    figure, axes = style.new_figure(1 + len(RATES), len(DRAWN), 11, 11, sharex=True, sharey=True)
    for (states, parameters), curve in curves.items():
        panels = axes[:, DRAWN.index(parameters)]
        colour = style.SET_COLOURS[states]
        panels[0].plot(curve.episodes, 100.0 * curve.rows.mean(axis=1) / curve.all_rows, color=colour,
                       label=f'{style.SET_NAMES[states]}: of {curve.all_rows:,} rows')
        for scenario, (name, line) in SCENARIOS.items():
            for panel, values in zip(panels[1:], curve.rates[scenario].mean(axis=1).T):
                panel.plot(curve.episodes, values, color=colour, linestyle=line,
                           label=f'{style.short_set_name(states)}, {name}')
    for column, parameters in enumerate(DRAWN):
        axes[0][column].set_title(PARAMETER_NAMES[parameters])
        axes[-1][column].set_xlabel('training episodes among several obstacles')
    labels = ['rows ever visited [%]', *(f'{measure} in demo [% of the agents]' for measure in RATES)]
    for row, label in enumerate(labels):
        axes[row][0].set_ylabel(label)
    axes[0][0].set_ylim(0, 105)
    axes[0][0].legend(loc='center right')
    axes[-1][1].legend(loc='upper right')
    chapter.draw(figure, 'learning_curves')
