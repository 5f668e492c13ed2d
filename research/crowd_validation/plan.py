"""Floor plans and scenario documents."""
import math

TICK = 0.1  # [s]


def wall(start, end, gaps=()):
    """Returns the walls from start to end without the gaps: (from, to) distances from the start, in order [m]."""
    length = math.dist(start, end)

    def point(distance):
        return [round(start[i] + (end[i] - start[i]) * distance / length, 6) for i in (0, 1)]
    ends = [0.0, *(distance for gap in gaps for distance in gap), length]
    return [[point(low), point(high)] for low, high in zip(ends[::2], ends[1::2]) if high > low]


def polyline(*points):
    """Returns the walls along these points."""
    return [[list(start), list(end)] for start, end in zip(points, points[1:])]


def agent(position, goal, speed, radius):
    """Returns an agent of a scenario. The position may be a region."""
    return {'position': [round(value, 4) for value in position], 'goal': list(goal), 'speed': round(speed, 4),
            'radius': radius}


def scenario(name, duration, agents, walls, goal_tolerance=0.3):
    """Returns a scenario document. Duration [s]."""
    return {'name': name, 'duration': duration, 'tick': TICK, 'goal_tolerance': goal_tolerance, 'agents': agents,
            'walls': walls}
