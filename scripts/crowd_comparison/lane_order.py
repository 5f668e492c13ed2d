"""How far people who walk two ways have sorted themselves into lanes.

The order parameter is that of M. Rex and H. Löwen, Lane formation in oppositely charged colloids driven by an electric
field, Phys. Rev. E 75, 051402 (2007), as S. Nowak and A. Schadschneider took it over to pedestrians (Quantitative
analysis of pedestrian counterflow in a cellular automaton model, Phys. Rev. E 85, 066128, 2012):

    phi = mean over walkers of ((same - opposite) / (same + opposite))^2

over the others in a lane around the walker. The latter take off what chance gives as well: with n others whose ways are
drawn at random, the square is 1 / n on average.
"""
import numpy

STRETCH = 5.0  # [m] to either side of the corridor's middle: who is in it counts
LEAST_WALKERS = 4  # of each way in the stretch, for the order over time to mean something
HALF_WIDTH = 0.3  # [m] of a lane: whose centres are no further to the side walk in one lane with the walker


def lane_order(places, ways):
    """The order parameter and what chance would make of it; nan where nobody has company.
    @param places (n, 2) along and across the corridor [m]; nan: not there
    @param ways (n) 1 or -1"""
    here = numpy.abs(places[:, 0]) <= STRETCH  # nan is nowhere
    aside = places[here, 1]
    way = numpy.asarray(ways)[here]
    in_lane = numpy.abs(aside[:, None] - aside[None]) <= HALF_WIDTH
    numpy.fill_diagonal(in_lane, False)
    company = in_lane.sum(axis=1)
    balance = (in_lane * way[None]).sum(axis=1)[company > 0]  # of one way over the other; squared, whichever it is
    company = company[company > 0]
    if len(company) == 0:
        return float('nan'), float('nan')
    return float(numpy.mean((balance / company) ** 2)), float(numpy.mean(1.0 / company))


def order_above_chance(places, ways):
    """0 where the order is what chance gives, 1 in perfect lanes."""
    order, chance = lane_order(places, ways)
    return (order - chance) / (1.0 - chance) if chance < 1.0 else float('nan')


def order_over_time(track, ways):
    """The order above chance at every tick of a track (tick, agent, 2); nan where few of one way are in the
    stretch."""
    here = numpy.abs(track[:, :, 0]) <= STRETCH
    enough = numpy.all([here[:, numpy.equal(ways, way)].sum(axis=1) >= LEAST_WALKERS for way in (1, -1)], axis=0)
    return numpy.array([order_above_chance(places, ways) if is_enough else float('nan')
                        for places, is_enough in zip(track, enough)])
