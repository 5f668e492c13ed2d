"""Robots in episodes of this process."""
import numpy
from social_crowd import _core
from social_crowd.checks import whole_number
from social_crowd.errors import InputError
from social_crowd.inputs import as_scenario, as_table
from social_crowd.observations import Observation


def scenario_list(given):
    """Returns a list of Scenarios. given: one scenario, or a list of them, see as_scenario(); dicts are one scenario"""
    if not isinstance(given, (list, tuple)) or given and all(isinstance(document, dict) for document in given):
        return [as_scenario(given)]
    return [as_scenario(one) for one in given]


class LocalRobots:
    """The backend of Env and VecEnv, see robot_task.py."""

    def __init__(self, scenario, table, size, *, is_batch, robot, ticks, observation, threads):
        of = Observation.of(observation)
        scenarios = scenario_list(scenario)
        if not isinstance(robot, str):
            raise InputError(f'robot: expected a name, got {robot!r}')
        self.is_batch = is_batch
        self.scenario_count = len(scenarios)
        self._batch = _core.RobotBatch(scenarios, as_table(table), size, robot, whole_number('ticks', ticks, least=1),
                                       of.needs_scan or bool(of.max_people), of.max_people, threads)
        self.robot = self._batch.robot
        self.arrays = self._batch.arrays()
        self.begin, self.step, self.result = self._batch.begin, self._batch.step, self._batch.result

    def scene(self, element):
        """Returns what render() shows besides what the robot knows: positions and radii of people, and walls."""
        positions, radii, statuses = self._batch.agents(element)
        present = (statuses == 0) | (statuses == 3)
        return positions[present], radii[present], numpy.asarray(self._batch.walls(element))
