"""RiMEA 14: a short and a long way."""
import random

import numpy

from .. import measures as texts, plan
from ..drawing import draw_paths, shown
from ..evaluation import Case, Result
from ..measures import crossing_times
from ..plan import RADIUS, adult_speeds, places

PEOPLE = 100
SHORT = [[10.0, 18.0], [12.0, 18.0]]  # across the nearer of two parallel corridors
LONG = [[16.0, 18.0], [18.0, 18.0]]
LANDMARKS = {'the start': (7.0, 29.0), 'the short way': (11.0, 18.0), 'the goal': (0.0, 8.0)}


def document(seed):
    """Returns a room from which two corridors lead to the same goal; the second is a detour of 12 m."""
    draw = random.Random(seed)
    walls = [*plan.polyline((0.0, 9.0), (10.0, 9.0), (10.0, 28.0), (0.0, 28.0), (0.0, 35.0), (7.0, 35.0), (7.0, 30.0),
                            (18.0, 30.0), (18.0, 7.0), (-2.0, 7.0)), *plan.polyline((0.0, 9.0), (-2.0, 9.0)),
             *plan.polyline((12.0, 9.0), (16.0, 9.0), (16.0, 28.0), (12.0, 28.0), (12.0, 9.0))]
    starts = places(PEOPLE, (1.0, 29.0), (6.0, 34.0), RADIUS, draw)
    people = [plan.agent(place, (-1.0, 8.0), speed, RADIUS)
              for place, speed in zip(starts, adult_speeds(PEOPLE, draw))]
    return plan.scenario('rimea_14', 300, people, walls, goal_tolerance=0.9)


def run(evaluation):
    """Counts the people by ways."""
    recordings = evaluation.walk({'ways': document})['ways']
    short, long = ([int(numpy.isfinite(crossing_times(recording, gate)).sum()) for recording in recordings]
                   for gate in (SHORT, LONG))
    picture = draw_paths(shown(recordings), evaluation.folder / 'rimea_14.png', 'A short and a long way')
    return Result(f'{texts.counts(short)} of {PEOPLE} by the short way, {texts.counts(long)} by the long way; '
                  f'{texts.arrived(recordings)}, the last after '
                  f'{texts.spread((recording.arrivals.max() for recording in recordings), "s", 0)}',
                  'none: the choice is to be documented', None,
                  texts.problems(recordings, LANDMARKS), (picture,))


CASE = Case('rimea_14', 'A short and a long way', run)
