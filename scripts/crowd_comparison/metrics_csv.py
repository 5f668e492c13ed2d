"""Metrics of scenarios, as evaluate, the benchmark's scorer and its references give them."""
import csv

import numpy

WITHOUT_WAY = 'door12'  # needs a way to be found around walls, which none of the models does


def read_metrics(file, model=None):
    """Numbers by scenario and figure; of a file with several models, those of one."""
    metrics = {}
    with open(file, newline='', encoding='utf-8') as stream:
        for row in csv.DictReader(stream):
            if model is None or row['model'] == model:
                metrics[row['scenario']] = {key: float(value) for key, value in row.items()
                                            if key not in ('scenario', 'model', 'parameters')}
    return metrics


def judged(metrics):
    """The scenarios over which means are taken."""
    return [scenario for scenario in metrics if scenario != WITHOUT_WAY]


def time_against(metrics, orca):
    """Geometric mean over the scenarios of time / ORCA's time."""
    scenarios = judged(metrics)
    ratios = [metrics[scenario]['time_ratio'] / orca[scenario]['time_ratio'] for scenario in scenarios]
    return float(numpy.exp(numpy.mean(numpy.log(ratios))))


def not_slower(metrics, orca):
    """In how many scenarios the time is not above ORCA's."""
    return sum(metrics[scenario]['time_ratio'] <= orca[scenario]['time_ratio'] for scenario in judged(metrics))


def greatest(metrics, key, scenarios=None):
    """The greatest value of a figure over scenarios, all by default."""
    return max(metrics[scenario][key] for scenario in scenarios or metrics)


def least(metrics, key, scenarios=None):
    """The least value of a figure over scenarios, all by default."""
    return min(metrics[scenario][key] for scenario in scenarios or metrics)


def largest_difference(one, other):
    """The greatest difference between the same figures of the same scenarios."""
    return max(abs(one[scenario][key] - value) for scenario, row in other.items() for key, value in row.items())
