#!/usr/bin/python3
"""Measures VecEnv: 64 robots, each among 20 people who walk all the time, with 720 rays, in a hall; and Crowd.step()
beside the same loop in C++. Prints steps of robots per second of the clock, and the processor time of a step.
"""
import argparse
import resource
import statistics
import time

import numpy
import social_crowd

FLOOR = {'box': [[-9, -9], [9, 9]]}
HALL = {
    'name': 'hall', 'duration': 60, 'goal_tolerance': 0.3, 'contact': 'solid', 'ends': 'robots',
    'agents': [{'count': 20, 'position': FLOOR, 'goals': [FLOOR] * 8, 'speed': [1.0, 1.5], 'radius': 0.25}],
    'robots': [{'name': 'robot', 'position': [-8, -8], 'goal': [8, 8], 'radius': 0.3, 'max_speed': 1}],
    'walls': [[[-10, -10], [10, -10]], [[10, -10], [10, 10]], [[10, 10], [-10, 10]], [[-10, 10], [-10, -10]]],
}


def processor_time():
    """Returns the processor time of all threads so far [s]."""
    used = resource.getrusage(resource.RUSAGE_SELF)
    return used.ru_utime + used.ru_stime


def straight(goal):
    """Returns actions towards the goals."""
    bearing = numpy.arctan2(goal[:, 1], goal[:, 0])
    return numpy.stack([numpy.maximum(0.0, numpy.cos(bearing)), numpy.clip(2.0 * bearing, -1.0, 1.0)], axis=1)


def measure_robots(kind, threads, steps):
    """Prints the speed of a VecEnv."""
    env = social_crowd.VecEnv(HALL, 64, observation=kind, threads=threads)
    observation, _ = env.reset(seed=1)
    ends = 0
    begin, used = time.perf_counter(), processor_time()
    for _ in range(steps):
        observation, _, terminated, truncated, _ = env.step(straight(observation['goal']))
        ends += numpy.count_nonzero(terminated | truncated)
    seconds, used = time.perf_counter() - begin, processor_time() - used
    count = steps * env.num_envs
    print(f'VecEnv, {kind}, {threads or "all"} threads: {count / seconds:.0f} steps/s, {1e6 * used / count:.0f} us of '
          f'processor time a step, {ends} episodes ended')


def measure_crowd(pairs):
    """Prints the processor time of Crowd.step() relative to that of evaluate(), for a crowd of 1,000."""
    table, scenario = social_crowd.QTable.load('anticipation'), social_crowd.Scenario.load('crowd_random_1000')
    ratios = []
    for _ in range(pairs):
        begin = time.process_time()
        social_crowd.evaluate(table, scenario, episodes=1, seed=3, threads=1)
        middle = time.process_time()
        crowd = social_crowd.Crowd(scenario, table, seed=3)
        while crowd.step():
            pass
        ratios.append((time.process_time() - middle) / (middle - begin))
    print(f'Crowd.step() / C++, 1,000 agents: {statistics.median(ratios):.3f} ({min(ratios):.3f} to {max(ratios):.3f})')


def main():
    """Measures everything."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--steps', type=int, default=300)
    parser.add_argument('--threads', type=int, default=0, help='0: one for each processor')
    parser.add_argument('--pairs', type=int, default=9, help='of runs of the crowd')
    arguments = parser.parse_args()
    for kind in ('scan', 'people', 'grid'):
        measure_robots(kind, arguments.threads, arguments.steps)
    measure_crowd(arguments.pairs)


if __name__ == '__main__':
    main()
