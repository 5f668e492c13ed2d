"""Benchmarks of the nodes: lockstep through ROS and through nodelets, and the load of a crowd in real time.

Each benchmark starts its own master and nodes, and returns value, yardstick in the same unit (ticks/s or % of a core),
and ratio: the time of a tick through ROS divided by the time of the yardstick; for nodelets their rate divided by the
headless rate."""
import math
import time

from crowd_experiments.tools import REPOSITORY

from .ros_system import RosSystem, arguments_of, cpu_seconds, program

Q_TABLE = REPOSITORY / 'config' / 'q_tables' / 'anticipation.txt'
MAX_NEIGHBOURS = 16  # those of the Q-table's model
NODELET = ['rosrun', 'nodelet', 'nodelet']
WARM_UP = 30  # ticks
CROWD_TICKS = 250
FEW_TICKS = 2500
TRIPS = 2500
REAL_TIME = 10.0  # [s]
ROUNDS = 7  # the best of them counts, as it is the least disturbed one


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
    return {'scenario': system.write('scenario.yaml', text), 'real_time_factor': 'fast', 'paused': True,
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
    """Runs a benchmark. Returns its result."""
    return benchmark.result(*BENCHMARKS[benchmark.name]())
