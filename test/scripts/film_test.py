"""scripts/film: films of scenarios and recordings, without a display and without ROS."""
import os
import shutil
import signal
import subprocess

import numpy
import PIL.Image
import pytest
from film_files import frames_of, recorded
from programs import PATIENCE, assert_says, in_package, tools_folder, wait_for

FILM = in_package('scripts', 'film')


def film(runner, *arguments, environment=None):
    """Runs the program in the test's folder. Returns exit status and output."""
    done = subprocess.run([FILM, *map(str, arguments)], cwd=runner.folder, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, timeout=PATIENCE, check=False, env=environment)
    return done.returncode, done.stdout.decode(errors='replace')


class ProgramTest:
    """The program."""

    def test_a_recording_as_a_gif(self, runner):
        status, output = film(runner, *recorded(runner), '--speed', 2, '--fps', 10, '--size', 400, '--output', 'a.gif')
        assert status == 0, output
        assert_says(output, 'a.gif: 21 frames of')
        with PIL.Image.open(runner.path('a.gif')) as picture:
            assert picture.n_frames == 21
            assert picture.info['duration'] == 100
            assert picture.info['loop'] == 0
            assert max(picture.size) == 400

    def test_a_scenario_as_a_webp(self, runner):
        """The program walks it; places have another Q-table than the other scenarios."""
        for scenario in ('place_corner', 'circle6'):
            status, output = film(runner, scenario, '--tools', tools_folder(), '--duration', 2, '--size', 320,
                                  '--output', 'a.webp')
            assert status == 0, output
            assert_says(output, f'walking {scenario}')
            assert len(frames_of(runner.path('a.webp'))) == 11

    def test_recorded_people_of_a_scenario(self, runner):
        status, output = film(runner, 'recorded_street', '--tools', tools_folder(), '--duration', 0.5, '--size', 320,
                              '--output', 'a.gif')
        assert status == 0, output

    def test_robots_stand_at_their_start(self, runner):
        status, output = film(runner, 'robot_hall', '--tools', tools_folder(), '--duration', 1, '--size', 400,
                              '--output', 'a.gif')
        assert status == 0, output
        gold = numpy.abs(frames_of(runner.path('a.gif'))[-1].astype(int) - (242, 169, 0)).max(axis=2) < 12
        assert gold.sum() > 50

    def test_a_limit_of_the_size(self, runner):
        arguments = (*recorded(runner), '--output', 'a.gif', '--speed', 0.5)
        status, output = film(runner, *arguments, '--max-size', 0.3)
        assert status == 0, output
        assert os.path.getsize(runner.path('a.gif')) <= 3e5
        assert_says(output, 'too large; once more with')
        status, output = film(runner, *arguments, '--max-size', 0.001)
        assert status == 1, output
        assert_says(output, 'more than 0.001 MB', 'shorter --duration')
        assert os.path.getsize(runner.path('a.gif')) <= 3e5  # the earlier film is unchanged
        assert sorted(os.listdir(runner.folder)) == ['a.gif', 'line.csv', 'line.yaml']

    @pytest.mark.skipif(shutil.which('ffmpeg') is None, reason='ffmpeg is not installed')
    def test_mp4(self, runner):
        status, output = film(runner, *recorded(runner), '--speed', 2, '--fps', 10, '--size', 401, '--output', 'a.mp4')
        assert status == 0, output
        probe = ['ffprobe', '-v', 'error', '-count_frames', '-show_entries', 'stream=codec_name,nb_read_frames', '-of',
                 'csv=p=0', runner.path('a.mp4')]
        assert subprocess.run(probe, capture_output=True, check=True, text=True).stdout.strip() == 'h264,21'

    def test_mp4_without_ffmpeg(self, runner):
        os.mkdir(runner.path('programs'))
        environment = dict(os.environ, PATH=runner.path('programs'))
        status, output = film(runner, *recorded(runner), '--output', 'a.mp4', environment=environment)
        assert status == 1, output
        assert_says(output, 'film: ffmpeg is not installed', '.gif or .webp')
        assert not os.path.exists(runner.path('a.mp4'))

    def test_interrupted(self, runner):
        process = runner.start('film', [FILM, *recorded(runner), '--speed', '0.001', '--output', runner.path('a.gif')])
        wait_for(lambda: os.path.exists(runner.path('.a.gif.part')), 'the file to be begun')
        process.signal(signal.SIGINT)
        assert process.wait() == 130
        assert_says(process.output(), 'film: interrupted, nothing was written')
        assert not [name for name in os.listdir(runner.folder) if '.gif' in name]

    @pytest.mark.parametrize('status, arguments, words', [
        (2, ['circle6', '--output', 'a.avi'], ['--output', '.gif, .webp, .mp4', "'a.avi'"]),
        (2, ['circle6', '--output', 'a.gif', '--speed', '0'], ['--speed', 'a number above 0']),
        (2, ['circle6', '--output', 'a.gif', '--view', '1', '0', '0', '1'], ['--view', 'X0 < X1']),
        (1, ['circel6', '--output', 'a.gif'], ["no scenario 'circel6', did you mean 'circle6'?"]),
        (1, ['circle6', '--output', 'none/a.gif'], ['none/a.gif: cannot be written: there is no folder /']),
        (1, ['circle6', '--output', 'a.gif', '--view', '100', '100', '110', '110'], ['--view: nothing of the scene']),
        (1, ['circle6', '--output', 'a.gif', '--speed', '100000'], ['--speed: the film would have one frame']),
        (1, ['circle6', '--output', 'a.webp', '--size', '4000', '--speed', '1'], ['.mp4', 'GB of memory']),
        (2, ['--output', 'a.gif', '--trajectories', 'a.csv', '--seed', '3'], ['--seed: a recording is not walked']),
        (2, ['--output', 'a.gif', '--trajectories', 'a.csv', '--q-table', 'a'], ['--q-table: a recording is not']),
        (2, ['circle6', '--output', 'a.gif', '--fps', 'many'], ["expected a number above 0, got 'many'"]),
        (1, ['circle6', '--output', 'a.gif', '--q-table', 'none.txt'], ["no Q-table 'none.txt'"]),
        (1, ['circle6', '--output', 'a.gif', '--trajectories', 'none.csv'], ['none.csv', 'No such file']),
        (1, ['circle6', '--output', 'a.gif', '--start', '900'], ['--start: the recording ends at', '900']),
    ])
    def test_errors(self, runner, status, arguments, words):
        got, output = film(runner, *arguments, '--tools', tools_folder())
        assert got == status, output
        assert_says(output, *words)
        assert 'Traceback' not in output
        assert os.listdir(runner.folder) == []
