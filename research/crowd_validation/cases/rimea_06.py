"""RiMEA 6: movement around a corner."""
import random

from .. import measures as texts, plan
from ..drawing import draw_paths, shown
from ..evaluation import Case, Result
from ..measures import largest_overlap, through_walls
from ..plan import RADIUS, adult_speeds, places

PEOPLE = 20
WIDTH, LEG = 2.0, 10.0  # of the corridor [m]: inner sides of both legs
OVERLAP = 0.001  # [m] smaller overlaps are rounding


def document(seed):
    """Returns two corridors at a right angle with 20 people in the first six metres."""
    draw = random.Random(seed)
    outer = LEG + WIDTH
    walls = [*plan.polyline((outer, outer + 2.0), (outer, 0.0), (0.0, 0.0), (0.0, WIDTH), (LEG, WIDTH),
                            (LEG, outer + 2.0))]
    goal = (LEG + WIDTH / 2.0, outer + 1.0)
    people = [plan.agent(place, goal, speed, RADIUS) for place, speed in
              zip(places(PEOPLE, (0.1, 0.1), (6.0, WIDTH - 0.1), RADIUS, draw), adult_speeds(PEOPLE, draw))]
    return plan.scenario('rimea_6', 120, people, walls, goal_tolerance=0.8)


def run(evaluation):
    """Counts people through walls and in contact."""
    recordings = evaluation.walk({'corner': document})['corner']
    through = [through_walls(recording) for recording in recordings]
    touched = [int(recording.touched.sum()) for recording in recordings]
    overlaps = [largest_overlap(recording) for recording in recordings]
    picture = draw_paths(shown(recordings), evaluation.folder / 'rimea_6.png', '20 people around a corner')
    passed = not any(through) and not any(touched) and max(overlaps) <= OVERLAP and \
        all(recording.all_arrived() for recording in recordings)
    return Result(f'{texts.arrived(recordings)}, {texts.counts(through)} through walls, {texts.counts(touched)} in '
                  f'contact; the last after {texts.spread((max(recording.arrivals) for recording in recordings), "s")}',
                  'all arrive, none through a wall, none in contact', passed,
                  texts.problems(recordings, {'the corner': (11.0, 1.0), 'the end': (11.0, 12.0)}), (picture,))


CASE = Case('rimea_6', 'Movement around a corner', run)
