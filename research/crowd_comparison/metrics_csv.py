"""Metrics of scenarios from the CSV files of evaluate, the benchmark's scorer, and its references."""
import csv

import numpy

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
