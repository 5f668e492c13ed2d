"""The program `sweep`."""
import argparse
import os
import pathlib
import shlex
import signal
import sys

from crowd_drawing.errors import InputError, problem_of
from crowd_experiments.arguments import positive
from crowd_experiments.interruption import EXIT_FAILED, EXIT_FINE, EXIT_INTERRUPTED, interrupt
from crowd_experiments.runs import carry_out
from crowd_experiments.tools import find_config, find_tools
from crowd_experiments.runs import RunError
from crowd_experiments.setting import Setting
from crowd_report.inputs import METRICS, RECORD, TRAJECTORIES, Source
from crowd_report.program import write_report
from crowd_sweep import plan as planning
from crowd_sweep.checks import check_configurations
from crowd_sweep.sweep_file import read_sweep

REPORT = 'report.html'
EXAMPLES = '''example of FILE.yaml:
  config: config/learning/anticipation.yaml   # or q_table: FILE, to evaluate without training
  parameters:                                 # of the configuration; every combination is run
    learning.gamma: [0.5, 0.92]
    learning.epsilon: [0.05, 0.2]
  seeds: 3                                    # 1 to 3, or a list
  train: {episodes: 500}
  evaluate: {scenarios: [circle6, training_field], episodes: 20, seed: 1000}

  sweep FILE.yaml --jobs 4 --results results/gamma

Completed runs are kept unless a program, configuration or scenario has changed; after Ctrl-C the same command continues
from there. Exit status: 0 success, 1 an error, 2 wrong usage, 130 interrupted.'''


def parser():
    """Returns the parser of the command line."""
    result = argparse.ArgumentParser(prog='sweep', formatter_class=argparse.RawDescriptionHelpFormatter,
                                     epilog=EXAMPLES, description='Trains and evaluates over a grid of parameters and '
                                     'seeds, and writes a report.')
    result.add_argument('file', type=pathlib.Path, metavar='FILE.yaml', help='the sweep, see below')
    result.add_argument('--jobs', type=positive, default=os.cpu_count() or 1, metavar='N', dest='processes',
                        help='number of parallel runs (default: one per processor)')
    result.add_argument('--results', type=pathlib.Path, metavar='FOLDER',
                        help='folder of all results (default: results/NAME of FILE)')
    result.add_argument('--force', action='store_true', help='repeat all runs')
    result.add_argument('--dry-run', action='store_true', help='write the configurations, check each by an episode of '
                        'training, and print the commands of all runs')
    result.add_argument('--tools', type=pathlib.Path, metavar='FOLDER', help='folder of train and evaluate (default: '
                        'that of this program; if they are not there, the package is built)')
    return result


class Experiment:
    """A sweep as carry_out() takes it."""

    def __init__(self, members):
        self.members = members

    def plan(self, _setting):
        """Returns the runs."""
        return [member.run for member in self.members]


def sources_of(members):
    """Returns the files of a report, and the records of the training."""
    sources, training = [], []
    for member in members:
        folder = member.run.folder
        sources += [Source(member.label, METRICS, folder / planning.METRICS),
                    Source(member.label, RECORD, folder / planning.RECORD)]
        walked = sorted((folder / planning.TRAJECTORIES).glob('*.csv'))
        sources += [Source(member.label, TRAJECTORIES, file) for file in walked]
        if (folder / planning.LEARNING).is_file():
            training.append(Source(member.label, RECORD, folder / planning.LEARNING))
    return sources, training


def run(arguments):
    """Carries out the sweep. Returns the exit status."""
    sweep = read_sweep(arguments.file)
    results = (arguments.results or pathlib.Path('results') / arguments.file.stem).absolute()
    setting = Setting(find_tools(arguments.tools), find_config(), results)
    members = planning.plan(sweep, setting)
    check_configurations(sweep, setting, members)
    if arguments.dry_run:
        for member in members:
            folder = shlex.quote(str(member.run.folder))
            print(f'# {member.label}, seed {member.seed}', f'mkdir -p {folder} && cd {folder}', *member.run.lines(),
                  sep='\n')
        return EXIT_FINE
    if not carry_out(setting, [Experiment(members)], arguments):
        return EXIT_INTERRUPTED
    write_report(results / REPORT, f'Sweep {arguments.file.stem}', *sources_of(members))
    print(f'Report: {results / REPORT}')
    return EXIT_FINE


def main(words=None):
    """Runs the program with command line words. Returns the exit status."""
    arguments = parser().parse_args(words)
    signal.signal(signal.SIGTERM, interrupt)
    try:
        return run(arguments)
    except KeyboardInterrupt:
        print('Interrupted; the finished runs are kept.')
        return EXIT_INTERRUPTED
    except (OSError, InputError, RunError, ValueError) as error:
        print(f'sweep: {problem_of(error, arguments.file)}', file=sys.stderr)
        return EXIT_FAILED
