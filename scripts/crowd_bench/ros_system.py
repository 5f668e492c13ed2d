"""A separate ROS system for a benchmark: a master on a free port, and nodes."""
import os
import pathlib
import signal
import socket
import subprocess
import tempfile
import time

from crowd_experiments.runs import RunError
from crowd_experiments.tools import build_folder, programs_in
from crowd_launching.launch_end import free_port

PATIENCE = 300.0  # [s] time limit of each command
CLOCK_TICKS = os.sysconf('SC_CLK_TCK')  # per second, unit of the times in /proc


def program(name):
    """Returns the path of a program of this package."""
    return programs_in(build_folder() / 'devel') / name


class RosSystem:
    """Context manager that starts a master and nodes, writes their output to files, and ends them all on exit."""

    def __enter__(self):
        self.folder = tempfile.TemporaryDirectory(prefix='social_crowd_bench_')
        self.processes = []
        port = free_port()
        self.environment = {**os.environ, 'ROS_MASTER_URI': f'http://127.0.0.1:{port}', 'ROS_HOSTNAME': '127.0.0.1',
                            'ROS_LOG_DIR': str(self.path('logs'))}
        self.environment.pop('ROS_NAMESPACE', None)
        self.start('rosmaster', ['/usr/bin/rosmaster', '--core', '-p', str(port)])
        self.wait_for_master(port)
        return self

    def __exit__(self, *_):
        for process in reversed(self.processes):
            if process.poll() is None:
                process.send_signal(signal.SIGINT)
        for process in reversed(self.processes):
            try:
                process.wait(10.0)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
        self.folder.cleanup()

    def wait_for_master(self, port):
        """Waits until the master answers."""
        deadline = time.monotonic() + PATIENCE
        while True:
            with socket.socket() as client:
                if client.connect_ex(('127.0.0.1', port)) == 0:
                    return
            self.check()
            if time.monotonic() > deadline:
                raise RunError(f'timeout of {PATIENCE:g} s while waiting for the master')
            time.sleep(0.05)

    def check(self):
        """Throws RunError if a process has failed."""
        for process in self.processes:
            if process.poll() not in (None, 0):
                raise RunError(f'{process.args} ended with status {process.returncode}:\n'
                               f"{process.log.read_text(encoding='utf-8', errors='replace')}")

    def path(self, name):
        """Returns a path in the system's folder."""
        return pathlib.Path(self.folder.name) / name

    def write(self, name, text):
        """Writes a file in the system's folder. Returns its path."""
        self.path(name).write_text(text, encoding='utf-8')
        return self.path(name)

    def start(self, name, command):
        """Starts a process in the package's environment; its log file is named after it."""
        log = self.path(f'{len(self.processes)}_{name}.log')
        with open(log, 'wb') as stream:
            process = subprocess.Popen(wrapped(command), stdin=subprocess.DEVNULL, stdout=stream, stderr=stream,
                                       env=self.environment)
        process.log = log
        self.processes.append(process)
        return process

    def start_node(self, kind, **parameters):
        """Starts a node of this package with private parameters."""
        return self.start(kind, [program(kind), *arguments_of(parameters)])

    def figures(self, name, *words):
        """Runs a program of this package. Returns the numbers in the last line of its output."""
        done = subprocess.run(wrapped([program(name), *words]), stdout=subprocess.PIPE, text=True, timeout=PATIENCE,
                              env=self.environment, check=False)
        self.check()
        if done.returncode != 0:
            raise RunError(f'{done.args} ended with status {done.returncode}')
        return [float(word) for word in done.stdout.splitlines()[-1].split()]


def wrapped(command):
    """Returns a command that runs in the package's environment."""
    return [str(build_folder() / 'devel' / 'env.sh'), *map(str, command)]


def arguments_of(parameters):
    """Returns private parameters as arguments of a node."""
    return [f'_{name}:={value}' for name, value in parameters.items()]


def cpu_seconds(processes):
    """Returns the processor time that processes and all their threads have used so far [s]."""
    ticks = 0
    for process in processes:
        fields = pathlib.Path(f'/proc/{process.pid}/stat').read_text(encoding='utf-8').rpartition(')')[2].split()
        ticks += int(fields[11]) + int(fields[12])  # user and system
    return ticks / CLOCK_TICKS
