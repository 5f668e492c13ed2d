"""RiMEA 11: choice of the exit."""
import random

import numpy

from .. import measures as texts, plan
from ..drawing import draw_moments, shown
from ..evaluation import Case, Result
from ..measures import crossing_times
from ..plan import RADIUS_IN_DENSE_CROWDS, adult_speeds, places

PEOPLE = 1000
WIDTH, HEIGHT = 30.0, 20.0  # of the room [m]
EXITS = {'exit 1': [[21.0, HEIGHT], [22.0, HEIGHT]], 'exit 2': [[27.0, HEIGHT], [28.0, HEIGHT]]}
DURATION = 1500  # [s]
OUTSIDE, TOLERANCE = (24.5, HEIGHT + 3.0), 2.0  # the goal of all, as far from one exit as from the other [m]


def document(seed):
    """Returns the room with a dense crowd on the left; all people walk the shortest way to the outside."""
    draw = random.Random(seed)
    walls = [*plan.polyline((0.0, HEIGHT), (0.0, 0.0), (WIDTH, 0.0), (WIDTH, HEIGHT)),
             *plan.wall((0.0, HEIGHT), (WIDTH, HEIGHT), [(start[0], end[0]) for start, end in EXITS.values()])]
    starts = places(PEOPLE, (2.0, 2.0), (15.0, 18.0), RADIUS_IN_DENSE_CROWDS, draw)
    people = [plan.agent(place, OUTSIDE, speed, RADIUS_IN_DENSE_CROWDS)
              for place, speed in zip(starts, adult_speeds(PEOPLE, draw))]
    return plan.scenario('rimea_11', DURATION, people, walls, TOLERANCE)


def run(evaluation):
    """Counts the people by exits."""
    recordings = evaluation.walk({'room': document})['room']
    left = [{name: int(numpy.isfinite(crossing_times(recording, gate)).sum()) for name, gate in EXITS.items()}
            for recording in recordings]
    by = {name: [numbers[name] for numbers in left] for name in EXITS}
    passed = all(numbers['exit 1'] > numbers['exit 2'] > 0 for numbers in left) and \
        all(recording.all_arrived() for recording in recordings)
    recording = shown(recordings)
    moments = (0, 20, 240, 500 if recording.all_arrived() else DURATION)
    picture = draw_moments([(recording, time, f'after {time} s') for time in moments],
                           evaluation.folder / 'rimea_11.png', 2)
    landmarks = {name: gate[0] for name, gate in EXITS.items()}
    return Result(f'{texts.counts(by["exit 1"])} by exit 1, {texts.counts(by["exit 2"])} by exit 2, of {PEOPLE}; the '
                  f'last after {texts.spread((recording.arrivals.max() for recording in recordings), "s", 0)}',
                  'most by exit 1, which is nearer, and some by exit 2', passed, texts.problems(recordings, landmarks),
                  (picture,))


CASE = Case('rimea_11', 'Choice of the exit', run)
