"""RiMEA 12: two bottlenecks in a row."""
import random

from crowd_experiments.style import new_figure, save

from .. import measures as texts, plan
from ..drawing import draw_moments, shown
from ..evaluation import Case, Result
from ..measures import slow_people, sustained_peak
from ..plan import RADIUS, adult_speeds, places

PEOPLE = 150
ROOM, CORRIDOR, WIDTH = 10.0, 5.0, 1.0  # side of the rooms, length and width of the corridor and the exit [m]
SECOND = ROOM + CORRIDOR  # x of the second room [m]
GAP = [((ROOM - WIDTH) / 2.0, (ROOM + WIDTH) / 2.0)]
JAM = 5  # people below half of their maximum speed...
JAM_TIME = 5.0  # [s] ...for this time without interruption
DURATION = 400  # [s]


def document(seed):
    """Returns two rooms with a corridor between them and an exit; 150 people in the left half of the first room."""
    draw = random.Random(seed)
    low, high = GAP[0]
    walls = [*plan.wall((0.0, 0.0), (0.0, ROOM)),
             *plan.polyline((ROOM, low), (SECOND, low)), *plan.polyline((ROOM, high), (SECOND, high))]
    for left in (0.0, SECOND):
        walls += [*plan.wall((left, 0.0), (left + ROOM, 0.0)), *plan.wall((left, ROOM), (left + ROOM, ROOM))]
    for x in (ROOM, SECOND, SECOND + ROOM):
        walls += plan.wall((x, 0.0), (x, ROOM), GAP)
    starts = places(PEOPLE, (0.2, 0.5), (5.0, ROOM - 0.5), RADIUS, draw)
    goal = (SECOND + ROOM + 1.0, ROOM / 2.0)
    people = [plan.agent(place, goal, speed, RADIUS) for place, speed in zip(starts, adult_speeds(PEOPLE, draw))]
    return plan.scenario('rimea_12', DURATION, people, walls, goal_tolerance=0.5)


def run(evaluation):
    """Counts slow people in both rooms."""
    recordings = evaluation.walk({'rooms': document})['rooms']
    slow = [[slow_people(recording, (left, 0.0), (left + ROOM, ROOM)) for left in (0.0, SECOND)]
            for recording in recordings]
    peaks = [[sustained_peak(counts, round(JAM_TIME / plan.TICK)) for counts in of_seed] for of_seed in slow]
    first, second = zip(*peaks)
    recording = shown(recordings)
    figure, axes = new_figure(1, 1, 8.0, 3.5)
    for counts, name in zip(slow[recordings.index(recording)], ('first room', 'second room')):
        axes[0, 0].plot([tick * plan.TICK for tick in range(len(counts))], counts, label=name)
    axes[0, 0].set_xlabel('time [s]')
    axes[0, 0].set_ylabel('slow people')
    axes[0, 0].legend()
    pictures = (draw_moments([(recording, time, f'after {time} s') for time in (10, 80)],
                             evaluation.folder / 'rimea_12.png', 1),
                save(figure, evaluation.folder / 'rimea_12_slow.png'))
    passed = min(first) >= JAM > max(second) and all(recording.all_arrived() for recording in recordings)
    landmarks = {'the corridor': (ROOM, ROOM / 2.0), 'the exit': (SECOND + ROOM, ROOM / 2.0)}
    return Result(f'slow for {JAM_TIME:g} s: {texts.counts(first)} people in the first room, {texts.counts(second)} in '
                  f'the second; {texts.arrived(recordings)}, the last after '
                  f'{texts.spread((max(recording.arrivals) for recording in recordings), "s", 0)}',
                  f'a jam ({JAM} or more) in the first room, none in the second; all arrive', passed,
                  texts.problems(recordings, landmarks), pictures)


CASE = Case('rimea_12', 'Two bottlenecks in a row', run)
