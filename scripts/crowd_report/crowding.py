"""How close people are to each other, and how fast they walk at which density, from trajectories."""
import math

import numpy

STEP = 0.5  # [s] between two moments that are measured; people hardly move in a tick
RADIUS = 2.0  # [m] of the disc in which people are counted
SPAN = 1.0  # [s] over which speeds are measured


def separations(track, tick):
    """Returns the distance from each person to the nearest other one [m], centre to centre, at moments 0.5 s apart.
    Track: array (tick, agent, 2) with nan for those who are not there; tick: duration [s]."""
    found = []
    for places in track[::stride(STEP, tick)]:
        here = places[numpy.isfinite(places[:, 0])]
        if len(here) > 1:
            found.append(distances(here).min(axis=1))
    return numpy.concatenate(found) if found else numpy.empty(0)


def distances(places):
    """Returns the distances between all places; infinite from a place to itself."""
    apart = numpy.hypot(*(places[:, None, :] - places[None, :, :]).transpose(2, 0, 1))
    numpy.fill_diagonal(apart, numpy.inf)
    return apart


def speeds_and_densities(track, tick):
    """Returns speed [m/s] and density [1/m2] of each person that is recorded for a whole second, at moments 0.5 s
    apart. The speed is the displacement in this second, divided by it; the density is the number of people within 2 m
    in its middle, including the person, divided by the area of this disc."""
    span, half = stride(SPAN, tick), stride(SPAN, tick) // 2
    speeds, densities = [], []
    for start in range(0, len(track) - span, stride(STEP, tick)):
        begin, middle, end = track[start], track[start + half], track[start + span]
        there = numpy.isfinite(middle[:, 0])
        whole = there & numpy.isfinite(begin[:, 0]) & numpy.isfinite(end[:, 0])
        if whole.any():
            near = (distances(middle[there]) <= RADIUS).sum(axis=1) + 1
            speeds.append(numpy.hypot(*(end - begin)[whole].T) / (span * tick))
            densities.append(near[whole[there]] / (math.pi * RADIUS**2))
    return (numpy.concatenate(speeds), numpy.concatenate(densities)) if speeds else (numpy.empty(0), numpy.empty(0))


def stride(duration, tick):
    """Returns a duration in ticks, at least 1."""
    return max(1, round(duration / tick))


def speed_by_density(speeds, densities, least=20):
    """Returns density [1/m2], and mean and standard deviation of the speeds [m/s], for each number of people in the
    disc that occurred at least `least` times."""
    rows = [(density, speeds[densities == density]) for density in numpy.unique(densities)]
    return numpy.array([(density, values.mean(), values.std()) for density, values in rows
                        if len(values) >= least]).reshape(-1, 3)
