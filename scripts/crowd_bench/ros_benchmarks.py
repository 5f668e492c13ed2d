"""Benchmarks of the nodes: lockstep through ROS and through nodelets, and the load of a crowd in real time.

Each benchmark starts its own master and nodes, and returns value, yardstick in the same unit (ticks/s or % of a core),
and ratio: the time of a tick through ROS divided by the time of the yardstick; for nodelets their rate divided by the
headless rate."""
import math
import os
import pathlib
import subprocess
import tempfile
import time

import rosgraph
from crowd_experiments.runs import RunError, output_of
from crowd_experiments.tools import REPOSITORY, build_folder, programs_in
from crowd_launching.program import end_all, free_port

PATIENCE = 300.0  # [s] time limit of each command
CLOCK_TICKS = os.sysconf('SC_CLK_TCK')  # per second, unit of the times in /proc
Q_TABLE = REPOSITORY / 'config' / 'q_tables' / 'anticipation.txt'
MAX_NEIGHBOURS = 16  # those of the Q-table's model
NODELET = ['rosrun', 'nodelet', 'nodelet']
WARM_UP, CROWD_TICKS, FEW_TICKS, TRIPS = 30, 250, 2500, 2500  # ticks; round trips
REAL_TIME = 10.0  # [s]
ROUNDS = 7  # the best of them counts, as it is the least disturbed one


def program(name):
    return programs_in(build_folder() / 'devel') / name


class RosSystem:
    """Context manager that starts a master and nodes, writes their output to files, and ends them all on exit."""

    def __enter__(self):
        self.folder = tempfile.TemporaryDirectory(prefix='social_crowd_bench_')
        self.processes = []
        port = free_port()
        master = f'http://127.0.0.1:{port}'
        self.environment = {**os.environ, 'ROS_MASTER_URI': master, 'ROS_HOSTNAME': '127.0.0.1',
                            'ROS_LOG_DIR': str(self.path('logs'))}
        self.environment.pop('ROS_NAMESPACE', None)
        self.start('rosmaster', ['/usr/bin/rosmaster', '--core', '-p', str(port)])
        while not rosgraph.is_master_online(master):
            self.check()
            time.sleep(0.05)
        return self

    def __exit__(self, *_):
        end_all(self.processes, 10.0)
        self.folder.cleanup()

    def check(self):
        for process in self.processes:
            if process.poll() not in (None, 0):
                raise RunError(f'{process.args} ended with status {process.returncode}:\n'
                               f"{process.log.read_text(encoding='utf-8', errors='replace')}")

    def path(self, name):
        return pathlib.Path(self.folder.name) / name

    def start(self, name, command):
        """Starts a process in the package's environment; its log file is named after it."""
        log = self.path(f'{len(self.processes)}_{name}.log')
        with open(log, 'wb') as stream:
            process = subprocess.Popen(wrapped(command), stdin=subprocess.DEVNULL, stdout=stream, stderr=stream,
                                       env=self.environment)
        process.log = log
        self.processes.append(process)
        return process

    def start_node(self, kind, **parameters):
        return self.start(kind, [program(kind), *arguments_of(parameters)])

    def figures(self, name, *words):
        """Runs a program of this package. Returns the numbers in the last line of its output."""
        output = output_of(wrapped([program(name), *words]), timeout=PATIENCE, env=self.environment)
        self.check()
        return [float(word) for word in output.splitlines()[-1].split()]


def wrapped(command):
    return [str(build_folder() / 'devel' / 'env.sh'), *map(str, command)]


def arguments_of(parameters):
    return [f'_{name}:={value}' for name, value in parameters.items()]


def cpu_seconds(processes):
    """Returns the processor time that processes and all their threads have used so far [s]."""
    stats = [pathlib.Path(f'/proc/{process.pid}/stat').read_text(encoding='utf-8') for process in processes]
    fields = [text.rpartition(')')[2].split()[11:13] for text in stats]  # user and system
    return sum(int(ticks) for of_process in fields for ticks in of_process) / CLOCK_TICKS


def crowd_scenario():
    """Returns a scenario with 1,000 agents, 0.5 per square metre, that walk all the time."""
    half = math.sqrt(1000 / 0.5) / 2
    box = f'{{box: [[{-half:.2f}, {-half:.2f}], [{half:.2f}, {half:.2f}]]}}'
    goals = ', '.join([box] * 12)
    return ('name: crowd\nduration: 600\ngoal_tolerance: 0.3\nagents:\n'
            f'  - {{count: 1000, position: {box}, goals: [{goals}], speed: [1.0, 1.5], radius: [0.2, 0.3]}}\n')


def few_scenario():
    """Returns a scenario with 12 agents that cross a circle back and forth."""
    lines = ['name: few', 'duration: 5000', 'goal_tolerance: 0.3', 'agents:']
    for i in range(12):
        x, y = (5.0 * function(2.0 * math.pi * i / 12) for function in (math.cos, math.sin))
        goals = ', '.join([f'[{-x:.3f}, {-y:.3f}], [{x:.3f}, {y:.3f}]'] * 1000)
        lines.append(f'  - {{position: [{x:.3f}, {y:.3f}], goals: [{goals}], speed: {1 + 0.04 * i:.2f}, radius: 0.25}}')
    return '\n'.join(lines) + '\n'


def controller_parameters(system, text, **others):
    """Returns the parameters of a controller with a scenario that waits for `step`."""
    scenario = system.path('scenario.yaml')
    scenario.write_text(text, encoding='utf-8')
    return {'scenario': scenario, 'real_time_factor': 'fast', 'paused': True,
            'answer_deadline': 60.0, **others}


def best_of(*measures):
    """Returns the best rate of each measure. The measures alternate, so that other load affects all of them equally."""
    rounds = [[measure() for measure in measures] for _ in range(ROUNDS)]
    return [max(rates) for rates in zip(*rounds)]


def walking(system, ticks):
    """Returns functions that measure ticks/s of the running controller, and without ROS."""
    return (lambda: system.figures('ros_bench', 'lockstep', WARM_UP, ticks)[0],
            lambda: system.figures('ros_bench', 'headless', system.path('scenario.yaml'), Q_TABLE, MAX_NEIGHBOURS,
                                   WARM_UP, ticks)[0])


def lockstep(text, ticks):
    """Measures controller and learner as nodes."""
    with RosSystem() as system:
        system.start_node('learner', q_table=Q_TABLE)
        system.start_node('crowd_controller', **controller_parameters(system, text))
        _, perceptions, actions = map(int, system.figures('ros_bench', 'lockstep', WARM_UP, ticks))
        system.start('echo', [program('ros_bench'), 'echo', str(actions)])
        rate, alone, trips = best_of(*walking(system, ticks), lambda: system.figures(
            'ros_bench', 'round_trip', perceptions, WARM_UP, TRIPS)[0])
    yardstick = 1.0 / (1.0 / trips + 1.0 / alone)
    return rate, yardstick, yardstick / rate


def nodelets():
    """Measures controller and learner as nodelets in one manager."""
    with RosSystem() as system:
        system.start('manager', [*NODELET, 'manager', '__name:=manager'])
        for kind, parameters in (('learner', {'q_table': Q_TABLE}),
                                 ('crowd_controller', controller_parameters(system, crowd_scenario()))):
            system.start(kind, [*NODELET, 'load', f'social_crowd/{kind}', 'manager', f'__name:={kind}',
                                *arguments_of(parameters)])
        rate, alone = best_of(*walking(system, CROWD_TICKS))
    return rate, alone, rate / alone


def real_time():
    """Measures the load of all nodes together with 1,000 agents in real time at 10 Hz, with markers and frames."""
    with RosSystem() as system:
        nodes = [system.start_node('learner', q_table=Q_TABLE), system.start_node('crowd_markers'),
                 system.start_node('crowd_controller', **controller_parameters(
                     system, crowd_scenario(), real_time_factor=1.0, paused=False, publish_tf=True))]
        system.start('sink', [program('ros_bench'), 'sink', 'markers', '/tf'])
        time.sleep(5.0)  # until all nodes are connected, and the drawn paths have their full length
        before, begin = cpu_seconds(nodes), time.monotonic()
        time.sleep(REAL_TIME)
        share = 100.0 * (cpu_seconds(nodes) - before) / (time.monotonic() - begin)
        system.check()
    return share, None, None


BENCHMARKS = {'ros_lockstep_1000': lambda: lockstep(crowd_scenario(), CROWD_TICKS),
              'ros_lockstep_12': lambda: lockstep(few_scenario(), FEW_TICKS),
              'nodelets_1000': nodelets, 'real_time_1000': real_time}


def run(benchmark):
    return benchmark.result(*BENCHMARKS[benchmark.name]())
