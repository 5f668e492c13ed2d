"""The command line of scripts/bench."""
import argparse
import importlib
import importlib.util
import os
import pathlib
import signal
import subprocess
import sys

from crowd_experiments.numbers import positive
from crowd_experiments.program import EXIT_FAILED, EXIT_FINE, EXIT_INTERRUPTED, REPOSITORY, interrupt
from crowd_experiments.runs import RunError

from . import document, host_traffic, profile, rank_benchmarks, table
from .catalogue import BENCHMARKS
from .core_benchmarks import PROGRAM, CoreBenchmarks
from .rank_scaling import RANK_SWEEPS
from .sweeps import SWEEPS

ROS_MODULE = 'crowd_bench.ros_benchmarks'
ENTRIES = (*BENCHMARKS, *SWEEPS, *RANK_SWEEPS, *host_traffic.TABLES, *profile.PROFILES)
ALL = {entry.name: entry for entry in ENTRIES}
BUILD = REPOSITORY / '.build'


def parse_arguments(words):
    parser = argparse.ArgumentParser(
        prog='bench', formatter_class=argparse.RawDescriptionHelpFormatter,
        description='Measures the performance of the package; each benchmark is compared with its yardstick. Builds '
                    'the package.',
        epilog='benchmarks (run by default):\n' + listed(BENCHMARKS, 'what')
               + '\nsweeps:\n' + listed((*SWEEPS, *RANK_SWEEPS), 'title') + '\nbytes between hosts, which need root:\n'
               + listed(host_traffic.TABLES, 'title') + '\nprofiles, with callgrind:\n'
               + listed(profile.PROFILES, 'title')
               + '\nall: all of them\n\nexample:\n  scripts/bench crowd_step_map_1000 --json bench.json\n\n'
                 'Ctrl-C keeps the results so far. Exit status: 0 success, 1 a measurement '
                 'failed, 2 wrong usage, 130 interrupted.')
    parser.add_argument('names', nargs='*', metavar='NAME', choices=[*ALL, 'all', []], help='see below')
    parser.add_argument('--json', type=pathlib.Path, metavar='FILE',
                        help='write {name, value, unit, yardstick, ratio} of each benchmark as a list')
    parser.add_argument('--document', type=pathlib.Path, metavar='FILE.md', action='append', default=[],
                        dest='documents',
                        help='update the tables of this document, and its pictures in images/; may be given several '
                             'times')
    parser.add_argument('--plots', type=pathlib.Path, metavar='FOLDER', default=pathlib.Path('results/bench'),
                        help='folder for the pictures of sweeps (default: %(default)s)')
    parser.add_argument('--repetitions', type=positive, default=5, metavar='N',
                        help='number of repetitions; the result is their median, for sweeps the fastest (default: '
                             '%(default)s)')
    parser.add_argument('--map', type=pathlib.Path, metavar='FILE.yaml',
                        help="map for the benchmarks on a map, in map_server's format (default: an office, drawn)")
    parser.add_argument('--tools', type=pathlib.Path, metavar='FOLDER',
                        help=f'folder of {PROGRAM} (default: the package is built)')
    return parser.parse_args(words)


def listed(entries, attribute):
    return ''.join(f'  {entry.name:30} {getattr(entry, attribute)}\n' for entry in entries)


def build():
    """Builds the package with its benchmarks. Returns the folder of the programs."""
    print('Building (takes minutes the first time)', flush=True)
    built = subprocess.run([REPOSITORY / 'scripts' / 'build', '--bench'], stdout=subprocess.PIPE,
                           stderr=subprocess.STDOUT, text=True, check=False)
    if built.returncode != 0:
        raise RunError(f'{built.stdout}\nthe package does not build')
    return pathlib.Path(os.environ.get('SOCIAL_CROWD_BUILD', BUILD)).resolve() / 'devel' / 'lib' / 'social_crowd'


class Measuring:
    """Measures benchmarks, sweeps and profiles one after the other, prints each result, and stores them all."""

    def __init__(self, arguments, folder):
        self.core = CoreBenchmarks(folder, arguments.repetitions, arguments.map)
        self.folder = folder
        self.json = arguments.json
        self.plots = arguments.plots
        self.results, self.sweeps, self.profiles = [], [], []

    def measure(self, entry):
        """Measures a benchmark, a sweep or a profile."""
        progress(entry.name)
        if entry in (*SWEEPS, *RANK_SWEEPS):
            self.measure_sweep(entry)
        elif entry in host_traffic.TABLES:
            self.measure_traffic(entry)
        elif entry in profile.PROFILES:
            self.measure_profile(entry)
        else:
            self.measure_benchmark(entry)

    def measure_benchmark(self, benchmark):
        if benchmark.mpi:
            result = rank_benchmarks.run(self.folder, benchmark, self.core.repetitions)
        else:
            result = measure_ros(benchmark.name) if benchmark.ros else self.core.measure(benchmark)
        if result is None:
            return report(f"{benchmark.name}: left out, there is no {'mpirun' if benchmark.mpi else ROS_MODULE}")
        self.results.append(result)
        if self.json:
            table.write_json(self.json, self.results)
        report(table.line(result, benchmark))

    def measure_sweep(self, sweep):
        if sweep in RANK_SWEEPS:
            points = rank_benchmarks.weak_scaling(self.folder)
            if not points:
                return report(f'{sweep.name}: left out, there is no mpirun')
        else:
            points = self.core.sweep(sweep.name, sweep.unit)
        self.sweeps.append((sweep, points, sweep.draw(points, self.plots / f'{sweep.name}.png')))
        header, rows = sweep.table(points)
        report('\n'.join([f'{sweep.name}: {", ".join(header)}', *('  ' + '  '.join(row) for row in rows)]))

    def measure_traffic(self, wanted):
        rows = host_traffic.measure(wanted)
        self.profiles.append((wanted, rows))
        report('\n'.join([f'{wanted.name}: {", ".join(wanted.header)}', *('  ' + '  '.join(row) for row in rows)]))

    def measure_profile(self, wanted):
        rows = profile.rows(wanted.measure(self.folder))
        self.profiles.append((wanted, rows))
        report('\n'.join([f'{wanted.name}: % of all instructions', *(f'  {share:>5}  {name}' for name, share in rows)]))


def measure_ros(name):
    """Runs a benchmark through ROS. Returns None if the package does not have these benchmarks."""
    if importlib.util.find_spec(ROS_MODULE) is None:
        return None
    return importlib.import_module(ROS_MODULE).run([name])[0]


def progress(name):
    """Shows the name of the current measurement on a terminal."""
    if sys.stderr.isatty():
        sys.stderr.write(f'{name} ...')
        sys.stderr.flush()


def report(text):
    """Replaces the progress by a text."""
    if sys.stderr.isatty():
        sys.stderr.write('\r\x1b[K')
        sys.stderr.flush()
    print(text, flush=True)


def chosen(names):
    """Returns the selected entries, in the order of the table."""
    if not names:
        return list(BENCHMARKS)
    return [entry for name, entry in ALL.items() if name in names or 'all' in names]


def main(words=None):
    """Runs the program with command line words. Returns the exit status."""
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
    """Measures all entries until interrupted; failures are reported. Returns the exit status."""
    status = EXIT_FINE
    try:
        print(table.heading(), flush=True)
        for entry in entries:
            try:
                measuring.measure(entry)
            except (RunError, RuntimeError, OSError) as error:  # RuntimeError: of benchmarks through ROS
                report(f'{entry.name}: failed: {error}')
                status = EXIT_FAILED
    except KeyboardInterrupt:
        report('Interrupted; the results so far are kept.')
        return EXIT_INTERRUPTED
    return status
