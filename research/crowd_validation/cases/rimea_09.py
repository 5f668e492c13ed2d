"""RiMEA 9: a crowd that leaves a large public space by two and by four exits."""
import random

import numpy
from crowd_experiments.records import Spread

from .. import measures as texts, plan
from ..drawing import draw_departures, draw_moments, shown
from ..evaluation import Case, Result
from ..measures import nearest_of
from ..plan import RADIUS, adult_speeds, places

PEOPLE = 1000
WIDTH, HEIGHT = 30.0, 20.0  # of the room [m]
GAPS = [(4.0, 5.0), (25.0, 26.0)]  # exits in each long wall [m]
DURATION = 600  # [s]
EXPECTED = (1.6, 2.4)  # time with two exits / time with four
UPPER = {'exit 1': (4.5, HEIGHT), 'exit 2': (25.5, HEIGHT)}
LOWER = {'exit 3': (4.5, 0.0), 'exit 4': (25.5, 0.0)}


def outside(exit_place):
    """Returns the goal of people who take an exit: one metre outside."""
    x, y = exit_place
    return x, y + 1.0 if y > 0 else y - 1.0


def document(seed, exits):
    """Returns the room with these exits; each person takes the nearest."""
    draw = random.Random(seed)
    walls = [*plan.wall((0.0, 0.0), (0.0, HEIGHT)), *plan.wall((WIDTH, 0.0), (WIDTH, HEIGHT))]
    for y in (0.0, HEIGHT):
        is_open = any(exit_place[1] == y for exit_place in exits.values())
        walls += plan.wall((0.0, y), (WIDTH, y), GAPS if is_open else ())
    starts = places(PEOPLE, (2.0, 2.0), (WIDTH - 2.0, HEIGHT - 2.0), RADIUS, draw)
    nearest = nearest_of(numpy.array(starts), list(exits.values()))
    goals = [outside(exit_place) for exit_place in exits.values()]
    people = [plan.agent(place, goals[index], speed, RADIUS)
              for place, index, speed in zip(starts, nearest, adult_speeds(PEOPLE, draw))]
    return plan.scenario('rimea_9', DURATION, people, walls, goal_tolerance=0.5)


def run(evaluation):
    """Compares the times with two and with four exits."""
    four_exits = {**UPPER, **LOWER}
    recordings = evaluation.walk({'two_exits': lambda seed: document(seed, LOWER),
                                  'four_exits': lambda seed: document(seed, four_exits)})
    two, four = recordings['two_exits'], recordings['four_exits']
    last = [[float(recording.arrivals.max()) for recording in of_plan] for of_plan in (two, four)]
    ratios = Spread(slow / fast if numpy.isfinite([slow, fast]).all() else numpy.inf for slow, fast in zip(*last))
    drawn = {'four exits': shown(four), 'two exits': shown(two)}
    panels = [(recording, time, f'{name}, after {time} s')
              for name, recording in drawn.items() for time in (20, DURATION // 4)]
    series = [(name, colour, drawn[name].arrivals) for name, colour in zip(drawn, ('#1f77b4', '#ff7f0e'))]
    pictures = (draw_moments(panels, evaluation.folder / 'rimea_9.png', 2),
                draw_departures(series, evaluation.folder / 'rimea_9_departures.png', '1,000 people leave a room'))
    passed = bool(EXPECTED[0] <= ratios.low and ratios.high <= EXPECTED[1])
    flows = [texts.spread((flow(recording, exits) for recording in of_plan), decimals=2)
             for of_plan, exits in ((two, LOWER), (four, four_exits))]
    remarks = [f'people per second and exit: {flows[0]} by two exits, {flows[1]} by four']
    remarks += [f'{name}: {text}' for name, text in (('two exits', texts.problems(two, LOWER)),
                                                     ('four exits', texts.problems(four, four_exits))) if text]
    return Result(f'two exits: {texts.arrived(two)}, the last after {texts.spread(last[0], "s", 0)}; four exits: '
                  f'{texts.arrived(four)}, the last after {texts.spread(last[1], "s", 0)}; ratio '
                  f'{texts.spread(ratios.values, "", 2)}', 'ratio 1.6-2.4', passed, '. '.join(remarks), pictures)


def flow(recording, exits):
    """Returns how many people leave per second by each of the exits: from the first tenth of the people to the last;
    infinite if fewer than nine tenths leave."""
    first, last = numpy.sort(recording.arrivals)[[PEOPLE // 10, PEOPLE - PEOPLE // 10 - 1]]
    return (PEOPLE - 2 * (PEOPLE // 10) - 1) / (last - first) / len(exits) if numpy.isfinite(last) else numpy.inf


CASE = Case('rimea_9', 'A crowd leaves a large room', run)
