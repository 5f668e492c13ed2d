"""The scenarios of section 4.3: their runs, groups in them (4.22, 4.23), surrounded agents (4.25), figures 4.17-25."""
import functools

import numpy
import pandas
from crowd_drawing.files import read_scene, read_walks
from crowd_drawing.picture import colours_of
from crowd_experiments import style
from crowd_studies.scene_figures import draw_moment, draw_scene, frame_alike, last_tick_of

from . import measures
from .declared import BETTER, DRAWN, THESIS
from .results import PARAMETER_NAMES, Runs, episodes_of, means_sentence, obstacle_places

SCENARIOS = {
    'dummies': 'a field of static dummies', 'circle6': 'six agents on a circle, each walks to the opposite point',
    'circle6_obstacle': 'six agents on a circle around an obstacle',
    'line6': 'six agents side by side, all paths cross',
    'line6_mover': 'six agents side by side, all paths cross, with a moving obstacle',
    'same_goal6': 'six agents with one goal', 'same_goal6_mover': 'six agents with one goal, with a moving obstacle',
    'circle12': 'twelve agents on a circle', 'circle12_varied': 'twelve agents on a circle, at varied speeds'}
OBSTRUCTED = 'circle12_varied_obstacle'  # 4.25 with an obstacle in the middle
WATCHED = ('circle12', 'circle12_varied', OBSTRUCTED)  # every decision is recorded
EXACT = ('circle12_exact', 'circle12_exact_simultaneous')
FREE, CROSSED = 'same_goal6_far', 'same_goal6_mover_far'
APART = 'line6'  # agents with the same starts as in these, but different goals
# Of the others: demo.csv.
RECORDS = {'dummies_wide': 'wide.csv', OBSTRUCTED: 'obstacle.csv', **dict.fromkeys(EXACT, 'exact.csv')}
OBSTACLE_RADIUS, VISION = 0.4, 1.0  # [m]
REACH = OBSTACLE_RADIUS + VISION  # [m] within this distance an agent perceives the rim
TIMES = ('before the passage', 'during the passage', 'after the passage', 'at the first arrival')
LEAST_SECTORS = 7  # of 8 occupied: "in almost every single angle interval"
SOON = 10  # [ticks], in which an agent walks 0.3 m, which is more than its radius
VISIT_CLASSES = {0: 'never', 1: '1-9 times', 10: '10-99 times', 100: '100 times or more'}
CROWDED = 3  # sectors
MOMENTS = (0.15, 0.4, 0.65, 1.0)  # fractions of the time until the last arrival
NUMBERS = {'circle6': '4_18', 'circle6_obstacle': '4_19', 'line6': '4_20', 'line6_mover': '4_21', 'same_goal6': '4_22',
           'same_goal6_mover': '4_23'}
DUMMIES = ((THESIS, 'dummies'), (THESIS, 'dummies_wide'), (BETTER, 'dummies'))  # the rows of figure 4.17
DUMMY_COLOUR = '#d63ad6'  # magenta in the thesis
PATH_COLOUR = '#d62728'
SURROUNDED_COLOUR = '#ff7f0e'  # orange in the thesis
CURVES = ((FREE, '#0072b2', 'six to one goal'), (CROSSED, '#d55e00', 'the same with a moving obstacle'),
          (APART, '0.55', 'for comparison: goals apart (line6)'))


def agents(setting, parameters=THESIS, states='occupancy'):
    """Returns the runs of agents that learned alone. Figures 4.17-4.25 show those with state set 2."""
    return Runs.of(setting, 'agents', states=states, parameters=parameters)


def record_file(scenario):
    return RECORDS.get(scenario, 'demo.csv')


def rates(runs, scenario):
    return runs.rates(record_file(scenario), scenario)


def groups_of(runs, seed, scenario):
    """Returns the recorded places of each instance before the first arrival."""
    return [measures.while_all_are_there(places) for places in runs.tracks(seed, f'{scenario}.csv').values()]


def spans_of(places, obstacle):
    """Returns the ticks before and during the passage, the tick after it, and the last tick. None if there is no
    passage, if it begins at the first tick, or if it has not ended at the first arrival."""
    times = measures.passing(places, obstacle, REACH)
    if times is None or times[0] == 0 or times[1] + 1 >= len(places):
        return None
    return (slice(0, times[0]), slice(times[0], times[1] + 1), slice(times[1], times[1] + 1),
            slice(len(places) - 1, len(places)))


def companions(places):
    """Returns the distance to the nearest companion at each tick, mean of all agents [m]."""
    return measures.nearest_distances(places).mean(axis=1)


GROUPING = {'nearest companion': companions, 'centre of the group': measures.centre_distances}


@functools.lru_cache(maxsize=None)
def phases(runs, measure):
    """Returns an array (seed, 4, 2): for each seed and each of TIMES the mean with the obstacle, and the mean without
    it at the same ticks [m]. The last of TIMES without the obstacle is the first arrival there."""
    obstacle = obstacle_places(runs.setting, 'same_goal6_mover', 2001)
    seeds = []
    for seed in runs.seeds():
        values = [[] for _ in TIMES]
        for places, free in zip(groups_of(runs, seed, CROSSED), groups_of(runs, seed, FREE)):
            for time, span in enumerate(spans_of(places, obstacle) or ()):
                same = measure(free)[span if time < len(TIMES) - 1 else slice(-1, None)]
                values[time].append((measure(places)[span].mean(), same.mean() if len(same) else numpy.nan))
        seeds.append([numpy.nanmean(pairs, axis=0) if pairs else (numpy.nan, numpy.nan) for pairs in values])
    return numpy.array(seeds)


def last_metre(runs, scenario):
    """Returns distances to the nearest companion at the start and at the first arrival [m], a pair for each seed."""
    return numpy.array([numpy.mean([companions(places)[[0, -1]] for places in groups_of(runs, seed, scenario)], axis=0)
                        for seed in runs.seeds()])


@functools.lru_cache(maxsize=None)
def surrounded(runs, scenario, instances=numpy.inf):
    """Returns a Surrounded for each seed, from the first recorded instances."""
    found = []
    record = runs.record(record_file(scenario), scenario)
    arrivals = record[record['arrived'] > 0]
    obstacle = OBSTACLE_RADIUS if scenario == OBSTRUCTED else None
    for seed in runs.seeds():
        decisions, there = runs.decisions(seed, scenario), arrivals[arrivals['seed'] == seed]
        found.append(measures.surrounded(decisions[decisions['instance'] < instances],
                                         set(zip(there['episode'], there['agent'])), LEAST_SECTORS, SOON, obstacle))
    return found


def middle_spreads(runs, scenario):
    """Returns the standard deviation of the times at which the agents reach the middle [s], the mean of the recorded
    instances, for each seed."""
    return [0.1 * numpy.mean([numpy.nanstd(measures.first_ticks(places, (0.0, 0.0), VISION), ddof=1)
                              for places in runs.tracks(seed, f'{scenario}.csv').values()]) for seed in runs.seeds()]


def hidden_shares(runs, scenario):
    """Returns the share [%] of the bodies within the radius of vision that are wholly hidden, for each seed."""
    return [numpy.mean([measures.hidden_share(places[::10], measures.RADIUS, VISION)
                        for places in runs.tracks(seed, f'{scenario}.csv').values()]) for seed in runs.seeds()]


@functools.lru_cache(maxsize=None)
def by_visits(runs, scenario, least_sectors):
    return [measures.by_visits(runs.decisions(seed, scenario), runs.visits(seed), list(VISIT_CLASSES), SOON,
                               least_sectors) for seed in runs.seeds()]


def recorded(runs, scenario):
    """Returns the recorded episodes, by seed and instance, with the numbers of agents that did `not_arrive`."""
    episodes = episodes_of(runs.record(record_file(scenario), scenario))
    episodes['not_arrived'] = episodes['agents'] - episodes['arrived']
    return episodes.query(f'episode < {runs.setting.count(5, 2)}')


def add_dummies(chapter, setting):
    """Adds figure 4.17: four episodes with the complete paths."""
    figure, axes = style.new_figure(len(DUMMIES), 4, 13, 9, sharex='row', sharey='row')
    texts = [f'{PARAMETER_NAMES[parameters]}, {scenario}: '
             f'{means_sentence(rates(agents(setting, parameters), scenario))}'
             for parameters, scenario in DUMMIES]
    sizes = [draw_dummies(line, agents(setting, parameters), scenario, PARAMETER_NAMES[parameters])
             for line, (parameters, scenario) in zip(axes, DUMMIES)]
    figure.set_size_inches(13, sum(0.9 + 3.0 * height / width for width, height in sizes))
    chapter.draw(figure, 'figure_4_17_dummies', rates='; '.join(texts))


def draw_dummies(line, runs, scenario, name):
    """Draws four episodes side by side, first those in which the agent arrives. Returns width and height [m]."""
    episodes = recorded(runs, scenario).sort_values('not_arrived', kind='stable')
    pictures = []
    for panel, letter, ((seed, instance), episode) in zip(line, 'abcd', episodes.iterrows()):
        folder = runs.folder(seed)
        pictures.append(draw_scene(panel, folder / f'{scenario}.yaml', folder / f'{scenario}.csv', int(instance),
                                   PATH_COLOUR, DUMMY_COLOUR))
        panel.set_title(f'({letter}) seed {seed}: ' + ('does not arrive' if episode.not_arrived else 'arrives'))
        panel.label_outer()
    line[0].set_ylabel(f'{name},\n{scenario}\ny [m]')
    return frame_alike(pictures)


def draw_row(line, runs, scenario, episode, name, moments=None, marked=None):
    """Draws four moments of an episode side by side. Returns the pictures."""
    seed, instance = episode[0], int(episode[1])
    folder = runs.folder(seed)
    scene = read_scene(folder / f'{scenario}.yaml', instance)
    _, walks = read_walks(folder / f'{scenario}.csv', instance)
    colours = colours_of(len(scene.agents))
    if marked is not None:
        colours = [SURROUNDED_COLOUR if agent == marked else '#7a9cc6' for agent in range(len(colours))]
    last = last_tick_of(walks)
    pictures = []
    for panel, letter, tick in zip(line, 'abcd', moments or [round(moment * last) for moment in MOMENTS]):
        tick = min(max(0, tick), last)
        pictures.append(draw_moment(panel, scene, walks, tick, colours, marked=marked))
        panel.set_title(f'({letter}) {tick * scene.tick:.1f} s, seed {seed}')
    line[0].set_ylabel(f'{name}\ny [m]')
    return pictures


def add_rows(chapter, setting, scenario, file, text, choose, sentence, **values):
    """Adds four moments of one episode; top: thesis's parameters, bottom: better parameters. `choose` returns the
    episode, and moments and a marked agent if there are some; `sentence` a text about it."""
    figure, axes = style.new_figure(2, len(MOMENTS), 13, 6.9)
    pictures, texts = [], []
    for line, parameters in zip(axes, DRAWN):
        runs = agents(setting, parameters)
        chosen = choose(runs, scenario)
        pictures += draw_row(line, runs, scenario, chosen[0], PARAMETER_NAMES[parameters], *chosen[1:])
        texts.append(f'{PARAMETER_NAMES[parameters]}: {sentence(runs, scenario, *chosen)}')
    for panel in axes[-1]:
        panel.set_xlabel('x [m]')
    width, height = frame_alike(pictures)
    figure.set_size_inches(13, len(axes) * (0.75 + 3.0 * height / width))
    chapter.draw(figure, file, text, key=chapter.text_of('key'), texts='; '.join(texts), **values)


def add_figures(chapter, setting):
    """Adds figures 4.18 to 4.25."""
    for scenario, number in NUMBERS.items():
        add_rows(chapter, setting, scenario, f'figure_{number}_{scenario}', 'moments', first_success, rates_sentence,
                 number=number.replace('_', '.'), title=SCENARIOS[scenario])
    add_rows(chapter, setting, 'circle12', 'figure_4_24_best', 'best', best_of, outcome_sentence)
    add_rows(chapter, setting, OBSTRUCTED, 'figure_4_25_worst', 'worst', worst_of, worst_sentence)


def first_success(runs, scenario):
    """Returns the first recorded episode in which all agents arrive; if there is none, the first episode."""
    return [recorded(runs, scenario)['not_arrived'].astype(bool).idxmin()]


def rates_sentence(runs, scenario, *_):
    """Returns a text with the rates of the agents, and the share of episodes in which all agents arrive."""
    whole = runs.whole(record_file(scenario), scenario).mean()
    return f'{means_sentence(rates(runs, scenario), 1)}; all agents arrive in {whole:.0f} % of the episodes'


def best_of(runs, scenario):
    order = ['not_arrived', 'collided', 'touched', 'ticks']
    return [recorded(runs, scenario).sort_values(order, kind='stable').index[0]]


def outcome_sentence(runs, scenario, episode, *_):
    row = recorded(runs, scenario).loc[episode].astype(int)
    return (f'{row.arrived} of 12 arrive, {row.collided} collide, {row.touched} have a contact, {row.ticks} decisions')


def worst_of(runs, scenario):
    """Returns the worst recorded episode of all seeds, with its moments and the agent that was surrounded most."""
    order = ['touched', 'not_arrived', 'collided', 'ticks']
    worst = recorded(runs, scenario).sort_values(order, ascending=False, kind='stable').index[0]
    decisions = runs.decisions(worst[0], scenario)
    crowded = decisions[(decisions['instance'] == worst[1]) & (decisions['sectors'] >= LEAST_SECTORS)]
    if crowded.empty:
        return [worst]
    agent = int(numpy.argmax(numpy.bincount(crowded['agent'])))
    first = int(crowded['tick'][crowded['agent'] == agent].min())
    return [worst, [first - 40, first, first + 20, 2000], agent]


def worst_sentence(runs, scenario, episode, _moments=None, marked=None):
    return outcome_sentence(runs, scenario, episode) + (
        ', no agent is surrounded' if marked is None else f', agent {marked} is surrounded')


def add_groups(chapter, setting):
    """Adds the figure of mean distances to the nearest companion, with and without a moving obstacle; its passage is
    shaded from the median of the begins to that of the ends."""
    obstacle = obstacle_places(setting, 'same_goal6_mover', 2001)
    figure, axes = style.new_figure(1, len(DRAWN), 11, 4, sharey=True)
    for panel, parameters in zip(axes[0], DRAWN):
        runs = agents(setting, parameters)
        for scenario, colour, label in CURVES:
            curves = [companions(places) for seed in runs.seeds() for places in groups_of(runs, seed, scenario)]
            half = int(numpy.median(list(map(len, curves))))  # then half of the groups have begun to arrive
            curve = pandas.DataFrame(curves).mean()[:half]
            panel.plot(0.1 * numpy.arange(len(curve)), curve, color=colour, label=label)
        spans = [span for seed in runs.seeds() for places in groups_of(runs, seed, CROSSED)
                 if (span := spans_of(places, obstacle))]
        if spans:
            begin, end = (0.1 * numpy.median([span[time].start for span in spans]) for time in (1, 2))
            panel.axvspan(begin, end, color='#d55e00', alpha=0.12, linewidth=0)
        panel.set(title=PARAMETER_NAMES[parameters], xlabel='time [s]')
    axes[0][0].set(ylabel='distance to the nearest companion [m]', ylim=(0, None))
    axes[0][0].legend(loc='lower left')
    chapter.draw(figure, 'figure_4_22_4_23_groups')
