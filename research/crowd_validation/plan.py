"""Floor plans, people by age, and scenario documents."""
import math
import random

RADIUS = 0.2  # [m]
RADIUS_IN_DENSE_CROWDS = 0.18  # [m] where people start at more than 4 per square metre
TICK = 0.1  # [s]
# Lowest and highest free walking speeds on the plane [m/s] by age, in the guideline's table after Weidmann (1992).
SPEEDS = {'under 30': (0.58, 1.61), '30 to 50': (1.41, 1.54), 'over 50': (0.68, 1.41),
          'limited mobility': (0.46, 0.76)}
ADULTS = ('under 30', '30 to 50', 'over 50')


def adult_speeds(count, draw):
    """Draws the speeds of adults [m/s]: the three age groups in turn, in a random order."""
    speeds = [draw.uniform(*SPEEDS[ADULTS[i % len(ADULTS)]]) for i in range(count)]
    draw.shuffle(speeds)
    return speeds


def places(count, low, high, radius, draw):
    """Draws places of bodies in a box, evenly spread without overlap. Raises ValueError if they do not fit."""
    width, height = high[0] - low[0], high[1] - low[1]
    columns = max(1, round(math.sqrt(count * width / height)))
    rows = math.ceil(count / columns)
    cell = width / columns, height / rows
    if min(cell) < 2.0 * radius:
        raise ValueError(f'{count} people of radius {radius} m do not fit into {width:g} x {height:g} m')
    cells = draw.sample([(column, row) for row in range(rows) for column in range(columns)], count)

    def place(index, axis):
        play = cell[axis] / 2.0 - radius
        return low[axis] + (index + 0.5) * cell[axis] + draw.uniform(-play, play)
    return [(place(column, 0), place(row, 1)) for column, row in cells]


def crowd(seed, count, low, high, goal, radius=RADIUS, above=0.0):
    """Returns adults at random places in a box that is moved up [m]. The goal may be a function of the place in it."""
    draw = random.Random(seed)
    starts = places(count, low, high, radius, draw)
    return [agent((place[0], above + place[1]), goal(place) if callable(goal) else goal, speed, radius)
            for place, speed in zip(starts, adult_speeds(count, draw))]


def wall(start, end, gaps=()):
    """Returns the walls from start to end without the gaps: (from, to) distances from the start, in order [m]."""
    length = math.dist(start, end)

    def point(distance):
        return [round(start[i] + (end[i] - start[i]) * distance / length, 6) for i in (0, 1)]
    ends = [0.0, *(distance for gap in gaps for distance in gap), length]
    return [[point(low), point(high)] for low, high in zip(ends[::2], ends[1::2]) if high > low]


def polyline(*points):
    return [[list(start), list(end)] for start, end in zip(points, points[1:])]


def agent(position, goal, speed, radius=RADIUS):
    """Returns an agent of a scenario. The position may be a region."""
    return {'position': [round(value, 4) for value in position], 'goal': list(goal), 'speed': round(speed, 4),
            'radius': radius}


def scenario(name, duration, agents, walls, goal_tolerance=0.3):
    """Returns a scenario document. Duration [s]."""
    return {'name': name, 'duration': duration, 'tick': TICK, 'goal_tolerance': goal_tolerance, 'agents': agents,
            'walls': walls}
