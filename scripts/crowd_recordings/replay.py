"""The node `replay`: plays a recording back as a crowd."""
import math
import os
import pathlib
import sys
import threading
import time

import rospy
from crowd_drawing.errors import InputError
from crowd_launching.launch_end import end_launch
from crowd_recordings.messages import Messages, grid_of
from crowd_recordings.shown import read_shown
from nav_msgs.msg import OccupancyGrid
from social_crowd.msg import AgentStates, Scenario
from std_srvs.srv import SetBool, SetBoolResponse

DEFAULTS = {'trajectories': '', 'scenario': '', 'instance': 0, 'frame_rate': 0.0, 'rate': 1.0, 'loop': False,
            'paused': False, 'delay': 0.2, 'stay': False}
QUEUE = 100  # messages
PATIENCE = 0.1  # [s] between two looks while it is paused


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
        """Publishes the state at the start."""
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


def messages_of(parameters):
    """Returns the Messages of the recording that the parameters name."""
    file = parameters['trajectories']
    if not os.path.isfile(file):
        raise InputError(f'there is no file {os.path.abspath(file)}' +
                         ('' if os.path.isabs(file) else '; give an absolute path'))
    shown = read_shown(file, parameters['scenario'] or None, int(parameters['instance']),
                       parameters['frame_rate'] or None)
    return Messages(pathlib.Path(file).stem, *shown)


def main():
    """Plays the recording until its end, or until the node is shut down. Returns the exit status."""
    try:
        rospy.init_node('replay')
        parameters = read_parameters()
        replay = Replay(messages_of(parameters), parameters['rate'], parameters['paused'])
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
