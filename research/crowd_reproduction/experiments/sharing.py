"""One agent learns, many use its table: effect of the number of episodes that the pioneer learns before it shares."""
import numpy
from crowd_experiments import style
from crowd_experiments.records import Spread

from ..declared import BETTER, PARAMETERS, SETS, THESIS
from ..results import PARAMETER_NAMES, RATES, Runs, rates_of, report_of

NAME = 'sharing'
EPISODES, QUICK_EPISODES = (0, 1000, 4000), (0, 5)  # of the pioneer among several obstacles
JUDGED_EPISODES = 50  # the last of those in which all agents continue learning
USES = {'fixed': ('unchanged table', '#0072b2'), 'own': ('all continue learning, own tables', '#e69f00'),
        'shared': ('all continue learning, one shared table', '#cc79a7')}


def report(setting):
    chapter = report_of(NAME, setting, 8, judged=JUDGED_EPISODES)
    add_figure(chapter, setting, {(states, use): curve(setting, states, use) for states in SETS for use in USES})
    chapter.tabulate(NAME, ['', *(f'{use}: {measure} %' for use in ('unchanged table', 'own tables', 'one table')
                                  for measure in RATES)], [
        [f'{style.SET_NAMES[states]}, {PARAMETER_NAMES[parameters]}, {episodes:,} episodes among several obstacles',
         *(Spread(values).text(1) for use in USES for values in curve(setting, states, use, parameters)[i].T)]
        for states in SETS for parameters in PARAMETERS[states] if parameters != BETTER
        for i, episodes in enumerate(setting.count(EPISODES, QUICK_EPISODES))])
    return chapter


def curve(setting, states, use, parameters=THESIS):
    """Returns an array (episodes, seeds, 3) of success, collision and contact [%]."""
    records = [Runs.of(setting, NAME, states=states, parameters=parameters).record(f'{use}_{episodes:05d}.csv')
               for episodes in setting.count(EPISODES, QUICK_EPISODES)]
    return numpy.array([rates_of(record[record['episode'] > record['episode'].max() - JUDGED_EPISODES])
                        for record in records])


def add_figure(chapter, setting, curves):
    figure, axes = style.new_figure(len(RATES), 2, 11, 9, sharex=True, sharey='row')
    episodes = setting.count(EPISODES, QUICK_EPISODES)
    for column, states in enumerate(SETS):
        for row, measure in enumerate(RATES):
            panel = axes[row][column]
            for use, (name, colour) in USES.items():
                values = curves[states, use][:, :, row]
                panel.plot(range(len(episodes)), values.mean(axis=1), marker='o', color=colour, label=name)
                panel.fill_between(range(len(episodes)), values.min(axis=1), values.max(axis=1), alpha=0.15,
                                   color=colour, linewidth=0)
            panel.set_title(f'{measure}, {style.SET_NAMES[states]}')
    for row, measure in enumerate(RATES):
        axes[row][0].set(ylabel=f'{measure} [% of the agents]', ylim=(0, 105))
    for panel in axes[-1]:
        panel.set_xticks(range(len(episodes)), [f'{number:,}' for number in episodes])
        panel.set_xlabel('episodes among several obstacles before the pioneer shared')
    axes[0][1].legend(loc='lower right')
    chapter.draw(figure, NAME, 'figure')
