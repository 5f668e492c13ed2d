"""Figures 4.1-4.12 of the evaluation of the rewards."""
import numpy
from matplotlib.ticker import ScalarFormatter

from crowd_drawing.files import read_walks
from crowd_drawing.picture import OBSTACLE_COLOUR, Picture, colours_of
from crowd_experiments import style
from crowd_experiments.records import finite
from crowd_studies.scene_figures import frame_alike
from crowd_experiments.variations import heading_of, read_documents

from . import names
from .reward_runs import (DRAWN_EPISODES, FREE_EPISODES, MODES, REWARDS, SEEDS, SPEED, THESIS_SUCCESS, Variant,
                          collision, gain_per_step, path_per_gain, per_seed, records, success)

COLLISION_RADIUS, VISION_RADIUS = 0.5, 1.0  # [m]
LETTERS = 'ab'
RATIOS = {
    'gain_per_tick': ('distance gained per step [m]', SPEED, "the agent's real velocity", gain_per_step),
    'path_per_gain': ('path per distance gained [-]', 1.0, 'straight line', path_per_gain)}
RATES = {'success': success, 'collision': collision}
DURING = {'training': 'in training', 'demo': 'in demo', 'free': 'without an obstacle'}


def add_figures(chapter, setting):
    """Adds all figures, each with the thesis's parameters and with better parameters."""
    add_setting(chapter, setting)
    for parameters in ('thesis', 'better'):
        for mode, first in zip(MODES, (2, 6)):
            for number, measure in enumerate(RATIOS, first):
                add_scatter(chapter, setting, number, parameters, measure, mode)
            for number, measure in enumerate(RATES, first + 2):
                add_rates(chapter, setting, number, parameters, measure, mode)
        add_paths(chapter, setting, parameters)
        for number, measure in enumerate(RATIOS, 11):
            add_scatter(chapter, setting, number, parameters, measure, 'free')


def figure_file(setting, number, parameters):
    """Returns fig_4_02.png with the thesis's parameters, fig_4_02_better.png with better parameters."""
    return setting.figure_file(f'fig_4_{number:02d}' + ('' if parameters == 'thesis' else '_better'))


def caption(number, parameters, text):
    return f'After figure 4.{number}, {names.PARAMETER_NAMES[parameters]}: {text}'


def shown_place(setting, variant):
    """Returns the index of the seed that is drawn: the nearest to the thesis's success in demo; with better parameters
    the nearest to the median of the seeds."""
    values = numpy.array(per_seed(setting, variant, 'demo', success))
    target = THESIS_SUCCESS[variant.reward, 'demo'] if variant.parameters == 'thesis' else numpy.median(values)
    return int(numpy.argmin(numpy.abs(values - target)))


def shown_text(setting, parameters):
    """Returns a text that states which seeds are drawn, and why."""
    rule = "the seed nearest to the thesis's success in demo" if parameters == 'thesis' else \
        'the seed nearest to the median success in demo'
    seeds = []
    for reward in REWARDS:
        variant = Variant(reward, parameters)
        place = shown_place(setting, variant)
        seeds.append(f'{names.REWARD_NAMES[reward]}: seed {setting.seeds(SEEDS)[place]}, '
                     f'{per_seed(setting, variant, "demo", success)[place]:.2f} %')
    return f'One run for each reward, {rule} ({"; ".join(seeds)}).'


def add_setting(chapter, setting):
    """Adds figure 4.1: one drawn scene, with the goals of other scenes."""
    folder = Variant('cosine_cubed').folder(setting, 1)
    scenes = read_documents(folder / 'single_obstacle.yaml')
    agent, obstacle = scenes[0]['agents'][0], scenes[0]['obstacles'][0]
    figure, axes = style.new_figure(1, 1, 5.5, 5.5)
    picture = Picture(axes[0][0])
    for scene in scenes[1:]:
        goal = scene['agents'][0]['goals'][0]
        picture.show(goal)
        picture.axes.plot(*goal, marker='+', color='0.6', markersize=6)
    start = agent['position']
    picture.disc(start, VISION_RADIUS, facecolor='0.85', edgecolor='0.7', zorder=1)
    picture.disc(obstacle['position'], obstacle['radius'], facecolor=OBSTACLE_COLOUR, edgecolor='0.35', zorder=2)
    picture.disc(start, COLLISION_RADIUS, fill=False, edgecolor='red', linewidth=1.5, zorder=3)
    picture.disc(start, agent['radius'], facecolor='#0072b2', edgecolor='none', zorder=4)
    heading = numpy.radians(heading_of(agent))
    picture.axes.plot([start[0], start[0] + agent['radius'] * numpy.cos(heading)],
                      [start[1], start[1] + agent['radius'] * numpy.sin(heading)], color='white', zorder=5)
    picture.draw_goals(agent['goals'], agent['radius'], '#0072b2')
    picture.frame()
    picture.axes.set_title('After figure 4.1: the setting')
    picture.axes.set_xlabel('x [m]')
    picture.axes.set_ylabel('y [m]')
    chapter.add_figure(
        style.save(figure, setting.figure_file('fig_4_01')),
        'After figure 4.1, the same for all parameters: the setting at the start of one episode. Blue: the agent, with '
        'a white line in the direction of its heading; red: its inner radius, 0.5 m (a rim within it is a collision); '
        'light grey: its radius of vision, 1 m; dark grey: the obstacle; blue cross: the goal; grey crosses: the goals '
        f'of {len(scenes) - 1} other episodes.')


def panels(number, parameters, what, height=3.9):
    """Returns a figure with two panels side by side, (a) distance gained and (b) cos³, as in the thesis."""
    figure, axes = style.new_figure(1, 2, 10, height, sharex=True, sharey=True)
    figure.suptitle(f'After figure 4.{number}, {names.PARAMETER_NAMES[parameters]}: {what}', fontsize=12)
    for panel, letter, reward in zip(axes[0], LETTERS, REWARDS):
        panel.set_title(f'({letter}) reward: {names.REWARD_NAMES[reward]}')
    return figure, axes[0]


def add_scatter(chapter, setting, number, parameters, measure, mode):
    """Adds a ratio in each episode of one run."""
    label, reference, legend, median_of = RATIOS[measure]
    ratio = label.split(' [')[0]
    figure, axes = panels(number, parameters, f'{ratio} {DURING[mode]}')
    medians = []
    for panel, reward in zip(axes, REWARDS):
        variant = Variant(reward, parameters)
        record = records(setting, variant, mode)[shown_place(setting, variant)]
        medians.append(f'{names.REWARD_NAMES[reward]} {median_of(record):.{4 if measure == "gain_per_tick" else 2}f}')
        scatter(panel, record, measure, names.REWARD_COLOURS[reward])
        panel.axhline(reference, color=style.REFERENCE, linewidth=1, linestyle='--', label=legend)
        panel.set_xlabel('episode')
    axes[0].set_ylabel(label)
    axes[0].legend(loc='best')
    text = (f'{ratio} in each episode {DURING[mode]}; dots: the agent arrived; crosses: it did not arrive. Median of '
            f'all episodes: {", ".join(medians)}. {shown_text(setting, parameters)}')
    if measure == 'path_per_gain':
        text += ' Episodes without a gained distance count as infinite in the median.'
    chapter.add_figure(style.save(figure, figure_file(setting, number, parameters)), caption(number, parameters, text))


def scatter(panel, record, measure, colour):
    arrived = record['arrived'] > 0
    for chosen, look in ((arrived, {'marker': '.', 'markersize': 4, 'alpha': 0.5}),
                         (~arrived, {'marker': 'x', 'markersize': 4})):
        panel.plot(record['episode'][chosen], record[measure][chosen], linestyle='', color=colour, **look)
    if measure == 'path_per_gain':
        panel.set_yscale('log')
        panel.yaxis.set_major_formatter(ScalarFormatter())
        panel.yaxis.set_minor_formatter(ScalarFormatter() if finite(record[measure]).max(initial=0.0) < 10 else '')


def add_rates(chapter, setting, number, parameters, measure, mode):
    """Adds a rate as a bar for each seed, with the mean over the seeds."""
    figure, axes = panels(number, parameters, f'rate of {measure} {DURING[mode]}')
    for panel, reward in zip(axes, REWARDS):
        values = numpy.sort(per_seed(setting, Variant(reward, parameters), mode, RATES[measure]))
        colour = names.REWARD_COLOURS[reward]
        panel.bar(range(1, len(values) + 1), values, color=colour, alpha=0.6, width=0.8)
        panel.axhline(values.mean(), color=colour, linewidth=1.5, label=f'mean {values.mean():.2f} %')
        if measure == 'success':
            reported = THESIS_SUCCESS[reward, mode]
            panel.axhline(reported, color='black', linestyle=':', linewidth=1.5, label=f'the thesis: {reported:.2f} %')
        panel.set_xlabel('seeds, in order of their rates')
        panel.set_xticks([])
        panel.legend(loc='lower right' if measure == 'success' else 'upper left')
    axes[0].set_ylabel(f'{measure} [% of the episodes]')
    axes[0].set_ylim(0, 105 if measure == 'success' else max(axes[0].get_ylim()[1], 5))
    what = 'in which the agent arrived' if measure == 'success' else \
        'in which the obstacle was within the inner radius of 0.5 m'
    text = f'rate of {measure} {DURING[mode]}: share of the episodes {what}. One bar per seed.'
    if measure == 'success':
        text += " The thesis's rates are those of its single run" + (
            '.' if parameters == 'thesis' else ', with its own parameters.')
    chapter.add_figure(style.save(figure, figure_file(setting, number, parameters)), caption(number, parameters, text))


def add_paths(chapter, setting, parameters):
    """Adds figure 4.10: paths without an obstacle."""
    figure, axes = panels(10, parameters, 'paths without an obstacle', 6.1)
    pictures = []
    for panel, reward in zip(axes, REWARDS):
        variant = Variant(reward, parameters)
        folder = variant.folder(setting, setting.seeds(SEEDS)[shown_place(setting, variant)])
        pictures.append(draw_paths(panel, folder))
        panel.set_xlabel('x [m]')
    frame_alike(pictures)
    axes[0].set_ylabel('y [m]')
    text = (f'paths of the first {DRAWN_EPISODES} of the {setting.count(FREE_EPISODES, 10)} demo episodes without an '
            f'obstacle; disc: start; circle: end; cross: goal. {shown_text(setting, parameters)}')
    chapter.add_figure(style.save(figure, figure_file(setting, 10, parameters)), caption(10, parameters, text))


def draw_paths(panel, folder):
    """Draws the recorded paths of one run. Returns the picture."""
    scenes = read_documents(folder / 'single_free.yaml')
    picture = Picture(panel)
    for instance, colour in enumerate(colours_of(DRAWN_EPISODES)):
        agent = scenes[instance]['agents'][0]
        _, walks = read_walks(folder / 'single_free.csv', instance)
        places = [(x, y) for _, x, y in walks[0]]
        for place in places:
            picture.show(place, agent['radius'])
        panel.plot(*zip(*places), color=colour, linewidth=1.4, zorder=5)
        picture.draw_goals(agent['goals'], agent['radius'], colour)
        picture.disc(places[0], 0.06, facecolor=colour, edgecolor='none', zorder=6)
        picture.disc(places[-1], agent['radius'], fill=False, edgecolor=colour, linewidth=1.2, zorder=7)
    return picture
