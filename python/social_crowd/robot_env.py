"""The interface of Gymnasium for one robot, with which Env and CrowdEnv differ in their backends only."""
import copy

import numpy
from social_crowd.errors import CrowdError, InputError
from social_crowd.random_seeds import EpisodeSeeds
from social_crowd.rendering import draw_robot
from social_crowd.rewards import of_robot
from social_crowd.robot_task import RobotTask

try:
    from gymnasium import Env as Base
except ImportError:

    class Base:
        """The members of gymnasium.Env."""

        metadata = {'render_modes': []}
        render_mode = None
        spec = None

        @property
        def unwrapped(self):
            """The environment itself."""
            return self

        def __enter__(self):
            return self

        def __exit__(self, *_error):
            self.close()
            return False

        def __str__(self):
            return f'<{type(self).__name__} instance>'

FRAMES_PER_SECOND = 10


def require_render_mode(mode):
    """Raises InputError unless frames can be rendered in this mode."""
    if mode not in (None, 'rgb_array'):
        raise InputError(f"render_mode: expected None or 'rgb_array', got {mode!r}")


class RobotEnv(Base):
    """One robot among people. Derived classes give the backend."""

    metadata = {'render_modes': ['rgb_array'], 'render_fps': FRAMES_PER_SECOND}

    def __init__(self, backend, *, observation, action, reward, contact_ends, render_mode):
        require_render_mode(render_mode)
        self.render_mode = render_mode
        self._task = RobotTask(backend, observation, action, reward, contact_ends)
        self.observation_space = self._task.observation_space
        self.action_space = self._task.action_space
        self._seeds = EpisodeSeeds(backend.scenario_count)
        self.np_random = self._seeds.random
        self._is_walking = False
        self._has_begun = False

    @property
    def np_random(self):
        """Generator of the seeds of episodes."""
        return self._np_random

    @np_random.setter
    def np_random(self, generator):
        self._np_random = self._seeds.random = generator
        self._np_random_seed = -1

    @property
    def np_random_seed(self):
        """Seed of `np_random`; -1 if reset() has not got one."""
        return self._np_random_seed

    @property
    def robot(self):
        """What the robot can do, and what its scanner is: a dict."""
        return dict(self._task.robot)

    @property
    def state(self):
        """All that is known of the robot, with the attributes that rewards get (docs/python.md, "Rewards")."""
        return of_robot(self._task.known(), 0)

    def reset(self, *, seed=None, options=None):
        """Begins an episode. Returns the observation and a dict of information.

        With a seed, the scenario is drawn from that seed, and later episodes from it, too: the same calls give the same
        episodes. Without one, the scenario is drawn anew.
        """
        before = copy.deepcopy(self._seeds.random)
        try:
            scenario, drawn = self._seeds.next(seed)
            self._begin(scenario, drawn, options or {})
        except BaseException:  # an episode that is refused draws no seed
            self._np_random = self._seeds.random = before
            raise
        self._np_random = self._seeds.random
        self._np_random_seed = self._np_random_seed if seed is None else drawn
        self._has_begun = self._is_walking = True
        return self._observe(), self._info()

    def step(self, action):
        """Drives at an action of `action_space` for the ticks of a step.

        Returns observation, reward, terminated (arrived, or in contact with people in this step), truncated (the
        episode is over) and a dict of information, at the end of an episode with `metrics` and `is_success`.
        """
        if not self._is_walking:
            raise CrowdError('call reset() first: no episode has begun, or the last one has ended')
        rewards, terminated, truncated = self._task.step([action])
        info = self._info()
        if terminated[0] or truncated[0]:
            self._is_walking = False
            info.update(self._task.final_info(0))
        return self._observe(), float(rewards), bool(terminated[0]), bool(truncated[0]), info

    def render(self):
        """Returns a picture of the surroundings of the robot, north up: an array (height, width, 3) of uint8.

        None without a render mode.
        """
        if self.render_mode is None:
            return None
        if not self._has_begun:
            raise CrowdError('call reset() first: no episode has begun')
        return draw_robot(self._task, 0)

    def close(self):
        """Ends the use of the environment."""

    def _begin(self, scenario, seed, options):
        raise NotImplementedError

    def _info(self):
        raise NotImplementedError

    def _observe(self):
        return {name: array[0] for name, array in self._task.observe().items()}


def no_more(options, used):
    """Raises InputError if there are options that are not used."""
    unknown = sorted(set(options) - set(used))
    if unknown:
        raise InputError(f"options: expected {', '.join(used) if used else 'none'}, got {', '.join(map(str, unknown))}")


def tick_of(task, element=0):
    """Returns the number of ticks of an episode."""
    return int(numpy.asarray(task.backend.arrays['tick'])[element])
