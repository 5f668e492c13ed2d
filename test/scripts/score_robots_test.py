"""score_robots: the metrics of robots, from logs of poses."""
import csv
import io
import math
import os
import subprocess

import pytest
from programs import ANTICIPATION_TABLE, PATIENCE, page_examples, page_text, read_text
from roslib.packages import find_node

# Of runs with and without robots, and of commands and poses that come by topics.
NOT_IN_A_LOG = {'people_compared', 'people_delay', 'people_detour'}
# Two goals, a gate that opens, walls, an obstacle, people who walk to and fro and people who leave.
SCENE = '''
name: shop
duration: 20
goal_tolerance: 0.3
contact: solid
ends: robots
walls: [[[-6, -4], [-6, 4]], [[0, -4], [0, -1]], [[0, 1], [0, 4]]]
obstacles: [{position: [3, 1], radius: 0.4}]
agents:
  - {count: 3, position: {box: [[1, -3], [5, 3]]}, route: rounds, speed: 1.2, radius: 0.25}
  - {count: 2, position: {box: [[1, -3], [5, 3]]}, goal: [-5, 0], speed: 1.2, radius: 0.2}
routes: {rounds: {repeat: true, waypoints: [{place: [4, -2]}, {place: [-4, 2]}]}}
gates: {door: {wall: [[0, -1], [0, 1]], open: [[2, 20]]}}
robots:
  - {name: tug, position: [-4, 0], goals: [[-1, 1], [4, -1]], radius: 0.3, max_speed: 1}
  - {name: cart, position: [-4, -2], max_speed: 0.5, goal: [4, -3],
     footprint: [[-0.3, -0.2], [0.3, -0.2], [0.3, 0.2], [-0.3, 0.2]]}
'''

# Everybody walks on.
REPEATING = '''
name: rounds
duration: 1
goal_tolerance: 0.3
agents:
  - {count: 3, position: {box: [[1, -3], [5, 3]]}, route: rounds, speed: 1.2, radius: 0.25}
routes: {rounds: {repeat: true, waypoints: [{place: [4, -2]}, {place: [-4, 2]}]}}
'''


def score(runner, *arguments):
    """Runs the program in the test's folder. Returns exit status and output."""
    done = subprocess.run([find_node('social_crowd', 'score_robots')[0], *map(str, arguments)], cwd=runner.folder,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=PATIENCE, check=False)
    return done.returncode, done.stdout.decode(errors='replace')


def rows_of(file):
    return list(csv.DictReader(io.StringIO(read_text(file))))


@pytest.fixture(name='evaluated')
def evaluate_shop(runner):
    """The files of an evaluation, by option."""
    files = {option: runner.path(option) for option in ('robots-csv', 'robot-goals', 'robot-series', 'robot-log')}
    runner.tool('evaluate', '--q-table', ANTICIPATION_TABLE, '--robot', 'straight', '--episodes', 3,
                *(word for option, file in files.items() for word in (f'--{option}', file)),
                runner.write('shop.yaml', SCENE))
    return files


class LogTest:
    """Logs of `evaluate --robot-log`."""

    def test_has_the_same_metrics(self, runner, evaluated):
        log = evaluated['robot-log']
        status, output = score(runner, log, '--csv', 'a.csv', '--goals', 'b.csv', '--series', 'c.csv')
        assert status == 0, output
        expected, got = rows_of(evaluated['robots-csv']), rows_of(runner.path('a.csv'))
        assert len(expected) == len(got) == 6
        assert [{name: row[name] for name in row if name not in NOT_IN_A_LOG} for row in got] == [
            {name: row[name] for name in row if name not in NOT_IN_A_LOG} for row in expected]
        assert read_text(runner.path('b.csv')) == read_text(evaluated['robot-goals'])
        assert read_text(runner.path('c.csv')) == read_text(os.path.join(evaluated['robot-series'], 'shop.csv'))
        assert 'shop, episode 2, robot cart\n' in output

    def test_goals_and_ticks_belong_to_the_metrics(self, evaluated):
        robots, goals = rows_of(evaluated['robots-csv']), rows_of(evaluated['robot-goals'])
        assert [row['robot'] for row in goals] == 3 * ['tug', 'tug', 'cart']
        series = rows_of(os.path.join(evaluated['robot-series'], 'shop.csv'))
        for robot in robots:
            key = (robot['episode'], robot['robot'])
            ticks = [row for row in series if (row['instance'], row['robot']) == key]
            assert [int(row['tick']) for row in ticks] == list(range(len(ticks)))
            work = sum(float(row['social_work']) for row in ticks[1:])
            assert math.isclose(work, float(robot['social_work']), rel_tol=1e-12)
            speeds = [float(row['speed']) for row in ticks[1:]]
            assert max(speeds) == float(robot['max_speed'])
            own = [row for row in goals if (row['episode'], row['robot']) == key]
            paths = sum(float(row['path_length']) for row in own if row['path_length'] != 'nan')
            assert math.isclose(paths, float(robot['path_length']), rel_tol=1e-12)

    def test_parameters(self, runner, evaluated):
        _, output = score(runner, evaluated['robot-log'], '--progress-distance', 100, '--progress-time', 1)
        assert 'failures_to_progress             ' in output
        failures = [int(line.split()[1]) for line in output[:output.index('mean ±')].splitlines()
                    if 'failures_to_progress' in line]
        assert min(failures) >= 5
        assert score(runner, evaluated['robot-log'], '--progress-time', 0)[0] == 2


class HandMadeLogTest:
    """Logs that a user writes."""

    def test_the_example_of_the_page(self, runner):
        name = 'by_hand.jsonl'
        runner.write(name, page_examples('metrics.md')[name])
        command = next(line for line in page_text('metrics.md').splitlines()
                       if line.startswith('    rosrun') and name in line)
        status, output = score(runner, *command.split()[3:])
        assert status == 0, output
        row = rows_of(runner.path('robots.csv'))[0]
        names = ('scenario', 'robot', 'success', 'time_to_reach_goal')
        assert [row[name] for name in names] == ['by_hand', 'tug', '1', '2']
        assert float(row['spl']) == pytest.approx(0.95)
        assert float(row['minimum_distance_to_people']) == pytest.approx(math.hypot(1, 0.9) - 0.3)
        assert (float(row['aggregated_time']), float(row['minimum_obstacle_clearance'])) == (2, pytest.approx(0.7))

    def test_means_of_episodes(self, runner):
        """Both robots drive straight at 1 m/s: one for 1 s and the other for 3 s, mean 2 and deviation sqrt(2)."""
        header = ('{"tick_duration": 1, "robots": [{"radius": 0.2, "max_speed": 1, "goals": [[%d, 0]], '
                  '"goal_tolerance": 0.1}]}\n')
        for name, length in (('a', 1), ('b', 3)):
            runner.write(f'{name}.jsonl', header % length + ''.join(
                '{"tick": %d, "robots": [{"x": %d, "y": 0, "heading": 0}]}\n' % (tick, tick)
                for tick in range(length + 1)))
        _, output = score(runner, 'a.jsonl', 'b.jsonl')
        means = output[output.index('mean ± standard deviation (least to greatest) of 2 results'):].splitlines()
        expected = ['time_to_reach_goal', '2.000', '±', '1.414', '(1.000', 'to', '3.000)', 's']
        assert expected in [line.split() for line in means], means
        assert 'mean ±' not in score(runner, 'a.jsonl')[1]

    @pytest.mark.parametrize('text, message', [
        ('', 'expected a log of robots'),
        ('{"tick": 1}\n', 'line 1: expected a header'),
        ('{"tick_duration": 1, "robots": [{"radius": 0.3}]}\n{"tick": 0, "robots": []}\n',
         'line 2: robots: expected a list of 1'),
        ('{"tick_duration": 1, "robot": []}\n', "robot"),
        ('{"tick_duration": 1\n', 'line 1: this is not a complete line of JSON')])
    def test_errors(self, runner, text, message):
        runner.write('before.csv', 'kept')
        status, output = score(runner, runner.write('bad.jsonl', text), '--csv', 'before.csv')
        assert status == 1
        assert output.startswith('score_robots: ') and 'bad.jsonl: ' in output and message in output, output
        assert read_text(runner.path('before.csv')) == 'kept'

    def test_wrong_usage(self, runner):
        assert score(runner)[0] == 2
        assert 'expected a LOG' in score(runner)[1]
        assert score(runner, 'nowhere.jsonl')[0] == 1


class SuccessTest:
    """`success%` of evaluate."""

    def test_is_a_dash_where_nobody_was_to_arrive(self, runner):
        scenario = runner.write('rounds.yaml', REPEATING)
        output = runner.tool('evaluate', '--q-table', ANTICIPATION_TABLE, '--csv', runner.path('m.csv'), scenario)
        row = next(line for line in output.splitlines() if line.startswith('rounds '))
        assert row.split()[2] == '-'
        assert rows_of(runner.path('m.csv'))[0]['success_pct'] == 'nan'
