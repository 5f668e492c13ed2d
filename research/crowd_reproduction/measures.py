"""Measures of what the thesis only describes (groups, surrounded agents, passages between two obstacles), and the files
of `evaluate --states` and `train` that they read."""
import dataclasses
import io

import numpy
import pandas
from crowd_experiments import records

HEADER = ['instance', 'tick', 'agent', 'x', 'y', 'heading', 'row', 'action', 'occupied']


@dataclasses.dataclass(frozen=True)
class Sector:
    """An occupied sector; angles from straight ahead, positive to the left [degrees]."""
    begin: float
    end: float
    distance_class: int


def read_decisions(file):
    """Returns a table of decisions; the column `occupied` has texts, `sectors` the number of occupied sectors."""
    with open(file, encoding='utf-8') as stream:
        if next(stream, '').rstrip('\n').split(',') != HEADER:
            raise ValueError(f"{file}:1: expected the header {','.join(HEADER)}")
        decisions = pandas.read_csv(io.StringIO(stream.read()), names=HEADER, keep_default_na=False, dtype={
            'x': float, 'y': float, 'heading': float, 'occupied': str})
    decisions['sectors'] = decisions['occupied'].str.count(':').floordiv(2)
    return decisions


def sectors_of(occupied):
    """Parses the sectors of a record; sectors to the right of straight ahead have negative angles."""
    sectors = [Sector(float(begin), float(end), int(distance_class))
               for begin, end, distance_class in (word.split(':') for word in occupied.split())]
    return [dataclasses.replace(sector, begin=sector.begin - 360, end=sector.end - 360) if sector.end > 180 else sector
            for sector in sectors]


def read_visits(file):
    """Returns the number of visits of each row of a Q-table, as an array."""
    visits = numpy.zeros(int(records.read_table_header(file)['rows']), dtype=int)
    found = records.read_visits(file)
    visits[list(found)] = list(found.values())
    return visits


RADIUS = 0.25  # of the thesis's agents [m]
COLLISION_RADIUS = 0.5  # [m]
CONTACT_OVERLAP = 0.001  # [m] a smaller overlap is not a contact


def nearest_distances(places):
    """Returns an array (tick, agent) of the distances to the nearest companion [m], centre to centre; nan without a
    companion. Places are (tick, agent, 2), nan for an agent that is not present."""
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
    """Returns the first and last tick at which the centre of an agent is within reach [m] of the obstacle's centre;
    None if there is no such tick. Obstacle: places (tick, 2)."""
    offsets = places - obstacle[:len(places), None]
    near = numpy.flatnonzero((numpy.hypot(offsets[..., 0], offsets[..., 1]) <= reach).any(axis=1))
    return (int(near[0]), int(near[-1])) if len(near) else None


def crossing(walk, x):
    """Returns the y at which a path, an array (tick, 2), last crosses the line at x from left to right [m]; None if it
    does not cross the line."""
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


@dataclasses.dataclass
class Outcome:
    """Number of decisions of one kind, and how many of them were soon followed by a contact or a collision."""
    decisions: int = 0
    contacts: int = 0
    collisions: int = 0

    def add(self, chosen, contact, collision):
        """Counts the chosen decisions of a grid."""
        self.decisions += int(chosen.sum())
        self.contacts += int((chosen & contact).sum())
        self.collisions += int((chosen & collision).sum())

    def contact_share(self):
        """Returns the share of decisions followed by a contact [%]."""
        return share(self.contacts, self.decisions)

    def collision_share(self):
        """Returns the share of decisions followed by a collision [%]."""
        return share(self.collisions, self.decisions)


@dataclasses.dataclass
class Surrounded:
    """Decisions of surrounded agents, decisions of other agents, and the results of the surrounded agents."""
    inside: Outcome = dataclasses.field(default_factory=Outcome)
    outside: Outcome = dataclasses.field(default_factory=Outcome)
    agents: int = 0
    surrounded: int = 0  # agents that were ever surrounded
    surrounded_arrived: int = 0
    surrounded_touched: int = 0  # had a contact with an agent within the next ticks after being surrounded
    longest: int = 0  # [ticks] without interruption

    def per_thousand(self):
        """Returns the number of decisions of surrounded agents per 1,000 decisions."""
        return 10.0 * share(self.inside.decisions, self.inside.decisions + self.outside.decisions)

    def touched_share(self):
        """Returns the share of agents that were ever surrounded and then had a contact [%]."""
        return share(self.surrounded_touched, self.surrounded)


def instances_of(decisions, ticks):
    """Yields for each instance: its number, a function that arranges a value of each decision as (tick, agent), and
    whether a contact and a collision follow within the next ticks."""
    for instance, rows in decisions.groupby('instance'):
        place = rows['tick'].to_numpy(), rows['agent'].to_numpy()
        shape = place[0].max() + 1, place[1].max() + 1

        def lay_out(column, empty):
            grid = numpy.full(shape + column.shape[1:], empty)
            grid[place] = column
            return grid

        distances = nearest_distances(lay_out(rows[['x', 'y']].to_numpy(), numpy.nan))
        yield instance, rows, lay_out, *(within_next(flags, ticks) for flags in
                                         (is_contact(distances), is_collision(distances)))


def surrounded(decisions, arrived, least_sectors, ticks):
    """Counts how often agents are surrounded (at least least_sectors sectors occupied), and contacts and collisions
    within the next ticks. Arrived: a set of (instance, agent)."""
    result = Surrounded()
    for instance, rows, lay_out, contact, collision in instances_of(decisions, ticks):
        sectors = lay_out(rows['sectors'].to_numpy(), -1)
        is_surrounded = sectors >= least_sectors
        result.inside.add(is_surrounded, contact, collision)
        result.outside.add((sectors >= 0) & ~is_surrounded, contact, collision)
        result.agents += is_surrounded.shape[1]
        result.longest = max(result.longest, longest_run(is_surrounded))
        found = numpy.flatnonzero(is_surrounded.any(axis=0))
        result.surrounded += len(found)
        result.surrounded_arrived += sum((int(instance), int(agent)) in arrived for agent in found)
        result.surrounded_touched += int((is_surrounded & contact).any(axis=0).sum())
    return result


def longest_run(flags):
    """Returns the greatest number of consecutive ticks for which a flag (tick, agent) is set."""
    longest, now = 0, numpy.zeros(flags.shape[1], dtype=int)
    for line in flags:
        now = numpy.where(line, now + 1, 0)
        longest = max(longest, int(now.max()))
    return longest


def by_visits(decisions, visits, limits, ticks, least_sectors=0):
    """Returns the outcomes of decisions by the number of visits of their row in training. Each class reaches from one
    limit to below the next. Only decisions with at least least_sectors occupied sectors count."""
    outcomes = [Outcome() for _ in limits]
    for _, rows, lay_out, contact, collision in instances_of(decisions, ticks):
        classes = numpy.digitize(visits[rows['row']], limits) - 1
        counted = lay_out(numpy.where(rows['sectors'] >= least_sectors, classes, -1), -1)
        for i, outcome in enumerate(outcomes):
            outcome.add(counted == i, contact, collision)
    return outcomes
