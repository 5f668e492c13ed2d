"""RiMEA 7: allocation of demographic parameters."""
import random

import numpy
from crowd_experiments.style import new_figure, save
from matplotlib.patches import Rectangle

from .. import measures as texts, plan
from ..evaluation import Case, Result
from ..measures import mean_speeds
from ..plan import RADIUS, SPEEDS, speed_of

PER_GROUP = 15
SPACING = 2.0  # [m] between people abreast, so that they do not influence each other
START, FROM, TO, GOAL = 0.0, 5.0, 25.0, 30.0  # [m]
TOLERANCE = 0.02  # [m/s]


def groups():
    """Returns the age group of each person."""
    return [group for group in SPEEDS for _ in range(PER_GROUP)]


def document(seed):
    """Returns people abreast on an open floor, each straight ahead, with speeds drawn by age."""
    draw = random.Random(seed)
    people = [plan.agent((START, SPACING * i), (GOAL, SPACING * i), speed_of(group, draw), RADIUS)
              for i, group in enumerate(groups())]
    return plan.scenario('rimea_7', 120, people, [])


def run(evaluation):
    """Compares the walked speeds of each age group with the guideline's range."""
    recordings = evaluation.walk({'floor': document})['floor']
    speeds = numpy.array([mean_speeds(recording, 0, FROM, TO) for recording in recordings])
    kept = max(float(numpy.max(numpy.abs(found / recording.speeds - 1.0)))
               for found, recording in zip(speeds, recordings))
    of_group = {group: speeds[:, numpy.equal(groups(), group)] for group in SPEEDS}
    passed = all(within(of_group[group], *SPEEDS[group]) for group in SPEEDS)
    measured = '; '.join(f'{group}: {texts.spread(of_group[group].mean(axis=1), "m/s", 2)}, people '
                         f'{of_group[group].min():.2f}-{of_group[group].max():.2f}' for group in SPEEDS)
    expected = '; '.join(f'{group}: {low}-{high} m/s' for group, (low, high) in SPEEDS.items())
    return Result(measured, expected, passed, f'Walked speeds differ from the maximum speeds by {100.0 * kept:.1f} % '
                  f'at most.', (draw_speeds(of_group, evaluation.folder / 'rimea_7.png'),))


def within(speeds, low, high):
    """Returns whether all speeds are in the range."""
    return bool(numpy.isfinite(speeds).all() and speeds.min() >= low - TOLERANCE and speeds.max() <= high + TOLERANCE)


def draw_speeds(of_group, file):
    """Draws every person's speed and the ranges of the guideline."""
    figure, axes = new_figure(1, 1, 6.0, 4.0)
    for i, (group, speeds) in enumerate(of_group.items()):
        low, high = SPEEDS[group]
        axes[0, 0].add_patch(range_box(i, low, high))
        axes[0, 0].plot(i + numpy.linspace(-0.25, 0.25, speeds.size), speeds.ravel(), '.', color='#1f77b4')
    axes[0, 0].set_xticks(range(len(of_group)), list(of_group))
    axes[0, 0].set_ylim(0.0, 1.8)
    axes[0, 0].set_ylabel('walked speed [m/s]')
    axes[0, 0].set_title('Dots: people of all seeds; boxes: ranges of the guideline')
    return save(figure, file)


def range_box(i, low, high):
    """Returns the box of a group."""
    return Rectangle((i - 0.35, low), 0.7, high - low, facecolor='0.88', edgecolor='0.5')


CASE = Case('rimea_7', 'Walking speeds by age', run)
