"""What all back ends of the page have in common: its clients, and when they get what."""
import base64
import math
import struct

import numpy
from crowd_drawing.errors import InputError
from crowd_web.client import as_json
from crowd_web.page_commands import COMMANDS
from crowd_web.recordings import Recordings
from crowd_web.throttle import Throttle

PROTOCOL = 1
MAGIC = 0x57524331
FRAME_PERIOD, STATUS_PERIOD, AGENTS_PERIOD = 1 / 30, 0.1, 0.25  # [s]
STREAMS = ('frame', 'robots', 'obstacles', 'mind')  # of which a slow client gets the latest
IN_CONTACT = 16  # added to a state
MARGIN = 1.0  # [m] of the bounds about what is there
PLACES = 4  # of metres in text


def frame_of(tick, time, ids, x, y, heading, speed, state):
    """Returns a binary frame. state: 0 to 3, and IN_CONTACT"""
    head = struct.pack('<IIdII', MAGIC, tick % 2**32, time, len(ids), 0)
    columns = [(ids, '<u4'), (x, '<f4'), (y, '<f4'), (heading, '<f4'), (speed, '<f4'), (state, 'u1')]
    return head + b''.join(numpy.ascontiguousarray(column, dtype).tobytes() for column, dtype in columns)


def bounds_of(points):
    """Returns x0, y0, x1, y1 of a box about points, some of them arrays [m]."""
    rows = [numpy.reshape(numpy.asarray(some, float), (-1, 2)) for some in points]
    rows = numpy.concatenate(rows) if rows else numpy.zeros((0, 2))
    if not len(rows):
        rows = numpy.zeros((1, 2))
    return [*(rows.min(axis=0) - MARGIN).round(2).tolist(), *(rows.max(axis=0) + MARGIN).round(2).tolist()]


def map_of(width, height, resolution, origin, cells):
    """Returns the map of a scene. origin: x, y [m], yaw [rad]; cells: 0 free, 100 occupied, 255 unknown"""
    return {'width': width, 'height': height, 'resolution': resolution, 'origin': list(origin),
            'cells': base64.b64encode(numpy.asarray(cells).astype('u1').tobytes()).decode()}


def corners_of(grid):
    """Returns the corners of a map_of() [m]."""
    x0, y0, yaw = grid['origin']
    sides = numpy.array([(i * grid['width'], j * grid['height']) for i in (0, 1) for j in (0, 1)]) * grid['resolution']
    cosine, sine = numpy.cos(yaw), numpy.sin(yaw)
    return sides @ numpy.array([[cosine, sine], [-sine, cosine]]) + (x0, y0)


def obstacles_of(rows):
    """Returns obstacles as a scene has them. rows: number, x, y, radius of each [m]"""
    return [{'id': int(row[0]), 'position': row[1:3], 'radius': row[3]} for row in numpy.round(rows, PLACES).tolist()]


def walls_of(ids, rows):
    """Returns walls as a scene has them. rows: x, y of both ends of each [m]"""
    return [{'id': wall, 'from': row[:2], 'to': row[2:]} for wall, row in zip(ids, numpy.round(rows, PLACES).tolist())]


def scan_of(first_angle, increment, ranges):
    """Returns the scan of a robot. ranges: infinite or NaN where nothing was seen [m]"""
    return {'angle_min': first_angle, 'angle_increment': increment,
            'ranges': [round(distance, 3) if math.isfinite(distance) else None for distance in ranges]}


class KnownAgents:
    """The agents that pages know: ids ascending, radii, goals [m]."""

    def __init__(self, ids=(), radii=(), goals=()):
        self.ids, self.radii = numpy.array(ids, 'i8'), numpy.array(radii, float)
        self.goals = numpy.array(goals, float).reshape(-1, 2)

    def new_among(self, others):
        """Returns which of others are not known, or otherwise: an array of bool."""
        if not len(self.ids):
            return numpy.ones(len(others.ids), bool)
        at = numpy.searchsorted(self.ids, others.ids).clip(max=len(self.ids) - 1)
        return ~((self.ids[at] == others.ids) & (self.radii[at] == others.radii) &
                 (self.goals[at] == others.goals).all(axis=1))

    def as_list(self, which=slice(None)):
        """Returns agents as a scene has them."""
        return [{'id': agent, 'radius': radius, 'goal': goal} for agent, radius, goal in zip(
            self.ids[which].tolist(), self.radii[which].round(PLACES).tolist(),
            self.goals[which].round(PLACES).tolist())]


class PageSource:
    """Gives the same messages to all pages. A back end derives from it, and has a function for each of its commands."""
    BACK_END = None

    def __init__(self, recordings=None):
        self.clients = {}  # the agent that each has selected, or None
        self.recordings = Recordings(recordings)
        self.scene = None  # the latest one, with the present agents and obstacles
        self.status = self.latest_frame = None  # as they were sent
        self.known = KnownAgents()
        self.frames = Throttle(FRAME_PERIOD, self.send_frame)
        self.statuses = Throttle(STATUS_PERIOD, self.send_status)
        self.agents = Throttle(AGENTS_PERIOD, self.send_agents)
        self.robots = Throttle(FRAME_PERIOD, self.send_robots)
        self.obstacles = Throttle(FRAME_PERIOD, self.send_obstacles)
        self.minds = Throttle(FRAME_PERIOD, self.send_minds)
        self.throttles = (self.frames, self.agents, self.robots, self.obstacles, self.minds)

    async def hello(self):
        """Returns the first message to a page."""
        return {'type': 'hello', 'protocol': PROTOCOL, 'back_end': self.BACK_END,
                'scenarios': await self.scenario_names(),
                'commands': [name for name in COMMANDS if hasattr(self, 'do_' + name)]}

    def add(self, client):
        """Begins to send to a client."""
        self.clients[client] = None
        if self.scene:
            client.send(dict(self.scene, agents=self.known.as_list()))
            if self.latest_frame:
                client.send_latest('frame', self.latest_frame)
        if self.status:
            client.send_data(self.status)

    def remove(self, client):
        """Ends it."""
        self.clients.pop(client, None)

    def selected(self):
        """Returns the agents that pages have selected."""
        return {agent for agent in self.clients.values() if agent is not None}

    async def run(self, client, command, values):
        """Carries out a command. Raises InputError if it is refused."""
        act = getattr(self, 'do_' + command, None)
        if act is None:
            raise InputError(f'this source ({self.BACK_END}) does not have it')
        await act(client, **values)

    def broadcast(self, message):
        """Sends a message to all pages. Returns it as text."""
        text = as_json(message)
        for client in self.clients:
            client.send_data(text)
        return text

    def send_latest(self, stream, message):
        text = as_json(message)
        for client in self.clients:
            client.send_latest(stream, text)

    def send_scene(self, scene, known):
        """Sends a scene, without its agents, and these; what waits of the one before is dropped."""
        for throttle in self.throttles:
            throttle.cancel()
        for client in self.clients:
            for stream in STREAMS:
                client.forget(stream)
        self.latest_frame, self.known = None, known
        self.scene = dict(scene, type='scene')
        self.broadcast(dict(self.scene, agents=known.as_list()))

    def send_agents(self, agents):
        """Sends the agents that pages do not know."""
        is_new = self.known.new_among(agents)
        self.known = agents
        if is_new.any():
            self.broadcast({'type': 'agents', 'agents': agents.as_list(is_new)})

    def send_robots(self, tick, robots):
        self.send_latest('robots', {'type': 'robots', 'tick': tick, 'robots': robots})

    def send_obstacles(self, tick, rows):
        self.scene['obstacles'] = obstacles_of(rows)
        self.send_latest('obstacles', {'type': 'obstacles', 'tick': tick, 'obstacles': self.scene['obstacles']})

    def send_frame(self, make, *arguments):
        """Sends the frame that a function returns; None: there is none."""
        frame = make(*arguments)
        if frame is not None:
            self.latest_frame = frame
            for client in self.clients:
                client.send_latest('frame', frame)

    def send_status(self, status):
        text = as_json(dict(status, type='status'))
        if text != self.status:
            self.status = text
            for client in self.clients:
                client.send_data(text)

    def send_minds(self, minds):
        """Sends what agents choose from to the pages that have selected them."""
        for mind in minds:
            text = as_json(dict(mind, type='mind'))
            for client, agent in self.clients.items():
                if agent == mind['agent']:
                    client.send_latest('mind', text)

    async def do_select(self, client, agent):
        self.clients[client] = agent
        await self.selection_changed(agent)

    async def do_recordings(self, client):
        client.send({'type': 'recordings', 'names': self.recordings.names()})

    async def do_open_recording(self, client, name):
        client.send(dict(await self.recordings.read(name), type='recording', name=name))
