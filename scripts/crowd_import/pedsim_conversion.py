"""Scenario files from scenes of pedsim_ros."""
import json
import math
import re

from crowd_import.pedsim_scene import ELDER, Queue, ROBOT, SINK, SOURCE

PLAIN_NAME = re.compile(r'[A-Za-z_][A-Za-z0-9_]*')
WORDS_OF_YAML = {'true', 'false', 'yes', 'no', 'on', 'off', 'null', 'y', 'n'}


def number_text(value):
    """Returns a number with up to ten digits, without trailing zeros."""
    return format(value + 0.0, '.10g')  # 0 instead of -0


def name_text(name):
    """Returns a name, in quotes where YAML needs them."""
    is_plain = PLAIN_NAME.fullmatch(name) and name.lower() not in WORDS_OF_YAML
    return name if is_plain else json.dumps(name, ensure_ascii=False)


def point(numbers):
    """Returns [x, y], or [low, high]."""
    return f"[{', '.join(map(number_text, numbers))}]"


def box(middle, sides):
    """Returns the place of a box from its middle and its sides [m]."""
    low, high = ([at + sign * side / 2 for at, side in zip(middle, sides)] for sign in (-1, 1))
    return f'{{box: [{point(low)}, {point(high)}]}}'


def region(middle, sides):
    """Returns the middle if the box has no extent, otherwise the place of the box."""
    return box(middle, sides) if max(sides) > 0 else point(middle)


def ring(disc):
    """Returns the place of a disc with `centre` and `radius` [m]."""
    if disc.radius == 0:
        return point(disc.centre)
    return f'{{ring: {{centre: {point(disc.centre)}, radius: [0, {number_text(disc.radius)}]}}}}'


def section(key, entries):
    """Returns a key with a list of entries, or with named entries, which begin with a space or a line break."""
    if not entries:
        return ''
    if isinstance(entries, dict):
        return f'{key}:\n' + ''.join(f'  {name_text(name)}:{entry}\n' for name, entry in entries.items())
    return f'{key}:\n' + ''.join(f'  - {entry}\n' for entry in entries)


SPEED = (0.89, 1.79)  # [m/s] mean and standard deviation of pedsim_ros's normal distribution: 1.34 and 0.26
ELDER_SPEED = 0.9  # [m/s]
ROBOT_SPEED, ROBOT_RADIUS = 1.6, 0.4  # [m/s], [m] of pedsim_ros's SOCIAL_DRIVE
QUEUE_SPACING = 0.5  # [m] mean distance of people in line; pedsim_ros draws 0.2 to 0.8
SERVICE = (0.2, 1.8)  # [s] with the mean of pedsim_ros's gamma distribution, 1
GAP = 0.05  # [m] between bodies at the start
DENSEST = 0.4  # greatest share of an area that discs at random places may cover
REASONS = {
    'attraction': 'people do not stop at attractions',
    'welcome': 'has no meaning in pedsim_ros',
}


def share_within(other, cluster):
    """Returns the share of the box of a cluster that is within the box of another one."""
    share = 1.0
    for axis in (0, 1):
        low, high = other.middle[axis] - other.sides[axis] / 2, other.middle[axis] + other.sides[axis] / 2
        least, most = (cluster.middle[axis] + sign * cluster.sides[axis] / 2 for sign in (-1, 1))
        common = min(high, most) - max(low, least)
        share *= (1.0 if common >= 0 else 0.0) if high == low else max(0.0, common) / (high - low)
    return share


class Conversion:
    """The keys of a scenario, as text, and notes about elements that are changed or not converted."""

    def __init__(self, scene, radius, spawn_period):
        self.scene = scene
        self.radius = radius
        self.spawn_period = spawn_period  # [s]
        self.notes = []  # (line, text)
        self.routes = {}  # text of a route -> its name
        self.sinks = {stop.name: ring(stop) for stop in scene.stops.values() if getattr(stop, 'behaviour', 0) == SINK}
        self.queues = {stop.name: self.queue_of(stop) for stop in scene.stops.values() if isinstance(stop, Queue)}
        self.walls = [wall for wall in map(self.wall_of, scene.walls) if wall]
        self.agents, self.obstacles, self.sources = [], [], []
        for element in scene.others:
            self.note(element, 'not carried over: ' + REASONS.get(element.tag, 'unknown, or not at this place'))
        for element in scene.unknown:
            self.note(element, 'not carried over: the scene does not define it')
        for cluster in scene.agents:
            self.add_agents(cluster)
        for cluster in scene.sources:
            self.add_source(cluster)
        self.note_behaviours(scene)
        self.notes = sorted(set(self.notes))

    def note(self, element, text):
        identity = element.attributes.get('id')
        self.notes.append((element.line, f"{element.tag}{f' {name_text(identity)}' if identity else ''}: {text}"))

    def note_behaviours(self, scene):
        for stop in scene.stops.values():
            if getattr(stop, 'behaviour', 0) == SOURCE:
                self.note(stop.element, 'b=1 (source) not carried over: it has no effect in pedsim_ros, either')

    def wall_of(self, element):
        ends = [(element.number(f'x{end}'), element.number(f'y{end}')) for end in (1, 2)]
        if ends[0] == ends[1]:
            self.note(element, 'not carried over: it has no length')
            return None
        return f'[{point(ends[0])}, {point(ends[1])}]'

    def queue_of(self, queue):
        direction = (queue.direction + 180.0) % 360.0  # of the line, from its head
        return f'{{head: {point(queue.head)}, direction: {number_text(direction)}, ' \
            f'spacing: {number_text(max(QUEUE_SPACING, 2 * self.radius + GAP))}, ' \
            f'service: {point(SERVICE)}}}'

    def body_of(self, cluster):
        """Returns the speed, as text, and the radius of the agents of a cluster."""
        if cluster.type == ROBOT:
            self.note(cluster.element, "a robot is a person here, with the size and speed of pedsim_ros's SOCIAL_DRIVE")
            return number_text(ROBOT_SPEED), ROBOT_RADIUS
        return (number_text(ELDER_SPEED) if cluster.type == ELDER else point(SPEED)), self.radius

    def area_of(self, cluster, radius):
        """Returns the region of a cluster at the start. It is enlarged where the bodies would overlap."""
        sides = cluster.sides
        count = sum(other.count * share_within(other, cluster) for other in self.scene.agents + self.scene.sources)
        needed = count * math.pi * (radius + GAP / 2) ** 2 / DENSEST
        if cluster.count > 1 and (sides[0] + 2 * radius) * (sides[1] + 2 * radius) < needed:
            ratio = math.sqrt(sides[0] / sides[1]) if min(sides) > 0 else 1.0
            root = math.sqrt(needed)
            sides = [max(side, math.ceil(10 * length) / 10) for side, length in
                     zip(sides, (root * ratio, root / ratio))]
            before, after = (' x '.join(map(number_text, lengths)) for lengths in (cluster.sides, sides))
            self.note(cluster.element,
                      f'{round(count)} bodies do not fit into {before} m; enlarged to {after} m')
        return region(cluster.middle, sides) if cluster.count == 1 else box(cluster.middle, sides)

    def add_agents(self, cluster):
        if cluster.count == 0:
            self.note(cluster.element, 'not carried over: n is 0')
            return
        speed, radius = self.body_of(cluster)
        count = f'count: {cluster.count}, ' if cluster.count > 1 else ''
        area = self.area_of(cluster, radius)
        if not cluster.stops:
            self.note(cluster.element, 'without waypoints it stands still: carried over as an obstacle')
            self.obstacles.append(f'{{{count}position: {area}, radius: {number_text(radius)}}}')
            return
        self.agents.append(f'{{{count}position: {area}, route: {self.route_of(cluster)}, speed: {speed}, '
                           f'radius: {number_text(radius)}}}')

    def add_source(self, cluster):
        if cluster.count == 0 or not cluster.stops:
            reason = 'n is 0' if cluster.count == 0 else 'it has no waypoints'
            self.note(cluster.element, f'not carried over: {reason}')
            return
        self.add_agents(cluster)  # pedsim_ros creates them at the start, too
        rate = cluster.count / self.spawn_period
        self.sources.append(
            f'{{area: {box(cluster.middle, cluster.sides)}, rate: {number_text(rate)}, interval: regular, '
            f'from: {number_text(self.spawn_period)}, route: {self.route_of(cluster)}, speed: {point(SPEED)}, '
            f'radius: {number_text(self.radius)}}}')
        self.note(cluster.element, f'people come one by one, not {cluster.count} at once each '
                  f'{number_text(self.spawn_period)} s')

    def route_of(self, cluster):
        """Returns the name of the route of a cluster. The route ends at its first sink, or else repeats."""
        sinks = [i for i, stop in enumerate(cluster.stops) if stop.name in self.sinks]
        stops = cluster.stops[:sinks[0] + 1] if sinks else cluster.stops
        if len(stops) < len(cluster.stops):
            self.note(cluster.element, f'the waypoints after the sink {name_text(stops[-1].name)} are not carried over')
        text = '\n'.join([f"    repeat: {'false' if sinks else 'true'}", '    waypoints:'] +
                         ['      - ' + self.stop_text(stop) for stop in stops])
        return self.routes.setdefault(text, f'route_{len(self.routes) + 1}')

    def stop_text(self, stop):
        if stop.name in self.sinks:
            return f'{{sink: {name_text(stop.name)}}}'
        return f'{{queue: {name_text(stop.name)}}}' if isinstance(stop, Queue) else f'{{place: {ring(stop)}}}'
