"""RiMEA 1, 5, 6 and 7: how single people, and few, move."""
import random

import numpy
from crowd_experiments.records import Spread
from crowd_experiments.style import new_figure, save
from matplotlib.patches import Rectangle

from . import plan
from .drawing import draw_paths, shown
from .evaluation import Result
from .measures import (all_arrived, arrived, counts, crossing_times, largest_overlap, last, mean_speeds, problems,
                       spread, starts, through_walls)

LENGTH, WIDTH, SPEED = 40.0, 2.0, 1.33  # of the corridor [m], [m], [m/s]
ROOM = (5.0, 8.0)  # [m]; the exit is in the middle of a short wall
REACTION_TIMES = [10.0 * (i + 1) for i in range(10)]  # [s] 10, 20, ... 100
LATEST = 0.2  # [s] two ticks
LEG = 10.0  # of the corner [m]: inner sides of both corridors
OVERLAP = 0.001  # [m] smaller overlaps are rounding
PER_GROUP = 15
SPACING = 2.0  # [m] between people abreast, so that they do not influence each other
MEASURED = (5.0, 25.0)  # of 30 m [m]
TOLERANCE = 0.02  # [m/s]
AGES = [group for group in plan.SPEEDS for _ in range(PER_GROUP)]  # of the people


def corridor(_seed):
    """Returns a corridor with one person at x = 0 who walks beyond its end."""
    walls = plan.polyline((LENGTH + 2.0, 0.0), (-1.0, 0.0), (-1.0, WIDTH), (LENGTH + 2.0, WIDTH))
    walker = plan.agent((0.0, WIDTH / 2.0), (LENGTH + 1.0, WIDTH / 2.0), SPEED)
    return plan.scenario('rimea_1', 60, [walker], walls)


def rimea_1(evaluation):
    recordings = evaluation.walk_one('corridor', corridor)
    times = Spread(crossing_times(recording, [[LENGTH, 0.0], [LENGTH, WIDTH]])[0] for recording in recordings)
    picture = draw_paths(recordings[0], evaluation.folder / 'rimea_1.png', 'One person in a corridor')
    return Result(f'{spread(times.values, "s", 2)} for 40 m', '26-34 s', 26.0 <= times.low and times.high <= 34.0,
                  pictures=(picture,))


def room(seed):
    """Returns a room with ten people of different reaction times."""
    width, length = ROOM
    walls = [*plan.polyline((0.0, length), (0.0, 0.0), (width, 0.0), (width, length)),
             *plan.wall((0.0, length), (width, length), [(2.0, 3.0)])]
    people = plan.crowd(seed, len(REACTION_TIMES), (0.5, 0.5), (4.5, 7.0), (2.5, length + 1.5))
    return plan.scenario('rimea_5', 200, [{**person, 'reaction_time': time}
                                          for person, time in zip(people, REACTION_TIMES)], walls)


def rimea_5(evaluation):
    recordings = evaluation.walk_one('room', room)
    found = [starts(recording) for recording in recordings]
    differences = [float(numpy.max(numpy.abs(times - REACTION_TIMES))) for times in found]
    figure, ((axes,),) = new_figure(1, 1, 5.0, 4.0)
    axes.plot([0.0, 110.0], [0.0, 110.0], color='0.7')
    axes.plot(REACTION_TIMES, found[0], 'o')
    axes.set(xlabel='reaction time [s]', ylabel='measured start [s]')
    return Result(f'largest difference between start and reaction time {spread(differences, "s", 2)}, '
                  f'{arrived(recordings)}',
                  f'each person starts after its reaction time (10, 20, ... 100 s), within {LATEST:g} s',
                  max(differences) <= LATEST and all_arrived(recordings),
                  problems(recordings, {'the exit': (2.5, ROOM[1])}),
                  (save(figure, evaluation.folder / 'rimea_5.png'),))


def corner(seed):
    """Returns two corridors at a right angle with 20 people in the first six metres."""
    outer = LEG + WIDTH
    walls = plan.polyline((outer, outer + 2.0), (outer, 0.0), (0.0, 0.0), (0.0, WIDTH), (LEG, WIDTH),
                          (LEG, outer + 2.0))
    people = plan.crowd(seed, 20, (0.1, 0.1), (6.0, WIDTH - 0.1), (LEG + WIDTH / 2.0, outer + 1.0))
    return plan.scenario('rimea_6', 120, people, walls, goal_tolerance=0.8)


def rimea_6(evaluation):
    recordings = evaluation.walk_one('corner', corner)
    through = [through_walls(recording) for recording in recordings]
    touched = [int(recording.touched.sum()) for recording in recordings]
    passed = not any(through) and not any(touched) and max(map(largest_overlap, recordings)) <= OVERLAP and \
        all_arrived(recordings)
    return Result(f'{arrived(recordings)}, {counts(through)} through walls, {counts(touched)} in contact; '
                  f'{last(recordings, 1)}', 'all arrive, none through a wall, none in contact', passed,
                  problems(recordings, {'the corner': (11.0, 1.0), 'the end': (11.0, 12.0)}),
                  (draw_paths(shown(recordings), evaluation.folder / 'rimea_6.png', '20 people around a corner'),))


def floor(seed):
    """Returns people abreast on an open floor, each straight ahead, with speeds drawn by age."""
    draw = random.Random(seed)
    people = [plan.agent((0.0, SPACING * i), (30.0, SPACING * i), draw.uniform(*plan.SPEEDS[group]))
              for i, group in enumerate(AGES)]
    return plan.scenario('rimea_7', 120, people, [])


def rimea_7(evaluation):
    recordings = evaluation.walk_one('floor', floor)
    speeds = numpy.array([mean_speeds(recording, 0, *MEASURED) for recording in recordings])
    kept = max(float(numpy.max(numpy.abs(found / recording.speeds - 1.0)))
               for found, recording in zip(speeds, recordings))
    of_group = {group: speeds[:, numpy.equal(AGES, group)] for group in plan.SPEEDS}
    measured = '; '.join(f'{group}: {spread(found.mean(axis=1), "m/s", 2)}, people {found.min():.2f}-{found.max():.2f}'
                         for group, found in of_group.items())
    expected = '; '.join(f'{group}: {low}-{high} m/s' for group, (low, high) in plan.SPEEDS.items())
    return Result(measured, expected, all(within(of_group[group], *plan.SPEEDS[group]) for group in of_group),
                  f'Walked speeds differ from the maximum speeds by {100.0 * kept:.1f} % at most.',
                  (draw_speeds(of_group, evaluation.folder / 'rimea_7.png'),))


def within(speeds, low, high):
    return bool(numpy.isfinite(speeds).all() and speeds.min() >= low - TOLERANCE and speeds.max() <= high + TOLERANCE)


def draw_speeds(of_group, file):
    figure, ((axes,),) = new_figure(1, 1, 6.0, 4.0)
    for i, (group, speeds) in enumerate(of_group.items()):
        low, high = plan.SPEEDS[group]
        axes.add_patch(Rectangle((i - 0.35, low), 0.7, high - low, facecolor='0.88', edgecolor='0.5'))
        axes.plot(i + numpy.linspace(-0.25, 0.25, speeds.size), speeds.ravel(), '.', color='#1f77b4')
    axes.set_xticks(range(len(of_group)), list(of_group))
    axes.set(ylim=(0.0, 1.8), ylabel='walked speed [m/s]',
             title='Dots: people of all seeds; boxes: ranges of the guideline')
    return save(figure, file)
