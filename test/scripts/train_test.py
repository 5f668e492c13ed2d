"""train: trainings that go on after an interruption, and errors."""
import os
import random
import resource
import shutil
import signal
import subprocess

import pytest
from learning_files import QTableFile
from programs import ANTICIPATION_TABLE, PATIENCE, assert_says, in_package, read_bytes, read_text, wait_for
from trainings import Training, config_of, size_of

LIMIT = 500_000  # of the size of a file [bytes]


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
        """SIGKILL before the first episode, at fixed and random places of the log, and near the end. Until the end, the
        output of another training stays."""
        config = config_of(runner, name, episodes)
        options = ['--episodes', episodes, '--save-every', episodes // 3]
        whole, killed = Training(runner, config, 'whole', *options), Training(runner, config, 'killed', *options)
        status, output = whole.run()
        assert status == 0, output
        size = size_of(whole.files['log'])
        seed = random.randrange(10**6)
        print(f'seed {seed}')
        shutil.copy(ANTICIPATION_TABLE, killed.files['output'])
        previous = read_bytes(killed.files['output'])
        first = [word for word in killed.resuming() if word != '--resume']  # it would find the previous output
        assert killed.interrupt(signal.SIGKILL, 1, first, 'checkpoint') == -signal.SIGKILL
        targets = [-1, 0, size // 3, random.Random(seed).randrange(size // 3, size // 2), size // 2]
        for target in targets:
            assert killed.interrupt(signal.SIGKILL, target) == -signal.SIGKILL
            assert read_bytes(killed.files['output']) == previous
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

    def test_kill_without_a_checkpoint(self, runner):
        """Nothing but the log and the record has changed."""
        training = Training(runner, config_of(runner, 'traces', 10**6), 'a')
        shutil.copy(ANTICIPATION_TABLE, training.files['output'])
        for target in (0, 1000):
            assert training.interrupt(signal.SIGKILL, target, training.command) == -signal.SIGKILL
            assert read_bytes(training.files['output']) == read_bytes(ANTICIPATION_TABLE)
        names = [name for name in os.listdir(runner.folder) if not name.endswith(('.yaml', '_train.log'))]
        assert sorted(names) == ['a.log', 'a.output', 'a.record']

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
        """The table is not read again."""
        config = config_of(runner, 'traces', 100)
        whole, ended = Training(runner, config, 'whole', '--seed', 5), Training(runner, config, 'ended', '--seed', 5)
        for training in (whole, ended):
            assert training.run()[0] == 0
            training.command += ['--q-table', training.files['output'], '--episodes', '800']
            for option in ('record', 'log'):
                os.remove(training.files[option])
        assert whole.run()[0] == 0
        assert ended.interrupt(signal.SIGKILL, size_of(whole.files['log']) // 2) == -signal.SIGKILL
        runner.write(os.path.basename(ended.files['output']), 'something else\n')
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


class ShippedTest:
    """Tables of the package."""

    @pytest.mark.parametrize('states', ('nearest', 'occupancy'))
    def test_those_of_the_thesis_are_what_their_configurations_give(self, runner, states):
        first, table = runner.path('first.txt'), runner.path('table.txt')
        runner.tool('train', in_package('config', 'learning', f'thesis_{states}.yaml'), '--output', first)
        runner.tool('train', in_package('config', 'learning', f'thesis_{states}_field.yaml'), '--q-table', first,
                    '--output', table)
        assert read_text(table) == read_text(in_package('config', 'q_tables', f'thesis_{states}.txt'))

    @pytest.mark.parametrize('table', ('anticipation', 'human'))
    def test_the_others_have_the_models_of_their_configurations(self, runner, table):
        trained = runner.path('table.txt')
        runner.tool('train', in_package('config', 'learning', table + '.yaml'), '--output', trained, '--episodes', 1)
        model = [read_text(file).split('\nepsilon: ')[0] for file in
                 (trained, in_package('config', 'q_tables', table + '.txt'))]
        assert 'state_set: {type: anticipation' in model[0] and 'alpha_decay' in model[0]
        assert model[0] == model[1]


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
