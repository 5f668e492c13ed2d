"""research/robot_benchmark: measures, tables, and the command line."""
import math
import os
import pathlib
import subprocess

import numpy
import pytest
from crowd_experiments.runs import RunError
from crowd_robot_benchmark.measures import (CROWDNAV_ORCA, INVISIBLE, VISIBLE, Summary, chapter_of, interval,
                                            number_text, read_record, rows_of)
from crowd_robots.driving import launch_arguments
from programs import assert_says, in_package, read_text, tools_folder, wait_for

COLUMNS = ('episode,scenario,robot,success,time_to_reach_goal,robot_on_person_collisions,person_on_robot_collisions,'
           'mutual_collisions,personal_space_time,people_compared,people_delay,people_detour\n')
# Four episodes: clean; with a contact of the robot; two contacts and no arrival; clean, without people to compare.
ROWS = ('0,robot_door,tug,1,10,0,0,0,2,3,1,0.5\n'
        '1,robot_door,tug,1,20,1,0,0,4,1,-1,2.5\n'
        '2,robot_door,tug,0,nan,0,1,1,6,0,nan,nan\n'
        '0,robot_queue,tug,1,14,0,0,0,0,0,nan,nan\n')


def record_file(folder, rows=ROWS, columns=COLUMNS):
    """Writes a record of robots. Returns its file."""
    file = folder / 'tug.csv'
    file.write_text(columns + rows, encoding='utf-8')
    return file


class MeasuresTest:
    """Sums of episodes, and intervals."""

    def test_a_summary(self, tmp_path):
        record = read_record(record_file(tmp_path))
        door = Summary.of(rows_of(record, 'robot_door'))
        assert (door.episodes, door.arrived, door.clean, door.touched) == (3, 2, 1, 2)
        assert door.contacts == (1, 1, 1)
        assert door.time == 15.0
        assert door.clean_time == 10.0
        assert door.personal_space_time == 4.0
        assert door.people_delay == pytest.approx((3 * 1 - 1 * 1) / 4)
        assert door.people_detour == pytest.approx((3 * 0.5 + 1 * 2.5) / 4)
        queue = Summary.of(rows_of(record, 'robot_queue'))
        assert (queue.episodes, queue.clean, queue.time) == (1, 1, 14.0)
        assert math.isnan(queue.people_delay)

    @pytest.mark.parametrize('count, total, low, high', [
        (0, 20, 0.0, 0.16113), (10, 20, 0.29930, 0.70070), (20, 20, 0.83887, 1.0), (500, 500, 0.99238, 1.0)])
    def test_intervals(self, count, total, low, high):
        """Wilson's interval; for n of n it is n / (n + z^2)."""
        assert interval(count, total) == pytest.approx((low, high), abs=2e-5)

    def test_intervals_contain_the_share(self):
        for total in range(1, 40):
            for count in range(total + 1):
                low, high = interval(count, total)
                assert low - 1e-12 <= count / total <= high + 1e-12

    @pytest.mark.parametrize('text, said', [
        ('episode,scenario,success\n', 'without the columns robot, time_to_reach_goal, '),
        ('', 'expected a record of robots as CSV'),
        (COLUMNS + '0,robot_door,tug,yes,1,0,0,0,0,0,0,0\n', 'expected a record of robots as CSV')])
    def test_other_files_are_refused(self, tmp_path, text, said):
        file = tmp_path / 'other.csv'
        file.write_text(text, encoding='utf-8')
        with pytest.raises(RunError, match=said):
            read_record(file)

    def test_people_are_optional(self, tmp_path):
        """A record of runs through ROS has no people's delay."""
        file = tmp_path / 'ros.csv'
        lines = (COLUMNS + ROWS).splitlines()
        file.write_text(''.join(','.join(line.split(',')[:-3]) + '\n' for line in lines), encoding='utf-8')
        record = read_record(file)
        assert not record['people_compared'].any()
        assert numpy.isnan(record['people_delay']).all()


class TablesTest:
    """The tables of the page."""

    def test_rows(self, tmp_path):
        record = read_record(record_file(tmp_path))
        summary, single, crowdnav = chapter_of({'tug': record}, ('robot_door', 'robot_queue'),
                                               {('tug', VISIBLE): record}).tables()
        assert summary.rows == [['tug', '2 x 1-3', '3 (30-95 %)', '2 (15-85 %)', '1, 1, 1', '14.7', '3.0', '0.50',
                                 '1.00']]
        assert [row[:3] for row in single.rows] == [['robot_door', 'tug', '2 (21-94 %)'],
                                                    ['robot_queue', 'tug', '1 (21-100 %)']]
        assert single.rows[1][4:] == ['0, 0, 0', '14.0', '0.0', '-', '-']
        # CrowdNav's success is without a contact, and so is the mean time.
        assert [row[:2] for row in crowdnav.rows] == [['robot visible', 'ORCA, published'], ['robot visible', 'tug'],
                                                      ['robot invisible', 'ORCA, published']]
        assert crowdnav.rows[1][2:] == ['4', '2 (15-85 %)', '2 (15-85 %)', '0', '12.00']
        assert crowdnav.rows[2][3].startswith('213 (38-47 %)')

    @pytest.mark.parametrize('value, text', [(1.234, '1.23'), (-0.004, '0.00'), (-0.006, '-0.01'), (math.nan, '-')])
    def test_numbers(self, value, text):
        assert number_text(value, 2) == text

    def test_published_episodes_add_up(self):
        for clean, touched, _ in (CROWDNAV_ORCA[VISIBLE], CROWDNAV_ORCA[INVISIBLE]):
            assert clean + touched <= 500


class RobotBenchmarkTest:
    """The program."""

    def benchmark(self, runner, *words):
        """Starts research/robot_benchmark with results in the test's folder."""
        return runner.start('robot_benchmark', [in_package('research', 'robot_benchmark'), *words, '--tools',
                                                tools_folder(), '--output', runner.path('results')])

    def test_a_controller_and_a_robot_from_elsewhere(self, runner):
        document = runner.write('page.md', '<!-- table robots/summary -->\n<!-- end -->\n'
                                           '<!-- table robots/scenarios -->\n<!-- end -->\n'
                                           '<!-- table robots/crowdnav -->\n<!-- end -->\n')
        runner.write('tug.csv', COLUMNS + ROWS)
        first = self.benchmark(runner, '--robot', 'straight', '--robot', 'tug=' + runner.path('tug.csv'), '--scenarios',
                               'robot_crossing', '--placements', '2', '--crowdnav-episodes', '3', '--document',
                               document)
        assert first.wait() == 0, first.output()
        page = read_text(document)
        assert_says(page, '| straight | 1 x 2 |', '| tug | 2 x 1-3 | 3 (30-95 %)', '| robot_crossing | straight | 2 (',
                    '| robot_door | tug |', '| robot visible | ORCA, published | 500 | 500 (99-100 %) |',
                    '| robot invisible | straight | 3 | ')
        record = read_record(runner.path('results/runs/straight/crowdnav_visible/robots.csv'))
        assert numpy.count_nonzero(record['people_compared']) == 3
        # People walk round a robot only if they see it.
        unseen = read_record(runner.path('results/runs/straight/crowdnav_invisible/robots.csv'))
        assert numpy.sum(unseen['robot_on_person_collisions'] + unseen['mutual_collisions'] +
                         unseen['person_on_robot_collisions']) > 0
        assert not numpy.array_equal(unseen['minimum_clearance'], record['minimum_clearance'])
        assert 'perceived: false' in read_text(runner.path('results/scenarios/perceived_false/robot_circle_5.yaml'))
        again = self.benchmark(runner, '--table', '--placements', '2', '--crowdnav-episodes', '3')
        assert again.wait() == 0, again.output()
        assert_says(again.output(), 'tug', 'straight')
        kept = self.benchmark(runner, '--robot', 'straight', '--scenarios', 'robot_crossing', '--placements', '2',
                              '--crowdnav-episodes', '3')
        assert kept.wait() == 0, kept.output()
        assert_says(kept.output(), '3 runs, 3 of them done before')

    def test_a_robot_with_protective_stop(self, runner):
        """Keys of the robots change; a map is found from the copy of the scenario, too."""
        done = self.benchmark(runner, '--robot', 'straight_stop', '--scenarios', 'robot_station', '--placements', '1',
                              '--crowdnav-episodes', '2')
        assert done.wait() == 0, done.output()
        assert 'yields: both' in read_text(runner.path('results/scenarios/yields_both/robot_station.yaml'))
        assert len(read_record(runner.path('results/runs/straight_stop/robot_station/robots.csv'))['success']) == 1
        assert not os.path.exists(runner.path('results/runs/straight_stop/crowdnav_invisible'))

    @pytest.mark.parametrize('words, said', [
        (['--robot', 'move_bus'],
         'expected straight, reactive, learned, straight_stop, learned_stop, move_base, move_base_people, or NAME='),
        (['--robot', 'straight=file.csv'], 'NAME=FILE.csv with another name'),
        (['--scenarios', 'robot_dor'], "invalid choice: 'robot_dor'"),
        (['--placements', '0'], 'expected a whole number from 1'),
    ])
    def test_wrong_usage(self, runner, words, said):
        refused = self.benchmark(runner, *words)
        assert refused.wait() == 2, refused.output()
        assert_says(refused.output(), said)
        assert not os.path.exists(runner.path('results'))

    @pytest.mark.parametrize('words, said', [
        (['--q-table', 'nowhere.txt'], 'nowhere.txt: there is no such Q-table'),
        (['--robot', 'tug=nowhere.csv'], 'nowhere.csv: No such file or directory'),
        (['--table'], 'has no results'),
    ])
    def test_wrong_input(self, runner, words, said):
        refused = self.benchmark(runner, *words)
        assert refused.wait() == 1, refused.output()
        assert_says(refused.output(), said)

    def test_interrupted(self, runner):
        running = self.benchmark(runner, '--robot', 'reactive', '--scenarios', 'robot_station', '--crowdnav-episodes',
                                 '0')
        log = runner.path('results/runs/reactive/robot_station/log.txt')
        wait_for(lambda: os.path.exists(log) and 'evaluate' in read_text(log), 'the first run')
        assert running.stop() == 130, running.output()
        assert_says(running.output(), 'Interrupted: ', ' runs are done and kept')


def has_move_base():
    """Returns whether move_base is in the environment."""
    try:
        return subprocess.run(['rospack', 'find', 'move_base'], capture_output=True, check=False).returncode == 0
    except OSError:
        return False


class DriveRobotsTest:
    """scripts/drive_robots."""

    def drive(self, runner, scenario, *words, environment=None):
        """Starts the program with a record in the test's folder."""
        return runner.start('drive_robots', [in_package('scripts', 'drive_robots'), '--robots-csv',
                                             runner.path('robots.csv'), *words, scenario], environment)

    @pytest.mark.skipif(not has_move_base(), reason='move_base is not in the environment')
    def test_records_through_ros(self, runner):
        """Holonomic robots, ticks of 0.25 s and no map."""
        driven = self.drive(runner, in_package('config', 'scenarios', 'robot_circle_5.yaml'), '--episodes', '2')
        assert driven.wait() == 0, driven.output()
        record = read_record(runner.path('robots.csv'))
        assert list(record['episode']) == [0, 1]
        assert set(record['scenario']) == {'robot_circle_5'}
        assert (record['commands_taken'] > 20).all()

    def test_without_move_base(self, runner):
        refused = self.drive(runner, in_package('config', 'scenarios', 'robot_hall.yaml'),
                             environment={'ROS_PACKAGE_PATH': runner.path('')})
        assert refused.wait() == 1, refused.output()
        assert_says(refused.output(), 'drive_robots: move_base is not in the ROS environment')

    def launched(self, runner, lines):
        """Starts the program with a shell script in place of roslaunch, which gets the file to record in $record, and
        an earlier record."""
        os.mkdir(runner.path('programs'))
        finds = 'for word; do case $word in robots_csv:=*) record=${word#robots_csv:=};; esac; done\n'
        for name, text in (('rospack', 'exit 0\n'), ('roslaunch', finds + lines)):
            os.chmod(runner.write(f'programs/{name}', '#!/bin/sh\n' + text), 0o755)
        runner.write('robots.csv', 'earlier')
        runner.write('rows.csv', COLUMNS + ROWS)
        return self.drive(runner, in_package('config', 'scenarios', 'robot_hall.yaml'), '--episodes', '4',
                          environment={'PATH': runner.path('programs') + ':' + os.environ['PATH']})

    def test_a_complete_record_replaces_the_earlier_one(self, runner):
        driven = self.launched(runner, f'cp {runner.path("rows.csv")} "$record"\n')
        assert driven.wait() == 0, driven.output()
        assert read_text(runner.path('robots.csv')) == COLUMNS + ROWS
        assert not os.path.exists(runner.path('.robots.csv.part'))

    @pytest.mark.parametrize('lines, said', [
        ('exit 1\n', ''), ('head -n 3 rows.csv > "$record"\n', '.robots.csv.part: expected 4 rows, got 2')])
    def test_an_earlier_record_is_not_lost(self, runner, lines, said):
        driven = self.launched(runner, lines.replace('rows.csv', runner.path('rows.csv')))
        assert driven.wait() == 1, driven.output()
        assert_says(driven.output(), said)
        assert read_text(runner.path('robots.csv')) == 'earlier'

    def test_drive_interrupted(self, runner):
        driven = self.launched(runner, f'echo > {runner.path("began")}\nexec sleep 60\n')
        wait_for(lambda: os.path.exists(runner.path('began')), 'roslaunch')
        assert driven.stop() == 130, driven.output()
        assert_says(driven.output(), 'drive_robots: interrupted')
        assert read_text(runner.path('robots.csv')) == 'earlier'

    def test_names_of_robots(self, runner):
        """An empty name space counts as none, and with a name space no name is required."""
        text = "robots:\n  - {radius: 0.3, namespace: a}\n  - {radius: 0.2, name: b, namespace: ''}\n"
        file = pathlib.Path(runner.write('scenario.yaml', text))
        assert launch_arguments(file, 'move_base')['robots'] == 'a b'

    @pytest.mark.parametrize('text, said', [
        ('robots:\n  - {radius: 1, name: a}\n  - {radius: 1}\n', 'robots[1]: expected a name or a namespace'),
        ('name: empty\n', 'expected a scenario with robots'),
        ('robots:\n  - {name: tug}\n', 'robots: expected the key radius for each robot')])
    def test_scenarios_that_it_cannot_drive(self, runner, text, said):
        refused = self.drive(runner, runner.write('scenario.yaml', text))
        assert refused.wait() == 1, refused.output()
        assert_says(refused.output(), 'scenario.yaml: ' + said)
        assert not os.path.exists(runner.path('robots.csv'))

    @pytest.mark.parametrize('words, said', [
        (['--episodes', '0'], 'expected a whole number from 1'), (['--robot', 'bus'], "invalid choice: 'bus'")])
    def test_wrong_usage(self, runner, words, said):
        refused = self.drive(runner, 'scenario.yaml', *words)
        assert refused.wait() == 2, refused.output()
        assert_says(refused.output(), said)
