"""Names, colours and texts that the figures and tables of the thesis's experiments share."""
from crowd_experiments.records import Spread
from crowd_studies.report import Report, read_texts

from .results import RATES

TEXTS = read_texts(__file__)
REWARD_COLOURS = {'distance_gained': '#0072b2', 'cosine_cubed': '#d55e00'}
REWARD_NAMES = {'distance_gained': 'distance gained', 'cosine_cubed': 'cos³'}
PARAMETER_NAMES = {'thesis': "thesis's parameters", 'better': 'better parameters'}
RATE_HEADER = [f'{rate} %' for rate in RATES]


def report_of(name, setting, seeds, **values):
    """Returns the empty chapter of an experiment with this number of seeds, and its first text."""
    report = Report(name, TEXTS, setting, seeds=len(setting.seeds(seeds)), spread=TEXTS['spread'], **values)
    report.say('intro')
    return report


def rate_texts(rates):
    """Returns the texts of success, collision and contact, given a table with a row for each seed."""
    return [Spread(rates[rate]).text(1) for rate in RATES]


def rates_sentence(rates):
    """Returns their texts as part of a sentence."""
    return 'success {} %, collision {} %, contact {} %'.format(*rate_texts(rates))


def means_sentence(rates, contact=0):
    """Returns the means as part of a sentence; `contact`: decimals of its contact."""
    means = rates.mean()
    return f'success {means.success:.0f} %, collision {means.collision:.0f} %, contact {means.contact:.{contact}f} %'
