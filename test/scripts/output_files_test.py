"""train and evaluate: what is no regular file, files that others have, and disks without space."""
import os
import shutil
import stat
import subprocess

import pytest
from learning_files import QTableFile
from programs import CIRCLE6, NEAREST_TABLE, PATIENCE, assert_says, read_bytes, read_text, tools_folder, wait_for
from trainings import Training, config_of

EVALUATE = [os.path.join(tools_folder(), 'evaluate')]
EPISODES = 20
NO_DISK = 77  # exit status of ON_A_DISK


@pytest.fixture
def training(runner):
    """Returns a short training. Its output is in `expected`."""
    training = Training(runner, config_of(runner, 'traces', EPISODES), 'a')
    status, output = training.run()
    assert status == 0, output
    training.expected = read_bytes(training.files['output'])
    return training


def with_file(training, option, file):
    """Returns the command with another file for an option."""
    command = list(training.command)
    command[command.index('--' + option) + 1] = file
    return command


def run(command, **options):
    """Runs a command. Returns exit status and output."""
    done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          timeout=PATIENCE, check=False, **options)
    return done.returncode, done.stdout.decode(errors='replace')


@pytest.fixture
def null(runner):
    """Returns a device in the folder of the test that is /dev/null under another name."""
    path = runner.path('null')
    try:
        os.mknod(path, stat.S_IFCHR | 0o600, os.makedev(1, 3))
    except PermissionError:
        pytest.skip('this user may not make devices')
    return path


@pytest.fixture
def pipe(runner):
    """Returns a pipe."""
    path = runner.path('pipe')
    os.mkfifo(path)
    return path


class StreamTest:
    """Devices and pipes are written into; they are not replaced."""

    @pytest.mark.parametrize('option', ['output', 'log', 'record'])
    def test_train_into_a_device(self, training, null, option):
        status, output = training.run(with_file(training, option, null))
        assert status == 0, output
        assert stat.S_ISCHR(os.lstat(null).st_mode)
        assert sorted(os.listdir(training.runner.folder)) == ['a.log', 'a.output', 'a.record', 'kept.yaml', 'null',
                                                              'traces.yaml']

    def test_evaluate_into_a_device(self, runner, null):
        for option in ('--csv', '--record', '--robots-csv'):
            status, output = run([*EVALUATE, '--q-table', NEAREST_TABLE, option, null, CIRCLE6])
            assert status == 0, output
            assert stat.S_ISCHR(os.lstat(null).st_mode)
        assert os.listdir(runner.folder) == ['null']

    def test_a_device_is_no_checkpoint(self, training, null):
        """Nor has it a lock."""
        before = sorted(os.listdir(training.runner.folder))
        for more in ([], ['--resume']):
            status, output = training.run([*training.command, '--checkpoint', null, *more])
            assert status == 1, output
            assert_says(output, f'{null}: cannot be replaced: is a device, expected a regular file')
        assert stat.S_ISCHR(os.lstat(null).st_mode)
        assert sorted(os.listdir(training.runner.folder)) == before

    @pytest.mark.parametrize('option', ['output', 'log'])
    def test_train_into_a_pipe_that_nobody_reads(self, training, pipe, option):
        """It does not wait, and changes nothing."""
        before = training.results()
        status, output = training.run(with_file(training, option, pipe))
        assert status == 1, output
        assert_says(output, f'{pipe}: cannot be written: is a pipe that no process reads')
        assert stat.S_ISFIFO(os.lstat(pipe).st_mode)
        if option == 'output':
            assert training.results() == before

    def test_evaluate_into_a_pipe_that_nobody_reads(self, pipe):
        status, output = run([*EVALUATE, '--q-table', NEAREST_TABLE, '--csv', pipe, CIRCLE6])
        assert status == 1, output
        assert_says(output, f'{pipe}: cannot be written: is a pipe that no process reads')
        assert 'circle6' not in output, 'said before the first episode'

    def test_train_into_a_pipe(self, training, pipe):
        """The reader waits from the start; it gets the table at the end."""
        reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
        status, output = training.run(with_file(training, 'output', pipe))
        assert status == 0, output
        with open(reader, 'rb') as stream:
            assert stream.read() == training.expected
        assert stat.S_ISFIFO(os.lstat(pipe).st_mode)

    def test_pipes_of_a_shell(self, training):
        """>(command) and <(command)."""
        got = training.runner.path('got')
        command = with_file(training, 'output', '/dev/null')
        words = ' '.join('"$got"' if word == '/dev/null' else f"'{word}'" for word in command)
        script = words.replace('"$got"', f">(cat > '{got}')").replace(f"'{command[1]}'", f"<(cat '{command[1]}')")
        # The configuration names its scenarios by paths beside it.
        shipped = read_text(command[1]).replace('training_field', CIRCLE6)
        training.runner.write('traces.yaml', shipped.replace('single_obstacle', CIRCLE6))
        assert training.run()[0] == 0
        status, output = run(['bash', '-c', script])
        assert status == 0, output
        expected = read_bytes(training.files['output'])
        wait_for(lambda: read_bytes(got) == expected, 'the table in the pipe')

    def test_csv_to_standard_output(self, runner):
        """A file that a shell has opened is written on, behind the table."""
        csv, everything = runner.path('csv'), runner.path('everything')
        command = [*EVALUATE, '--q-table', NEAREST_TABLE, '--csv', csv, CIRCLE6]
        status, output = run(command)
        assert status == 0, output
        for to in ('/dev/stdout', '/dev/fd/1', '/proc/self/fd/1'):
            command[-2] = to
            with open(everything, 'wb') as stream:
                subprocess.run(command, stdout=stream, stderr=subprocess.DEVNULL, timeout=PATIENCE, check=True)
            assert read_text(everything) == output + read_text(csv)

    def test_tables_on_the_way_have_no_place_beside_a_device(self, training, null):
        status, output = training.run([*with_file(training, 'output', null), '--save-every', '5'])
        assert status == 1, output
        assert_says(output, '--output: expected a regular file', 'save_every', '--save-every 0')

    def test_a_reader_of_the_log_that_ends(self, runner, pipe):
        """What was learned is saved."""
        training = Training(runner, config_of(runner, 'traces', 10**6), 'a')
        reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
        process = runner.start('train', with_file(training, 'log', pipe))
        wait_for(lambda: os.path.exists(training.files['record']) and
                 os.path.getsize(training.files['record']) > 1000, 'the first episodes')
        os.close(reader)
        assert process.wait() == 1
        assert_says(process.output(), f'train: {pipe}: cannot be written: Broken pipe', 'ended by an error')
        assert QTableFile(training.files['output']).header['decisions'] > 0


class InputTest:
    """Files that are read end, and are no larger than such a file can be."""

    @pytest.mark.parametrize('words', [['--q-table', '/dev/zero', CIRCLE6],
                                       ['--q-table', NEAREST_TABLE, '--config', '/dev/zero', CIRCLE6],
                                       ['--q-table', NEAREST_TABLE, '/dev/zero']])
    def test_devices(self, words):
        status, output = run([*EVALUATE, *words])
        assert status == 1, output
        assert_says(output, '/dev/zero: is a device, expected a file')

    def test_pipes(self):
        script = f"'{EVALUATE[0]}' --q-table <(cat '{NEAREST_TABLE}') /dev/stdin < <(cat '{CIRCLE6}') 2>&1"
        status, output = run(['bash', '-c', script])
        assert status == 0, output
        expected = run([*EVALUATE, '--q-table', NEAREST_TABLE, CIRCLE6])[1]
        assert output.replace('stdin  ', 'circle6') == expected

    def test_an_endless_pipe(self):
        status, output = run(['bash', '-c', f"'{EVALUATE[0]}' --q-table '{NEAREST_TABLE}' <(yes)"])
        assert status == 1, output
        assert_says(output, ': has more, expected at most 100 MB')

    def test_a_file_that_is_too_large(self, runner):
        file = runner.write('scenario.yaml', 'name: a')
        os.truncate(file, 2 * 10**12)  # has no blocks on the disk
        status, output = run([*EVALUATE, '--q-table', NEAREST_TABLE, file])
        assert status == 1, output
        assert_says(output, f'{file}: is 2000000 MB, expected at most 100 MB')


# Arguments: size of the disk and further options for it, folder of the disk, folder for its files at the end, command
# before it, command. The files of the second folder are there from the start.
ON_A_DISK = f'''
mount -t tmpfs -o "$1" disk "$2" || exit {NO_DISK}
disk=$2 files=$3 first=$4; shift 4
cp -a "$files/." "$disk"; rm "$files"/*
eval "$first"
"$@"; status=$?
cp -a "$disk/." "$files"
exit $status
'''


class DiskTest:
    """Disks of their own, as small as they need to be."""

    @pytest.fixture
    def disk(self, runner):
        """Returns a function that runs a training on a disk that has a previous output: options of the disk, what is
        done before, and arguments of the training; it returns exit status, text and the files at the end."""
        folder, files = runner.path('disk'), runner.path('files')

        def on_disk(options, first, *arguments):
            for path in (folder, files):
                os.makedirs(path, exist_ok=True)
            shutil.copy(NEAREST_TABLE, os.path.join(files, 'table'))
            space = ['unshare', '--mount', *([] if os.geteuid() == 0 else ['--map-root-user'])]
            command = [os.path.join(tools_folder(), 'train'), config_of(runner, 'traces', 50_000), '--output',
                       os.path.join(folder, 'table'), *arguments]
            status, output = run([*space, 'sh', '-c', ON_A_DISK, 'sh', options, folder, files, first, *command])
            if status == NO_DISK or 'unshare failed' in output:
                pytest.skip(f'there are no disks of a test here: {output}')
            return status, output, {name: os.path.join(files, name) for name in os.listdir(files)}
        return on_disk

    @pytest.mark.parametrize('option', ['--log', '--record'])
    def test_becomes_full(self, runner, disk, option):
        """The table has the place that it needs; it replaces the previous one."""
        status, output, files = disk('size=400k', '', option, runner.path('disk/rows'))
        assert status == 1, output
        assert_says(output, 'rows: cannot be written: No space left on device', 'ended by an error')
        assert sorted(files) == ['rows', 'table']
        assert os.path.getsize(files['rows']) > 200_000
        learned = int(output.split(' decisions, ')[0].split()[-1])
        assert 0 < learned == QTableFile(files['table']).header['decisions']

    @pytest.mark.parametrize('options, first, reason', [
        ('size=60k', '', 'No space left on device: it may need'),
        ('size=1m,nr_inodes=2', '', 'No space left on device'),
        ('size=1m', 'mount -o remount,ro "$disk"', 'Read-only file system'),
    ])
    def test_has_no_place_from_the_start(self, runner, disk, options, first, reason):
        """The previous table stays, and nothing is learned in vain."""
        status, output, files = disk(options, first, '--log', runner.path('log'))
        assert status == 1, output
        assert_says(output, f'train: {runner.path("disk/table")}: cannot be written: {reason}')
        assert 'episodes, ' not in output
        assert list(files) == ['table']
        assert read_bytes(files['table']) == read_bytes(NEAREST_TABLE)
        assert not os.path.exists(runner.path('log'))
