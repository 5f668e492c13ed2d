"""Where a moving obstacle is."""
import math


def place_of(obstacle, time):
    """The centre of an obstacle whose way is fixed, so long after the episode's start [s]."""
    x, y = obstacle['position']
    if obstacle['to_and_fro']:
        there = [(x, y)] + obstacle['to_and_fro']
        return along(there + there[-2::-1], obstacle['speed'] * time)
    if obstacle['waypoints']:
        return along([(x, y)] + obstacle['waypoints'] + [(x, y)], obstacle['speed'] * time)
    return x + obstacle['velocity'][0] * time, y + obstacle['velocity'][1] * time


def along(points, distance):
    """The point so far along a closed way [m], round and round."""
    legs = list(zip(points, points[1:]))
    distance %= sum(math.dist(here, there) for here, there in legs)
    for (x0, y0), (x1, y1) in legs:
        length = math.dist((x0, y0), (x1, y1))
        if distance < length:
            share = distance / length
            return x0 + share * (x1 - x0), y0 + share * (y1 - y0)
        distance -= length
    return points[-1]
