"""The runs of the evaluation of the rewards, and what is measured in each of them."""
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
DRAWN_EPISODES = 8  # of those, with their paths
DRAWN_SCENES = 40
DEMO_SEED = 1000  # and the seed of the training: other places than those it was trained at
GOAL_SECTORS = 8  # of state set 1, whose first rows are those without an obstacle (3.2)
LEG = 20  # [decisions] of a path, over which its direction is taken
SPEED = 0.03  # [m per decision]
# What the thesis reports [%].
THESIS_SUCCESS = {('distance_gained', 'training'): 92.25, ('cosine_cubed', 'training'): 99.60,
                  ('distance_gained', 'demo'): 73.80, ('cosine_cubed', 'demo'): 79.10}


@dataclasses.dataclass(frozen=True)
class Variant:
    """What a table is trained with."""
    reward: str
    parameters: str = 'thesis'
    heading: str = HEADING
    is_longer: bool = False  # trained for LONGER_EPISODES

    def name(self):
        """As in the names of folders."""
        heading = '' if self.heading == HEADING else f'_heading_{self.heading}'
        return f'{self.reward}_{self.parameters}{heading}{"_longer" if self.is_longer else ""}'

    def scenario(self, setting):
        """With the obstacle."""
        if self.heading == HEADING:
            return setting.scenario('single_obstacle')
        return vary_scenario(setting, 'single_obstacle', {'agents.*.heading': self.heading},
                             f'single_obstacle_heading_{self.heading}')

    def config(self, setting):
        """The training configuration."""
        shipped = f'reward_{self.reward}_{self.parameters}'
        if self.heading == HEADING:
            return setting.config_file(shipped)
        return vary_config(setting, shipped, {}, self.name(), [self.scenario(setting)])

    def folder(self, setting, seed):
        """Of a run."""
        return setting.run_folder(NAME, f'{self.name()}_{seed:02d}')


GAIN, COSINE = (Variant(reward) for reward in REWARDS)  # with the thesis's parameters
MAIN = [Variant(reward, parameters) for parameters in PARAMETERS for reward in REWARDS]
VARIANTS = [*MAIN, *(Variant(reward, heading=heading) for heading in OTHER_HEADINGS for reward in REWARDS),
            *(Variant(reward, is_longer=True) for reward in REWARDS)]


def plan(setting):
    """A run for each variant and seed."""
    return [make_run(setting, variant, seed) for seed in setting.seeds(SEEDS) for variant in VARIANTS]


def make_run(setting, variant, seed):
    """Trains, then walks with the table just learned."""
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
    """The scenario with more decisions in an episode."""
    return vary_scenario(setting, 'single_obstacle', {'duration': PATIENT_DURATION}, 'single_obstacle_patient')


@functools.lru_cache(maxsize=None)
def records(setting, variant, mode):
    """The records of all seeds; mode: training, demo, free or patient."""
    return [read_csv(variant.folder(setting, seed) / f'{mode}.csv') for seed in setting.seeds(SEEDS)]


def per_seed(setting, variant, mode, measure):
    """A measure of the record of each seed."""
    return [measure(record) for record in records(setting, variant, mode)]


def free_share(setting, variant):
    """For each seed, which share of the decisions in training was made without an obstacle in sight [%]."""
    shares = []
    for seed in setting.seeds(SEEDS):
        visits = read_visits(variant.folder(setting, seed) / 'q_table.txt')
        shares.append(100.0 * sum(visits.get(row, 0) for row in range(GOAL_SECTORS)) / sum(visits.values()))
    return shares


def bends(places):
    """How a path bends from one leg to the next, the zigzag within a leg left out: in total and at the sharpest
    [degrees]; places are (ticks, 2), nan after the end."""
    corners = places[numpy.isfinite(places[:, 0])][::LEG]
    legs = numpy.diff(corners, axis=0)
    turns = numpy.degrees(numpy.abs(numpy.diff(numpy.unwrap(numpy.arctan2(legs[:, 1], legs[:, 0])))))
    return float(turns.sum()), float(turns.max(initial=0.0))


@functools.lru_cache(maxsize=None)
def free_bends(setting, variant):
    """Of the drawn episodes without an obstacle, for each seed the median of both: an array (seeds, 2)."""
    return numpy.array([
        numpy.median([bends(track[:, 0]) for track in read_tracks(file).values()], axis=0)
        for file in (variant.folder(setting, seed) / 'single_free.csv' for seed in setting.seeds(SEEDS))])


def success(record):
    """[%]"""
    return rates(record)[0]


def contact(record):
    """[%]"""
    return rates(record)[1]


def collision(record):
    """[%]"""
    return rates(record)[2]


def gain_per_step(record):
    """Distance gained per step [m], median over all episodes."""
    return median(record['gain_per_tick'])


def shortfall(record):
    """By how much the distance gained per step differs from the agent's velocity [m], median over all episodes."""
    return median(numpy.abs(SPEED - record['gain_per_tick']))


def ratios(record):
    """Path per distance gained of all episodes; infinite where nothing was gained."""
    return numpy.where(numpy.isnan(record['path_per_gain']), numpy.inf, record['path_per_gain'])


def path_per_gain(record):
    """Median over all episodes."""
    return float(numpy.median(ratios(record)))


def breadth(values, percentiles):
    """From one percentile to the other: the less, the more compact the values lie."""
    low, high = numpy.percentile(values, percentiles, method='nearest')
    return float(high - low) if numpy.isfinite(high) else float('inf')


def gain_breadth(percentiles):
    """Measures how broadly the distance gained per step is scattered [m]."""
    return lambda record: breadth(record['gain_per_tick'], percentiles)


def ratio_breadth(percentiles):
    """Measures how broadly the path per distance gained is scattered."""
    return lambda record: breadth(ratios(record), percentiles)


def ratio_peak(record):
    """The path per distance gained that one in a hundred episodes exceeds."""
    return float(numpy.percentile(ratios(record), 99, method='nearest'))


def path_ratio(record):
    """Path per straight way, median over arrivals only; nan without any."""
    return median(record['path_ratio'][record['arrived'] > 0])


def turning(record):
    """Turning [rad/m], median over arrivals only; nan without any."""
    return median(record['turn_per_metre'][record['arrived'] > 0])
