"""Bytes between hosts: a crowd on one host and its learners, or RViz, on others. The hosts are network namespaces,
which need root. Counted are the bytes of their links, with the headers of all protocols."""
import dataclasses
import math
import os
import subprocess
import tempfile
import time

from crowd_experiments.runs import RunError

from .hosts import MASTER_PORT, Network, why_not
from .ros_system import PATIENCE, REPOSITORY, RosSystem, arguments_of, program

Q_TABLE = os.path.join(REPOSITORY, 'config', 'q_tables', 'anticipation.txt')
AGENTS = (200, 1000, 10_000)
LEARNERS = (1, 2, 4)
DENSITY = 0.5  # [agents per square metre]
WARM_UP, TICKS = 10, 50
REAL_TIME = 10.0  # [s] of ticks for RViz, whose messages have a rate of the wall clock
TICK_RATE = 10.0  # [Hz]


def scenario(agents):
    """Returns a scenario with agents that walk all the time."""
    half = math.sqrt(agents / DENSITY) / 2
    box = f'{{box: [[{-half:.2f}, {-half:.2f}], [{half:.2f}, {half:.2f}]]}}'
    goals = ', '.join([box] * 12)
    return ('name: crowd\nduration: 3600\ngoal_tolerance: 0.3\nagents:\n'
            f'  - {{count: {agents}, position: {box}, goals: [{goals}], speed: [1.0, 1.5], radius: [0.2, 0.3]}}\n')


class HostSystem(RosSystem):
    """Context manager that starts a master on the first of several hosts, and nodes on any."""

    def __enter__(self):
        self.folder = tempfile.TemporaryDirectory(prefix='social_crowd_bench_')
        self.processes = []
        self.network = Network({'ROS_LOG_DIR': self.path('logs')})
        self.network.__enter__()
        self.crowd = self.network.add('crowd')
        self.start_on(self.crowd, 'rosmaster', ['/usr/bin/rosmaster', '--core', '-p', str(MASTER_PORT)])
        self.wait_for(self.has_master, 'the master')
        return self

    def __exit__(self, *_):
        super().__exit__(*_)
        self.network.__exit__(*_)

    def has_master(self):
        """Returns whether the master accepts connections."""
        connect = self.crowd.command('bash', '-c', f'echo >/dev/tcp/{self.crowd.address}/{MASTER_PORT}')
        return subprocess.run(connect, stderr=subprocess.DEVNULL, check=False).returncode == 0

    def start_on(self, host, name, command):
        """Starts a process on a host."""
        self.environment = {**os.environ, **host.environment()}
        self.environment.pop('ROS_HOSTNAME', None)
        self.environment.pop('ROS_NAMESPACE', None)
        return self.start(name, host.command(*self.wrapped(command)))

    def start_node_on(self, host, kind, *words, **parameters):
        """Starts a node of this package on a host."""
        return self.start_on(host, kind, [program(kind), *words, *arguments_of(parameters)])

    def start_crowd(self, agents, **parameters):
        """Starts a crowd that waits for `step`."""
        file = self.write('crowd.yaml', scenario(agents))
        self.start_node_on(self.crowd, 'crowd_controller', scenario=file, **{
            'real_time_factor': 'fast', 'paused': True, 'answer_deadline': 60.0, 'start_deadline': 60.0, **parameters})

    def step(self, ticks):
        """Walks ticks. The service is there before the first answers are."""
        call = ['rosservice', 'call', '--wait', '/crowd_controller/step', str(ticks)]
        done = subprocess.run(self.crowd.command(*self.wrapped(call)), env=self.environment, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, timeout=PATIENCE, check=False)
        self.check()
        if done.returncode != 0 or 'success: True' not in done.stdout:
            raise RunError(f'step failed: {done.stdout}')


def traffic_of(hosts, measure):
    """Runs a function. Returns the bytes that each host received and sent meanwhile."""
    before = [host.traffic() for host in hosts]
    measure()
    return [(after[0] - first[0], after[1] - first[1])
            for first, after in zip(before, (host.traffic() for host in hosts))]


def learner_traffic(agents, learners):
    """Returns kilobytes per tick: received and sent by the busiest learner host; sent and received by the crowd's."""
    with HostSystem() as system:
        hosts = [system.network.add(f'learner{i}') for i in range(learners)]
        for i, host in enumerate(hosts):
            system.start_node_on(host, 'learner', f'__name:=learner_{i}', q_table=Q_TABLE, share=i, shares=learners)
        system.start_crowd(agents)
        system.step(WARM_UP)
        *each, crowd = traffic_of([*hosts, system.crowd], lambda: system.step(TICKS))
    kilobytes = [value / TICKS / 1000.0 for value in
                 (max(received for received, _ in each), max(sent for _, sent in each), crowd[1], crowd[0])]
    return kilobytes


def rviz_traffic(agents, markers_there, chosen_agent):
    """Returns the kilobytes per tick that a host with RViz receives, in real time."""
    with HostSystem() as system:
        rviz = system.network.add('rviz')
        system.start_node_on(system.crowd, 'learner', q_table=Q_TABLE)
        system.start_node_on(rviz if markers_there else system.crowd, 'crowd_markers', agent=chosen_agent)
        system.start_on(rviz, 'sink', [program('ros_bench'), 'sink', 'markers', '/tf'])
        system.start_crowd(agents, real_time_factor=1.0)
        system.step(int(3 * TICK_RATE))  # until all nodes are connected
        begin = time.monotonic()
        [(received, _)] = traffic_of([rviz], lambda: system.step(int(REAL_TIME * TICK_RATE)))
        if time.monotonic() - begin > 1.5 * REAL_TIME:
            raise RunError('the machine is too slow for a crowd in real time')
    return received / (REAL_TIME * TICK_RATE) / 1000.0


@dataclasses.dataclass(frozen=True)
class HostTraffic:
    """A table of bytes between hosts."""
    name: str
    title: str
    header: tuple
    rows: object  # function without arguments


def text(kilobytes):
    """Returns a number with three digits."""
    return f'{kilobytes:,.0f}' if kilobytes >= 100 else f'{kilobytes:.3g}'


def learner_rows():
    """Measures all numbers of agents and learners."""
    return [[f'{agents:,}', str(learners), *map(text, learner_traffic(agents, learners))]
            for agents in AGENTS for learners in LEARNERS]


def rviz_rows():
    """Measures all numbers of agents, with the markers made on either host."""
    return [[f'{agents:,}', *(text(rviz_traffic(agents, *where)) for where in ((True, -1), (True, 0), (False, -1)))]
            for agents in AGENTS]


TABLES = (
    HostTraffic('host_learners', 'Learners on other hosts [kB per tick]',
                ('agents', 'learner hosts', 'each receives [kB per tick]', 'each sends',
                 'the crowd\'s host sends', 'it receives'),
                learner_rows),
    HostTraffic('host_rviz', 'RViz on another host [kB per tick]',
                ('agents', 'received with crowd_markers there [kB per tick]', 'the same, with a chosen agent',
                 'received with crowd_markers on the crowd\'s host'), rviz_rows),
)


def measure(table):
    """Returns the rows of a table; none where there are no namespaces."""
    reason = why_not()
    if reason:
        raise RunError(f'left out: {reason}')
    return table.rows()
