"""Figures 4.17 to 4.25: the scenarios."""
import numpy

from crowd_drawing.files import read_scene, read_walks
from crowd_drawing.picture import colours_of
from crowd_experiments import style
from crowd_experiments.records import Spread
from crowd_studies.scene_figures import draw_moment, draw_scene, frame_alike, last_tick_of

from . import names, scenario_runs as runs, surroundings

MOMENTS = (0.15, 0.4, 0.65, 1.0)  # fractions of the time until the last arrival
NUMBERS = {'circle6': '4_18', 'circle6_obstacle': '4_19', 'line6': '4_20', 'line6_mover': '4_21', 'same_goal6': '4_22',
           'same_goal6_mover': '4_23'}
DUMMY_COLOUR = '#d63ad6'  # magenta in the thesis
PATH_COLOUR = '#d62728'
SURROUNDED_COLOUR = '#ff7f0e'  # orange in the thesis
KEY = 'Discs: bodies; circles: agents that have arrived and are removed; crosses: goals; grey: obstacles.'


def recorded(setting):
    """Returns seed and instance of each recorded episode."""
    return [(seed, instance) for seed in setting.seeds(runs.SEEDS) for instance in range(setting.count(runs.WALKED, 2))]


def all_arrive(setting, table, scenario, seed, instance):
    episodes = runs.episodes_of(setting, table, seed, scenario)
    return episodes['arrived'][instance] == episodes['agents']


def rates_sentence(setting, table, scenario):
    """Returns a text with the rates of the agents, and the share of episodes in which all agents arrive."""
    whole = Spread(100.0 * numpy.mean(episodes['arrived'] == episodes['agents']) for episodes in
                   (runs.episodes_of(setting, table, seed, scenario) for seed in setting.seeds(runs.SEEDS)))
    return (f'{names.means_sentence(runs.measured(setting, table, scenario), 1)}; all agents arrive in '
            f'{whole.mean:.0f} % of the episodes')


def first_success(setting, table, scenario):
    """Returns the first recorded episode in which all agents arrive; if there is none, the first episode."""
    episodes = recorded(setting)
    return next((episode for episode in episodes if all_arrive(setting, table, scenario, *episode)), episodes[0])


DUMMIES = (('thesis', 'dummies'), ('thesis', runs.WIDE), ('better', 'dummies'))  # the rows of figure 4.17


def add_dummies(chapter, setting):
    """Adds figure 4.17: four episodes with the complete paths."""
    figure, axes = style.new_figure(len(DUMMIES), 4, 13, 9, sharex='row', sharey='row')
    texts = []
    sizes = [draw_dummies(line, setting, ('agent', 'occupancy', parameters), scenario, texts)
             for line, (parameters, scenario) in zip(axes, DUMMIES)]
    figure.set_size_inches(13, sum(0.9 + 3.0 * height / width for width, height in sizes))
    chapter.add_figure(style.save(figure, setting.figure_file('figure_4_17_dummies')),
                       'Figure 4.17: one agent in a field of static dummies (magenta); four episodes with the complete '
                       'paths. Set 2, one agent\'s table. The first recorded episodes, in the order of the seeds, in '
                       'which the agent arrives; if there are fewer than four, followed by the first episodes in which '
                       f'it does not arrive. {runs.WIDE}: the same dummies at {runs.WIDER:g} times the distances. '
                       f'{"; ".join(texts)}.')


def draw_dummies(line, setting, table, scenario, texts):
    """Draws four episodes side by side, first those in which the agent arrives. Returns width and height [m]."""
    chosen = sorted(recorded(setting),
                    key=lambda episode: not all_arrive(setting, table, scenario, *episode))
    pictures = []
    for panel, letter, (seed, instance) in zip(line, 'abcd', chosen):
        folder = runs.folder_of(setting, table, seed)
        pictures.append(draw_scene(panel, folder / f'{scenario}.yaml', folder / f'{scenario}.csv', instance,
                                   PATH_COLOUR, DUMMY_COLOUR))
        arrives = all_arrive(setting, table, scenario, seed, instance)
        panel.set_title(f'({letter}) seed {seed}: ' + ('arrives' if arrives else 'does not arrive'))
        panel.label_outer()
    line[0].set_ylabel(f'{names.PARAMETER_NAMES[table[2]]},\n{scenario}\ny [m]')
    texts.append(f'{names.PARAMETER_NAMES[table[2]]}, {scenario}: '
                 + names.means_sentence(runs.measured(setting, table, scenario)))
    return frame_alike(pictures)


def draw_row(line, setting, table, scenario, episode, moments=None, marked=None):
    """Draws four moments of an episode side by side. Returns the pictures."""
    seed, instance = episode
    folder = runs.folder_of(setting, table, seed)
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
    line[0].set_ylabel(f'{names.PARAMETER_NAMES[table[2]]}\ny [m]')
    return pictures


def finish(chapter, setting, figure, axes, pictures, file, caption):
    """Gives all panels the same limits, and adds the figure to the chapter."""
    for panel in axes[-1]:
        panel.set_xlabel('x [m]')
    width, height = frame_alike(pictures)
    figure.set_size_inches(13, len(axes) * (0.75 + 3.0 * height / width))
    chapter.add_figure(style.save(figure, setting.figure_file(file)), caption)


def add_moments(chapter, setting, scenario):
    """Adds four moments of one episode; top: thesis's parameters, bottom: better parameters."""
    figure, axes = style.new_figure(2, len(MOMENTS), 13, 6.9)
    pictures, texts = [], []
    for line, parameters in zip(axes, runs.PARAMETERS):
        table = ('agent', 'occupancy', parameters)
        pictures += draw_row(line, setting, table, scenario, first_success(setting, table, scenario))
        texts.append(f'{names.PARAMETER_NAMES[parameters]}: {rates_sentence(setting, table, scenario)}')
    finish(chapter, setting, figure, axes, pictures, f'figure_{NUMBERS[scenario]}_{scenario}',
           f'Figure {NUMBERS[scenario].replace("_", ".")}: {runs.SCENARIOS[scenario]}. Four moments of the first '
           "recorded episode, in the order of the seeds, in which all agents arrive. Set 2, one agent's table; top: "
           f'thesis\'s parameters, bottom: better parameters. {KEY} {"; ".join(texts)}.')


def badness(setting, table, scenario, episode):
    """Returns the numbers of agents that did not arrive, collided, and touched a body, and the duration [ticks]."""
    seed, instance = episode
    episodes = runs.episodes_of(setting, table, seed, scenario)
    return (episodes['agents'] - episodes['arrived'][instance], episodes['collided'][instance],
            episodes['touched'][instance], episodes['ticks'][instance])


def episode_sentence(setting, table, scenario, episode):
    """Returns a text with the outcome of an episode."""
    left, collided, touched, ticks = map(int, badness(setting, table, scenario, episode))
    return (f'{names.PARAMETER_NAMES[table[2]]}: {12 - left} of 12 arrive, {collided} collide, {touched} have a '
            f'contact, {ticks} decisions')


def best_of(setting, table, scenario):
    """Returns the best recorded episode of all seeds."""
    return min(recorded(setting), key=lambda episode: badness(setting, table, scenario, episode))


def add_best(chapter, setting):
    """Adds figure 4.24: the best case."""
    scenario = 'circle12'
    figure, axes = style.new_figure(2, len(MOMENTS), 13, 6.9)
    pictures, texts = [], []
    for line, parameters in zip(axes, runs.PARAMETERS):
        table = ('agent', 'occupancy', parameters)
        best = best_of(setting, table, scenario)
        pictures += draw_row(line, setting, table, scenario, best)
        texts.append(episode_sentence(setting, table, scenario, best))
    finish(chapter, setting, figure, axes, pictures, 'figure_4_24_best',
           'Figure 4.24: best case of twelve agents on a circle, all at the same speed. The best of the recorded '
           f'episodes ({setting.count(runs.WALKED, 2)} instances, {len(setting.seeds(runs.SEEDS))} seeds), by most '
           'arrivals, then fewest collisions, then fewest contacts, then shortest duration. Set 2, '
           f"one agent's table. {KEY} {'; '.join(texts)}.")


def surrounded_agent(setting, table, scenario, episode):
    """Returns the agent that was surrounded for the most decisions of an episode, and the tick of the first of these
    decisions; None if no agent was surrounded."""
    seed, instance = episode
    decisions = runs.decisions_of(setting, table, seed, scenario)
    is_surrounded = (decisions['instance'] == instance) & (decisions['sectors'] >= surroundings.LEAST_SECTORS)
    if not is_surrounded.any():
        return None
    agent = int(numpy.argmax(numpy.bincount(decisions['agent'][is_surrounded])))
    return agent, int(decisions['tick'][is_surrounded & (decisions['agent'] == agent)].min())


def add_worst(chapter, setting):
    """Adds figure 4.25: the worst case."""
    scenario = 'circle12_varied'
    figure, axes = style.new_figure(2, len(MOMENTS), 13, 6.9)
    pictures, texts = [], []
    for line, parameters in zip(axes, runs.PARAMETERS):
        table = ('agent', 'occupancy', parameters)

        def harm(episode, table=table):
            left, collided, touched, ticks = badness(setting, table, scenario, episode)
            return touched, left, collided, ticks

        worst = max(recorded(setting), key=harm)
        found = surrounded_agent(setting, table, scenario, worst)
        moments = None if found is None else [found[1] - 40, found[1], found[1] + 20, 2000]
        pictures += draw_row(line, setting, table, scenario, worst, moments, found and found[0])
        texts.append(episode_sentence(setting, table, scenario, worst) + (
            ', no agent is surrounded' if found is None else f', agent {found[0]} is surrounded'))
    finish(chapter, setting, figure, axes, pictures, 'figure_4_25_worst',
           'Figure 4.25: worst case of twelve agents on a circle, at varied speeds. The worst of the recorded episodes '
           f'({setting.count(runs.WALKED, 2)} instances, {len(setting.seeds(runs.SEEDS))} seeds), by most contacts, '
           'then fewest arrivals, then most collisions, then longest duration. Orange with a black ring: the agent '
           f'with the most decisions with {surroundings.LEAST_SECTORS} or 8 of 8 sectors occupied; (b) is the first of '
           'these decisions, (a) is 4 s before it, (c) is 2 s after it, (d) is the end. Set 2, one '
           f"agent's table. {KEY} {'; '.join(texts)}.")
