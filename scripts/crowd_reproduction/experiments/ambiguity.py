"""Figures 4.13-4.16: what state set 1 cannot tell apart, and two obstacles side by side."""
import numpy

from crowd_drawing.files import read_scene
from crowd_experiments import style
from crowd_experiments.chapter import Chapter
from crowd_experiments.records import (Spread, median, of_scenario, percent, read_table_header, read_tracks)
from crowd_experiments.scene_figures import draw_perception, draw_scene, frame_alike

from .. import agent_runs, agent_training, names, twins_runs as twins
from ..decisions import read_decisions, sectors_of
from ..measures import crossing

NAME = twins.NAME
TITLE = 'Ambiguity of state set 1: the twins tests (figures 4.13-4.16)'
DRAWN = {'thesis': 'single', 'better': 'field'}  # which training figure 4.16 shows
HALF_GAP = 0.95  # of test d: where the centres of the obstacles are, to either side of the straight way [m]
RADII = (0.5, 1.0)  # of the two distance classes [m]
LIMITS = {'nearest': (0, 15, 45, 90, 180, -90, -45, -15), 'occupancy': numpy.arange(-157.5, 180, 45)}


def plan(setting):
    """The agents that learned elsewhere, and those that are trained on the tests."""
    return twins.plan(setting) + agent_runs.plan(setting)


def report(setting):
    """The chapter, from the runs' records."""
    chapter = Chapter(NAME, TITLE)
    chapter.add_text(
        'An agent and two obstacles of radius 0.4 m side by side across its way: a: they overlap; b: they all but '
        'touch; c: the gap of 0.4 m is narrower than the agent (0.5 m); d: the gap of 1.1 m can be passed without '
        'coming within the collision radius. State set 1 sees the nearer of the two only and cannot tell a gap from a '
        'wall. The thesis does not say how the agent of these tests was trained, so three readings are shown: as in '
        f'4.1 ({agent_training.SINGLE_EPISODES:,} episodes with one obstacle); then further among several obstacles '
        f'({agent_training.FIELD_EPISODES:,} episodes, as 4.3 does); or on the four tests themselves '
        f'({twins.TWINS_EPISODES:,} episodes). {len(setting.seeds(twins.SEEDS))} seeds, '
        f'{setting.count(twins.EPISODES, 5)} episodes a test, with start and goal at other places than in training.')
    add_same_state(chapter, setting)
    add_failures(chapter, setting)
    add_perceptions(chapter, setting)
    for parameters in twins.PARAMETERS:
        add_twins(chapter, setting, parameters)
    add_tables(chapter, setting)
    add_passage(chapter, setting)
    return chapter


# What the first decision in a scene was made on.


def first_decision(setting, scene, states):
    """Of the agent trained with the thesis's parameters; any table of the set looks up the same rows."""
    folder = twins.folder_of(setting, ('single', states, 'thesis'), 1)
    decisions = read_decisions(folder / 'scenes' / f'{scene}.csv')
    return {name: column[0] for name, column in decisions.items()}


def rows_of(setting, states):
    """The rows that the three scenes of figure 4.13 are mapped to."""
    return [int(first_decision(setting, scene, states)['row']) for scene in twins.SCENES]


def draw_view(panel, setting, scene, states):
    """The scene as the agent perceives it with a state set."""
    decision = first_decision(setting, scene, states)
    return draw_perception(panel, read_scene(setting.scenario(scene), 0),
                           (decision['x'], decision['y'], decision['heading']), sectors_of(decision['occupied']), RADII,
                           LIMITS[states])


def add_same_state(chapter, setting):
    """Figure 4.13."""
    rows = {states: rows_of(setting, states) for states in twins.SETS}
    figure, axes = style.new_figure(1, len(twins.SCENES), 12, 5.3)
    pictures = []
    for i, (panel, (scene, title)) in enumerate(zip(axes[0], twins.SCENES.items())):
        pictures.append(draw_view(panel, setting, scene, 'nearest'))
        panel.set_title(f'({title[0]}) {title[3:]}: row {rows["nearest"][i]} of set 1\n(row {rows["occupancy"][i]} of '
                        'set 2)')
    frame_alike(pictures)
    alike = 'one and the same row' if len(set(rows['nearest'])) == 1 else 'DIFFERENT rows'
    chapter.add_figure(style.save(figure, setting.figure_file('figure_4_13')),
                       f'Figure 4.13: three situations that state set 1 maps to {alike}, '
                       f'{", ".join(map(str, rows["nearest"]))}; set 2 has a row for each: '
                       f'{", ".join(map(str, rows["occupancy"]))}. The arrow is the heading. Red circle: inner radius, '
                       '0.5 m; grey: radius of vision, 1 m; filled: the one sector that set 1 marks as occupied (red: '
                       'class 1, within the inner radius; grey: class 2).')
    chapter.add_table('Rows of the Q-table in the situations of figure 4.13', ['', *twins.SCENES.values()],
                      [[style.SET_NAMES[states], *map(str, rows[states])] for states in twins.SETS], name='same_state')


def add_perceptions(chapter, setting):
    """Figure 4.15."""
    scene = 'same_state_c'
    figure, axes = style.new_figure(1, 2, 9, 4.6)
    for panel, states, letter in zip(axes[0], twins.SETS, 'ab'):
        draw_view(panel, setting, scene, states).frame()
        sectors = sectors_of(first_decision(setting, scene, states)['occupied'])
        classes = ', '.join(f'{sector.begin:g} to {sector.end:g}°: class {sector.distance_class}' for sector in sectors)
        panel.set_title(f'({letter}) {style.SET_NAMES[states]}')
        panel.set_xlabel(wrapped(classes))
    chapter.add_figure(style.save(figure, setting.figure_file('figure_4_15')),
                       'Figure 4.15: one scene as both state sets perceive it: the sectors that each marks as '
                       'occupied, to the radius of their class, angles from straight ahead to the left. Colours as in '
                       'figure 4.13.')


def wrapped(text, width=62):
    """In lines that are not wider, broken after commas."""
    lines = ['']
    for word in text.split(', '):
        if lines[-1] and len(lines[-1]) + len(word) > width:
            lines.append('')
        lines[-1] += (', ' if lines[-1] else '') + word
    return ',\n'.join(lines)


# Walks through the tests.


def find_walk(setting, agent, tests, condition):
    """The first recorded walk, seed by seed, test by test and instance by instance, that fulfils a condition on its
    line of the record: seed, test, instance and whether there is any; else the very first."""
    for seed in setting.seeds(twins.SEEDS):
        record = twins.record_of(setting, agent, seed)
        for test in tests:
            lines = numpy.flatnonzero(of_scenario(record, test))[:setting.count(twins.WALKED, 2)]
            for instance, line in enumerate(lines):
                if condition({name: column[line] for name, column in record.items()}):
                    return seed, test, instance, True
    return 1, tests[0], 0, False


def draw_walk(panel, setting, agent, seed, test, instance):
    folder = twins.drawn_folder(setting, agent, seed)
    draw_scene(panel, folder / f'{test}.yaml', folder / f'{test}.csv', instance, '#d62728', '#c9c3e6')
    panel.set_xlim(-3.1, 3.1)
    panel.set_ylim(-3.3, 3.6)
    panel.label_outer()


def ending(line):
    """How a walk went, in words."""
    words = 'arrives' if line['arrived'] else 'does not arrive'
    if line['touched']:
        return words + ', goes through an obstacle'
    return words + (', collides' if line['collided'] else '')


FAILURES = (
    ('one obstacle in sight', (twins.ALONE,), lambda line: line['arrived'] and not line['collided']),
    ('two: dances', ('twins_b', 'twins_c', 'twins_a'), lambda line: not line['arrived']),
    ('two: goes in', ('twins_b', 'twins_c', 'twins_d', 'twins_a'), lambda line: line['touched'] or line['collided']),
)


def add_failures(chapter, setting):
    """Figure 4.14."""
    agent = ('single', 'nearest', 'thesis')
    figure, axes = style.new_figure(1, len(FAILURES), 12, 5.8, sharex=True, sharey=True)
    for panel, letter, (title, tests, condition) in zip(axes[0], 'abc', FAILURES):
        seed, test, instance, found = find_walk(setting, agent, tests, condition)
        draw_walk(panel, setting, agent, seed, test, instance)
        record = twins.record_of(setting, agent, seed)
        line = numpy.flatnonzero(of_scenario(record, test))[instance]
        words = ending({name: column[line] for name, column in record.items()})
        panel.set_title(f'({letter}) {title if found else "no such walk was found"}\n{test}, seed {seed}: {words}')
    rates_of = {test: [Spread(values).mean for values in zip(*twins.measured(setting, agent, test))]
                for test in (twins.ALONE, 'twins_b', 'twins_c')}
    told = '; '.join(f'{test}: {success:.0f} % arrive, {collision:.0f} % collide'
                     for test, (success, _, collision) in rates_of.items())
    chapter.add_figure(style.save(figure, setting.figure_file('figure_4_14')),
                       "Figure 4.14: the twins test with state set 1, thesis's parameters, trained as in 4.1. (a) Only "
                       'one of the obstacles ever comes into sight: the first recorded walk that arrives without a '
                       'collision. (b) Two obstacles in sight: the first that does not arrive. (c) The first that '
                       'collides with an obstacle or goes through it. First: in the order of the seeds, of the tests '
                       f'b, c, and of the instances. All seeds and instances: {label}.')


def add_twins(chapter, setting, parameters):
    """Figure 4.16, for a set of parameters."""
    agent = (DRAWN[parameters], 'occupancy', parameters)
    figure, axes = style.new_figure(2, 2, 8.4, 10.4, sharex=True, sharey=True)
    for panel, (test, title) in zip(axes.flat, twins.TESTS.items()):
        seed, _, instance, found = find_walk(setting, agent, [test],
                                             lambda line: line['arrived'] and not line['collided'])
        draw_walk(panel, setting, agent, seed, test, instance)
        success, _, collision = (Spread(values).mean for values in zip(*twins.measured(setting, agent, test)))
        panel.set_title(f'({title[0]}) {title[3:]}, seed {seed}' + ('' if found else ' (fails)') +
                        f'\nof all: {success:.0f} % arrive, {collision:.0f} % collide')
    suffix = '' if parameters == 'thesis' else f'_{parameters}'
    chapter.add_figure(style.save(figure, setting.figure_file(f'figure_4_16{suffix}')),
                       f'Figure 4.16 with {names.PARAMETER_NAMES[parameters]}: the twins test with state set 2, '
                       f'{twins.TRAININGS[DRAWN[parameters]]}. Of each test the first recorded walk, seed by seed, '
                       'that arrives without a collision; where there is none the very first walk. Above each: how '
                       f'many of all walks ({len(setting.seeds(twins.SEEDS))} seeds) arrive and collide.')


def passage(setting, agent, seed):
    """Of the recorded walks of test d, the shares [%] that pass between the obstacles and around both."""
    tracks = read_tracks(twins.drawn_folder(setting, agent, seed) / 'twins_d.csv')
    places = [crossing(track[:, 0], 0.0) for track in tracks.values()]
    between = [place is not None and abs(place) < HALF_GAP for place in places]
    around = [place is not None and abs(place) >= HALF_GAP for place in places]
    return percent(between), percent(around)


def passages(setting, agent):
    """Of all seeds: the shares that pass between, and those around."""
    return tuple(zip(*(passage(setting, agent, seed) for seed in setting.seeds(twins.SEEDS))))


def decisions_needed(setting, agent, test):
    """How many decisions those who arrived made, the median, for each seed; nan where none arrived."""
    return [median(record['ticks'][of_scenario(record, test) & (record['arrived'] > 0)])
            for record in twins.records_of(setting, agent)]


def add_tables(chapter, setting):
    for parameters in twins.PARAMETERS:
        rows = []
        for training, label in twins.TRAININGS.items():
            for states in twins.SETS:
                rows += test_rows(setting, (training, states, parameters),
                                  f'{style.short_set_name(states)}, {label}')
        chapter.add_table(f'Twins tests, {names.PARAMETER_NAMES[parameters]}: mean ± standard deviation over the seeds '
                          '(lowest-highest); path ratio and decisions: the median of those that arrived, seed by seed, '
                          'of the seeds in which any did',
                          ['', 'success %', 'collision %', 'contact %', 'path ratio (arrivals only)',
                           'decisions (arrivals only)', 'rows visited in training'], rows, name=f'twins_{parameters}')


def test_rows(setting, agent, label):
    """A row of the table for each test."""
    rows = []
    records = twins.records_of(setting, agent)
    visited = Spread(float(read_table_header(twins.table_of(setting, agent, seed))['visited_rows'])
                     for seed in setting.seeds(twins.SEEDS))
    for test, title in twins.TESTS.items():
        success, contact, collision = map(Spread, zip(*twins.measured(setting, agent, test)))
        ratios = Spread.of_numbers(median(record['path_ratio'][of_scenario(record, test) & (record['arrived'] > 0)])
                                   for record in records)
        needed = Spread.of_numbers(decisions_needed(setting, agent, test))
        rows.append([f'{label}, {title}', success.text(1), collision.text(1), contact.text(1), ratios.text(2),
                     needed.text(0), visited.text(0)])
    return rows


def add_passage(chapter, setting):
    rows = []
    for parameters in twins.PARAMETERS:
        for training, label in twins.TRAININGS.items():
            between, around = map(Spread, passages(setting, (training, 'occupancy', parameters)))
            rows.append([f'{names.PARAMETER_NAMES[parameters]}, {label}', between.text(1), around.text(1)])
    chapter.add_table('The tight gap (d) with state set 2: ways taken, % of all walks; the rest never passes the '
                      'obstacles. Mean ± standard deviation over the seeds (lowest-highest)',
                      ['', 'between the obstacles %', 'around both %'], rows, name='passage')
