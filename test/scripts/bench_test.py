"""scripts/bench and research/bench_sweeps: processing of benchmark results, which are written by hand."""
import json
import os
import pathlib
import signal

import pytest
from crowd_bench import callgrind as profile, table, table as document
from crowd_bench.table import BENCHMARKS
from crowd_sweeps import sweeps as rank_scaling
from crowd_sweeps.sweeps import SWEEPS
from programs import assert_says, in_package, read_bytes, read_text, wait_for

# Writes the output format of Google Benchmark with the given counters of each repetition; None never ends.
PROGRAM = '''#!/usr/bin/python3
import json
import re
import sys
import time
options = dict(word.lstrip('-').split('=', 1) for word in sys.argv[1:])
runs = []
for name, repetitions in {counters!r}.items():
    if not re.search(options['benchmark_filter'], name):
        continue
    for counters in repetitions[:int(options['benchmark_repetitions'])]:
        if counters is None:
            time.sleep(600)
        runs.append({{'run_name': name, 'name': name, 'run_type': 'iteration', **counters}})
    median = dict.fromkeys(counters, -1.0)
    runs.append({{'run_name': name, 'name': name + '_median', 'run_type': 'aggregate', **median}})
with open(options['benchmark_out'], 'w') as stream:
    json.dump({{'benchmarks': runs}}, stream)
'''


def repetitions(**counters):
    """Returns the counters of each repetition: rate=[1.0, 2.0] -> [{'rate': 1.0}, {'rate': 2.0}]."""
    return [dict(zip(counters, values)) for values in zip(*counters.values())]


COUNTERS = {
    # The median of the ratios 2, 3 and 1.5 is 2; the ratio of the medians is 3.
    'train_occupancy/manual_time': repetitions(rate=[1e6, 2e6, 4e6], yardstick_rate=[2e6, 6e6, 6e6]),
    'crowd_step_10000_two_threads/iterations:2/manual_time': repetitions(rate=[3e6] * 3, yardstick_rate=[2e6] * 3),
    'q_table_load/manual_time': repetitions(real_time=[30.0, 31.0, 50.0], yardstick_rate=[2000.0] * 3),
    'memory_100000/iterations:5': repetitions(megabytes=[150.0, 1000.0, 1000.0]),  # only the first is valid
    'crowd_step_agents/1000/iterations:40': repetitions(rate=[9e5, 1e6, 8e5]),
    'crowd_step_agents/20000/iterations:40/real_time': repetitions(rate=[5e5, 5e5, 5e5]),
    'q_table_save/manual_time': [None],
}
ENTRIES = {entry.name: entry for entry in BENCHMARKS + SWEEPS}


class BenchTest:
    """The complete program."""

    def bench(self, runner, *words, program=PROGRAM.format(counters=COUNTERS), script='scripts/bench'):
        """Starts scripts/bench, or another script, with a substitute for the benchmarks."""
        os.makedirs(runner.path('tools'), exist_ok=True)
        os.chmod(runner.write('tools/core_benchmarks', program), 0o755)
        return runner.start('bench', [in_package(script), '--tools', runner.path('tools'),
                                      '--repetitions', '3', '--plots', runner.path('plots'),
                                      '--json', runner.path('results.json'), *words])

    def results(self, runner):
        """Returns the written results, by name."""
        return {result.pop('name'): result for result in json.loads(read_text(runner.path('results.json')))}

    def test_medians_and_ratios(self, runner):
        running = self.bench(runner, 'train_occupancy', 'crowd_step_10000_two_threads', 'q_table_load', 'memory_100000')
        assert running.wait() == 0, running.output()
        assert self.results(runner) == {
            'train_occupancy': {'value': 2e6, 'unit': 'decisions/s', 'yardstick': 6e6, 'ratio': 2.0},
            'crowd_step_10000_two_threads': {'value': 3e6, 'unit': 'agent steps/s', 'yardstick': 2e6, 'ratio': 1.5},
            'q_table_load': {'value': 31.0, 'unit': 'ms', 'yardstick': 0.5, 'ratio': 62.0},
            'memory_100000': {'value': 150.0, 'unit': 'MB', 'yardstick': None, 'ratio': None},
        }
        assert len(running.output().splitlines()) == 5, 'a heading and a line each'

    def test_ranks_are_measured_under_mpirun(self, runner):
        os.mkdir(runner.path('bin'))
        os.chmod(runner.write('bin/mpirun', '#!/bin/sh\nexec sh -c "$(cat "$(dirname "$0")/rates")"\n'), 0o755)
        runner.write('bin/rates', '\n'.join(
            f'echo \'{{"rate": {rate}, "parts_rate": {parts}, "threads_rate": 1e6}}\''
            for rate, parts in ((9e5, 1e6), (8e5, 1e6), (7e5, 1e6))))
        runner.environment['PATH'] = f"{runner.path('bin')}:{os.environ['PATH']}"
        running = self.bench(runner, 'crowd_step_mpi_2', 'crowd_step_mpi_2_parts')
        assert running.wait() == 0, running.output()
        assert self.results(runner) == {
            name: {'value': 8e5, 'unit': 'agent steps/s', 'yardstick': 1e6, 'ratio': 0.8}
            for name in ('crowd_step_mpi_2', 'crowd_step_mpi_2_parts')}
        assert_says(running.output(), 'yes', 'no')

    def test_sweeps_fill_documents_with_tables_and_pictures(self, runner):
        os.mkdir(runner.path('images'))
        pictures = runner.write('pictures.md', '![](images/crowd_step_agents.png)\n')
        tables = runner.write('tables.md', '<!-- table performance/crowd_step_agents -->\n<!-- end -->\n')
        running = self.bench(runner, 'crowd_step_agents', '--document', pictures, '--document', tables,
                             script='research/bench_sweeps')
        assert running.wait() == 0, running.output()
        rows = '| 1,000 | 1.000 | 1.00 | 1.00 |\n| 20,000 | 0.500 | 2.00 | 2.00 |'
        assert rows in read_text(tables)
        assert read_bytes(runner.path('images/crowd_step_agents.png')).startswith(b'\x89PNG')

    def test_an_interrupt_keeps_the_results(self, runner):
        running = self.bench(runner, 'train_occupancy', 'q_table_save')
        wait_for(lambda: 'train_occupancy  ' in running.output(), 'the first result')
        running.signal(signal.SIGINT)
        assert running.wait() == 130, running.output()
        assert set(self.results(runner)) == {'train_occupancy'}

    def test_failures_are_reported(self, runner):
        broken = self.bench(runner, 'train_occupancy', program='#!/bin/sh\necho out of order\nexit 3\n')
        assert broken.wait() == 1
        assert_says(broken.output(), 'train_occupancy: failed: core_benchmarks: out of order\n')
        lacking = self.bench(runner, 'train_anticipation', 'q_table_load')
        assert lacking.wait() == 1
        assert_says(lacking.output(), 'has no benchmark', 'train_anticipation')
        assert set(self.results(runner)) == {'q_table_load'}, 'what follows is measured'
        assert self.bench(runner, 'no_such_benchmark').wait() == 2


class TableTest:
    """Comparison of results with their bars, and rows of the document."""

    def test_bars(self):
        for name, value, yardstick, expected in [
                ('train_occupancy', 8e6, 9e6, True), ('train_occupancy', 7.9e6, 9e6, False),
                ('crowd_step_10000', 2e6, 9e6, True), ('crowd_step_10000', 1.9e6, 2e6, False),
                ('crowd_step_map_1000', 2e6, 3e6, True), ('crowd_step_map_1000', 2e6, 3.1e6, False),
                ('crowd_step_10000_two_threads', 1.8e6, 1e6, True), ('crowd_step_10000_two_threads', 9e9, 8e9, False),
                ('ros_lockstep_1000', 250, 400, True), ('ros_lockstep_1000', 249, 249, False),
                ('nodelets_1000', 800, 1600, True), ('nodelets_1000', 800, 1601, False),
                ('real_time_1000', 40, None, True), ('real_time_1000', 41, None, False),
                ('q_table_load', 50, 1, True), ('q_table_load', 51, 1, False)]:
            benchmark = ENTRIES[name]
            ratio = benchmark.ratio(value, yardstick) if yardstick else None
            result = benchmark.result(value, yardstick, ratio)
            assert benchmark.clears_bar(result) == expected, (name, value)

    def test_rows_without_new_results_are_kept(self, runner):
        file = pathlib.Path(runner.write('page.md', '<!-- table performance/benchmarks -->\n'
                                                    '| name | what |\n|---|---|\n'
                                                    '| q_table_save | a | b | c | d | e | f | g | h | i |\n'
                                                    '<!-- end -->\n'))
        load = ENTRIES['q_table_load']
        slow = (f'| q_table_load | {load.title} | ≤ 50 ms | 60 ms'
                f' | 49.5, 61 | {load.yardstick} | 0.5 ms | 120.00 |  | no |')
        fast = f'| q_table_load | {load.title} | ≤ 50 ms | 40 ms |  | {load.yardstick} | 0.5 ms | 80.00 |  | yes |'
        document.fill(file, [load.result(60.0, 0.5, 120.0, (49.5, 61.0))], [], 3)
        text = read_text(file)
        assert_says(text, '| q_table_save | a | b | c | d | e | f | g | h | i |', slow,
                    f"| train_occupancy | {ENTRIES['train_occupancy'].title} |  |")
        document.fill(file, [load.result(40.0, 0.5, 80.0)], [], 3)
        assert read_text(file) == text.replace(slow, fast)

    def test_a_result_through_ros_has_no_spread(self):
        lockstep = ENTRIES['ros_lockstep_12']
        result = {'name': lockstep.name, 'value': 7000.0, 'unit': lockstep.unit, 'yardstick': 7000.0, 'ratio': 1.0}
        assert table.row(result, lockstep)[3:5] == ['7,000 ticks/s', '']

    def test_quantities(self):
        quantities = [table.quantity(value, 'x') for value in (2512345.0, 123456.0, 6543.2, 51.234, 0.4321, None)]
        assert quantities == ['2.51 M x', '0.123 M x', '6,543 x', '51.2 x', '0.432 x', '']

    def test_speed_up_by_threads(self):
        sweep = ENTRIES['crowd_step_threads']
        assert sweep.points([(1, 2e6), (2, 3e6)]) == [(1, 1.0), (2, 1.5)]


class ProfileTest:
    """Profiles of instructions."""

    def test_annotation(self):
        text = ('Ir\n---\n1,000 (100.0%)  PROGRAM TOTALS\n---\nIr  file:function\n---\n'
                '600 (60.00%)  ???:crowd::World::look(crowd::Vision const&) const [/lib/core.so]\n'
                '150 (15.00%)  ./math/./s_sin.c:__sincos_fma [/lib/libm.so.6]\n'
                '200 (20.00%)  ???:crowd::World::look(crowd::Vision const&) const\'2 [/lib/core.so]\n'
                ' 50 ( 5.00%)  ???:crowd::(anonymous namespace)::walk(int) [/lib/core.so]\n')
        shares = profile.read_annotation(text)
        assert shares == [('crowd::World::look', 80.0), ('__sincos_fma', 15.0), ('crowd::walk', 5.0)]
        assert profile.rows(shares)[-1] == ['all others', '0.0']

    def test_nothing_counted_is_an_error(self):
        with pytest.raises(profile.RunError, match='counted nothing'):
            profile.read_annotation('Ir\n---\n0  PROGRAM TOTALS\n---\nIr  file:function\n---\n')

    def test_by_class(self):
        shares = [('crowd::World::look', 40.0), ('sin', 20.0), ('crowd::World::step', 10.0), ('crowd::QTable::at', 9.0)]
        assert profile.by_class(shares) == [('crowd::World', 50.0), (profile.LIBRARIES, 20.0), ('crowd::QTable', 9.0)]


class RankScalingTest:
    """Model of the weak scaling of a crowd on several ranks."""

    def test_copies_beyond_borders(self):
        # Sides of 447.2 m and 1,264.9 m; one border and two, 9.5 m at 0.5 agents per m².
        assert rank_scaling.copies(1, 50_000) == 0
        assert rank_scaling.copies(2, 50_000) == pytest.approx(0.5 * 9.5 * 447.2, rel=1e-3)
        assert rank_scaling.copies(16, 50_000) == pytest.approx(2 * 0.5 * 9.5 * 1264.9, rel=1e-3)

    def test_fit(self):
        more = [1e-3 * rank_scaling.copies(ranks, 50_000) for ranks in (2, 4)]  # 1 us per copy
        model = rank_scaling.Model.of([(1, 40.0), (2, 40.0 + more[0]), (4, 40.0 + more[1])])
        assert model.per_agent == pytest.approx(40.0 / 50_000)
        assert model.per_copy == pytest.approx(1e-3)
        assert model.tick(1, 100_000) == pytest.approx(80.0)
        # 42 bytes at 1 GB/s are 42 ns more.
        assert model.tick(4, 50_000) == pytest.approx(40.0 + 1.042 * more[1])
        assert model.efficiency(4, 50_000) == pytest.approx(40.0 / (40.0 + 1.042 * more[1]))
