"""Commands of trainings with all their files."""
import os
import signal
import subprocess

from learning_files import config_text
from programs import CIRCLE6, PATIENCE, in_package, read_bytes, read_text, tools_folder, wait_for

CROWD = in_package('config', 'learning', 'anticipation.yaml')
# Two agents that keep their headings from one episode to the next, and one of them can collide with an obstacle.
KEPT = '''name: kept
duration: 10
goal_tolerance: 0.3
agents:
  - {count: 2, position: {ring: {centre: [0, 0], radius: [1, 2]}}, goal: {opposite: [0, 0]}, speed: 1, radius: 0.2,
     heading: kept}
obstacles: [{position: [0, 0], radius: 0.2}]
'''
TRACES = '{alpha: 0.1, gamma: 0.9, lambda: 0.8, epsilon: {from: 0.5, to: 0.05, episodes: 200, shape: exponential}}'
DECAYING = '{alpha: 0.01, alpha_decay: 0.6, gamma: 0.9, mirrored: true, ties: random, epsilon: 0.2}'


def config_of(runner, name, episodes):
    """Writes a training configuration, by its name in the tests. Returns its file."""
    text = {
        'traces': config_text('single_obstacle, training_field', episodes, learning=TRACES),
        'side_by_side': config_text('kept.yaml, training_field', episodes, learning=DECAYING
                                    ).replace('tables: shared', 'tables: shared, side_by_side: 3, turn: 4'),
        'own': config_text('kept.yaml', episodes, tables='own'),
        'crowd': read_text(CROWD).replace('../scenarios/training_crowd.yaml', CIRCLE6),
    }[name]
    runner.write('kept.yaml', KEPT)
    return runner.write(f'{name}.yaml', text)


def size_of(file):
    """Returns the size of a file, -1 if it does not exist."""
    return os.path.getsize(file) if os.path.exists(file) else -1


class Training:
    """The command of a training with all its files."""

    def __init__(self, runner, config, name, *options):
        self.runner = runner
        self.files = {option: runner.path(f'{name}.{option}') for option in ('output', 'record', 'log', 'checkpoint')}
        files = [word for option in ('output', 'record', 'log') for word in ('--' + option, self.files[option])]
        self.command = [os.path.join(tools_folder(), 'train'), config, *files, *map(str, options)]

    def resuming(self):
        """Returns the command that goes on from the checkpoint."""
        return [*self.command, '--checkpoint', self.files['checkpoint'], '--checkpoint-interval', '0.01', '--resume']

    def run(self, command=None):
        """Runs the command to its end. Returns exit status and output."""
        done = subprocess.run(command or self.command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, check=False,
                              stderr=subprocess.STDOUT, timeout=PATIENCE, cwd=self.runner.folder)
        return done.returncode, done.stdout.decode(errors='replace')

    def results(self):
        """Returns the bytes of table, record and log, and of the tables that were saved on the way, by their names."""
        folder, stem = os.path.split(os.path.splitext(self.files['output'])[0])
        tables = {name: os.path.join(folder, name) for name in os.listdir(folder) if name.startswith(stem + '_0')}
        return {name.replace(stem, ''): read_bytes(file)
                for name, file in {**tables, **{key: self.files[key] for key in ('output', 'record', 'log')}}.items()}

    def interrupt(self, number, log_size, command=None, wanted='log'):
        """Goes on, and sends a signal when the log, or another file, has reached a size. Returns the exit status."""
        process = self.runner.start('train', command or self.resuming())
        wait_for(lambda: not process.is_running() or size_of(self.files[wanted]) >= log_size, f'the {wanted} to grow')
        process.signal(number)
        if number == signal.SIGKILL:
            process.is_given_up = True
        return process.wait()
