"""Sensitivity of the twins tests, the dummies and crowds to the choices that the thesis leaves open."""
import functools

from crowd_experiments import style

from ..declared import CROWD_CHOICES, LISTS, SETS, choices_of
from ..results import RATES, Runs, report_of
from .sensitivity import LEAST_ERRORS, LEAST_POINTS, effects_text, strongest

NAME = 'crowd_sensitivity'
# Files by scenarios.
FILES = {**dict.fromkeys(LISTS['twins'], 'twins.csv'), **dict.fromkeys(LISTS['crowded'], 'demo.csv')}
CELLS = [(scenario, rate) for scenario in FILES for rate in RATES]


def report(setting):
    chapter = report_of(NAME, setting, 8)
    for states in SETS:
        name, tried = style.SET_NAMES[states], tried_with(setting, states)
        chapter.tabulate(f'choices_{states}', ['', *FILES], [
            [CROWD_CHOICES[variation]['label'], *(means_of(setting, states, variation, scenario) for scenario in FILES)]
            for variation in tried], 'choices', states=name)
        found = {choice: [strongest(CROWD_CHOICES, tried, choice, functools.partial(values_of, setting, states, cell))
                          for cell in CELLS] for choice in choices_among(tried)}
        chapter.tabulate(f'strongest_{states}', ['', *FILES], [
            [choice, *(effects_in(effects, scenario) for scenario in FILES)] for choice, effects in found.items()],
            'strongest', states=name, points=LEAST_POINTS, errors=LEAST_ERRORS)
        chapter.phrases[states] = effects_text(found)
        chapter.add_text(f'{name}. {effects_text(found)}')
    return chapter


def tried_with(setting, states):
    """Returns the names of the variations that are tried with a state set."""
    return [name for name in choices_of(setting, CROWD_CHOICES)
            if CROWD_CHOICES[name].get('sets') in (None, states)]


def choices_among(variations):
    """Returns the names of the choices of which a value is tried."""
    names = (CROWD_CHOICES[variation].get('choice') for variation in variations)
    return list(dict.fromkeys(name for name in names if name))


def values_of(setting, states, cell, variation):
    scenario, rate = cell
    return rates_of(setting, states, variation, scenario)[rate]


def effects_in(effects, scenario):
    """Returns the effects on the three rates in a scenario; effects: in the order of CELLS."""
    texts = [f'{rate} {effect[1]:+.0f} ({effect[0]})' for (of, rate), effect in zip(CELLS, effects)
             if of == scenario and effect]
    return '; '.join(texts) or '-'


def rates_of(setting, states, variation, scenario):
    return Runs.of(setting, NAME, states=states, variation=variation).rates(FILES[scenario], scenario)


def means_of(setting, states, variation, scenario):
    means = rates_of(setting, states, variation, scenario).mean()
    return ' / '.join(f'{means[rate]:.0f}' for rate in RATES)
