"""Runs the benchmarks of the core, a program of Google Benchmark."""
import json
import re
import statistics
import subprocess
import tempfile

from crowd_experiments.runs import RunError

from .catalogue import AGENT_STEPS, DECISIONS, MEGABYTES, MILLISECONDS

PROGRAM = 'core_benchmarks'
YARDSTICK = '/yardstick'
# What Google Benchmark appends to a name, and the counters that hold a benchmark's value; times have none.
SUFFIX = re.compile(r'(/(iterations:\d+|repeats:\d+|min_time:[\d.]+|real_time))+$')
COUNTERS = {DECISIONS: 'decisions_per_second', AGENT_STEPS: 'agent_steps_per_second', MEGABYTES: 'resident_megabytes',
            MILLISECONDS: 'real_time'}


class CoreBenchmarks:
    """The program, and how often it is to repeat everything."""

    def __init__(self, folder, repetitions):
        self.program = folder / PROGRAM
        self.repetitions = repetitions

    def measure(self, benchmark):
        """Runs a benchmark and its yardstick, taking turns; its result."""
        values = self.values(benchmark.name + f'({YARDSTICK})?', benchmark.unit, benchmark.repetitions)
        medians = {name: statistics.median(numbers) for name, numbers in values.items()}
        measured = values[benchmark.name]
        return benchmark.result(medians[benchmark.name], medians.get(benchmark.name + YARDSTICK),
                                (min(measured), max(measured)))

    def sweep(self, name, unit):
        """Runs a sweep; its points with their rates, in order. Of each point the fastest repetition: what else a
        machine does slows some points down more than others, and medians would compare that."""
        values = self.values(name + '/[0-9]+', unit)
        return sorted((int(point.rsplit('/', 1)[1]), max(numbers)) for point, numbers in values.items())

    def values(self, pattern, unit, repetitions=None):
        """Of all repetitions in the unit, by name, of the benchmarks that the pattern names."""
        values = {}
        for run in self.run(f'^{pattern}(/iterations:[0-9]+)?(/real_time)?$', repetitions or self.repetitions):
            if run.get('error_occurred'):
                raise RunError(f"{run['name']}: {run['error_message']}")
            if run['run_type'] == 'iteration':
                values.setdefault(SUFFIX.sub('', run['run_name']), []).append(run[COUNTERS[unit]])
        if not values:
            raise RunError(f'{self.program}: has no benchmark {pattern}')
        return values

    def run(self, pattern, repetitions):
        """What the program tells of its runs. The files that it makes lie in a folder on the disk of the program."""
        with tempfile.TemporaryDirectory(prefix='bench_', dir=self.program.parent) as folder:
            output = f'{folder}/runs.json'
            done = subprocess.run(
                [self.program, f'--benchmark_filter={pattern}', f'--benchmark_repetitions={repetitions}',
                 '--benchmark_enable_random_interleaving=true', '--benchmark_out_format=json',
                 f'--benchmark_out={output}'],
                cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
            if done.returncode != 0:
                raise RunError(f'{self.program} failed:\n{done.stdout}')
            with open(output, encoding='utf-8') as stream:
                text = stream.read()
        return json.loads(text)['benchmarks'] if text.strip() else []
