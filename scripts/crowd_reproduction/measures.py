"""Measures of what the thesis only looks at: groups, surrounded agents, ways between two obstacles."""
import dataclasses

import numpy

RADIUS = 0.25  # of the thesis's agents [m]
COLLISION_RADIUS = 0.5  # [m]
CONTACT_OVERLAP = 0.001  # bodies that overlap by less only touch [m]


def nearest_distances(places):
    """How far the nearest companion is [m], centre to centre, from places (tick, agent, 2) that are nan where an agent
    is not there: an array (tick, agent), nan for those who are alone."""
    offsets = places[:, :, None] - places[:, None]
    distances = numpy.hypot(offsets[..., 0], offsets[..., 1])
    others = ~numpy.eye(places.shape[1], dtype=bool)
    distances = numpy.where(others & numpy.isfinite(distances), distances, numpy.inf).min(axis=2)
    return numpy.where(numpy.isfinite(distances), distances, numpy.nan)


def centre_distances(places):
    """How far the agents are from the middle of all of them [m], on average: an array (tick)."""
    offsets = places - places.mean(axis=1, keepdims=True)
    return numpy.hypot(offsets[..., 0], offsets[..., 1]).mean(axis=1)


def while_all_are_there(places):
    """The ticks before the first one leaves."""
    there = numpy.isfinite(places[..., 0]).all(axis=1)
    return places[:len(there) if there.all() else int(numpy.argmin(there))]


def passing(places, obstacle, reach):
    """First and last tick at which the centre of an agent is within reach [m] of the obstacle's, whose places are an
    array (tick, 2); None if that never happens."""
    offsets = places - obstacle[:len(places), None]
    near = numpy.flatnonzero((numpy.hypot(offsets[..., 0], offsets[..., 1]) <= reach).any(axis=1))
    return (int(near[0]), int(near[-1])) if len(near) else None


def crossing(walk, x):
    """Where a walk, an array (tick, 2), last crosses the line at x from left to right [m]; None if it does not."""
    crossed = numpy.flatnonzero((walk[:-1, 0] < x) & (walk[1:, 0] >= x))
    if not len(crossed):
        return None
    here, there = walk[crossed[-1]], walk[crossed[-1] + 1]
    return float(here[1] + (there[1] - here[1]) * (x - here[0]) / (there[0] - here[0]))


def within_next(flags, ticks):
    """Whether a flag (tick, agent) is set at any of the next so many ticks, this one not among them."""
    following = numpy.zeros_like(flags)
    for i in range(1, min(ticks, len(flags) - 1) + 1):
        following[:-i] |= flags[i:]
    return following


def grid_of(decisions, chosen):
    """Places (tick, agent, 2), nan where no decision was made, and a function that lays out a column of the chosen
    decisions (of one instance) in the same way."""
    ticks, agents = decisions['tick'][chosen], decisions['agent'][chosen]
    shape = ticks.max() + 1, agents.max() + 1

    def lay_out(column, empty):
        grid = numpy.full(shape + column.shape[1:], empty)
        grid[ticks, agents] = column
        return grid

    return lay_out(numpy.column_stack([decisions['x'][chosen], decisions['y'][chosen]]), numpy.nan), lay_out


def is_contact(distances):
    """Whether two bodies whose centres are so far apart overlap."""
    return distances < 2 * RADIUS - CONTACT_OVERLAP


def is_collision(distances):
    """Whether the rim of a body whose centre is so far away is within the collision radius."""
    return distances <= COLLISION_RADIUS + RADIUS


@dataclasses.dataclass
class Outcome:
    """Of decisions of one kind: how many, and after how many a contact or a collision came soon."""
    decisions: int = 0
    contacts: int = 0
    collisions: int = 0

    def add(self, chosen, contact, collision):
        """Counts the chosen of a grid of decisions."""
        self.decisions += int(chosen.sum())
        self.contacts += int((chosen & contact).sum())
        self.collisions += int((chosen & collision).sum())

    def contact_share(self):
        """[%]"""
        return share(self.contacts, self.decisions)

    def collision_share(self):
        """[%]"""
        return share(self.collisions, self.decisions)


@dataclasses.dataclass
class Surrounded:
    """Decisions of agents that were surrounded, those of the others, and how the agents fared."""
    inside: Outcome
    outside: Outcome
    agents: int = 0
    caught: int = 0  # agents that were ever surrounded
    caught_arrived: int = 0
    caught_touched: int = 0  # touched another within the next ticks after being surrounded
    longest: int = 0  # ticks without a break

    def per_thousand(self):
        """Of 1,000 decisions, how many were made by one who is surrounded."""
        return 10.0 * share(self.inside.decisions, self.inside.decisions + self.outside.decisions)

    def caught_share(self):
        """[% of the agents]"""
        return share(self.caught, self.agents)


def share(part, whole):
    """[%]"""
    return 100.0 * part / whole if whole else float('nan')


def surrounded(decisions, arrived, least_sectors, ticks):
    """How often agents are surrounded (so many sectors occupied, or more), and what comes of it within so many ticks;
    arrived: a set of (instance, agent)."""
    result = Surrounded(Outcome(), Outcome())
    for instance in numpy.unique(decisions['instance']):
        chosen = decisions['instance'] == instance
        places, lay_out = grid_of(decisions, chosen)
        sectors = lay_out(decisions['sectors'][chosen], -1)
        distances = nearest_distances(places)
        contact = within_next(is_contact(distances), ticks)
        collision = within_next(is_collision(distances), ticks)
        caught = sectors >= least_sectors
        result.inside.add(caught, contact, collision)
        result.outside.add((sectors >= 0) & ~caught, contact, collision)
        result.agents += caught.shape[1]
        result.longest = max(result.longest, longest_run(caught))
        for agent in numpy.flatnonzero(caught.any(axis=0)):
            result.caught += 1
            result.caught_arrived += (int(instance), int(agent)) in arrived
            result.caught_touched += bool((caught & contact)[:, agent].any())
    return result


def longest_run(flags):
    """The most ticks in a row for which a flag (tick, agent) is set."""
    longest, now = 0, numpy.zeros(flags.shape[1], dtype=int)
    for line in flags:
        now = numpy.where(line, now + 1, 0)
        longest = max(longest, int(now.max()))
    return longest


def by_visits(decisions, visits, limits, ticks, least_sectors=0):
    """Outcomes of decisions by how often their row was visited in training: classes from each limit to below the next;
    of those only with so many sectors occupied."""
    outcomes = [Outcome() for _ in limits]
    for instance in numpy.unique(decisions['instance']):
        chosen = decisions['instance'] == instance
        places, lay_out = grid_of(decisions, chosen)
        counted = lay_out(numpy.where(decisions['sectors'][chosen] >= least_sectors,
                                      numpy.digitize(visits[decisions['row'][chosen]], limits) - 1, -1), -1)
        distances = nearest_distances(places)
        contact, collision = (within_next(flags, ticks) for flags in (is_contact(distances), is_collision(distances)))
        for i, outcome in enumerate(outcomes):
            outcome.add(counted == i, contact, collision)
    return outcomes
