"""The compared models, and their metrics by scenario, from CSV files of evaluate, the benchmark's scorer and its
references."""
import numpy
import pandas
from crowd_experiments.records import Spread, percent, read_csv
from crowd_experiments.runs import Run
from crowd_studies.program import read_texts

TEXTS = read_texts(__file__)
OURS = 'anticipation'
LEARNED = ('thesis_nearest', 'thesis_occupancy', OURS)
REFERENCES = ('orca_best', 'orca_fixed', 'social_force')
ORCA = 'orca_best'  # reference for times
NAMES = {'thesis_nearest': 'thesis set 1', 'thesis_occupancy': 'thesis set 2', 'anticipation': 'anticipation',
         'orca_best': 'ORCA, best', 'orca_fixed': 'ORCA, fixed', 'social_force': 'social force'}
COLOURS = {'thesis_nearest': '#009e73', 'thesis_occupancy': '#8e5ea2', 'anticipation': '#d55e00',
           'orca_best': '#0072b2', 'orca_fixed': '#56b4e9', 'social_force': '0.45'}
EXCLUDED = 'door12'  # requires path planning around walls, which none of the models does


def walked(setting, experiment, table, scenario, episodes, cost, draws=True):
    """Returns a run that walks the same placements of a scenario in each model, given its shipped table."""
    drawing = ['--scenes', '.', '--trajectories', '.'] if draws else []
    name = table if experiment != 'crowds' else scenario
    return Run(setting.run_folder(experiment, name), [[
        setting.tools / 'evaluate', '--q-table', setting.table(table), '--threads', 1, '--seed', 1, '--episodes',
        episodes, '--record', 'record.csv', *drawing, setting.scenario(scenario)]], cost)


def success_and_contact(folder):
    """Returns success and contact in a record as texts [%]."""
    record = read_csv(folder / 'record.csv')
    return [f'{percent(record[column]):.1f}' for column in ('arrived', 'touched')]


def benchmark_run(setting, folder, config, seed, episodes, cost):
    """Returns a run that trains, with --quick this number of episodes, and evaluates the benchmark's scenarios."""
    return Run(folder, [
        [setting.tools / 'train', config, '--output', 'q_table.txt', '--seed', seed]
        + (['--episodes', episodes] if setting.quick else []),
        [setting.tools / 'evaluate', '--q-table', 'q_table.txt', '--threads', 1, '--csv', 'metrics.csv',
         *scenarios_of(setting)]], cost)


def scenarios_of(setting):
    return sorted((setting.benchmark / 'scenarios').glob('*.yaml'))


def read_metrics(file, model=None):
    """Returns a table of numbers with a row for each scenario; of a file with several models, those of one model."""
    rows = pandas.read_csv(file, index_col='scenario', float_precision='round_trip')
    return (rows if model is None else rows[rows['model'] == model]).select_dtypes('number').astype(float)


def judged(metrics):
    """Returns the scenarios over which means are computed."""
    return metrics.drop(index=EXCLUDED, errors='ignore')


def time_against(metrics, orca):
    """Returns the geometric mean over the scenarios of time / ORCA's time."""
    ratios = judged(metrics.time_ratio / orca.time_ratio)
    return float(numpy.exp(numpy.log(ratios).mean(skipna=False)))


def not_slower(metrics, orca):
    """Returns the number of scenarios in which the time is not above ORCA's."""
    return int((judged(metrics.time_ratio - orca.time_ratio) <= 0).sum())


def largest_difference(one, other):
    """Returns the greatest difference between the same metrics of the same scenarios."""
    return float((one.loc[other.index, other.columns] - other).abs().to_numpy().max())


def spread_text(values, decimals):
    """Returns mean (lowest-highest), or only the mean if there is no spread."""
    spread = Spread(values)
    mean, low, high = (f'{value:.{decimals}f}' for value in (spread.mean, spread.low, spread.high))
    return mean if low == high else f'{mean} ({low}-{high})'


def spread_row(name, columns, seeds):
    """Returns a row with the spreads of measures over the metrics of seeds; columns: measure, decimals by title."""
    return [name, *(spread_text(map(measure, seeds), decimals) for measure, decimals in columns.values())]
