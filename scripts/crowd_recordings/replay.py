"""The node `replay`: plays a recording back as a crowd, with the messages that crowd_controller publishes."""
import math
import os
import pathlib
import sys
import threading
import time

import numpy
import rospy
from crowd_drawing.errors import InputError
from crowd_drawing.files import OCCUPIED_COLOUR, UNKNOWN_COLOUR, place_of
from crowd_launching.program import end_launch
from crowd_recordings.formats import read_shown, recorded_people
from geometry_msgs.msg import Point, Pose, Pose2D, Quaternion, Vector3
from nav_msgs.msg import MapMetaData, OccupancyGrid
from social_crowd.msg import AgentState, AgentStates, ObstacleState, Scenario, Wall
from std_msgs.msg import Header
from std_srvs.srv import SetBool, SetBoolResponse

FRAME = 'map'
LONGEST_TICK = 0.1  # [s] between two messages; recordings with fewer frames are interpolated
OCCUPIED, FREE, UNKNOWN = 100, 0, -1
DEFAULTS = {'trajectories': '', 'scenario': '', 'instance': 0, 'frame_rate': 0.0, 'rate': 1.0, 'loop': False,
            'paused': False, 'delay': 0.2, 'stay': False}
QUEUE = 100  # messages
PATIENCE = 0.1  # [s] between two looks while it is paused


class Messages:
    """Makes the messages of a recording. People are numbered from 0 in the order in which they appear; the list in a
    message contains those who have appeared so far. `names`: their numbers in the file, by these numbers."""

    def __init__(self, name, scene, tracks, frame_duration):
        self.name, self.scene, self.recorded = name, scene, recorded_people(scene)
        self.names = sorted(tracks, key=lambda person: (tracks[person].times[0], person))
        self.tracks = [tracks[person] for person in self.names]
        self.tick_duration = frame_duration / math.ceil(frame_duration / LONGEST_TICK - 1e-9)
        self.first = self.tracks[0].times[0]
        last = max(track.times[-1] for track in self.tracks)
        self.last_tick = round((last - self.first) / self.tick_duration)

    def scenario(self, episode, stamp):
        """Returns the Scenario of an episode, with all people at their first places, so that a view has all."""
        people = [self.agent(number, track, track.times[0], False) for number, track in enumerate(self.tracks)]
        return Scenario(header=Header(stamp=stamp, frame_id=FRAME), episode=episode, name=self.scene.name or self.name,
                        instance=episode, tick_duration=self.tick_duration, max_ticks=self.last_tick,
                        agents=people, obstacles=self.obstacles(0),
                        walls=[Wall(*(Point(x, y, 0) for x, y in ends)) for ends in self.scene.walls])

    def states(self, episode, tick, stamp):
        return AgentStates(header=Header(stamp=stamp, frame_id=FRAME), episode=episode, tick=tick,
                           time=tick * self.tick_duration, agents=self.agents(tick), obstacles=self.obstacles(tick))

    def time_of(self, tick):
        """Returns the time of a tick in the recording [s], whose first tick may be later than 0."""
        return self.first + tick * self.tick_duration

    def agents(self, tick):
        """Returns the states of all people who have appeared by a tick."""
        time = self.time_of(tick)
        soon = 0.5 * self.tick_duration  # times are multiples of the tick up to rounding
        return [self.agent(number, track, time, time > track.times[-1] + soon)
                for number, track in enumerate(self.tracks) if track.times[0] <= time + soon]

    def agent(self, number, track, time, has_left):
        (x, y), before = track.place_at(time), track.place_at(time - self.tick_duration)
        goal = track.places[-1]
        state = AgentState(agent=number, pose=Pose2D(x, y, track.heading_at(time)), goal=Point(goal[0], goal[1], 0),
                           radius=self.scene.radius_of(self.names[number]),
                           status=AgentState.ARRIVED if has_left else AgentState.WALKING)
        state.velocity = Vector3((x - before[0]) / self.tick_duration, (y - before[1]) / self.tick_duration, 0)
        return state

    def obstacles(self, tick):
        time = self.time_of(tick)
        known = [obstacle for obstacle in self.scene.obstacles if obstacle['position'] is not None]
        states = [ObstacleState(obstacle=number, radius=obstacle['radius'],
                                position=Point(*place_of(obstacle, time), 0)) for number, obstacle in enumerate(known)]
        for number, (person, track, radius) in enumerate(self.recorded, len(known)):
            if track.is_present(time):
                (x, y), before = track.place_at(time), track.place_at(time - self.tick_duration)
                velocity = Vector3((x - before[0]) / self.tick_duration, (y - before[1]) / self.tick_duration, 0)
                states.append(ObstacleState(obstacle=number, recorded=1, person=person, position=Point(x, y, 0),
                                            velocity=velocity, radius=radius))
        return states


def grid_of(floor, stamp):
    """Returns the map of a scene, a MapPicture, as an OccupancyGrid; its first row is the lowest."""
    rows = floor.pixels[::-1]
    cells = numpy.full(rows.shape[:2], FREE, dtype=numpy.int8)
    cells[(rows == OCCUPIED_COLOUR).all(axis=2)] = OCCUPIED
    cells[(rows == UNKNOWN_COLOUR).all(axis=2)] = UNKNOWN
    x, y, yaw = floor.origin
    origin = Pose(Point(x, y, 0), Quaternion(0, 0, math.sin(yaw / 2), math.cos(yaw / 2)))
    return OccupancyGrid(Header(stamp=stamp, frame_id=FRAME),
                         MapMetaData(stamp, floor.resolution, cells.shape[1], cells.shape[0], origin),
                         cells.ravel().tolist())


class Replay:
    """Publishes the messages of a recording at their times. The service is called in threads of rospy."""

    def __init__(self, messages, rate, is_paused):
        self.messages, self.rate = messages, rate
        self.runs, self.closed = threading.Event(), threading.Event()
        if not is_paused:
            self.runs.set()
        # By another thread: a signal handler runs in the main thread, which may hold the lock of the event in wait().
        rospy.on_shutdown(lambda: threading.Thread(target=self.closed.set, daemon=True).start())
        self.scenario = rospy.Publisher('scenario', Scenario, queue_size=QUEUE, latch=True)
        self.agents = rospy.Publisher('agents', AgentStates, queue_size=QUEUE)
        self.map = rospy.Publisher('map', OccupancyGrid, queue_size=1, latch=True)
        self.service = rospy.Service('~pause', SetBool, self.pause)

    def pause(self, request):
        """Stops before the next tick, or continues."""
        (self.runs.clear if request.data else self.runs.set)()
        return SetBoolResponse(True, 'paused' if request.data else 'continues')

    def begin(self, episode):
        if episode == 0 and self.messages.scene.map is not None:
            self.map.publish(grid_of(self.messages.scene.map, rospy.Time.now()))
        self.scenario.publish(self.messages.scenario(episode, rospy.Time.now()))

    def play(self, episode):
        """Publishes all ticks. Returns whether the end was reached."""
        period, due = self.messages.tick_duration / self.rate, time.monotonic()
        for tick in range(self.messages.last_tick + 1):
            if not self.runs.is_set():
                while not self.runs.wait(PATIENCE) and not self.closed.is_set():
                    pass
                due = time.monotonic()
            if self.closed.wait(max(0.0, due - time.monotonic())):
                return False
            self.agents.publish(self.messages.states(episode, tick, rospy.Time.now()))
            due = max(due + period, time.monotonic() - period)  # what is late is not made up for
        return True


def is_number(value):
    """Returns whether a value is a finite number from 0."""
    return isinstance(value, (int, float)) and not isinstance(value, bool) and 0 <= value < math.inf


# By the type of the default: whether a value fits, and what is expected.
KINDS = {bool: (lambda value: isinstance(value, bool), 'true or false'),
         str: (lambda value: isinstance(value, str), 'a text'),
         int: (lambda value: is_number(value) and value == int(value), 'a whole number from 0'),
         float: (is_number, 'a number from 0')}


def read_parameters():
    """Returns the parameters, with defaults. Raises InputError with all that are invalid."""
    given = rospy.get_param('~', {})
    problems = [f"~{name}: there is no such parameter; there are {', '.join(DEFAULTS)}"
                for name in given if name not in DEFAULTS]
    read = dict(DEFAULTS, **{name: value for name, value in given.items() if name in DEFAULTS})
    for name, default in DEFAULTS.items():
        fits, expected = KINDS[type(default)]
        if not fits(read[name]):
            problems.append(f"~{name}: expected {expected}, got '{read[name]}'")
    if not problems and not read['rate'] > 0:
        problems.append(f"~rate: expected a number above 0, got '{read['rate']}'")
    if not problems and not read['trajectories']:
        problems.append('~trajectories: expected a file')
    if problems:
        raise InputError('; '.join(problems))
    return read


def main():
    """Plays the recording until its end, or until the node is shut down. Returns the exit status."""
    try:
        rospy.init_node('replay')
        parameters = read_parameters()
        file = parameters['trajectories']
        if not os.path.isfile(file):
            raise InputError(f'there is no file {os.path.abspath(file)}' +
                             ('' if os.path.isabs(file) else '; give an absolute path'))
        shown = read_shown(file, parameters['scenario'] or None, int(parameters['instance']),
                           parameters['frame_rate'] or None)
        replay = Replay(Messages(pathlib.Path(file).stem, *shown), parameters['rate'], parameters['paused'])
    except (InputError, OSError) as error:
        print(f'replay: {error}', file=sys.stderr)
        return 1
    except rospy.ROSInitException:  # interrupted during initialisation
        return 0
    episode, goes_on = 0, True
    while goes_on:
        replay.begin(episode)
        if replay.closed.wait(parameters['delay']) or not replay.play(episode):
            return 0
        episode, goes_on = episode + 1, parameters['loop']
    if parameters['stay']:
        replay.closed.wait()
    else:
        replay.closed.wait(PATIENCE)  # for the last message to be sent
        end_launch()
    return 0
