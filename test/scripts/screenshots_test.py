"""scripts/screenshots: pictures of RViz without a display, films, and pictures in a browser."""
import os
import pathlib
import shutil
import subprocess

import pytest
from crowd_screenshots import web_pictures
from matplotlib.image import imread
from programs import PATIENCE, in_package
from renderer import variables

TOOL_COLOUR = 0.1, 0.45, 0.9  # of outlines
BEST_COLOUR = 0.993, 0.906, 0.144  # of the wedge of the best move
CHOSEN_COLOUR = 0.99, 0.89, 0.27  # of the bar of the best move on the page
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

    def test_films(self, tmp_path):
        status, output = run('film', '--output', tmp_path)
        assert status == 0, output
        files = [pathlib.Path(line) for line in output.splitlines()]
        assert [file.name for file in files] == [
            'film_station.gif', 'film_museum.gif', 'film_two_way_door.gif', 'film_robot_door.gif']
        sizes = [file.stat().st_size for file in files]
        assert 1e6 < sizes[0] < 3e6 and 1e5 < min(sizes[1:]) and max(sizes[1:]) < 1.5e6

    @pytest.mark.skipif(shutil.which('chromium') is None, reason='chromium is not installed')
    def test_report(self, tmp_path):
        status, output = run('report', '--output', tmp_path)
        assert status == 0, output
        assert imread(tmp_path / 'report.png').std() > 0.05  # not blank

    @pytest.mark.skipif(None in map(shutil.which, ('chromium', 'npm')), reason='chromium or npm is not installed')
    def test_page(self, tmp_path, monkeypatch):
        """The first picture; the others differ in the scenario."""
        monkeypatch.setattr(web_pictures, 'PICTURES', {'web_6': web_pictures.PICTURES['web_6']})
        file, = web_pictures.web(tmp_path)
        assert file == tmp_path / 'web_6.png' and file.stat().st_size < 2.5e5
        picture = imread(file)
        assert picture.shape[:2] == (720, 1280) and count_like(picture, CHOSEN_COLOUR) > 500

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
