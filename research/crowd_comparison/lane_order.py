"""Lane order of two crowds that walk in opposite directions.

The order parameter is that of M. Rex and H. Löwen, Lane formation in oppositely charged colloids driven by an electric
field, Phys. Rev. E 75, 051402 (2007), applied to pedestrians by S. Nowak and A. Schadschneider (Quantitative
analysis of pedestrian counterflow in a cellular automaton model, Phys. Rev. E 85, 066128, 2012):

    phi = mean over walkers of ((same - opposite) / (same + opposite))^2

over the other walkers in a lane around the walker. Nowak and Schadschneider also subtract the value expected by chance:
with n others in random directions, the mean of the square is 1 / n.
"""
import numpy

STRETCH = 5.0  # [m] distance from the middle of the corridor within which walkers count
LEAST_WALKERS = 4  # minimum number of walkers of each direction in the stretch; with fewer, the order is nan
HALF_WIDTH = 0.3  # [m] half of the width of a lane, which is centred on the walker


def lane_order(places, directions):
    """Returns the order parameter and its value expected by chance; nan if all walkers are alone in their lanes.
    @param places (n, 2) along and across the corridor [m]; nan: not present
    @param directions (n) 1 or -1"""
    here = numpy.abs(places[:, 0]) <= STRETCH  # false for nan
    aside = places[here, 1]
    direction = numpy.asarray(directions)[here]
    in_lane = numpy.abs(aside[:, None] - aside[None]) <= HALF_WIDTH
    numpy.fill_diagonal(in_lane, False)
    company = in_lane.sum(axis=1)
    balance = (in_lane * direction[None]).sum(axis=1)[company > 0]  # surplus of one direction; the sign is irrelevant
    company = company[company > 0]
    if len(company) == 0:
        return float('nan'), float('nan')
    return float(numpy.mean((balance / company) ** 2)), float(numpy.mean(1.0 / company))


def order_above_chance(places, directions):
    """Returns the order above chance: 0 is chance, 1 is perfect lanes."""
    order, chance = lane_order(places, directions)
    return (order - chance) / (1.0 - chance) if chance < 1.0 else float('nan')


def order_over_time(track, directions):
    """Returns the order above chance at every tick of a track (tick, agent, 2); nan if the stretch has fewer than
    LEAST_WALKERS walkers of one direction."""
    here = numpy.abs(track[:, :, 0]) <= STRETCH
    counts = [here[:, numpy.equal(directions, direction)].sum(axis=1) for direction in (1, -1)]
    enough = numpy.minimum(*counts) >= LEAST_WALKERS
    return numpy.array([order_above_chance(places, directions) if is_enough else float('nan')
                        for places, is_enough in zip(track, enough)])
