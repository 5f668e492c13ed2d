"""The nodes crowd_controller and learner of the show, their services and the results of episodes."""
import threading
import time
import xmlrpc.client

import rosgraph
import rospy
from crowd_launching.nodes import NodeError, ending_of, start_node, stop_nodes
from social_crowd.msg import EpisodeResult

CONTROLLER, LEARNER = 'crowd_controller', 'learner'
PERIOD = 0.05  # [s] between two checks
PATIENCE = 10.0  # [s] for the last messages of a node that has ended


class Stopped(Exception):
    """The show is interrupted."""


class CrowdNodes:
    """Starts nodes, calls their services, and keeps the results of the present controller."""

    def __init__(self):
        self.processes = {}  # by kind of node
        self.results = []
        self.subscriber = rospy.Subscriber('episode_results', EpisodeResult, self.take, queue_size=None)
        rospy.on_shutdown(self.stop)  # unblocks calls of services

    def take(self, result):
        self.results.append(result)

    def start(self, kind, **parameters):
        self.require_running()
        self.processes[kind] = start_node(kind, kind, parameters)

    def start_controller(self, **parameters):
        """Starts a controller that is paused, and waits until its results will be received."""
        self.results = []
        self.start(CONTROLLER, paused=True, **parameters)
        self.wait(self.is_connected)

    def is_connected(self):
        """Returns whether the controller knows the subscriber of results; rospy counts connections before that."""
        try:
            node = rosgraph.Master(rospy.get_name()).lookupNode(rospy.resolve_name(CONTROLLER))
            connections = xmlrpc.client.ServerProxy(node).getBusInfo(rospy.get_name())[2]
        except (OSError, rosgraph.MasterException):
            return False  # it has not begun
        return any(connection[1] in (rospy.get_name(), rospy.get_node_uri()) and connection[2] == 'o' and
                   connection[4] == self.subscriber.resolved_name for connection in connections)

    def call(self, service, kind, **request):
        """Calls a service, such as learner/set_mode. Returns its answer. Raises NodeError."""
        self.wait(lambda: rosgraph.Master(rospy.get_name()).lookupService(rospy.resolve_name(service)),
                  rosgraph.MasterException)
        answer = rospy.ServiceProxy(service, kind)(**request)
        if not answer.success:
            raise NodeError(f'{rospy.resolve_name(service)}: {answer.message}')
        return answer

    def wait(self, is_done, *not_yet):
        """Waits until a function returns a true value, without an exception of the kinds `not_yet`."""
        while True:
            self.require_running()
            try:
                if is_done():
                    return
            except not_yet:
                pass
            threading.Event().wait(PERIOD)

    def wait_for_results(self, count):
        """Waits until the controller has walked its episodes and has ended. Raises NodeError if results are missing."""
        controller = self.processes[CONTROLLER]
        self.wait(lambda: controller.poll() is not None)
        end = time.monotonic() + PATIENCE
        self.wait(lambda: len(self.results) >= count or time.monotonic() > end)
        if len(self.results) != count:
            raise NodeError(f'{len(self.results)} results of {count} episodes were received')

    def require_running(self):
        """Raises Stopped during a shutdown, and NodeError if a node has ended with an error, or the learner at all."""
        if rospy.is_shutdown():
            raise Stopped
        for kind, process in self.processes.items():
            status = process.poll()
            if status is not None and (status != 0 or kind == LEARNER):
                raise NodeError(f'{kind} {ending_of(status)}')

    def stop(self, *_):
        """Ends all nodes, the controller first."""
        for kind in (CONTROLLER, LEARNER):
            if kind in self.processes:
                stop_nodes([self.processes[kind]])
