"""The runs of the evaluation of the rewards, and the measures of their records."""
import dataclasses
import functools

import numpy

from crowd_experiments.records import median, rates, read_csv, read_tracks, read_visits
from crowd_experiments.runs import Run
from crowd_experiments.variations import vary_config, vary_scenario

NAME = 'reward_evaluation'
REWARDS = ('distance_gained', 'cosine_cubed')
PARAMETERS = ('thesis', 'better')
MODES = ('training', 'demo')
HEADING = 'random'  # at the start of an episode, in the thesis configuration
OTHER_HEADINGS = ('goal', 'kept')
SEEDS = 20
EPISODES, LONGER_EPISODES = 2000, 8000  # of training
DEMO_EPISODES = 2000
FREE_EPISODES = 100
PATIENT_EPISODES, PATIENT_DURATION = 200, 8000  # of demo, with more decisions than the thesis's 2000
DRAWN_EPISODES = 8  # of the episodes without an obstacle, with their paths
DRAWN_SCENES = 40
DEMO_SEED = 1000  # is added to the seed of the training, so that the places differ from those of the training
GOAL_SECTORS = 8  # of state set 1; its first rows are those without an obstacle (3.2)
LEG = 20  # [decisions] length of the legs of a path, whose directions are compared
SPEED = 0.03  # [m per decision]
# Rates that the thesis reports [%].
THESIS_SUCCESS = {('distance_gained', 'training'): 92.25, ('cosine_cubed', 'training'): 99.60,
                  ('distance_gained', 'demo'): 73.80, ('cosine_cubed', 'demo'): 79.10}


@dataclasses.dataclass(frozen=True)
class Variant:
    """The reward and the settings with which a table is trained."""
    reward: str
    parameters: str = 'thesis'
    heading: str = HEADING
    is_longer: bool = False  # trained for LONGER_EPISODES

    def name(self):
        """Returns the name that is used for folders."""
        heading = '' if self.heading == HEADING else f'_heading_{self.heading}'
        return f'{self.reward}_{self.parameters}{heading}{"_longer" if self.is_longer else ""}'

    def scenario(self, setting):
        """Returns the scenario with the obstacle."""
        if self.heading == HEADING:
            return setting.scenario('single_obstacle')
        return vary_scenario(setting, 'single_obstacle', {'agents.*.heading': self.heading},
                             f'single_obstacle_heading_{self.heading}')

    def config(self, setting):
        """Returns the training configuration."""
        shipped = f'reward_{self.reward}_{self.parameters}'
        if self.heading == HEADING:
            return setting.config_file(shipped)
        return vary_config(setting, shipped, {}, self.name(), [self.scenario(setting)])

    def folder(self, setting, seed):
        """Returns the folder of the run with a seed."""
        return setting.run_folder(NAME, f'{self.name()}_{seed:02d}')


GAIN, COSINE = (Variant(reward) for reward in REWARDS)  # with the thesis's parameters
MAIN = [Variant(reward, parameters) for parameters in PARAMETERS for reward in REWARDS]
VARIANTS = [*MAIN, *(Variant(reward, heading=heading) for heading in OTHER_HEADINGS for reward in REWARDS),
            *(Variant(reward, is_longer=True) for reward in REWARDS)]


def plan(setting):
    """Returns a run for each variant and seed."""
    return [make_run(setting, variant, seed) for seed in setting.seeds(SEEDS) for variant in VARIANTS]


def make_run(setting, variant, seed):
    """Returns a run that trains, then evaluates the table."""
    episodes = setting.count(LONGER_EPISODES, 80) if variant.is_longer else setting.count(EPISODES, 40)
    walk = [setting.tool('evaluate'), '--q-table', 'q_table.txt', '--threads', '1', '--seed', DEMO_SEED + seed]
    scenario, free = variant.scenario(setting), setting.scenario('single_free')
    commands = [
        [setting.tool('train'), variant.config(setting), '--output', 'q_table.txt', '--seed', seed, '--episodes',
         episodes, '--record', 'training.csv'],
        walk + ['--episodes', setting.count(DEMO_EPISODES, 20), '--record', 'demo.csv', scenario]]
    if variant in MAIN:
        commands += [
            walk + ['--episodes', setting.count(FREE_EPISODES, 10), '--record', 'free.csv', '--scenes', '.', free],
            walk + ['--episodes', DRAWN_EPISODES, '--trajectories', '.', free],
            walk + ['--episodes', DRAWN_SCENES, '--scenes', '.', scenario]]
    if variant in (GAIN, COSINE):
        commands.append(walk + ['--episodes', setting.count(PATIENT_EPISODES, 5), '--record', 'patient.csv',
                                patient(setting)])
    return Run(variant.folder(setting, seed), commands, cost=1.5 if variant.is_longer else 0.7)


def patient(setting):
    """Returns the scenario with more decisions per episode."""
    return vary_scenario(setting, 'single_obstacle', {'duration': PATIENT_DURATION}, 'single_obstacle_patient')


@functools.lru_cache(maxsize=None)
def records(setting, variant, mode):
    """Returns the records of all seeds; mode: training, demo, free or patient."""
    return [read_csv(variant.folder(setting, seed) / f'{mode}.csv') for seed in setting.seeds(SEEDS)]


def per_seed(setting, variant, mode, measure):
    """Returns a measure of the record of each seed."""
    return [measure(record) for record in records(setting, variant, mode)]


def free_share(setting, variant):
    """Returns the share of the decisions in training that were made without a perceived obstacle [%], per seed."""
    shares = []
    for seed in setting.seeds(SEEDS):
        visits = read_visits(variant.folder(setting, seed) / 'q_table.txt')
        shares.append(100.0 * sum(visits.get(row, 0) for row in range(GOAL_SECTORS)) / sum(visits.values()))
    return shares


def bends(places):
    """Returns the sum of a path's bends from one leg to the next, and the sharpest bend [degrees]. A zigzag within a
    leg is ignored. Places are (ticks, 2), nan after the end."""
    corners = places[numpy.isfinite(places[:, 0])][::LEG]
    legs = numpy.diff(corners, axis=0)
    turns = numpy.degrees(numpy.abs(numpy.diff(numpy.unwrap(numpy.arctan2(legs[:, 1], legs[:, 0])))))
    return float(turns.sum()), float(turns.max(initial=0.0))


@functools.lru_cache(maxsize=None)
def free_bends(setting, variant):
    """Returns an array (seeds, 2): the medians of both values of bends() over the drawn episodes without an
    obstacle."""
    return numpy.array([
        numpy.median([bends(track[:, 0]) for track in read_tracks(file).values()], axis=0)
        for file in (variant.folder(setting, seed) / 'single_free.csv' for seed in setting.seeds(SEEDS))])


def success(record):
    """Returns the rate of success [%]."""
    return rates(record)[0]


def contact(record):
    """Returns the rate of contact [%]."""
    return rates(record)[1]


def collision(record):
    """Returns the rate of collision [%]."""
    return rates(record)[2]


def gain_per_step(record):
    """Returns the distance gained per step [m], median over all episodes."""
    return median(record['gain_per_tick'])


def shortfall(record):
    """Returns the difference between the agent's velocity and the distance gained per step [m], median over all
    episodes."""
    return median(numpy.abs(SPEED - record['gain_per_tick']))


def ratios(record):
    """Returns the path per distance gained of all episodes; infinite if no distance was gained."""
    return numpy.where(numpy.isnan(record['path_per_gain']), numpy.inf, record['path_per_gain'])


def path_per_gain(record):
    """Returns the path per distance gained, median over all episodes."""
    return float(numpy.median(ratios(record)))


def breadth(values, percentiles):
    """Returns the difference of two percentiles; small values mean a compact distribution."""
    low, high = numpy.percentile(values, percentiles, method='nearest')
    return float(high - low) if numpy.isfinite(high) else float('inf')


def gain_breadth(percentiles):
    """Returns a measure of the scatter of the distance gained per step [m]."""
    return lambda record: breadth(record['gain_per_tick'], percentiles)


def ratio_breadth(percentiles):
    """Returns a measure of the scatter of the path per distance gained."""
    return lambda record: breadth(ratios(record), percentiles)


def ratio_peak(record):
    """Returns the path per distance gained that one of a hundred episodes exceeds."""
    return float(numpy.percentile(ratios(record), 99, method='nearest'))


def path_ratio(record):
    """Returns the path ratio, median over arrivals only; nan without arrivals."""
    return median(record['path_ratio'][record['arrived'] > 0])


def turning(record):
    """Returns the turning [rad/m], median over arrivals only; nan without arrivals."""
    return median(record['turn_per_metre'][record['arrived'] > 0])
