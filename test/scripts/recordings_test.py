"""Formats of recorded trajectories, and convert_trajectories."""
import math
import os
import re
import subprocess

import numpy
import pytest
from crowd_drawing.errors import InputError
from crowd_drawing.files import read_scene
from crowd_recordings.formats import read_recording, read_shown, recorded_people
from programs import CIRCLE6, NEAREST_TABLE, PATIENCE, assert_says, in_package, read_text

CSV = 'instance,tick,agent,x,y\n0,0,0,1.5,2\n0,0,1,-3,0.1\n0,1,0,1.6,2\n1,0,0,9,9\n'
JUPEDSIM = '''# description: made by hand
#framerate: 8.00
#geometry: geometry.xml
#ID\tFR\tX\tY\tZ\tA\tB\tANGLE
7\t3\t1.5\t2\t0\t0.2\t0.2\t90
7 4 1.75 2 0 0.2 0.2 90
2 4 -3 1e-1 0 0.2 0.2 0
'''
# Person 5 in frames 780 and 786, person 9 in frame 792; y is the fifth column.
OBSMAT = ('   7.8000000e+02   5.0000000e+00   8.5   0   3.5   1.6   0   0.1\n'
          '   7.8600000e+02   5.0000000e+00   9.1   0   3.6   1.6   0   0.3\n'
          '   7.9200000e+02   9.0000000e+00   -1   0   2   0   0   0\n')
PEOPLE = in_package(os.pardir, 'shared', 'data', 'pedestrians')


def pedpy_rules(file):
    """Reads a file as PedPy's load_trajectory_from_txt() does. Returns frame rate, unit and rows (id, frame, x, y)."""
    rate = unit = None
    lines = read_text(file).splitlines()
    for line in lines:
        if not line.startswith('#'):
            break
        if 'framerate' in line:
            numbers = [word for word in line.split() if re.fullmatch(r'[-+.\deE]+', word)]
            rate = float(numbers[0]) if rate is None else rate
        if 'x/m' in line.lower() or 'in m' in line.lower():
            unit = 'm'
    rows = [line.split()[:4] for line in lines if not line.startswith('#')]
    return rate, unit, [(int(i), int(frame), float(x), float(y)) for i, frame, x, y in rows]


def convert(runner, *arguments):
    """Runs the program in the test's folder. Returns exit status and output."""
    done = subprocess.run([in_package('scripts', 'convert_trajectories'), *map(str, arguments)], cwd=runner.folder,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=PATIENCE, check=False)
    return done.returncode, done.stdout.decode(errors='replace')


class FormatTest:
    """The three formats."""

    def test_csv(self, runner):
        file = runner.write('walk.csv', CSV)
        recording = read_recording(file)
        assert recording.walks == {0: [(0, 1.5, 2), (1, 1.6, 2)], 1: [(0, -3, 0.1)]}
        assert recording.frame_duration is None
        assert read_recording(file, 1).walks == {0: [(0, 9, 9)]}

    def test_jupedsim(self, runner):
        """Older files have more columns."""
        recording = read_recording(runner.write('walk.txt', JUPEDSIM))
        assert recording.walks == {2: [(4, -3, 0.1)], 7: [(3, 1.5, 2), (4, 1.75, 2)]}
        assert recording.frame_duration == 1 / 8

    def test_jupedsim_in_centimetres(self, runner):
        text = '# framerate: 25 fps\n# id frame x/cm y/cm z/cm\n1 0 150 -20 0\n'
        assert read_recording(runner.write('walk.txt', text)).walks == {1: [(0, 1.5, -0.2)]}

    def test_jupedsim_without_a_header(self, runner):
        recording = read_recording(runner.write('walk.txt', '1 0 1.5 2\n'))
        assert (recording.walks, recording.frame_duration) == ({1: [(0, 1.5, 2)]}, None)
        assert recording.at_rate(4).frame_duration == 0.25

    def test_obsmat(self, runner):
        """Only the annotated frames count, every 0.4 s."""
        recording = read_recording(runner.write('obsmat.txt', OBSMAT))
        assert recording.walks == {5: [(0, 8.5, 3.5), (1, 9.1, 3.6)], 9: [(2, -1, 2)]}
        assert recording.frame_duration == 0.4

    def test_obsmat_with_a_person_between_the_annotated_frames(self, runner):
        """Frames are counted in the step that all have in common, here 2 frames, a third of 0.4 s."""
        recording = read_recording(runner.write('obsmat.txt', OBSMAT + '788 3 0 0 0 0 0 0\n'))
        assert recording.walks[3] == [(4, 0, 0)]
        assert recording.walks[5] == [(0, 8.5, 3.5), (3, 9.1, 3.6)]
        assert recording.frame_duration == pytest.approx(0.4 / 3)

    @pytest.mark.parametrize('name, people, rows', [('eth', 360, 8908), ('zara01', 148, 5024)])
    def test_recordings_of_people(self, name, people, rows):
        """They walk at the speeds of people, so that the time between frames is right."""
        file = os.path.join(PEOPLE, name, 'obsmat.txt')
        if not os.path.exists(file):
            pytest.skip(f'there is no {file}')
        recording = read_recording(file)
        assert (len(recording.walks), sum(map(len, recording.walks.values()))) == (people, rows)
        speeds = [math.dist(walk[0][1:], walk[-1][1:]) / (walk[-1][0] - walk[0][0]) / recording.frame_duration
                  for walk in recording.walks.values() if len(walk) > 5]
        assert 1.1 < sorted(speeds)[len(speeds) // 2] < 1.6

    @pytest.mark.parametrize('text, words', [
        ('', ['walk:1: is not a recording', 'instance,tick,agent,x,y', 'obsmat.txt']),
        ('name: scene\n', ['walk:1: is not a recording']),
        ('# framerate: 0\n1 0 1 1 0\n', ["walk:1: expected a frame rate above 0, got '0'"]),
        ('# framerate: 1e999\n1 0 1 1 0\n', ["walk:1: expected a frame rate above 0, got '1e999'"]),
        ('# framerate: 8\n1 0 1 1 0\n1 half 1 1 0\n', ["walk:3: expected id, frame, x and y, got '1 half 1 1 0'"]),
        ('# framerate: 8\n1 0 1\n', ['walk:2: expected id, frame, x and y']),
        ('# framerate: 8\n1 0 1 1 0\n1 0 2 1 0\n', ['walk:3: person 1 is in frame 0 for the second time']),
        ('# framerate: 8\n1 -1 1 1 0\n', ['walk:2: expected numbers of person and frame from 0']),
        ('# framerate: 8\n1 0 nan 1 0\n', ['walk:2:', 'finite positions']),
        ('# framerate: 8\n', ['walk: has no trajectory']),
        (OBSMAT + '1 2 3\n', ['walk:4: expected frame, person, x, z, y']),
        (OBSMAT + '1.5 2 3 0 0 0 0 0\n', ['walk:4: expected frame, person, x, z, y']),
        ('instance,tick,agent,x,y\n0,0,0,1,2\n1,0,0,1,2\n0,0,0,1.5,2\n', ['walk:4: agent 0 is in tick 0']),
        ('instance,tick,agent,x,y\n0,0,0,a,1\n', ['walk:2: expected three whole numbers']),
    ])
    def test_errors(self, runner, text, words):
        with pytest.raises(InputError) as caught:
            read_recording(runner.write('walk', text))
        assert_says(str(caught.value), *words)


class ConversionTest:
    """convert_trajectories."""

    def test_to_pedpy_and_back(self, runner):
        """All positions of an episode, bit for bit."""
        runner.tool('evaluate', '--q-table', NEAREST_TABLE, '--trajectories', runner.folder, CIRCLE6)
        status, output = convert(runner, 'circle6.csv', '--output', 'circle6.txt')
        assert status == 0, output
        assert_says(output, 'circle6.txt: 6 people', '10 frames a second')
        rate, unit, rows = pedpy_rules(runner.path('circle6.txt'))
        expected = read_recording(runner.path('circle6.csv')).walks
        assert (rate, unit) == (10.0, 'm')
        assert sorted(rows) == sorted((agent, *row) for agent, walk in expected.items() for row in walk)
        status, output = convert(runner, 'circle6.txt', '--output', 'back.csv')
        assert status == 0, output
        assert read_text(runner.path('back.csv')) == read_text(runner.path('circle6.csv'))

    def test_other_instance_and_rate(self, runner):
        runner.write('walk.csv', CSV)
        status, output = convert(runner, 'walk.csv', '--output', 'walk.txt', '--instance', 1, '--frame-rate', 4)
        assert status == 0, output
        assert pedpy_rules(runner.path('walk.txt')) == (4.0, 'm', [(0, 0, 9.0, 9.0)])

    def test_obsmat_to_csv(self, runner):
        runner.write('obsmat.txt', OBSMAT)
        status, output = convert(runner, 'obsmat.txt', '--output', 'people.csv')
        assert (status, output) == (0, 'people.csv: 2 people, 3 positions, 2.5 frames a second\n'
                                    'A CSV file has no frame rate: give --frame-rate 2.5 to programs that read it.\n')
        assert read_text(runner.path('people.csv')) == \
            'instance,tick,agent,x,y\n0,0,5,8.5,3.5\n0,1,5,9.1,3.6\n0,2,9,-1.0,2.0\n'

    @pytest.mark.parametrize('status, arguments, words', [
        (2, ['walk.csv', '--output', 'a.xml'], ['--output', '.csv or .txt', "'a.xml'"]),
        (2, ['walk.csv', '--output', 'a.txt', '--frame-rate', '0'], ['--frame-rate', 'a number above 0']),
        (1, ['none.csv', '--output', 'a.txt'], ['none.csv: No such file']),
        (1, ['walk.csv', '--output', 'none/a.txt'], ['none/a.txt: cannot be written: there is no folder /']),
        (1, ['walk.csv', '--output', 'a.txt', '--instance', '7'], ['has no instance 7, expected 0 to 1']),
        (1, ['obsmat.txt', '--output', 'a.txt', '--instance', '1'], ['has no instance 1, expected 0']),
    ])
    def test_errors(self, runner, status, arguments, words):
        runner.write('walk.csv', CSV)
        runner.write('obsmat.txt', OBSMAT)
        got, output = convert(runner, *arguments)
        assert got == status, output
        assert_says(output, *words)
        assert sorted(os.listdir(runner.folder)) == ['obsmat.txt', 'walk.csv']


class ShownTest:
    """A recording in a scenario."""

    def test_people_who_are_not_its_agents(self, runner):
        """Of the scenario remain walls and the like; CSV files of `evaluate` must fit it."""
        runner.write('obsmat.txt', OBSMAT)
        scenario = runner.write('two.yaml', 'name: two\nagents: [{position: [0, 0], goal: [1, 0], radius: 0.5}]\n'
                                'walls: [[[0, 1], [5, 1]]]\n')
        scene, tracks, _ = read_shown(runner.path('obsmat.txt'), scenario)
        assert (scene.agents, len(scene.walls)) == ([], 1)
        assert max(tracks) > 0
        walk = runner.write('walk.csv', 'instance,tick,agent,x,y\n0,0,3,1,2\n')
        with pytest.raises(InputError, match='has an agent 3, but .* has 1 agents'):
            read_shown(walk, scenario)

    def test_recorded_people(self, runner):
        """The keys of an entry under `recorded` mean what they mean to `evaluate`."""
        runner.write('walk.csv', 'instance,tick,agent,x,y\n3,0,2,0,0\n3,20,2,2,0\n3,10,7,0,5\n3,30,7,2,5\n4,0,9,8,8\n')
        scene = read_scene(runner.write('street.yaml', '''
name: street
recorded:
  - {file: walk.csv, from: 0.5, to: 1.5, offset: 10, shift: [100, 1]}
  - {file: walk.csv, people: [7], frame_rate: 5, radius: 0.3}
  - {file: walk.csv, instance: 4, from: 1}
'''), 0)
        first, second, third = recorded_people(scene)
        for (person, track, radius), number, size, times, places in (
                (first, 2, 0.25, [10, 11], [[100.5, 1], [101.5, 1]]),
                (second, 7, 0.25, [10.5, 11], [[100, 6], [100.5, 6]]),
                (third, 7, 0.3, [2, 6], [[0, 5], [2, 5]])):
            assert (person, radius) == (number, size)
            assert track.times == pytest.approx(times)
            assert track.places == pytest.approx(numpy.array(places))
