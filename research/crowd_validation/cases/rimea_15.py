"""RiMEA 15: a large crowd around a corner."""
import random

from .. import measures as texts, plan
from ..drawing import draw_moments, shown
from ..evaluation import Case, Result
from ..measures import crossing_times
from ..plan import RADIUS_IN_DENSE_CROWDS, adult_speeds, places

PEOPLE = 500
WIDTH, DEPTH = 20.0, 6.0  # of the corridors, and of the area at their upper ends where people start [m]
SHORT, LONG = 50.0, 81.0  # [m]
TOP, CHAMFER, END = 60.0, 10.0, 30.0  # of the corner: its first leg ends at y = 60 m, the second at x = 30 m
DURATION = 300  # [s]


def people(seed, top, goal_of):
    """Returns the crowd at the top of a corridor. `goal_of` is a function of the distance from the left wall [m]."""
    draw = random.Random(seed)
    starts = places(PEOPLE, (0.1, -DEPTH), (WIDTH - 0.1, -0.1), RADIUS_IN_DENSE_CROWDS, draw)
    speeds = adult_speeds(PEOPLE, draw)
    return [plan.agent((x, top + y), goal_of(x), speed, RADIUS_IN_DENSE_CROWDS)
            for (x, y), speed in zip(starts, speeds)]


def straight(length):
    """Returns the plan of a straight corridor, a function of the seed, and its end."""
    def document(seed):
        walls = plan.polyline((0.0, -2.0), (0.0, length), (WIDTH, length), (WIDTH, -2.0))
        return plan.scenario('rimea_15', DURATION, people(seed, length, lambda x: (round(x, 3), -1.0)), walls, 0.8)
    return document, [[0.0, 0.0], [WIDTH, 0.0]]


def corner():
    """Returns the plan of the corner, a function of the seed, and its end. The outer corner is cut off."""
    def document(seed):
        walls = plan.polyline((END + 2.0, 0.0), (CHAMFER, 0.0), (0.0, CHAMFER), (0.0, TOP), (WIDTH, TOP),
                              (WIDTH, WIDTH), (END + 2.0, WIDTH))
        crowd = people(seed, TOP, lambda x: (END + 1.0, round(x, 3)))
        return plan.scenario('rimea_15', DURATION, crowd, walls, 0.8)
    return document, [[END, 0.0], [END, WIDTH]]


def run(evaluation):
    """Compares the arrival times of the last person in the three corridors."""
    plans = {'short': straight(SHORT), 'corner': corner(), 'long': straight(LONG)}
    recordings = evaluation.walk({name: document for name, (document, _) in plans.items()})
    last = {name: [float(crossing_times(recording, end).max()) for recording in recordings[name]]
            for name, (_, end) in plans.items()}
    panels = [(shown(recordings[name]), 30.0, f'{name}, after 30 s') for name in plans]
    picture = draw_moments(panels, evaluation.folder / 'rimea_15.png', 3)
    passed = all(short < round_it < long < float('inf') for short, round_it, long in
                 zip(last['short'], last['corner'], last['long']))
    remarks = '. '.join(f'{name}: {text}' for name in plans
                        if (text := texts.problems(recordings[name], {'the start': plans[name][1][0]})))
    return Result('; '.join(f'{name} {texts.spread(times, "s", 1)}' for name, times in last.items()),
                  'short < corner < long', passed, remarks, (picture,))


CASE = Case('rimea_15', 'A large crowd around a corner', run)
