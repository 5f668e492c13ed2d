"""Env, VecEnv and spaces beside the interface of Gymnasium and stable-baselines3, as stated in
test/data/gymnasium_interface.yaml, and what these packages check of environments.
"""
import copy
import inspect
import pathlib

import numpy
import pytest
import social_crowd
import yaml
from social_crowd.spaces import Box, Dict

STATED = yaml.safe_load((pathlib.Path(__file__).parents[1] / 'data' / 'gymnasium_interface.yaml').read_text())
OBSERVATIONS = ('scan', 'people', 'grid')


def objects(kind):
    """Returns an object of a part of the statement."""
    makers = {
        'env': lambda: social_crowd.Env('robot_circle_5'),
        'vector_env': lambda: social_crowd.VecEnv('robot_circle_5', 2),
        'box': lambda: Box(-1.0, 1.0, (2,)),
        'dict': lambda: Dict({'one': Box(-1.0, 1.0, (2,))}),
        'sb3_vec_env': lambda: social_crowd.SB3VecEnv(social_crowd.VecEnv('robot_circle_5', 2)),
    }
    return makers[kind]()


def parameters_of(method):
    """Returns the names of the parameters of a bound method, without those that take any."""
    names = []
    for name, parameter in inspect.signature(method).parameters.items():
        if parameter.kind not in (parameter.VAR_POSITIONAL, parameter.VAR_KEYWORD):
            names.append(f'*{name}' if parameter.kind == parameter.KEYWORD_ONLY else name)
    return names


class StatedInterfaceTest:
    """Members, and parameters of methods."""

    @pytest.mark.parametrize('kind', ['env', 'vector_env', 'box', 'dict', 'sb3_vec_env'])
    def test_members(self, kind):
        one, stated = objects(kind), STATED[kind]
        assert [name for name in stated['attributes'] if not hasattr(one, name)] == []
        parameters = {name: parameters_of(getattr(one, name)) for name in stated['methods']}
        of_any = {'sb3_vec_env': ['env_method']}.get(kind, [])
        for name, names in stated['methods'].items():
            got = parameters[name]
            if name in of_any:
                assert set(names) <= set(got), name
            else:
                assert got[:len(names)] == names or [part.lstrip('*') for part in got] == names, name

    def test_metadata(self):
        for kind in ('env', 'vector_env'):
            metadata = objects(kind).metadata
            assert set(STATED['metadata']) <= set(metadata)
            assert metadata['render_modes'] == ['rgb_array']
        mode = objects('vector_env').metadata['autoreset_mode']
        assert getattr(mode, 'value', mode) == 'SameStep'
        assert 'SameStep' in STATED['autoreset_modes']

    def test_parents_where_they_are_installed(self):
        gymnasium = pytest.importorskip('gymnasium')
        assert isinstance(objects('env'), gymnasium.Env)
        assert isinstance(objects('vector_env'), gymnasium.vector.VectorEnv)

    def test_checks_of_gymnasium(self):
        checker = pytest.importorskip('gymnasium.utils.env_checker')
        checker.check_env(objects('env'))

    def test_checks_of_stable_baselines3(self):
        checker = pytest.importorskip('stable_baselines3.common.env_checker')
        checker.check_env(objects('env'))


class SpacesTest:
    """Box and Dict."""

    def test_a_box(self):
        box = Box(numpy.array([0.0, -numpy.inf]), numpy.array([1.0, 2.0]), dtype=numpy.float32)
        assert (box.shape, box.dtype) == ((2,), numpy.float32)
        assert numpy.array([1.0, 2.0], numpy.float32) in box
        assert numpy.array([0.0, -1e9], numpy.float32) in box
        assert numpy.array([-0.1, 0.0], numpy.float32) not in box
        assert numpy.array([0.0, 2.1], numpy.float32) not in box
        assert numpy.array([0.0, numpy.nan], numpy.float32) not in box
        assert numpy.zeros(3, numpy.float32) not in box
        assert not box.is_bounded('below') and box.is_bounded('above') and not box.is_bounded()

    def test_samples(self):
        for box in (Box(-1.0, 3.0, (500,)), Box(0, 255, (500,), numpy.uint8), Box(-numpy.inf, numpy.inf, (500,)),
                    Box(2.0, numpy.inf, (500,)), Box(-numpy.inf, -2.0, (500,))):
            box.seed(5)
            first = box.sample()
            assert first in box and first.dtype == box.dtype and len(set(first.tolist())) > 50
            box.seed(5)
            numpy.testing.assert_array_equal(box.sample(), first)
        assert {0, 255} <= set(Box(0, 255, (5000,), numpy.uint8, seed=1).sample().tolist())

    def test_a_dict(self):
        space = Dict({'a': Box(0.0, 1.0, (2,)), 'b': Box(0.0, 1.0, (3,))})
        value = space.sample()
        assert value in space and set(value) == {'a', 'b'} and space['b'].shape == (3,) and len(space) == 2
        assert {'a': value['a']} not in space
        assert dict(value, c=1) not in space
        assert dict(value, a=value['b']) not in space
        space.seed(3)
        first = space.sample()
        space.seed(3)
        second = space.sample()
        assert all((first[key] == second[key]).all() for key in first)
        assert space == copy.deepcopy(space) and space != Dict({'a': Box(0.0, 1.0, (2,))})


class ReturnedValuesTest:
    """What reset() and step() return is of the spaces and types that are stated."""

    @pytest.mark.parametrize('kind', OBSERVATIONS)
    def test_env(self, kind):
        env = social_crowd.Env('robot_circle_5', observation=kind)
        observation, info = env.reset(seed=3)
        assert observation in env.observation_space and isinstance(info, dict)
        env.action_space.seed(1)
        for _ in range(20):
            returned = env.step(env.action_space.sample())
            observation, reward, terminated, truncated, info = returned
            assert len(returned) == len(STATED['returns']['step'])
            assert observation in env.observation_space
            assert type(reward) is float and type(terminated) is bool and type(truncated) is bool
            assert isinstance(info, dict) and 'episode' not in info  # a key of Gymnasium's wrappers
            if terminated or truncated:
                env.reset()

    @pytest.mark.parametrize('kind', OBSERVATIONS)
    def test_vector_env(self, kind):
        env = social_crowd.VecEnv('robot_circle_5', 3, observation=kind, contact_ends=False)
        observation, infos = env.reset(seed=3)
        assert observation in env.observation_space and isinstance(infos, dict)
        assert env.action_space.shape == (3, 3)  # its robot is holonomic
        for _ in range(20):
            observation, rewards, terminated, truncated, infos = env.step(env.action_space.sample())
            assert observation in env.observation_space
            assert (rewards.shape, rewards.dtype) == ((3,), numpy.float64)
            assert (terminated.shape, terminated.dtype) == ((3,), bool) == (truncated.shape, truncated.dtype)
            assert all(array.shape == (3,) for array in infos.values() if isinstance(array, numpy.ndarray))

    def test_ends_of_vector_env(self):
        text = SHORT.format(duration=0.3)
        env = social_crowd.VecEnv(text, 2)
        first, _ = env.reset(seed=7)
        for _ in range(2):
            assert not set(env.step(numpy.zeros((2, 2)))[4]) & set(STATED['ends_of_vector_env'])
        observation, _, terminated, truncated, infos = env.step(numpy.zeros((2, 2)))
        assert truncated.all() and not terminated.any()
        assert set(STATED['ends_of_vector_env']) <= set(infos)
        assert infos['_final_obs'].all() and infos['_final_info'].all()
        assert infos['final_obs'][1] in env.single_observation_space
        numpy.testing.assert_array_equal(infos['final_info']['tick'], [3, 3])
        numpy.testing.assert_array_equal(infos['final_info']['metrics']['success'], [False, False])
        numpy.testing.assert_array_equal(infos['tick'], [0, 0])
        assert not numpy.array_equal(observation['scan'], first['scan'])  # another draw

    def test_sb3(self):
        env = social_crowd.SB3VecEnv(social_crowd.VecEnv(SHORT.format(duration=0.3), 2))
        assert env.seed(7) == [7, 8]
        first = env.reset()
        assert env.observation_space.shape is None and first['scan'].shape == (2, 720)
        assert [info['seed'] for info in env.reset_infos] == [7, 8]
        for _ in range(2):
            _, rewards, dones, infos = env.step(numpy.zeros((2, 2)))
            assert rewards.dtype == numpy.float32 and not dones.any()
            assert not any('terminal_observation' in info for info in infos)
        _, _, dones, infos = env.step(numpy.zeros((2, 2)))
        assert dones.all()
        for info in infos:
            assert set(STATED['ends_of_sb3']) <= set(info)
            assert info['TimeLimit.truncated'] is True and info['is_success'] is False
            assert info['terminal_observation'] in env.observation_space and info['metrics']['path_length'] == 0.0
        env.seed(7)
        again = env.reset()
        assert all((first[key] == again[key]).all() for key in first)
        assert env.env_is_wrapped(object) == [False, False] and env.get_attr('num_envs', [0]) == [2]

    def test_pictures(self):
        env = social_crowd.Env('robot_circle_20', render_mode='rgb_array')
        env.reset(seed=1)
        picture = env.render()
        assert picture.ndim == 3 and picture.shape[2] == 3 and picture.dtype == numpy.uint8
        middle = picture[picture.shape[0] // 2 + 6, picture.shape[1] // 2]
        assert middle[0] > 2 * middle[2]  # the robot, which is orange
        env.step((1.0, 0.0))
        assert not numpy.array_equal(env.render(), picture)
        assert social_crowd.Env('robot_circle_20').render() is None
        frames = social_crowd.VecEnv('robot_circle_20', 2, render_mode='rgb_array')
        frames.reset(seed=1)
        assert len(frames.render()) == 2
        numpy.testing.assert_array_equal(frames.render()[0], picture)


SHORT = """
name: short
duration: {duration}
goal_tolerance: 0.3
agents:
  - {{count: 5, position: {{box: [[-5, -5], [5, 5]]}}, goal: [20, 0], speed: 1, radius: 0.25}}
robots:
  - {{name: tug, position: [9, 9], goal: [-9, 9], radius: 0.3, max_speed: 1}}
"""
