"""Many robots among people, in episodes of their own, side by side on threads, without ROS."""
import types

import numpy
from social_crowd.checks import whole_number
from social_crowd.env import EPISODE_OPTIONS, start_of
from social_crowd.errors import CrowdError, InputError
from social_crowd.local_robots import LocalRobots
from social_crowd.random_seeds import EpisodeSeeds
from social_crowd.rendering import draw_robot
from social_crowd.rewards import progress_reward
from social_crowd.robot_env import FRAMES_PER_SECOND, no_more, require_render_mode
from social_crowd.robot_task import RobotTask
from social_crowd.spaces import batched
from social_crowd.vector_infos import add_info

try:
    from gymnasium.vector import VectorEnv as Base
except ImportError:

    class Base:
        """The members of gymnasium.vector.VectorEnv."""

        metadata = {}
        render_mode = None
        spec = None
        closed = False

        @property
        def unwrapped(self):
            """The environment itself."""
            return self

        def close(self, **options):
            """Ends the use of the environments."""
            if not self.closed:
                self.close_extras(**options)
                self.closed = True

        def __repr__(self):
            return f'{type(self).__name__}(num_envs={self.num_envs})'

try:
    from gymnasium.vector import AutoresetMode
    SAME_STEP = AutoresetMode.SAME_STEP
except ImportError:
    SAME_STEP = 'SameStep'  # the value of AutoresetMode.SAME_STEP


class VecEnv(Base):
    """Drives one robot in each of many episodes. The interface is that of gymnasium.vector.VectorEnv.

    Element i gives the same observations and rewards, bit for bit, as an Env with its seed and actions, whatever the
    number of threads. An episode that has ended begins anew in the same step: the observation is the first one of the
    next episode, and `infos` has the last one (`final_obs`) and its information (`final_info`).
    """

    metadata = {'render_modes': ['rgb_array'], 'render_fps': FRAMES_PER_SECOND, 'autoreset_mode': SAME_STEP}

    def __init__(self, scenario, num_envs, table='anticipation', *, robot='', ticks=1, observation='scan',
                 action='twist', reward=progress_reward, contact_ends=True, threads=0, render_mode=None):
        """Reads the scenario; arguments are those of Env.

        num_envs: number of episodes side by side
        reward: gets arrays with an element for each robot, and returns an array, see rewards.py
        threads: that share the episodes; 0: one for each processor. Results do not depend on it
        """
        require_render_mode(render_mode)
        self.render_mode = render_mode
        self.num_envs = whole_number('num_envs', num_envs, least=1)
        backend = LocalRobots(scenario, table, self.num_envs, is_batch=True, robot=robot, ticks=ticks,
                              observation=observation, threads=whole_number('threads', threads))
        self._task = RobotTask(backend, observation, action, reward, contact_ends)
        self.single_observation_space = self._task.observation_space
        self.single_action_space = self._task.action_space
        self.observation_space = batched(self.single_observation_space, self.num_envs)
        self.action_space = batched(self.single_action_space, self.num_envs)
        self._seeds = [EpisodeSeeds(backend.scenario_count) for _ in range(self.num_envs)]
        self._has_begun = False
        self._numbers = numpy.zeros(self.num_envs, numpy.int64)  # of the episodes
        self._drawn = numpy.zeros(self.num_envs, numpy.int64)  # their seeds

    @property
    def robot(self):
        """What the robots can do, and what their scanner is: a dict."""
        return dict(self._task.robot)

    @property
    def state(self):
        """All that is known of the robots, with the attributes that rewards get: read-only arrays without copies, which
        reset() and step() overwrite.
        """
        return types.SimpleNamespace(**self._task.backend.arrays)

    def reset(self, *, seed=None, options=None):
        """Begins an episode in each environment. Returns observations and a dict of information.

        seed: of the first environment, one more for each of the others; or a list of seeds, of which some may be None
        options: those of Env, for all, or a list with one for each environment; `reset_mask`: an array of bool: which
            environments begin anew, others go on
        """
        options = dict(options or {})
        mask = options.pop('reset_mask', None)
        no_more(options, EPISODE_OPTIONS)
        which = range(self.num_envs) if mask is None else self._masked(mask)
        seeds = self._seeds_of(seed)
        each = {name: self._one_each(name, value) for name, value in options.items()}
        self._begin([(i, seeds[i], {name: values[i] for name, values in each.items()}) for i in which])
        return self._task.observe(), self._infos()

    def step(self, actions):
        """Drives all robots at an array of actions, a row for each.

        Returns observations, rewards, terminations, truncations (see Env) and infos: arrays with an element or a row
        for each environment.
        """
        if not self._has_begun:
            raise CrowdError('call reset() first: no episode has begun')
        rewards, terminated, truncated = self._task.step(actions)
        observations = self._task.observe()
        ended = numpy.flatnonzero(terminated | truncated)
        if len(ended) == 0:
            return observations, rewards, terminated, truncated, self._infos()
        final = {}
        for i in ended:
            info = dict(self._info(i), **self._task.final_info(i))
            last = {name: array[i].copy() for name, array in observations.items()}
            add_info(final, {'final_obs': last, 'final_info': info}, i, self.num_envs)
        self._begin([(i, None, {}) for i in ended])
        return self._task.observe(), rewards, terminated, truncated, dict(self._infos(), **final)

    def render(self):
        """Returns a picture for each environment, see Env.render(); None without a render mode."""
        if self.render_mode is None:
            return None
        if not self._has_begun:
            raise CrowdError('call reset() first: no episode has begun')
        return tuple(draw_robot(self._task, i) for i in range(self.num_envs))

    def close_extras(self, **_options):
        """Called by close()."""

    def _begin(self, elements):
        """Begins episodes. elements: an element, a seed or None, and options of each"""
        starts = [start_of(int(i), *self._seeds[i].next(seed), options) for i, seed, options in elements]
        self._task.backend.begin(starts)
        self._has_begun = True
        for element, _, seed, _, number in starts:
            self._numbers[element] = number
            self._drawn[element] = seed

    def _seeds_of(self, seed):
        if seed is None or numpy.ndim(seed) > 0:
            return self._one_each('seed', seed)
        return [whole_number('seed', seed) + i for i in range(self.num_envs)]

    def _one_each(self, name, given):
        """Returns a list with a value for each environment. given: such a list, or one value for all"""
        if numpy.ndim(given) == 0:
            return [given] * self.num_envs
        if len(given) != self.num_envs:
            raise InputError(f'{name}: expected {self.num_envs} numbers, got {len(given)}')
        return list(given)

    def _masked(self, mask):
        mask = numpy.asarray(mask)
        if mask.shape != (self.num_envs,) or mask.dtype != bool:
            raise InputError(f'reset_mask: expected an array of {self.num_envs} bool, got {mask.dtype} of shape '
                             f'{mask.shape}')
        if not self._has_begun and not mask.all():
            raise InputError('reset_mask: no episode has begun, so all environments must begin one')
        return numpy.flatnonzero(mask)

    def _info(self, element):
        return {name: array[element] for name, array in self._infos().items()}

    def _infos(self):
        return {'episode_number': self._numbers.copy(), 'tick': self._task.backend.arrays['tick'].astype(numpy.int64),
                'seed': self._drawn.copy()}
