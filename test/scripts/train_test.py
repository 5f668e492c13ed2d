"""train: its log, and trainings that go on after an interruption."""
import csv
import os
import random
import resource
import shutil
import signal
import subprocess

import pytest
from learning_files import QTableFile, config_text
from programs import CIRCLE6, PATIENCE, assert_says, in_package, read_bytes, read_text, tools_folder, wait_for
from terminals import run_in_terminal

LIMIT = 500_000  # of the size of a file [bytes]
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

    def interrupt(self, number, log_size):
        """Goes on, and sends a signal when the log has reached a size. Returns the exit status."""
        process = self.runner.start('train', self.resuming())
        wait_for(lambda: not process.is_running() or size_of(self.files['log']) >= log_size, 'the log to grow')
        process.signal(number)
        if number == signal.SIGKILL:
            process.is_given_up = True
        return process.wait()


def size_of(file):
    """Returns the size of a file, -1 if it does not exist."""
    return os.path.getsize(file) if os.path.exists(file) else -1


def assert_same(got, expected):
    """Compares results of trainings."""
    assert sorted(got) == sorted(expected)
    for name, content in expected.items():
        assert got[name] == content, f'{name} differs: {len(got[name])} bytes in place of {len(content)}'


class InterruptionTest:
    """A training that was interrupted gives the same files, byte for byte."""

    @pytest.mark.parametrize('name, episodes', [('traces', 1500), ('side_by_side', 1501), ('own', 3000),
                                                ('crowd', 700)])
    def test_kill(self, runner, name, episodes):
        """SIGKILL before the first episode, at fixed and random places of the log, and near the end."""
        config = config_of(runner, name, episodes)
        options = ['--episodes', episodes, '--save-every', episodes // 3]
        whole, killed = Training(runner, config, 'whole', *options), Training(runner, config, 'killed', *options)
        status, output = whole.run()
        assert status == 0, output
        size = size_of(whole.files['log'])
        seed = random.randrange(10**6)
        print(f'seed {seed}')
        targets = [-1, 0, size // 3, random.Random(seed).randrange(size // 3, size // 2), size // 2]
        for target in targets:
            assert killed.interrupt(signal.SIGKILL, target) == -signal.SIGKILL
        assert read_bytes(killed.files['log']) != read_bytes(whole.files['log'])
        killed.interrupt(signal.SIGKILL, size - 1)  # it may be done before
        status, output = killed.run(killed.resuming())
        assert status == 0, output
        assert_says(output, f'of {episodes} episodes are done', f'{episodes} episodes, ')
        assert not [name for name in os.listdir(runner.folder) if '.tmp' in name]
        assert_same(killed.results(), whole.results())
        # The same command once more: there is nothing left to do.
        status, output = killed.run(killed.resuming())
        assert status == 0, output
        assert_says(output, f'killed.checkpoint: {episodes} of {episodes} episodes are done', 'was complete')
        assert_same(killed.results(), whole.results())

    @pytest.mark.parametrize('number', [signal.SIGINT, signal.SIGTERM])
    def test_signals(self, runner, number):
        """The checkpoint is that of the last episode, and so is the table."""
        config = config_of(runner, 'traces', 1500)
        whole, ended = Training(runner, config, 'whole'), Training(runner, config, 'ended')
        assert whole.run()[0] == 0
        assert ended.interrupt(number, size_of(whole.files['log']) // 3) == 130
        episodes = len(read_text(ended.files['log']).splitlines()) - 1
        assert 300 < episodes < 1500
        decisions = QTableFile(ended.files['output']).header['decisions']
        status, output = ended.run(ended.resuming())
        assert status == 0, output
        assert_says(output, f'ended.checkpoint: {episodes} of 1500 episodes are done')
        assert QTableFile(ended.files['output']).header['decisions'] > decisions
        assert_same(ended.results(), whole.results())

    def test_training_from_a_table(self, runner):
        """The table is not read again: here it is replaced by that of the training."""
        config = config_of(runner, 'traces', 100)
        whole, ended = Training(runner, config, 'whole', '--seed', 5), Training(runner, config, 'ended', '--seed', 5)
        for training in (whole, ended):
            assert training.run()[0] == 0
            training.command += ['--q-table', training.files['output'], '--episodes', '800']
            for option in ('record', 'log'):
                os.remove(training.files[option])
        assert whole.run()[0] == 0
        assert ended.interrupt(signal.SIGKILL, size_of(whole.files['log']) // 2) == -signal.SIGKILL
        status, output = ended.run(ended.resuming())
        assert status == 0, output
        assert_same(ended.results(), whole.results())

    def test_more_episodes(self, runner):
        """A training that is complete goes on for more episodes."""
        config = config_of(runner, 'traces', 400)
        whole, longer = Training(runner, config, 'whole'), Training(runner, config, 'longer', '--episodes', 100)
        assert whole.run()[0] == 0
        assert longer.run(longer.resuming())[0] == 0
        longer.command[-1] = '400'
        assert longer.run(longer.resuming())[0] == 0
        assert_same(longer.results(), whole.results())


class RefusalTest:
    """What is refused changes no file."""

    @pytest.fixture
    def training(self, runner):
        """Returns a training with a checkpoint."""
        training = Training(runner, config_of(runner, 'traces', 20), 'old')
        assert training.run(training.resuming())[0] == 0
        return training

    def refuse(self, training, words, *more, without=(), status=1):
        """Runs the command, which must fail with these words and leave all files."""
        folder = training.runner.folder
        before = {name: read_bytes(os.path.join(folder, name)) for name in os.listdir(folder)}
        got, output = training.run([word for word in training.resuming() if word not in without] + list(more))
        assert got == status, output
        assert_says(output, *words)
        assert {name: read_bytes(os.path.join(folder, name)) for name in os.listdir(folder)} == before

    def test_a_training_that_begins_anew(self, training):
        self.refuse(training, ['old.checkpoint: there is a checkpoint already', '--resume'], without=['--resume'])

    def test_another_training(self, training):
        self.refuse(training, ["old.checkpoint: is the checkpoint of another training: it has 'seed: 1', the training "
                               "has 'seed: 2'"], '--seed', '2')
        self.refuse(training, ["'tables: shared'", "'tables: own'"], '--tables', 'own')
        self.refuse(training, ["the training has 'q_table: other.txt'"], '--q-table', 'other.txt')
        self.refuse(training, ['training.episodes: expected 20 episodes or more, got 19'], '--episodes', '19')

    def test_a_missing_checkpoint(self, training):
        """Its name may be misspelt: nothing that was learned is replaced."""
        os.rename(training.files['checkpoint'], training.runner.path('other.checkpoint'))
        for option in ('log', 'record', 'output'):
            file = training.files[option]
            self.refuse(training, [f'old.checkpoint: there is no checkpoint, and --{option} {file} has contents that '
                                   'would be lost', 'leave out --resume'])
            os.remove(file)
        assert training.run(training.resuming())[0] == 0

    def test_a_training_that_was_killed_before_its_first_checkpoint(self, training):
        """Its files have only headers."""
        for option in ('log', 'record'):
            header = read_text(training.files[option]).splitlines()[0]
            training.runner.write(os.path.basename(training.files[option]), header + '\n')
        os.remove(training.files['output'])
        os.remove(training.files['checkpoint'])
        assert training.run(training.resuming())[0] == 0

    @pytest.mark.parametrize('option', ['record', 'log', 'checkpoint', 'output'])
    def test_a_missing_folder(self, training, option):
        """Also in a training that begins anew: it would replace the other files."""
        file = training.runner.path('none/file')
        new = [word for word in training.resuming() if word != '--resume']
        new[new.index('--checkpoint') + 1] = training.runner.path('new.checkpoint')
        for command in (training.resuming(), new):
            command[command.index('--' + option) + 1] = file
            before = training.results()
            status, output = training.run(command)
            assert status == 1, output
            assert_says(output, f'{file}: cannot be written', 'there is no folder')
            assert training.results() == before

    def test_a_second_process(self, training):
        """The first one holds the checkpoint."""
        words = ['--episodes', '1000000']
        first = training.runner.start('train', training.resuming() + words)
        size = size_of(training.files['log'])
        wait_for(lambda: size_of(training.files['log']) > size, 'the log to grow')
        status, output = training.run(training.resuming() + words)
        assert status == 1, output
        assert_says(output, 'old.checkpoint: is in use by another process, number ')
        first.signal(signal.SIGINT)
        assert first.wait() == 130
        rows = read_text(training.files['log']).splitlines()[1:]
        assert [int(row.split(',')[0]) for row in rows] == list(range(len(rows)))
        assert not [name for name in os.listdir(training.runner.folder) if name.endswith('.lock')]

    def test_other_files(self, training):
        self.refuse(training, ['old.checkpoint: the checkpoint was written with --log'],
                    without=['--log', training.files['log']])
        self.refuse(training, ['--log: expected another file than that of --record'],
                    '--log', training.files['record'], without=['--log', training.files['log']])

    def test_files_that_are_too_short(self, training):
        size = size_of(training.files['record'])
        os.truncate(training.files['record'], size - 1)
        self.refuse(training, [f'old.record: cannot be continued: expected the {size} bytes', f'got {size - 1}'])
        os.remove(training.files['record'])
        self.refuse(training, ['old.record: cannot be continued: No such file'])

    def test_a_damaged_checkpoint(self, training):
        content = bytearray(read_bytes(training.files['checkpoint']))
        content[len(content) // 2] ^= 1
        for damaged in (content, content[:len(content) // 2]):
            with open(training.files['checkpoint'], 'wb') as stream:
                stream.write(damaged)
            self.refuse(training, ['old.checkpoint: the checkpoint was damaged or cut short', 'nothing was changed'])
        with open(training.files['checkpoint'], 'wb') as stream:
            stream.write(b'something else\n')
        self.refuse(training, ['old.checkpoint: line 1: expected', 'this is no checkpoint of this package'])

    def test_wrong_usage(self, training):
        command = [*training.command, '--resume']
        status, output = training.run(command)
        assert (status, '--resume requires --checkpoint' in output) == (2, True), output
        status, output = training.run([*training.command, '--plot'])
        assert status == 2, output
        assert_says(output, 'train: --plot: standard error is no terminal', 'plot_learning')


class WriteErrorTest:
    """Errors of files while it trains do not lose what was learned."""

    def test_the_record(self, runner):
        """No file can grow beyond a size, as on a full disk."""
        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (LIMIT, LIMIT))
        training = Training(runner, config_of(runner, 'traces', 20000), 'a')
        done = subprocess.run(training.command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, check=False,
                              stderr=subprocess.STDOUT, timeout=PATIENCE, cwd=runner.folder, preexec_fn=limit)
        output = done.stdout.decode(errors='replace')
        assert done.returncode == 1, output
        assert_says(output, f'train: {training.files["record"]}: cannot be written: File too large',
                    'ended by an error')
        assert size_of(training.files['record']) == LIMIT
        assert QTableFile(training.files['output']).header['decisions'] > 0

    def test_a_checkpoint(self, runner):
        """The training goes on without it."""
        training = Training(runner, config_of(runner, 'traces', 1500), 'a')
        folder = runner.path('checkpoints')
        os.mkdir(folder)
        training.files['checkpoint'] = os.path.join(folder, 'a')
        process = runner.start('train', training.resuming())
        wait_for(lambda: size_of(training.files['log']) > 1000, 'the log to grow')
        process.signal(signal.SIGSTOP)  # so that it writes nothing into the folder while it is removed
        shutil.rmtree(folder)
        process.signal(signal.SIGCONT)
        assert process.wait() == 1
        assert process.output().count('; the training goes on') == 1
        assert_says(process.output(), f'train: {folder}/a: cannot be written', ': 1500 episodes, ')
        assert len(read_text(training.files['log']).splitlines()) == 1501


class LogTest:
    """train --log."""

    def test_rows(self, runner):
        """The log agrees with the record, the table and the schedule of epsilon."""
        training = Training(runner, config_of(runner, 'crowd', 30), 'a', '--episodes', 30)
        status, output = training.run()
        assert status == 0, output
        with open(training.files['log'], newline='', encoding='utf-8') as stream:
            rows = list(csv.DictReader(stream))
        with open(training.files['record'], newline='', encoding='utf-8') as stream:
            agents = list(csv.DictReader(stream))
        assert [row['episode'] for row in rows] == [str(i) for i in range(30)]
        for row in rows:
            mine = [agent for agent in agents if agent['episode'] == row['episode']]
            assert (row['scenario'], row['agents']) == ('circle6', '6')
            for share, column in (('success', 'arrived'), ('contact', 'touched'), ('collision', 'collided')):
                assert float(row[share]) == sum(int(agent[column]) for agent in mine) / 6
            assert int(row['decisions']) == sum(int(agent['ticks']) for agent in mine)
            assert float(row['epsilon']) == pytest.approx(0.3 + int(row['episode']) / 4000 * (0.02 - 0.3))
            assert -25 < float(row['reward']) < 0  # `progress`: 0 is the best
        visited = [int(row['visited_rows']) for row in rows]
        assert visited == sorted(visited)
        table = QTableFile(training.files['output'])
        assert visited[-1] == table.header['visited_rows']
        assert sum(int(row['decisions']) for row in rows) == table.header['decisions']


class PlotTest:
    """train --plot, in a pseudo-terminal."""

    TITLES = ('success [%]', 'contact [%]', 'mean reward', 'visited rows', 'epsilon')

    def train(self, runner, columns, rows, episodes, typed=''):
        """Trains in a terminal. Returns exit status and the lines of the screen."""
        training = Training(runner, config_of(runner, 'traces', episodes), 'a', '--plot')
        status, screen = run_in_terminal(training.command, columns, rows, typed)
        print('\n'.join(screen.lines()))
        assert screen.x == 0  # what follows begins a line
        return status, screen.lines()

    @pytest.mark.parametrize('columns, rows, across', [(80, 24, 2), (120, 30, 3), (200, 50, 5)])
    def test_final_screen(self, runner, columns, rows, across):
        """Each panel is there once; below them the bar, and what the program prints at its end."""
        status, lines = self.train(runner, columns, rows, 600)
        assert status == 0
        text = '\n'.join(lines)
        first = next(line for line in lines if 'contact [%]' in line)
        assert [title in first for title in self.TITLES[1:]] == [i < across for i in range(1, 5)]
        for title in self.TITLES:
            assert text.count(title) == 1
        assert 'episodes 0 to 599, about ' in text
        bar = next(i for i, line in enumerate(lines) if line.startswith('episode [######'))
        assert lines[bar].startswith('episode [########################] 600/600  left 0:00  success')
        assert lines[bar + 1].startswith(f'{runner.path("a.output")}: 600 episodes, '[:columns])
        dots = sum('\u2801' <= character <= '\u28ff' for character in text)
        assert dots > 5 * 20

    def test_curves_go_on(self, runner):
        """After an interruption they have the episodes of the log."""
        training = Training(runner, config_of(runner, 'traces', 200), 'a')
        assert training.run([*training.resuming(), '--episodes', '100'])[0] == 0
        status, screen = run_in_terminal([*training.resuming(), '--plot'], 80, 24)
        assert status == 0
        assert 'episodes 0 to 199' in '\n'.join(screen.lines())

    def test_interruption(self, runner):
        """Ctrl-C leaves one picture, the bar and the last message."""
        status, lines = self.train(runner, 120, 40, 10**6, '\x03')
        assert status == 130
        text = '\n'.join(lines)
        assert [text.count(title) for title in self.TITLES] == [1] * 5
        assert [line.startswith('episode [') for line in lines].count(True) == 1
        assert '; interrupted' in text
        assert text.count('^C') <= 1
