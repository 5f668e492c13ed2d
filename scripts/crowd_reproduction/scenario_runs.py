"""The runs of the scenarios' chapter, and what they left, for all who look at them."""
import functools

import numpy

from crowd_drawing.motion import place_of
from crowd_drawing.files import read_scene
from crowd_experiments.records import of_scenario, rates, read_csv, read_tracks
from crowd_experiments.runs import Run
from crowd_experiments.variations import read_documents, vary_scenario

from . import agent_training
from .decisions import read_decisions, read_visits

NAME = 'scenarios'
SETS = agent_training.SETS
PARAMETERS = agent_training.PARAMETERS
SCENARIOS = {
    'dummies': 'a field of resting dummies', 'circle6': 'six on a circle, each to the opposite point',
    'circle6_obstacle': 'six on a circle around an obstacle', 'line6': 'six abreast, all ways cross',
    'line6_mover': 'six abreast, all ways cross, with a moving obstacle', 'same_goal6': 'six to one goal',
    'same_goal6_mover': 'six to one goal, with a moving obstacle', 'circle12': 'twelve on a circle',
    'circle12_varied': 'twelve on a circle, at varied speeds'}
WATCHED = ('circle12', 'circle12_varied')  # every decision is recorded
# Figures 4.22 and 4.23 with a goal so far away that there is time to group again, by the scenarios they are made from.
FAR = {'same_goal6_far': 'same_goal6', 'same_goal6_mover_far': 'same_goal6_mover'}
FAR_GOAL = [11, 0]  # [m]; in place of [5, 0]
# The dummies of figure 4.17 with more space between them: positions, starts and goals so many times as far out.
WIDE, WIDER = 'dummies_wide', 1.6
# Twelve exactly on the circle, in the thesis's order and at the same time: how much synchronicity is there to break?
EXACT = {'circle12_exact': {}, 'circle12_exact_simultaneous': {'order': 'simultaneous'}}
EXACT_RADIUS = [0, 1e-6]  # of the starts around their places [m], in place of [0, 0.05]
# Whose experience the table holds.
LEARNERS = {'agent': 'one agent, alone', 'crowd': 'the crowd learned together on a mix'}
MAIN = ('agent', 'occupancy', 'thesis')  # what figures 4.17-4.25 show
DEMO = 'demo.csv'  # how all agents fared in all scenarios; those above have records of their own
RECORDS = {WIDE: 'wide.csv', **dict.fromkeys(EXACT, 'exact.csv')}
SEEDS = 10
EPISODES = 50
WALKED = 5  # of them are recorded to be drawn
MIX_EPISODES = 1500


def folder_of(setting, table, seed):
    """Of the run that made a table: learner, state set and parameters."""
    learner, states, parameters = table
    if learner == 'agent':
        return agent_training.folder_of(setting, states, parameters, seed)
    return setting.run_folder(NAME, f'{learner}_{states}_{parameters}_{seed:02d}')


def plan(setting):
    """A run for each state set, set of parameters and seed, in which a crowd learns together."""
    return [make_run(setting, ('crowd', states, parameters), seed) for seed in setting.seeds(SEEDS) for states in SETS
            for parameters in PARAMETERS]


def far_scenarios(setting):
    """The scenarios of FAR."""
    return [vary_scenario(setting, base, {'name': far, 'agents.*.goal': FAR_GOAL}, far) for far, base in FAR.items()]


def wide_dummies(setting):
    """The scenario WIDE."""
    base = read_documents(setting.scenario('dummies'))[0]
    changes = {f'obstacles.{i}.position': [round(WIDER * x, 3) for x in obstacle['position']]
               for i, obstacle in enumerate(base['obstacles'])}
    return vary_scenario(setting, 'dummies', {
        'name': WIDE, 'agents.0.position.box': [[-WIDER * 5, -1.5], [-WIDER * 5 + 0.4, 1.5]],
        'agents.0.goal.box': [[WIDER * 5 - 0.4, -1.5], [WIDER * 5, 1.5]], **changes}, WIDE)


def exact_scenarios(setting):
    """The scenarios of EXACT."""
    return [vary_scenario(setting, 'circle12', {'name': name, 'agents.*.position.ring.radius': EXACT_RADIUS, **changes},
                          name) for name, changes in EXACT.items()]


def make_run(setting, table, seed):
    """A crowd learns on a mix of scenarios, and walks."""
    _, states, parameters = table
    return Run(folder_of(setting, table, seed), [
        [setting.tool('train'), setting.config_file(f'crowd_mix_{states}_{parameters}'), '--output',
         agent_training.TABLE, '--seed', seed, '--episodes', setting.count(MIX_EPISODES, 16)],
        judged_walk(setting, seed)], cost=2.5)


def judged_walk(setting, seed, table=agent_training.TABLE, record=DEMO):
    """The command by which a table walks all scenarios."""
    return agent_training.walk(setting, table, seed) + ['--episodes', setting.count(EPISODES, 2), '--record', record,
                                                        *map(setting.scenario, SCENARIOS)]


def agent_walks(setting, states, seed):
    """What the tables of one agent walk: after the first part of its training, and after both."""
    commands = [judged_walk(setting, seed, agent_training.SINGLE_TABLE, 'single.csv'), judged_walk(setting, seed)]
    if states == 'occupancy':
        walk = agent_training.walk(setting, agent_training.TABLE, seed) + ['--episodes', setting.count(WALKED, 2)]
        commands += [walk + ['--scenes', '.', '--trajectories', '.', *map(setting.scenario, SCENARIOS),
                             *far_scenarios(setting), wide_dummies(setting)],
                     agent_training.walk(setting, agent_training.TABLE, seed) + [
                         '--episodes', setting.count(EPISODES, 2), '--record', RECORDS[WIDE], wide_dummies(setting)],
                     agent_training.walk(setting, agent_training.TABLE, seed) + [
                         '--episodes', 1, '--record', RECORDS['circle12_exact'], *exact_scenarios(setting)],
                     walk + ['--states', 'states', *map(setting.scenario, WATCHED)]]
    return commands


@functools.lru_cache(maxsize=None)
def record_of(setting, table, seed, file=DEMO):
    """How all agents fared in all scenarios."""
    return read_csv(folder_of(setting, table, seed) / file)


def measured(setting, table, scenario, file=DEMO):
    """Success, contact and collision [%], a tuple for each seed."""
    file = RECORDS.get(scenario, file)
    records = [record_of(setting, table, seed, file) for seed in setting.seeds(SEEDS)]
    return [rates(record, of_scenario(record, scenario)) for record in records]


@functools.lru_cache(maxsize=None)
def episodes_of(setting, table, seed, scenario):
    """Of each episode: how many agents arrived, touched and collided (arrays), how many there were, and how long it
    took until the last one arrived or time was up."""
    record = record_of(setting, table, seed, RECORDS.get(scenario, DEMO))
    chosen = of_scenario(record, scenario)
    count = int(record['episode'][chosen].max()) + 1

    def by_episode(name):
        return record[name][chosen].reshape(count, -1)

    sums = {name: by_episode(name).sum(axis=1) for name in ('arrived', 'touched', 'collided')}
    return {**sums, 'agents': by_episode('arrived').shape[1], 'ticks': by_episode('ticks').max(axis=1)}


def clean_share(setting, table, seed, scenario, incident='touched'):
    """The share of the episodes [%] in which all arrive, and none touches anything (or has collided)."""
    episodes = episodes_of(setting, table, seed, scenario)
    return 100.0 * float(numpy.mean((episodes['arrived'] == episodes['agents']) & (episodes[incident] == 0)))


@functools.lru_cache(maxsize=None)
def tracks_of(setting, table, seed, scenario):
    """The recorded places, by instance."""
    return read_tracks(folder_of(setting, table, seed) / f'{scenario}.csv')


def obstacle_places(setting, scenario, ticks):
    """Where the first obstacle of a scenario is, at each tick from the start."""
    scene = read_scene(setting.scenario(scenario), 0)
    return numpy.array([place_of(scene.obstacles[0], tick * scene.tick) for tick in range(ticks)])


@functools.lru_cache(maxsize=None)
def decisions_of(setting, table, seed, scenario):
    """All decisions of the recorded instances."""
    return read_decisions(folder_of(setting, table, seed) / 'states' / f'{scenario}.csv')


@functools.lru_cache(maxsize=None)
def visits_of(setting, table, seed):
    """How often each row was decided on in training."""
    return read_visits(folder_of(setting, table, seed) / agent_training.TABLE)


def arrivals_of(setting, table, seed, scenario):
    """Who arrived: a set of (instance, agent)."""
    record = record_of(setting, table, seed)
    chosen = of_scenario(record, scenario) & (record['arrived'] > 0)
    return set(zip(record['episode'][chosen].astype(int).tolist(), record['agent'][chosen].astype(int).tolist()))
