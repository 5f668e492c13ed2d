#!/usr/bin/python3
"""Metrics and recordings of robots: through ROS the same as those of `evaluate`, bit for bit."""
import csv
import io
import json
import math

import support
from robots import RobotTestCase, command, scenario
from social_crowd.msg import EpisodeResult, RobotResult

# Two robots drive straight ahead through people who cross their way; only one gets to its goal in time.
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
  - {name: cart, position: [-5, 1], goal: [15, 1], heading: 0, max_speed: 0.5,
     footprint: [[-0.4, -0.3], [0.4, -0.3], [0.4, 0.3], [-0.4, 0.3]]}
"""
SPEEDS = {'tug': 1.0, 'cart': 0.5}
METRICS = {'progress_distance': 0.6, 'progress_time': 1.0, 'stalled_speed': 0.1}  # the second one does 0.5 m in 1 s
SEED = 1  # the first robot and a person touch
# Files of the controller, and the same of `evaluate`.
RECORDED = {'robot.csv': 'headless/crossing.csv', 'robot.jsonl': 'headless.jsonl'}
# `evaluate --people-delay` compares two runs.
WITHOUT_ROS = {'people_compared', 'people_delay', 'people_detour'}


def straight(observed):
    """Returns the command of `evaluate --robot straight` for a robot whose goal lies straight ahead."""
    if observed.arrived:
        return command(0.0)
    return command(SPEEDS[observed.name] * min(1.0, observed.goal.x))


class RobotResultsTest(RobotTestCase):
    """What is published and logged at the end of an episode."""

    def headless_rows(self, file):
        """Returns the rows of `evaluate --robots-csv` by robot; also records."""
        table = self.path('robots.csv')
        options = [word for name, value in METRICS.items() for word in (f'--{name.replace("_", "-")}', value)]
        self.tool('evaluate', '--q-table', support.ANTICIPATION_TABLE, '--robot', 'straight', '--robots-csv', table,
                  '--robot-series', self.path('headless'), '--robot-log', self.path('headless.jsonl'),
                  '--episodes', 1, '--seed', SEED, *options, file)
        return {row['robot']: row for row in csv.DictReader(io.StringIO(support.read_text(table)))}

    def test_the_same_metrics_as_without_ros(self):
        expected = self.headless_rows(self.write('crossing.yaml', CROSSING))
        self.assertEqual((expected['tug']['success'], expected['cart']['timeout']), ('1', '1'))
        self.assertGreater(int(expected['tug']['people_contacts']), 0)
        self.assertGreater(int(expected['cart']['failures_to_progress']), 0)
        results = self.listen('episode_results', EpisodeResult)
        self.start_learner(q_table=support.ANTICIPATION_TABLE)
        self.start_all(CROSSING, learner=False, seed=SEED, **self.recorded(), **METRICS)
        results.wait_connected()
        self.step(3)
        self.succeed('crowd_controller/reset', keep_seed=True)  # the records begin anew
        self.drive_straight()
        result = results.wait()
        self.assertEqual([robot.robot for robot in result.robots], ['tug', 'cart'])
        for robot in result.robots:
            self.assert_same(robot, expected[robot.robot])
        support.wait_for(lambda: 'robots: 1 of 2 arrived after' in self.controller.output(), 'a line in the log')

        for name in ('robot.csv', 'robot.jsonl'):
            expected = support.read_bytes(self.path(RECORDED[name]))
            self.assertTrue(support.read_bytes(self.path(f'ros/{name}')) == expected, f'{name} differs')
            self.assertGreater(expected.count(b'\n'), 140, name)  # one line a tick

    def recorded(self):
        """Returns the parameters of the controller that let it record robots in the folder `ros`."""
        return {'robot_series': self.path('ros'), 'robot_logs': self.path('ros')}

    def drive_straight(self):
        """Drives all robots until the end of the episode."""
        response = self.step_robots(ticks=0)
        while not response.done:
            names = [observed.name for observed in response.observations]
            response = self.step_robots(names, [straight(observed) for observed in response.observations])

    def test_a_record_goes_on_after_a_robot_was_added(self):
        results = self.listen('episode_results', EpisodeResult)
        self.start_all(scenario(duration=1), **self.recorded())
        results.wait_connected()
        self.step(4)
        self.succeed('crowd_controller/spawn_robot', robot='{name: cart, position: [1, 3], radius: 0.3, max_speed: 1}')
        self.step(6)
        results.wait()
        lines = [json.loads(line) for line in support.read_text(self.path('ros/robot.jsonl')).splitlines()]
        self.assertEqual([[robot['name'] for robot in line['robots']] for line in lines if 'tick' not in line],
                         [['tug'], ['tug', 'cart']])
        self.assertEqual([(line['tick'], len(line['robots'])) for line in lines if 'tick' in line],
                         [(tick, 1 + (tick > 4)) for tick in range(11)])

    def assert_same(self, robot, row):
        """Compares all fields of a message with a row of the CSV file."""
        for name in set(RobotResult.__slots__) - {'goals'}:
            got, expected = getattr(robot, name), row[name]
            if isinstance(got, float):
                self.assertTrue(got == float(expected) or math.isnan(got) and expected == 'nan',
                                f'{name} of {robot.robot}: {got!r}, expected {expected}')
            else:
                self.assertEqual(str(int(got)) if isinstance(got, (bool, int)) else got, expected, name)
        self.assertEqual(set(row) - set(RobotResult.__slots__) - {'episode', 'scenario'} - WITHOUT_ROS, set())

    def test_commands_and_poses_are_counted(self):
        text = scenario(duration=1) + scenario().split('robots:\n')[1].replace('tug', 'cart').replace(
            '[1, 0]', '[1, 3]').replace('max_speed', 'drive: external, max_speed')
        results = self.listen('episode_results', EpisodeResult)
        self.start_all(text, publish_clock=True)
        results.wait_connected()
        self.send(self.publisher('tug/cmd_vel', type(command(0.0))), command(math.nan), 1)
        support.wait_for(lambda: self.walk() and results.messages, 'the end of the episode')
        tug, cart = results.wait().robots
        self.assertEqual((tug.commands_refused, tug.commands_taken, tug.pose_stale), (1, 0, 0))
        self.assertEqual((cart.commands_refused, cart.poses_taken, cart.pose_stale), (0, 0, 1))


if __name__ == '__main__':
    support.run('robot_results_test')
