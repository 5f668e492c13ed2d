#!/usr/bin/python3
"""The Python class CrowdEnv: reset, step, observations and rewards."""
import numpy
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
        with self.assertRaisesRegex(CrowdEnvError, 'call reset'):
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
        with self.assertRaisesRegex(CrowdEnvError, 'call reset'):
            env.step((0.0, 0.0))
        env.reset()
        with self.assertRaisesRegex(CrowdEnvError, 'expected 2 or 3 numbers, got 1'):
            env.step((0.0,))
        with self.assertRaisesRegex(CrowdEnvError, 'finite'):
            env.step((float('nan'), 0.0))
        other = CrowdEnv(robot='cart', controller=f'{self.namespace}/crowd_controller')
        with self.assertRaisesRegex(CrowdEnvError, "no robot 'cart', only: tug"):
            other.reset()
        with self.assertRaisesRegex(CrowdEnvError, 'is the crowd controller running'):
            CrowdEnv(controller=f'{self.namespace}/nobody', timeout=0.2)


if __name__ == '__main__':
    support.run('crowd_env_test')
