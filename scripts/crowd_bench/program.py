"""The command line of scripts/bench, and of research/bench_sweeps."""
import json
import pathlib
import shutil
import sys

from crowd_drawing.errors import replaced
from crowd_experiments.arguments import add_file, parser_of, positive
from crowd_experiments.interruption import EXIT_FAILED, EXIT_FINE, EXIT_INTERRUPTED
from crowd_experiments.runs import RunError
from crowd_experiments.tools import run_build

from . import core_benchmarks, ros_benchmarks, table
from .table import BENCHMARKS, Benchmark
from .core_benchmarks import CoreBenchmarks, PROGRAM
from .callgrind import PROFILES

GROUPS = {'benchmarks (run by default)': BENCHMARKS, 'profiles, with callgrind': PROFILES}
KEYS = ('name', 'value', 'unit', 'yardstick', 'ratio')  # of a result as JSON
EXAMPLE = 'scripts/bench crowd_step_map_1000 --json bench.json'


def parse_arguments(words, groups, example):
    listed = ''.join(f'{title}:\n' + ''.join(f'  {entry.name:30} {entry.title}\n' for entry in entries) + '\n'
                     for title, entries in groups.items())
    parser = parser_of(
        example.split()[0].rpartition('/')[2], 'Measures the performance of the package; each benchmark is compared '
        'with its yardstick. Builds the package.', f'{listed}all: all of them\n\nexample:\n  {example}\n\nCtrl-C keeps '
        'the results so far.', '0 success, 1 a measurement failed, 2 wrong usage, 130 interrupted.')
    add, names = parser.add_argument, [entry.name for entries in groups.values() for entry in entries]
    add('names', nargs='*', metavar='NAME', choices=[*names, 'all', []], help='see below')
    add_file(parser, '--json', help='write {name, value, unit, yardstick, ratio} of each benchmark as a list')
    add_file(parser, '--document', metavar='FILE.md', action='append', default=[], dest='documents',
             help='update the tables of this document, and its pictures in images/; may be given several times')
    add_file(parser, '--plots', metavar='FOLDER', default=pathlib.Path('results/bench'),
             help='folder for the pictures of sweeps (default: %(default)s)')
    add('--repetitions', type=positive, default=5, metavar='N',
        help='number of repetitions; the result is their median, for sweeps the fastest (default: %(default)s)')
    add_file(parser, '--map', metavar='FILE.yaml',
             help="map for the benchmarks on a map, in map_server's format (default: an office, drawn)")
    add_file(parser, '--tools', metavar='FOLDER', help=f'folder of {PROGRAM} (default: the package is built)')
    return parser.parse_args(words)


class Measuring:
    """Measures benchmarks, and sweeps and profiles, which have tables, one after the other, and stores all results."""

    def __init__(self, arguments):
        self.folder = arguments.tools.resolve() if arguments.tools else run_build('--bench')
        self.core = CoreBenchmarks(self.folder, arguments.repetitions, arguments.map)
        self.json, self.plots = arguments.json, arguments.plots
        self.results, self.tables = [], []

    def measure(self, entry):
        """Measures an entry. Returns the printed text."""
        if not isinstance(entry, Benchmark):
            header, rows, picture = entry.measure(self)
            self.tables.append((entry, header, rows, picture))
            return '\n'.join([f'{entry.name}: {", ".join(header)}', *('  ' + '  '.join(row) for row in rows)])
        if entry.mpi and shutil.which('mpirun') is None:
            return f'{entry.name}: left out, there is no mpirun'
        self.results.append(core_benchmarks.run(self.folder, entry, self.core.repetitions) if entry.mpi else
                            ros_benchmarks.run(entry) if entry.ros else self.core.measure(entry))
        if self.json:
            with replaced(self.json) as part:
                results = [{key: result[key] for key in KEYS} for result in self.results]
                part.write_text(json.dumps(results, indent=2) + '\n')
        return table.line(self.results[-1], entry)

    def measure_all(self, entries):
        """Measures all entries until interrupted; failures are reported. Returns the exit status."""
        status = EXIT_FINE
        print(table.HEADING, flush=True)
        for entry in entries:
            show(f'{entry.name} ...')
            try:
                text = self.measure(entry)
            except KeyboardInterrupt:
                report('Interrupted; the results so far are kept.')
                return EXIT_INTERRUPTED
            except (RunError, OSError) as error:
                text, status = f'{entry.name}: failed: {error}', EXIT_FAILED
            report(text)
        return status


def show(text):
    """Shows a text on a terminal, until the next one."""
    if sys.stderr.isatty():
        sys.stderr.write(f'\r\x1b[K{text}')
        sys.stderr.flush()


def report(text):
    """Prints a text in place of what is shown."""
    show('')
    print(text, flush=True)


def main(words=None, groups=None, example=EXAMPLE):
    """Runs the program. Returns the exit status. Groups: entries by titles; the first group is the default."""
    groups = groups or GROUPS
    arguments = parse_arguments(words, groups, example)
    entries = [entry for of_group in groups.values() for entry in of_group]
    chosen = [entry for entry in entries if entry.name in arguments.names or 'all' in arguments.names]
    measuring = Measuring(arguments)
    status = measuring.measure_all(chosen or next(iter(groups.values())))
    for file in arguments.documents:
        lacking = table.fill(file, measuring.results, measuring.tables, arguments.repetitions)
        print('\n'.join(lacking if 'all' in arguments.names else [f'{file}: filled']))
    return status
