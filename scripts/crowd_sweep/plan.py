"""The program `sweep`: plans runs, checks their configurations before they begin, and writes a report."""
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import typing

from crowd_drawing.errors import InputError
from crowd_experiments.arguments import add_file, add_tools, parser_of, positive
from crowd_experiments.runs import Run, execute_left
from crowd_experiments.tools import find_config, find_tools
from crowd_experiments.variations import Setting, vary_config, vary_scenario
from crowd_report.program import write_report
from crowd_report.tables import METRICS, RECORD, Source, TRAJECTORIES
from crowd_sweep.sweep_file import read_sweep

TABLE, LEARNING, METRICS_FILE, RECORD_FILE = 'table.txt', 'learning.csv', 'metrics.csv', 'record.csv'
ONE_THREAD = ['--threads', 1]  # runs are parallel
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
from there.'''


def check_configurations(sweep, setting, members):
    """Trains one episode with each combination that has runs to do. Raises InputError if one is refused."""
    if sweep.config is None:
        return
    first = {member.label: member for member in reversed(members) if not member.run.is_done()}
    with tempfile.TemporaryDirectory(prefix='social_crowd_') as folder:
        for i, (label, member) in enumerate(sorted(first.items(), key=lambda item: members.index(item[1])), 1):
            print(f'sweep: checking configuration {i} of {len(first)}', file=sys.stderr, flush=True)
            config = member.run.commands[0][1]
            command = [setting.tools / 'train', config, '--episodes', 1, '--threads', 1, '--output',
                       pathlib.Path(folder, 'table.txt')]
            done = subprocess.run(list(map(str, command)), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                  stderr=subprocess.PIPE, check=False)
            if done.returncode != 0:
                message = done.stderr.decode(errors='replace').strip().splitlines()[-1:] or ['no message']
                cause = message[0].replace('train: ', '', 1).replace(f'{config}: ', '', 1)
                raise InputError(f'{sweep.file}: {label}: the configuration is refused: {cause}')


class Member(typing.NamedTuple):
    """A run of a combination with a seed."""
    label: str  # of the combination
    seed: int
    run: Run


def label_of(changes):
    """Returns a short name for changes, such as `gamma=0.9 alpha=0.1`; `all` without changes."""
    return ' '.join(f"{path.split('.')[-1]}={value_text(value)}" for path, value in changes.items()) or 'all'


def value_text(value):
    """Returns a value as a short text, such as 0.3..0.02/500 for a schedule over 500 episodes."""
    if isinstance(value, dict) and {'from', 'to', 'episodes'} <= set(value):
        more = [str(part) for key, part in value.items() if key not in ('from', 'to', 'episodes')]
        return ','.join([f"{value['from']}..{value['to']}/{value['episodes']}", *more])
    if isinstance(value, dict):
        return ','.join(f'{key}:{value_text(part)}' for key, part in value.items())
    return ','.join(map(value_text, value)) if isinstance(value, list) else str(value)


def plan(sweep, setting):
    """Returns the Members of a Sweep. Varied configurations and scenarios are written to the results folder."""
    members = []
    for index, (config_changes, scenario_changes) in enumerate(sweep.combinations()):
        label = ' '.join(label_of(changes) for changes in (config_changes, scenario_changes) if changes) or label_of({})
        if any(member.label == label for member in members):
            raise InputError(f"{sweep.file}: two combinations have the label '{label}'; expected values that differ")
        name = f"{index:03d}_{re.sub(r'[^A-Za-z0-9=.,_-]+', '_', label)[:60]}"
        scenarios = [vary_scenario(setting, file, scenario_changes, f'{name}/{file.stem}') if scenario_changes else file
                     for file in sweep.scenarios]
        config = vary_config(setting, sweep.config, config_changes, name) if sweep.config else None
        members += [Member(label, seed, run_of(sweep, setting, name, config, scenarios, seed)) for seed in sweep.seeds]
    return members


def run_of(sweep, setting, name, config, scenarios, seed):
    commands, table = [], sweep.q_table
    if config:
        table = TABLE
        episodes = ['--episodes', sweep.train_episodes] if sweep.train_episodes else []
        commands.append([setting.tools / 'train', config, '--seed', seed, '--output', TABLE, '--record', LEARNING,
                         *episodes, *ONE_THREAD])
    evaluate = [setting.tools / 'evaluate', '--q-table', table, '--seed',
                seed if sweep.evaluate_seed is None else sweep.evaluate_seed, *ONE_THREAD]
    commands.append([*evaluate, '--episodes', sweep.episodes, '--csv', METRICS_FILE, '--record', RECORD_FILE,
                     *scenarios])
    if sweep.trajectories and seed == sweep.seeds[0]:
        commands.append([*evaluate, '--episodes', 1, '--trajectories', TRAJECTORIES, '--scenes', TRAJECTORIES,
                         *scenarios])
    return Run(pathlib.Path(setting.run_folder(name, f'seed_{seed}')), commands)


def sources_of(members):
    """Returns the files of a report, and the records of the training."""
    sources, training = [], []
    for member in members:
        folder = member.run.folder
        files = [(METRICS, folder / METRICS_FILE), (RECORD, folder / RECORD_FILE),
                 *((TRAJECTORIES, file) for file in sorted((folder / TRAJECTORIES).glob('*.csv')))]
        sources += [Source(member.label, *kind_and_file) for kind_and_file in files]
        if (folder / LEARNING).is_file():
            training.append(Source(member.label, RECORD, folder / LEARNING))
    return sources, training


def main(words=None):
    parser = parser_of('sweep',
                       'Trains and evaluates over a grid of parameters and seeds, and writes a report.', EXAMPLES)
    add_file(parser, 'file', metavar='FILE.yaml', help='the sweep, see below')
    parser.add_argument('--jobs', type=positive, default=os.cpu_count() or 1, metavar='N', dest='processes',
                        help='number of parallel runs (default: one per processor)')
    add_file(parser, '--results', metavar='FOLDER', help='folder of all results (default: results/NAME of FILE)')
    parser.add_argument('--force', action='store_true', help='repeat all runs')
    parser.add_argument('--dry-run', action='store_true', help='write the configurations, check each by an episode of '
                        'training, and print the commands of all runs')
    add_tools(parser)
    arguments = parser.parse_args(words)
    sweep = read_sweep(arguments.file)
    results = (arguments.results or pathlib.Path('results') / arguments.file.stem).absolute()
    setting = Setting(find_tools(arguments.tools), find_config(), results)
    members = plan(sweep, setting)
    check_configurations(sweep, setting, members)
    if arguments.dry_run:
        for member in members:
            folder = shlex.quote(str(member.run.folder))
            print(f'# {member.label}, seed {member.seed}', f'mkdir -p {folder} && cd {folder}', *member.run.lines(),
                  sep='\n')
        return
    execute_left([member.run for member in members], arguments.processes, arguments.force)
    report = results / 'report.html'
    write_report(report, f'Sweep {arguments.file.stem}', *sources_of(members))
    print(f'Report: {report}')
