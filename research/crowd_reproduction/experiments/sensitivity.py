"""Sensitivity of the rates of section 4.1 to the choices that the thesis leaves open, varied one at a time."""
import functools

import numpy
from crowd_experiments import style
from crowd_experiments.records import Spread

from ..declared import CHOICES, DECLARED, GROUPS, REWARDS, choices_of, chosen
from ..results import REWARD_COLOURS, REWARD_NAMES, Runs, report_of
from ..reward_measures import MODES, THESIS_SUCCESS

NAME = 'sensitivity'
TABLED = ('success', 'collision')
THESIS = next(iter(CHOICES))
CELLS = [(measure, mode, reward) for measure in TABLED for mode in MODES for reward in REWARDS]
# A change of the mean over the seeds counts from this number of points and of standard errors of the paired difference.
LEAST_POINTS, LEAST_ERRORS = 1.0, 3.0
THESIS_MARK = dict(marker='D', color='black', linestyle='', markersize=5, zorder=6)


def values_of(setting, variation, cell):
    measure, mode, reward = cell
    runs = Runs.of(setting, NAME, variation=variation, reward=reward)
    return runs.rates(f'{mode}.csv')[measure].to_numpy()


def report(setting):
    ours = '; '.join(f"{choice['name']}: {chosen(setting, choice)}" for choice in DECLARED['choices'])
    chapter = report_of(NAME, setting, GROUPS[NAME]['seeds'], chosen=ours)
    add_figure(chapter, setting)
    reported = [f'{THESIS_SUCCESS[reward, mode]:.2f}' if measure == 'success' else ''
                for measure, mode, reward in CELLS]
    add_table(chapter, setting, NAME, CELLS, [['the thesis', *reported]])
    chapter.tabulate('nearest', ['', 'sum of the differences [points]'], nearest(setting))
    add_table(chapter, setting, 'contact', [('contact', mode, reward) for mode in MODES for reward in REWARDS], [])
    found = {choice['name']: [strongest(CHOICES, choices_of(setting), choice['name'],
                                        functools.partial(values_of, setting, cell=cell)) for cell in CELLS]
             for choice in DECLARED['choices']
             if any(CHOICES[name].get('choice') == choice['name'] for name in choices_of(setting))}
    chapter.tabulate('effects', ['', *map(column_name, CELLS)], [
        [name, *('-' if effect is None else f'{effect[1]:+.1f} ({effect[0]})' for effect in effects)]
        for name, effects in found.items()], points=LEAST_POINTS, errors=LEAST_ERRORS)
    chapter.phrases['effects'] = effects_text(found)
    chapter.add_text(effects_text(found))
    chapter.add_text(swing_text({reward: values_of(setting, THESIS, ('success', 'demo', reward))
                                 for reward in REWARDS}))
    return chapter


def nearest(setting):
    """Returns rows with how far the four mean rates of success are from those of the thesis, the nearest first."""
    off = {CHOICES[variation]['label']: sum(
        abs(values_of(setting, variation, ('success', mode, reward)).mean() - rate)
        for (reward, mode), rate in THESIS_SUCCESS.items()) for variation in choices_of(setting)}
    return [[label, f'{off[label]:.1f}'] for label in sorted(off, key=off.get)]


def column_name(cell):
    measure, mode, reward = cell
    return f'{measure} %, {mode}, {REWARD_NAMES[reward]}'


def add_table(chapter, setting, name, cells, rows):
    rows = rows + [[CHOICES[variation]['label'], *(Spread(values_of(setting, variation, cell)).text(1, False)
                                                   for cell in cells)] for variation in choices_of(setting)]
    chapter.tabulate(name, ['', *map(column_name, cells)], rows)


def shift(values, base):
    """Returns the change of the mean over the seeds [points]; 0 if it is not significant."""
    differences = numpy.subtract(values, base)
    mean = float(differences.mean())
    error = float(differences.std(ddof=1)) / len(differences) ** 0.5
    return mean if abs(mean) >= LEAST_POINTS and abs(mean) > LEAST_ERRORS * error else 0.0


def strongest(choices, tried, choice, rate_of):
    """Returns the value of a choice with the strongest effect on a rate, and the change [points]; None if no value has
    one. `rate_of`: a function of the variation that returns the rate for each seed."""
    shifts = {choices[name]['value']: shift(rate_of(name), rate_of(THESIS))
              for name in tried if choices[name].get('choice') == choice}
    value = max(shifts, key=lambda value: abs(shifts[value]))
    return (value, shifts[value]) if shifts[value] else None


def effects_text(found):
    """Returns a text about the strongest changes, given by choice, from the choice that changes most rates."""
    moved = {name: [effect for effect in effects if effect] for name, effects in found.items()}
    order = sorted(moved, key=lambda name: -len(moved[name]))
    parts = [f'{name} ({len(moved[name])} rate{"s" * (len(moved[name]) > 1)}, by up to '
             f'{max(abs(points) for _, points in moved[name]):.1f} points)' for name in order if moved[name]]
    still = [name for name in order if not moved[name]]
    text = f'Choices with an effect: {"; ".join(parts) if parts else "none"}.'
    return text + (f' No effect found: {"; ".join(still)}.' if still else '')


def swing_text(values):
    """Returns a text on the spread of the rates in demo; `values` has the success in demo by the reward."""
    parts = [f'{REWARD_NAMES[reward]} {min(rates_in_demo):.1f} to {max(rates_in_demo):.1f} %'
             for reward, rates_in_demo in values.items()]
    return (f'With the reading that leads, success in demo already varies between seeds ({", ".join(parts)}). So '
            f'{len(next(iter(values.values())))} seeds show only large changes of the rates in demo.')


def add_figure(chapter, setting):
    """Adds a figure with a row for each variation; dot: mean, line: from the lowest to the highest seed."""
    variations = choices_of(setting)[::-1]
    panels = [(measure, mode) for measure in TABLED for mode in MODES]
    figure, axes = style.new_figure(1, len(panels), 14, 1.2 + 0.33 * len(variations), sharey=True)
    figure.suptitle("What the thesis leaves open, one choice at a time, thesis's parameters", fontsize=12)
    for panel, (measure, mode) in zip(axes[0], panels):
        for offset, reward in zip((0.15, -0.15), REWARDS):
            draw_rates(panel, setting, variations, (measure, mode, reward), offset)
        panel.set(title=f'{measure}, {mode}', xlabel='[% of the episodes]')
    axes[0][0].set_yticks(range(len(variations)), [CHOICES[variation]['label'] for variation in variations])
    axes[0][0].legend(loc='upper left', bbox_to_anchor=(-1.0, -0.02), fontsize=8)
    chapter.draw(figure, NAME, 'figure')


def draw_rates(panel, setting, variations, cell, offset):
    measure, mode, reward = cell
    colour = REWARD_COLOURS[reward]
    for place, variation in enumerate(variations):
        values = values_of(setting, variation, cell)
        panel.plot([values.min(), values.max()], [place + offset] * 2, color=colour, linewidth=1.2, alpha=0.6)
        panel.plot([values.mean()], [place + offset], marker='o', color=colour, markersize=5, linestyle='',
                   label=REWARD_NAMES[reward] if place == 0 else None)
    panel.axvline(values_of(setting, THESIS, cell).mean(), color=colour, linewidth=1, linestyle='--', zorder=1)
    if measure == 'success':
        panel.plot([THESIS_SUCCESS[reward, mode]], [len(variations) - 1 + offset],
                   **THESIS_MARK, markeredgecolor=colour)
