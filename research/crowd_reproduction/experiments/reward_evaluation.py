"""Figures 4.1-4.12: comparison of both rewards, with one obstacle."""
import numpy

from crowd_experiments.pages import Chapter
from crowd_experiments.records import Spread, spread_text
from crowd_experiments.variations import heading_of, read_documents

from .. import names, reward_runs
from ..reward_figures import add_figures
from ..reward_runs import (EPISODES, HEADING, LONGER_EPISODES, MODES, OTHER_HEADINGS, PARAMETERS, REWARDS, SEEDS,
                           THESIS_SUCCESS, Variant, collision, contact, gain_per_step, path_per_gain, path_ratio,
                           per_seed, success, turning)

NAME = reward_runs.NAME
TITLE = 'Evaluation of the rewards (figures 4.1-4.12)'
# Requirements for the better parameters in demo [%].
LEAST_MEAN_SUCCESS, LEAST_SUCCESS, MOST_CONTACT = 99.0, 97.0, 1.0
RATES = {'success %': success, 'collision %': collision, 'contact %': contact}
RATIOS = {'distance gained per step [m]': (gain_per_step, 4), 'path per distance gained': (path_per_gain, 2)}
OF_ARRIVALS = {'path ratio, arrivals only': (path_ratio, 2), 'turning [rad/m], arrivals only': (turning, 2)}
EACH = 'mean ± standard deviation over the seeds (lowest-highest)'
OF_ALL = 'for path and distance gained, the median over all episodes of a seed, arrived or not'
plan = reward_runs.plan


def report(setting):
    """Returns the chapter, from the runs' records."""
    chapter = Chapter(NAME, TITLE)
    seeds = len(setting.seeds(SEEDS))
    chapter.add_text(
        'One agent starts near the centre, and one obstacle (radius 0.4 m) lies between it and its goal. The direction '
        f'of the goal and the heading at the start are random. State set 1. {EPISODES:,} training episodes of at most '
        '2,000 decisions, then 2,000 demo episodes with the learned table, at other places, and 100 without the '
        f'obstacle; {seeds} seeds. Collision: the obstacle\'s rim was within 0.5 m of the agent\'s centre, as the '
        'thesis defines it; contact: the bodies overlapped.')
    chapter.add_text(
        "The thesis's parameters: learning rate 0.1, gamma 0.1, lambda 0, not tuned; the chapter sensitivity varies "
        'what the thesis leaves open. Better parameters: gamma 0.9, learning rate 0.02, epsilon decreasing from 100 % '
        'to 2 % within 1,500 episodes; their rates in training include the episodes with much exploration.')
    chapter.add_text(difference_text(setting))
    add_figures(chapter, setting)
    add_main_table(chapter, setting)
    add_free_table(chapter, setting)
    add_headings_table(chapter, setting)
    chapter.add_text(nearest_text(setting))
    add_longer_table(chapter, setting)
    chapter.add_text(verdict(setting))
    return chapter


def difference_text(setting):
    """Returns a text on the number of different episodes without an obstacle, for the first seed."""
    scenes = read_documents(Variant('cosine_cubed').folder(setting, 1) / 'single_free.yaml')
    distances, headings = zip(*(start_of(scene['agents'][0]) for scene in scenes))
    different = len({(round(distance, 3), round(heading, 1)) for distance, heading in zip(distances, headings)})
    return (f'{different} of the {len(scenes)} episodes without an obstacle differ in the perception at the start '
            f'(seed 1): the distance of the goal is {min(distances):.2f} to {max(distances):.2f} m, and its direction '
            f'is {min(headings):.0f} to {max(headings):.0f} degrees from the heading.')


def start_of(agent):
    """Returns the distance of an agent's goal [m], and its direction relative to the heading [degrees]."""
    offset = numpy.subtract(agent['goals'][0], agent['position'])
    turn = numpy.degrees(numpy.arctan2(offset[1], offset[0])) - heading_of(agent)
    return float(numpy.hypot(*offset)), float((turn + 180.0) % 360.0 - 180.0)


def rate_texts(setting, variant, mode):
    """Returns the texts of success, collision and contact."""
    return [spread_text(per_seed(setting, variant, mode, measure)) for measure in RATES.values()]


def measure_texts(setting, variant, mode, measures):
    """Returns the texts of measures with their decimals."""
    return [spread_text(per_seed(setting, variant, mode, measure), decimals) for measure, decimals in measures.values()]


def reported(variant, mode):
    """Returns the thesis's rate of success for the thesis's parameters; otherwise an empty text."""
    return f'{THESIS_SUCCESS[variant.reward, mode]:.2f}' if variant.parameters == 'thesis' else ''


def row_name(variant, *words):
    return ', '.join([names.PARAMETER_NAMES[variant.parameters], *words, names.REWARD_NAMES[variant.reward]])


def add_main_table(chapter, setting):
    rows = [[row_name(variant, mode), reported(variant, mode), *rate_texts(setting, variant, mode),
             *measure_texts(setting, variant, mode, RATIOS)]
            for parameters in PARAMETERS for mode in MODES
            for variant in (Variant(reward, parameters) for reward in REWARDS)]
    chapter.add_table(f'Both rewards: {EACH}; {OF_ALL}', ['', 'thesis: success %', *RATES, *RATIOS], rows,
                      'rewards')


def add_free_table(chapter, setting):
    rows = [[row_name(variant), *rate_texts(setting, variant, 'free'),
             *measure_texts(setting, variant, 'free', {**RATIOS, **OF_ARRIVALS})]
            for parameters in PARAMETERS for variant in (Variant(reward, parameters) for reward in REWARDS)]
    chapter.add_table(f'Without an obstacle: {EACH}; {OF_ALL}',
                      ['', *RATES, *RATIOS, *OF_ARRIVALS], rows, 'free')


def add_headings_table(chapter, setting):
    """Adds the table of the three headings at the start, which the thesis leaves open."""
    rows = [[row_name(variant, f'heading: {heading}', mode), reported(variant, mode),
             *rate_texts(setting, variant, mode)]
            for heading in (HEADING, *OTHER_HEADINGS) for mode in MODES
            for variant in (Variant(reward, heading=heading) for reward in REWARDS)]
    chapter.add_table('The heading at the start of an episode: random (the thesis configuration), towards the goal, or '
                      f'kept from the previous episode; {EACH}',
                      ['', 'thesis: success %', *RATES], rows, 'headings')


def nearest_text(setting):
    """Returns a text on the heading at the start whose rates are the nearest to the thesis's."""
    off = {heading: sum(abs(Spread(per_seed(setting, Variant(reward, heading=heading), mode, success)).mean - rate)
                        for (reward, mode), rate in THESIS_SUCCESS.items()) for heading in (HEADING, *OTHER_HEADINGS)}
    listed = ', '.join(f'{heading} {points:.1f}' for heading, points in off.items())
    return (f"Sum of the differences between the four mean rates of success and the thesis's [points]: {listed}; the "
            f'nearest is {min(off, key=off.get)}.')


def add_longer_table(chapter, setting):
    """Adds the table of the effect of more training."""
    trained = ((setting.count(EPISODES, 40), False), (setting.count(LONGER_EPISODES, 80), True))
    rows = [[row_name(variant, f'{episodes:,} training episodes', mode), *rate_texts(setting, variant, mode)]
            for episodes, is_longer in trained
            for mode in MODES for variant in (Variant(reward, is_longer=is_longer) for reward in REWARDS)]
    chapter.add_table(f'More training: {EACH}', ['', *RATES], rows, 'more_training')


def verdict(setting):
    """Returns a text on whether the better parameters meet the requirements."""
    words = []
    for reward in REWARDS:
        arrived, touched, collided = (Spread(per_seed(setting, Variant(reward, 'better'), 'demo', measure))
                                      for measure in (success, contact, collision))
        passed = arrived.mean >= LEAST_MEAN_SUCCESS and arrived.low >= LEAST_SUCCESS and touched.mean <= MOST_CONTACT
        words.append(f'{names.REWARD_NAMES[reward]}: mean {arrived.mean:.2f} %, worst seed {arrived.low:.2f} %, '
                     f'contact {touched.mean:.2f} %, collision {collided.mean:.2f} %, '
                     f'{"met" if passed else "NOT met"}')
    return (f'Requirements for the better parameters in demo (mean success at least {LEAST_MEAN_SUCCESS:g} %, success '
            f'of every seed at least {LEAST_SUCCESS:g} %, contact at most {MOST_CONTACT:g} %): {"; ".join(words)}.')
