"""Base of the rostests: nodes, topics and services in a separate name space. Includes the support of all tests."""
import os
import queue
import random
import shutil
import sys
import tempfile
import threading
import time
import unittest
import xml.etree.ElementTree as ElementTree
import xmlrpc.client

import rosgraph
import rospy
import rostest
from roslib.packages import find_node
from social_crowd import srv
from social_crowd.msg import LearnerStatus
from std_srvs.srv import SetBool, Trigger

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, 'support'))
from programs import (ANTICIPATION_TABLE, CIRCLE6, NEAREST_TABLE, OCCUPANCY_TABLE, PATIENCE,  # noqa: E402, F401
                      Launch, ProgramRunner, assert_same_recording, assert_says, data, in_package, page_examples,
                      read_bytes, read_text, recording_of, wait_for)

TICK = 0.1  # [s], default of scenarios
STANDARD_SERVICES = {'pause': SetBool, 'reset_traces': Trigger}  # the class of another one is called like it

LATENESS = float(os.environ.get('SOCIAL_CROWD_TEST_LATENESS', 0))  # [s]

skips = {}  # reasons, by test


class Task:
    """A call in a separate thread, with a timeout."""

    def __init__(self, call):
        self.call = call
        self.value = None
        self.error = None
        self.thread = threading.Thread(target=self.run, daemon=True)
        self.thread.start()

    def run(self):
        """Runs the call in the thread."""
        try:
            self.value = self.call()
        except Exception as error:
            self.error = error

    def is_done(self):
        """Returns whether the call has returned."""
        return not self.thread.is_alive()

    def result(self, what='an answer', seconds=PATIENCE):
        """Waits for the result of the call."""
        wait_for(self.is_done, what, seconds)
        if self.error is not None:
            raise self.error
        return self.value


def service_class(name):
    """Returns the class of a service of the package, such as set_goal."""
    return STANDARD_SERVICES.get(name) or getattr(srv, ''.join(word.capitalize() for word in name.split('_')))


def late(receive):
    """Returns `receive`, delayed by a random time of up to LATENESS, which is the same for all messages. Nothing
    promises that messages of two topics come in the order in which they were sent: this shows tests that rely on it."""
    if not LATENESS:
        return receive
    seconds = random.uniform(0, LATENESS)
    messages = queue.Queue()

    def run():
        while True:
            due, message = messages.get()
            time.sleep(max(0.0, due - time.monotonic()))
            receive(message)

    threading.Thread(target=run, daemon=True).start()
    return lambda message: messages.put((time.monotonic() + seconds, message))


class Listener:
    """Keeps all messages of a topic."""

    def __init__(self, topic, message_type):
        self.topic = topic
        self.messages = []
        self.subscriber = rospy.Subscriber(topic, message_type, late(self.messages.append), tcp_nodelay=True)

    def wait_connected(self, count=1):
        """Waits until this number of publishers send their messages here. rospy counts connections before that."""
        wait_for(lambda: self.subscriber.get_num_connections() >= count, f'{count} publishers of {self.topic}')
        wait_for(lambda: sum(map(self.is_served_by, self.publishers())) >= count,
                 f'messages of {count} publishers of {self.topic}')
        return self

    def wait_served_by(self, node):
        """Waits until a node sends its messages here, of a topic that others publish, too."""
        wait_for(lambda: self.is_served_by(node), f'messages of {node} on {self.topic}')
        return self

    def publishers(self):
        """Returns the nodes that publish the topic."""
        return dict(rosgraph.Master(rospy.get_name()).getSystemState()[0]).get(self.subscriber.resolved_name, [])

    def is_served_by(self, node):
        """Returns whether a node has connected this one to the topic, by its bus information."""
        try:
            proxy = xmlrpc.client.ServerProxy(rosgraph.Master(rospy.get_name()).lookupNode(node))
            connections = proxy.getBusInfo(rospy.get_name())[2]
        except (OSError, rosgraph.MasterException):
            return False  # it has ended
        return any(connection[1] in (rospy.get_name(), rospy.get_node_uri()) and connection[2] == 'o' and
                   connection[4] == self.subscriber.resolved_name for connection in connections)

    def wait(self, fits=lambda message: True, what='', seconds=PATIENCE):
        """Waits for a message that meets the condition. Returns the first one."""
        return wait_for(lambda: [message for message in list(self.messages) if fits(message)],
                        f'a message on {self.topic} {what}', seconds)[0]

    def wait_at(self, episode, tick):
        """Waits for the message of a tick."""
        return self.wait(lambda message: (message.episode, message.tick) == (episode, tick),
                         f'of episode {episode}, tick {tick}')


class CrowdTestCase(unittest.TestCase, ProgramRunner):
    """A test that starts nodes in its own name space and folder."""

    longMessage = True
    maxDiff = None
    count = 0

    def run(self, result=None):
        """Runs the test; if it fails, prints the output of its processes."""
        CrowdTestCase.count += 1
        self.namespace = f'/test_{CrowdTestCase.count}'
        ProgramRunner.__init__(self, tempfile.mkdtemp(prefix='social_crowd_'), {'ROS_NAMESPACE': self.namespace})
        self.listeners = []
        problems = len(result.failures) + len(result.errors)
        try:
            super().run(result)
            if len(result.failures) + len(result.errors) > problems:
                print(f'--- {self.id()}\n{self.outputs()}', file=sys.stderr)
        finally:
            shutil.rmtree(self.folder, ignore_errors=True)

    def setUp(self):
        self.addCleanup(self.check_ends)

    def check_ends(self):
        """Ends all processes and checks that they end properly."""
        for listener in self.listeners:
            listener.subscriber.unregister()
        self.assertEqual(self.clean_up(), '', 'processes that ended badly')

    def skip(self, reason):
        """Marks the test as skipped and ends it."""
        skips[self.id()] = reason
        print(f'SKIPPED {self.id()}: {reason}', file=sys.stderr)
        self.skipTest(reason)

    # Nodes

    def start_node(self, kind, name, parameters, arguments=()):
        """Starts a node of this package with private parameters."""
        full_name = f'{self.namespace}/{name}'
        if rospy.has_param(full_name):
            rospy.delete_param(full_name)
        for key, value in parameters.items():
            rospy.set_param(f'{full_name}/{key}', value)
        return self.start(name, find_node('social_crowd', kind)[:1] + [f'__name:={name}', *arguments])

    def start_controller(self, scenario, arguments=(), **parameters):
        """Starts a crowd controller with long deadlines that walks as fast as possible. Its services use the folder of
        the test."""
        defaults = {'scenario': scenario, 'real_time_factor': 'fast', 'start_deadline': 120.0, 'answer_deadline': 60.0,
                    'agents_rate': 0, 'data_folder': self.folder}
        return self.start_node('crowd_controller', 'crowd_controller', dict(defaults, **parameters), arguments)

    def start_learner(self, name='learner', arguments=(), **parameters):
        """Starts a learner, by default in demo mode with a trained table. Its services use the folder of the test."""
        parameters.setdefault('data_folder', self.folder)
        if not {'q_table', 'config'} & set(parameters):
            parameters['q_table'] = NEAREST_TABLE
        return self.start_node('learner', name, parameters, arguments)

    # ROS

    def listen(self, topic, message_type):
        """Listens to a topic of the test's name space, or to an absolute one."""
        listener = Listener(topic if topic.startswith('/') else f'{self.namespace}/{topic}', message_type)
        self.listeners.append(listener)
        return listener

    def call_later(self, service, **request):
        """Calls a service of a node, such as learner/set_mode, in a separate thread."""
        name = f'{self.namespace}/{service}'
        rospy.wait_for_service(name, PATIENCE)
        return Task(lambda: rospy.ServiceProxy(name, service_class(service.split('/')[-1]))(**request))

    def call(self, service, seconds=PATIENCE, **request):
        """Calls a service of a node, such as learner/set_mode."""
        return self.call_later(service, **request).result(f'an answer of {service}', seconds)

    def succeed(self, service, **request):
        """Calls a service that must succeed."""
        response = self.call(service, **request)
        self.assertTrue(response.success, f'{service}: {response.message}')
        return response

    def refuse(self, service, *words, **request):
        """Calls a service that must refuse, with a message that contains these words."""
        response = self.call(service, **request)
        self.assertFalse(response.success, f'{service} should have refused {request}')
        self.assert_says(response.message, *words)
        return response

    def step(self, ticks=1):
        """Walks a number of ticks."""
        return self.succeed('crowd_controller/step', ticks=ticks)

    def wait_until_learned(self, learner, decisions):
        """Waits until a learner has learned from a number of decisions."""
        status = self.listen('learner_status', LearnerStatus)

        def has_all():
            self.succeed(f'{learner}/set_learning_parameters', parameters='{}')  # changes nothing, publishes a status
            name = f'{self.namespace}/{learner}'
            return any(message.node == name and message.decisions >= decisions for message in status.messages)

        wait_for(has_all, f'{decisions} decisions learned from')

    # Assertions

    assert_says = staticmethod(assert_says)
    assert_same_recording = staticmethod(assert_same_recording)


def read_recording(file):
    """Returns the positions of a recording by (instance, tick, agent)."""
    rows = [line.split(',') for line in read_text(file).splitlines()[1:]]
    return {(int(i), int(k), int(a)): (float(x), float(y)) for i, k, a, x, y in rows}


def note_skips():
    """Marks skipped tests in the results, because rosunit reports them as passed."""
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
