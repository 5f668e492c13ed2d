"""Figures 4.13-4.16: situations that state set 1 does not distinguish, and two obstacles side by side."""
import numpy
from crowd_drawing.files import read_scene
from crowd_experiments import style
from crowd_experiments.pages import Chapter
from crowd_experiments.records import Spread, median, of_scenario, percent, read_table_header, read_tracks
from crowd_studies.scene_figures import draw_perception, draw_scene, frame_alike

from .. import agent_runs, agent_training, names, twins_runs as twins
from ..measures import crossing, read_decisions, sectors_of

NAME = twins.NAME
TITLE = 'Ambiguity of state set 1: the twins tests (figures 4.13-4.16)'
DRAWN = {'thesis': 'single', 'better': 'field'}  # the training that figure 4.16 shows
HALF_GAP = 0.95  # [m] of test d: distance of the obstacles' centres from the straight line to the goal
RADII = (0.5, 1.0)  # of the two distance classes [m]
LIMITS = {'nearest': (0, 15, 45, 90, 180, -90, -45, -15), 'occupancy': numpy.arange(-157.5, 180, 45)}


def plan(setting):
    """Returns the runs of the agents that are trained elsewhere, and of those that are trained on the tests."""
    return twins.plan(setting) + agent_runs.plan(setting)


def report(setting):
    """The chapter, from the runs' records."""
    chapter = Chapter(NAME, TITLE)
    chapter.add_text(
        'Two obstacles of radius 0.4 m lie side by side between an agent and its goal: a: they overlap; b: they almost '
        'touch; c: the gap of 0.4 m is narrower than the agent (0.5 m); d: the agent can pass the gap of 1.1 m without '
        'a collision. State set 1 contains only the nearer of the two and cannot distinguish a gap from a wall. The '
        'thesis does not state how the agent of these tests was trained, so three variants are shown: as in '
        f'4.1 ({agent_training.SINGLE_EPISODES:,} episodes with one obstacle); then further among several obstacles '
        f'({agent_training.FIELD_EPISODES:,} episodes, as in 4.3); or on the four tests '
        f'({twins.TWINS_EPISODES:,} episodes). {len(setting.seeds(twins.SEEDS))} seeds, '
        f'{setting.count(twins.EPISODES, 5)} episodes per test; starts and goals differ from those of the training.')
    add_same_state(chapter, setting)
    add_failures(chapter, setting)
    add_perceptions(chapter, setting)
    for parameters in twins.PARAMETERS:
        add_twins(chapter, setting, parameters)
    add_tables(chapter, setting)
    add_passage(chapter, setting)
    return chapter


# The perception at the first decision in a scene.


def first_decision(setting, scene, states):
    """Returns the first decision of the agent trained with the thesis's parameters; the row depends only on the state
    set."""
    folder = twins.folder_of(setting, ('single', states, 'thesis'), 1)
    decisions = read_decisions(folder / 'scenes' / f'{scene}.csv')
    return decisions.iloc[0]


def rows_of(setting, states):
    """Returns the rows of the three scenes of figure 4.13."""
    return [int(first_decision(setting, scene, states)['row']) for scene in twins.SCENES]


def draw_view(panel, setting, scene, states):
    """Draws the scene as the agent perceives it with a state set."""
    decision = first_decision(setting, scene, states)
    return draw_perception(panel, read_scene(setting.scenario(scene), 0),
                           (decision['x'], decision['y'], decision['heading']), sectors_of(decision['occupied']), RADII,
                           LIMITS[states])


def add_same_state(chapter, setting):
    """Adds figure 4.13."""
    rows = {states: rows_of(setting, states) for states in twins.SETS}
    figure, axes = style.new_figure(1, len(twins.SCENES), 12, 5.3)
    pictures = []
    for i, (panel, (scene, title)) in enumerate(zip(axes[0], twins.SCENES.items())):
        pictures.append(draw_view(panel, setting, scene, 'nearest'))
        panel.set_title(f'({title[0]}) {title[3:]}: row {rows["nearest"][i]} of set 1\n(row {rows["occupancy"][i]} of '
                        'set 2)')
    frame_alike(pictures)
    alike = 'the same row' if len(set(rows['nearest'])) == 1 else 'DIFFERENT rows'
    chapter.add_figure(style.save(figure, setting.figure_file('figure_4_13')),
                       f'Figure 4.13: three situations that state set 1 maps to {alike}, '
                       f'{", ".join(map(str, rows["nearest"]))}; set 2 has one row for each: '
                       f'{", ".join(map(str, rows["occupancy"]))}. The arrow is the heading. Red circle: inner radius, '
                       '0.5 m; grey: radius of vision, 1 m; filled: the sector that set 1 marks as occupied (red: '
                       'class 1, within the inner radius; grey: class 2).')
    chapter.add_table('Rows of the Q-table in the situations of figure 4.13', ['', *twins.SCENES.values()],
                      [[style.SET_NAMES[states], *map(str, rows[states])] for states in twins.SETS], name='same_state')


def add_perceptions(chapter, setting):
    """Adds figure 4.15."""
    scene = 'same_state_c'
    figure, axes = style.new_figure(1, 2, 9, 4.6)
    for panel, states, letter in zip(axes[0], twins.SETS, 'ab'):
        draw_view(panel, setting, scene, states).frame()
        sectors = sectors_of(first_decision(setting, scene, states)['occupied'])
        classes = ', '.join(f'{sector.begin:g} to {sector.end:g}°: class {sector.distance_class}' for sector in sectors)
        panel.set_title(f'({letter}) {style.SET_NAMES[states]}')
        panel.set_xlabel(wrapped(classes))
    chapter.add_figure(style.save(figure, setting.figure_file('figure_4_15')),
                       'Figure 4.15: one scene as represented by both state sets. Filled: the occupied sectors, up to '
                       'the radius of their class. Angles are measured from straight ahead to the left. Colours as in '
                       'figure 4.13.')


def wrapped(text, width=62):
    """Returns the text in lines of at most this width, broken after commas."""
    lines = ['']
    for word in text.split(', '):
        if lines[-1] and len(lines[-1]) + len(word) > width:
            lines.append('')
        lines[-1] += (', ' if lines[-1] else '') + word
    return ',\n'.join(lines)


# Recorded episodes of the tests.


def find_walk(setting, agent, tests, condition):
    """Returns seed, test and instance of the first recorded episode whose row of the record meets a condition, and
    whether there is one; otherwise the first episode. Order: seeds, tests, instances."""
    for seed in setting.seeds(twins.SEEDS):
        record = twins.records_of(setting, agent)[seed - 1]
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
    """Returns the outcome of an episode as a text."""
    words = 'arrives' if line['arrived'] else 'does not arrive'
    if line['touched']:
        return words + ', contact with an obstacle'
    return words + (', collision' if line['collided'] else '')


FAILURES = (
    ('one obstacle perceived', (twins.ALONE,), lambda line: line['arrived'] and not line['collided']),
    ('two: oscillates', ('twins_b', 'twins_c', 'twins_a'), lambda line: not line['arrived']),
    ('two: collides', ('twins_b', 'twins_c', 'twins_d', 'twins_a'), lambda line: line['touched'] or line['collided']),
)


def add_failures(chapter, setting):
    """Adds figure 4.14."""
    agent = ('single', 'nearest', 'thesis')
    figure, axes = style.new_figure(1, len(FAILURES), 12, 5.8, sharex=True, sharey=True)
    for panel, letter, (title, tests, condition) in zip(axes[0], 'abc', FAILURES):
        seed, test, instance, found = find_walk(setting, agent, tests, condition)
        draw_walk(panel, setting, agent, seed, test, instance)
        record = twins.records_of(setting, agent)[seed - 1]
        line = numpy.flatnonzero(of_scenario(record, test))[instance]
        words = ending({name: column[line] for name, column in record.items()})
        panel.set_title(f'({letter}) {title if found else "no such episode"}\n{test}, seed {seed}: {words}')
    rates_of = {test: [Spread(values).mean for values in zip(*twins.measured(setting, agent, test))]
                for test in (twins.ALONE, 'twins_b', 'twins_c')}
    text = '; '.join(f'{test}: success {success:.0f} %, collision {collision:.0f} %'
                     for test, (success, _, collision) in rates_of.items())
    chapter.add_figure(style.save(figure, setting.figure_file('figure_4_14')),
                       "Figure 4.14: the twins test with state set 1, thesis's parameters, trained as in 4.1. (a) The "
                       'agent perceives only one of the obstacles: the first recorded episode in which it arrives '
                       'without a collision. (b) The agent perceives both obstacles: the first episode in which it '
                       'does not arrive. (c) The first episode with a collision or a contact. Order: seeds, tests b '
                       f'and c, instances. All seeds and instances: {text}.')


def add_twins(chapter, setting, parameters):
    """Adds figure 4.16 for a set of parameters."""
    agent = (DRAWN[parameters], 'occupancy', parameters)
    figure, axes = style.new_figure(2, 2, 8.4, 10.4, sharex=True, sharey=True)
    for panel, (test, title) in zip(axes.flat, twins.TESTS.items()):
        seed, _, instance, found = find_walk(setting, agent, [test],
                                             lambda line: line['arrived'] and not line['collided'])
        draw_walk(panel, setting, agent, seed, test, instance)
        success, _, collision = (Spread(values).mean for values in zip(*twins.measured(setting, agent, test)))
        panel.set_title(f'({title[0]}) {title[3:]}, seed {seed}' + ('' if found else ' (fails)') +
                        f'\nall: success {success:.0f} %, collision {collision:.0f} %')
    suffix = '' if parameters == 'thesis' else f'_{parameters}'
    chapter.add_figure(style.save(figure, setting.figure_file(f'figure_4_16{suffix}')),
                       f'Figure 4.16 with {names.PARAMETER_NAMES[parameters]}: the twins test with state set 2, '
                       f'{twins.TRAININGS[DRAWN[parameters]]}. For each test the first recorded episode, in the order '
                       'of the seeds, in which the agent arrives without a collision; if there is none, the first '
                       f'episode. Titles: rates over all episodes of {len(setting.seeds(twins.SEEDS))} seeds.')


def passage(setting, agent, seed):
    """Returns the shares [%] of the recorded episodes of test d in which the agent passes between the obstacles, and
    around both."""
    tracks = read_tracks(twins.drawn_folder(setting, agent, seed) / 'twins_d.csv')
    places = [crossing(track[:, 0], 0.0) for track in tracks.values()]
    between = [place is not None and abs(place) < HALF_GAP for place in places]
    around = [place is not None and abs(place) >= HALF_GAP for place in places]
    return percent(between), percent(around)


def passages(setting, agent):
    """Returns the shares of passage() for all seeds: between the obstacles, and around both."""
    return tuple(zip(*(passage(setting, agent, seed) for seed in setting.seeds(twins.SEEDS))))


def decisions_needed(setting, agent, test):
    """Returns the median number of decisions of the agents that arrived, for each seed; nan without arrivals."""
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
                          '(lowest-highest); path ratio and decisions: the median of the arrivals for each seed, of '
                          'the seeds with arrivals',
                          ['', *names.RATES, 'path ratio (arrivals only)',
                           'decisions (arrivals only)', 'rows visited in training'], rows, name=f'twins_{parameters}')


def test_rows(setting, agent, label):
    """Returns a row of the table for each test."""
    rows = []
    records = twins.records_of(setting, agent)
    files = (twins.folder_of(setting, agent, seed) / twins.TABLES[agent[0]] for seed in setting.seeds(twins.SEEDS))
    visited = Spread(float(read_table_header(file)['visited_rows']) for file in files)
    for test, title in twins.TESTS.items():
        ratios = Spread.of_numbers(median(record['path_ratio'][of_scenario(record, test) & (record['arrived'] > 0)])
                                   for record in records)
        needed = Spread.of_numbers(decisions_needed(setting, agent, test))
        rows.append([f'{label}, {title}', *names.rate_texts(twins.measured(setting, agent, test)), ratios.text(2),
                     needed.text(0), visited.text(0)])
    return rows


def add_passage(chapter, setting):
    rows = []
    for parameters in twins.PARAMETERS:
        for training, label in twins.TRAININGS.items():
            between, around = map(Spread, passages(setting, (training, 'occupancy', parameters)))
            rows.append([f'{names.PARAMETER_NAMES[parameters]}, {label}', between.text(1), around.text(1)])
    chapter.add_table('The tight gap (d) with state set 2: paths, % of all episodes; in the other episodes the agent '
                      'does not pass the obstacles. Mean ± standard deviation over the seeds (lowest-highest)',
                      ['', 'between the obstacles %', 'around both %'], rows, name='passage')
