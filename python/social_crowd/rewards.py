"""Rewards of robots.

A reward is a function of what is known of the robot before and after a step: two objects with the attributes of
docs/python.md, "Rewards". In Env and CrowdEnv the attributes are those of one robot, in VecEnv arrays with an element
or a row for each robot, for which the function returns an array; functions of NumPy work for both.
"""
import types

import numpy


def progress_reward(before, after):
    """Returns by how much the way via the remaining goals became shorter [m], minus 1 in contact with people.

    A goal counts as reached within its tolerance, so the way may become shorter there by up to twice the tolerance.
    """
    return before.remaining_distance - after.remaining_distance - (after.contacts > 0)


def each_robot(reward):
    """Returns a reward for VecEnv that calls `reward` for each robot, with the attributes of that robot."""
    def all_robots(before, after):
        if numpy.ndim(after.contacts) == 0:
            return reward(before, after)
        return numpy.array([reward(of_robot(vars(before), i), of_robot(vars(after), i))
                            for i in range(len(after.contacts))], dtype=float)
    return all_robots


def of_robot(arrays, i):
    """Returns what is known of robot `i`. arrays: a dict of arrays"""
    return types.SimpleNamespace(**{name: array[i] for name, array in arrays.items()})
