"""Names, colours and texts that the figures and tables of the thesis's experiments share."""
from crowd_experiments.records import Spread

REWARD_COLOURS = {'distance_gained': '#0072b2', 'cosine_cubed': '#d55e00'}
REWARD_NAMES = {'distance_gained': 'distance gained', 'cosine_cubed': 'cos³'}
PARAMETER_NAMES = {'thesis': "thesis's parameters", 'better': 'better parameters'}
THESIS_MARK = dict(marker='D', color='black', linestyle='', markersize=7, zorder=6)
RATES = ['success %', 'collision %', 'contact %']  # in the order of all texts
SPREAD = 'mean ± standard deviation over the seeds (lowest-highest)'


def rate_spreads(rates):
    """Returns Spreads of success, collision and contact, given (success, contact, collision) for each seed."""
    success, contact, collision = map(Spread, zip(*rates))
    return success, collision, contact


def rate_texts(rates):
    """Returns their texts."""
    return [spread.text(1) for spread in rate_spreads(rates)]


def rates_sentence(rates):
    """Returns their texts as part of a sentence."""
    return 'success {} %, collision {} %, contact {} %'.format(*rate_texts(rates))


def means_sentence(rates, contact=0):
    """Returns the means as part of a sentence; `contact`: decimals of its contact."""
    means = [spread.mean for spread in rate_spreads(rates)]
    return f'success {means[0]:.0f} %, collision {means[1]:.0f} %, contact {means[2]:.{contact}f} %'
