"""VecEnv with the interface of stable-baselines3, which differs from Gymnasium's."""
import numpy
from social_crowd.errors import CrowdError, InputError

try:
    from stable_baselines3.common.vec_env import VecEnv as Base
except ImportError:

    class Base:
        """The members of stable_baselines3.common.vec_env.VecEnv that derived classes do not have to write."""

        def __init__(self, num_envs, observation_space, action_space):
            self.num_envs = num_envs
            self.observation_space = observation_space
            self.action_space = action_space
            self.reset_infos = [{} for _ in range(num_envs)]
            self._seeds = [None for _ in range(num_envs)]
            self._options = [{} for _ in range(num_envs)]
            self.render_mode = self.get_attr('render_mode')[0]

        def step(self, actions):
            """Drives all robots."""
            self.step_async(actions)
            return self.step_wait()

        def seed(self, seed=None):
            """Sets the seeds of the next reset(). Returns them."""
            if seed is None:
                seed = int(numpy.random.default_rng().integers(2 ** 31))
            self._seeds = [seed + i for i in range(self.num_envs)]
            return self._seeds

        def set_options(self, options=None):
            """Sets the options of the next reset()."""
            options = options or {}
            self._options = options if isinstance(options, list) else [options] * self.num_envs

        @property
        def unwrapped(self):
            """The environment itself."""
            return self

        def _get_indices(self, indices):
            if indices is None:
                return range(self.num_envs)
            return [indices] if isinstance(indices, int) else indices

        def _reset_seeds(self):
            self._seeds = [None for _ in range(self.num_envs)]

        def _reset_options(self):
            self._options = [{} for _ in range(self.num_envs)]


class SB3VecEnv(Base):
    """A VecEnv for stable-baselines3: `PPO('MultiInputPolicy', SB3VecEnv(VecEnv('robot_crossing', 64)))`."""

    def __init__(self, vec_env):
        """vec_env: a VecEnv, which belongs to it from now on"""
        self.vec_env = vec_env
        self._actions = None
        super().__init__(vec_env.num_envs, vec_env.single_observation_space, vec_env.single_action_space)

    def reset(self):
        """Begins an episode in each environment. Returns the observations."""
        if any(options != self._options[0] for options in self._options):
            raise InputError('options: expected the same for all environments')
        observations, infos = self.vec_env.reset(seed=self._seeds, options=self._options[0])
        self.reset_infos = self._listed(infos)
        self._reset_seeds()
        self._reset_options()
        return observations

    def step_async(self, actions):
        """Takes the actions of the next step."""
        self._actions = actions

    def step_wait(self):
        """Drives all robots. Returns observations, rewards, whether episodes ended, and a list of dicts.

        At the end of an episode its dict has `terminal_observation`, `TimeLimit.truncated`, and what Env has.
        """
        if self._actions is None:
            raise CrowdError('call step_async() first')
        actions, self._actions = self._actions, None
        observations, rewards, terminated, truncated, infos = self.vec_env.step(actions)
        done = terminated | truncated
        listed = self._listed(infos)
        for i in numpy.flatnonzero(done):
            listed[i] = dict(_of_one(infos['final_info'], i), terminal_observation=infos['final_obs'][i])
        for info, is_cut in zip(listed, truncated):
            info['TimeLimit.truncated'] = bool(is_cut)
        return observations, rewards.astype(numpy.float32), done, listed

    def close(self):
        """Ends the use of the environments."""
        self.vec_env.close()

    def get_attr(self, attr_name, indices=None):
        """Returns the value of an attribute for each environment."""
        return [getattr(self.vec_env, attr_name) for _ in self._get_indices(indices)]

    def set_attr(self, attr_name, value, indices=None):
        """Sets an attribute of all environments."""
        if len(list(self._get_indices(indices))) != self.num_envs:
            raise InputError('set_attr: expected all environments, which share their attributes')
        setattr(self.vec_env, attr_name, value)

    def env_method(self, method_name, *method_args, indices=None, **method_kwargs):
        """Calls a method of the VecEnv. Returns its result for each environment."""
        result = getattr(self.vec_env, method_name)(*method_args, **method_kwargs)
        return [result for _ in self._get_indices(indices)]

    def env_is_wrapped(self, wrapper_class, indices=None):
        """Returns False for each environment: a VecEnv has no wrappers."""
        return [False for _ in self._get_indices(indices)]

    def get_images(self):
        """Returns a picture for each environment."""
        return list(self.vec_env.render() or [None] * self.num_envs)

    def _listed(self, infos):
        return [{name: infos[name][i].item() for name in ('episode_number', 'tick', 'seed')}
                for i in range(self.num_envs)]


def _of_one(infos, element):
    """Returns the information of one environment."""
    info = {}
    for key, value in infos.items():
        if key.startswith('_') or not infos[f'_{key}'][element]:
            continue
        if isinstance(value, dict):
            info[key] = _of_one(value, element)
        else:
            info[key] = value[element].item() if isinstance(value[element], numpy.generic) else value[element]
    return info
