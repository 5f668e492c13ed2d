"""Converts a scene of pedsim_ros into a scenario file.

Obstacles become walls; waypoints, queues and sinks become routes; agents, sources and attractions are carried over.
What is not carried over, or is changed, is printed and written at the top of the scenario file, with its line in the
scene.
"""
import math
import pathlib
import sys

import yaml
from crowd_experiments.arguments import above_zero, parser_of
from crowd_import.pedsim_scene import ELDER, PedsimScene, Queue, ROBOT, SINK, SOURCE

SPEED = [0.89, 1.79]  # [m/s] mean and standard deviation of pedsim_ros's normal distribution: 1.34 and 0.26
ELDER_SPEED = 0.9  # [m/s]
ROBOT_SPEED, ROBOT_RADIUS = 1.6, 0.4  # [m/s], [m] of pedsim_ros's SOCIAL_DRIVE
QUEUE_SPACING = 0.5  # [m] mean distance of people in line; pedsim_ros draws 0.2 to 0.8
SERVICE = [0.2, 1.8]  # [s] with the mean of pedsim_ros's gamma distribution, 1
ATTRACTION_RADIUS = 7.0  # [m]; the rate falls from that within the area to 0 there
ATTRACTION_RATE = 0.02  # [1/s] for a strength of 1, within the area
MEAN_SPEED = 1.34  # [m/s]
STAY = [0, 66.7]  # [s] with the mean of pedsim_ros's exponential distribution, 1 / 0.03
GAP = 0.05  # [m] between bodies at the start
DENSEST = 0.4  # greatest share of an area that discs at random places may cover
REASONS = {'welcome': 'has no meaning in pedsim_ros'}
EXAMPLES = '''example:
  rosrun social_crowd pedsim_import hall.xml --output hall.yaml --duration 120'''


def number(value):
    """Returns a number with up to ten digits: a whole one if it is whole, 0 instead of -0."""
    value = float(format(value + 0.0, '.10g'))
    return int(value) if value.is_integer() else value


def text_of(value):
    return yaml.safe_dump(value, default_flow_style=True, sort_keys=False, allow_unicode=True, width=math.inf
                          ).removesuffix('...\n').strip()


def point(numbers):
    """Returns [x, y], or [low, high]."""
    return list(map(number, numbers))


def box(middle, sides):
    """Returns the place of a box from its middle and its sides [m]."""
    return {'box': [point(at + sign * side / 2 for at, side in zip(middle, sides)) for sign in (-1, 1)]}


def ring(disc):
    """Returns the place of a disc with `centre` and `radius` [m]."""
    if disc.radius == 0:
        return point(disc.centre)
    return {'ring': {'centre': point(disc.centre), 'radius': [0, number(disc.radius)]}}


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
    """The keys of a scenario, and notes (line, text) about elements that are changed or not converted."""

    def __init__(self, scene, radius, spawn_period):
        self.scene, self.radius, self.spawn_period = scene, number(radius), spawn_period  # [m], [s]
        self.notes = []
        self.routes, self.agents, self.obstacles, self.sources = {}, [], [], []
        stops = scene.stops.values()
        self.sinks = {stop.name: {'area': ring(stop)} for stop in stops if getattr(stop, 'behaviour', 0) == SINK}
        self.queues = {stop.name: {
            'head': point(stop.head), 'direction': number((stop.direction + 180.0) % 360.0),  # of the line
            'spacing': number(max(QUEUE_SPACING, 2 * radius + GAP)), 'service': SERVICE}
            for stop in stops if isinstance(stop, Queue)}
        self.attractions = {}
        for attraction in scene.attractions.values():
            self.add_attraction(attraction)
        self.walls = []
        for element in scene.walls:
            ends = [point((element.number(f'x{end}'), element.number(f'y{end}'))) for end in (1, 2)]
            if ends[0] != ends[1]:
                self.walls.append(ends)
            else:
                self.note(element, 'not carried over: it has no length')
        for element in scene.others:
            self.note(element, 'not carried over: ' + REASONS.get(element.tag, 'unknown, or not at this place'))
        for element in scene.unknown:
            self.note(element, 'not carried over: the scene does not define it')
        for cluster in scene.agents:
            self.add_agents(cluster)
        for cluster in scene.sources:
            self.add_source(cluster)
        for stop in stops:
            if getattr(stop, 'behaviour', 0) == SOURCE:
                self.note(stop.element, 'b=1 (source) not carried over: it has no effect in pedsim_ros, either')
        self.notes = sorted(set(self.notes))

    def note(self, element, text):
        identity = element.attributes.get('id')
        self.notes.append((element.line, f"{element.tag}{f' {text_of(identity)}' if identity else ''}: {text}"))

    def add_attraction(self, attraction):
        """Its share is the probability that somebody who walks straight to it and away is attracted."""
        if attraction.strength == 0:
            self.note(attraction.element, 'not carried over: its strength is 0')
            return
        time = ATTRACTION_RADIUS / MEAN_SPEED  # twice the way between radius and area, at half the rate
        share = 1.0 - math.exp(-ATTRACTION_RATE * attraction.strength * time)
        self.attractions[attraction.name] = {
            'area': box(attraction.middle, attraction.sides), 'radius': number(ATTRACTION_RADIUS),
            'share': number(round(share, 3)), 'wait': STAY}
        self.note(attraction.element, 'people stop there once, and only if they see it')

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
            before, after = (' x '.join(str(number(side)) for side in lengths) for lengths in (cluster.sides, sides))
            self.note(cluster.element, f'{round(count)} bodies do not fit into {before} m; enlarged to {after} m')
        return box(cluster.middle, sides) if cluster.count > 1 or max(sides) > 0 else point(cluster.middle)

    def add_agents(self, cluster):
        if cluster.count == 0:
            self.note(cluster.element, 'not carried over: n is 0')
            return
        speed, radius = ELDER_SPEED if cluster.type == ELDER else SPEED, self.radius
        if cluster.type == ROBOT:
            self.note(cluster.element, "a robot is a person here, with the size and speed of pedsim_ros's SOCIAL_DRIVE")
            speed, radius = ROBOT_SPEED, ROBOT_RADIUS
        body = {'count': cluster.count} if cluster.count > 1 else {}
        body['position'] = self.area_of(cluster, radius)
        if cluster.stops:
            self.agents.append({**body, 'route': self.route_of(cluster), 'speed': speed, 'radius': radius})
        else:
            self.note(cluster.element, 'without waypoints it stands still: carried over as an obstacle')
            self.obstacles.append({**body, 'radius': radius})

    def add_source(self, cluster):
        if cluster.count == 0 or not cluster.stops:
            reason = 'n is 0' if cluster.count == 0 else 'it has no waypoints'
            self.note(cluster.element, f'not carried over: {reason}')
            return
        self.add_agents(cluster)  # pedsim_ros creates them at the start, too
        period = number(self.spawn_period)
        self.sources.append({
            'area': box(cluster.middle, cluster.sides), 'rate': number(cluster.count / self.spawn_period),
            'interval': 'regular', 'from': period, 'route': self.route_of(cluster), 'speed': SPEED,
            'radius': self.radius})
        self.note(cluster.element, f'people come one by one, not {cluster.count} at once each {period} s')

    def route_of(self, cluster):
        """Returns the name of the route of a cluster. The route ends at its first sink, or else repeats."""
        sinks = [i for i, stop in enumerate(cluster.stops) if stop.name in self.sinks]
        stops = cluster.stops[:sinks[0] + 1] if sinks else cluster.stops
        if len(stops) < len(cluster.stops):
            self.note(cluster.element, f"the waypoints after the sink '{stops[-1].name}' are not carried over")
        route = {'repeat': not sinks, 'waypoints': [
            {'sink': stop.name} if stop.name in self.sinks else
            {'queue': stop.name} if isinstance(stop, Queue) else {'place': ring(stop)} for stop in stops]}
        for name, known in self.routes.items():
            if known == route:
                return name
        name = f'route_{len(self.routes) + 1}'
        self.routes[name] = route
        return name


def scenario_of(conversion, source, name, duration):
    lines = [f'# Converted from {source}, a scene of pedsim_ros.']
    if conversion.notes:
        lines += ['# Not carried over, or changed:', *(f'#   line {line}: {note}' for line, note in conversion.notes)]
    lines += [f'name: {text_of(name)}', f'duration: {number(duration)}', 'goal_tolerance: 0.3']
    for key in ('agents', 'obstacles', 'sources', 'sinks', 'queues', 'routes', 'attractions', 'walls'):
        entries = getattr(conversion, key)
        named = isinstance(entries, dict)
        lines += [f'{key}:'] if entries else []
        for entry in entries:
            if key == 'routes':
                lines += [f'  {entry}:', f"    repeat: {text_of(entries[entry]['repeat'])}", '    waypoints:',
                          *(f'      - {text_of(stop)}' for stop in entries[entry]['waypoints'])]
            else:
                lines.append(f'  {text_of(entry)}: {text_of(entries[entry])}' if named else f'  - {text_of(entry)}')
    return '\n'.join([*lines, ''])


def main(words=None):
    parser = parser_of('pedsim_import', __doc__, EXAMPLES)
    parser.add_argument('scene', metavar='FILE.xml', help='scene of pedsim_ros')
    parser.add_argument('--output', required=True, metavar='SCENARIO.yaml', help='scenario file to write')
    parser.add_argument('--duration', type=above_zero, default=300.0, metavar='S',
                        help='duration of the scenario [s], default 300')
    parser.add_argument('--radius', type=above_zero, default=0.2, metavar='M', help='radius of people [m], default 0.2')
    parser.add_argument('--spawn-period', type=above_zero, default=5.0, metavar='S',
                        help="pedsim_ros's parameter: time between two groups of a source [s], default 5")
    parser.add_argument('--skip-unknown', action='store_true',
                        help='leave out waypoints of routes that the scene does not define, instead of an error')
    arguments = parser.parse_args(words)
    scene = PedsimScene(arguments.scene, arguments.skip_unknown)
    conversion = Conversion(scene, arguments.radius, arguments.spawn_period)
    output = pathlib.Path(arguments.output)
    source = pathlib.Path(arguments.scene).name
    output.write_text(scenario_of(conversion, source, output.stem, arguments.duration), encoding='utf-8')
    for line, note in conversion.notes:
        print(f'{arguments.scene}:{line}: {note}', file=sys.stderr)
