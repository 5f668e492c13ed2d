"""Large crowds: arrivals and contacts."""
import pandas
from crowd_drawing.files import read_scene, read_walks
from crowd_experiments import style
from crowd_experiments.records import Spread, percent, read_csv
from crowd_studies.program import Report
from crowd_studies.scene_figures import draw_moment, last_tick_of

from ..models import OURS, TEXTS, walked

NAME = 'crowds'
# Number of placements of each scene, and the approximate duration of one [s].
SCENES = {'crowd_random_50': (10, 0.1), 'crowd_random_200': (5, 0.4), 'crowd_random_1000': (3, 3.0),
          'crowd_circle_50': (10, 0.2), 'crowd_circle_200': (5, 0.8), 'crowd_circle_1000': (2, 25.0)}
QUICK_SCENES = {'crowd_random_50': (2, 0.1), 'crowd_circle_50': (1, 0.2)}
DRAWN = ('crowd_circle_50', 'crowd_random_200')
MOMENTS = (0.0, 1 / 3, 2 / 3)  # fractions of the time until the last arrival


def plan(setting):
    return [walked(setting, NAME, OURS, scene, episodes, episodes * seconds, scene in DRAWN)
            for scene, (episodes, seconds) in setting.count(SCENES, QUICK_SCENES).items()]


def report(setting):
    chapter = Report(NAME, TEXTS, setting)
    chapter.say('intro')
    scenes = setting.count(SCENES, QUICK_SCENES)
    chapter.tabulate(NAME, ['', 'placements', 'success %', 'contact %', 'stuck', 'time', 'slowest agent', 'path',
                            'turn rad/m'],
                     [row_of(scene, pandas.DataFrame(read_csv(setting.run_folder(NAME, scene) / 'record.csv')))
                      for scene in scenes])
    for scene in DRAWN:
        if scene in scenes:
            add_moments(chapter, setting, scene)
    return chapter


def row_of(scene, record):
    arrived = record[record['arrived'] > 0]
    times = Spread.of_numbers(arrived.groupby('episode')['time_ratio'].mean())
    return [scene, str(record['episode'].nunique()), f"{percent(record['arrived']):.2f}",
            f"{percent(record['touched']):.2f}", str(len(record) - len(arrived)), times.text(3),
            f"{arrived['time_ratio'].max():.2f}", f"{arrived['path_ratio'].mean():.3f}",
            f"{arrived['turn_per_metre'].mean():.2f}"]


def add_moments(chapter, setting, name):
    folder = setting.run_folder(NAME, name)
    scene = read_scene(folder / f'{name}.yaml', 0)
    _, walks = read_walks(folder / f'{name}.csv', 0)
    ticks = [round(moment * last_tick_of(walks)) for moment in MOMENTS]
    figure, axes = style.new_figure(1, len(ticks), 4.3 * len(ticks), 4.6, sharex=True, sharey=True)
    for panel, tick in zip(axes[0], ticks):
        draw_moment(panel, scene, walks, tick, with_paths=False).frame()
        panel.set_title(f'{tick * scene.tick:.0f} s')
    reach = 1.02 * max(max(abs(x), abs(y)) for walk in walks.values() for _, x, y in walk) + 0.5
    axes[0][0].set(xlim=(-reach, reach), ylim=(-reach, reach))
    chapter.draw(figure, name, 'moments', scene=name)
