"""Small runs take as many instructions as stored; their results do not depend on the vector instructions of the
processor."""
import os
import pathlib
import re
import subprocess
import sys

import pytest
from crowd_bench import callgrind, callgrind as instruction_counts
from crowd_experiments.runs import RunError
from programs import ANTICIPATION_TABLE, assert_same_recording, assert_says, in_package, read_bytes, tools_folder

ADVICE = 'If this is intended: research/count_instructions --keep'
REFERENCE = 'reference'
# As valgrind 3.19 ends at RDTSCP on processors on which it does not emulate that.
VALGRIND_THAT_DIES = '''#!/bin/sh
cat >&2 <<END
vex amd64->IR: unhandled instruction bytes: 0xF 0x1 0xF9 0x89 0xCF 0x48 0xC1 0xE2 0x20 0x48
==17== valgrind: Unrecognised instruction at address 0x4cb6555.
==17==    at 0x4CB6555: hwy::platform::TimerResolution() (in /usr/lib/x86_64-linux-gnu/libhwy.so.1.0.3)
==17== Process terminating with default action of signal 4 (SIGILL)
END
ulimit -c 0
kill -ILL $$
'''
WHY = ('valgrind cannot start evaluate on this processor: unhandled instruction bytes: 0xF 0x1 0xF9',
       'in hwy::platform::TimerResolution()')


class InstructionCountsTest:
    """Skipped if counts cannot be compared: no valgrind that can run the programs, another compiler, other flags, or
    another kind of processor."""

    @pytest.fixture(scope='class')
    def kept(self):
        """Returns the stored counts, by name."""
        tools = pathlib.Path(tools_folder())
        try:
            callgrind.require_valgrind(tools / 'evaluate')
            kind = instruction_counts.kind_of(tools)
        except RunError as error:
            pytest.skip(str(error))
        kept = instruction_counts.read_kept()
        if kind != kept['kind']:
            pytest.skip(f"this is '{kind}', the stored counts are for '{kept['kind']}'")
        return kept['counts']

    @pytest.mark.parametrize('run', instruction_counts.RUNS, ids=lambda run: run.name)
    def test_counts(self, run, kept):
        count = run.count(pathlib.Path(tools_folder()))
        change = instruction_counts.change(count, kept[run.name])
        assert instruction_counts.is_fine(count, kept[run.name]), f'{count:,} instructions, {change:+.2f} %. {ADVICE}'

    @pytest.mark.usefixtures('kept')
    def test_a_function_that_is_never_called_is_an_error(self):
        command = instruction_counts.RUNS[1].command
        run = instruction_counts.CountedRun('none', 'crowd::noSuchFunction()', command)
        with pytest.raises(RunError, match='never entered'):
            run.count(pathlib.Path(tools_folder()))


class ValgrindThatCannotStartTest:
    """A processor with an instruction that valgrind does not emulate, in the start-up code of the programs."""

    @pytest.fixture
    def environment(self, runner):
        """Returns variables with which the program `valgrind` is one that dies."""
        os.mkdir(runner.path('bin'))
        os.chmod(runner.write('bin/valgrind', VALGRIND_THAT_DIES), 0o755)
        return {'PATH': runner.path('bin') + os.pathsep + os.environ['PATH']}

    def test_count_instructions_says_why(self, runner, environment):
        counting = runner.start('count_instructions', [in_package('research', 'count_instructions'), '--tools',
                                                       tools_folder()], environment)
        assert counting.wait() == 1
        assert_says(counting.output(), 'count_instructions: ', *WHY)

    def test_counts_are_skipped_with_the_reason(self, runner, environment):
        tests = f'{__file__}::{InstructionCountsTest.__name__}'
        testing = runner.start('pytest', [sys.executable, '-m', 'pytest', tests], environment)
        assert testing.wait() == 0, testing.output()
        assert_says(testing.output(), '3 skipped', *WHY)

    def test_another_end_is_told(self):
        assert callgrind.cause_in('valgrind: failed to start\n') == 'valgrind: failed to start'
        assert callgrind.cause_in('') == 'it printed nothing'

    def test_a_missing_valgrind_is_told(self, monkeypatch, runner):
        monkeypatch.setenv('PATH', runner.folder)
        assert_says(callgrind.why_not('evaluate'), 'there is no valgrind')


def vector_targets():
    """Returns the instruction sets of this processor for which there are kernels, by the error that lists them."""
    command = [os.path.join(tools_folder(), 'evaluate'), '--q-table', ANTICIPATION_TABLE,
               in_package('config', 'scenarios', 'circle12.yaml')]
    done = subprocess.run(command, env={**os.environ, 'SOCIAL_CROWD_SIMD': 'none'}, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, check=False)
    targets = re.search(r"SOCIAL_CROWD_SIMD is 'none', expected one of (.*)", done.stdout)[1].split(', ')
    return [target for target in targets if target != REFERENCE]


class SameBitsTest:
    """Compares the kernels for each instruction set of this processor with the scalar kernels."""

    @pytest.fixture(scope='class')
    def targets(self):
        targets = vector_targets()
        return targets or pytest.skip('the programs are built without Highway: there are only scalar kernels')

    @staticmethod
    def result(runner, written, target, tool, *arguments):
        """Returns the bytes of the output of a tool with the kernels for an instruction set."""
        runner.tool(tool, *arguments, within=('env', f'SOCIAL_CROWD_SIMD={target}'))
        result = read_bytes(runner.path(written))
        os.remove(runner.path(written))
        return result

    def check(self, runner, targets, written, *command):
        """Checks that the output of a tool is the same with all kernels, byte for byte."""
        expected = self.result(runner, written, REFERENCE, *command)
        for target in targets:
            print(target)
            assert_same_recording(self.result(runner, written, target, *command), expected)

    def test_trajectories(self, runner, targets):
        self.check(runner, targets, 'circle12.csv', 'evaluate', '--q-table', ANTICIPATION_TABLE, '--threads', 1,
                   '--episodes', 2, '--trajectories', runner.folder, in_package('config', 'scenarios', 'circle12.yaml'))

    def check_trained_table(self, runner, targets, name, episodes):
        self.check(runner, targets, 'table.txt', 'train', in_package('config', 'learning', f'{name}.yaml'), '--output',
                   runner.path('table.txt'), '--threads', 1, '--episodes', episodes)

    def test_trained_table_of_anticipation(self, runner, targets):
        self.check_trained_table(runner, targets, 'anticipation', 10)

    def test_trained_table_of_thesis_occupancy(self, runner, targets):
        self.check_trained_table(runner, targets, 'thesis_occupancy', 30)


class ComparisonTest:
    """Comparison of counts with stored counts."""

    def test_tolerance(self):
        assert instruction_counts.is_fine(1019, 1000)
        assert instruction_counts.is_fine(981, 1000)
        assert not instruction_counts.is_fine(1021, 1000)
        assert not instruction_counts.is_fine(979, 1000)

    def test_stored_counts_are_read_back(self, runner):
        file = runner.path('counts.yaml')
        instruction_counts.write_kept('GNU 12 Release', {'train': 12345678901}, file)
        assert instruction_counts.read_kept(file) == {'kind': 'GNU 12 Release',
                                                      'counts': {'train': 12345678901}}
