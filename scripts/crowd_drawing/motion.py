"""Positions of moving obstacles."""
import math


def place_of(obstacle, time):
    """Returns the centre of an obstacle at a time after the start of the episode [s]."""
    x, y = obstacle['position']
    if obstacle['to_and_fro']:
        there = [(x, y)] + obstacle['to_and_fro']
        return along(there + there[-2::-1], obstacle['speed'] * time)
    if obstacle['waypoints']:
        return along([(x, y)] + obstacle['waypoints'] + [(x, y)], obstacle['speed'] * time)
    return x + obstacle['velocity'][0] * time, y + obstacle['velocity'][1] * time


def along(points, distance):
    """Returns the point at a distance along a closed path [m], which is repeated."""
    legs = list(zip(points, points[1:]))
    distance %= sum(math.dist(here, there) for here, there in legs)
    for (x0, y0), (x1, y1) in legs:
        length = math.dist((x0, y0), (x1, y1))
        if distance < length:
            share = distance / length
            return x0 + share * (x1 - x0), y0 + share * (y1 - y0)
        distance -= length
    return points[-1]
