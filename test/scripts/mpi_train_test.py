"""train under mpirun: learners on several processes, with the same files as one process."""
import os
import re
import signal

import pytest
from mpi_test import MPIRUN, children_of, environment, needs_mpi, run
from learning_files import config_text
from programs import CIRCLE6, assert_says, in_package, read_bytes, read_text, tools_folder, wait_for

CROWD = in_package('config', 'learning', 'anticipation.yaml')
FILES = ('output', 'record', 'log', 'checkpoint')


def train(*arguments):
    """Returns the command line of the program."""
    return [os.path.join(tools_folder(), 'train'), *map(str, arguments)]


def on_ranks(count, command):
    """Returns the command line that runs a program on `count` ranks."""
    return [*MPIRUN, '-n', str(count), *command]


class Plan:
    """A training of five learners side by side, with all its files."""

    def __init__(self, runner, name, episodes=100, learners=5):
        text = read_text(CROWD).replace('../scenarios/training_crowd.yaml', CIRCLE6)
        text = text.replace('  episodes: 8000\n', f'  episodes: 8000\n  side_by_side: {learners}\n  turn: 4\n')
        assert 'side_by_side' in text
        self.config = runner.write('crowd.yaml', text)
        self.files = {option: runner.path(f'{name}.{option}') for option in FILES}
        self.saved = runner.path(f'{name}_000060.output')
        files = [word for option in FILES for word in ('--' + option, self.files[option])]
        self.command = train(self.config, *files, '--episodes', episodes, '--save-every', 60,
                             '--checkpoint-interval', 0)

    def results(self):
        """Returns the bytes of all files."""
        return [read_bytes(file) for file in (*self.files.values(), self.saved)]


@pytest.fixture(name='expected')
def expected_results(runner):
    """The files of one process."""
    plan = Plan(runner, 'alone')
    status, output = run(plan.command)
    assert status == 0, output
    results = plan.results()
    assert None not in results
    return results


@needs_mpi
@pytest.mark.parametrize('ranks, threads', [(1, 1), (2, 1), (3, 2)])
def test_gives_the_same_files(runner, expected, ranks, threads):
    plan = Plan(runner, 'ranks')
    status, output = run(on_ranks(ranks, [*plan.command, '--threads', str(threads)]))
    assert status == 0, output
    assert plan.results() == expected
    assert output.count('100 episodes, ') == 1, 'the summary is printed once'
    if ranks > 1:
        assert_says(output, f'{ranks} ranks, 5 learners, 5 turns', 'MB exchanged per turn', 'imbalance of episodes')


@needs_mpi
@pytest.mark.parametrize('first, second', [(1, 3), (3, 1), (2, 3)])
def test_goes_on_with_another_number_of_ranks(runner, expected, first, second):
    plan = Plan(runner, 'resumed')
    for ranks, episodes in ((first, 40), (second, 100)):
        command = [*plan.command, '--resume']
        command[command.index('--episodes') + 1] = str(episodes)
        status, output = run(on_ranks(ranks, command) if ranks > 1 else command)
        assert status == 0, output
    assert_says(output, '40 of 100 episodes are done')
    assert plan.results() == expected


def start(runner, plan, *options):
    """Starts a long training on two ranks. Returns mpirun and the numbers of the ranks' processes."""
    process = runner.start('mpirun', on_ranks(2, [*plan.command, *options]), environment())
    children = wait_for(lambda: children_of(process.process.pid, 2), 'two processes')
    log = plan.files['log']
    wait_for(lambda: os.path.exists(log) and os.path.getsize(log) > 3000, 'the log to grow')
    return process, children


@needs_mpi
def test_a_process_that_dies_leaves_the_last_checkpoint(runner):
    plan = Plan(runner, 'killed', 20_000)
    process, children = start(runner, plan)
    os.kill(children[1], signal.SIGKILL)
    assert process.wait() != 0
    assert_says(process.output(), 'signal 9')
    done = int(read_text(plan.files['checkpoint']).split('\nepisode ')[1].split()[0])
    assert done > 0 and done % 20 == 0
    whole = Plan(runner, 'whole', done + 200)
    status, output = run(whole.command)
    assert status == 0, output
    position = plan.command.index('--episodes')
    plan.command[position + 1] = str(done + 200)
    status, output = run(on_ranks(3, [*plan.command, '--resume']))
    assert status == 0, output
    assert plan.results() == whole.results()


@needs_mpi
@pytest.mark.parametrize('receiver', ['mpirun', 'one process'])
def test_ctrl_c_saves_the_table(runner, receiver):
    if receiver == 'mpirun':  # it kills the processes after a second, which is too short on a busy machine
        runner.environment['OMPI_MCA_odls_base_sigkill_timeout'] = '5'
    plan = Plan(runner, 'interrupted', 200_000)
    process, children = start(runner, plan)
    os.kill(process.process.pid if receiver == 'mpirun' else children[1], signal.SIGINT)
    status = process.wait()
    # mpirun hides the exit status after a signal of its own.
    assert status == (1 if receiver == 'mpirun' else 130), process.output()
    assert_says(process.output(), '; interrupted')
    rows = read_text(plan.files['log']).count('\n') - 1
    assert f'\nepisode {rows}\n' in read_text(plan.files['checkpoint'])
    assert f'{rows} episodes, ' in process.output()
    decisions = re.search(r'episodes, (\d+) decisions', process.output())[1]
    assert int(decisions) > 0
    assert f'\ndecisions: {decisions}\n' in read_text(plan.files['output'])


class ErrorsTest:
    """Clear messages, once."""

    def fails(self, status, *command):
        """Runs a command that fails. Returns the line of the program."""
        got, output = run(command)
        assert got == status, output
        lines = [line for line in output.splitlines() if line.startswith(('train: ', 'evaluate: '))]
        assert len(lines) == 1, output
        return lines[0]

    @needs_mpi
    def test_processes_with_other_configurations(self, runner):
        one = runner.write('one.yaml', config_text(CIRCLE6, 40).replace('tables:', 'side_by_side: 3, tables:'))
        other = runner.write('other.yaml', read_text(one).replace('gamma: 0.', 'gamma: 0.0'))
        assert read_text(one) != read_text(other)
        table = runner.path('table.txt')
        assert_says(self.fails(1, *MPIRUN, '-n', '1', *train(one, '-o', table), ':', '-n', '1',
                               *train(other, '-o', table)), 'rank 1 differs from rank 0 in the training', 'gamma')
        assert_says(self.fails(1, *MPIRUN, '-n', '1', *train(one, '-o', table), ':', '-n', '1',
                               *train(one, '-o', table, '--episodes', 7)), 'number of episodes', "'7' there")
        assert not os.path.exists(table)

    @needs_mpi
    def test_more_processes_than_learners(self, runner):
        plan = Plan(runner, 'few', learners=2)
        assert_says(self.fails(1, *on_ranks(3, plan.command)), 'training.side_by_side: expected 3', 'got 2')

    @needs_mpi
    def test_other_programs(self, runner):
        plan = Plan(runner, 'program')
        evaluating = [os.path.join(tools_folder(), 'evaluate'), '--q-table', 'none', 'circle6']
        assert_says(self.fails(1, *MPIRUN, '-n', '1', *plan.command, ':', '-n', '1', *evaluating),
                    'rank 1 differs from rank 0 in the program')

    @needs_mpi
    def test_a_disk_that_becomes_full(self, runner):
        plan = Plan(runner, 'growing', 100_000)
        command = ['sh', '-c', 'ulimit -f 1000; trap "" XFSZ; exec "$@"', 'sh', *plan.command]  # 512 kB
        # Through the loopback interface: the limit is too small for shared memory, and there may be no other network.
        loopback = ('--mca', 'btl', 'self,tcp', '--mca', 'btl_tcp_if_include', 'lo')
        status, output = run([*MPIRUN, *loopback, '-n', '1', *command, ':', '-n', '1', *plan.command])
        assert status == 1, output
        assert_says(output, 'File too large', '; ended by an error')
        assert int(re.search(r': (\d+) episodes, ', output)[1]) > 0
        decisions = re.search(r'episodes, (\d+) decisions', output)[1]
        assert f'\ndecisions: {decisions}\n' in read_text(plan.files['output'])

    @needs_mpi
    def test_a_full_disk(self, runner):
        plan = Plan(runner, 'full')
        command = train(plan.config, '--episodes', 100, '-o', runner.path('table.txt'), '--log', '/dev/full')
        assert_says(self.fails(1, *on_ranks(2, command)), '/dev/full', 'No space left')

    @needs_mpi
    @pytest.mark.parametrize('tool', ['train', 'evaluate'])
    def test_help_and_wrong_usage_are_printed_once(self, tool):
        program = os.path.join(tools_folder(), tool)
        status, output = run(on_ranks(3, [program, '--help']))
        assert status == 0
        assert output.count('Exit status: 0') == 1
        assert_says(self.fails(2, *on_ranks(3, [program])), 'is required')
