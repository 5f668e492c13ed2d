"""The command line of scripts/bench."""
import argparse
import importlib
import importlib.util
import os
import pathlib
import signal
import subprocess
import sys

from crowd_experiments.program import EXIT_FAILED, EXIT_FINE, EXIT_INTERRUPTED, REPOSITORY, interrupt, positive
from crowd_experiments.runs import RunError

from . import document, profile, table
from .catalogue import BENCHMARKS
from .core_benchmarks import PROGRAM, CoreBenchmarks
from .sweeps import SWEEPS

ROS_MODULE = 'crowd_bench.ros_benchmarks'
ALL = {entry.name: entry for entry in (*BENCHMARKS, *SWEEPS, *profile.PROFILES)}
BUILD = REPOSITORY / '.build'


def parse_arguments(words):
    parser = argparse.ArgumentParser(
        prog='bench', formatter_class=argparse.RawDescriptionHelpFormatter,
        description='Measures what crowds cost, each benchmark beside its yardstick. Builds what it needs.',
        epilog='benchmarks, those that are run when none is named:\n' + listed(BENCHMARKS, 'what')
               + '\nsweeps:\n' + listed(SWEEPS, 'title') + '\nprofiles, with callgrind:\n'
               + listed(profile.PROFILES, 'title')
               + '\nall: all of them\n\nCtrl-C keeps what is measured. Exit status: 0 done, 1 something failed, '
                 '2 wrong usage, 130 interrupted.')
    parser.add_argument('names', nargs='*', metavar='NAME', choices=[*ALL, 'all', []], help='see below')
    parser.add_argument('--json', type=pathlib.Path, metavar='FILE',
                        help='write {name, value, unit, yardstick, ratio} of each benchmark as a list')
    parser.add_argument('--document', type=pathlib.Path, metavar='FILE.md', action='append', default=[],
                        dest='documents',
                        help="fill this document's tables with what is measured, and the pictures it shows in images/; "
                             'may be given several times')
    parser.add_argument('--plots', type=pathlib.Path, metavar='FOLDER', default=pathlib.Path('results/bench'),
                        help='where sweeps are drawn (default: %(default)s)')
    parser.add_argument('--repetitions', type=positive, default=5, metavar='N',
                        help='the median of so many counts, of sweeps the fastest (default: %(default)s)')
    parser.add_argument('--tools', type=pathlib.Path, metavar='FOLDER',
                        help=f'of {PROGRAM} (default: they are built)')
    return parser.parse_args(words)


def listed(entries, attribute):
    return ''.join(f'  {entry.name:30} {getattr(entry, attribute)}\n' for entry in entries)


def build():
    """Builds the package with its benchmarks; the folder of the programs."""
    print('Building, which takes minutes the first time only', flush=True)
    built = subprocess.run([REPOSITORY / 'scripts' / 'build', '--bench'], stdout=subprocess.PIPE,
                           stderr=subprocess.STDOUT, text=True, check=False)
    if built.returncode != 0:
        raise RunError(f'{built.stdout}\nthe package does not build')
    return pathlib.Path(os.environ.get('SOCIAL_CROWD_BUILD', BUILD)).resolve() / 'devel' / 'lib' / 'social_crowd'


class Measuring:
    """Measures one thing after the other, tells each as soon as it is there, and keeps them all."""

    def __init__(self, arguments, folder):
        self.core = CoreBenchmarks(folder, arguments.repetitions)
        self.folder = folder
        self.json = arguments.json
        self.plots = arguments.plots
        self.results, self.sweeps, self.profiles = [], [], []

    def measure(self, entry):
        """Measures a benchmark, a sweep or a profile."""
        progress(entry.name)
        if entry in SWEEPS:
            self.measure_sweep(entry)
        elif entry in profile.PROFILES:
            self.measure_profile(entry)
        else:
            self.measure_benchmark(entry)

    def measure_benchmark(self, benchmark):
        result = measure_ros(benchmark.name) if benchmark.ros else self.core.measure(benchmark)
        if result is None:
            return tell(f'{benchmark.name}: left out, there is no {ROS_MODULE}')
        self.results.append(result)
        if self.json:
            table.write_json(self.json, self.results)
        tell(table.line(result, benchmark))

    def measure_sweep(self, sweep):
        points = self.core.sweep(sweep.name, sweep.unit)
        self.sweeps.append((sweep, points, sweep.draw(points, self.plots / f'{sweep.name}.png')))
        header, rows = sweep.table(points)
        tell('\n'.join([f'{sweep.name}: {", ".join(header)}', *('  ' + '  '.join(row) for row in rows)]))

    def measure_profile(self, wanted):
        rows = profile.rows(wanted.measure(self.folder))
        self.profiles.append((wanted, rows))
        tell('\n'.join([f'{wanted.name}: % of all instructions', *(f'  {share:>5}  {name}' for name, share in rows)]))


def measure_ros(name):
    """A benchmark through ROS; None where these are not part of the package."""
    if importlib.util.find_spec(ROS_MODULE) is None:
        return None
    return importlib.import_module(ROS_MODULE).run([name])[0]


def progress(name):
    """What is being measured, as long as it is, on a terminal."""
    if sys.stderr.isatty():
        sys.stderr.write(f'{name} ...')
        sys.stderr.flush()


def tell(text):
    """Prints in place of the progress."""
    if sys.stderr.isatty():
        sys.stderr.write('\r\x1b[K')
        sys.stderr.flush()
    print(text, flush=True)


def chosen(names):
    """What is to be measured, in the order of the table."""
    if not names:
        return list(BENCHMARKS)
    return [entry for name, entry in ALL.items() if name in names or 'all' in names]


def main(words=None):
    """Returns the exit status."""
    arguments = parse_arguments(words)
    signal.signal(signal.SIGTERM, interrupt)
    try:
        measuring = Measuring(arguments, arguments.tools.resolve() if arguments.tools else build())
        status = measure_all(measuring, chosen(arguments.names))
        for file in arguments.documents:
            lacking = document.fill(file, measuring.results, measuring.sweeps, measuring.profiles,
                                    arguments.repetitions)
            print('\n'.join(lacking if 'all' in arguments.names else [f'{file}: filled']))
    except KeyboardInterrupt:
        return EXIT_INTERRUPTED
    except (RunError, OSError) as error:
        print(f'bench: {error}', file=sys.stderr)
        return EXIT_FAILED
    return status


def measure_all(measuring, entries):
    """Measures until it is interrupted; what fails is told and left out. The exit status."""
    status = EXIT_FINE
    try:
        print(table.heading(), flush=True)
        for entry in entries:
            try:
                measuring.measure(entry)
            except (RunError, RuntimeError, OSError) as error:  # RuntimeError: of benchmarks through ROS
                tell(f'{entry.name}: failed: {error}')
                status = EXIT_FAILED
    except KeyboardInterrupt:
        tell('Interrupted; what is measured stays.')
        return EXIT_INTERRUPTED
    return status
