"""Runs the benchmarks of the core, a program of Google Benchmark."""
import json
import re
import statistics
import subprocess
import tempfile

from crowd_experiments.runs import RunError

from .catalogue import AGENT_STEPS, DECISIONS, MEGABYTES, MILLISECONDS

PROGRAM = 'core_benchmarks'
# What Google Benchmark appends to a name.
SUFFIX = re.compile(r'(/(iterations:\d+|repeats:\d+|min_time:[\d.]+|real_time|manual_time))+$')
# What a run tells its value by, and its yardstick's: how often in a second.
VALUES = {DECISIONS: 'rate', AGENT_STEPS: 'rate', MEGABYTES: 'resident_megabytes', MILLISECONDS: 'real_time'}
YARDSTICK = 'yardstick_rate'


class CoreBenchmarks:
    """The program, and how often it is to repeat everything."""

    def __init__(self, folder, repetitions):
        self.program = folder / PROGRAM
        self.repetitions = repetitions

    def measure(self, benchmark):
        """Runs a benchmark and its yardstick, taking turns; its result. The ratio is the median of the repetitions'
        own: what else the machine does slows down both of a repetition alike, but one repetition more than another."""
        runs = list(self.runs(benchmark.name, benchmark.repetitions))
        values = [run[VALUES[benchmark.unit]] for run in runs]
        yardsticks = [in_unit(run[YARDSTICK], benchmark.unit) for run in runs if YARDSTICK in run]
        ratios = [benchmark.ratio(*pair) for pair in zip(values, yardsticks)]
        return benchmark.result(*map(median, (values, yardsticks, ratios)), (min(values), max(values)))

    def sweep(self, name, unit):
        """Runs a sweep; its points with their rates, in order. Of each point the fastest repetition: what else a
        machine does slows some points down more than others, and medians would compare that."""
        values = {}
        for run in self.runs(name + '/[0-9]+'):
            values.setdefault(SUFFIX.sub('', run['run_name']), []).append(run[VALUES[unit]])
        return sorted((int(point.rsplit('/', 1)[1]), max(numbers)) for point, numbers in values.items())

    def runs(self, pattern, repetitions=None):
        """What is told of every repetition of the benchmarks that the pattern names."""
        runs = self.run(pattern, repetitions or self.repetitions)
        if not runs:
            raise RunError(f'{self.program}: has no benchmark {pattern}')
        for run in runs:
            if run.get('error_occurred'):
                raise RunError(f"{run['name']}: {run['error_message']}")
            if run['run_type'] == 'iteration':
                yield run

    def run(self, pattern, repetitions):
        """What the program tells of its runs. The files that it makes lie in a folder on the disk of the program."""
        with tempfile.TemporaryDirectory(prefix='bench_', dir=self.program.parent) as folder:
            output = f'{folder}/runs.json'
            done = subprocess.run(
                [self.program, filter_of(pattern), f'--benchmark_repetitions={repetitions}',
                 '--benchmark_enable_random_interleaving=true', '--benchmark_out_format=json',
                 f'--benchmark_out={output}'],
                cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
            if done.returncode != 0:
                raise RunError(f'{self.program} failed:\n{done.stdout}')
            with open(output, encoding='utf-8') as stream:
                text = stream.read()
        return json.loads(text)['benchmarks'] if text.strip() else []


def filter_of(pattern):
    """The option that chooses the benchmarks that a pattern names, however they are measured."""
    return f'--benchmark_filter=^{pattern}(/iterations:[0-9]+)?(/real_time|/manual_time)?$'


def in_unit(rate, unit):
    """How often in a second as a rate, or as a time."""
    return 1e3 / rate if unit == MILLISECONDS else rate


def median(values):
    """None where there are none."""
    return statistics.median(values) if values else None
