"""Shared code of all Python tests: running programs of this package in a temporary folder, and waiting with a deadline.
Does not need a ROS master."""
import os
import re
import signal
import subprocess
import tempfile
import time

import rospkg
from roslib.packages import find_node

PATIENCE = 90.0  # [s] time limit for events that take almost no time on an idle machine
PERIOD = 0.01  # [s] between two polls
PACKAGE = rospkg.RosPack().get_path('social_crowd')
COLOUR = re.compile(r'\x1b\[[0-9;]*m')


def in_package(*parts):
    """Returns a path in the package."""
    return os.path.join(PACKAGE, *parts)


NEAREST_TABLE = in_package('config', 'q_tables', 'thesis_nearest.txt')
OCCUPANCY_TABLE = in_package('config', 'q_tables', 'thesis_occupancy.txt')
ANTICIPATION_TABLE = in_package('config', 'q_tables', 'anticipation.txt')
CIRCLE6 = in_package('config', 'scenarios', 'circle6.yaml')


def data(name):
    """Returns a file in test/data."""
    return in_package('test', 'data', name)


def page_examples(page):
    """Returns the example files of a page in docs/ by name. An example is `NAME`: followed by a block of code."""
    text = read_text(in_package('docs', page))
    return dict(re.findall(r'^`([\w.]+)`:\n\n```\w+\n(.*?)^```$', text, re.DOTALL | re.MULTILINE))


def page_text(page):
    """Returns the text of a page in docs/."""
    return read_text(in_package('docs', page))


def tools_folder():
    """Returns the folder of the programs train and evaluate."""
    return os.path.dirname(find_node('social_crowd', 'train')[0])


def recording_of(scenario):
    """Returns the name of a scenario file's recording."""
    return os.path.splitext(os.path.basename(scenario))[0] + '.csv'


def wait_for(condition, what, seconds=PATIENCE):
    """Polls until the condition returns a true value, and returns this value."""
    deadline = time.monotonic() + seconds
    while True:
        result = condition()
        if result:
            return result
        if time.monotonic() > deadline:
            raise AssertionError(f'timeout of {seconds:g} s while waiting for {what}')
        time.sleep(PERIOD)


def read_text(file):
    """Returns the contents of a file."""
    with open(file, encoding='utf-8', errors='replace') as stream:
        return stream.read()


def read_bytes(file):
    """Returns the bytes of a file; None if the file does not exist."""
    if not os.path.exists(file):
        return None
    with open(file, 'rb') as stream:
        return stream.read()


def assert_says(text, *words):
    """Checks that a text contains all these words."""
    missing = [word for word in words if word not in text]
    if missing:
        raise AssertionError(f'{missing} are missing in: {text}')


def assert_same_recording(got, expected):
    """Compares recordings byte for byte; the error contains the first different line."""
    if got is None:
        raise AssertionError('there is no recording')
    if got == expected:
        return
    lines = [recording.decode().splitlines() + ['(the end)'] for recording in (got, expected)]
    first = next(i for i, pair in enumerate(zip(*lines)) if pair[0] != pair[1])
    raise AssertionError(f'the recordings differ from line {first + 1}: got {lines[0][first]}, '
                         f'expected {lines[1][first]}')


class Process:
    """A program that runs in parallel with the test; its output is written to a file."""

    def __init__(self, name, command, log, environment=None):
        self.name = name
        self.log = log
        self.is_given_up = False  # killed intentionally; its exit status is ignored
        # The output of roscpp and of Python is read while the program runs.
        unbuffered = {'ROSCONSOLE_STDOUT_LINE_BUFFERED': '1', 'PYTHONUNBUFFERED': '1'}
        environment = {**os.environ, **unbuffered, **(environment or {})}
        with open(log, 'wb') as stream:
            self.process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=stream, stderr=stream,
                                            env=environment)

    def output(self):
        """Returns the output so far, without colours."""
        return COLOUR.sub('', read_text(self.log))

    def is_running(self):
        """Returns whether the program is still running."""
        return self.process.poll() is None

    def wait(self, seconds=PATIENCE):
        """Waits for the end of the program. Returns its exit status."""
        wait_for(lambda: not self.is_running(), f'the end of {self.name}', seconds)
        return self.process.returncode

    def signal(self, number):
        """Sends a signal to the program."""
        self.process.send_signal(number)

    def stop(self):
        """Interrupts the program, as Ctrl-C does. Returns its exit status."""
        if self.is_running():
            self.signal(signal.SIGINT)
        return self.wait()

    def kill(self):
        """Kills the program."""
        self.is_given_up = True
        self.process.kill()
        self.process.wait()

    def clean_up(self):
        """Ends the program. Returns a text if it did not end properly."""
        if self.is_given_up:
            self.process.kill()
            self.process.wait()
            return ''
        was_running = self.is_running()
        try:
            status = self.stop()
        except AssertionError:
            self.kill()
            return f'{self.name} did not end after SIGINT'
        return f'{self.name} ended with exit status {status} after SIGINT' if was_running and status != 0 else ''


class Launch(Process):
    """A roslaunch, which ends with an error if it is interrupted while it starts nodes."""

    NODE = re.compile(r'^    \S+ \(\w+/\S+\)$', re.MULTILINE)  # in the list that it prints first
    STARTED = re.compile(r'^process\[(?!master\]|rosout-).*started with pid', re.MULTILINE)

    def has_started(self):
        """Returns whether all nodes were started."""
        nodes, started = (len(line.findall(self.output())) for line in (self.NODE, self.STARTED))
        return 0 < nodes <= started

    def stop(self):
        """Interrupts it after it has started its nodes. Returns its exit status."""
        try:
            wait_for(lambda: not self.is_running() or self.has_started(), 'the start of all nodes')
        finally:
            status = super().stop()
        return status


class Folder:
    """A folder of a test, with files."""

    def __init__(self, folder):
        self.folder = folder

    def path(self, name):
        """Returns a path in the folder."""
        return os.path.join(self.folder, name)

    def write(self, name, text):
        """Writes a file in the folder. Returns its path."""
        with open(self.path(name), 'w', encoding='utf-8') as stream:
            stream.write(text)
        return self.path(name)


class ProgramRunner(Folder):
    """Runs the programs of a test in the test's folder."""

    def __init__(self, folder, environment=None):
        super().__init__(folder)
        self.environment = environment or {}  # additional variables for all programs
        self.processes = []

    def start(self, name, command, environment=None, kind=Process):
        """Starts a program. Returns its Process, of a class for its kind of program."""
        log = self.path(f'{len(self.processes)}_{name}.log')
        process = kind(name, command, log, dict(self.environment, **(environment or {})))
        self.processes.append(process)
        return process

    def outputs(self):
        """Returns the output of the started programs so far."""
        return ''.join(f'--- output of {process.name}\n{process.output()}\n' for process in self.processes)

    def clean_up(self):
        """Ends the started programs. Returns a line for each program that did not end properly."""
        problems = [process.clean_up() for process in reversed(self.processes)]
        return '\n'.join(problem for problem in problems if problem)

    @staticmethod
    def tool(name, *arguments, within=()):
        """Runs a program of this package, optionally with another program as a prefix. Returns its output."""
        command = [*within, *find_node('social_crowd', name)[:1], *map(str, arguments)]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=PATIENCE, check=False)
        output = done.stdout.decode(errors='replace')
        if done.returncode != 0:
            raise AssertionError(f'{name} failed with exit status {done.returncode}:\n{output}')
        return output

    def headless(self, scenario, table=NEAREST_TABLE, **options):
        """Returns the bytes of the recording of a run without ROS."""
        folder = tempfile.mkdtemp(dir=self.folder)
        arguments = [part for name, value in options.items() for part in (f'--{name}', value)]
        self.tool('evaluate', '--q-table', table, '--trajectories', folder, *arguments, scenario)
        return read_bytes(os.path.join(folder, recording_of(scenario)))
