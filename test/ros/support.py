"""What the rostests share: nodes as processes of their own, waiting with a deadline, recordings."""
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import xml.etree.ElementTree as ElementTree

import rospkg
import rospy
import rostest
from roslib.packages import find_node
from social_crowd import srv
from social_crowd.msg import LearnerStatus
from std_srvs.srv import SetBool, Trigger

PATIENCE = 90.0  # [s] for what comes at once on an idle machine
PERIOD = 0.01  # [s] between two looks
PACKAGE = rospkg.RosPack().get_path('social_crowd')
TICK = 0.1  # [s] of a scenario that does not say otherwise
COLOUR = re.compile(r'\x1b\[[0-9;]*m')
SERVICES = {
    'pause': SetBool,
    'step': srv.Step,
    'reset': srv.Reset,
    'load_scenario': srv.LoadScenario,
    'spawn_agent': srv.SpawnAgent,
    'remove_agent': srv.RemoveAgent,
    'set_goal': srv.SetGoal,
    'spawn_obstacle': srv.SpawnObstacle,
    'remove_obstacle': srv.RemoveObstacle,
    'save_q_table': srv.SaveQTable,
    'load_q_table': srv.LoadQTable,
    'share_q_table': srv.ShareQTable,
    'take_q_table': srv.TakeQTable,
    'reset_traces': Trigger,
    'set_mode': srv.SetMode,
    'set_learning_parameters': srv.SetLearningParameters,
}

skips = {}  # reasons, by test


def in_package(*parts):
    """A path in the package."""
    return os.path.join(PACKAGE, *parts)


NEAREST_TABLE = in_package('config', 'q_tables', 'thesis_nearest.txt')
OCCUPANCY_TABLE = in_package('config', 'q_tables', 'thesis_occupancy.txt')
ANTICIPATION_TABLE = in_package('config', 'q_tables', 'anticipation.txt')
CIRCLE6 = in_package('config', 'scenarios', 'circle6.yaml')


def data(name):
    """A file in test/data."""
    return in_package('test', 'data', name)


def wait_for(condition, what, seconds=PATIENCE):
    """Polls until the condition gives something true, and returns that."""
    deadline = time.monotonic() + seconds
    while True:
        result = condition()
        if result:
            return result
        if time.monotonic() > deadline:
            raise AssertionError(f'waited {seconds:g} s in vain for {what}')
        time.sleep(PERIOD)


def read_text(file):
    """What a file holds."""
    with open(file, encoding='utf-8', errors='replace') as stream:
        return stream.read()


def read_bytes(file):
    """What a file holds, byte for byte; None if there is no such file."""
    if not os.path.exists(file):
        return None
    with open(file, 'rb') as stream:
        return stream.read()


class Task:
    """A call in a thread of its own, so that one that hangs can be told from one that takes its time."""

    def __init__(self, call):
        self.call = call
        self.value = None
        self.error = None
        self.thread = threading.Thread(target=self.run, daemon=True)
        self.thread.start()

    def run(self):
        """What the thread does."""
        try:
            self.value = self.call()
        except Exception as error:
            self.error = error

    def is_done(self):
        """Whether the call has returned."""
        return not self.thread.is_alive()

    def result(self, what='an answer', seconds=PATIENCE):
        """What the call returned, once it has."""
        wait_for(self.is_done, what, seconds)
        if self.error is not None:
            raise self.error
        return self.value


class Process:
    """A program that runs beside the test; its output goes to a file."""

    def __init__(self, name, command, log, environment=None):
        self.name = name
        self.log = log
        self.is_given_up = False  # killed on purpose: how it ends says nothing
        environment = dict(os.environ, ROSCONSOLE_STDOUT_LINE_BUFFERED='1', **(environment or {}))
        with open(log, 'wb') as stream:
            self.process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=stream, stderr=stream,
                                            env=environment)

    def output(self):
        """What it has printed so far, without colours."""
        return COLOUR.sub('', read_text(self.log))

    def is_running(self):
        """Whether it has not ended yet."""
        return self.process.poll() is None

    def wait(self, seconds=PATIENCE):
        """Waits for its end; the exit status."""
        wait_for(lambda: not self.is_running(), f'the end of {self.name}', seconds)
        return self.process.returncode

    def signal(self, number):
        """Sends it a signal."""
        self.process.send_signal(number)

    def stop(self):
        """Asks it to end, as Ctrl-C does; the exit status."""
        if self.is_running():
            self.signal(signal.SIGINT)
        return self.wait()

    def kill(self):
        """Ends it without a chance to say goodbye."""
        self.is_given_up = True
        self.process.kill()
        self.process.wait()

    def clean_up(self):
        """Ends it in any case; what was wrong with its end, if anything."""
        if self.is_given_up:
            self.process.kill()
            self.process.wait()
            return ''
        was_running = self.is_running()
        try:
            status = self.stop()
        except AssertionError:
            self.kill()
            return f'{self.name} did not end when asked to'
        return f'{self.name} ended with exit status {status} when asked to' if was_running and status != 0 else ''


class Listener:
    """Keeps all messages of a topic."""

    def __init__(self, topic, message_type):
        self.topic = topic
        self.messages = []
        self.subscriber = rospy.Subscriber(topic, message_type, self.messages.append, tcp_nodelay=True)

    def wait_connected(self):
        """Waits until somebody publishes."""
        wait_for(lambda: self.subscriber.get_num_connections() > 0, f'somebody who publishes {self.topic}')
        return self

    def wait(self, fits=lambda message: True, what='', seconds=PATIENCE):
        """Waits for a message that fits; the first one."""
        return wait_for(lambda: [message for message in list(self.messages) if fits(message)],
                        f'a message on {self.topic} {what}', seconds)[0]

    def wait_at(self, episode, tick):
        """Waits for the message of a tick."""
        return self.wait(lambda message: (message.episode, message.tick) == (episode, tick),
                         f'of episode {episode}, tick {tick}')


class CrowdTestCase(unittest.TestCase):
    """A test with a name space and a folder of its own, in which it starts nodes."""

    longMessage = True
    maxDiff = None
    count = 0

    def run(self, result=None):
        """Runs the test; if it fails, shows what its processes printed."""
        CrowdTestCase.count += 1
        self.namespace = f'/test_{CrowdTestCase.count}'
        self.folder = tempfile.mkdtemp(prefix='social_crowd_')
        self.processes = []
        self.listeners = []
        problems = len(result.failures) + len(result.errors)
        try:
            super().run(result)
            if len(result.failures) + len(result.errors) > problems:
                self.show_outputs()
        finally:
            shutil.rmtree(self.folder, ignore_errors=True)

    def setUp(self):
        self.addCleanup(self.clean_up)

    def clean_up(self):
        """Ends all processes and looks how they end."""
        for listener in self.listeners:
            listener.subscriber.unregister()
        problems = [process.clean_up() for process in reversed(self.processes)]
        self.assertEqual('\n'.join(problem for problem in problems if problem), '', 'processes that ended badly')

    def show_outputs(self):
        """Prints what the processes printed."""
        for process in self.processes:
            print(f'--- output of {process.name} ({self.id()})\n{process.output()}', file=sys.stderr)

    def skip(self, reason):
        """Ends the test as one that could not run."""
        skips[self.id()] = reason
        print(f'SKIPPED {self.id()}: {reason}', file=sys.stderr)
        self.skipTest(reason)

    # Files

    def path(self, name):
        """A path in the test's folder."""
        return os.path.join(self.folder, name)

    def write(self, name, text):
        """Writes a file in the test's folder; its path."""
        with open(self.path(name), 'w', encoding='utf-8') as stream:
            stream.write(text)
        return self.path(name)

    # Processes

    def start(self, name, command, environment=None):
        """Starts a program."""
        log = self.path(f'{len(self.processes)}_{name}.log')
        process = Process(name, command, log, dict({'ROS_NAMESPACE': self.namespace}, **(environment or {})))
        self.processes.append(process)
        return process

    def start_node(self, kind, name, parameters, arguments=()):
        """Starts a node of this package with private parameters."""
        full_name = f'{self.namespace}/{name}'
        if rospy.has_param(full_name):
            rospy.delete_param(full_name)
        for key, value in parameters.items():
            rospy.set_param(f'{full_name}/{key}', value)
        return self.start(name, find_node('social_crowd', kind)[:1] + [f'__name:={name}', *arguments])

    def start_controller(self, scenario, arguments=(), **parameters):
        """Starts a crowd controller that is in no hurry with its learners, only with its clock."""
        defaults = {'scenario': scenario, 'pace': 'fast', 'start_deadline': 120.0, 'answer_deadline': 60.0,
                    'agents_rate': 0}
        return self.start_node('crowd_controller', 'crowd_controller', dict(defaults, **parameters), arguments)

    def start_learner(self, name='learner', arguments=(), **parameters):
        """Starts a learner, in demo mode with a trained table unless told otherwise."""
        if not {'q_table', 'config'} & set(parameters):
            parameters['q_table'] = NEAREST_TABLE
        return self.start_node('learner', name, parameters, arguments)

    def tool(self, name, *arguments, within=()):
        """Runs a program of this package to its end, perhaps within another one; what it printed."""
        command = [*within, *find_node('social_crowd', name)[:1], *map(str, arguments)]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=PATIENCE, check=False)
        output = done.stdout.decode(errors='replace')
        self.assertEqual(done.returncode, 0, f'{name} failed:\n{output}')
        return output

    def headless(self, scenario, table=NEAREST_TABLE, **options):
        """The recording of a run without ROS, byte for byte."""
        folder = tempfile.mkdtemp(dir=self.folder)
        arguments = [part for name, value in options.items() for part in (f'--{name}', value)]
        self.tool('evaluate', '--q-table', table, '--trajectories', folder, *arguments, scenario)
        return read_bytes(os.path.join(folder, recording_of(scenario)))

    # ROS

    def listen(self, topic, message_type):
        """Listens to a topic of the test's name space, or to an absolute one."""
        listener = Listener(topic if topic.startswith('/') else f'{self.namespace}/{topic}', message_type)
        self.listeners.append(listener)
        return listener

    def call_later(self, service, **request):
        """Calls a service of a node, such as learner/set_mode, in a thread of its own."""
        name = f'{self.namespace}/{service}'
        rospy.wait_for_service(name, PATIENCE)
        return Task(lambda: rospy.ServiceProxy(name, SERVICES[service.split('/')[-1]])(**request))

    def call(self, service, seconds=PATIENCE, **request):
        """Calls a service of a node, such as learner/set_mode."""
        return self.call_later(service, **request).result(f'an answer of {service}', seconds)

    def succeed(self, service, **request):
        """Calls a service that is to succeed."""
        response = self.call(service, **request)
        self.assertTrue(response.success, f'{service}: {response.message}')
        return response

    def refuse(self, service, *words, **request):
        """Calls a service that is to refuse, with a message that holds these words."""
        response = self.call(service, **request)
        self.assertFalse(response.success, f'{service} should have refused {request}')
        self.assert_says(response.message, *words)
        return response

    def step(self, ticks=1):
        """Walks so many ticks."""
        return self.succeed('crowd_controller/step', ticks=ticks)

    def wait_until_learned(self, learner, decisions):
        """Waits until a learner has learned from so many decisions."""
        status = self.listen('learner_status', LearnerStatus)

        def has_all():
            self.succeed(f'{learner}/set_learning_parameters', parameters='{}')  # changes nothing, publishes a status
            name = f'{self.namespace}/{learner}'
            return any(message.node == name and message.decisions >= decisions for message in status.messages)

        wait_for(has_all, f'{decisions} decisions learned from')

    # Assertions

    def assert_says(self, text, *words):
        """Checks that a text holds all these words."""
        missing = [word for word in words if word not in text]
        self.assertEqual(missing, [], f'these are missing in: {text}')

    def assert_same_recording(self, got, expected):
        """Compares recordings byte for byte; the first line that differs is told."""
        self.assertIsNotNone(got, 'there is no recording')
        if got == expected:
            return
        lines = [recording.decode().splitlines() + ['(the end)'] for recording in (got, expected)]
        first = next(i for i, pair in enumerate(zip(*lines)) if pair[0] != pair[1])
        self.fail(f'the recordings differ from line {first + 1}: got {lines[0][first]}, expected {lines[1][first]}')


def recording_of(scenario):
    """Name of a scenario file's recording."""
    return os.path.splitext(os.path.basename(scenario))[0] + '.csv'


def read_recording(file):
    """Positions by (instance, tick, agent)."""
    rows = [line.split(',') for line in read_text(file).splitlines()[1:]]
    return {(int(i), int(k), int(a)): (float(x), float(y)) for i, k, a, x, y in rows}


def note_skips():
    """Marks skipped tests in the results, which rosunit takes for passed ones."""
    files = [word.partition(':xml:')[2] for word in sys.argv if word.startswith('--gtest_output=xml:')]
    if not skips or not files or not os.path.exists(files[0]):
        return
    tree = ElementTree.parse(files[0])
    for case in tree.iter('testcase'):
        reason = skips.get(f"{case.get('classname')}.{case.get('name')}")
        if reason:
            ElementTree.SubElement(case, 'skipped', message=reason)
    tree.write(files[0])


def run(name):
    """Runs all tests of the program."""
    rospy.init_node(name)
    try:
        rostest.rosrun('social_crowd', name, '__main__')
    finally:
        note_skips()
