"""RiMEA 10: assigned exits in a corridor with twelve rooms."""
import random

import numpy

from .. import measures as texts, plan
from ..drawing import draw_paths, shown
from ..evaluation import Case, Result
from ..measures import crossing_times, through_walls
from ..plan import RADIUS, adult_speeds, places

ROOM, DEPTH, DOOR = 3.0, 5.0, 0.9  # width and depth of a room, width of its door [m]
CORRIDOR = (5.0, 6.0)  # y [m]
LENGTH = 18.0  # of the corridor [m]
MAIN_EXIT = [[6.0, 11.0], [7.2, 11.0]]  # at the end of a passage between the second and the third upper room
SECOND_EXIT = [[LENGTH, CORRIDOR[0]], [LENGTH, CORRIDOR[1]]]
TO_MAIN_EXIT = (1, 2, 3, 4, 7, 8, 9, 10)  # rooms


def rooms():
    """Returns the rooms 1 to 12 as (left, right, number of people): 1 to 6 above the corridor, 7 to 12 below it."""
    upper = [(0.0, 3.0), (3.0, 6.0), (7.2, 9.0), (9.0, 12.0), (12.0, 15.0), (15.0, 18.0)]
    lower = [(ROOM * i, ROOM * (i + 1)) for i in range(6)]
    return [(*sides, 1 if i == 2 else 2) for i, sides in enumerate(upper + lower)]


def walls():
    """Returns the walls of rooms, corridor and passage."""
    found = [*plan.polyline((0.0, CORRIDOR[0]), (0.0, CORRIDOR[1]))]
    for i, (left, right, _) in enumerate(rooms()):
        near, far = (CORRIDOR[1], CORRIDOR[1] + DEPTH) if i < 6 else (CORRIDOR[0], CORRIDOR[0] - DEPTH)
        middle = (right - left) / 2.0
        found += plan.wall((left, near), (right, near), [(middle - DOOR / 2.0, middle + DOOR / 2.0)])
        found += plan.polyline((left, near), (left, far), (right, far), (right, near))
    return found


def assignments():
    """Returns the room (1 to 12) of each of the 23 people."""
    return [i for i, (_, _, people) in enumerate(rooms(), 1) for _ in range(people)]


def document(seed):
    """Returns the floor with 23 people."""
    draw = random.Random(seed)
    speeds = iter(adult_speeds(len(assignments()), draw))
    people = []
    for i, (left, right, count) in enumerate(rooms(), 1):
        low, high = (7.0, 10.5) if i <= 6 else (0.5, 4.0)
        goal = (6.6, 12.0) if i in TO_MAIN_EXIT else (LENGTH + 1.0, 5.5)
        people += [plan.agent(place, goal, next(speeds), RADIUS)
                   for place in places(count, (left + 0.3, low), (right - 0.3, high), RADIUS, draw)]
    return plan.scenario('rimea_10', 180, people, walls())


def run(evaluation):
    """Counts the people who leave by their assigned exit."""
    recordings = evaluation.walk({'corridor': document})['corridor']
    to_main = numpy.isin(assignments(), TO_MAIN_EXIT)
    right = [int(numpy.isfinite(numpy.where(to_main, crossing_times(recording, MAIN_EXIT),
                                            crossing_times(recording, SECOND_EXIT))).sum()) for recording in recordings]
    wrong = [int((numpy.isfinite(numpy.where(to_main, crossing_times(recording, SECOND_EXIT),
                                             crossing_times(recording, MAIN_EXIT)))).sum()) for recording in recordings]
    through = [through_walls(recording) for recording in recordings]
    picture = draw_paths(shown(recordings), evaluation.folder / 'rimea_10.png', '23 people with assigned exits',
                         [('#1f77b4' if main else '#ff7f0e') for main in to_main])
    return Result(f'{texts.counts(right)} of 23 by the assigned exit, {texts.counts(wrong)} by the other; '
                  f'{texts.counts(through)} through walls', '23 of 23 by the assigned exit',
                  min(right) == len(to_main) and not any(wrong + through),
                  texts.problems(recordings, {'the main exit': (6.6, 11.0), 'the secondary exit': (18.0, 5.5)}),
                  (picture,))


CASE = Case('rimea_10', 'Assigned exits', run)
