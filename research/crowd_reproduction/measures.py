"""Measures of what the thesis only describes: groups, surrounded agents, passages between two obstacles. Places are
arrays (tick, agent, 2) [m], nan for an agent that is not present."""

import typing

import numpy
import pandas

RADIUS = 0.25  # of the thesis's agents [m]
COLLISION_RADIUS = 0.5  # [m]
CONTACT_OVERLAP = 0.001  # [m] a smaller overlap is not a contact


class Sector(typing.NamedTuple):
    """An occupied sector; angles from straight ahead, positive to the left [degrees]."""
    begin: float
    end: float
    distance_class: int


def sectors_of(occupied):
    """Parses the sectors of a record; sectors to the right of straight ahead have negative angles."""
    sectors = [map(float, word.split(':')) for word in occupied.split()]
    return [Sector(begin - (360 if end > 180 else 0), end - (360 if end > 180 else 0), int(distance_class))
            for begin, end, distance_class in sectors]


def nearest_distances(places):
    """Returns an array (tick, agent) of the distances to the nearest companion [m]; nan without a companion."""
    offsets = places[:, :, None] - places[:, None]
    distances = numpy.hypot(offsets[..., 0], offsets[..., 1])
    others = ~numpy.eye(places.shape[1], dtype=bool)
    distances = numpy.where(others & numpy.isfinite(distances), distances, numpy.inf).min(axis=2)
    return numpy.where(numpy.isfinite(distances), distances, numpy.nan)


def centre_distances(places):
    """Returns an array (tick) of the mean distance of the agents to their centroid [m]."""
    offsets = places - places.mean(axis=1, keepdims=True)
    return numpy.hypot(offsets[..., 0], offsets[..., 1]).mean(axis=1)


def while_all_are_there(places):
    """Returns the places at the ticks before the first agent leaves."""
    there = numpy.isfinite(places[..., 0]).all(axis=1)
    return places[:len(there) if there.all() else int(numpy.argmin(there))]


def passing(places, obstacle, reach):
    """Returns the first and last tick at which an agent's centre is within reach [m] of the obstacle's; or None."""
    offsets = places - obstacle[:len(places), None]
    near = numpy.flatnonzero((numpy.hypot(offsets[..., 0], offsets[..., 1]) <= reach).any(axis=1))
    return (int(near[0]), int(near[-1])) if len(near) else None


def first_ticks(places, centre, reach):
    """Returns the first tick at which each agent's centre is within reach [m] of a point; nan for those never there."""
    offsets = places - numpy.asarray(centre)
    near = numpy.hypot(offsets[..., 0], offsets[..., 1]) <= reach
    return numpy.where(near.any(axis=0), near.argmax(axis=0), numpy.nan)


def hidden_share(places, radius, vision):
    """Returns the share [%] of the bodies within an agent's vision (rim to centre [m]) that nearer ones hide wholly,
    of all agents and ticks; bodies have the same radius [m]."""
    seen = hidden = 0
    for line in places:
        there = line[numpy.isfinite(line[:, 0])]
        for agent, place in enumerate(there):
            offsets = numpy.delete(there, agent, axis=0) - place
            distances = numpy.hypot(offsets[:, 0], offsets[:, 1])
            near = numpy.argsort(distances)[:numpy.count_nonzero(distances - radius <= vision)]
            halves = numpy.arcsin(numpy.minimum(1.0, radius / numpy.maximum(distances[near], radius)))
            bearings = numpy.arctan2(offsets[near, 1], offsets[near, 0])
            seen += len(near)
            hidden += sum(is_hidden(bearings[i], halves[i], bearings[:i], halves[:i]) for i in range(1, len(near)))
    return share(hidden, seen)


def is_hidden(bearing, half, others, halves):
    """Returns whether the angles from bearing - half to bearing + half are covered by those of the others [rad]."""
    middles = (others - bearing + numpy.pi) % (2 * numpy.pi) - numpy.pi
    reached = -half
    for begin, end in sorted(zip(middles - halves, middles + halves)):
        if begin > reached:
            break
        reached = max(reached, end)
    return bool(reached >= half)


def crossing(walk, x):
    """Returns the y at which a path (tick, 2) last crosses the line at x to the right [m]; None if it does not."""
    crossed = numpy.flatnonzero((walk[:-1, 0] < x) & (walk[1:, 0] >= x))
    if not len(crossed):
        return None
    here, there = walk[crossed[-1]], walk[crossed[-1] + 1]
    return float(here[1] + (there[1] - here[1]) * (x - here[0]) / (there[0] - here[0]))


def within_next(flags, ticks):
    """Returns whether a flag (tick, agent) is set at any of the next ticks; the current tick is not included."""
    following = numpy.zeros_like(flags)
    for i in range(1, min(ticks, len(flags) - 1) + 1):
        following[:-i] |= flags[i:]
    return following


def is_contact(distances):
    """Returns whether two bodies overlap, given the distances of their centres [m]."""
    return distances < 2 * RADIUS - CONTACT_OVERLAP


def is_collision(distances):
    """Returns whether the rim of a body is within the collision radius, given the distances of the centres [m]."""
    return distances <= COLLISION_RADIUS + RADIUS


def share(part, whole):
    """Returns part / whole [%]; nan if whole is 0."""
    return 100.0 * part / whole if whole else float('nan')


def with_outcomes(decisions, ticks, obstacle=None):
    """Returns decisions with the columns contact and collision: whether the agent has one within the next ticks, with
    another agent or with an obstacle of this radius [m] at the origin."""
    def of_instance(rows):
        place = rows['tick'].to_numpy(), rows['agent'].to_numpy()
        places = numpy.full((place[0].max() + 1, place[1].max() + 1, 2), numpy.nan)
        places[place] = rows[['x', 'y']]
        distances = nearest_distances(places)
        if obstacle is not None:  # as far as the centre of an agent whose rim is as near
            distances = numpy.fmin(distances, numpy.hypot(places[..., 0], places[..., 1]) - obstacle + RADIUS)
        return rows.assign(contact=within_next(is_contact(distances), ticks)[place],
                           collision=within_next(is_collision(distances), ticks)[place])
    return pandas.concat([of_instance(rows) for _, rows in decisions.groupby('instance')])


def outcomes_of(decisions):
    """Returns the number of decisions, and the shares [%] that a contact and a collision follow."""
    count = len(decisions)
    return count, share(decisions['contact'].sum(), count), share(decisions['collision'].sum(), count)


class Surrounded(typing.NamedTuple):
    """Decisions of surrounded agents, other decisions (see outcomes_of()), and the results of the surrounded agents."""
    inside: tuple
    outside: tuple
    ever: float  # share of the agents that were ever surrounded [%]; the next two are shares of these
    arrived: float
    touched: float  # had a contact within the next ticks after being surrounded
    longest: int  # [ticks] without interruption

    def per_thousand(self):
        """Returns the number of decisions of surrounded agents per 1,000 decisions."""
        return 10.0 * share(self.inside[0], self.inside[0] + self.outside[0])


def surrounded(decisions, arrived, least_sectors, ticks, obstacle=None):
    """Returns a Surrounded. Arrived: a set of (instance, agent); ticks: those within which a contact counts; obstacle:
    see with_outcomes()."""
    rows = with_outcomes(decisions, ticks, obstacle)
    rows['inside'] = rows['sectors'] >= least_sectors
    inside = rows[rows['inside']]
    touched = inside.groupby(['instance', 'agent'])['contact'].any()
    grids = (of_instance.pivot(index='tick', columns='agent', values='inside').fillna(False).to_numpy(dtype=bool)
             for _, of_instance in rows.groupby('instance'))
    return Surrounded(outcomes_of(inside), outcomes_of(rows[~rows['inside']]),
                      share(len(touched), rows.groupby(['instance', 'agent']).ngroups),
                      share(sum(agent in arrived for agent in touched.index), len(touched)),
                      share(touched.sum(), len(touched)), max(map(longest_run, grids)))


def longest_run(flags):
    """Returns the greatest number of consecutive ticks for which a flag (tick, agent) is set."""
    longest, now = 0, numpy.zeros(flags.shape[1], dtype=int)
    for line in flags:
        now = numpy.where(line, now + 1, 0)
        longest = max(longest, int(now.max()))
    return longest


def by_visits(decisions, visits, limits, ticks, least_sectors=0):
    """Returns decisions, contacts and collisions as a table, by the visits of their row: from a limit to the next."""
    rows = with_outcomes(decisions, ticks).assign(decisions=1)
    rows['visited'] = numpy.digitize(visits[rows['row']], limits) - 1
    counted = rows[rows['sectors'] >= least_sectors].groupby('visited')[['decisions', 'contact', 'collision']].sum()
    return counted.reindex(range(len(limits)), fill_value=0)
