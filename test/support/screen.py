"""A separate screen (Xvfb) on which programs draw in software."""
import os
import signal
import subprocess

from matplotlib.image import imread
from renderer import variables

SIZE = '1280x900x24'


class Screen:
    """A screen on which programs draw in software."""

    def __init__(self, size=SIZE):
        read, write = os.pipe()
        # Without -noreset it starts anew whenever the last client leaves, and refuses clients meanwhile.
        self.process = subprocess.Popen(['Xvfb', '-displayfd', str(write), '-noreset', '-screen', '0', size],
                                        pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as displays:
            number = displays.readline().strip()
        self.variables = dict(variables(), DISPLAY=':' + number)
        self.environment = dict(os.environ, **self.variables)

    def picture(self, file):
        """Writes a PNG file of the screen. Returns its pixels [rows, columns, rgb], or None if there are none yet."""
        command = ['import', '-window', 'root', 'png24:' + file]  # in colour, also while the screen is still grey
        taken = subprocess.run(command, env=self.environment, stderr=subprocess.DEVNULL, check=False)
        return imread(file) if taken.returncode == 0 else None

    def use(self, *words):
        """Moves the mouse, clicks and types, as xdotool does."""
        subprocess.run(['xdotool', *map(str, words)], env=self.environment, check=True, stdout=subprocess.DEVNULL)

    def close(self):
        """Ends the screen."""
        end(self.process)


def end(process):
    """Ends a program."""
    process.send_signal(signal.SIGTERM)
    try:
        process.wait(10.0)
    except subprocess.TimeoutExpired:
        process.kill()
