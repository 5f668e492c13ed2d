#!/usr/bin/python3
"""The Python class CrowdEnv: reset, step, observations and rewards, and the same bytes as Env without ROS."""
import numpy
import social_crowd
import support
from robots import RobotTestCase, scenario
from social_crowd.crowd_env import CrowdEnv, CrowdEnvError


class CrowdEnvTest(RobotTestCase):
    """An environment with one robot."""

    def start_env(self, text, **parameters):
        """Starts the nodes and the environment."""
        self.start_all(text)
        return CrowdEnv(controller=f'{self.namespace}/crowd_controller', **parameters)

    def test_a_robot_drives_to_its_goal(self):
        env = self.start_env(scenario(more=', goal: [3, 0]'), ticks=5)
        observation, info = env.reset(seed=1)
        self.assertEqual(info['tick'], 0)
        numpy.testing.assert_array_equal(observation['goal'], [2.0, 0.0])
        self.assertEqual(observation['scan'].shape, (720,))
        rewards = []
        terminated = truncated = False
        while not terminated and not truncated:
            observation, reward, terminated, truncated, info = env.step((0.5, 0.0))
            numpy.testing.assert_array_equal(observation['velocity'], [0.5, 0.0])
            rewards.append(reward)
        self.assertTrue(terminated)
        self.assertFalse(truncated)
        # The goal counts as reached within 0.3 m: after 1.75 m.
        self.assertEqual(info['tick'], 35)
        numpy.testing.assert_allclose(rewards, [0.25] * 7, atol=1e-9)

    def test_the_reward_does_not_jump_at_a_waypoint(self):
        env = self.start_env(scenario(more=', goals: [[2, 0], [4, 0]]'), ticks=5)
        env.reset(seed=1)
        rewards = [env.step((0.5, 0.0))[1] for _ in range(8)]
        numpy.testing.assert_allclose(rewards, [0.25] * 8, atol=1e-9)

    def test_contacts_of_all_ticks_of_a_step_end_the_episode(self):
        text = scenario(more=', perceived: false').replace('[0, 20], goal: [100, 20]', '[1, -2], goal: [1, 9]')
        env = self.start_env(text.replace('solid', 'ghost'), ticks=100)
        env.reset(seed=1)
        _, reward, terminated, truncated, _ = env.step((0.0, 0.0))
        self.assertEqual((reward, terminated, truncated), (-1.0, True, False))

    def test_the_same_seed_and_actions_give_the_same_observations(self):
        env = self.start_env(scenario(more=', goal: [4, 0], scan: {rays: 50, noise: 0.02}'))

        def run(seed):
            seen = [env.reset(seed=seed)[0]] + [env.step((0.5, 0.1))[0] for _ in range(5)]
            return [array.tobytes() for one in seen for array in one.values()]

        first = run(1)
        self.assertEqual(run(1), first)
        self.assertNotEqual(run(2), first)

    def test_an_episode_that_is_over_is_truncated(self):
        env = self.start_env(scenario(duration=0.3))
        env.reset()
        self.assertEqual([env.step((0.0, 0.0))[3] for _ in range(3)], [False, False, True])
        with self.assertRaisesRegex(social_crowd.CrowdError, 'call reset'):
            env.step((0.0, 0.0))
        self.assertEqual(env.reset()[1]['tick'], 0)
        env.step((0.0, 0.0))
        self.assertEqual(env.reset()[1]['tick'], 0)  # in the middle of an episode

    def test_a_seed_determines_the_episodes_that_follow(self):
        env = self.start_env(scenario(more=', goal: [4, 0], scan: {rays: 50, noise: 0.02}'))

        def scans(seed):
            return [env.reset(seed=seed)[0]['scan'].tobytes(), env.reset()[0]['scan'].tobytes()]

        first = scans(1)
        self.assertNotEqual(first[0], first[1])
        self.assertEqual(scans(1), first)

    def test_errors(self):
        env = self.start_env(scenario())
        with self.assertRaisesRegex(social_crowd.CrowdError, 'call reset'):
            env.step((0.0, 0.0))
        env.reset()
        with self.assertRaisesRegex(social_crowd.InputError, r'expected 2 numbers \(ahead, rotation\), got shape'):
            env.step((0.0,))
        with self.assertRaisesRegex(social_crowd.InputError, 'finite'):
            env.step((float('nan'), 0.0))
        with self.assertRaisesRegex(CrowdEnvError, "no robot 'cart', only: tug"):
            CrowdEnv(robot='cart', controller=f'{self.namespace}/crowd_controller')
        with self.assertRaisesRegex(CrowdEnvError, 'is the crowd controller running'):
            CrowdEnv(controller=f'{self.namespace}/nobody', timeout=0.2)

    def test_a_robot_that_has_changed(self):
        env = self.start_env(scenario())
        env.reset()
        file = self.write('other.yaml', scenario().replace('max_speed: 1.0', 'max_speed: 2.0'))
        self.succeed('crowd_controller/load_scenario', scenario=file)
        with self.assertRaisesRegex(CrowdEnvError, "'tug' has changed"):
            env.reset()


class SameBytesTest(RobotTestCase):
    """CrowdEnv and Env return the same, bit for bit."""

    def assert_same_bytes(self, text, table, *seeds, **parameters):
        """Drives both through an episode for each seed and another one, with the same actions."""
        self.start_learner(q_table=table)
        self.start_all(text, learner=False)
        through_ros = CrowdEnv(controller=f'{self.namespace}/crowd_controller', **parameters)
        local = social_crowd.Env(text, table, **parameters)
        self.assertEqual(through_ros.action_space, local.action_space)
        self.assertEqual(through_ros.observation_space, local.observation_space)
        random = numpy.random.default_rng(3)
        ends = 0
        for seed in (*seeds, None):
            observation, info = through_ros.reset(seed=seed)
            # The gait of people depends on the number of the episode, which counts up in the controller.
            expected = local.reset(seed=seed, options={'number': info['episode_number']})
            self.assert_same((observation, info), expected)
            while True:
                action = random.uniform(0.3 * local.action_space.low, local.action_space.high)
                returned, expected = through_ros.step(action), local.step(action)
                self.assert_same(returned, expected)
                if returned[2] or returned[3]:
                    self.assertIn('metrics', returned[4])
                    ends += 1
                    break
        self.assertEqual(ends, len(seeds) + 1)
        through_ros.close()

    def assert_same(self, returned, expected):
        """Compares what reset() or step() returned."""
        for key, array in expected[0].items():
            self.assertEqual(returned[0][key].dtype, array.dtype)
            self.assertEqual(returned[0][key].tobytes(), array.tobytes(), key)
        self.assertEqual(returned[1:-1], expected[1:-1])
        numpy.testing.assert_equal(returned[-1], expected[-1])

    def test_scans(self):
        self.assert_same_bytes(AMONG_PEOPLE, 'anticipation', 5, ticks=2)

    def test_people(self):
        observation = social_crowd.Observation('people', max_people=4)
        self.assert_same_bytes(AMONG_PEOPLE, 'anticipation', 6, observation=observation, contact_ends=False)

    def test_grids(self):
        self.assert_same_bytes(AMONG_PEOPLE, 'anticipation', 7, observation='grid')

    def test_people_with_gait_and_a_holonomic_robot(self):
        text = AMONG_PEOPLE.replace('max_speed: 1', 'drive: holonomic, max_speed: 1')
        self.assert_same_bytes(text, 'human', 8, 15, 17, 22, 26, observation='people', action='velocity')

    def test_rewards_of_ones_own(self):
        def reward(before, after):
            return min(after.clearance, 9.0) - min(before.clearance, 9.0) + numpy.nanmin(after.scan) + after.pose[0]

        self.assert_same_bytes(AMONG_PEOPLE, 'anticipation', 9, reward=reward)


AMONG_PEOPLE = """
name: among_people
duration: 6
goal_tolerance: 0.3
contact: solid
agents:
  - {count: 12, position: {box: [[-4, -4], [4, 4]]}, goal: {box: [[-4, -4], [4, 4]]}, speed: [1.0, 1.5], radius: 0.25}
robots:
  - {name: tug, position: [-6, 0], goal: {box: [[4, -1], [5, 1]]}, radius: 0.3, max_speed: 1, yields: nobody,
     scan: {rays: 180, noise: 0.02, dropout: 0.05, people: legs}, odometry: {distance: 0.02}}
walls:
  - [[-7, -5], [7, -5]]
  - [[-7, 5], [7, 5]]
"""


if __name__ == '__main__':
    support.run('crowd_env_test')
