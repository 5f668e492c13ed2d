"""Sensitivity of the rates of section 4.1 to the choices that the thesis leaves open, varied one at a time."""
import functools

import numpy

from crowd_experiments import style
from crowd_experiments.pages import Chapter
from crowd_experiments.records import Spread, rates, read_csv
from crowd_experiments.runs import Run

from .. import names
from ..open_choices import CHOICES, THESIS, VARIATIONS
from ..reward_runs import DEMO_SEED, MODES, REWARDS, THESIS_SUCCESS

NAME = 'sensitivity'
TITLE = 'What the thesis leaves open, varied one at a time'
SEEDS = 10
EPISODES = 2000
DEMO_EPISODES = 500
MEASURES = {'success': 0, 'collision': 1, 'contact': 2}  # indices in the results of rates_of()
TABLED = ('success', 'collision')
CELLS = [(measure, mode, reward) for measure in TABLED for mode in MODES for reward in REWARDS]
# A change of the mean over the seeds counts from this number of points and of standard errors of the paired difference.
LEAST_POINTS, LEAST_ERRORS = 1.0, 3.0


def variations_of(setting):
    """Returns the variations that are tried."""
    return VARIATIONS[:3] if setting.quick else VARIATIONS


def plan(setting):
    """Returns a run for each variation, reward and seed."""
    return [make_run(setting, variation, reward, seed) for seed in setting.seeds(SEEDS)
            for variation in variations_of(setting) for reward in REWARDS]


def folder_of(setting, variation, reward, seed):
    return setting.run_folder(NAME, f'{reward}_{variation.name()}_{seed:02d}')


def make_run(setting, variation, reward, seed):
    return Run(folder_of(setting, variation, reward, seed), [
        [setting.tool('train'), variation.config(setting, reward), '--output', 'q_table.txt', '--seed', seed,
         '--episodes', setting.count(EPISODES, 40), '--record', 'training.csv'],
        [setting.tool('evaluate'), '--q-table', 'q_table.txt', '--threads', 1, '--seed', DEMO_SEED + seed, '--episodes',
         setting.count(DEMO_EPISODES, 10), '--record', 'demo.csv', variation.scenario(setting)],
    ], cost=0.4)


@functools.lru_cache(maxsize=None)
def rates_of(setting, variation, reward, mode):
    """Returns an array (seeds, 3) of success, collision and contact [%]."""
    found = [rates(read_csv(folder_of(setting, variation, reward, seed) / f'{mode}.csv'))
             for seed in setting.seeds(SEEDS)]
    return numpy.array([(success, collision, contact) for success, contact, collision in found])


def values_of(setting, variation, cell):
    """Returns the rates of the seeds [%] in a cell of the table."""
    measure, mode, reward = cell
    return rates_of(setting, variation, reward, mode)[:, MEASURES[measure]]


def report(setting):
    """Returns the chapter, from the runs' records."""
    chapter = Chapter(NAME, TITLE)
    chosen = '; '.join(f'{choice.name}: {choice.chosen(setting)}' for choice in CHOICES)
    chapter.add_text(
        f'The thesis does not state these choices. Thesis configuration: {chosen}. Each choice is varied on its own; '
        f"the thesis's parameters, both rewards, {len(setting.seeds(SEEDS))} seeds, "
        f'{setting.count(EPISODES, 40):,} training episodes, {setting.count(DEMO_EPISODES, 10)} demo episodes.')
    add_figure(chapter, setting)
    add_table(chapter, setting, 'The four rates of success and of collision [%]', CELLS, NAME)
    add_table(chapter, setting, 'The four rates of contact [%]',
              [('contact', mode, reward) for mode in MODES for reward in REWARDS], 'contact')
    add_effects(chapter, setting)
    return chapter


def column_name(cell):
    measure, mode, reward = cell
    return f'{measure} %, {mode}, {names.REWARD_NAMES[reward]}'


def add_table(chapter, setting, title, cells, name):
    rows = [['the thesis', *map(reported, cells)]] if any(map(reported, cells)) else []
    rows += [[variation.title(), *(cell_text(values_of(setting, variation, cell)) for cell in cells)]
             for variation in variations_of(setting)]
    chapter.add_table(f"{title}, thesis's parameters: mean over the seeds (lowest-highest)",
                      ['', *map(column_name, cells)], rows, name)


def reported(cell):
    """Returns the rate that the thesis reports; it reports rates of success only."""
    measure, mode, reward = cell
    return f'{THESIS_SUCCESS[reward, mode]:.2f}' if measure == 'success' else ''


def cell_text(values):
    spread = Spread(values)
    return f'{spread.mean:.1f} ({spread.low:.1f}-{spread.high:.1f})'


def shift(values, base):
    """Returns the change of the mean over the seeds [points]; 0 if it is not significant."""
    differences = numpy.subtract(values, base)
    mean = float(differences.mean())
    error = float(differences.std(ddof=1)) / len(differences) ** 0.5
    return mean if abs(mean) >= LEAST_POINTS and abs(mean) > LEAST_ERRORS * error else 0.0


def strongest(setting, choice, cell):
    """Returns the value with the strongest effect on a rate, and the change [points]; None if no value has one."""
    base = values_of(setting, THESIS, cell)
    shifts = {variation.value_text(): shift(values_of(setting, variation, cell), base)
              for variation in variations_of(setting) if variation.choice is choice}
    value = max(shifts, key=lambda value: abs(shifts[value]))
    return (value, shifts[value]) if shifts[value] else None


def add_effects(chapter, setting):
    """Adds the table of the strongest effects, and texts about them."""
    tried = [choice for choice in CHOICES if any(variation.choice is choice for variation in variations_of(setting))]
    found = {choice.name: [strongest(setting, choice, cell) for cell in CELLS] for choice in tried}
    rows = [[name, *('-' if effect is None else f'{effect[1]:+.1f} ({effect[0]})' for effect in effects)]
            for name, effects in found.items()]
    chapter.add_table(
        f'Strongest effect on each rate in points (the value that causes it); -: no value changes the mean '
        f'over the seeds by at least {LEAST_POINTS:g} point and by more than {LEAST_ERRORS:g} standard errors of the '
        'paired difference', ['', *map(column_name, CELLS)], rows, 'effects')
    chapter.add_text(effects_text(found))
    chapter.add_text(swing_text({reward: values_of(setting, THESIS, ('success', 'demo', reward))
                                 for reward in REWARDS}))


def effects_text(found):
    """Returns a text that lists the choices by the number of rates that they change; `found` has the strongest changes
    by the choice."""
    moved = {name: [effect for effect in effects if effect] for name, effects in found.items()}
    order = sorted(moved, key=lambda name: -len(moved[name]))
    parts = [f'{name} changes {len(moved[name])} of {len(found[name])} rates, by up to '
             f'{max(abs(points) for _, points in moved[name]):.1f} points' for name in order if moved[name]]
    still = [name for name in order if not moved[name]]
    text = f'Choices with an effect: {"; ".join(parts) if parts else "none"}.'
    return text + (f' No effect found: {"; ".join(still)}.' if still else '')


def swing_text(values):
    """Returns a text on the spread of the rates in demo; `values` has the success in demo by the reward."""
    parts = [f'{names.REWARD_NAMES[reward]} {min(rates_in_demo):.1f} to {max(rates_in_demo):.1f} %'
             for reward, rates_in_demo in values.items()]
    return (f'With the thesis configuration, success in demo already varies between seeds ({", ".join(parts)}). So '
            f'{len(next(iter(values.values())))} seeds show only large changes of the rates in demo.')


def add_figure(chapter, setting):
    """Adds a figure with a row for each variation; dot: mean, line: from the lowest to the highest seed."""
    variations = variations_of(setting)[::-1]
    panels = [(measure, mode) for measure in TABLED for mode in MODES]
    figure, axes = style.new_figure(1, len(panels), 14, 1.2 + 0.33 * len(variations), sharey=True)
    figure.suptitle("What the thesis leaves open, one choice at a time, thesis's parameters", fontsize=12)
    for panel, (measure, mode) in zip(axes[0], panels):
        for offset, reward in zip((0.15, -0.15), REWARDS):
            draw_rates(panel, setting, variations, (measure, mode, reward), offset)
        panel.set_title(f'{measure}, {mode}')
        panel.set_xlabel('[% of the episodes]')
    axes[0][0].set_yticks(range(len(variations)), [variation.title() for variation in variations])
    axes[0][0].legend(loc='upper left', bbox_to_anchor=(-1.0, -0.02), fontsize=8)
    chapter.add_figure(
        style.save(figure, setting.figure_file('sensitivity')),
        "What the thesis leaves open, varied one at a time, thesis's parameters. Dots: mean over the seeds; lines: "
        "lowest to highest seed; dashed: mean of the thesis configuration; diamonds: the thesis's rates of success.")


def draw_rates(panel, setting, variations, cell, offset):
    measure, mode, reward = cell
    colour = names.REWARD_COLOURS[reward]
    for place, variation in enumerate(variations):
        values = values_of(setting, variation, cell)
        panel.plot([values.min(), values.max()], [place + offset] * 2, color=colour, linewidth=1.2, alpha=0.6)
        panel.plot([values.mean()], [place + offset], marker='o', color=colour, markersize=5, linestyle='',
                   label=names.REWARD_NAMES[reward] if place == 0 else None)
    panel.axvline(values_of(setting, THESIS, cell).mean(), color=colour, linewidth=1, linestyle='--', zorder=1)
    if measure == 'success':
        mark = dict(names.THESIS_MARK, markersize=5, markeredgecolor=colour)
        panel.plot([THESIS_SUCCESS[reward, mode]], [len(variations) - 1 + offset], **mark)
