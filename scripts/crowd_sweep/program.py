"""The program `sweep`."""
import os
import pathlib
import shlex

from crowd_experiments.arguments import add_file, add_tools, parser_of, positive
from crowd_experiments.runs import execute_left
from crowd_experiments.tools import find_config, find_tools
from crowd_experiments.variations import Setting
from crowd_report.program import write_report
from crowd_report.tables import METRICS, RECORD, Source, TRAJECTORIES
from crowd_sweep import plan as planning
from crowd_sweep.plan import check_configurations
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
    result = parser_of('sweep',
                       'Trains and evaluates over a grid of parameters and seeds, and writes a report.', EXAMPLES)
    add_file(result, 'file', metavar='FILE.yaml', help='the sweep, see below')
    result.add_argument('--jobs', type=positive, default=os.cpu_count() or 1, metavar='N', dest='processes',
                        help='number of parallel runs (default: one per processor)')
    add_file(result, '--results', metavar='FOLDER', help='folder of all results (default: results/NAME of FILE)')
    result.add_argument('--force', action='store_true', help='repeat all runs')
    result.add_argument('--dry-run', action='store_true', help='write the configurations, check each by an episode of '
                        'training, and print the commands of all runs')
    add_tools(result)
    return result


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


def main(words=None):
    """Runs the program with command line words."""
    arguments = parser().parse_args(words)
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
        return
    execute_left([member.run for member in members], arguments.processes, arguments.force)
    write_report(results / REPORT, f'Sweep {arguments.file.stem}', *sources_of(members))
    print(f'Report: {results / REPORT}')
