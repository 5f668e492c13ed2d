"""The runs of the scenarios' chapter, and functions that read their results."""
import functools

import numpy
from crowd_drawing.files import read_scene
from crowd_drawing.motion import place_of
from crowd_experiments.records import of_scenario, rates, read_csv, read_tracks
from crowd_experiments.runs import Run
from crowd_experiments.variations import read_documents, vary_scenario

from . import agent_training
from .measures import read_decisions, read_visits

NAME = 'scenarios'
SETS = agent_training.SETS
PARAMETERS = agent_training.PARAMETERS
SCENARIOS = {
    'dummies': 'a field of static dummies', 'circle6': 'six agents on a circle, each walks to the opposite point',
    'circle6_obstacle': 'six agents on a circle around an obstacle',
    'line6': 'six agents side by side, all paths cross',
    'line6_mover': 'six agents side by side, all paths cross, with a moving obstacle',
    'same_goal6': 'six agents with one goal', 'same_goal6_mover': 'six agents with one goal, with a moving obstacle',
    'circle12': 'twelve agents on a circle', 'circle12_varied': 'twelve agents on a circle, at varied speeds'}
WATCHED = ('circle12', 'circle12_varied')  # every decision is recorded
# Figures 4.22 and 4.23 with a more distant goal, so that the agents have time to group again; by base scenario.
FAR = {'same_goal6_far': 'same_goal6', 'same_goal6_mover_far': 'same_goal6_mover'}
FAR_GOAL = [11, 0]  # [m]; in place of [5, 0]
# The dummies of figure 4.17 with more space: positions, starts and goals are multiplied by WIDER.
WIDE, WIDER = 'dummies_wide', 1.6
# Twelve agents exactly on the circle, moving in sequence as in the thesis or simultaneously, to measure synchronicity.
EXACT = {'circle12_exact': {}, 'circle12_exact_simultaneous': {'order': 'simultaneous'}}
EXACT_RADIUS = [0, 1e-6]  # [m] of the starts around their places, instead of [0, 0.05]
# The agents that learned the table.
LEARNERS = {'agent': 'one agent', 'crowd': 'crowd trained together on a mix'}
MAIN = ('agent', 'occupancy', 'thesis')  # the table that figures 4.17-4.25 show
DEMO = 'demo.csv'  # record of all SCENARIOS; the other scenarios have their own records
RECORDS = {WIDE: 'wide.csv', **dict.fromkeys(EXACT, 'exact.csv')}
SEEDS = 10
EPISODES = 50
WALKED = 5  # number of episodes that are recorded to be drawn
MIX_EPISODES = 1500


def folder_of(setting, table, seed):
    """Returns the folder of the run that trained a table: learner, state set and parameters."""
    learner, states, parameters = table
    if learner == 'agent':
        return agent_training.folder_of(setting, states, parameters, seed)
    return setting.run_folder(NAME, f'{learner}_{states}_{parameters}_{seed:02d}')


def plan(setting):
    """Returns a run for each state set, set of parameters and seed, in which a crowd is trained together."""
    return [make_run(setting, ('crowd', states, parameters), seed) for seed in setting.seeds(SEEDS) for states in SETS
            for parameters in PARAMETERS]


def far_scenarios(setting):
    """Returns the scenarios of FAR."""
    return [vary_scenario(setting, base, {'name': far, 'agents.*.goal': FAR_GOAL}, far) for far, base in FAR.items()]


def wide_dummies(setting):
    """Returns the scenario WIDE."""
    base = read_documents(setting.scenario('dummies'))[0]
    changes = {f'obstacles.{i}.position': [round(WIDER * x, 3) for x in obstacle['position']]
               for i, obstacle in enumerate(base['obstacles'])}
    return vary_scenario(setting, 'dummies', {
        'name': WIDE, 'agents.0.position.box': [[-WIDER * 5, -1.5], [-WIDER * 5 + 0.4, 1.5]],
        'agents.0.goal.box': [[WIDER * 5 - 0.4, -1.5], [WIDER * 5, 1.5]], **changes}, WIDE)


def exact_scenarios(setting):
    """Returns the scenarios of EXACT."""
    return [vary_scenario(setting, 'circle12', {'name': name, 'agents.*.position.ring.radius': EXACT_RADIUS, **changes},
                          name) for name, changes in EXACT.items()]


def make_run(setting, table, seed):
    """Returns a run that trains a crowd on a mix of scenarios, and evaluates it."""
    _, states, parameters = table
    return Run(folder_of(setting, table, seed), [
        agent_training.train(setting, setting.config_file(f'crowd_mix_{states}_{parameters}'), seed,
                             setting.count(MIX_EPISODES, 16), '--output', agent_training.TABLE),
        judged_walk(setting, seed)], cost=2.5)


def judged_walk(setting, seed, table=agent_training.TABLE, record=DEMO):
    """Returns the command that runs all scenarios with a table."""
    return agent_training.walk(setting, table, seed) + ['--episodes', setting.count(EPISODES, 2), '--record', record,
                                                        *map(setting.scenario, SCENARIOS)]


def agent_walks(setting, states, seed):
    """Returns the commands for the tables of one agent, after the first part of the training and after both."""
    commands = [judged_walk(setting, seed, agent_training.SINGLE_TABLE, 'single.csv'), judged_walk(setting, seed)]
    if states == 'occupancy':
        walk = agent_training.walk(setting, agent_training.TABLE, seed)
        walked = ['--episodes', setting.count(WALKED, 2)]
        commands += [
            walk + walked + ['--scenes', '.', '--trajectories', '.', *map(setting.scenario, SCENARIOS),
                             *far_scenarios(setting), wide_dummies(setting)],
            walk + ['--episodes', setting.count(EPISODES, 2), '--record', RECORDS[WIDE], wide_dummies(setting)],
            walk + ['--episodes', 1, '--record', RECORDS['circle12_exact'], *exact_scenarios(setting)],
            walk + walked + ['--states', 'states', *map(setting.scenario, WATCHED)]]
    return commands


@functools.lru_cache(maxsize=None)
def record_of(setting, table, seed, file=DEMO):
    """Returns the record of all agents in all scenarios."""
    return read_csv(folder_of(setting, table, seed) / file)


def measured(setting, table, scenario, file=DEMO):
    """Returns success, contact and collision [%], a tuple for each seed."""
    file = RECORDS.get(scenario, file)
    records = [record_of(setting, table, seed, file) for seed in setting.seeds(SEEDS)]
    return [rates(record, of_scenario(record, scenario)) for record in records]


@functools.lru_cache(maxsize=None)
def episodes_of(setting, table, seed, scenario):
    """Returns for each episode the number of agents that arrived, touched and collided (arrays), the number of agents,
    and the duration until the last arrival or the end of the time [ticks]."""
    record = record_of(setting, table, seed, RECORDS.get(scenario, DEMO))
    chosen = of_scenario(record, scenario)
    count = int(record['episode'][chosen].max()) + 1

    def by_episode(name):
        return record[name][chosen].reshape(count, -1)

    sums = {name: by_episode(name).sum(axis=1) for name in ('arrived', 'touched', 'collided')}
    return {**sums, 'agents': by_episode('arrived').shape[1], 'ticks': by_episode('ticks').max(axis=1)}


def clean_share(setting, table, seed, scenario, incident='touched'):
    """Returns the share of the episodes [%] in which all agents arrive without an incident: touched or collided."""
    episodes = episodes_of(setting, table, seed, scenario)
    return 100.0 * float(numpy.mean((episodes['arrived'] == episodes['agents']) & (episodes[incident] == 0)))


@functools.lru_cache(maxsize=None)
def tracks_of(setting, table, seed, scenario):
    """Returns the recorded places, by instance."""
    return read_tracks(folder_of(setting, table, seed) / f'{scenario}.csv')


def obstacle_places(setting, scenario, ticks):
    """Returns the positions of the first obstacle of a scenario, at each tick from the start."""
    scene = read_scene(setting.scenario(scenario), 0)
    return numpy.array([place_of(scene.obstacles[0], tick * scene.tick) for tick in range(ticks)])


@functools.lru_cache(maxsize=None)
def decisions_of(setting, table, seed, scenario):
    """Returns all decisions of the recorded instances."""
    return read_decisions(folder_of(setting, table, seed) / 'states' / f'{scenario}.csv')


@functools.lru_cache(maxsize=None)
def visits_of(setting, table, seed):
    """Returns the number of visits of each row in training."""
    return read_visits(folder_of(setting, table, seed) / agent_training.TABLE)


def arrivals_of(setting, table, seed, scenario):
    """Returns the agents that arrived, as a set of (instance, agent)."""
    record = record_of(setting, table, seed)
    chosen = of_scenario(record, scenario) & (record['arrived'] > 0)
    return set(zip(record['episode'][chosen].astype(int).tolist(), record['agent'][chosen].astype(int).tolist()))
