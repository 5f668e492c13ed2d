"""Benchmarks of the nodes: lockstep through ROS and through nodelets, and the load of a crowd in real time.

Each benchmark starts its own master and nodes. `value` is in ticks/s or % of a core; `yardstick` has the same unit.
`ratio` is the time of a tick through ROS divided by the yardstick's time; for nodelets it is their rate divided by the
headless rate.
"""
import math
import os
import time

from crowd_experiments.tools import REPOSITORY

from .ros_system import RosSystem, arguments_of, cpu_seconds, program

Q_TABLE = os.path.join(REPOSITORY, 'config', 'q_tables', 'anticipation.txt')
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


def controller_parameters(scenario, **others):
    """Returns the parameters of a controller that waits for `step`."""
    return {'scenario': scenario, 'real_time_factor': 'fast', 'paused': True, 'answer_deadline': 60.0, **others}


def best_of(*measures):
    """Returns the best rate of each measure. The measures alternate, so that other load affects all of them equally."""
    rounds = [[measure() for measure in measures] for _ in range(ROUNDS)]
    return [max(rates) for rates in zip(*rounds)]


def headless(system, scenario, ticks):
    """Returns a function that measures ticks/s without ROS."""
    return lambda: system.figures('ros_bench', 'headless', scenario, Q_TABLE, MAX_NEIGHBOURS, WARM_UP, ticks)[0]


def walking(system, ticks):
    """Returns a function that measures ticks/s of the running controller."""
    return lambda: system.figures('ros_bench', 'lockstep', WARM_UP, ticks)[0]


def lockstep(text, ticks):
    """Measures controller and learner as nodes."""
    with RosSystem() as system:
        scenario = system.write('scenario.yaml', text)
        system.start_node('learner', q_table=Q_TABLE)
        system.start_node('crowd_controller', **controller_parameters(scenario))
        _, perceptions, actions = (int(number) for number in system.figures('ros_bench', 'lockstep', WARM_UP, ticks))
        system.start('echo', [program('ros_bench'), 'echo', str(actions)])
        rate, alone, trips = best_of(
            walking(system, ticks), headless(system, scenario, ticks),
            lambda: system.figures('ros_bench', 'round_trip', perceptions, WARM_UP, TRIPS)[0])
    yardstick = 1.0 / (1.0 / trips + 1.0 / alone)
    detail = {'round_trips': trips, 'headless': alone, 'perceptions_bytes': perceptions, 'actions_bytes': actions}
    return figure(rate, 'ticks/s', yardstick, yardstick / rate, detail)


def ros_lockstep_1000():
    """Measures 1,000 agents with one learner node."""
    return lockstep(crowd_scenario(), CROWD_TICKS)


def ros_lockstep_12():
    """Measures 12 agents with one learner node."""
    return lockstep(few_scenario(), FEW_TICKS)


def nodelets_1000():
    """Measures controller and learner as nodelets in one manager."""
    with RosSystem() as system:
        scenario = system.write('scenario.yaml', crowd_scenario())
        system.start('manager', [*NODELET, 'manager', '__name:=manager'])
        for kind, parameters in (('learner', {'q_table': Q_TABLE}),
                                 ('crowd_controller', controller_parameters(scenario))):
            system.start(kind, [*NODELET, 'load', f'social_crowd/{kind}', 'manager', f'__name:={kind}',
                                *arguments_of(parameters)])
        rate, alone = best_of(walking(system, CROWD_TICKS), headless(system, scenario, CROWD_TICKS))
    return figure(rate, 'ticks/s', alone, rate / alone, {})


def real_time_1000():
    """Measures the load of all nodes together with 1,000 agents in real time at 10 Hz, with markers and frames."""
    with RosSystem() as system:
        scenario = system.write('scenario.yaml', crowd_scenario())
        parameters = controller_parameters(scenario, real_time_factor=1.0, paused=False, publish_tf=True)
        kinds = {'learner': {'q_table': Q_TABLE}, 'crowd_markers': {}, 'crowd_controller': parameters}
        nodes = {kind: system.start_node(kind, **parameters) for kind, parameters in kinds.items()}
        system.start('sink', [program('ros_bench'), 'sink', 'markers', '/tf'])
        time.sleep(5.0)  # until all nodes are connected, and the drawn paths have their full length
        before = {kind: cpu_seconds([node]) for kind, node in nodes.items()}
        begin = time.monotonic()
        time.sleep(REAL_TIME)
        seconds = time.monotonic() - begin
        shares = {kind: 100.0 * (cpu_seconds([node]) - before[kind]) / seconds for kind, node in nodes.items()}
        system.check()
    return figure(sum(shares.values()), '% of a core', None, None, shares)


def figure(value, unit, yardstick, ratio, detail):
    """Returns a benchmark's result without its name."""
    return {'value': value, 'unit': unit, 'yardstick': yardstick, 'ratio': ratio, 'detail': detail}


BENCHMARKS = {function.__name__: function for function in
              (ros_lockstep_1000, ros_lockstep_12, nodelets_1000, real_time_1000)}


def run(name):
    """Runs a benchmark. Returns {name, value, unit, yardstick, ratio, detail}."""
    return {'name': name, **BENCHMARKS[name]()}
