"""A ROS master that ends, and a new one at its place: nodes go on, and register with the new one."""
import os
import re
import select
import signal
import socket
import socketserver
import subprocess
import threading
import xmlrpc.client

import pytest
import rosgraph
from crowd_launching.program import free_port
from programs import ANTICIPATION_TABLE, PATIENCE, assert_says, in_package, wait_for
from roslib.packages import find_node

KINDS = ('publisher', 'subscriber', 'service')
NO_ANSWER_LOST = '0 answers missed, 0 dropped'


class Desk:
    """Nodes and a ROS master of their own, on a free port."""

    def __init__(self, runner):
        self.runner = runner
        uri = f'http://127.0.0.1:{free_port()}'
        self.environment = {'ROS_MASTER_URI': uri, 'ROS_HOSTNAME': '127.0.0.1', 'ROS_NAMESPACE': '',
                            'ROS_HOME': runner.path('ros'), 'ROS_LOG_DIR': runner.path('ros/log')}
        self.uri = uri
        self.master = rosgraph.Master('/new_master_test', uri)
        self.rosmaster = None

    def start_rosmaster(self):
        """Starts a ROS master and waits until it answers."""
        # Not roscore, which ends if the master has not begun to answer after 10 s.
        self.rosmaster = self.runner.start('rosmaster', ['rosmaster', '--core', '-p', self.uri.rsplit(':', 1)[1]],
                                           self.environment)
        wait_for(lambda: self.state() is not None, 'the ROS master')

    def stop_rosmaster(self):
        """Ends the ROS master."""
        assert self.rosmaster.stop() == 0
        assert self.state() is None

    def replace_rosmaster(self):
        """Ends the ROS master and starts another one."""
        self.stop_rosmaster()
        self.start_rosmaster()

    def start(self, kind, *remappings, **parameters):
        """Starts a node of this package. Returns its Process."""
        words = [f'_{name}:={value}' for name, value in parameters.items()]
        return self.runner.start(kind, [find_node('social_crowd', kind)[0], *words, *remappings], self.environment)

    def start_controller(self, **parameters):
        return self.start('crowd_controller', **{
            'scenario': in_package('config', 'scenarios', 'circle6.yaml'), 'real_time_factor': 'fast',
            'answer_deadline': PATIENCE, **parameters})

    def start_learner(self, *remappings, **parameters):
        return self.start('learner', *remappings, q_table=ANTICIPATION_TABLE, **parameters)

    def start_nodelet(self, *words):
        return self.runner.start(f'nodelet_{words[0]}', ['rosrun', 'nodelet', 'nodelet', *words], self.environment)

    def state(self, of=''):
        """Returns what the master has of a node, or of all but its own: {(kind, name, node)}; None without a master."""
        try:
            kinds = self.master.getSystemState()
        except (OSError, rosgraph.MasterException):
            return None
        return {(kind, name, node) for kind, entries in zip(KINDS, kinds) for name, nodes in entries for node in nodes
                if node != '/rosout' and of in ('', node)}

    def links(self, node):
        """Returns the connections to publishers of a node: {(topic, number)}."""
        links = xmlrpc.client.ServerProxy(self.master.lookupNode(node)).getBusInfo('/new_master_test')[2]
        return {(link[4], link[0]) for link in links if link[2] == 'i'}

    def has_service(self, name, node):
        """Returns whether the master has this service of a node."""
        return ('service', name, node) in (self.state() or set())

    def wait_same_state(self, expected, of=''):
        """Waits until the master has all of this again."""
        wait_for(lambda: expected <= (self.state(of) or set()), 'the registrations')
        assert self.state(of) == expected

    def run(self, *command):
        """Runs a program. Returns its output."""
        done = subprocess.run(command, env={**os.environ, **self.environment}, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, timeout=PATIENCE, check=False)
        assert done.returncode == 0, done.stdout
        return done.stdout


@pytest.fixture
def desk(runner):
    desk = Desk(runner)
    desk.start_rosmaster()
    return desk


def episodes(controller):
    """Returns the lines about the episodes that have ended."""
    return [line for line in controller.output().splitlines() if 'agents arrived' in line]


def wait_episode(controller):
    """Waits until an episode has ended that began later than now."""
    end = len(episodes(controller)) + 2
    wait_for(lambda: len(episodes(controller)) >= end, 'another episode')


def wait_registered_again(*nodes):
    """Waits until nodes have registered with a new master."""
    for node in nodes:
        wait_for(lambda node=node: 'did not know this node' in node.output(), f'{node.name} to register again')


def assert_no_answer_lost(controller):
    """A learner that needs more than 3 s to start is named, too: then agents stay in place."""
    lines = episodes(controller)
    assert [line for line in lines if NO_ANSWER_LOST not in line] == []
    assert [line for line in controller.output().splitlines()
            if 'no answer' in line and not line.endswith('They stay in place')] == []


class ClosingProxy(socketserver.ThreadingTCPServer):
    """Stands between nodes and a ROS master, and closes the connections of the first reads of parameters."""
    daemon_threads = True

    def __init__(self, master_uri, closes):
        super().__init__(('127.0.0.1', 0), self.Connection)
        self.master = ('127.0.0.1', int(master_uri.rsplit(':', 1)[1]))
        self.closes = closes
        self.uri = f'http://127.0.0.1:{self.server_address[1]}'
        threading.Thread(target=self.serve_forever, daemon=True).start()

    class Connection(socketserver.BaseRequestHandler):
        """Passes bytes on in both directions."""

        def handle(self):
            with socket.create_connection(self.server.master) as master:
                others = {self.request: master, master: self.request}
                while True:
                    for source in select.select(list(others), [], [])[0]:
                        data = source.recv(65536)
                        if b'getParam<' in data and self.server.closes > 0:
                            self.server.closes -= 1
                            return
                        if not data:
                            return
                        others[source].sendall(data)


class ReadParametersTest:
    """Parameters of a node that starts."""

    def test_a_call_that_fails_is_no_missing_parameter(self, desk):
        with ClosingProxy(desk.uri, closes=5) as proxy:
            desk.environment['ROS_MASTER_URI'] = proxy.uri
            learner = desk.start_learner(mode='training')
            wait_for(lambda: 'what is learned will not be saved' in learner.output(), 'the mode of training')
            assert proxy.closes == 0
            learner.stop()
            proxy.shutdown()


class NewMasterTest:
    """A new rosmaster on the same port."""

    def test_all_is_registered_again_and_no_answer_is_lost(self, desk):
        controller, learner = desk.start_controller(), desk.start_learner()
        wait_episode(controller)
        before = desk.state()
        desk.replace_rosmaster()
        wait_registered_again(controller, learner)
        desk.wait_same_state(before)
        assert_says(desk.run('rosservice', 'call', '/crowd_controller/pause', 'true'), 'success: True', 'paused at')
        assert_says(desk.run('rosservice', 'call', '/learner/set_mode', 'demo'), 'success: True')
        assert_says(desk.run('rostopic', 'echo', '-n', '1', '/scenario/agents[0]/agent'), '0')  # latched
        assert_says(desk.run('rostopic', 'list'), '/perceptions', '/actions', '/agents', '/learner_status')
        assert_says(controller.output(), f'the ROS master at {desk.uri} did not know this node',
                    'as after a new roscore', 'Parameters of the earlier master are lost')
        desk.run('rosservice', 'call', '/crowd_controller/pause', 'false')
        wait_episode(controller)
        assert_no_answer_lost(controller)

    def test_learners_with_agents_of_their_own_stay_connected(self, desk):
        controller = desk.start_controller()
        learners = [desk.start_learner(f'__name:=learner_{i}', share=i, shares=3) for i in range(3)]
        wait_episode(controller)
        before, links = desk.state(), desk.links('/crowd_controller')
        desk.replace_rosmaster()
        wait_registered_again(controller, *learners)
        desk.wait_same_state(before)
        assert links and links <= desk.links('/crowd_controller')
        wait_episode(controller)
        assert_no_answer_lost(controller)

    def test_nodelets(self, desk):
        """The programs that have loaded them stay connected with their manager, or it would unload them."""
        manager = desk.start_nodelet('manager', '__name:=manager')
        loaders = [desk.start_nodelet('load', f'social_crowd/{name}', 'manager', f'__name:={name}', *parameters)
                   for name, parameters in (('learner', [f'_q_table:={ANTICIPATION_TABLE}']),
                                            ('crowd_controller', ['_scenario:=circle6', '_real_time_factor:=5',
                                                                  f'_answer_deadline:={PATIENCE}']))]
        wait_episode(manager)
        before = desk.state('/manager')
        desk.replace_rosmaster()
        wait_registered_again(manager)
        desk.wait_same_state(before, '/manager')
        wait_episode(manager)  # which takes longer than the manager waits for signs of the programs
        assert [loader.is_running() for loader in loaders] == [True, True]
        assert manager.output().count('did not know this node') == 1
        assert_no_answer_lost(manager)
        desk.run('rosservice', 'call', '/crowd_controller/pause', 'true')
        for loader in loaders:
            loader.stop()
        # The manager unloads in a thread of its own, and cannot be interrupted meanwhile.
        wait_for(lambda: not {('publisher', f'/{topic}', '/manager') for topic in ('actions', 'agents')} & desk.state(),
                 'the unloading')

    def test_node_of_the_same_name_is_not_ended(self, desk):
        controller, old = desk.start_controller(answer_deadline=1.0), desk.start_learner()
        wait_episode(controller)
        old.signal(signal.SIGSTOP)
        desk.replace_rosmaster()
        new = desk.start_learner()
        wait_for(lambda: desk.has_service('/learner/set_mode', '/learner'), 'the new learner')
        old.signal(signal.SIGCONT)
        wait_for(lambda: 'another node has the name /learner' in old.output(), 'the warning')
        assert new.is_running()
        assert 'did not know this node' not in old.output()


class NoMasterTest:
    """Time without a ROS master."""

    def test_the_cause_is_told_and_a_new_learner_is_used(self, desk):
        controller, learner = desk.start_controller(answer_deadline=0.1), desk.start_learner()
        wait_episode(controller)
        desk.stop_rosmaster()
        learner.kill()
        # A busy machine may have missed answers before.
        warning = re.compile(rf'no answer for agent.*: the ROS master at {re.escape(desk.uri)} does not answer; ')
        wait_for(lambda: warning.search(controller.output()), 'the warning of silence')
        wait_for(lambda: f'the ROS master at {desk.uri} does not answer. Connected nodes go on' in controller.output(),
                 'the warning of the missing master')
        desk.start_rosmaster()
        desk.start_learner()
        wait_registered_again(controller)
        assert_says(controller.output(), f'there is a ROS master at {desk.uri} again')
        wait_episode(controller)
        assert '6 of 6 agents arrived' in episodes(controller)[-1]

    def test_nodes_end_without_a_master(self, desk):
        controller, learner = desk.start_controller(), desk.start_learner()
        wait_episode(controller)
        desk.stop_rosmaster()
        assert (controller.stop(), learner.stop()) == (0, 0)
