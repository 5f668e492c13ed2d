"""A ROS master, a crowd controller and learners, which can be ended and started at any time."""
import math
import os
import pathlib
import signal
import subprocess
import time

import rosgraph
import rospy
from crowd_drawing.errors import RunError
from crowd_experiments.tools import find_config
from crowd_launching.nodes import ending_of, find_program
from crowd_launching.program import end_all, free_port
from social_crowd.msg import ControllerStatus

AGENTS = 16
SHARES = 2  # learners, each with a share of the agents
STEADY_TICKS = 5  # without a miss, after a fault
FACTOR = 5.0  # of real time
PERIOD = 0.01  # [s] between two checks
LOG_END = 2000  # characters of a node's output in an error


class Violation(RunError):
    """A node has crashed or hangs, or the crowd does not go on as it should."""


def few_agents():
    """Returns a scenario in which agents walk to and fro through the centre of a circle all the time."""
    angles = [2 * math.pi * i / AGENTS for i in range(AGENTS)]
    places = [(round(6 * math.cos(angle), 3), round(6 * math.sin(angle), 3)) for angle in angles]
    return scenario([f'{{position: [{x}, {y}], route: way_{i}, speed: {1 + 0.03 * i:.2f}, radius: 0.25}}'
                     for i, (x, y) in enumerate(places)],
                    [f'way_{i}: {{repeat: true, waypoints: [{{place: [{-x}, {-y}]}}, {{place: [{x}, {y}]}}]}}'
                     for i, (x, y) in enumerate(places)])


def scenario(agents, routes):
    """Returns a scenario that does not end."""
    return '\n  '.join(['name: faults\nduration: 1000000\ngoal_tolerance: 0.3\nagents:',
                        *('- ' + agent for agent in agents)]) + '\n' + '\n  '.join(['routes:', *routes]) + '\n'


class Graph:
    """Context manager with a master on a free port; ends all nodes on exit. Its nodes are in their own sessions, so
    that Ctrl-C is sent to this program only."""

    def __init__(self, folder, deadline, text, agents=AGENTS, **parameters):
        """Text: a scenario with this number of agents. Parameters: of the controller."""
        self.folder, self.deadline, self.agents = pathlib.Path(folder), deadline, agents
        self.parameters = {'_scenario': self.folder / 'faults.yaml', '_real_time_factor': FACTOR, '_start_deadline': 5,
                           '_misses_until_absent': 3, **{'_' + name: value for name, value in parameters.items()}}
        self.port = free_port()
        os.environ.update(ROS_MASTER_URI=f'http://127.0.0.1:{self.port}', ROS_HOSTNAME='127.0.0.1',
                          ROS_HOME=str(self.folder), ROS_LOG_DIR=str(self.folder / 'log'))
        os.environ.pop('ROS_NAMESPACE', None)
        (self.folder / 'faults.yaml').write_text(text, encoding='utf-8')
        self.nodes = {}  # processes that are to live, by name
        self.logs = {}
        self.status = None
        self.subscriber = None
        self.other_table = None  # a Q-table of another state set
        self.broken = []  # what the messages of the controller should not say

    def __enter__(self):
        self.start_master()
        rospy.init_node('graph_faults', disable_signals=True, disable_rosout=True)
        self.listen()
        self.start_controller()
        return self

    def __exit__(self, *_):
        for process in self.nodes.values():
            process.send_signal(signal.SIGCONT)
        end_all(list(self.nodes.values()), 10.0)

    # Nodes

    def start(self, name, command):
        self.logs[name] = self.folder / f'{name}.log'
        with open(self.logs[name], 'ab') as stream:
            self.nodes[name] = subprocess.Popen(list(map(str, command)), stdin=subprocess.DEVNULL, stdout=stream,
                                                stderr=stream, start_new_session=True)
        return self.nodes[name]

    def start_master(self):
        self.start('master', ['/usr/bin/rosmaster', '--core', '-p', self.port])
        self.wait_for(rosgraph.is_master_online, 'the master')

    def start_controller(self):
        self.status = None
        self.start('controller', [find_program('crowd_controller'), *map(':='.join, texts(self.parameters))])

    def start_learner(self, name, *words, share=None, table=None):
        parameters = {'__name': name, '_q_table': table or find_config() / 'q_tables' / 'anticipation.txt'}
        if share is not None:
            parameters.update(_share=share, _shares=SHARES)
        return self.start(name, [find_program('learner'), *map(':='.join, texts(parameters)), *words])

    def start_learners(self):
        for share in range(SHARES):
            self.start_learner(f'learner_{share}', share=share)

    def end(self, name, number=signal.SIGINT):
        """Ends a node by a signal, and checks that it ends in time, without an error."""
        process = self.nodes.pop(name)
        process.send_signal(number)
        self.wait_end(name, process, number)

    def wait_end(self, name, process, number=signal.SIGINT):
        """Waits until a node ends that was asked to. Before it handles SIGINT, this signal ends it."""
        try:
            status = process.wait(self.deadline)
        except subprocess.TimeoutExpired:
            process.kill()
            raise Violation(f'{name} did not end within {self.deadline:g} s') from None
        if status not in (0, -number):
            raise Violation(f'{name} {ending_of(status)}:\n{self.output(name)}')

    def output(self, name):
        return self.logs[name].read_text(encoding='utf-8', errors='replace')[-LOG_END:]

    # Checks

    def listen(self):
        """Subscribes to the status of the controller, again after a new master, with which rospy does not register."""
        if self.subscriber:
            self.subscriber.unregister()
        self.subscriber = rospy.Subscriber('controller_status', ControllerStatus, self.take, tcp_nodelay=True)

    def take(self, status):
        """Checks that each agent has an answer or a counted miss in each tick, and that no agent is in contact."""
        if status.decisions + status.missed_answers != self.agents * status.tick:
            self.broken.append(f'{status.decisions} answers and {status.missed_answers} misses of {self.agents} agents '
                               f'in {status.tick} ticks')
        if status.touched:
            self.broken.append(f'{status.touched} agents are in contact in tick {status.tick}')
        self.status = status

    def check(self):
        """Raises Violation if a node that is to live has ended, or the messages of the controller are wrong."""
        for name, process in self.nodes.items():
            if process.poll() is not None:
                raise Violation(f'{name} {ending_of(process.returncode)}:\n{self.output(name)}')
        if self.broken:
            raise Violation(self.broken[0])

    def wait_for(self, condition, what):
        end = time.monotonic() + self.deadline
        while not condition():
            self.check()
            if time.monotonic() > end:
                logs = '\n'.join(f'{name}: ...{self.output(name)}' for name in self.nodes)
                raise Violation(f'{what} did not come within {self.deadline:g} s\n{logs}')
            time.sleep(PERIOD)

    def wait_until_steady(self):
        """Waits for a few ticks in which no answer is missed."""
        since = None

        def is_steady():
            nonlocal since
            now = self.status
            if now is None:
                return False
            if since is None or now.tick < since.tick or now.missed_answers != since.missed_answers:
                since = now
            return now.tick >= since.tick + STEADY_TICKS

        self.status = None
        self.wait_for(is_steady, 'ticks without misses')
        self.check()

    def is_registered(self):
        """Returns whether the controller and all learners are registered with the master."""
        nodes = {node for kind in rosgraph.Master('/graph_faults').getSystemState() for _, of in kind for node in of}
        return {'/crowd_controller', *('/' + name for name in self.nodes if name.startswith('learner'))} <= nodes

    def usage(self, name):
        """Returns the open file descriptors and the memory [MB] of a node."""
        process = pathlib.Path('/proc') / str(self.nodes[name].pid)
        pages = int((process / 'statm').read_text(encoding='ascii').split()[1])
        return len(os.listdir(process / 'fd')), pages * os.sysconf('SC_PAGE_SIZE') / 2**20

    def usages(self):
        """Returns the same for the nodes of this package, by name and process."""
        return {(name, process.pid): self.usage(name) for name, process in self.nodes.items() if name != 'master'}


def texts(parameters):
    return ((name, str(value)) for name, value in parameters.items())
