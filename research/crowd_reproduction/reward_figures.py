"""Figures 4.1-4.12 of the evaluation of the rewards."""
import numpy
from crowd_drawing.files import read_walks
from crowd_drawing.picture import OBSTACLE_COLOUR, Picture, colours_of
from crowd_experiments import style
from crowd_experiments.records import finite
from crowd_experiments.variations import heading_of, read_documents
from crowd_studies.scene_figures import frame_alike
from matplotlib.ticker import ScalarFormatter

from .declared import BETTER, DRAWN, REWARDS
from .results import PARAMETER_NAMES, REWARD_COLOURS, REWARD_NAMES
from .reward_measures import (MODES, SPEED, THESIS_SUCCESS, collision, gain_per_step, learned, of_mode, path_per_gain,
                              success)

COLLISION_RADIUS, VISION_RADIUS = 0.5, 1.0  # [m]
DRAWN_EPISODES = 8  # without an obstacle
RATIOS = {
    'gain_per_tick': ('distance gained per step [m]', SPEED, "the agent's real velocity", gain_per_step, 4),
    'path_per_gain': ('path per distance gained [-]', 1.0, 'straight line', path_per_gain, 2)}
RATES = {'success': success, 'collision': collision}
DURING = {'training': 'in training', 'demo': 'in demo', 'free': 'without an obstacle'}
FIRST_RATIO, FIRST_RATE = {'training': 2, 'demo': 6, 'free': 11}, {'training': 4, 'demo': 8}  # numbers of figures


def add_figures(chapter, setting):
    """Adds all figures, each with the thesis's parameters and with better parameters."""
    add_setting(chapter, setting)
    for parameters in DRAWN:
        for mode in MODES:
            add_scatters(chapter, setting, parameters, mode)
            for number, measure in enumerate(RATES, FIRST_RATE[mode]):
                add_rates(chapter, setting, number, parameters, measure, mode)
        add_paths(chapter, setting, parameters)
        add_scatters(chapter, setting, parameters, 'free')


def file_of(number, parameters):
    """Returns fig_4_02 with the thesis's parameters, fig_4_02_better with better parameters."""
    return f'fig_4_{number:02d}' + ('_better' if parameters == BETTER else '')


def shown_seed(runs):
    """Returns seed and success of the run nearest to the thesis's success in demo, or to the median."""
    values, keys = numpy.array(of_mode(runs, 'demo', success)), dict(runs.keys)
    target = THESIS_SUCCESS[keys['reward'], 'demo'] if keys['parameters'] != BETTER else numpy.median(values)
    place = int(numpy.argmin(numpy.abs(values - target)))
    return runs.seeds()[place], values[place]


def shown_text(chapter, setting, parameters):
    seeds = {reward: shown_seed(learned(setting, reward, parameters)) for reward in REWARDS}
    return chapter.text_of(
        'shown', what='median success in demo' if parameters == BETTER else "thesis's success in demo",
        listed='; '.join(f'{REWARD_NAMES[reward]}: seed {seed}, {value:.2f} %'
                         for reward, (seed, value) in seeds.items()))


def add_setting(chapter, setting):
    """Adds figure 4.1: one drawn scene, with the goals of other scenes."""
    scenes = read_documents(learned(setting, 'cosine_cubed').folder(1) / 'single_obstacle.yaml')
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
    picture.axes.set(title='After figure 4.1: the setting', xlabel='x [m]', ylabel='y [m]')
    chapter.draw(figure, 'fig_4_01', others=len(scenes) - 1)


def panels(number, parameters, what, height=3.9):
    """Returns a figure with two panels side by side, (a) distance gained and (b) cos³, as in the thesis."""
    figure, axes = style.new_figure(1, 2, 10, height, sharex=True, sharey=True)
    figure.suptitle(f'After figure 4.{number}, {PARAMETER_NAMES[parameters]}: {what}', fontsize=12)
    for panel, letter, reward in zip(axes[0], 'ab', REWARDS):
        panel.set_title(f'({letter}) reward: {REWARD_NAMES[reward]}')
    return figure, axes[0]


def add_scatters(chapter, setting, parameters, mode):
    """Adds each ratio in each episode of one run."""
    for number, (measure, (label, reference, legend, median_of, decimals)) in enumerate(RATIOS.items(),
                                                                                        FIRST_RATIO[mode]):
        ratio, medians = label.split(' [')[0], []
        figure, axes = panels(number, parameters, f'{ratio} {DURING[mode]}')
        for panel, reward in zip(axes, REWARDS):
            runs = learned(setting, reward, parameters)
            record = runs.record(f'{mode}.csv')
            record = record[record['seed'] == shown_seed(runs)[0]]
            medians.append(f'{REWARD_NAMES[reward]} {median_of(record):.{decimals}f}')
            scatter(panel, record, measure, REWARD_COLOURS[reward])
            panel.axhline(reference, color=style.REFERENCE, linewidth=1, linestyle='--', label=legend)
            panel.set_xlabel('episode')
        axes[0].set_ylabel(label)
        axes[0].legend(loc='best')
        more = ' Episodes without a gained distance count as infinite in the median.'
        chapter.draw(figure, file_of(number, parameters), 'scatter', number=number, ratio=ratio, during=DURING[mode],
                     parameters=PARAMETER_NAMES[parameters], medians=', '.join(medians),
                     shown=shown_text(chapter, setting, parameters), more=more if measure == 'path_per_gain' else '')


def scatter(panel, record, measure, colour):
    arrived = record['arrived'] > 0
    for chosen, look in ((arrived, {'marker': '.', 'markersize': 4, 'alpha': 0.5}),
                         (~arrived, {'marker': 'x', 'markersize': 4})):
        panel.plot(record['episode'][chosen], record[measure][chosen], linestyle='', color=colour, **look)
    if measure == 'path_per_gain':
        panel.set_yscale('log')
        panel.yaxis.set_major_formatter(ScalarFormatter())
        highest = finite(record[measure].to_numpy()).max(initial=0.0)
        panel.yaxis.set_minor_formatter(ScalarFormatter() if highest < 10 else '')


def add_rates(chapter, setting, number, parameters, measure, mode):
    """Adds a rate as a bar for each seed, with the mean over the seeds."""
    figure, axes = panels(number, parameters, f'rate of {measure} {DURING[mode]}')
    is_success = measure == 'success'
    for panel, reward in zip(axes, REWARDS):
        values = numpy.sort(of_mode(learned(setting, reward, parameters), mode, RATES[measure]))
        colour = REWARD_COLOURS[reward]
        panel.bar(range(1, len(values) + 1), values, color=colour, alpha=0.6, width=0.8)
        panel.axhline(values.mean(), color=colour, linewidth=1.5, label=f'mean {values.mean():.2f} %')
        if is_success:
            reported = THESIS_SUCCESS[reward, mode]
            panel.axhline(reported, color='black', linestyle=':', linewidth=1.5, label=f'the thesis: {reported:.2f} %')
        panel.set(xlabel='seeds, in order of their rates', xticks=[])
        panel.legend(loc='lower right' if is_success else 'upper left')
    axes[0].set_ylabel(f'{measure} [% of the episodes]')
    axes[0].set_ylim(0, 105 if is_success else max(axes[0].get_ylim()[1], 5))
    chapter.draw(figure, file_of(number, parameters), measure, number=number, parameters=PARAMETER_NAMES[parameters],
                 during=DURING[mode], own=', with its own parameters' if parameters == BETTER else '')


def add_paths(chapter, setting, parameters):
    """Adds figure 4.10: paths without an obstacle."""
    figure, axes = panels(10, parameters, 'paths without an obstacle', 6.1)
    pictures = []
    for panel, reward in zip(axes, REWARDS):
        runs = learned(setting, reward, parameters)
        pictures.append(draw_paths(panel, runs.folder(shown_seed(runs)[0])))
        panel.set_xlabel('x [m]')
    frame_alike(pictures)
    axes[0].set_ylabel('y [m]')
    chapter.draw(figure, file_of(10, parameters), 'paths', parameters=PARAMETER_NAMES[parameters],
                 shown=shown_text(chapter, setting, parameters))


def draw_paths(panel, folder):
    scenes = read_documents(folder / 'single_free.yaml')
    picture = Picture(panel)
    for instance, colour in enumerate(colours_of(DRAWN_EPISODES)):
        agent = scenes[instance]['agents'][0]
        _, walks = read_walks(folder / 'single_free.csv', instance)
        places = [(x, y) for _, x, y in walks[0]]
        picture.show(places, agent['radius'])
        panel.plot(*zip(*places), color=colour, linewidth=1.4, zorder=5)
        picture.draw_goals(agent['goals'], agent['radius'], colour)
        picture.disc(places[0], 0.06, facecolor=colour, edgecolor='none', zorder=6)
        picture.disc(places[-1], agent['radius'], fill=False, edgecolor=colour, linewidth=1.2, zorder=7)
    return picture
