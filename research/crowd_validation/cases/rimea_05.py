"""RiMEA 5: reaction times."""
import random

import numpy
from crowd_experiments.style import new_figure, save

from .. import measures as texts, plan
from ..evaluation import Case, Result
from ..measures import starts
from ..plan import RADIUS, adult_speeds, places

WIDTH, LENGTH = 5.0, 8.0  # of the room [m]; the exit is in the middle of a short wall
PEOPLE = 10
TOLERANCE = 0.2  # [s] two ticks


def reaction_times():
    """Returns the reaction times [s]: 10, 20, ... 100."""
    return [10.0 * (i + 1) for i in range(PEOPLE)]


def document(seed):
    """Returns the room with ten people of different reaction times."""
    draw = random.Random(seed)
    walls = [*plan.polyline((0.0, LENGTH), (0.0, 0.0), (WIDTH, 0.0), (WIDTH, LENGTH)),
             *plan.wall((0.0, LENGTH), (WIDTH, LENGTH), [(2.0, 3.0)])]
    starts_at = places(PEOPLE, (0.5, 0.5), (4.5, 7.0), RADIUS, draw)
    people = [{**plan.agent(place, (2.5, LENGTH + 1.5), speed, RADIUS), 'reaction_time': time}
              for place, speed, time in zip(starts_at, adult_speeds(PEOPLE, draw), reaction_times())]
    return plan.scenario('rimea_5', 200, people, walls)


def run(evaluation):
    """Compares the moments at which people start with their reaction times."""
    recordings = evaluation.walk({'room': document})['room']
    expected = numpy.array(reaction_times())
    found = [starts(recording) for recording in recordings]
    differences = [float(numpy.max(numpy.abs(times - expected))) for times in found]
    figure, axes = new_figure(1, 1, 5.0, 4.0)
    axes[0, 0].plot([0.0, 110.0], [0.0, 110.0], color='0.7')
    axes[0, 0].plot(expected, found[0], 'o')
    axes[0, 0].set_xlabel('reaction time [s]')
    axes[0, 0].set_ylabel('measured start [s]')
    picture = save(figure, evaluation.folder / 'rimea_5.png')
    passed = max(differences) <= TOLERANCE and all(recording.all_arrived() for recording in recordings)
    return Result(f'largest difference between start and reaction time {texts.spread(differences, "s", 2)}, '
                  f'{texts.arrived(recordings)}',
                  f'each person starts after its reaction time (10, 20, ... 100 s), within {TOLERANCE:g} s', passed,
                  texts.problems(recordings, {'the exit': (2.5, LENGTH)}), (picture,))


CASE = Case('rimea_5', 'Reaction times', run)
