"""A terminal of a user: runs command lines as printed on a page, with a ROS master of its own."""
import os
import socket
import subprocess
import urllib.parse

from crowd_launching.program import free_port
from programs import Folder, PACKAGE, PATIENCE, wait_for

WORK = 5 * PATIENCE  # [s] time limit of a line, which may train or film for half a minute on an idle machine
BAD = ('[ERROR]', '[FATAL]', 'Traceback', 'has died', 'escalating', 'exit code')


class Terminal(Folder):
    """A shell in a folder that looks like a clone. Programs that it starts end with the test of its ProgramRunner."""

    def __init__(self, runner, folder, environment=None):
        super().__init__(folder)
        self.runner = runner
        os.makedirs(folder, exist_ok=True)
        for name in os.listdir(PACKAGE):
            if not name.startswith('.') and not os.path.lexists(os.path.join(folder, name)):
                os.symlink(os.path.join(PACKAGE, name), os.path.join(folder, name))
        self.port = free_port()
        self.environment = {'ROS_MASTER_URI': f'http://127.0.0.1:{self.port}', 'ROS_HOSTNAME': '127.0.0.1',
                            **dict.fromkeys(('ROS_HOME', 'ROS_LOG_DIR'), os.path.join(folder, '.ros')),
                            **(environment or {})}
        self.environment.pop('ROS_NAMESPACE', None)

    def start(self, line):
        """Starts a command line. Returns its Process."""
        return self.runner.start(line.split()[0].split('/')[-1], ['bash', '-c', f"cd '{self.folder}' && exec {line}"],
                                 self.environment)

    def run(self, line, status=0, seconds=WORK):
        """Runs a command line, which must end with this exit status. Returns its output."""
        done = subprocess.run(['bash', '-c', line], cwd=self.folder, env={**os.environ, **self.environment},
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              timeout=seconds, check=False)
        output = done.stdout.decode(errors='replace')
        assert done.returncode == status, f'{line}\nexit status {done.returncode}\n{output}'
        return output

    def wait_message(self, topic, condition='True'):
        """Waits for a message m that meets the condition, which is written in Python. A launch may train before."""
        wait_for(self.has_master, 'the ROS master')
        return self.run(f"rostopic echo -n 1 --filter '{condition}' {topic}")

    def has_master(self):
        """Returns whether the ROS master of this terminal answers."""
        with socket.socket() as probe:
            uri = urllib.parse.urlparse(self.environment['ROS_MASTER_URI'])
            return probe.connect_ex((uri.hostname, uri.port)) == 0

    def launch(self, line):
        """Starts a launch file and waits until its crowd walks. Returns its Process."""
        process = self.start(line)
        # A recording has a namespace of its own, so that it can be shown beside a demo.
        namespace = '/recording' if 'replay.launch' in line else ''
        self.wait_message(f'{namespace}/agents', 'm.tick > 0')
        return process

    @staticmethod
    def interrupt(process):
        """Ends a launch with Ctrl-C; it must end well, and without errors in its output."""
        assert process.is_running(), process.output()
        assert process.stop() == 0, process.output()
        assert [word for word in BAD if word in process.output()] == [], process.output()
