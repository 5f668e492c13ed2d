"""What is to be shown, by the parameters of the node."""
import math
import os
import pathlib
import typing

import rospkg
import rospy
import yaml
from crowd_drawing.errors import InputError
from crowd_drawing.files import find_scenario

STATE_SETS = {1: 'nearest', 2: 'occupancy'}  # of the thesis, by the names of their training configurations
FAST, WATCHED = 'fast', 'watched'


class Plan(typing.NamedTuple):
    """Arguments of thesis.launch."""
    states: str  # nearest or occupancy
    scenario: str  # of the crowd: a file, or a name
    training: str  # fast or watched
    training_episodes: int  # with one obstacle; among several obstacles there are twice as many
    training_factor: str  # of real time, of a training that is watched
    learning: bool  # whether the crowd goes on learning
    episodes: int  # of the crowd
    ends: bool  # with the last episode; otherwise the crowd walks on
    seed: int
    real_time_factor: str  # of the crowd
    epsilon: typing.Any  # of the training; None: that of the configuration
    crowd_epsilon: float
    answer_deadline: float  # [s]
    folder: pathlib.Path  # of all files

    def file(self, name):
        return str(self.folder / name)


class Parameters:
    """Reads private parameters and collects what is wrong."""

    def __init__(self):
        self.problems = []

    def read(self, name, default, fits, expected):
        """Returns a parameter; the default if it is not set, is empty, or does not fit."""
        value = rospy.get_param('~' + name, '')
        if value == '':
            return default
        if fits(value):
            return value
        self.problems.append(f"~{name}: expected {expected}, got '{value}'")
        return default

    def one_of(self, name, default, values):
        return self.read(name, default, lambda value: value in values and not isinstance(value, bool),
                         ' or '.join(map(str, values)))

    def flag(self, name, default):
        return self.read(name, default, lambda value: isinstance(value, bool), 'true or false')

    def whole(self, name, default, least):
        return int(self.read(name, default, lambda value: is_number(value) and value >= least and value == int(value),
                             f'a whole number from {least}'))

    def number(self, name, default, low, high):
        return self.read(name, default, lambda value: is_number(value) and low <= value <= high,
                         f'a number from {low:g} to {high:g}')

    def factor(self, name, default):
        """Returns a factor of real time, as the crowd controller takes it."""
        return str(self.read(name, default, lambda value: value == FAST or is_number(value) and 0 <= value <= 1e6,
                             f"'{FAST}' or a number from 0 to 1e+06"))

    def parsed(self, name):
        """Returns a parameter; a text is read as YAML. None if it is not set, or is not YAML."""
        value = rospy.get_param('~' + name, '')
        try:
            return yaml.safe_load(value) if isinstance(value, str) else value
        except (yaml.YAMLError, ValueError) as error:  # ValueError: a date that does not exist
            self.problems.append(f"~{name}: not YAML: {' '.join(str(error).split())}")
            return None

    def scenario(self, name, default):
        value = str(rospy.get_param('~' + name, '') or default)
        try:
            find_scenario(value)
        except InputError as error:
            self.problems.append(f'~{name}: {error}')
        return value


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)


def read_plan():
    """Returns the Plan. Raises InputError with all parameters that are wrong."""
    read = Parameters()
    folder = rospy.get_param('~data_folder', '') or os.path.join(rospkg.get_ros_home(), 'social_crowd', 'thesis')
    plan = Plan(
        states=STATE_SETS[read.one_of('state_set', 2, tuple(STATE_SETS))],
        scenario=read.scenario('scenario', 'circle12_varied'),
        training=read.one_of('training', FAST, (FAST, WATCHED)),
        training_episodes=read.whole('training_episodes', 2000, 1),
        training_factor=read.factor('training_factor', FAST),
        learning=read.flag('learning', False),
        episodes=read.whole('episodes', 5, 1),
        ends=read.flag('ends', False),
        seed=read.whole('seed', 1, 0),
        real_time_factor=read.factor('real_time_factor', '4'),
        # A number, or a schedule, which the learner checks as a part of its configuration.
        epsilon=read.parsed('epsilon'),
        crowd_epsilon=read.number('crowd_epsilon', 0.01, 0, 1),
        answer_deadline=read.number('answer_deadline', 1.0, 0.001, 3600),
        folder=pathlib.Path(folder).absolute())
    if read.problems:
        raise InputError('\n'.join(read.problems))
    return plan
