"""Figures 4.1-4.12: comparison of both rewards, with one obstacle."""
import numpy
from crowd_experiments.records import Spread, spread_text
from crowd_experiments.variations import heading_of, read_documents

from ..declared import BETTER, PARAMETERS, REWARDS, SETS, THESIS
from ..results import PARAMETER_NAMES, RATES, RATE_HEADER, REWARD_NAMES, Runs, report_of
from ..reward_figures import add_figures
from ..reward_measures import (MODES, THESIS_SUCCESS, collision, contact, gain_per_step, learned, of_mode,
                               path_per_gain, path_ratio, success, turning)

ALL = PARAMETERS[SETS[0]]
READ = [parameters for parameters in ALL if parameters != BETTER]
# Requirements for the better parameters in demo [%].
LEAST_MEAN_SUCCESS, LEAST_SUCCESS, MOST_CONTACT = 99.0, 97.0, 1.0
RATIOS = {'distance gained per step [m]': (gain_per_step, 4), 'path per distance gained': (path_per_gain, 2)}
OF_ARRIVALS = {'path ratio, arrivals only': (path_ratio, 2), 'turning [rad/m], arrivals only': (turning, 2)}


def report(setting):
    chapter = report_of('reward_evaluation', setting, 20)
    chapter.say('parameters')
    chapter.say('difference', **differences(setting))
    add_figures(chapter, setting)
    chapter.tabulate('summary', ['', *(f'{mode}, {REWARD_NAMES[reward]}' for mode in MODES for reward in REWARDS)], [
        ['the thesis', *(reported(THESIS, reward, mode) for mode in MODES for reward in REWARDS)],
        *([PARAMETER_NAMES[parameters], *(
            Spread(of_mode(learned(setting, reward, parameters), mode, success)).text(1, False)
            for mode in MODES for reward in REWARDS)] for parameters in ALL)])
    thesis = ['', 'thesis: success %', *RATE_HEADER]
    chapter.tabulate('rewards', [*thesis, *RATIOS], [
        [row_name(parameters, mode, reward), reported(parameters, reward, mode),
         *cells(learned(setting, reward, parameters), mode, RATIOS)]
        for parameters in ALL for mode in MODES for reward in REWARDS])
    chapter.tabulate('free', ['', *RATE_HEADER, *RATIOS, *OF_ARRIVALS], [
        [row_name(parameters, reward), *cells(learned(setting, reward, parameters), 'free', {**RATIOS, **OF_ARRIVALS})]
        for parameters in ALL for reward in REWARDS])
    chapter.tabulate('more_training', ['', *RATE_HEADER], [
        [row_name(parameters, f'{episodes} training episodes', mode, reward),
         *cells(Runs.of(setting, group, reward=reward, parameters=parameters), mode)]
        for parameters in READ for episodes, group in ((setting.count('2,000', 40), 'learned'),
                                                       (setting.count('8,000', 80), 'longer'))
        for mode in MODES for reward in REWARDS])
    chapter.say('requirements', words='; '.join(requirement(setting, reward) for reward in REWARDS),
                mean=LEAST_MEAN_SUCCESS, least=LEAST_SUCCESS, contact=MOST_CONTACT)
    return chapter


def differences(setting):
    """Returns how much the episodes without an obstacle differ, for the first seed: distances of the goals [m], and
    their directions relative to the heading [degrees]."""
    scenes = read_documents(learned(setting, 'cosine_cubed').folder(1) / 'single_free.yaml')
    agents = [scene['agents'][0] for scene in scenes]
    x, y = numpy.transpose([numpy.subtract(agent['goals'][0], agent['position']) for agent in agents])
    turns = (numpy.degrees(numpy.arctan2(y, x)) - list(map(heading_of, agents)) + 180.0) % 360.0 - 180.0
    distances = numpy.hypot(x, y)
    different = len(set(zip(distances.round(3), turns.round(1))))
    return {'different': different, 'scenes': len(scenes), 'nearest': min(distances), 'farthest': max(distances),
            'least': min(turns), 'most': max(turns)}


def cells(runs, mode, measures=()):
    """Returns the texts of the rates, and of measures with their decimals."""
    rates = runs.rates(f'{mode}.csv')
    return [*(spread_text(rates[rate]) for rate in RATES),
            *(spread_text(of_mode(runs, mode, measure), decimals) for measure, decimals in dict(measures).values())]


def reported(parameters, reward, mode):
    """Returns the thesis's rate of success for the thesis's parameters; otherwise an empty text."""
    return '' if parameters == BETTER else f'{THESIS_SUCCESS[reward, mode]:.2f}'


def row_name(parameters, *words):
    return ', '.join([PARAMETER_NAMES[parameters], *words[:-1], REWARD_NAMES[words[-1]]])


def requirement(setting, reward):
    """Returns a text on whether the better parameters meet the requirements with a reward."""
    arrived, touched, collided = (Spread(of_mode(learned(setting, reward, BETTER), 'demo', measure))
                                  for measure in (success, contact, collision))
    passed = arrived.mean >= LEAST_MEAN_SUCCESS and arrived.low >= LEAST_SUCCESS and touched.mean <= MOST_CONTACT
    return (f'{REWARD_NAMES[reward]}: mean {arrived.mean:.2f} %, worst seed {arrived.low:.2f} %, contact '
            f'{touched.mean:.2f} %, collision {collided.mean:.2f} %, {"met" if passed else "NOT met"}')
