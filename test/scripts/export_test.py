"""scripts/export: people of runs as glTF, BVH and CSV."""
import json
import os
import shutil
import subprocess
from pathlib import Path

import numpy
import pytest
from crowd_recordings.formats import read_recording
from foot_slide import FINER, feet_of, rows_of, slides_of, stances
from glb import Glb
from node_packages import install_clients
from programs import PATIENCE, assert_says, in_package, tools_folder

EXPORT = in_package('scripts', 'export')
# Runs that turn, stop, walk slowly and stand, with children and wheelchairs; with the Q-tables of both kinds.
RUNS = [('place_corner', 1, 'human'), ('place_two_way_door', 2, 'human'), ('circle6_obstacle', 1, 'anticipation'),
        ('kinds_hall', 3, 'anticipation'), ('robot_door', 1, 'human')]
SECONDS = 10  # that are exported
PEOPLE = 6  # of each run whose feet are looked at
SLIDE = 0.01  # greatest mean of a step [m]
TOLERANCE = 0.05 + 0.01  # of places: of the smoothed path, and of what the keyframes leave out [m]


def export(folder, *arguments):
    """Runs the program. Returns exit status and output."""
    done = subprocess.run([EXPORT, *map(str, arguments)], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          timeout=PATIENCE, check=False)
    return done.returncode, done.stdout.decode(errors='replace')


@pytest.fixture(scope='module')
def runs(tmp_path_factory):
    """Exported runs by scenario: folders with a.glb, a.csv, bvh/, and the recording NAME.csv or log.jsonl."""
    folders = {}
    for scenario, seed, table in RUNS:
        folder = folders[scenario] = tmp_path_factory.mktemp(scenario)
        table = in_package('config', 'q_tables', f'{table}.txt')
        file, = Path(in_package('config', 'scenarios')).rglob(f'{scenario}.yaml')
        subprocess.run([os.path.join(tools_folder(), 'evaluate'), '--q-table', table, '--episodes', '1', '--seed',
                        str(seed), '--trajectories', folder, '--scenes', folder, '--robot', 'reactive', '--robot-log',
                        folder / 'log.jsonl', file], check=True, stdout=subprocess.DEVNULL)
        log = folder / 'log.jsonl'
        recording = log if log.stat().st_size else folder / f'{scenario}.csv'
        status, output = export(folder, folder / f'{scenario}.yaml', '--trajectories', recording, '--duration', SECONDS,
                                '--gltf', 'a.glb', '--csv', 'a.csv', '--bvh', 'bvh')
        assert status == 0, output
        (folder / 'recording').symlink_to(recording)
    return folders


class FileTest:
    """What is in a glTF file."""

    def test_the_validator_finds_nothing(self, runs, tmp_path):
        install_clients(tmp_path)
        for folder in runs.values():
            report = json.loads(subprocess.check_output(['node', 'validate_gltf.mjs', folder / 'a.glb'], cwd=tmp_path,
                                                        timeout=PATIENCE))
            assert (report['numErrors'], report['numWarnings'], report['numInfos']) == (0, 0, 0), report['messages']
            assert report['info']['animationCount'] == 1

    def test_places_are_those_of_the_recording(self, runs):
        for folder in runs.values():
            glb, recording = Glb(folder / 'a.glb'), read_recording(folder / 'recording')
            for node in (node for node, entry in enumerate(glb.nodes) if 'extras' in entry):
                person = glb.nodes[node]['extras']['person']
                walk = numpy.array(recording.walks[person])
                times, places = walk[:, 0] * 0.1, walk[:, 1:]
                begin, end = glb.keys(node, 'translation')[0][[0, -1]]
                there = (times >= begin - 1e-6) & (times <= end + 1e-6)
                world = glb.world(node, times[there])[:, :3, 3]  # x, z, -y
                away = numpy.linalg.norm(world[:, [0, 2]] * [1, -1] - places[there], axis=1)
                assert away.max() < TOLERANCE, person
                assert numpy.abs(world[:, 1]).max() < 1e-6

    def test_people_are_there_while_they_walk(self, runs):
        glb = Glb(runs['kinds_hall'] / 'a.glb')
        later = 0
        for person, rows in rows_of(runs['kinds_hall'] / 'a.csv').items():
            begin, end = float(rows[0]['time']), float(rows[-1]['time'])
            times = numpy.array([begin - 0.02, begin + 0.01, end - 0.01, end + 0.04])
            sizes = glb.animated(glb.named(person), 'scale', times)[:, 0]
            later += begin > 0
            assert (sizes[1:3] > 0.5).all(), person
            assert begin == 0 or sizes[0] == 0, person
            assert end > SECONDS - 0.1 or sizes[3] == 0, person
        assert later > 3

    def test_surroundings(self, runs):
        names = {name: {node['name'] for node in Glb(folder / 'a.glb').nodes} for name, folder in runs.items()}
        assert {'floor', 'walls'} <= names['place_corner']
        assert 'obstacle_0' in names['circle6_obstacle']
        assert {'wheelchair', 'stick'} <= names['kinds_hall']
        robot = Glb(runs['robot_door'] / 'a.glb')
        assert numpy.ptp(robot.keys(robot.named('robot_0'), 'translation')[1], axis=0).max() > 1.0

    def test_size_of_a_second_of_a_person(self, runs):
        """200 people for 60 s are 12,000 of them, and must have less than 30 MB."""
        seconds = sum(len(rows) for rows in rows_of(runs['place_two_way_door'] / 'a.csv').values()) / 30
        assert os.path.getsize(runs['place_two_way_door'] / 'a.glb') - 300_000 < 30e6 / 12_000 * seconds


class GaitTest:
    """How people walk."""

    def test_feet_do_not_slide(self, runs):
        """The point of a foot on the floor stays where it is while the foot stands, also between keyframes."""
        for scenario, folder in runs.items():
            glb, slides, shares = Glb(folder / 'a.glb'), [], []
            walkers = {name: rows for name, rows in rows_of(folder / 'a.csv').items() if rows[0]['left_x']}
            for person, rows in list(walkers.items())[:PEOPLE]:
                for stands, heights, moves in feet_of(glb, person, rows):
                    slides += slides_of(stands, moves)
                    shares.append(stands.mean())
                    assert heights.min() > -0.01
                    for begin, end in stances(stands):
                        assert heights[FINER * begin:FINER * end + 1].max() < 0.02
            assert numpy.mean(slides) < SLIDE, scenario
            assert len(slides) > 50 and 0.55 < numpy.mean(shares) < 1, scenario  # 60 % of a cycle of who walks

    def test_knees_and_elbows_bend_one_way(self, runs):
        for folder in runs.values():
            glb = Glb(folder / 'a.glb')
            for node, entry in enumerate(glb.nodes):
                part = entry['name'].rpartition('_')[2]
                if part in ('shank', 'forearm') and (node, 'rotation') in glb.channels:
                    x, y, z, w = glb.keys(node, 'rotation')[1].T
                    degrees = numpy.degrees(2 * numpy.arctan2(x, w)) * (1 if part == 'shank' else -1)
                    assert numpy.abs([y, z]).max() < 1e-3  # a hinge
                    assert 0 <= degrees.min() and degrees.max() < (100 if part == 'shank' else 80), entry['name']

    def test_who_stands_has_both_feet_on_the_floor(self, runner):
        runner.write('stands.csv', 'instance,tick,agent,x,y\n' + ''.join(f'0,{tick},0,1,2\n' for tick in range(30)))
        status, output = export(runner.folder, '--trajectories', 'stands.csv', '--gltf', 'a.glb', '--csv', 'a.csv')
        assert status == 0, output
        rows, = rows_of(runner.path('a.csv')).values()
        assert all(row[f'{side}_stands'] == '1' for row in rows for side in ('left', 'right'))
        assert [key for key in Glb(runner.path('a.glb')).channels if key[1] == 'rotation'] == []


class BvhTest:
    """BVH files."""

    def test_hips_are_where_they_are_in_the_csv(self, runs):
        for person, rows in list(rows_of(runs['kinds_hall'] / 'a.csv').items())[:4]:
            text = (runs['kinds_hall'] / 'bvh' / f'{person}.bvh').read_text()
            head, motion = text.split('MOTION\n')
            lines = motion.splitlines()
            assert lines[:2] == [f'Frames: {len(rows)}', f'Frame Time: {1 / 30:.8f}']
            frames = numpy.loadtxt(lines[2:])
            assert frames.shape == (len(rows), 3 * (head.count('JOINT') + 2))
            assert head.count('{') == head.count('}') == head.count('OFFSET')
            heights = [float(row['hips_z']) for row in rows]
            assert numpy.allclose(frames[:, 1], heights, atol=1e-3)
            places = numpy.array([(float(row['x']), -float(row['y'])) for row in rows])
            assert numpy.abs(frames[:, [0, 2]] - places).max() < 0.06  # hips sway

    @pytest.mark.skipif(shutil.which('blender') is None, reason='blender is not installed')
    def test_blender_imports_both(self, runs):
        folder = runs['circle6_obstacle']
        done = subprocess.run(['blender', '--background', '--factory-startup', '--python-exit-code', '1', '--python',
                               in_package('test', 'support', 'blender_import.py'), '--', folder / 'a.glb',
                               folder / 'bvh' / 'person_0.bvh'], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              timeout=PATIENCE, check=False)
        output = done.stdout.decode(errors='replace')
        found = json.loads(next(line[6:] for line in output.splitlines() if line.startswith('FOUND ')))
        people = rows_of(folder / 'a.csv')
        assert found['people'] == len(people)
        for person, rows in people.items():
            for frame in (1, 30):  # Blender's x and y are those of the map
                place = [float(rows[frame][axis]) for axis in 'xy']
                assert numpy.allclose(found[str(frame)][person], place, atol=0.01)
        assert found['bvh'][0] == 16


class ProgramTest:
    """The program."""

    def test_a_scenario(self, runner):
        status, output = export(runner.folder, 'circle6', '--tools', tools_folder(), '--duration', 2, '--gltf', 'a.glb')
        assert status == 0, output
        assert_says(output, 'walking circle6', '6 people, 2 s, 30 frames a second', 'a.glb: 0.')

    @pytest.mark.parametrize('rows, words', [
        ('0,0,0,1,2\n', 'the recording ends at 0 s'),
        ('0,0,0,1,2\n0,900000000,0,2,2\n', 'shorter --duration'),
        ('0,0,0,1e300,2\n0,10,0,2,2\n', 'person_0 is farther than 100000 m'),
    ])
    def test_recordings_that_cannot_be_shown(self, runner, rows, words):
        runner.write('a.csv', 'instance,tick,agent,x,y\n' + rows)
        status, output = export(runner.folder, '--trajectories', 'a.csv', '--gltf', 'a.glb')
        assert status == 1, output
        assert_says(output, words)
        assert os.listdir(runner.folder) == ['a.csv']

    @pytest.mark.parametrize('status, arguments, words', [
        (2, ['circle6'], ['expected --gltf, --bvh or --csv']),
        (2, ['--gltf', 'a.glb'], ['expected a SCENARIO or --trajectories']),
        (2, ['circle6', '--gltf', 'a.gltf'], ['--gltf: expected a name with .glb', "'a.gltf'"]),
        (2, ['circle6', '--csv', 'a.txt'], ['--csv: expected a name with .csv']),
        (2, ['circle6', '--gltf', 'a.glb', '--fps', '1'], ['--fps', 'a number from 10 to 240']),
        (1, ['circel6', '--gltf', 'a.glb'], ["no scenario 'circel6', did you mean 'circle6'?"]),
        (1, ['circle6', '--gltf', 'none/a.glb'], ['none/a.glb: cannot be written: there is no folder /']),
        (1, ['circle6', '--bvh', 'none/people'], ['none/people: cannot be written: there is no folder /']),
        (1, ['circle6', '--gltf', 'a.glb', '--start', '900'], ['--start: the recording ends at', '900']),
        (1, ['--trajectories', 'none.csv', '--gltf', 'a.glb'], ['none.csv', 'No such file']),
    ])
    def test_errors(self, runner, status, arguments, words):
        got, output = export(runner.folder, *arguments, '--tools', tools_folder())
        assert got == status, output
        assert_says(output, *words)
        assert 'Traceback' not in output
        assert os.listdir(runner.folder) == []
