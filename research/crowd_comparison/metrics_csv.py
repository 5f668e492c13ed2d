"""The compared models, and metrics of scenarios from CSV files of evaluate, the benchmark's scorer and its "
  "references."""
import csv

import numpy

THESIS_MODELS = ('thesis_nearest', 'thesis_occupancy')
OURS = 'anticipation'
LEARNED = (*THESIS_MODELS, OURS)
REFERENCES = ('orca_best', 'orca_fixed', 'social_force')
ORCA = 'orca_best'  # reference for times

NAMES = {'thesis_nearest': 'thesis set 1', 'thesis_occupancy': 'thesis set 2', 'anticipation': 'anticipation',
         'orca_best': 'ORCA, best', 'orca_fixed': 'ORCA, fixed', 'social_force': 'social force'}
COLOURS = {'thesis_nearest': '#009e73', 'thesis_occupancy': '#8e5ea2', 'anticipation': '#d55e00',
           'orca_best': '#0072b2', 'orca_fixed': '#56b4e9', 'social_force': '0.45'}


EXCLUDED = 'door12'  # requires path planning around walls, which none of the models does


def read_metrics(file, model=None):
    """Returns numbers by scenario and metric; of a file with several models, those of one model."""
    metrics = {}
    with open(file, newline='', encoding='utf-8') as stream:
        for row in csv.DictReader(stream):
            if model is None or row['model'] == model:
                metrics[row['scenario']] = {key: float(value) for key, value in row.items()
                                            if key not in ('scenario', 'model', 'parameters')}
    return metrics


def judged(metrics):
    """Returns the scenarios over which means are computed."""
    return [scenario for scenario in metrics if scenario != EXCLUDED]


def time_against(metrics, orca):
    """Returns the geometric mean over the scenarios of time / ORCA's time."""
    scenarios = judged(metrics)
    ratios = [metrics[scenario]['time_ratio'] / orca[scenario]['time_ratio'] for scenario in scenarios]
    return float(numpy.exp(numpy.mean(numpy.log(ratios))))


def not_slower(metrics, orca):
    """Returns the number of scenarios in which the time is not above ORCA's."""
    return sum(metrics[scenario]['time_ratio'] <= orca[scenario]['time_ratio'] for scenario in judged(metrics))


def greatest(metrics, key, scenarios=None):
    """Returns the greatest value of a metric over scenarios, all by default."""
    return max(metrics[scenario][key] for scenario in scenarios or metrics)


def least(metrics, key, scenarios=None):
    """Returns the least value of a metric over scenarios, all by default."""
    return min(metrics[scenario][key] for scenario in scenarios or metrics)


def largest_difference(one, other):
    """Returns the greatest difference between the same metrics of the same scenarios."""
    return max(abs(one[scenario][key] - value) for scenario, row in other.items() for key, value in row.items())
