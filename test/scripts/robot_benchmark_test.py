"""research/robot_benchmark: measures, tables, the results file and its verification, and the command line."""
import csv
import hashlib
import json
import math
import os
import pathlib
import re
import shutil
import subprocess

import numpy
import pytest
from crowd_drawing.errors import read_documents
from crowd_experiments import scenario_files
from crowd_experiments.runs import STAMP, RunError
from crowd_experiments.scenario_files import files_behind
from crowd_experiments.tools import find_config
from crowd_robot_benchmark import verify
from crowd_robot_benchmark.identity import Identity, Inputs, scene_digest, version_of
from crowd_robot_benchmark.measures import (CAUSES, CROWDNAV_ORCA, Summary, chapter_of, interval, number_text,
                                            read_record, rows_of)
from crowd_robot_benchmark.results import Row
from crowd_robot_benchmark.suite import INVISIBLE, RECORD, ROBOTS, VISIBLE, Suite, changed_scene, scene_files
from crowd_robot_benchmark.verify import repeat, spread
from crowd_robot_benchmark.worst import worst_rows
from programs import ANTICIPATION_TABLE, assert_says, in_package, read_text, tools_folder, wait_for

COLUMNS = ('episode,scenario,robot,success,time_to_reach_goal,people_contacts,robot_on_person_collisions,'
           'person_on_robot_collisions,mutual_collisions,personal_space_time,people_compared,people_delay,'
           'people_detour\n')
# Four episodes: clean; with a contact of the robot; two contacts and no arrival; clean, without people to compare.
ROWS = ('0,robot_door,tug,1,10,0,0,0,0,2,3,1,0.5\n'
        '1,robot_door,tug,1,20,1,1,0,0,4,1,-1,2.5\n'
        '2,robot_door,tug,0,nan,2,0,1,1,6,0,nan,nan\n'
        '0,robot_queue,tug,1,14,0,0,0,0,0,0,nan,nan\n')


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
        (COLUMNS + '0,robot_door,tug,yes,1,0,0,0,0,0,0,0,0\n', 'expected a record of robots as CSV')])
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
        assert summary.rows == [['tug', '2 x 1-3', '3 (30-95 %)', '2 (15-85 %)', '-', '1, 1, 1', '14.7', '3.0',
                                 '0.50', '1.00']]
        assert single.header == ['scene', 'people per m²', 'tug']
        assert single.rows == [['robot_door', '-', '2 / 1'], ['robot_queue', '-', '1 / 1']]
        # CrowdNav's success is without a contact, and so is the mean time.
        assert [row[:2] for row in crowdnav.rows] == [['robot visible', 'ORCA, published'], ['robot visible', 'tug'],
                                                      ['robot invisible', 'ORCA, published']]
        assert crowdnav.rows[1][2:] == ['4', '2 (15-85 %)', '2 (15-85 %)', '0', '12.00']
        assert crowdnav.rows[2][3].startswith('213 (38-47 %)')

    def test_scenes_of_several_robots(self, tmp_path):
        """The density is the mean over all episodes of the scene; a robot that was not there has a dash."""
        record = read_record(record_file(tmp_path))
        dense = record.assign(people_density=[0.1, 0.2, 0.3, 0.5])
        rows = chapter_of({'tug': dense, 'cart': rows_of(dense, 'robot_door')}, ('robot_door', 'robot_queue'),
                          {}).tables()[1].rows
        assert rows == [['robot_door', '0.20', '2 / 1', '2 / 1'], ['robot_queue', '0.50', '1 / 1', '-']]

    @pytest.mark.parametrize('value, text', [(1.234, '1.23'), (-0.004, '0.00'), (-0.006, '-0.01'), (math.nan, '-')])
    def test_numbers(self, value, text):
        assert number_text(value, 2) == text

    def test_published_episodes_add_up(self):
        for clean, touched, _ in (CROWDNAV_ORCA[VISIBLE], CROWDNAV_ORCA[INVISIBLE]):
            assert clean + touched <= 500


SCENES = scene_files(find_config())


class ScenesTest:
    """config/scenarios/robots."""

    def test_there_are_enough(self):
        assert len(SCENES) >= 40

    @pytest.mark.parametrize('name', SCENES)
    def test_pages(self, name):
        """Each has a row on the page, and says what happens."""
        assert_says(read_text(in_package('docs', 'robot_scenes.md')), f'| `{name}` |')
        assert SCENES[name].read_text(encoding='utf-8').startswith('# ')

    def test_pages_of_scenes_that_are_there(self):
        rows = re.findall(r'^\| `(robot_\w+)` \|', read_text(in_package('docs', 'robot_scenes.md')), re.MULTILINE)
        assert sorted(rows) == sorted(SCENES)

    def test_one_robot_each(self):
        for name, file in SCENES.items():
            document, = read_documents(file)
            assert (document['name'], document['ends'], len(document['robots'])) == (name, 'robots', 1)

    def test_people_go_on(self, runner):
        """In each scene but CrowdNav's, there are people on their way when the robot could have arrived."""
        record = runner.path('record.csv')
        runner.tool('evaluate', '--q-table', ANTICIPATION_TABLE, '--episodes', '1', '--record', record,
                    *SCENES.values())
        ends = {}
        for row in rows_of_csv(record):
            left = row['arrived'] == '0' and row['ticks'] != '0'
            ends[row['scenario']] = ends.get(row['scenario'], 0) + left
        recorded = {name for name, file in SCENES.items() if 'recorded:' in file.read_text(encoding='utf-8')}
        assert {name for name in SCENES if not ends.get(name)} - recorded == {'robot_circle_5'}


def rows_of_csv(file):
    """Returns the rows of a CSV file as texts by column."""
    with open(file, newline='', encoding='utf-8') as stream:
        return list(csv.DictReader(stream))


class IdentityTest:
    """A hash changes with all that determines a row."""

    def suite(self, folder, name='robot_station'):
        """Returns a Suite with copies of the package's scene and of the files that it names."""
        shutil.copytree(in_package('config'), folder / 'config')
        q_table = folder / 'config' / 'q_tables' / 'anticipation.txt'
        file = folder / 'config' / 'scenarios' / 'robots' / f'{name}.yaml'
        return Suite(pathlib.Path(tools_folder(), 'evaluate'), q_table, {name: file}, folder / 'results')

    @pytest.mark.parametrize('robot', ['learned', 'learned_stop'])
    @pytest.mark.parametrize('scene, files', [
        ('robot_station', ['scenarios/robots/robot_station.yaml', 'maps/station.yaml', 'maps/station.png',
                           'q_tables/anticipation.txt']),
        ('robot_street', ['scenarios/robots/robot_street.yaml', 'recordings/street.csv']),
        ('robot_kinds', ['scenarios/robots/robot_kinds.yaml', 'kinds.yaml'])])
    def test_files(self, tmp_path, scene, files, robot, monkeypatch):
        """Hash and stamp change with each of them, so that no run is done that has another hash."""
        suite = self.suite(tmp_path, scene)
        monkeypatch.setattr(scenario_files, 'kinds_file', lambda: tmp_path / 'config' / 'kinds.yaml')

        def state():
            run = suite.run_of(robot, scene)
            assert not run.is_done()
            run.folder.mkdir(parents=True, exist_ok=True)
            (run.folder / STAMP).write_text(run.stamp(), encoding='utf-8')
            assert suite.run_of(robot, scene).is_done()
            return Inputs(suite).identity(robot, ROBOTS[robot], scene, 1, 0).hash

        hashes = {state()}
        for name in files:
            with open(tmp_path / 'config' / name, 'ab') as stream:
                stream.write(b'# changed: 1\n')
            hashes.add(state())
        assert len(hashes) == len(files) + 1

    def test_other_files_do_not_matter(self, tmp_path):
        """Kinds of people are behind scenes that use them."""
        suite = self.suite(tmp_path, 'robot_hall')
        assert [*files_behind(suite.scenes['robot_hall'])] == []
        assert files_behind(SCENES['robot_kinds']) == [find_config() / 'kinds.yaml']

    def test_what_the_program_says_of_itself(self, tmp_path):
        package, sources, compiler = version_of(pathlib.Path(tools_folder(), 'evaluate'))
        assert f'<version>{package}</version>' in read_text(in_package('package.xml'))
        assert re.fullmatch('[0-9a-f]{16}', sources)
        assert re.match(r'\w+ [\d.]+ ', compiler)
        other = tmp_path / 'evaluate'
        other.write_text('#!/bin/sh\necho package 1\n', encoding='utf-8')
        other.chmod(0o755)
        with pytest.raises(RunError, match='expected a line with sources, compiler'):
            version_of(other)

    def test_digest_of_sources(self, tmp_path):
        """It is that of `sha256sum`, of all files and their names."""
        sources = {'src/core.cmake': '-O3', 'src/tools/a.cpp': 'main'}
        values = {'PROGRAM_SOURCES': ';'.join(sources), 'PROJECT_SOURCE_DIR': tmp_path, 'social_crowd_VERSION': '1.2',
                  'BUILT_VERSION': tmp_path / 'built_version.h', 'BUILD_KIND': 'GNU "12"'}
        script = read_text(in_package('src', 'tools', 'built_version.cmake'))
        (tmp_path / 'digest.cmake').write_text(re.sub(r'@(\w+)@', lambda found: str(values[found[1]]), script),
                                               encoding='utf-8')
        for changed in ('-O3', '-O2'):
            sources['src/core.cmake'] = changed
            for name, text in sources.items():
                (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
                (tmp_path / name).write_text(text, encoding='utf-8')
            subprocess.run(['cmake', '-P', tmp_path / 'digest.cmake'], check=True)
            sums = ''.join(f'{hashlib.sha256(text.encode()).hexdigest()}  {name}\n' for name, text in sources.items())
            digest = hashlib.sha256(sums.encode()).hexdigest()[:16]
            assert_says(read_text(tmp_path / 'built_version.h'), f'"{digest}"', '"1.2"', 'R"(GNU "12")"')

    def test_settings(self, tmp_path):
        inputs = Inputs(self.suite(tmp_path))
        settings = [('learned', 1, 0), ('learned_stop', 1, 0), ('orca', 1, 0), ('learned', 2, 0), ('learned', 1, 1)]
        found = [inputs.identity(name, ROBOTS[name], 'robot_station', seed, episode)
                 for name, seed, episode in settings]
        assert len({identity.hash for identity in found}) == len(settings)
        for field in ('package', 'program', 'compiler'):
            assert found[0]._replace(**{field: '0'}).computed_hash() != found[0].hash
        # The name in tables determines nothing.
        assert found[0]._replace(baseline='other').computed_hash() == found[0].hash

    def test_folders_do_not_matter(self, tmp_path):
        suite = self.suite(tmp_path)
        assert scene_digest(suite.scenes['robot_station']) == scene_digest(SCENES['robot_station'])

    @pytest.mark.parametrize('scene', ['robot_station', 'robot_street', 'robot_kinds'])
    def test_changed_scenes(self, tmp_path, scene):
        """A copy with other keys of the robots names the same files."""
        copy = changed_scene(SCENES[scene], {'yields': 'both'}, tmp_path / 'robots' / f'{scene}.yaml')
        assert 'yields: both' in copy.read_text(encoding='utf-8')
        document, = read_documents(copy)
        named = [document.get('map'), *(entry['file'] for entry in document.get('recorded') or [])]
        assert all(os.path.isabs(file) and os.path.exists(file) for file in named if file)

    def test_a_changed_scene_is_written_once(self, tmp_path):
        """A program may be reading it."""
        copy = tmp_path / 'robots' / 'robot_hall.yaml'
        changed_scene(SCENES['robot_hall'], {'yields': 'both'}, copy)
        state = copy.stat()
        changed_scene(SCENES['robot_hall'], {'yields': 'both'}, copy)
        assert (copy.stat().st_ino, copy.stat().st_mtime_ns) == (state.st_ino, state.st_mtime_ns)
        changed_scene(SCENES['robot_hall'], {'yields': 'robot'}, copy)
        assert copy.stat().st_ino != state.st_ino
        assert os.listdir(copy.parent) == ['robot_hall.yaml']


class WorstEpisodesTest:
    """The worst episodes, and films of them."""

    def test_order(self, tmp_path):
        """Contacts first, then failures, then the time near people; one episode of a scene."""
        columns = ['success', 'time_to_reach_goal', 'people_contacts', 'personal_space_time']
        values = {('a', '0'): '1,9,0,5', ('a', '1'): '1,9,1,1', ('b', '0'): '0,nan,0,3', ('b', '1'): '1,9,0,9',
                  ('c', '0'): '1,9,2,0', ('d', '0'): '1,9,0,1'}
        rows = [Row(0, Identity(*(['x'] * 10), episode, scene), text.split(','))
                for (scene, episode), text in values.items()]
        found = [(row.identity.scenario, row.identity.episode) for row, _ in worst_rows(columns, rows)]
        assert found == [('c', '0'), ('a', '1'), ('b', '0'), ('d', '0')]

    def test_page(self, runner):
        done = runner.start('robot_benchmark', [
            in_package('research', 'robot_benchmark'), '--robot', 'straight', '--scenes', 'robot_frontal',
            'robot_street', '--episodes', '1', '--crowdnav-episodes', '0', '--films', '2', '--page',
            runner.path('page.html'), '--tools', tools_folder(), '--output', runner.path('results')])
        assert done.wait() == 0, done.output()
        page = read_text(runner.path('page.html'))
        assert page.count('src="data:image/webp;base64,') == 2
        assert_says(page, 'Worst episodes', 'straight in robot_street, episode 0', 'SHA-256 ')


class RobotBenchmarkTest:
    """The program."""

    def benchmark(self, runner, *words):
        """Starts research/robot_benchmark with results in the test's folder."""
        return runner.start('robot_benchmark', [in_package('research', 'robot_benchmark'), *words, '--tools',
                                                tools_folder(), '--output', runner.path('results')])

    def test_a_controller_and_a_robot_from_elsewhere(self, runner):
        document = runner.write('page.md', '<!-- table robots/summary -->\n<!-- end -->\n'
                                           '<!-- table robots/scenes -->\n<!-- end -->\n'
                                           '<!-- table robots/crowdnav -->\n<!-- end -->\n')
        runner.write('tug.csv', COLUMNS + ROWS)
        first = self.benchmark(runner, '--robot', 'straight', '--robot', 'tug=' + runner.path('tug.csv'), '--scenes',
                               'robot_crossing', '--episodes', '2', '--crowdnav-episodes', '3', '--document',
                               document)
        assert first.wait() == 0, first.output()
        page = read_text(document)
        assert_says(page, '| straight | 1 x 2 |', '| tug | 2 x 1-3 | 3 (30-95 %)', '| robot_crossing | ',
                    '| robot_door | - | - | 2 / 1 |',
                    '| robot visible | ORCA, published | 500 | 500 (99-100 %) |',
                    '| robot invisible | straight | 3 | ')
        record = read_record(runner.path('results/runs/straight/crowdnav_visible/robots.csv'))
        assert numpy.count_nonzero(record['people_compared']) == 3
        # People walk round a robot only if they see it.
        unseen = read_record(runner.path('results/runs/straight/crowdnav_invisible/robots.csv'))
        assert numpy.sum(unseen['people_contacts']) > 0
        assert numpy.array_equal(unseen['people_contacts'], unseen[CAUSES].sum(axis=1))
        assert not numpy.array_equal(unseen['minimum_clearance'], record['minimum_clearance'])
        assert 'perceived: false' in read_text(runner.path('results/scenarios/perceived_false/robot_circle_5.yaml'))
        results = runner.path('results/results.csv')
        assert [row['keys'] for row in rows_of_csv(results)] == ['{}'] * 5 + ['{"perceived": false}'] * 3
        same = self.verify(runner, results, '--rows', 'all')
        assert same.wait() == 0, same.output()
        assert_says(same.output(), '8 rows repeated: 8 are the same, bit for bit\n')
        again = self.benchmark(runner, '--table', '--episodes', '2', '--crowdnav-episodes', '3')
        assert again.wait() == 0, again.output()
        assert_says(again.output(), 'tug', 'straight')
        kept = self.benchmark(runner, '--robot', 'straight', '--scenes', 'robot_crossing', '--episodes', '2',
                              '--crowdnav-episodes', '3')
        assert kept.wait() == 0, kept.output()
        assert_says(kept.output(), '3 runs, 3 of them done before')

    def test_results_are_verified(self, runner):
        """One and two threads, and scalar code, give the same file; a changed digit is found."""
        words = ('--robot', 'learned_stop', '--robot', 'orca', '--scenes', 'robot_frontal', 'robot_station',
                 '--episodes', '2', '--crowdnav-episodes', '0')
        done = self.benchmark(runner, *words)
        assert done.wait() == 0, done.output()
        results = runner.path('results/results.csv')
        text = read_text(results)
        assert len(text.splitlines()) == 1 + 2 * 2 * 2
        other = runner.start('robot_benchmark', [in_package('research', 'robot_benchmark'), *words, '--tools',
                                                 tools_folder(), '--output', runner.path('other'), '--threads', '2'],
                             {'SOCIAL_CROWD_SIMD': 'reference'})
        assert other.wait() == 0, other.output()
        assert read_text(runner.path('other/results.csv')) == text
        assert_says(other.output(), done.output().split('SHA-256 ')[1].split()[0])
        same = self.verify(runner, results, '--rows', 'all', '--processes', '4')
        assert same.wait() == 0, same.output()
        assert_says(same.output(), '8 rows repeated: 8 are the same, bit for bit\n')
        rows = rows_of_csv(results)
        changed = rows[-1]['path_length']
        digit = changed[:-1] + str((int(changed[-1]) + 1) % 10)
        wrong = runner.write('wrong.csv', digit.join(text.rsplit(changed, 1)))
        found = self.verify(runner, wrong, '--rows', 'all')
        assert found.wait() == 1, found.output()
        assert_says(found.output(), f'wrong.csv:9: learned_stop in robot_station, episode 1: path_length is {digit} '
                    f'in the file, {changed} here', '7 are the same, bit for bit\n')

    def verify(self, runner, file, *words):
        return runner.start('verify', [in_package('research', 'robot_benchmark'), 'verify', file, '--tools',
                                       tools_folder(), *words])

    def test_rows_of_other_inputs(self, runner):
        """They are named, and repeated all the same: only other results, or a hash of another row, are a failure."""
        done = self.benchmark(runner, '--robot', 'straight', '--scenes', 'robot_frontal', '--episodes', '1',
                              '--crowdnav-episodes', '0')
        assert done.wait() == 0, done.output()
        header, line = read_text(runner.path('results/results.csv')).splitlines()
        row = dict(zip(header.split(','), next(csv.reader([line]))))
        assert json.loads(row['keys']) == {}
        other = line.replace(row['program'], '0' * 16)
        note = f"note: program is {'0' * 16} in the file, {row['program']} here"
        found = self.verify(runner, runner.write('other.csv', f'{header}\n{other}\n'))
        assert found.wait() == 1, found.output()
        identity = Identity(*next(csv.reader([other]))[:len(Identity._fields)])
        assert_says(found.output(), f"its hash is {row['hash']}, but what it names has the hash "
                    f'{identity.computed_hash()}', note, '1 rows repeated: 0 are the same')
        other = other.replace(row['hash'], identity.computed_hash())
        found = self.verify(runner, runner.write('other.csv', f'{header}\n{other}\n'))
        assert found.wait() == 0, found.output()
        assert_says(found.output(), note,
                    '1 rows repeated: 1 are the same, bit for bit, 1 of them though inputs differ')

    def test_rows_of_scenes_that_are_not_here(self, runner):
        identity = Identity(*['1'] * (len(Identity._fields) - 1), 'robot_nowhere').with_hash()
        file = runner.write('file.csv', f"{','.join(Identity._fields)},robot\n{','.join(identity)},tug\n")
        found = self.verify(runner, file)
        assert found.wait() == 1, found.output()
        assert_says(found.output(), 'there is no such scene here', '1 rows repeated: 0 are the same')

    @pytest.mark.parametrize('text, said', [
        ('episode,scenario\n', 'expected results of robot_benchmark, with the columns hash,package,'),
        (','.join(Identity._fields) + ',robot\n', 'has no rows'),
        (','.join(Identity._fields) + ',robot\na,b\n', 'file.csv:2: expected 13 values, got 2')])
    def test_files_that_cannot_be_verified(self, runner, text, said):
        refused = self.verify(runner, runner.write('file.csv', text))
        assert refused.wait() == 1, refused.output()
        assert_says(refused.output(), said)

    def test_each_row_has_its_own_scene(self, monkeypatch):
        """Rows of the same keys and scene are repeated in parallel."""
        files = []

        def walk(command, cwd):
            assert cwd in command[-1].parents and 'yields: both' in read_text(command[-1])
            files.append(command[-1])
            (cwd / RECORD).write_text('episode,scenario,robot\n3,robot_hall,tug\n', encoding='utf-8')

        monkeypatch.setattr(verify, 'output_of', walk)
        suite = Suite(pathlib.Path('evaluate'), pathlib.Path('table.txt'), SCENES, pathlib.Path('nowhere'))
        identity = Identity(*['1'] * len(Identity._fields))._replace(keys='{"yields": "both"}', scenario='robot_hall',
                                                                     episode='3')
        for _ in range(2):
            assert repeat(suite, Row(2, identity, ['tug'])) == (['robot'], ['tug'])
        assert files[0] != files[1]

    def test_rows_are_spread(self):
        assert spread(list(range(10)), 2) == [2, 7]
        assert spread(list(range(10)), 'all') == spread(list(range(10)), 11) == list(range(10))
        assert len(set(spread(list(range(97)), 20))) == 20

    def test_a_robot_with_protective_stop(self, runner):
        """Keys of the robots change; a map is found from the copy of the scenario, too."""
        done = self.benchmark(runner, '--robot', 'learned_stop', '--scenes', 'robot_station', '--episodes', '1',
                              '--crowdnav-episodes', '2')
        assert done.wait() == 0, done.output()
        assert 'yields: both' in read_text(runner.path('results/scenarios/yields_both/robot_station.yaml'))
        assert len(read_record(runner.path('results/runs/learned_stop/robot_station/robots.csv'))['success']) == 1
        assert not os.path.exists(runner.path('results/runs/learned_stop/crowdnav_invisible'))

    @pytest.mark.parametrize('words, said', [
        (['--robot', 'move_bus'],
         'expected straight, reactive, orca, social_force, learned, learned_stop, move_base, move_base_people, or '
         'NAME='),
        (['--robot', 'straight=file.csv'], 'NAME=FILE.csv with another name'),
        (['--scenes', 'robot_dor'], "invalid choice: 'robot_dor'"),
        (['--episodes', '0'], 'expected a whole number from 1'),
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
        running = self.benchmark(runner, '--robot', 'reactive', '--scenes', 'robot_station', '--crowdnav-episodes',
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
        driven = self.drive(runner, 'robot_circle_5', '--episodes', '2')
        assert driven.wait() == 0, driven.output()
        record = read_record(runner.path('robots.csv'))
        assert list(record['episode']) == [0, 1]
        assert set(record['scenario']) == {'robot_circle_5'}
        assert (record['commands_taken'] > 20).all()

    def test_without_move_base(self, runner):
        refused = self.drive(runner, in_package('config', 'scenarios', 'robots', 'robot_hall.yaml'),
                             environment={'ROS_PACKAGE_PATH': runner.path('')})
        assert refused.wait() == 1, refused.output()
        assert_says(refused.output(), 'drive_robots: move_base is not in the ROS environment')

    def launched(self, runner, lines, *words):
        """Starts the program with a shell script in place of roslaunch, which gets the file to record in $record, and
        an earlier record."""
        os.mkdir(runner.path('programs'))
        finds = 'for word; do case $word in robots_csv:=*) record=${word#robots_csv:=};; esac; done\n'
        for name, text in (('rospack', 'exit 0\n'), ('roslaunch', finds + lines)):
            os.chmod(runner.write(f'programs/{name}', '#!/bin/sh\n' + text), 0o755)
        runner.write('robots.csv', 'earlier')
        runner.write('rows.csv', COLUMNS + ROWS)
        return self.drive(runner, in_package('config', 'scenarios', 'robots', 'robot_hall.yaml'), '--episodes', '4',
                          *words, environment={'PATH': runner.path('programs') + ':' + os.environ['PATH']})

    def test_a_complete_record_replaces_the_earlier_one(self, runner):
        driven = self.launched(runner, f'cp {runner.path("rows.csv")} "$record"\n')
        assert driven.wait() == 0, driven.output()
        assert read_text(runner.path('robots.csv')) == COLUMNS + ROWS
        assert not os.path.exists(runner.path('.robots.csv.part'))

    def test_recordings(self, runner):
        """Their folders are passed on as absolute paths."""
        self.launched(runner, f'echo "$@" > {runner.path("words")}\n').wait()
        assert 'robot_logs' not in read_text(runner.path('words'))
        shutil.rmtree(runner.path('programs'))
        self.launched(runner, f'echo "$@" > {runner.path("words")}\n', '--robot-logs', runner.path('logs'),
                      '--robot-series', 'series').wait()
        assert_says(read_text(runner.path('words')), f' robot_logs:={runner.path("logs")} ',
                    f' robot_series:={os.path.join(os.getcwd(), "series")} ')

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

    @pytest.mark.parametrize('text, said', [
        ('name: empty\n', 'expected a scenario with robots'), ('robots: tug\n', 'expected a scenario with robots'),
        ('robots: []\n', 'expected a scenario with robots')])
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
