"""Sensitivity of the twins tests, the dummies and crowds to the choices that the thesis leaves open."""
from crowd_experiments import style

from ..results import CROWD_CHOICES, LISTS, RATES, Runs, SETS, choices_of, report_of
from .sensitivity import LEAST_ERRORS, LEAST_POINTS, effects_text, strongest

NAME = 'crowd_sensitivity'
FILES = {**dict.fromkeys(LISTS['twins'], 'twins.csv'), **dict.fromkeys(LISTS['crowded'], 'demo.csv')}  # by scenarios


def report(setting):
    chapter = report_of(NAME, setting, 8)
    for states in SETS:
        name = style.SET_NAMES[states]
        chapter.tabulate(f'choices_{states}', ['', *FILES], [
            [CROWD_CHOICES[variation]['label'], *(means_of(setting, states, variation, scenario) for scenario in FILES)]
            for variation in choices_of(setting, CROWD_CHOICES)], 'choices', states=name)
        found = {choice: [strongest(CROWD_CHOICES, choices_of(setting, CROWD_CHOICES), choice,
                                    lambda name, scenario=scenario: rates_of(setting, states, name, scenario).success)
                          for scenario in FILES] for choice in choices_tried(setting)}
        chapter.tabulate(f'strongest_{states}', ['', *FILES], [
            [choice, *('-' if effect is None else f'{effect[1]:+.0f} ({effect[0]})' for effect in effects)]
            for choice, effects in found.items()], 'strongest', states=name, points=LEAST_POINTS, errors=LEAST_ERRORS)
        chapter.phrases[states] = effects_text(found)
        chapter.add_text(f'{name}. {effects_text(found)}')
    return chapter


def choices_tried(setting):
    """Returns the names of the choices of which a value is tried."""
    names = (CROWD_CHOICES[variation].get('choice') for variation in choices_of(setting, CROWD_CHOICES))
    return list(dict.fromkeys(name for name in names if name))


def rates_of(setting, states, variation, scenario):
    return Runs.of(setting, NAME, states=states, variation=variation).rates(FILES[scenario], scenario)


def means_of(setting, states, variation, scenario):
    means = rates_of(setting, states, variation, scenario).mean()
    return ' / '.join(f'{means[rate]:.0f}' for rate in RATES)
