"""scripts/screenshots: pictures of RViz without a display."""
import subprocess

from matplotlib.image import imread
from programs import PATIENCE, in_package

TOOL_COLOUR = 0.1, 0.45, 0.9  # of outlines
LIKE = 0.06


def run(*arguments):
    """Returns exit status and output of the script."""
    done = subprocess.run([in_package('scripts', 'screenshots'), *map(str, arguments)], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, timeout=2 * PATIENCE, check=False)
    return done.returncode, done.stdout.decode()


def count_like(picture, colour):
    """Returns the number of pixels with approximately this colour."""
    return int((abs(picture[:, :, :3] - colour).max(axis=2) < LIKE).sum())


class ScreenshotsTest:
    """The whole script."""

    def test_pictures_show_panel_and_tools(self, tmp_path):
        status, output = run('--output', tmp_path)
        assert status == 0, output
        panel, tools = (imread(tmp_path / name) for name in ('rviz_panel.png', 'rviz_tools.png'))
        assert panel.shape[:2] == tools.shape[:2] == (800, 1280)
        assert count_like(tools, TOOL_COLOUR) > count_like(panel, TOOL_COLOUR) + 500

    def test_wrong_usage(self):
        status, output = run('--nonsense')
        assert status == 2
        assert '--nonsense' in output

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
