"""Figures of scenarios, as evaluate, the benchmark's scorer and its references give them."""
import csv

import numpy

WITHOUT_WAY = 'door12'  # needs a way to be found around walls, which none of the models does


def read_figures(file, model=None):
    """Numbers by scenario and figure; of a file with several models, those of one."""
    figures = {}
    with open(file, newline='', encoding='utf-8') as stream:
        for row in csv.DictReader(stream):
            if model is None or row['model'] == model:
                figures[row['scenario']] = {key: float(value) for key, value in row.items()
                                            if key not in ('scenario', 'model', 'parameters')}
    return figures


def judged(figures):
    """The scenarios over which means are taken."""
    return [scenario for scenario in figures if scenario != WITHOUT_WAY]


def time_against(figures, orca):
    """Geometric mean over the scenarios of time / ORCA's time."""
    scenarios = judged(figures)
    ratios = [figures[scenario]['time_ratio'] / orca[scenario]['time_ratio'] for scenario in scenarios]
    return float(numpy.exp(numpy.mean(numpy.log(ratios))))


def not_slower(figures, orca):
    """In how many scenarios the time is not above ORCA's."""
    return sum(figures[scenario]['time_ratio'] <= orca[scenario]['time_ratio'] for scenario in judged(figures))


def greatest(figures, key, scenarios=None):
    """The greatest value of a figure over scenarios, all by default."""
    return max(figures[scenario][key] for scenario in scenarios or figures)


def least(figures, key, scenarios=None):
    """The least value of a figure over scenarios, all by default."""
    return min(figures[scenario][key] for scenario in scenarios or figures)


def largest_difference(one, other):
    """The greatest difference between the same figures of the same scenarios."""
    return max(abs(one[scenario][key] - value) for scenario, row in other.items() for key, value in row.items())
