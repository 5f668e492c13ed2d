"""evaluate under mpirun: one crowd on several processes, with the same files as one process."""
import glob
import os
import shutil
import signal
import subprocess

import pytest
from programs import ANTICIPATION_TABLE, PATIENCE, assert_same_recording, assert_says, in_package, read_bytes, wait_for
from roslib.packages import find_node

HUMAN_TABLE = in_package('config', 'q_tables', 'human.txt')
# A solid crowd with obstacles and a wall.
SOLID = '''name: solid
duration: 4
goal_tolerance: 0.3
contact: solid
way_finding: false
walls: [[[-2, -5], [2, -5]]]
obstacles:
  - {position: [0, 0], radius: 0.5}
  - {position: [-8, 3], radius: 0.4, velocity: [0.7, 0]}
agents:
  - {count: 300, position: {box: [[-20, -8], [20, 8]]}, goal: {box: [[-20, -8], [20, 8]]}, speed: [0.8, 1.6],
     radius: [0.18, 0.3]}
'''
LONG = '''name: long
duration: 100000
goal_tolerance: 0.3
agents: [{position: [0, 0], goal: [100000, 0], speed: 1, radius: 0.25}]
'''
# Without binding, ranks share the processors with other programs fairly.
MPIRUN = ('mpirun', '--oversubscribe', '--allow-run-as-root', '--bind-to', 'none')


def is_built_with_mpi():
    """Whether the programs can be run with mpirun."""
    program = find_node('social_crowd', 'evaluate')[0]
    done = subprocess.run([program, '--help'], stdout=subprocess.PIPE, text=True, check=True)
    return shutil.which('mpirun') is not None and 'built with MPI' in done.stdout


needs_mpi = pytest.mark.skipif(not is_built_with_mpi(), reason='there is no mpirun, or the programs are without MPI')


def evaluate(*arguments):
    """Returns the command line of the program."""
    return [find_node('social_crowd', 'evaluate')[0], *map(str, arguments)]


def environment():
    """Returns the variables of a process that waits for others without occupying a processor."""
    return {**os.environ, 'OMPI_MCA_mpi_yield_when_idle': '1'}


def run(command, folder=None):
    """Runs a command in a folder. Returns exit status and output: standard output, then standard error."""
    # Two pipes: in one, mpirun puts parts of a line of standard error into lines of standard output.
    done = subprocess.run(command, cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, timeout=PATIENCE,
                          env=environment(), check=False)
    return done.returncode, (done.stdout + done.stderr).decode(errors='replace')


class OneCrowdTest:
    """The same bytes for any number of processes."""

    FILES = ('walks/solid.csv', 'walks/crowd_random_50.csv', 'scenes/solid.yaml', 'metrics.csv', 'record.csv')

    def walk(self, runner, name, prefix=()):
        """Walks two episodes of two scenarios. Returns the files' contents and the output."""
        folder = runner.path(name)
        os.mkdir(folder)
        scenario = runner.write('solid.yaml', SOLID)
        status, output = run([*prefix, *evaluate(
            '--q-table', HUMAN_TABLE, '--episodes', 2, '--seed', 5, '--trajectories', f'{folder}/walks', '--scenes',
            f'{folder}/scenes', '--csv', f'{folder}/metrics.csv', '--record', f'{folder}/record.csv', scenario,
            'crowd_random_50')])
        assert status == 0, output
        return [read_bytes(f'{folder}/{file}') for file in self.FILES], output

    @needs_mpi
    def test_gives_the_same_files(self, runner):
        expected, _ = self.walk(runner, 'alone')
        for count in (1, 2, 3, 4):
            files, output = self.walk(runner, f'ranks_{count}', [*MPIRUN, '-n', str(count)])
            for got, wanted in zip(files, expected):
                assert_same_recording(got, wanted)
            assert output.count('\nsolid ') == 1, 'the table is printed once'
            if count > 1:
                assert_says(output, f'{count} ranks, 300 agents', 'MB exchanged per tick', 'imbalance of agents')

    @needs_mpi
    def test_works_with_more_processes_than_agents(self, runner):
        scenario = runner.write('one.yaml', LONG.replace('100000', '10'))
        status, output = run([*MPIRUN, '-n', '5', *evaluate('--q-table', ANTICIPATION_TABLE, scenario)])
        assert status == 0, output
        assert_says(output, '5 ranks, 1 agents', '100.00')

    @needs_mpi
    @pytest.mark.parametrize('arguments', [
        ('place_bottleneck',),
        ('single_free', '--states', 'states'),
        ('robot_crossing', '--robot', 'reactive', '--people-delay', '--robots-csv', 'robots.csv'),
    ])
    def test_scenes_that_cannot_be_divided(self, runner, arguments):
        written = []
        for name, prefix in (('alone', ()), ('ranks', (*MPIRUN, '-n', '3'))):
            folder = runner.path(name)
            os.mkdir(folder)
            status, output = run([*prefix, *evaluate('--q-table', HUMAN_TABLE, '--trajectories', 'walks', '--record',
                                                     'record.csv', '--csv', 'metrics.csv', *arguments)], folder)
            assert status == 0, output
            written.append({os.path.relpath(file, folder): read_bytes(file)
                            for file in glob.glob(f'{folder}/**', recursive=True) if os.path.isfile(file)})
        assert_says(output, '3 ranks', 'by rank 0 alone')
        assert len(written[0]) >= 3
        assert written[0] == written[1]


class ErrorsTest:
    """Clear messages, once, and exit status 1."""

    def fails(self, *command):
        """Runs a command that fails. Returns the program's lines of the output."""
        status, output = run(command)
        assert status == 1, output
        return [line for line in output.splitlines() if line.startswith('evaluate: ')]

    @needs_mpi
    def test_processes_with_other_tables(self):
        lines = self.fails(*MPIRUN, '-n', '1', *evaluate('--q-table', ANTICIPATION_TABLE, 'circle6'), ':',
                           '-n', '2', *evaluate('--q-table', HUMAN_TABLE, 'circle6'))
        assert len(lines) == 1
        assert_says(lines[0], 'rank 1 differs from rank 0', 'Q-table')

    @needs_mpi
    def test_processes_with_other_scenes(self, runner):
        os.mkdir(runner.path('other'))
        one = runner.write('solid.yaml', SOLID)
        other = runner.write('other/solid.yaml', SOLID.replace('radius: 0.5', 'radius: 0.51'))
        lines = self.fails(*MPIRUN, '-n', '2', *evaluate('--q-table', HUMAN_TABLE, one), ':',
                           '-n', '1', *evaluate('--q-table', HUMAN_TABLE, other))
        assert len(lines) == 1
        assert_says(lines[0], 'rank 2 differs from rank 0', "scene of 'solid'")

    @needs_mpi
    def test_processes_with_other_versions(self, runner):
        library = os.path.join(in_lib(), 'libsocial_crowd_core.so')
        shutil.copy(library, runner.folder)
        with open(runner.path('libsocial_crowd_core.so'), 'ab') as stream:
            stream.write(b'another version')
        command = evaluate('--q-table', HUMAN_TABLE, 'circle6')
        lines = self.fails(*MPIRUN, '-n', '1', *command, ':', '-n', '1', 'env', f'LD_LIBRARY_PATH={runner.folder}',
                           *command)
        assert len(lines) == 1
        assert_says(lines[0], 'rank 1 differs from rank 0', "the program's library")

    @needs_mpi
    def test_unknown_scenario(self):
        lines = self.fails(*MPIRUN, '-n', '2', *evaluate('--q-table', ANTICIPATION_TABLE, 'nonsense'))
        assert len(lines) == 1
        assert_says(lines[0], "no scenario 'nonsense'")

    @needs_mpi
    def test_one_process_that_cannot_write(self, runner):
        lines = self.fails(*MPIRUN, '-n', '2', *evaluate('--q-table', ANTICIPATION_TABLE, '--record',
                                                         runner.path('none/record.csv'), 'circle6'))
        assert len(lines) == 1
        assert_says(lines[0], 'none/record.csv')

    @needs_mpi
    def test_a_process_that_dies_ends_all(self, runner):
        process = runner.start('mpirun', [*MPIRUN, '-n', '2', *evaluate(
            '--q-table', ANTICIPATION_TABLE, runner.write('long.yaml', LONG))], environment())
        children = wait_for(lambda: children_of(process.process.pid, 2), 'two processes')
        wait_for(lambda: 'scenario' in process.output(), 'the first output')
        os.kill(children[1], signal.SIGKILL)
        assert process.wait() != 0
        assert 'signal 9' in process.output()

    @needs_mpi
    def test_ctrl_c_ends_all(self, runner):
        process = runner.start('mpirun', [*MPIRUN, '-n', '2', *evaluate(
            '--q-table', ANTICIPATION_TABLE, runner.write('long.yaml', LONG))], environment())
        wait_for(lambda: children_of(process.process.pid, 2), 'two processes')
        process.signal(signal.SIGINT)
        assert process.wait() != 0


def in_lib():
    """Returns the folder of the package's library."""
    program = find_node('social_crowd', 'evaluate')[0]
    done = subprocess.run(['ldd', program], stdout=subprocess.PIPE, text=True, check=True)
    line = next(line for line in done.stdout.splitlines() if 'libsocial_crowd_core' in line)
    return os.path.dirname(line.split()[2])


def children_of(pid, count):
    """Returns the child processes of a process if there are at least that many."""
    done = subprocess.run(['pgrep', '--parent', str(pid)], stdout=subprocess.PIPE, text=True, check=False)
    children = [int(word) for word in done.stdout.split()]
    return children if len(children) >= count else None
