"""scripts/screenshots: pictures of RViz without a display."""
import os
import shutil
import subprocess

import pytest
from matplotlib.image import imread
from programs import PATIENCE, in_package
from renderer import variables

TOOL_COLOUR = 0.1, 0.45, 0.9  # of outlines
BEST_COLOUR = 0.993, 0.906, 0.144  # of the wedge of the best move
SECTOR_COLOUR = 0.96, 0.85, 0.66  # of a sector in which the chosen agent perceives another one
LIKE = 0.06


def run(*arguments):
    """Returns exit status and output of the script."""
    done = subprocess.run([in_package('scripts', 'screenshots'), *map(str, arguments)], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, timeout=5 * PATIENCE, check=False,
                          env=dict(os.environ, **variables()))
    return done.returncode, done.stdout.decode()


def count_like(picture, colour):
    """Returns the number of pixels with approximately this colour."""
    return int((abs(picture[:, :, :3] - colour).max(axis=2) < LIKE).sum())


class ScreenshotsTest:
    """The whole script."""

    def test_pictures_show_panel_and_tools(self, tmp_path):
        status, output = run('rviz', '--output', tmp_path)
        assert status == 0, output
        panel, tools = (imread(tmp_path / name) for name in ('rviz_panel.png', 'rviz_tools.png'))
        assert panel.shape[:2] == tools.shape[:2] == (800, 1280)
        assert count_like(tools, TOOL_COLOUR) > count_like(panel, TOOL_COLOUR) + 500
        values, people = (imread(tmp_path / name) for name in ('rviz_values.png', 'rviz_people.png'))
        assert count_like(values, BEST_COLOUR) > 100
        assert people.shape[:2] == (600, 890)
        assert count_like(imread(tmp_path / 'rviz_thesis.png'), SECTOR_COLOUR) > 1000

    def test_film(self, tmp_path):
        status, output = run('film', '--output', tmp_path)
        assert status == 0, output
        assert output.splitlines() == [str(tmp_path / 'film_station.gif')]
        assert 1e6 < (tmp_path / 'film_station.gif').stat().st_size < 3e6

    @pytest.mark.skipif(shutil.which('chromium') is None, reason='chromium is not installed')
    def test_report(self, tmp_path):
        status, output = run('report', '--output', tmp_path)
        assert status == 0, output
        assert imread(tmp_path / 'report.png').std() > 0.05  # not blank

    @pytest.mark.parametrize('word', ['--nonsense', 'nonsense'])
    def test_wrong_usage(self, word):
        status, output = run(word)
        assert status == 2
        assert word in output

    def test_help_has_an_example(self):
        status, output = run('--help')
        assert status == 0
        assert 'scripts/screenshots --output /tmp' in output

    def test_folder_that_cannot_be_made(self, tmp_path):
        file = tmp_path / 'file'
        file.write_text('')
        status, output = run('--output', file / 'folder')
        assert status == 1
        assert str(file) in output
