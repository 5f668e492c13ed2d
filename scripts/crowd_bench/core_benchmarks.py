"""Runs the benchmarks of the core, a program of Google Benchmark, and those on several ranks, programs for mpirun."""
import json
import os
import pathlib
import re
import statistics
import tempfile

from crowd_experiments.runs import RunError, output_of

from .table import AGENT_STEPS, DECISIONS, MEGABYTES, MILLISECONDS, REAL_TIME

RANKS_PROGRAM, TRAINING = 'rank_benchmarks', 'rank_training'
RANKS, LEARNERS, AGENTS = 2, 16, 100_000
# Rates of the yardsticks in the program's output, by benchmark.
YARDSTICKS = {'crowd_step_mpi_2': 'threads_rate', 'crowd_step_mpi_2_parts': 'parts_rate',
              'train_mpi_2': 'threads_rate'}
PROGRAM, MAP_VARIABLE = 'core_benchmarks', 'SOCIAL_CROWD_BENCH_MAP'
# Suffixes that Google Benchmark appends to a name.
SUFFIX = re.compile(r'(/(iterations:\d+|repeats:\d+|min_time:[\d.]+|real_time|manual_time))+$')
# Counters with the value of a run, and with the rate of its yardstick.
VALUES = {DECISIONS: 'rate', AGENT_STEPS: 'rate', REAL_TIME: 'rate', MEGABYTES: 'megabytes', MILLISECONDS: 'real_time'}
YARDSTICK = 'yardstick_rate'


def run(folder, benchmark, repetitions):
    program, size = (TRAINING, LEARNERS) if benchmark.name == 'train_mpi_2' else (RANKS_PROGRAM, AGENTS)
    runs = measure(folder / program, RANKS, size, benchmark.repetitions or repetitions)
    return result(benchmark, [each['rate'] for each in runs], [each[YARDSTICKS[benchmark.name]] for each in runs])


def result(benchmark, values, yardsticks):
    """Returns the result of repetitions in which benchmark and yardstick took turns. The ratio is the median of their
    ratios: other load of the machine slows down both parts of a repetition equally, but varies between repetitions."""
    ratios = [benchmark.ratio(*pair) for pair in zip(values, yardsticks)]
    medians = [statistics.median(numbers) if numbers else None for numbers in (values, yardsticks, ratios)]
    return benchmark.result(*medians, (min(values), max(values)))


def measure(program, ranks, size, repetitions):
    """Returns the measurements of each repetition, with this number of agents or learners.
    Ranks that wait give way to the threads of others."""
    command = ['mpirun', '--oversubscribe', '--allow-run-as-root', '--bind-to', 'none', '-n', ranks, program, size,
               repetitions]
    output = output_of(command, env={**os.environ, 'OMPI_MCA_mpi_yield_when_idle': '1'})
    return [json.loads(line) for line in output.splitlines()]


class CoreBenchmarks:
    """The program and the number of repetitions.

    @param map_file file of the map for the benchmarks on a map; None: the program draws one"""

    def __init__(self, folder, repetitions, map_file=None):
        self.program = folder / PROGRAM
        self.repetitions = repetitions
        self.environment = {**os.environ, MAP_VARIABLE: str(map_file.resolve())} if map_file else None

    def measure(self, benchmark):
        """Runs a benchmark and its yardstick alternately. Returns the result."""
        runs = list(self.runs(benchmark.name, benchmark.repetitions))
        rates = [run[YARDSTICK] for run in runs if YARDSTICK in run]  # [1/s]
        return result(benchmark, [run[VALUES[benchmark.unit]] for run in runs],
                      [1e3 / rate for rate in rates] if benchmark.unit == MILLISECONDS else rates)

    def sweep(self, name, unit):
        """Runs a sweep. Returns its points with their rates, in order. The rate of a point is that of the fastest
        repetition, because other load of the machine affects the medians of some points more than others."""
        values = {}
        for run in self.runs(name + '/[0-9]+'):
            values.setdefault(SUFFIX.sub('', run['run_name']), []).append(run[VALUES[unit]])
        return sorted((int(point.rsplit('/', 1)[1]), max(numbers)) for point, numbers in values.items())

    def runs(self, pattern, repetitions=None):
        """Yields the results of all repetitions of the benchmarks that match a pattern."""
        runs = self.run(pattern, repetitions or self.repetitions)
        if not runs:
            raise RunError(f'{self.program}: has no benchmark {pattern}')
        for run in runs:
            if run.get('error_occurred'):
                raise RunError(f"{run['name']}: {run['error_message']}")
            if run['run_type'] == 'iteration':
                yield run

    def run(self, pattern, repetitions):
        """Returns the runs in the program's output. Temporary files are on the same disk as the program."""
        with tempfile.TemporaryDirectory(prefix='bench_', dir=self.program.parent) as folder:
            output = pathlib.Path(folder, 'runs.json')
            output_of([self.program, filter_of(pattern), f'--benchmark_repetitions={repetitions}',
                       '--benchmark_enable_random_interleaving=true', '--benchmark_out_format=json',
                       f'--benchmark_out={output}'], cwd=folder, env=self.environment)
            text = output.read_text(encoding='utf-8')
        return json.loads(text)['benchmarks'] if text.strip() else []


def filter_of(pattern):
    """Returns the option that selects the benchmarks that match a pattern, with any suffix."""
    return f'--benchmark_filter=^{pattern}(/iterations:[0-9]+)?(/real_time|/manual_time)?$'
