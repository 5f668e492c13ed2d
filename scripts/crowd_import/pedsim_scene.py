"""Scenes of pedsim_ros, with the rules of its ScenarioReader."""
import difflib

from crowd_import.elements import read_root

SIMPLE, SOURCE, SINK = 0, 1, 2  # behaviours of a waypoint
ADULT, CHILD, ROBOT, ELDER = 0, 1, 2, 3  # types of agents
TYPE_NAMES = {ADULT: 'adult', CHILD: 'child', ROBOT: 'robot', ELDER: 'elder'}
ROUTE_PARTS = {'addwaypoint', 'addqueue'}


class Waypoint:
    """A disc that agents walk to."""

    def __init__(self, element):
        self.element = element
        self.name = element.text('id')
        self.centre = element.number('x'), element.number('y')
        self.radius = element.not_negative('r')
        self.behaviour = element.whole('b', SIMPLE)
        if self.behaviour not in (SIMPLE, SOURCE, SINK):
            element.fail(f'b: expected {SIMPLE} (simple), {SOURCE} (source) or {SINK} (sink), got {self.behaviour}')


class Queue:
    """A point in front of which agents wait in line; `direction` [deg]: where they look."""

    def __init__(self, element):
        self.element = element
        self.name = element.text('id')
        self.head = element.number('x'), element.number('y')
        self.direction = element.number('direction')


class Cluster:
    """Agents, or a source of agents: their number, the middle and the sides of their box, their type and stops."""

    def __init__(self, element):
        self.element = element
        self.middle = element.number('x'), element.number('y')
        self.sides = element.not_negative('dx', 0.0), element.not_negative('dy', 0.0)
        self.count = element.whole('n')
        self.type = element.whole('type', ADULT)
        if self.type not in TYPE_NAMES:
            known = ', '.join(f'{number} ({name})' for number, name in TYPE_NAMES.items())
            element.fail(f'type: expected one of {known}, got {self.type}')
        self.stops = []  # waypoints and queues


class PedsimScene:
    """The elements of a scene, in the order of the file."""

    def __init__(self, file, skip_unknown=False):
        self.skip_unknown = skip_unknown
        self.unknown = []  # parts of routes that were skipped
        self.walls = []  # elements
        self.stops = {}  # waypoints and queues by id
        self.agents = []
        self.sources = []
        self.others = []  # all other elements
        root = read_root(file)
        if root.tag != 'scenario':
            root.fail("expected a scene of pedsim_ros, whose root is 'scenario'")
        for element in root.children:
            self.add(element)
        for cluster in self.agents + self.sources:
            stops = [self.stop_of(part) for part in cluster.element.children if part.tag in ROUTE_PARTS]
            cluster.stops = [stop for stop in stops if stop is not None]
            self.others += [part for part in cluster.element.children if part.tag not in ROUTE_PARTS]
        if not self.agents and not self.sources:
            root.fail('expected at least one agent or source')

    def add(self, element):
        """Adds an element below the root."""
        if element.tag == 'obstacle':
            self.walls.append(element)
        elif element.tag in ('waypoint', 'queue'):
            self.add_stop(Waypoint(element) if element.tag == 'waypoint' else Queue(element))
        elif element.tag == 'agent':
            self.agents.append(Cluster(element))
        elif element.tag == 'source':
            self.sources.append(Cluster(element))
        elif element.tag in ROUTE_PARTS:
            element.fail('expected within an agent or a source')
        else:
            self.others.append(element)

    def add_stop(self, stop):
        """Adds a waypoint or a queue, whose id must be new."""
        if stop.name in self.stops:
            stop.element.fail(f"the id '{stop.name}' is used in line {self.stops[stop.name].element.line} already")
        self.stops[stop.name] = stop

    def stop_of(self, part):
        """Returns the waypoint or queue that an `addwaypoint` or `addqueue` names; None if it is skipped."""
        name = part.text('id')
        kinds = (Queue,) if part.tag == 'addqueue' else (Waypoint, Queue)  # as pedsim_ros looks them up
        known = {other for other, stop in self.stops.items() if isinstance(stop, kinds)}
        if name not in known and self.skip_unknown:
            self.unknown.append(part)
            return None
        if name not in known:
            near = difflib.get_close_matches(name, sorted(known), 1)
            kind = 'queue' if part.tag == 'addqueue' else 'waypoint'
            part.fail(f"there is no {kind} '{name}'" + (f", did you mean '{near[0]}'?" if near else ''))
        return self.stops[name]
