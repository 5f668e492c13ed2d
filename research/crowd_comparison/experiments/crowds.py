"""Large crowds: arrivals and contacts."""
import numpy
from crowd_drawing.files import read_scene, read_walks
from crowd_experiments import style
from crowd_experiments.pages import Chapter
from crowd_experiments.records import Spread, rates, read_csv
from crowd_experiments.runs import Run
from crowd_studies.scene_figures import draw_moment, last_tick_of

from ..metrics_csv import NAMES, OURS

NAME = 'crowds'
TITLE = 'Large crowds'
SEED = 1  # of the placements
# Number of placements of each scene, and the approximate duration of one [s].
SCENES = {'crowd_random_50': (10, 0.1), 'crowd_random_200': (5, 0.4), 'crowd_random_1000': (3, 3.0),
          'crowd_circle_50': (10, 0.2), 'crowd_circle_200': (5, 0.8), 'crowd_circle_1000': (2, 25.0)}
QUICK_SCENES = {'crowd_random_50': (2, 0.1), 'crowd_circle_50': (1, 0.2)}
DRAWN = ('crowd_circle_50', 'crowd_random_200')
MOMENTS = (0.0, 1 / 3, 2 / 3)  # fractions of the time until the last arrival


def scenes_of(setting):
    return setting.count(SCENES, QUICK_SCENES)


def drawn_of(setting):
    """Returns the scenes whose trajectories are recorded and drawn."""
    return [scene for scene in DRAWN if scene in scenes_of(setting)]


def plan(setting):
    """Returns a run for each scene."""
    return [make_run(setting, scene, episodes, episodes * seconds)
            for scene, (episodes, seconds) in scenes_of(setting).items()]


def make_run(setting, scene, episodes, cost):
    keep = ['--scenes', '.', '--trajectories', '.'] if scene in DRAWN else []
    return Run(setting.run_folder(NAME, scene), [
        [setting.tool('evaluate'), '--q-table', setting.table(OURS), '--threads', 1, '--seed', SEED, '--episodes',
         episodes, '--record', 'record.csv', *keep, setting.scenario(scene)]], cost)


def report(setting):
    """Returns the chapter, from the runs' records."""
    chapter = Chapter(NAME, TITLE)
    chapter.add_text(
        f'{NAMES[OURS].capitalize()}, the shipped table; radii from 0.18 to 0.35 m, speeds from 0.8 to 1.6 m/s, '
        'different placements each time. Random: each agent walks from a random place to a random place, 0.3 agents '
        'per square metre. Circle: a ring with one agent per 1.5 m, each agent walks to the opposite point. Stuck: '
        'number of agents that have not arrived when the time is up.')
    rows = [row_of(scene, read_csv(setting.run_folder(NAME, scene) / 'record.csv')) for scene in scenes_of(setting)]
    chapter.add_table('Large crowds', ['', 'placements', 'success %', 'contact %', 'stuck', 'time', 'slowest agent',
                                       'path', 'turn rad/m'], rows, 'crowds')
    for scene in drawn_of(setting):
        add_moments(chapter, setting, scene)
    return chapter


def row_of(scene, record):
    success, contact, _ = rates(record)
    arrived = record['arrived'] > 0
    placements = numpy.unique(record['episode'])
    times = Spread.of_numbers(mean_of(record['time_ratio'][arrived & (record['episode'] == episode)])
                              for episode in placements)
    slowest = max(record['time_ratio'][arrived], default=float('nan'))
    return [scene, str(len(placements)), f'{success:.2f}', f'{contact:.2f}', str(int((~arrived).sum())), times.text(3),
            f'{slowest:.2f}', f"{mean_of(record['path_ratio'][arrived]):.3f}",
            f"{mean_of(record['turn_per_metre'][arrived]):.2f}"]


def mean_of(values):
    return float(numpy.mean(values)) if len(values) else float('nan')


def add_moments(chapter, setting, scene_name):
    """Adds three moments of the first placement."""
    folder = setting.run_folder(NAME, scene_name)
    scene = read_scene(folder / f'{scene_name}.yaml', 0)
    _, walks = read_walks(folder / f'{scene_name}.csv', 0)
    ticks = [round(moment * last_tick_of(walks)) for moment in MOMENTS]
    figure, axes = style.new_figure(1, len(ticks), 4.3 * len(ticks), 4.6, sharex=True, sharey=True)
    for panel, tick in zip(axes[0], ticks):
        draw_moment(panel, scene, walks, tick, with_paths=False).frame()
        panel.set_title(f'{tick * scene.tick:.0f} s')
    reach = 1.02 * max(max(abs(x), abs(y)) for walk in walks.values() for _, x, y in walk) + 0.5
    axes[0][0].set_xlim(-reach, reach)
    axes[0][0].set_ylim(-reach, reach)
    chapter.add_figure(style.save(figure, setting.figure_file(scene_name)),
                       f'{scene_name}, the first placement: agents that have not arrived yet.')
