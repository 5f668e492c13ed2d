"""Figures 4.13-4.16: situations that state set 1 does not distinguish, and two obstacles side by side."""
import textwrap

import numpy
from crowd_drawing.files import read_scene
from crowd_experiments import style
from crowd_experiments.records import Spread
from crowd_studies.scene_figures import draw_perception, draw_scene, frame_alike

from ..measures import sectors_of
from ..declared import BETTER, PARAMETERS, SETS, THESIS
from ..results import PARAMETER_NAMES, RATE_HEADER, rate_texts, report_of
from ..twins import ALONE, SCENES, TESTS, TRAININGS, Agent, first_decision, rows_of

DRAWN = {THESIS: 'single', BETTER: 'field'}  # the training that figure 4.16 shows
RADII = (0.5, 1.0)  # of the two distance classes [m]
LIMITS = {'nearest': (0, 15, 45, 90, 180, -90, -45, -15), 'occupancy': numpy.arange(-157.5, 180, 45)}
CLEAN = 'arrived > 0 and collided == 0'
FAILURES = (('one obstacle perceived', (ALONE,), CLEAN),
            ('two: oscillates', ('twins_b', 'twins_c', 'twins_a'), 'arrived == 0'),
            ('two: collides', ('twins_b', 'twins_c', 'twins_d', 'twins_a'), 'touched > 0 or collided > 0'))


def report(setting):
    chapter = report_of('ambiguity', setting, 8)
    add_same_state(chapter, setting)
    add_failures(chapter, setting)
    add_perceptions(chapter, setting)
    for parameters in DRAWN:
        add_twins(chapter, setting, parameters)
    for parameters in PARAMETERS['occupancy']:
        chapter.tabulate(f'twins_{parameters}', [
            '', *RATE_HEADER, 'path ratio (arrivals only)', 'decisions (arrivals only)', 'rows visited in training'], [
                [f'{style.short_set_name(states)}, {label}, {title}',
                 *test_cells(Agent(setting, training, states, parameters), test)]
                for training, label in TRAININGS.items() for states in SETS if parameters in PARAMETERS[states]
                for test, title in TESTS.items()],
            'twins', parameters=PARAMETER_NAMES[parameters])
    chapter.tabulate('passage', ['', 'between the obstacles %', 'around both %'], [
        [f'{PARAMETER_NAMES[parameters]}, {label}',
         *(Spread(shares).text(1) for shares in Agent(setting, training, 'occupancy', parameters).passages())]
        for parameters in PARAMETERS['occupancy'] for training, label in TRAININGS.items()])
    return chapter


def test_cells(agent, test):
    texts = [Spread.of_numbers(agent.runs.arrivals(agent.file, column, test)).text(decimals)
             for column, decimals in (('path_ratio', 2), ('ticks', 0))]
    return [*rate_texts(agent.runs.rates(agent.file, test)), *texts,
            Spread(agent.runs.headers(agent.table, 'visited_rows')).text(0)]


def draw_view(panel, setting, scene, states):
    """Draws the scene as the agent perceives it with a state set. Returns the picture and the occupied sectors."""
    decision = first_decision(setting, scene, states)
    sectors = sectors_of(decision['occupied'])
    return draw_perception(panel, read_scene(setting.scenario(scene), 0), decision[['x', 'y', 'heading']], sectors,
                           RADII, LIMITS[states]), sectors


def add_same_state(chapter, setting):
    rows = {states: rows_of(setting, states) for states in SETS}
    figure, axes = style.new_figure(1, len(SCENES), 12, 5.3)
    pictures = []
    for i, (panel, (scene, title)) in enumerate(zip(axes[0], SCENES.items())):
        pictures.append(draw_view(panel, setting, scene, 'nearest')[0])
        panel.set_title(f'({title[0]}) {title[3:]}: row {rows["nearest"][i]} of set 1\n(row {rows["occupancy"][i]} of '
                        'set 2)')
    frame_alike(pictures)
    chapter.draw(figure, 'figure_4_13', alike='the same row' if len(set(rows['nearest'])) == 1 else 'DIFFERENT rows',
                 **{states: ', '.join(map(str, rows[states])) for states in SETS})
    chapter.tabulate('same_state', ['', *SCENES.values()],
                     [[style.SET_NAMES[states], *map(str, rows[states])] for states in SETS])


def add_perceptions(chapter, setting):
    figure, axes = style.new_figure(1, 2, 9, 4.6)
    for panel, states, letter in zip(axes[0], SETS, 'ab'):
        picture, sectors = draw_view(panel, setting, 'same_state_c', states)
        picture.frame()
        classes = [f'{sector.begin:g} to {sector.end:g}°: class {sector.distance_class}'.replace(' ', '\xa0')
                   for sector in sectors]  # lines are broken after commas only
        panel.set(title=f'({letter}) {style.SET_NAMES[states]}', xlabel='\n'.join(
            textwrap.wrap(', '.join(classes), 63, break_long_words=False)).replace('\xa0', ' '))
    chapter.draw(figure, 'figure_4_15')


def find_walk(setting, agent, tests, condition):
    """Returns row and test of the first recorded episode that meets a condition, and True; else the first, False."""
    recorded = {test: agent.runs.record(agent.file, test).query(f'episode < {setting.count(10, 2)}') for test in tests}
    for seed in agent.runs.seeds():
        for test in tests:
            fits = recorded[test].query(f'seed == {seed} and ({condition})')
            if len(fits):
                return fits.iloc[0], test, True
    return recorded[tests[0]].iloc[0], tests[0], False


def draw_walk(panel, agent, row, test):
    folder = agent.runs.folder(int(row['seed'])) / agent.tests
    draw_scene(panel, folder / f'{test}.yaml', folder / f'{test}.csv', int(row['episode']), '#d62728', '#c9c3e6')
    panel.set(xlim=(-3.1, 3.1), ylim=(-3.3, 3.6))
    panel.label_outer()


def ending(row):
    words = 'arrives' if row['arrived'] else 'does not arrive'
    if row['touched']:
        return words + ', contact with an obstacle'
    return words + (', collision' if row['collided'] else '')


def add_failures(chapter, setting):
    agent = Agent(setting, 'single', 'nearest')
    figure, axes = style.new_figure(1, len(FAILURES), 12, 5.8, sharex=True, sharey=True)
    for panel, letter, (title, tests, condition) in zip(axes[0], 'abc', FAILURES):
        row, test, found = find_walk(setting, agent, tests, condition)
        draw_walk(panel, agent, row, test)
        panel.set_title(f'({letter}) {title if found else "no such episode"}\n{test}, seed {row["seed"]}: '
                        f'{ending(row)}')
    means = {test: agent.runs.rates(agent.file, test).mean() for test in (ALONE, 'twins_b', 'twins_c')}
    chapter.draw(figure, 'figure_4_14', rates='; '.join(
        f'{test}: success {mean.success:.0f} %, collision {mean.collision:.0f} %' for test, mean in means.items()))


def add_twins(chapter, setting, parameters):
    """Adds figure 4.16 for a set of parameters."""
    agent = Agent(setting, DRAWN[parameters], 'occupancy', parameters)
    figure, axes = style.new_figure(2, 2, 8.4, 10.4, sharex=True, sharey=True)
    for panel, (test, title) in zip(axes.flat, TESTS.items()):
        row, _, found = find_walk(setting, agent, [test], CLEAN)
        draw_walk(panel, agent, row, test)
        mean = agent.runs.rates(agent.file, test).mean()
        panel.set_title(f'({title[0]}) {title[3:]}, seed {row["seed"]}' + ('' if found else ' (fails)') +
                        f'\nall: success {mean.success:.0f} %, collision {mean.collision:.0f} %')
    chapter.draw(figure, 'figure_4_16' + (f'_{BETTER}' if parameters == BETTER else ''), 'figure_4_16',
                 parameters=PARAMETER_NAMES[parameters], training=TRAININGS[DRAWN[parameters]])
