"""RiMEA 9 to 15: crowds that leave rooms, choose ways, and jam."""
import math
import random

import numpy
from crowd_experiments.records import Spread
from crowd_experiments.style import new_figure, save

from . import plan
from .drawing import draw_departures, draw_moments, draw_paths, shown
from .evaluation import Result
from .measures import (all_arrived, arrived, counts, crossing_times, last, nearest_of, problems, slow_people, spread,
                       sustained_peak, through_walls)
from .plan import RADIUS_IN_DENSE_CROWDS

PEOPLE = 1000
WIDTH, HEIGHT = 30.0, 20.0  # of the large room [m]
GAPS = [(4.0, 5.0), (25.0, 26.0)]  # exits in each long wall [m]
UPPER = {'exit 1': (4.5, HEIGHT), 'exit 2': (25.5, HEIGHT)}
LOWER = {'exit 3': (4.5, 0.0), 'exit 4': (25.5, 0.0)}
LONGEST = 600  # [s]
DEPTH, DOOR = 5.0, 0.9  # of the rooms, width of their doors [m]
CORRIDOR = (5.0, 6.0)  # y [m]
MAIN_EXIT = [[6.0, 11.0], [7.2, 11.0]]  # at the end of a passage between the second and the third upper room
SECOND_EXIT = [[18.0, CORRIDOR[0]], [18.0, CORRIDOR[1]]]
TO_MAIN_EXIT = (1, 2, 3, 4, 7, 8, 9, 10)  # rooms
# The rooms 1 to 12 as (left, right, number of people): 1 to 6 above the corridor, 7 to 12 below it.
ROOMS = [(0.0, 3.0, 2), (3.0, 6.0, 2), (7.2, 9.0, 1), (9.0, 12.0, 2), (12.0, 15.0, 2), (15.0, 18.0, 2),
         *((3.0 * i, 3.0 * (i + 1), 2) for i in range(6))]
ASSIGNED = [i for i, (_, _, people) in enumerate(ROOMS, 1) for _ in range(people)]  # rooms of the 23 people
EXITS = {'exit 1': [[21.0, HEIGHT], [22.0, HEIGHT]], 'exit 2': [[27.0, HEIGHT], [28.0, HEIGHT]]}
OUTSIDE = (24.5, HEIGHT + 3.0)  # the goal of all, as far from one exit as from the other [m]
SIDE, SECOND = 10.0, 15.0  # of the rooms, x of the second room [m]; the corridor and the exit are 1 m wide
GAP = [(4.5, 5.5)]
JAM = 5  # people below half of their maximum speed...
JAM_TIME = 5.0  # [s] ...for this time without interruption
WAYS = [[[10.0, 18.0], [12.0, 18.0]], [[16.0, 18.0], [18.0, 18.0]]]  # across a short and a long corridor
ACROSS, STARTED = 20.0, 6.0  # width of the corridors, and depth of the area at their upper ends where people start [m]
TOP, CHAMFER, END = 60.0, 10.0, 30.0  # of the corner: its first leg ends at y = 60 m, the second at x = 30 m


def large_room(seed, exits):
    """Returns the room with these exits; each person takes the nearest, to a goal one metre outside."""
    walls = [*plan.wall((0.0, 0.0), (0.0, HEIGHT)), *plan.wall((WIDTH, 0.0), (WIDTH, HEIGHT))]
    for y in (0.0, HEIGHT):
        is_open = any(exit_place[1] == y for exit_place in exits.values())
        walls += plan.wall((0.0, y), (WIDTH, y), GAPS if is_open else ())
    goals = [(x, y + 1.0 if y > 0 else y - 1.0) for x, y in exits.values()]
    people = plan.crowd(seed, PEOPLE, (2.0, 2.0), (WIDTH - 2.0, HEIGHT - 2.0),
                        lambda place: goals[nearest_of(numpy.array([place]), list(exits.values()))[0]])
    return plan.scenario('rimea_9', LONGEST, people, walls, goal_tolerance=0.5)


def rimea_9(evaluation):
    exits = {'two exits': LOWER, 'four exits': {**UPPER, **LOWER}}
    found = evaluation.walk({'two_exits': lambda seed: large_room(seed, exits['two exits']),
                             'four_exits': lambda seed: large_room(seed, exits['four exits'])})
    found = {name: found[name.replace(' ', '_')] for name in exits}
    times = {name: [float(recording.arrivals.max()) for recording in recordings] for name, recordings in found.items()}
    ratios = Spread(slow / fast if numpy.isfinite([slow, fast]).all() else numpy.inf for slow, fast in
                    zip(*times.values()))
    drawn = {name: shown(found[name]) for name in ('four exits', 'two exits')}
    panels = [(recording, time, f'{name}, after {time} s')
              for name, recording in drawn.items() for time in (20, LONGEST // 4)]
    series = [(name, colour, drawn[name].arrivals) for name, colour in zip(drawn, ('#1f77b4', '#ff7f0e'))]
    flows = [spread((flow(recording, exits[name]) for recording in found[name]), decimals=2) for name in exits]
    remarks = [f'people per second and exit: {flows[0]} by two exits, {flows[1]} by four']
    remarks += [f'{name}: {text}' for name in exits if (text := problems(found[name], exits[name]))]
    measured = '; '.join(f'{name}: {arrived(found[name])}, the last after {spread(times[name], "s", 0)}'
                         for name in exits)
    return Result(f'{measured}; ratio {spread(ratios.values, "", 2)}', 'ratio 1.6-2.4',
                  bool(1.6 <= ratios.low and ratios.high <= 2.4), '. '.join(remarks),
                  (draw_moments(panels, evaluation.folder / 'rimea_9.png', 2),
                   draw_departures(series, evaluation.folder / 'rimea_9_departures.png', '1,000 people leave a room')))


def flow(recording, exits):
    """Returns people per second and exit, without the first and the last tenth; infinite if the latter stay."""
    first, end = numpy.sort(recording.arrivals)[[PEOPLE // 10, PEOPLE - PEOPLE // 10 - 1]]
    return (PEOPLE - 2 * (PEOPLE // 10) - 1) / (end - first) / len(exits) if numpy.isfinite(end) else numpy.inf


def twelve_rooms(seed):
    """Returns a corridor between two rows of rooms, with 23 people."""
    walls = plan.polyline((0.0, CORRIDOR[0]), (0.0, CORRIDOR[1]))
    draw = random.Random(seed)
    speeds = iter(plan.adult_speeds(len(ASSIGNED), draw))
    people = []
    for i, (left, right, count) in enumerate(ROOMS, 1):
        near, far = (CORRIDOR[1], CORRIDOR[1] + DEPTH) if i <= 6 else (CORRIDOR[0], CORRIDOR[0] - DEPTH)
        middle = (right - left) / 2.0
        walls += plan.wall((left, near), (right, near), [(middle - DOOR / 2.0, middle + DOOR / 2.0)])
        walls += plan.polyline((left, near), (left, far), (right, far), (right, near))
        low, high = (7.0, 10.5) if i <= 6 else (0.5, 4.0)
        goal = (6.6, 12.0) if i in TO_MAIN_EXIT else (19.0, 5.5)
        people += [plan.agent(place, goal, next(speeds)) for place in
                   plan.places(count, (left + 0.3, low), (right - 0.3, high), plan.RADIUS, draw)]
    return plan.scenario('rimea_10', 180, people, walls)


def rimea_10(evaluation):
    recordings = evaluation.walk_one('corridor', twelve_rooms)
    to_main = numpy.isin(ASSIGNED, TO_MAIN_EXIT)

    def by(assigned, other):
        return [int(numpy.isfinite(numpy.where(to_main, crossing_times(recording, assigned),
                                               crossing_times(recording, other))).sum()) for recording in recordings]
    right, wrong = by(MAIN_EXIT, SECOND_EXIT), by(SECOND_EXIT, MAIN_EXIT)
    through = [through_walls(recording) for recording in recordings]
    picture = draw_paths(shown(recordings), evaluation.folder / 'rimea_10.png', '23 people with assigned exits',
                         [('#1f77b4' if main else '#ff7f0e') for main in to_main])
    return Result(f'{counts(right)} of 23 by the assigned exit, {counts(wrong)} by the other; '
                  f'{counts(through)} through walls', '23 of 23 by the assigned exit',
                  min(right) == len(to_main) and not any(wrong + through),
                  problems(recordings, {'the main exit': (6.6, 11.0), 'the secondary exit': (18.0, 5.5)}), (picture,))


def dense_room(seed):
    """Returns the room with a dense crowd on the left; all people walk the shortest way to the outside."""
    walls = [*plan.polyline((0.0, HEIGHT), (0.0, 0.0), (WIDTH, 0.0), (WIDTH, HEIGHT)),
             *plan.wall((0.0, HEIGHT), (WIDTH, HEIGHT), [(start[0], end[0]) for start, end in EXITS.values()])]
    people = plan.crowd(seed, PEOPLE, (2.0, 2.0), (15.0, 18.0), OUTSIDE, RADIUS_IN_DENSE_CROWDS)
    return plan.scenario('rimea_11', 1500, people, walls, goal_tolerance=2.0)


def rimea_11(evaluation):
    recordings = evaluation.walk_one('room', dense_room)
    first, second = ([int(numpy.isfinite(crossing_times(recording, gate)).sum()) for recording in recordings]
                     for gate in EXITS.values())
    passed = all(near > far > 0 for near, far in zip(first, second)) and all_arrived(recordings)
    recording = shown(recordings)
    panels = [(recording, time, f'after {time} s') for time in (0, 20, 240, 500 if recording.all_arrived() else 1500)]
    return Result(f'{counts(first)} by exit 1, {counts(second)} by exit 2, of {PEOPLE}; {last(recordings)}',
                  'most by exit 1, which is nearer, and some by exit 2', passed,
                  problems(recordings, {name: gate[0] for name, gate in EXITS.items()}),
                  (draw_moments(panels, evaluation.folder / 'rimea_11.png', 2),))


def two_rooms(seed):
    """Returns two rooms with a corridor between them and an exit; 150 people in the left half of the first room."""
    low, high = GAP[0]
    walls = [*plan.wall((0.0, 0.0), (0.0, SIDE)),
             *plan.polyline((SIDE, low), (SECOND, low)), *plan.polyline((SIDE, high), (SECOND, high))]
    for left in (0.0, SECOND):
        walls += [*plan.wall((left, 0.0), (left + SIDE, 0.0)), *plan.wall((left, SIDE), (left + SIDE, SIDE))]
    for x in (SIDE, SECOND, SECOND + SIDE):
        walls += plan.wall((x, 0.0), (x, SIDE), GAP)
    people = plan.crowd(seed, 150, (0.2, 0.5), (5.0, SIDE - 0.5), (SECOND + SIDE + 1.0, SIDE / 2.0))
    return plan.scenario('rimea_12', 400, people, walls, goal_tolerance=0.5)


def rimea_12(evaluation):
    recordings = evaluation.walk_one('rooms', two_rooms)
    slow = [[slow_people(recording, (left, 0.0), (left + SIDE, SIDE)) for left in (0.0, SECOND)]
            for recording in recordings]
    first, second = zip(*([sustained_peak(people, round(JAM_TIME / plan.TICK)) for people in of_seed]
                          for of_seed in slow))
    recording = shown(recordings)
    figure, ((axes,),) = new_figure(1, 1, 8.0, 3.5)
    for people, name in zip(slow[recordings.index(recording)], ('first room', 'second room')):
        axes.plot([tick * plan.TICK for tick in range(len(people))], people, label=name)
    axes.set(xlabel='time [s]', ylabel='slow people')
    axes.legend()
    panels = [(recording, time, f'after {time} s') for time in (10, 80)]
    return Result(f'slow for {JAM_TIME:g} s: {counts(first)} people in the first room, {counts(second)} in the second; '
                  f'{arrived(recordings)}, {last(recordings)}',
                  f'a jam ({JAM} or more) in the first room, none in the second; all arrive',
                  min(first) >= JAM > max(second) and all_arrived(recordings),
                  problems(recordings, {'the corridor': (SIDE, SIDE / 2.0), 'the exit': (SECOND + SIDE, SIDE / 2.0)}),
                  (draw_moments(panels, evaluation.folder / 'rimea_12.png', 1),
                   save(figure, evaluation.folder / 'rimea_12_slow.png')))


def two_ways(seed):
    """Returns a room from which two corridors lead to the same goal; the second is a detour of 12 m."""
    walls = [*plan.polyline((0.0, 9.0), (10.0, 9.0), (10.0, 28.0), (0.0, 28.0), (0.0, 35.0), (7.0, 35.0), (7.0, 30.0),
                            (18.0, 30.0), (18.0, 7.0), (-2.0, 7.0)), *plan.polyline((0.0, 9.0), (-2.0, 9.0)),
             *plan.polyline((12.0, 9.0), (16.0, 9.0), (16.0, 28.0), (12.0, 28.0), (12.0, 9.0))]
    people = plan.crowd(seed, 100, (1.0, 29.0), (6.0, 34.0), (-1.0, 8.0))
    return plan.scenario('rimea_14', 300, people, walls, goal_tolerance=0.9)


def rimea_14(evaluation):
    recordings = evaluation.walk_one('ways', two_ways)
    short, long = ([int(numpy.isfinite(crossing_times(recording, gate)).sum()) for recording in recordings]
                   for gate in WAYS)
    landmarks = {'the start': (7.0, 29.0), 'the short way': (11.0, 18.0), 'the goal': (0.0, 8.0)}
    return Result(f'{counts(short)} of 100 by the short way, {counts(long)} by the long way; {arrived(recordings)}, '
                  f'{last(recordings)}', 'none: the choice is to be documented', None, problems(recordings, landmarks),
                  (draw_paths(shown(recordings), evaluation.folder / 'rimea_14.png', 'A short and a long way'),))


def wide_corridor(seed, length):
    """Returns a straight corridor with a large crowd at its top."""
    walls = plan.polyline((0.0, -2.0), (0.0, length), (ACROSS, length), (ACROSS, -2.0))
    return large_crowd(seed, walls, length, lambda place: (round(place[0], 3), -1.0))


def wide_corner(seed):
    """Returns the corner, of which the outer one is cut off."""
    walls = plan.polyline((END + 2.0, 0.0), (CHAMFER, 0.0), (0.0, CHAMFER), (0.0, TOP), (ACROSS, TOP), (ACROSS, ACROSS),
                          (END + 2.0, ACROSS))
    return large_crowd(seed, walls, TOP, lambda place: (END + 1.0, round(place[0], 3)))


def large_crowd(seed, walls, top, goal):
    people = plan.crowd(seed, 500, (0.1, -STARTED), (ACROSS - 0.1, -0.1), goal, RADIUS_IN_DENSE_CROWDS, top)
    return plan.scenario('rimea_15', 300, people, walls, goal_tolerance=0.8)


def rimea_15(evaluation):
    ends = {'short': [[0.0, 0.0], [ACROSS, 0.0]], 'corner': [[END, 0.0], [END, ACROSS]],
            'long': [[0.0, 0.0], [ACROSS, 0.0]]}
    found = evaluation.walk({'short': lambda seed: wide_corridor(seed, 50.0), 'corner': wide_corner,
                             'long': lambda seed: wide_corridor(seed, 81.0)})
    times = {name: [float(crossing_times(recording, end).max()) for recording in found[name]]
             for name, end in ends.items()}
    panels = [(shown(found[name]), 30.0, f'{name}, after 30 s') for name in ends]
    remarks = '. '.join(f'{name}: {text}' for name, end in ends.items()
                        if (text := problems(found[name], {'the start': end[0]})))
    return Result('; '.join(f'{name} {spread(of_seeds, "s", 1)}' for name, of_seeds in times.items()),
                  'short < corner < long',
                  all(short < corner < long < math.inf for short, corner, long in zip(*times.values())), remarks,
                  (draw_moments(panels, evaluation.folder / 'rimea_15.png', 3),))
