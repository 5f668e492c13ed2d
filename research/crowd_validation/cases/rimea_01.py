"""RiMEA 1: keeping the walking speed in a corridor."""
from crowd_experiments.records import Spread

from .. import measures as texts, plan
from ..drawing import draw_paths
from ..evaluation import Case, Result
from ..measures import crossing_times
from ..plan import RADIUS

LENGTH, WIDTH, SPEED = 40.0, 2.0, 1.33  # [m], [m], [m/s]
EXPECTED = (26.0, 34.0)  # [s]


def document(_seed):
    """Returns the corridor with one person at x = 0 who walks beyond its end."""
    walls = plan.polyline((LENGTH + 2.0, 0.0), (-1.0, 0.0), (-1.0, WIDTH), (LENGTH + 2.0, WIDTH))
    walker = plan.agent((0.0, WIDTH / 2.0), (LENGTH + 1.0, WIDTH / 2.0), SPEED, RADIUS)
    return plan.scenario('rimea_1', 60, [walker], walls)


def run(evaluation):
    """Measures the time for the 40 m."""
    recordings = evaluation.walk({'corridor': document})['corridor']
    times = Spread(crossing_times(recording, [[LENGTH, 0.0], [LENGTH, WIDTH]])[0] for recording in recordings)
    picture = draw_paths(recordings[0], evaluation.folder / 'rimea_1.png', 'One person in a corridor')
    return Result(f'{texts.spread(times.values, "s", 2)} for 40 m', '26-34 s',
                  EXPECTED[0] <= times.low and times.high <= EXPECTED[1], pictures=(picture,))


CASE = Case('rimea_1', 'Walking speed in a corridor', run)
