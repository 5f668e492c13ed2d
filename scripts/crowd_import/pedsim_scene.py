"""Scenes of pedsim_ros, with the rules of its ScenarioReader; elements of XML files know their lines."""
import dataclasses
import difflib
import math
import pathlib
import xml.parsers.expat

from crowd_drawing.errors import InputError

SIMPLE, SOURCE, SINK = 0, 1, 2  # behaviours of a waypoint
ADULT, CHILD, ROBOT, ELDER = 0, 1, 2, 3  # types of agents
TYPE_NAMES = {ADULT: 'adult', CHILD: 'child', ROBOT: 'robot', ELDER: 'elder'}
ROUTE_PARTS = ('addwaypoint', 'addqueue')


@dataclasses.dataclass
class Element:
    """An XML element: its tag, its attributes, and the file and line where it starts, for messages."""
    file: str
    line: int
    tag: str
    attributes: dict
    children: list = dataclasses.field(default_factory=list)

    def fail(self, text):
        """Raises InputError with file, line and tag of the element."""
        raise InputError(f'{self.file}:{self.line}: {self.tag}: {text}')

    def text(self, name):
        """Returns an attribute, which must be present and not empty."""
        value = self.attributes.get(name, '')
        if not value:
            self.fail(f"the attribute '{name}' is missing")
        return value

    def number(self, name, default=None):
        """Returns an attribute as a finite number. It must be present unless there is a default."""
        if default is not None and name not in self.attributes:
            return default
        text = self.text(name)
        try:
            value = float(text)
        except ValueError:
            value = math.nan
        if not math.isfinite(value):
            self.fail(f"{name}: expected a number, got '{text}'")
        return value

    def not_negative(self, name, default=None):
        """Returns an attribute as a finite number of 0 or more."""
        value = self.number(name, default)
        if value < 0:
            self.fail(f"{name}: expected a number of 0 or more, got '{self.attributes[name]}'")
        return value

    def whole(self, name, default=None):
        """Returns an attribute as a whole number of 0 or more."""
        value = self.not_negative(name, default)
        if value != int(value):
            self.fail(f"{name}: expected a whole number, got '{self.attributes[name]}'")
        return int(value)


def read_root(file):
    """Returns the root element of an XML file. Raises InputError with the line of an error."""
    parser = xml.parsers.expat.ParserCreate()
    document = Element(file, 0, 'document', {})
    path = [document]

    def start(tag, attributes):
        path[-1].children.append(Element(file, parser.CurrentLineNumber, tag, attributes))
        path.append(path[-1].children[-1])

    parser.StartElementHandler = start
    parser.EndElementHandler = lambda _tag: path.pop()
    try:
        parser.Parse(pathlib.Path(file).read_bytes(), True)
    except (xml.parsers.expat.ExpatError, LookupError, ValueError) as error:  # the last two: of its encoding
        reason = getattr(error, 'code', None)
        message = str(error) if reason is None else xml.parsers.expat.ErrorString(reason)
        raise InputError(f'{file}:{parser.CurrentLineNumber}: not XML: {message}') from None
    return document.children[0]


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


class Attraction:
    """A box in which people stop: its middle and its sides."""

    def __init__(self, element):
        self.element = element
        self.name = element.text('id')
        self.middle = element.number('x'), element.number('y')
        self.sides = element.not_negative('width'), element.not_negative('height')
        self.strength = element.not_negative('strength')


STOPS = {'waypoint': Waypoint, 'queue': Queue}


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
        self.stops = {}  # waypoints and queues by id
        root = read_root(file)
        if root.tag != 'scenario':
            root.fail("expected a scene of pedsim_ros, whose root is 'scenario'")
        elements = {tag: [element for element in root.children if element.tag == tag]
                    for tag in ('obstacle', 'agent', 'source', 'attraction')}
        self.walls = elements['obstacle']
        self.attractions = {}  # by id
        for element in elements['attraction']:
            self.add_new(Attraction(element), self.attractions)
        for element in root.children:
            if element.tag in STOPS:
                self.add_new(STOPS[element.tag](element), self.stops)
            elif element.tag in ROUTE_PARTS:
                element.fail('expected within an agent or a source')
        self.agents, self.sources = ([Cluster(element) for element in elements[tag]] for tag in ('agent', 'source'))
        self.others = [element for element in root.children if element.tag not in (*elements, *STOPS)]
        for cluster in self.agents + self.sources:
            stops = [self.stop_of(part) for part in cluster.element.children if part.tag in ROUTE_PARTS]
            cluster.stops = [stop for stop in stops if stop is not None]
            self.others += [part for part in cluster.element.children if part.tag not in ROUTE_PARTS]
        if not self.agents and not self.sources:
            root.fail('expected at least one agent or source')

    @staticmethod
    def add_new(entry, entries):
        """Adds an object with `name` and `element`, or raises InputError if there is one of its name."""
        known = entries.setdefault(entry.name, entry)
        if known is not entry:
            entry.element.fail(f"the id '{entry.name}' is used in line {known.element.line} already")

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
