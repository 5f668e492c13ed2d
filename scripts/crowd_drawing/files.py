"""Reads scenario files, maps in the format of map_server, and recorded trajectories for drawings."""
import csv
import difflib
import math
import pathlib
import textwrap

import numpy
from crowd_drawing.errors import InputError, complete_lines, opened, read_documents
from crowd_experiments.tools import find_config
from matplotlib.transforms import Affine2D

OCCUPIED_COLOUR, UNKNOWN_COLOUR, FREE_COLOUR = (70, 74, 82), (224, 226, 230), (255, 255, 255)
HEADER = ['instance', 'tick', 'agent', 'x', 'y']
DEFAULT_TICK = 0.1  # [s]
DEFAULT_RADIUS = 0.25  # [m] of recorded people without a scenario


class MapPicture:
    """The pixels of a map in three colours, uppermost row first, with its resolution [m] and origin [x, y, yaw]."""

    def __init__(self, pixels, resolution, origin):
        self.pixels, self.resolution, self.origin = pixels, resolution, origin
        self.size = [side * resolution for side in (pixels.shape[1], pixels.shape[0])]  # width, height [m]

    def transform(self):
        """Returns the transformation from metres in the map to metres in the scene."""
        return Affine2D().rotate(self.origin[2]).translate(*self.origin[:2])

    def corners(self):
        return [tuple(self.transform().transform((x, y))) for x in (0, self.size[0]) for y in (0, self.size[1])]


def read_map(file):
    """Returns the MapPicture of a YAML file of map_server. Raises InputError if it cannot be drawn."""
    try:
        keys, = read_documents(file)
        resolution, origin = float(keys['resolution']), [float(number) for number in keys['origin']]
        thresholds = float(keys['free_thresh']), float(keys['occupied_thresh'])
        image, negate = pathlib.Path(file).parent / keys['image'], str(keys['negate']) in ('1', 'True')
    except (KeyError, TypeError, ValueError) as error:
        raise InputError(f"{file}: is not a map of map_server: {' '.join(str(error).split())}") from None
    if not (len(origin) == 3 and all(map(math.isfinite, origin)) and 0 < resolution < math.inf):
        raise InputError(f'{file}: expected a resolution above 0 and an origin [x, y, yaw]')
    return MapPicture(colours_of(image, negate, *thresholds), resolution, origin)


def colours_of(image, negate, free_threshold, occupied_threshold):
    """Returns the pixels of an image in the colours of free, occupied and unknown cells."""
    import PIL.Image  # needed for maps only
    try:
        with PIL.Image.open(image) as opened:
            grey = numpy.asarray(opened.convert('L'), dtype=float)
    except PIL.UnidentifiedImageError:
        raise InputError(f'{image}: is not an image') from None
    darkness = (grey if negate else 255.0 - grey) / 255.0
    pixels = numpy.full(grey.shape + (3,), UNKNOWN_COLOUR, dtype=numpy.uint8)
    pixels[darkness < free_threshold] = FREE_COLOUR
    pixels[darkness > occupied_threshold] = OCCUPIED_COLOUR
    return pixels


class Population:
    """Areas of sources and sinks: their places; queues: line from the head; gates: wall, and when it is open."""

    def __init__(self, scene, document):
        sources = document.get('sources') or []
        self.source_areas = [source['area'] for source in sources]
        self.source_radii = [scene.radius(source, f'sources[{i}]') for i, source in enumerate(sources)]
        sinks, queues, gates = ((document.get(key) or {}).values() for key in ('sinks', 'queues', 'gates'))
        self.sink_areas = [sink['area'] for sink in sinks]
        self.queues = [self.queue(scene, queue) for queue in queues]
        self.gates = [(scene.wall(gate['wall'], 'gates'), gate.get('open', False)) for gate in gates]

    @staticmethod
    def queue(scene, entry):
        """Returns the head of a queue and the place of the fifth in line."""
        x, y = scene.point(entry['head'], 'queues')
        angle = math.radians(scene.number(entry['direction'], 'queues'))
        length = 4 * scene.number(entry.get('spacing', 0.6), 'queues')
        return (x, y), (x + length * math.cos(angle), y + length * math.sin(angle))


def is_open(periods, time):
    """Returns whether a gate is open at a time [s], given its key `open`: true, false, or a list of periods."""
    if isinstance(periods, bool):
        return periods
    return any(begin <= time < end for begin, end in periods)


def shipped_scenarios():
    """Returns the files of the package's scenarios by their names, also of those in folders of config/scenarios."""
    folder = find_config() / 'scenarios'
    files = sorted(folder.glob('*.yaml')) + sorted(folder.glob('*/*.yaml'))
    return {file.stem: file for file in files}


def find_scenario(name_or_file):
    """Returns the given file if it exists, otherwise the package's scenario of that name."""
    path = pathlib.Path(name_or_file)
    if path.exists() or path.parent != pathlib.Path('.') or path.suffix not in ('', '.yaml'):
        return name_or_file
    scenarios = shipped_scenarios()
    if path.stem in scenarios:
        return scenarios[path.stem]
    near = difflib.get_close_matches(path.stem, scenarios)
    names = near + [name for name in scenarios if name not in near]
    raise InputError(f"no scenario '{name_or_file}'" + (f", did you mean '{near[0]}'? There" if near else ': there') +
                     f" is no file {path.absolute()}; in config/scenarios there are {', '.join(names)}")


def numbers_of(file, line, words, columns, expected):
    """Returns columns of a line: whole numbers, maybe as 7.8000000e+02, and two numbers. Raises InputError."""
    try:
        *wholes, x, y = (float(words[column]) for column in columns)
        if not all(map(float.is_integer, wholes)):
            raise ValueError
        return *map(int, wholes), x, y
    except (ValueError, IndexError, OverflowError):
        got = textwrap.shorten(' '.join(words), 60, placeholder=' ...')  # a field in quotes may have many lines
        raise InputError(f"{file}:{line}: expected {expected}, got '{got}'") from None


def collect(file, rows, person='person', frame='frame'):
    """Returns walks, lists of (frame, x, y) by person, of rows (line, person, frame, x, y) in any order. Raises
    InputError, which has these words for person and frame."""
    walks = {}
    for line, of, at, x, y in rows:
        if min(of, at) < 0 or not (math.isfinite(x) and math.isfinite(y)):
            raise InputError(f'{file}:{line}: expected numbers of {person} and {frame} from 0, and finite positions')
        places = walks.setdefault(of, {})
        if at in places:
            raise InputError(f'{file}:{line}: {person} {of} is in {frame} {at} for the second time')
        places[at] = (x, y)
    if not walks:
        raise InputError(f'{file}: has no trajectory')
    return {of: [(at, *places[at]) for at in sorted(places)] for of, places in sorted(walks.items())}


def read_walks(file, instance):
    """Returns the instance, by default the first, and lists of (tick, x, y) [m] by agent. Raises InputError."""
    with opened(file, newline='') as stream:
        lines = csv.reader(complete_lines(stream, file))
        if next(lines, None) != HEADER:
            raise InputError(f"{file}:1: expected the header {','.join(HEADER)}")
        rows = [(lines.line_num, *numbers_of(file, lines.line_num, words, range(len(words)) if len(words) == 5 else [0],
                                             'three whole numbers and two numbers')) for words in lines]
    instances = sorted({of for _, of, *_ in rows})
    if instance is None and rows:
        instance = rows[0][1]
    if rows and instance not in instances:
        expected = ' to '.join(dict.fromkeys(map(str, (instances[0], instances[-1]))))
        raise InputError(f'{file}: has no instance {instance}, expected {expected}')
    return instance, collect(file, [(line, agent, tick, x, y) for line, of, tick, agent, x, y in rows
                                    if of == instance], 'agent', 'tick')


class Scene:
    """Agents, obstacles, robots and walls of a scenario document, as far as they can be drawn. Only what is drawn is
    checked: `evaluate` names the place of any other mistake."""

    def __init__(self, document, place):
        self.place = place
        self.map = None  # MapPicture
        try:
            self.read(document)
        except KeyError as error:
            raise InputError(f'{place}: the key {error} is missing') from None
        except (AttributeError, TypeError, ValueError) as error:
            raise InputError(f'{place}: is not a scenario that `evaluate` reads: {error}') from None

    def read(self, document):
        self.tick = self.number(document.get('tick', DEFAULT_TICK), 'tick')  # [s]
        self.need(self.tick > 0, 'tick', 'a number above 0', self.tick)
        self.speed_unit = 1.0 / self.tick if document.get('units') == 'thesis' else 1.0  # [m/s]
        self.name = str(document.get('name', ''))
        self.kinds = document.get('kinds') or {}
        self.agents, self.obstacles, self.robots = (
            [body for i, entry in enumerate(document.get(key) or [])
             for body in [read(entry, f'{key}[{i}]')] * self.count(entry, f'{key}[{i}].count')]
            for key, read in (('agents', self.agent), ('obstacles', self.obstacle), ('robots', self.robot)))
        self.recorded = [self.recorded_people(entry, f'recorded[{i}]')
                         for i, entry in enumerate(document.get('recorded') or [])]
        self.walls = [self.wall(wall, f'walls[{i}]') for i, wall in enumerate(document.get('walls') or [])]
        self.population = Population(self, document)
        self.radii = {}  # of agents, where a recording has them [m]

    def radius_of(self, agent):
        """Returns the radius of an agent; those of sources follow the agents of the start."""
        if agent in self.radii:
            return self.radii[agent]
        radii = self.population.source_radii or [DEFAULT_RADIUS]
        return self.agents[agent]['radius'] if agent < len(self.agents) else radii[0]

    def figure_of(self, agent):
        """Returns the figure of an agent (docs/kinds.md); those of sources are adults."""
        return self.agents[agent]['figure'] if agent < len(self.agents) else 'adult'

    def kind_of(self, entry):
        """Returns the kind of an entry, of a mix the first one. The package's kinds are in what evaluate writes."""
        name = entry.get('kind')
        return (self.kinds.get(next(iter(name)) if isinstance(name, dict) else name) or {}) if name else {}

    def need(self, condition, where, expected, got):
        if not condition:
            raise InputError(f'{self.place}: {where}: expected {expected}, got {got!r}')

    def number(self, value, where):
        """Returns a number, or the mean of a range [low, high]."""
        values = value if isinstance(value, list) and len(value) == 2 else [value]
        for element in values:
            is_number = isinstance(element, (int, float)) and not isinstance(element, bool)
            self.need(is_number and math.isfinite(element), where, 'a number or [low, high]', value)
        return sum(values) / len(values)

    def point(self, value, where):
        """Returns a point, or None for a region from which each episode draws a point."""
        if isinstance(value, dict):
            return None
        self.need(isinstance(value, list) and len(value) == 2, where, '[x, y]', value)
        return self.number(value[0], where), self.number(value[1], where)

    def points(self, value, where):
        """Returns a list of points, without regions."""
        is_list = isinstance(value, list) and value and isinstance(value[0], (list, dict))
        found = [self.point(element, where) for element in (value if is_list else [value])]
        return [point for point in found if point is not None]

    def radius(self, entry, where):
        radius = self.number({**self.kind_of(entry), **entry}['radius'], f'{where}.radius')
        self.need(radius > 0, f'{where}.radius', 'a number above 0', radius)
        return radius

    def count(self, entry, where):
        count = entry.get('count', 1)
        self.need(isinstance(count, int) and count >= 0, where, 'a whole number', count)
        return count

    def agent(self, entry, where):
        has_none = 'route' in entry or 'leader' in entry
        goal = {} if has_none else entry['goals'] if 'goals' in entry else entry['goal']
        mirror = goal.get('opposite') if isinstance(goal, dict) else None
        return {
            'radius': self.radius(entry, where),
            'figure': self.kind_of(entry).get('figure', 'adult'),
            'speed': self.number(entry.get('speed', 0), f'{where}.speed') * self.speed_unit,
            'goals': self.points(goal, f'{where}.goal'),
            # Centre of a goal that lies opposite the start.
            'mirror': None if mirror is None else self.point(mirror, f'{where}.goal.opposite'),
        }

    def obstacle(self, entry, where):
        velocity = self.point(entry.get('velocity', [0, 0]), f'{where}.velocity') or (0, 0)
        return {
            'position': self.point(entry['position'], f'{where}.position'),
            'radius': self.radius(entry, where),
            'velocity': (velocity[0] * self.speed_unit, velocity[1] * self.speed_unit),
            'to_and_fro': self.points(entry.get('to_and_fro', {}), f'{where}.to_and_fro'),
            'waypoints': self.points(entry.get('waypoints', {}), f'{where}.waypoints'),
            'speed': self.number(entry.get('speed', 0), f'{where}.speed') * self.speed_unit,
        }

    def robot(self, entry, where):
        """Reads a robot: its place and heading at the start [rad], and the radius of a disc that contains it."""
        heading = entry.get('heading', 0)
        radians = heading.get('radians') if isinstance(heading, dict) else None  # as `evaluate --scenes` writes it
        corners = self.points(entry.get('footprint', {}), f'{where}.footprint')
        return {
            'position': self.point(entry['position'], f'{where}.position'),
            'heading': math.radians(self.number(heading, f'{where}.heading')) if radians is None else radians,
            'radius': max(math.hypot(*corner) for corner in corners) if corners else self.radius(entry, where),
        }

    def recorded_people(self, entry, where):
        """Reads an entry under `recorded`; crowd_recordings.formats reads its file."""
        times = {key: self.number(entry[key], f'{where}.{key}') for key in ('from', 'to', 'offset', 'frame_rate')
                 if entry.get(key) is not None}
        return {'file': entry['file'], 'instance': entry.get('instance'), 'people': entry.get('people'), **times,
                'radius': self.number(entry.get('radius', DEFAULT_RADIUS), f'{where}.radius'),
                'shift': self.point(entry.get('shift', [0, 0]), f'{where}.shift')}

    def wall(self, wall, where):
        ends = [self.point(end, where) for end in wall]
        self.need(len(ends) == 2 and None not in ends, where, '[[x1, y1], [x2, y2]]', wall)
        return ends


def read_scene(file, instance):
    """Reads the document of an instance; documents are repeated if there are fewer documents than instances."""
    documents = read_documents(file)
    if not documents:
        raise InputError(f'{file}: has no scenario')
    index = instance % len(documents)
    scene = Scene(documents[index], f'{file}: document {index + 1}')
    for entry in scene.recorded:
        entry['file'] = (pathlib.Path(file).parent / entry['file']).resolve()  # the folder may be a temporary one
    if 'map' in documents[index]:
        scene.map = read_map(pathlib.Path(file).parent / documents[index]['map'])
    return scene


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
    points = numpy.array(points)
    passed = numpy.cumsum([0.0, *numpy.hypot(*numpy.diff(points, axis=0).T)])
    return tuple(float(numpy.interp(distance % passed[-1], passed, axis)) for axis in points.T)
