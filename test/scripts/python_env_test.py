"""Env and VecEnv: observations worked out by hand, the same bytes again, and the same results as `evaluate`."""
import math

import numpy
import pytest
import social_crowd

# A robot looks along x at a wall 2 m ahead; a person stands 1.5 m to its left, another one behind that one.
BESIDE = """
name: beside
duration: 60
goal_tolerance: 0.3
contact: solid
agents:
  - {position: [0, 1.5], goal: [0, 99], speed: 0.001, radius: 0.25}
  - {position: [0, 3.5], goal: [0, 99], speed: 0.001, radius: 0.25}
  - {position: [-1, -3], goal: [0, 99], speed: 0.001, radius: 0.25}
walls:
  - [[2, -5], [2, 5]]
robots:
  - {name: tug, position: [0, 0], heading: 0, goal: [0, 4], radius: 0.3, max_speed: 1, acceleration: 100,
     rotation_acceleration: 1000%s}
"""
# A robot drives straight ahead through people who cross its way.
CROSSING = """
name: crossing
duration: 14
goal_tolerance: 0.3
contact: solid
agents:
  - {count: 6, position: {box: [[-2, -6], [2, -3]]}, goal: {box: [[-2, 6], [2, 9]]}, speed: 1.2, radius: 0.25}
  - {count: 6, position: {box: [[-2, 3], [2, 6]]}, goal: {box: [[-2, -9], [2, -6]]}, speed: 1.2, radius: 0.25}
robots:
  - {name: tug, position: [-6, 0], goal: [6, 0], heading: 0, radius: 0.3, max_speed: 1.0, yields: nobody}
"""
SHORT = CROSSING.replace('14', '1.5').replace('radius: 0.3', 'radius: 0.3, scan: {rays: 90, noise: 0.02, dropout: 0.1}')


def beside(more='', **parameters):
    """Returns an Env of BESIDE after reset(). more: keys of the robot, after a comma"""
    env = social_crowd.Env(BESIDE % more, **parameters)
    return env, env.reset(seed=1)[0]


def bytes_of(observation):
    """Returns all bytes of an observation."""
    return b''.join(array.tobytes() for array in observation.values())


def drive(env, seed, steps):
    """Returns the bytes of all that an Env returns in several episodes, with actions drawn from a seed."""
    random = numpy.random.default_rng(17)
    seen = [bytes_of(env.reset(seed=seed)[0])]
    for _ in range(steps):
        observation, reward, terminated, truncated, info = env.step(random.uniform(-1, 1, env.action_space.shape))
        seen.append(bytes_of(observation) + numpy.float64(reward).tobytes() + bytes([terminated, truncated]))
        if terminated or truncated:
            seen.append(str(info).encode())
            seen.append(bytes_of(env.reset()[0]))
    return seen


class ObservationTest:
    """What the robot of BESIDE observes."""

    def test_scan(self):
        _, observation = beside(', scan: {rays: 4}')
        assert list(observation) == ['goal', 'velocity', 'scan']
        numpy.testing.assert_array_equal(observation['goal'], numpy.float32([0, 4]))
        numpy.testing.assert_array_equal(observation['velocity'], numpy.float32([0, 0]))
        # Behind nothing, as far as 20 m; right nothing, as the third person stands 1 m beside the ray; wall; person.
        numpy.testing.assert_array_equal(observation['scan'], numpy.float32([20, 20, 2, 1.25]))

    def test_ranges_are_finite(self):
        _, observation = beside(', scan: {rays: 4, range: [1.5, 3]}')
        numpy.testing.assert_array_equal(observation['scan'], numpy.float32([3, 3, 2, 0]))
        env, observation = beside(', scan: {rays: 500, dropout: 0.5, noise: 0.1}')
        assert observation in env.observation_space
        assert numpy.isnan(env.state.scan).sum() > 100

    def test_people_in_sight(self):
        env, observation = beside(observation=social_crowd.Observation('people', max_people=3))
        expected = numpy.zeros((3, 5))
        expected[0] = 0, 1.5, 0, 0, 0.25
        expected[1] = -1, -3, 0, 0, 0.25  # the second person is hidden behind the first one
        numpy.testing.assert_allclose(observation['people'], expected, atol=1e-6)
        assert env.state.people_count == 2
        env, observation = beside(observation=social_crowd.Observation('people', max_people=1))
        numpy.testing.assert_allclose(observation['people'], expected[:1], atol=1e-6)

    def test_people_in_the_frame_of_the_robot(self):
        env, _ = beside(', max_rotation: 20', observation='people')
        observation = env.step((0.0, 5.0 * math.pi))[0]  # a quarter of a turn to the left in 0.1 s
        numpy.testing.assert_allclose(env.state.pose, [0, 0, math.pi / 2], atol=1e-9)
        numpy.testing.assert_allclose(observation['goal'], [4, 0], atol=1e-6)
        numpy.testing.assert_allclose(observation['velocity'], [0, 5.0 * math.pi], rtol=1e-6)
        numpy.testing.assert_allclose(observation['people'][0], [1.5, 0, 0, 0, 0.25], atol=2e-3)

    def test_grid(self):
        env, observation = beside(observation=social_crowd.Observation('grid', cells=61, resolution=0.1))
        grid = observation['grid'][0]
        row, column = 30, 30  # of the robot

        def at(ahead, left):
            return grid[row + round(10 * ahead), column + round(10 * left)]

        assert (at(2.0, 0.0), at(2.0, -1.0)) == (255, 255)  # wall
        assert (at(1.0, 0.0), at(-2.0, 0.0), at(0.0, -2.0)) == (0, 0, 0)
        assert (at(2.5, 0.0), at(0.0, 2.0)) == (128, 128)  # behind the wall and the person
        assert at(0.0, 1.3) == 255  # rim of the person at 1.25 m
        assert env.observation_space['grid'].shape == (1, 61, 61)

    def test_half_a_circle_does_not_see_what_is_behind(self):
        _, observation = beside(', scan: {rays: 181, angles: [-90, 90]}',
                                observation=social_crowd.Observation('grid', cells=21, resolution=0.1))
        assert (observation['grid'][0][:9] == 128).all() and (observation['grid'][0][15:] == 0).all()

    def test_holonomic_robots(self):
        env, observation = beside(', drive: holonomic')
        assert (env.action_space.shape, observation['velocity'].shape) == ((3,), (3,))
        observation = env.step((0.0, 0.5, 0.0))[0]
        numpy.testing.assert_allclose(observation['velocity'], [0, 0.5, 0])
        env, _ = beside(', drive: holonomic', action='velocity')
        numpy.testing.assert_array_equal(env.action_space.high, numpy.float32([1, 1]))
        env.step((0.0, 0.5))
        numpy.testing.assert_allclose(env.state.pose, [0, 0.05, 0], atol=1e-12)

    def test_ticks(self):
        env, _ = beside(ticks=5)
        env.step((1.0, 0.0))
        assert env.state.tick == 5
        numpy.testing.assert_allclose(env.state.pose, [0.5, 0, 0])


class RewardTest:
    """Rewards and ends of episodes."""

    def test_progress(self):
        env, _ = beside(', max_rotation: 20')
        env.step((0.0, 5.0 * math.pi))
        _, reward, terminated, _, _ = env.step((1.0, 0.0))
        assert reward == pytest.approx(0.1, abs=1e-6) and not terminated

    def test_contacts(self):
        def run(contact_ends):
            env, _ = beside(', max_rotation: 20', contact_ends=contact_ends)
            env.step((0.0, 5.0 * math.pi))
            for step in range(30):
                _, reward, terminated, _, info = env.step((1.0, 0.0))
                if env.state.contacts:
                    return step, reward, terminated, info
            return None

        step, reward, terminated, info = run(True)
        assert step == 9 and terminated and -1.0 <= reward < -0.89  # 1.5 m - 0.25 m - 0.3 m, 0.1 m in a step
        assert info['is_success'] is False and info['metrics']['robot_on_person_collisions'] == 1
        assert run(False)[:2] == (step, reward) and run(False)[2] is False

    def test_a_function_of_ones_own(self):
        def reward(before, after):
            return 10.0 * (after.tick - before.tick) + (after.clearance < 5.0) - numpy.nanmin(after.scan)

        env, _ = beside(', scan: {rays: 4}', reward=reward, ticks=2)
        expected = 10.0 * 2 + 1 - 1.25
        assert env.step((0.0, 0.0))[1] == pytest.approx(expected, abs=1e-3)  # the person walks at 1 mm/s
        many = social_crowd.VecEnv(BESIDE % ', scan: {rays: 4}', 2, reward=social_crowd.each_robot(reward), ticks=2)
        many.reset(seed=1)
        numpy.testing.assert_allclose(many.step(numpy.zeros((2, 2)))[1], [expected] * 2, atol=1e-3)

    def test_arrival(self):
        env = social_crowd.Env(CROSSING.replace('count: 6', 'count: 1'), contact_ends=False)
        env.reset(seed=1)
        terminated = truncated = False
        while not terminated and not truncated:
            _, _, terminated, truncated, info = env.step((1.0, 0.0))
        assert terminated and not truncated and info['metrics']['success'] is True
        assert info['metrics']['time_to_reach_goal'] == pytest.approx(0.1 * info['tick'])


class SameBytesTest:
    """The same seed and actions give the same bytes."""

    @pytest.mark.parametrize('kind', ['scan', 'people', 'grid'])
    def test_again(self, kind):
        first = drive(social_crowd.Env(SHORT, observation=kind), 3, 60)
        assert drive(social_crowd.Env(SHORT, observation=kind), 3, 60) == first
        assert drive(social_crowd.Env(SHORT, observation=kind), 4, 60) != first

    def test_the_gait_depends_on_the_number_of_the_episode(self):
        def walk(**options):
            env = social_crowd.Env('robot_circle_20', 'human')
            env.reset(seed=1, options=options)
            return [bytes_of(env.step((1.0, 0.0))[0]) for _ in range(10)]

        assert walk() == walk(episode=0, number=0) != walk(number=1)

    @pytest.mark.parametrize('threads', [1, 2, 5])
    def test_elements_of_a_vec_env_are_envs(self, threads):
        """Over several episodes, with actions of their own."""
        random = numpy.random.default_rng(23)
        actions = random.uniform(-1, 1, (40, 7, 2))
        many = social_crowd.VecEnv([SHORT, SHORT.replace('count: 6', 'count: 2')], 7, threads=threads)
        ones = [social_crowd.Env([SHORT, SHORT.replace('count: 6', 'count: 2')]) for _ in range(7)]
        observations, infos = many.reset(seed=11)
        for i, one in enumerate(ones):
            observation, info = one.reset(seed=11 + i)
            assert bytes_of(observation) == bytes_of({key: array[i] for key, array in observations.items()})
            assert info == {key: array[i] for key, array in infos.items()}
        ends = 0
        for row in actions:
            observations, rewards, terminated, truncated, infos = many.step(row)
            for i, one in enumerate(ones):
                observation, *rest, info = one.step(row[i])
                assert rest == [rewards[i], terminated[i], truncated[i]]
                if rest[1] or rest[2]:
                    ends += 1
                    assert bytes_of(infos['final_obs'][i]) == bytes_of(observation)
                    for name, value in info['metrics'].items():
                        numpy.testing.assert_equal(infos['final_info']['metrics'][name][i], value, name)
                    observation, _ = one.reset()
                assert bytes_of(observation) == bytes_of({key: array[i] for key, array in observations.items()})
        assert ends >= 14

    def test_reset_mask(self):
        many = social_crowd.VecEnv(SHORT, 3)
        many.reset(seed=1)
        many.step(numpy.zeros((3, 2)))
        before = many.state.pose.copy()
        many.step(numpy.ones((3, 2)))
        many.reset(seed=1, options={'reset_mask': numpy.array([True, False, True])})
        numpy.testing.assert_array_equal(many.state.tick, [0, 2, 0])
        assert many.state.pose[1, 0] > before[1, 0]

    def test_no_copies(self):
        many = social_crowd.VecEnv(SHORT, 3)
        many.reset(seed=1)
        scan = many.state.scan
        assert scan.shape == (3, 90) and not scan.flags.writeable and numpy.shares_memory(scan, many.state.scan)
        before = scan.copy()
        observations = many.step(numpy.ones((3, 2)))[0]
        assert not numpy.array_equal(scan, before, equal_nan=True)
        assert not numpy.shares_memory(observations['scan'], scan)  # those are the user's
        del many
        assert scan.shape == (3, 90)


class EvaluateTest:
    """The same driver gives the same results as in `evaluate`."""

    @pytest.mark.parametrize('table', ['anticipation', 'human'])
    def test_straight_ahead(self, table):
        evaluated = social_crowd.evaluate(table, CROSSING, episodes=4, seed=33, robot='straight')
        env = social_crowd.Env(CROSSING, table, contact_ends=False)
        collisions = 0
        for number, episode in enumerate(evaluated.episodes):
            env.reset(seed=33, options={'episode': number})
            terminated = truncated = False
            while not terminated and not truncated:
                action = (min(1.0, env.state.goal[0]), 0.0)
                _, _, terminated, truncated, info = env.step(action)
            robot, = episode['robots']
            assert robot.pop('name') == 'tug' == env.robot['name']
            numpy.testing.assert_equal(info['metrics'], robot)
            collisions += robot['robot_on_person_collisions'] + robot['person_on_robot_collisions']
        assert collisions > 0


class ErrorTest:
    """Bad input gets an error that says what was expected."""

    @pytest.mark.parametrize('arguments, keywords, said', [
        (('robot_cirle_5',), {}, "no scenario 'robot_cirle_5', did you mean"),
        (('circle6',), {}, 'the scenario has no robot'),
        (('robot_circle_5',), {'robot': 'cart'}, "there is no robot 'cart', only: robot"),
        (('robot_circle_5',), {'robot': 5}, 'robot: expected a name'),
        (('robot_circle_5', 'nothing'), {}, "no Q-table 'nothing'"),
        (('robot_circle_5',), {'ticks': 0}, 'ticks: expected at least 1, got 0'),
        (('robot_circle_5',), {'observation': 'lidar'}, "observation: expected scan, people or grid, got 'lidar'"),
        (('robot_circle_5',), {'action': 'force'}, "action: expected twist or velocity, got 'force'"),
        (('robot_circle_20',), {'action': 'velocity'}, 'drive: holonomic'),
        (('robot_circle_5',), {'render_mode': 'human'}, "render_mode: expected None or 'rgb_array', got 'human'"),
        (([],), {}, 'expected at least one'),
        ((['robot_circle_5', BESIDE % ', scan: {rays: 9}'],), {}, 'of the first scenario'),
    ])
    def test_construction(self, arguments, keywords, said):
        with pytest.raises(social_crowd.InputError, match=said):
            social_crowd.Env(*arguments, **keywords)
        with pytest.raises(social_crowd.InputError, match=said):
            social_crowd.VecEnv(arguments[0], 2, *arguments[1:], **keywords)

    @pytest.mark.parametrize('action, said', [
        ((1.0,), r'action: expected 2 numbers \(ahead, rotation\), got shape \(1, 1\)'),
        ((1.0, 0.0, 0.0), 'expected 2 numbers'),
        ((math.nan, 0.0), 'action: expected finite numbers'),
        ((math.inf, 0.0), 'action: expected finite numbers'),
        (('fast', 'left'), 'action: expected numbers'),
        (None, 'action: expected'),
    ])
    def test_actions(self, action, said):
        env, _ = beside()
        with pytest.raises(social_crowd.InputError, match=said):
            env.step(action)
        assert env.state.tick == 0  # nothing has moved
        env.step((0.0, 0.0))

    def test_order_of_calls(self):
        env = social_crowd.Env(SHORT)
        for call in (lambda: env.step((0.0, 0.0)), social_crowd.Env(SHORT, render_mode='rgb_array').render,
                     lambda: social_crowd.VecEnv(SHORT, 2).step(numpy.zeros((2, 2)))):
            with pytest.raises(social_crowd.CrowdError, match='call reset'):
                call()
        env.reset(seed=1)
        while not any(env.step((0.0, 0.0))[2:4]):
            pass
        with pytest.raises(social_crowd.CrowdError, match='call reset'):
            env.step((0.0, 0.0))

    def test_resets(self):
        env = social_crowd.Env(SHORT)
        with pytest.raises(social_crowd.InputError, match='seed: expected at least 0, got -1'):
            env.reset(seed=-1)
        with pytest.raises(social_crowd.InputError, match='options: expected episode, number, got episodes'):
            env.reset(options={'episodes': 1})
        env.reset(seed=3)
        expected = env.reset()[1]['seed']
        env.reset(seed=3)
        for seed in (None, 5):
            with pytest.raises(social_crowd.InputError):
                env.reset(seed=seed, options={'number': -1})
        assert env.reset()[1]['seed'] == expected  # what was refused has drawn no seed
        many = social_crowd.VecEnv(SHORT, 2)
        with pytest.raises(social_crowd.InputError, match='seed: expected 2 numbers, got 3'):
            many.reset(seed=[1, 2, 3])
        with pytest.raises(social_crowd.InputError, match='reset_mask: expected an array of 2 bool'):
            many.reset(options={'reset_mask': [1, 0]})
        with pytest.raises(social_crowd.InputError, match='reset_mask: no episode has begun'):
            many.reset(options={'reset_mask': [True, False]})
        with pytest.raises(social_crowd.InputError, match='num_envs: expected at least 1'):
            social_crowd.VecEnv(SHORT, 0)

    def test_a_scenario_without_space(self):
        full = SHORT.replace('position: {box: [[-2, 3], [2, 6]]}', 'position: {box: [[-6, -0.1], [-5.9, 0.1]]}')
        with pytest.raises(social_crowd.InputError, match='no free place'):
            social_crowd.Env(full)

    def test_rewards(self):
        many = social_crowd.VecEnv(SHORT, 3, reward=lambda before, after: 1.0)
        many.reset(seed=1)
        with pytest.raises(social_crowd.InputError, match=r'reward: expected an array of 3 numbers, got shape \(\)'):
            many.step(numpy.zeros((3, 2)))
        for returned, said in ((None, 'None'), (float('nan'), 'nan'), ('x', "'x'")):
            env, _ = beside(reward=lambda before, after, returned=returned: returned)
            with pytest.raises(social_crowd.InputError, match=f'reward: expected a number, got {said}'):
                env.step((0.0, 0.0))
        with pytest.raises(social_crowd.InputError, match='reward: expected a function, got 5'):
            social_crowd.Env(SHORT, reward=5)
