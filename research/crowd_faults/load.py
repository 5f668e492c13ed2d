"""The program `graph_load`."""
import math
import selectors
import socket
import tempfile
import threading
import time
import xmlrpc.client

import rosgraph
import rosgraph.network
from crowd_bench.ros_benchmarks import cpu_seconds
from crowd_experiments.arguments import above_zero, at_least_zero, parser_of, positive, whole
from social_crowd.msg import AgentStates

from .graph import Graph, scenario

DENSITY = 0.5  # [1/m^2]
TICK = 0.1  # [s]
EXAMPLE = '''example:
  source .build/devel/setup.bash
  research/graph_load --agents 10000
  research/graph_load --agents 1000 --factor 1 --subscribers 50 --seconds 120

Prints a line for each period: ticks per second and the factor of real time, processor time of a tick, memory and file
descriptors of the controller. With --subscribers, the first subscriber of `agents` never reads its messages.'''
HEADER = '{:>8} {:>8} {:>8} {:>15} {:>12} {:>8} {:>11}'.format(
    'time [s]', 'ticks/s', 'factor', 'controller [ms]', 'learner [ms]', 'MB', 'descriptors')


def many_agents(count):
    """Returns a scenario with agents that walk between random places of a square all the time."""
    half = math.sqrt(count / DENSITY) / 2
    box = f'{{box: [[{-half:.2f}, {-half:.2f}], [{half:.2f}, {half:.2f}]]}}'
    return scenario([f'{{count: {count}, position: {box}, route: tour, speed: [1.0, 1.5], radius: [0.2, 0.3]}}'],
                    [f'tour: {{repeat: true, waypoints: [{{place: {box}}}, {{place: {box}}}]}}'])


class Readers:
    """Subscribers of `agents` that read all messages, but for the first one, which reads none."""

    def __init__(self, count):
        self.bytes = 0
        self.sockets = [subscribe(f'/reader_{i}') for i in range(count)]
        threading.Thread(target=self.read, daemon=True).start()

    def read(self):
        selector = selectors.DefaultSelector()
        for one in self.sockets[1:]:
            selector.register(one, selectors.EVENT_READ)
        while True:
            for key, _ in selector.select():
                self.bytes += len(key.fileobj.recv(2**20))


def subscribe(caller):
    """Returns a connection to the controller that sends the messages of `agents`."""
    node = xmlrpc.client.ServerProxy(rosgraph.Master(caller).lookupNode('/crowd_controller'))
    _, _, (_, host, port) = node.requestTopic(caller, '/agents', [['TCPROS']])
    connection = socket.create_connection((host, port))
    rosgraph.network.write_ros_handshake_header(connection, {
        'callerid': caller, 'topic': '/agents', 'type': AgentStates._type, 'md5sum': AgentStates._md5sum,
        'message_definition': AgentStates._full_text})
    return connection


def measure(graph, seconds):
    """Waits. Returns ticks/s, and the processor time of a tick of controller and learner [ms]."""
    nodes = [graph.nodes['controller'], graph.nodes['learner']]
    before, begin, used = graph.status.tick, time.monotonic(), [cpu_seconds([node]) for node in nodes]
    graph.wait_for(lambda: time.monotonic() > begin + seconds, 'the end of the period')
    ticks = max(graph.status.tick - before, 1)
    return ticks / (time.monotonic() - begin), [1000 * (cpu_seconds([node]) - start) / ticks
                                                for node, start in zip(nodes, used)]


def main(words=None):
    parser = parser_of('graph_load', 'Measures a crowd controller with one learner.', EXAMPLE)
    add = parser.add_argument
    add('--agents', type=positive, default=1000, metavar='N', help='number of agents (default: %(default)s)')
    add('--factor', type=at_least_zero, default=0.0, help='of real time; 0: as fast as possible (default)')
    add('--subscribers', type=whole, default=0, metavar='N', help='of `agents`, of which one never reads (default: 0)')
    add('--seconds', type=above_zero, default=60.0, help='of the measurement (default: %(default)s)')
    add('--period', type=above_zero, default=10.0, metavar='SECONDS', help='of a line (default: %(default)s)')
    arguments = parser.parse_args(words)
    with tempfile.TemporaryDirectory(prefix='social_crowd_') as folder, \
            Graph(folder, 600.0, many_agents(arguments.agents), arguments.agents, answer_deadline=60,
                  start_deadline=600, real_time_factor=arguments.factor) as graph:
        graph.start_learner('learner')
        graph.wait_until_steady()
        readers = Readers(arguments.subscribers)
        print(HEADER, flush=True)
        end = time.monotonic() + arguments.seconds
        while (left := end - time.monotonic()) > 0.0:
            rate, (controller, learner) = measure(graph, arguments.period)
            files, memory = graph.usage('controller')
            print(f'{arguments.seconds - left + arguments.period:8.0f} {rate:8.1f} {rate * TICK:8.2f} '
                  f'{controller:15.1f} {learner:12.1f} {memory:8.1f} {files:11}', flush=True)
        if arguments.subscribers:
            print(f'{readers.bytes / 2**20:.0f} MB were read by {arguments.subscribers - 1} subscribers')
    return 0
