"""A separate screen with a launch file on it, and a mouse."""
import os
import shutil
import signal
import subprocess
import tempfile
import time

from crowd_experiments.runs import RunError
from crowd_launching.launch_end import free_port

SIZE = '1280x800x24'
PATIENCE = 120.0  # [s]
PERIOD = 0.2  # [s] between two looks


class Desk:
    """Runs demo.launch with RViz on a screen of its own. Use it in a `with` statement."""

    def __init__(self, *arguments):
        self.arguments = arguments
        self.folder = tempfile.TemporaryDirectory(prefix='social_crowd_screenshots_')
        self.processes = []

    def __enter__(self):
        try:
            display = self._open_screen()
            self.environment = dict(os.environ, DISPLAY=display, LIBGL_ALWAYS_SOFTWARE='1',
                                    ROS_MASTER_URI=f'http://127.0.0.1:{free_port()}', ROS_HOSTNAME='127.0.0.1',
                                    ROS_HOME=self.folder.name)
            log = open(os.path.join(self.folder.name, 'launch.log'), 'wb')
            self.processes.append(subprocess.Popen(['roslaunch', 'social_crowd', 'demo.launch', *self.arguments],
                                                   env=self.environment, stdout=log, stderr=log))
            self.wait_for(['xdotool', 'search', '--onlyvisible', '--name', 'RViz'], 'RViz')
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        for process in reversed(self.processes):
            process.send_signal(signal.SIGINT if process is not self.processes[0] else signal.SIGTERM)
            try:
                process.wait(30.0)
            except subprocess.TimeoutExpired:
                process.kill()
        self.folder.cleanup()

    def _open_screen(self):
        read, write = os.pipe()
        self.processes.append(subprocess.Popen(['Xvfb', '-displayfd', str(write), '-screen', '0', SIZE],
                                               pass_fds=[write], stderr=subprocess.DEVNULL))
        os.close(write)
        with os.fdopen(read) as displays:
            return ':' + displays.readline().strip()

    def run(self, *command):
        """Runs a command on the screen. Returns its output; None if it failed or hung."""
        try:
            done = subprocess.run(list(map(str, command)), env=self.environment, stdout=subprocess.PIPE,
                                  stderr=subprocess.DEVNULL, check=False, timeout=PATIENCE)
        except subprocess.TimeoutExpired:
            return None
        return done.stdout.decode() if done.returncode == 0 else None

    def wait_for(self, command, what, words=''):
        """Repeats a command until it succeeds and its output contains these words."""
        deadline = time.monotonic() + PATIENCE
        while True:
            output = self.run(*command)
            if output is not None and words in output:
                return
            if time.monotonic() > deadline:
                raise RunError(f'timeout of {PATIENCE:g} s while waiting for {what}')
            time.sleep(PERIOD)

    def call(self, service, request):
        """Calls a service with a request in YAML."""
        self.wait_for(['rosservice', 'call', service, request], f'the service {service}', 'success: True')

    def mouse(self, *words):
        """Moves and clicks, with the words of xdotool."""
        if self.run('xdotool', *words) is None:
            raise RunError(f'xdotool failed: {words}')

    def take(self, file, seconds=2.0, crop=None):
        """Waits until RViz has drawn, and takes a picture, or its part (width, height, left, top)."""
        time.sleep(seconds)
        part = ['-crop', '{}x{}+{}+{}'.format(*crop), '+repage'] if crop else []
        fresh = os.path.join(self.folder.name, file.name)
        if self.run('import', '-window', 'root', *part, 'png24:' + fresh) is None:
            raise RunError(f'{file} cannot be written')
        shutil.copyfile(fresh, file)
        return file
