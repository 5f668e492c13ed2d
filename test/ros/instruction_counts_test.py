#!/usr/bin/python3
"""Small runs take as many instructions as they did when these were last counted; their results do not depend on which
vector instructions the processor has."""
import os
import pathlib
import sys

import support
from roslib.packages import find_node

sys.path.insert(0, support.in_package('scripts'))
from crowd_bench import instruction_counts  # noqa: E402
from crowd_bench.callgrind import has_valgrind  # noqa: E402
from crowd_experiments.runs import RunError  # noqa: E402

ADVICE = 'If that is as it should be: scripts/count_instructions --keep'
VALGRIND = ('valgrind', '--tool=none', '--quiet')
REFERENCE = ('env', 'SOCIAL_CROWD_SIMD=reference')


class InstructionCountsTest(support.CrowdTestCase):
    """Skipped where counts cannot be compared: another compiler, other flags, another kind of processor."""

    def setUp(self):
        super().setUp()
        if not has_valgrind():
            self.skip('there is no valgrind')
        self.tools = pathlib.Path(find_node('social_crowd', 'train')[0]).parent
        try:
            kind = instruction_counts.kind_of(self.tools)
        except RunError as error:
            self.skip(str(error))
        self.kept = instruction_counts.read_kept()
        if kind != self.kept['kind']:
            self.skip(f"this is '{kind}', what was counted is '{self.kept['kind']}'")

    def check(self, run):
        count, kept = run.count(self.tools), self.kept['counts'][run.name]
        self.assertTrue(instruction_counts.is_fine(count, kept),
                        f'{count:,} instructions, {instruction_counts.change(count, kept):+.2f} %. {ADVICE}')

    def test_evaluate(self):
        self.check(instruction_counts.RUNS[0])

    def test_train(self):
        self.check(instruction_counts.RUNS[1])

    def test_what_is_never_entered_counts_as_a_failure(self):
        run = instruction_counts.RUNS[1]
        with self.assertRaisesRegex(RunError, 'never entered'):
            instruction_counts.CountedRun('none', 'crowd::noSuchFunction()', run.command).count(self.tools)


class SameBitsTest(support.CrowdTestCase):
    """Kernels for what the processor has, those for AVX2 (valgrind knows no AVX-512), and the scalar ones."""

    def setUp(self):
        super().setUp()
        if not has_valgrind():
            self.skip('there is no valgrind')

    def check(self, written, tool, *arguments):
        """What a tool writes is the same either way, byte for byte."""
        results = []
        for within in ((), VALGRIND, REFERENCE):
            self.tool(tool, *arguments, within=within)
            results.append(support.read_bytes(self.path(written)))
            os.remove(self.path(written))
        for other in results[1:]:
            self.assert_same_recording(other, results[0])

    def test_trajectories(self):
        self.check('circle12.csv', 'evaluate', '--q-table', support.ANTICIPATION_TABLE, '--threads', 1, '--episodes', 2,
                   '--trajectories', self.folder, support.in_package('config', 'scenarios', 'circle12.yaml'))

    def check_trained_table(self, name, episodes):
        self.check('table.txt', 'train', support.in_package('config', 'learning', f'{name}.yaml'), '--output',
                   self.path('table.txt'), '--threads', 1, '--episodes', episodes)

    def test_trained_table_of_anticipation(self):
        self.check_trained_table('anticipation', 10)

    def test_trained_table_of_thesis_occupancy(self):
        self.check_trained_table('thesis_occupancy', 30)


class ComparisonTest(support.CrowdTestCase):
    """Counts against those that are kept."""

    def test_tolerance(self):
        self.assertTrue(instruction_counts.is_fine(1019, 1000))
        self.assertTrue(instruction_counts.is_fine(981, 1000))
        self.assertFalse(instruction_counts.is_fine(1021, 1000))
        self.assertFalse(instruction_counts.is_fine(979, 1000))

    def test_what_is_kept_reads_back(self):
        file = self.path('counts.yaml')
        instruction_counts.write_kept('GNU 12 Release', {'train': 12345678901}, file)
        self.assertEqual(instruction_counts.read_kept(file), {'kind': 'GNU 12 Release',
                                                              'counts': {'train': 12345678901}})


if __name__ == '__main__':
    support.run('instruction_counts_test')
