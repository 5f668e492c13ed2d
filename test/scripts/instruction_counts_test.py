"""Small runs take as many instructions as stored; their results do not depend on the vector instructions of the
processor."""
import os
import pathlib

import pytest
from crowd_bench import instruction_counts
from crowd_bench.profile import has_valgrind
from crowd_experiments.runs import RunError
from programs import ANTICIPATION_TABLE, assert_same_recording, in_package, read_bytes, tools_folder

ADVICE = 'If this is intended: scripts/count_instructions --keep'
VALGRIND = ('valgrind', '--tool=none', '--quiet')
REFERENCE = ('env', 'SOCIAL_CROWD_SIMD=reference')
needs_valgrind = pytest.mark.skipif(not has_valgrind(), reason='valgrind is missing')


@needs_valgrind
class InstructionCountsTest:
    """Skipped if counts cannot be compared: another compiler, other flags, another kind of processor."""

    @pytest.fixture
    def kept(self):
        """Returns the stored counts, by name."""
        try:
            kind = instruction_counts.kind_of(pathlib.Path(tools_folder()))
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


@needs_valgrind
class SameBitsTest:
    """Compares the kernels for this processor, for AVX2 (valgrind does not support AVX-512), and the scalar kernels."""

    def check(self, runner, written, tool, *arguments):
        """Checks that the output of a tool is the same with all kernels, byte for byte."""
        results = []
        for within in ((), VALGRIND, REFERENCE):
            runner.tool(tool, *arguments, within=within)
            results.append(read_bytes(runner.path(written)))
            os.remove(runner.path(written))
        for other in results[1:]:
            assert_same_recording(other, results[0])

    def test_trajectories(self, runner):
        self.check(runner, 'circle12.csv', 'evaluate', '--q-table', ANTICIPATION_TABLE, '--threads', 1,
                   '--episodes', 2, '--trajectories', runner.folder, in_package('config', 'scenarios', 'circle12.yaml'))

    def check_trained_table(self, runner, name, episodes):
        self.check(runner, 'table.txt', 'train', in_package('config', 'learning', f'{name}.yaml'), '--output',
                   runner.path('table.txt'), '--threads', 1, '--episodes', episodes)

    def test_trained_table_of_anticipation(self, runner):
        self.check_trained_table(runner, 'anticipation', 10)

    def test_trained_table_of_thesis_occupancy(self, runner):
        self.check_trained_table(runner, 'thesis_occupancy', 30)


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
