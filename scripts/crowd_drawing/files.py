"""Reads scenario files and recorded trajectories for drawings."""
import csv
import difflib
import math
import pathlib

import yaml
from crowd_drawing.errors import InputError, complete_lines
from crowd_drawing.maps import read_map


class Population:
    """Areas of sources and sinks: their places; queues: line from the head; gates: wall, and when it is open."""

    def __init__(self, scene, document):
        self.scene = scene
        sources = scene.listed(document, 'sources')
        for i, source in enumerate(sources):
            scene.need(isinstance(source, dict) and 'area' in source and 'radius' in source, f'sources[{i}]',
                       'a map with area and radius', source)
        self.source_areas = [source['area'] for source in sources]
        self.source_radii = [scene.radius(source, f'sources[{i}]') for i, source in enumerate(sources)]
        self.sink_areas = [sink['area'] for sink in self.named(document, 'sinks', 'area')]
        self.queues = [self.queue(queue) for queue in self.named(document, 'queues', 'head', 'direction')]
        self.gates = [(scene.wall(gate['wall'], 'gates'), gate.get('open', False))
                      for gate in self.named(document, 'gates', 'wall')]

    def named(self, document, key, *needed):
        """Returns the values of a map of maps that have the needed keys."""
        entries = document.get(key) or {}
        self.scene.need(isinstance(entries, dict), key, 'a map of names', entries)
        for name, entry in entries.items():
            has_all = isinstance(entry, dict) and all(word in entry for word in needed)
            self.scene.need(has_all, f'{key}.{name}', f"a map with {', '.join(needed)}", entry)
        return list(entries.values())

    def queue(self, entry):
        """Returns the head of a queue and the place of the fifth in line."""
        x, y = self.scene.point(entry['head'], 'queues')
        angle = math.radians(self.scene.number(entry['direction'], 'queues'))
        length = 4 * self.scene.number(entry.get('spacing', 0.6), 'queues')
        return (x, y), (x + length * math.cos(angle), y + length * math.sin(angle))


def is_open(periods, time):
    """Returns whether a gate is open at a time [s], given its key `open`: true, false, or a list of periods."""
    if isinstance(periods, bool):
        return periods
    return any(begin <= time < end for begin, end in periods)


HEADER = ['instance', 'tick', 'agent', 'x', 'y']
DEFAULT_TICK = 0.1  # [s]
DEFAULT_RADIUS = 0.25  # [m] of recorded people without a scenario
HERE = pathlib.Path(__file__).resolve().parent
# Folders that may contain config/scenarios: the source tree, and PREFIX/share for programs in PREFIX/lib/social_crowd.
HOMES = [HERE.parents[1], HERE.parents[2] / 'share' / 'social_crowd']


def shipped_scenarios():
    """Returns the package's scenario files by their names."""
    return {file.stem: file for home in HOMES for file in sorted((home / 'config' / 'scenarios').glob('*.yaml'))}


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


def read_walks(file, instance):
    """Returns the instance, by default the first, and lists of (tick, x, y) [m] by agent. Raises InputError."""
    walks = {}
    instances = set()
    with open(file, newline='', encoding='utf-8', errors='replace') as stream:
        rows = csv.reader(complete_lines(stream, file))
        if next(rows, None) != HEADER:
            raise InputError(f"{file}:1: expected the header {','.join(HEADER)}")
        for row in rows:
            try:
                row_instance, tick, agent = map(int, row[:3])
                x, y = map(float, row[3:])
            except ValueError:
                raise InputError(f"{file}:{rows.line_num}: expected three whole numbers and two numbers, "
                                 f"got '{','.join(row)}'") from None
            if min(row_instance, tick, agent) < 0 or not (math.isfinite(x) and math.isfinite(y)):
                raise InputError(f"{file}:{rows.line_num}: negative or not finite: '{','.join(row)}'")
            instances.add(row_instance)
            if instance is None:
                instance = row_instance
            if row_instance == instance:
                places = walks.setdefault(agent, {})
                if tick in places:
                    raise InputError(f'{file}:{rows.line_num}: agent {agent} is in tick {tick} for the second time')
                places[tick] = (x, y)
    if not instances:
        raise InputError(f'{file}: has no trajectory')
    if not walks:
        least, most = min(instances), max(instances)
        expected = least if least == most else f'{least} to {most}'
        raise InputError(f'{file}: has no instance {instance}, expected {expected}')
    return instance, {agent: [(tick, *places[tick]) for tick in sorted(places)] for agent, places in walks.items()}


class Scene:
    """Agents, obstacles and walls of a scenario document, as far as they can be drawn."""

    def __init__(self, document, place):
        self.place = place
        self.need(isinstance(document, dict), '', 'a map', document)
        thesis = document.get('units') == 'thesis'
        self.tick = self.number(document.get('tick', DEFAULT_TICK), 'tick')  # [s]
        self.need(self.tick > 0, 'tick', 'a number above 0', self.tick)
        self.speed_unit = 1.0 / self.tick if thesis else 1.0  # [m/s]
        self.name = str(document.get('name', ''))
        self.agents = self.entries(document, 'agents', self.agent)
        self.obstacles = self.entries(document, 'obstacles', self.obstacle)
        self.robots = [self.robot(robot, f'robots[{i}]') for i, robot in enumerate(self.listed(document, 'robots'))]
        self.walls = [self.wall(wall, f'walls[{i}]') for i, wall in enumerate(self.listed(document, 'walls'))]
        self.map = None  # MapPicture
        self.population = Population(self, document)

    def radius_of(self, agent):
        """Returns the radius of an agent; those of sources follow the agents of the start."""
        radii = self.population.source_radii or [DEFAULT_RADIUS]
        return self.agents[agent]['radius'] if agent < len(self.agents) else radii[0]

    def need(self, condition, where, expected, got):
        if not condition:
            raise InputError(f"{self.place}: {where + ': ' if where else ''}expected {expected}, got {got!r}")

    def listed(self, document, key):
        value = document.get(key) or []
        self.need(isinstance(value, list), key, 'a list', value)
        return value

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

    def entries(self, document, key, read):
        """Reads a list of entries; an entry with `count` stands for several bodies."""
        bodies = []
        for i, entry in enumerate(self.listed(document, key)):
            where = f'{key}[{i}]'
            self.need(isinstance(entry, dict), where, 'a map', entry)
            for needed in ('position', 'radius'):
                self.need(needed in entry, where, f'a {needed}', entry)
            count = entry.get('count', 1)
            self.need(isinstance(count, int) and count >= 0, f'{where}.count', 'a whole number', count)
            bodies += [read(entry, where)] * count
        return bodies

    def radius(self, entry, where):
        radius = self.number(entry['radius'], f'{where}.radius')
        self.need(radius > 0, f'{where}.radius', 'a number above 0', radius)
        return radius

    def agent(self, entry, where):
        goal = entry.get('goals', entry.get('goal'))
        if 'route' in entry:
            goal = {}
        self.need(goal is not None, where, 'a goal', entry)
        mirror = goal.get('opposite') if isinstance(goal, dict) else None
        return {
            'radius': self.radius(entry, where),
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
        self.need(isinstance(entry, dict), where, 'a map', entry)
        for needed in ('position', 'footprint' if 'footprint' in entry else 'radius'):
            self.need(needed in entry, where, f'a {needed}', entry)
        heading = entry.get('heading', 0)
        radians = heading.get('radians') if isinstance(heading, dict) else None  # as `evaluate --scenes` writes it
        corners = self.points(entry.get('footprint', {}), f'{where}.footprint')
        return {
            'position': self.point(entry['position'], f'{where}.position'),
            'heading': math.radians(self.number(heading, f'{where}.heading')) if radians is None else radians,
            'radius': max(math.hypot(*corner) for corner in corners) if corners else self.radius(entry, where),
        }

    def wall(self, wall, where):
        self.need(isinstance(wall, list) and len(wall) == 2, where, '[[x1, y1], [x2, y2]]', wall)
        ends = [self.point(end, where) for end in wall]
        self.need(None not in ends, where, '[[x1, y1], [x2, y2]]', wall)
        return ends


def read_scene(file, instance):
    """Reads the document of an instance; documents are repeated if there are fewer documents than instances."""
    loader = getattr(yaml, 'CSafeLoader', yaml.SafeLoader)
    try:
        with open(file, encoding='utf-8', errors='replace') as stream:
            documents = [document for document in yaml.load_all(stream, loader) if document is not None]
    except yaml.YAMLError as error:
        raise InputError(f"{file}: not YAML: {' '.join(str(error).split())}") from None
    if not documents:
        raise InputError(f'{file}: has no scenario')
    index = instance % len(documents)
    scene = Scene(documents[index], f'{file}: document {index + 1}')
    if 'map' in documents[index]:
        name = documents[index]['map']
        scene.need(isinstance(name, str) and name, 'map', 'the file of a map', name)
        scene.map = read_map(pathlib.Path(file).parent / name)
    return scene
