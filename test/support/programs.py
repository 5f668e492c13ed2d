"""What all tests in Python share: programs of this package as processes of their own, in a folder of the test's own,
and waiting with a deadline. Needs no ROS master."""
import os
import re
import signal
import subprocess
import tempfile
import time

import rospkg
from roslib.packages import find_node

PATIENCE = 90.0  # [s] for what comes at once on an idle machine
PERIOD = 0.01  # [s] between two looks
PACKAGE = rospkg.RosPack().get_path('social_crowd')
COLOUR = re.compile(r'\x1b\[[0-9;]*m')


def in_package(*parts):
    """A path in the package."""
    return os.path.join(PACKAGE, *parts)


NEAREST_TABLE = in_package('config', 'q_tables', 'thesis_nearest.txt')
OCCUPANCY_TABLE = in_package('config', 'q_tables', 'thesis_occupancy.txt')
ANTICIPATION_TABLE = in_package('config', 'q_tables', 'anticipation.txt')
CIRCLE6 = in_package('config', 'scenarios', 'circle6.yaml')


def data(name):
    """A file in test/data."""
    return in_package('test', 'data', name)


def page_examples(page):
    """The files that a page of docs/ prints, by name: `NAME`: and a block of code."""
    text = read_text(in_package('docs', page))
    return dict(re.findall(r'^`([\w.]+)`:\n\n```\w+\n(.*?)^```$', text, re.DOTALL | re.MULTILINE))


def tools_folder():
    """The folder of the programs train and evaluate."""
    return os.path.dirname(find_node('social_crowd', 'train')[0])


def recording_of(scenario):
    """Name of a scenario file's recording."""
    return os.path.splitext(os.path.basename(scenario))[0] + '.csv'


def wait_for(condition, what, seconds=PATIENCE):
    """Polls until the condition gives something true, and returns that."""
    deadline = time.monotonic() + seconds
    while True:
        result = condition()
        if result:
            return result
        if time.monotonic() > deadline:
            raise AssertionError(f'waited {seconds:g} s in vain for {what}')
        time.sleep(PERIOD)


def read_text(file):
    """What a file holds."""
    with open(file, encoding='utf-8', errors='replace') as stream:
        return stream.read()


def read_bytes(file):
    """What a file holds, byte for byte; None if there is no such file."""
    if not os.path.exists(file):
        return None
    with open(file, 'rb') as stream:
        return stream.read()


def assert_says(text, *words):
    """Checks that a text holds all these words."""
    missing = [word for word in words if word not in text]
    if missing:
        raise AssertionError(f'{missing} are missing in: {text}')


def assert_same_recording(got, expected):
    """Compares recordings byte for byte; the first line that differs is told."""
    if got is None:
        raise AssertionError('there is no recording')
    if got == expected:
        return
    lines = [recording.decode().splitlines() + ['(the end)'] for recording in (got, expected)]
    first = next(i for i, pair in enumerate(zip(*lines)) if pair[0] != pair[1])
    raise AssertionError(f'the recordings differ from line {first + 1}: got {lines[0][first]}, '
                         f'expected {lines[1][first]}')


class Process:
    """A program that runs beside the test; its output goes to a file."""

    def __init__(self, name, command, log, environment=None):
        self.name = name
        self.log = log
        self.is_given_up = False  # killed on purpose: how it ends says nothing
        environment = dict(os.environ, ROSCONSOLE_STDOUT_LINE_BUFFERED='1', **(environment or {}))
        with open(log, 'wb') as stream:
            self.process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=stream, stderr=stream,
                                            env=environment)

    def output(self):
        """What it has printed so far, without colours."""
        return COLOUR.sub('', read_text(self.log))

    def is_running(self):
        """Whether it has not ended yet."""
        return self.process.poll() is None

    def wait(self, seconds=PATIENCE):
        """Waits for its end; the exit status."""
        wait_for(lambda: not self.is_running(), f'the end of {self.name}', seconds)
        return self.process.returncode

    def signal(self, number):
        """Sends it a signal."""
        self.process.send_signal(number)

    def stop(self):
        """Asks it to end, as Ctrl-C does; the exit status."""
        if self.is_running():
            self.signal(signal.SIGINT)
        return self.wait()

    def kill(self):
        """Ends it without a chance to say goodbye."""
        self.is_given_up = True
        self.process.kill()
        self.process.wait()

    def clean_up(self):
        """Ends it in any case; what was wrong with its end, if anything."""
        if self.is_given_up:
            self.process.kill()
            self.process.wait()
            return ''
        was_running = self.is_running()
        try:
            status = self.stop()
        except AssertionError:
            self.kill()
            return f'{self.name} did not end when asked to'
        return f'{self.name} ended with exit status {status} when asked to' if was_running and status != 0 else ''


class ProgramRunner:
    """Programs that a test runs, and the test's folder."""

    def __init__(self, folder, environment=None):
        self.folder = folder
        self.environment = environment or {}  # of all programs, beside the test's own
        self.processes = []

    def path(self, name):
        """A path in the test's folder."""
        return os.path.join(self.folder, name)

    def write(self, name, text):
        """Writes a file in the test's folder; its path."""
        with open(self.path(name), 'w', encoding='utf-8') as stream:
            stream.write(text)
        return self.path(name)

    def start(self, name, command, environment=None):
        """Starts a program."""
        log = self.path(f'{len(self.processes)}_{name}.log')
        process = Process(name, command, log, dict(self.environment, **(environment or {})))
        self.processes.append(process)
        return process

    def outputs(self):
        """What the started programs have printed so far."""
        return ''.join(f'--- output of {process.name}\n{process.output()}\n' for process in self.processes)

    def clean_up(self):
        """Ends the started programs; what was wrong with their ends, if anything, a line each."""
        problems = [process.clean_up() for process in reversed(self.processes)]
        return '\n'.join(problem for problem in problems if problem)

    @staticmethod
    def tool(name, *arguments, within=()):
        """Runs a program of this package to its end, perhaps within another one; what it printed."""
        command = [*within, *find_node('social_crowd', name)[:1], *map(str, arguments)]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=PATIENCE, check=False)
        output = done.stdout.decode(errors='replace')
        if done.returncode != 0:
            raise AssertionError(f'{name} failed with exit status {done.returncode}:\n{output}')
        return output

    def headless(self, scenario, table=NEAREST_TABLE, **options):
        """The recording of a run without ROS, byte for byte."""
        folder = tempfile.mkdtemp(dir=self.folder)
        arguments = [part for name, value in options.items() for part in (f'--{name}', value)]
        self.tool('evaluate', '--q-table', table, '--trajectories', folder, *arguments, scenario)
        return read_bytes(os.path.join(folder, recording_of(scenario)))
