"""The future work of section 5.2, applied to the thesis's agent: a stay action, occlusion, condensed states."""
from crowd_experiments import style
from crowd_experiments.records import Spread

from ..crowds import LEAST_SECTORS, SOON, agents, surrounded
from ..declared import GROUPS, LEAD, READINGS, THESIS, Reading
from ..results import RATE_HEADER, Runs, rate_texts, report_of
from .scenarios import SURROUNDED, surrounded_row

NAME = 'future_work'
SCENARIO = 'circle12_varied'
WATCHED = 2  # number of episodes of which every decision is recorded
# Labels by variations.
LABELS = {THESIS: "the thesis's agent", 'stay': 'stay action', 'stay_02': 'stay action, cost 0.2',
          'stay_1': 'stay action, cost 1', 'stay_5': 'stay action, cost 5', 'occlusion': 'occlusion',
          'condensed': 'condensed states', 'condensed_80': 'condensed states, cost 80',
          'both': 'stay action, cost 1, occlusion'}
COLOUR = '#8e5ea2'


def report(setting):
    chapter = report_of(NAME, setting, 8, least=LEAST_SECTORS, soon=SOON)
    add_figure(chapter, setting)
    for reading in GROUPS[NAME]['each']['parameters']:
        read, values = Reading.of(setting, reading), {'reading': READINGS[reading]['label']}
        name = '' if reading == LEAD else f'_{reading}'
        chapter.tabulate(NAME + name, ['', *RATE_HEADER, 'path ratio (arrivals only)', 'time ratio (arrivals only)',
                                       'rows visited in training'],
                         [row_of(read, variation) for variation in LABELS], NAME, **values)
        chapter.tabulate('surrounded' + name, ['', *SURROUNDED],
                         [surrounded_row(label, found_of(read, variation)) for variation, label in LABELS.items()],
                         'surrounded', **values, definitions=chapter.text_of('definitions'))
    return chapter


def runs_of(setting, variation):
    """Returns the runs of a variation; the thesis's agent is that of the scenarios."""
    return agents(setting) if variation == THESIS else Runs.of(setting, NAME, variation=variation)


def found_of(setting, variation):
    """Returns what is found of surrounded agents, for each seed."""
    return surrounded(runs_of(setting, variation), SCENARIO, WATCHED)


def rates(setting, variation):
    return runs_of(setting, variation).rates('demo.csv', SCENARIO)


def row_of(setting, variation):
    runs = runs_of(setting, variation)
    ratios = [Spread.of_numbers(runs.arrivals('demo.csv', column, SCENARIO)).text(2)
              for column in ('path_ratio', 'time_ratio')]
    return [LABELS[variation], *rate_texts(rates(setting, variation)), *ratios,
            Spread(runs.headers('q_table.txt', 'visited_rows')).text(0)]


def add_figure(chapter, setting):
    figure, axes = style.new_figure(1, 4, 14, 4.4, sharey=True)
    for place, variation in enumerate(LABELS):
        of_variation = rates(setting, variation)
        panels = {**{f'{rate} [% of the agents]': of_variation[rate] for rate in of_variation},
                  'contact after being surrounded [%]': [one.touched for one in found_of(setting, variation)]}
        for panel, (title, values) in zip(axes[0], panels.items()):
            values = Spread.of_numbers(values)
            panel.barh(place, values.mean, color=COLOUR, alpha=0.45)
            panel.plot(values.values, [place] * len(values.values), linestyle='', marker='o', markersize=3,
                       color=COLOUR)
            panel.set(title=title, xlim=(0, 105))
    axes[0][0].set_yticks(range(len(LABELS)), list(LABELS.values()))
    axes[0][0].invert_yaxis()
    chapter.draw(figure, NAME, 'figure')
