"""What Env, VecEnv and CrowdEnv have in common: spaces, observations, commands, rewards and ends of episodes.

Each of them has a backend, which walks the simulator and has
    robot: a dict that describes the robot
    arrays: a dict of arrays with an element or a row for each robot, which begin() and step() overwrite
    begin(starts): begins episodes; of each the element, scenario, seed, instance and number
    step(commands): walks a step with ahead, left, rotation of each robot
    result(element): the metrics of a robot by name
"""
import types

import numpy
from social_crowd.errors import InputError
from social_crowd.observations import Observation
from social_crowd.rewards import of_robot
from social_crowd.spaces import Box


class RobotTask:
    """Drives the robots of a backend."""

    def __init__(self, backend, observation, action, reward, contact_ends):
        self.backend = backend
        self.robot = robot = rounded(backend.robot)
        self._observer = Observation.of(observation).observer(robot)
        if not callable(reward):
            raise InputError(f'reward: expected a function, got {reward!r}')
        self._reward = reward
        self._contact_ends = contact_ends
        speed, turn = robot['max_speed'], robot['max_rotation']
        is_holonomic = robot['drive'] == 'holonomic'
        if action == 'twist':
            self._parts = (0, 1, 2) if is_holonomic else (0, 2)
        elif action == 'velocity' and is_holonomic:
            self._parts = (0, 1)
        elif action == 'velocity':
            raise InputError(f"action: velocity needs a robot with drive: holonomic, {robot['name']!r} has "
                             f"{robot['drive']}")
        else:
            raise InputError(f'action: expected twist or velocity, got {action!r}')
        limits = numpy.array([speed, speed, turn], numpy.float32)[list(self._parts)]
        self.action_space = Box(-limits, limits, dtype=numpy.float32)
        self.observation_space = self._observer.space

    def observe(self):
        """Returns observations: a dict of new arrays with a row for each robot."""
        return self._observer.observe(self.backend.arrays)

    def known(self):
        """Returns a copy of all that is known of the robots: a dict of arrays."""
        return {name: array.copy() for name, array in self.backend.arrays.items()}

    def commands(self, actions):
        """Returns the commands of the actions, a row for each robot. Raises InputError unless they are such actions."""
        shape = (len(self.backend.arrays['tick']), len(self._parts))
        try:
            given = numpy.asarray(actions, dtype=float)
        except (TypeError, ValueError):
            raise InputError(f'action: expected numbers, got {actions!r}') from None
        if given.shape != shape:
            raise InputError(f"action: expected {shape[1]} numbers ({', '.join(self._names())})"
                             f'{f" for each of {shape[0]} robots" if shape[0] > 1 else ""}, got shape {given.shape}')
        if not numpy.isfinite(given).all():
            raise InputError(f'action: expected finite numbers, got {actions!r}')
        commands = numpy.zeros((shape[0], 3))
        commands[:, self._parts] = given
        return commands

    def step(self, actions):
        """Walks a step. Returns rewards, terminated and truncated: arrays; a reward of one robot is a number."""
        commands = self.commands(actions)
        before = self.known()
        self.backend.step(commands)
        after = self.known()
        rewards = self._rewards(before, after)
        terminated = self.backend.arrays['arrived'].copy()
        if self._contact_ends:
            terminated |= self.backend.arrays['contacts'] > 0
        return rewards, terminated, self.backend.arrays['over'] & ~terminated

    def final_info(self, element):
        """Returns what is known at the end of an episode: whether it arrived without contact, and its metrics."""
        metrics = self.backend.result(element)
        return {'is_success': bool(metrics['success'] and metrics['people_contacts'] == 0), 'metrics': metrics}

    def _names(self):
        return [('ahead', 'left', 'rotation')[part] for part in self._parts]

    def _rewards(self, before, after):
        count = len(after['tick'])
        if not self.backend.is_batch:
            rewards = self._reward(of_robot(before, 0), of_robot(after, 0))
        else:
            rewards = self._reward(types.SimpleNamespace(**before), types.SimpleNamespace(**after))
        shape = (count,) if self.backend.is_batch else ()
        expected = f'expected {f"an array of {count} numbers" if shape else "a number"}'
        try:
            numbers = numpy.asarray(rewards, dtype=float)
        except (TypeError, ValueError):
            raise InputError(f'reward: {expected}, got {rewards!r}') from None
        if numbers.shape != shape and rewards is not None:
            raise InputError(f'reward: {expected}, got shape {numbers.shape}; see social_crowd.each_robot')
        if not numpy.isfinite(numbers).all():
            raise InputError(f'reward: {expected}, got {rewards!r}')
        return numbers


def rounded(robot):
    """Returns a description with the numbers of its scanner as the message of ROS has them: of single precision."""
    single = ('first_angle', 'angle_increment', 'min_range', 'max_range')
    return {name: float(numpy.float32(value)) if name in single else value for name, value in robot.items()}
