"""The future work of section 5.2, applied to the thesis's agent: a stay action, occlusion, condensed states."""
from crowd_experiments import style
from crowd_experiments.pages import Chapter
from crowd_experiments.records import Spread, median, of_scenario, rates, read_csv, read_table_header
from crowd_experiments.runs import Run
from crowd_experiments.variations import vary_config

from .. import agent_runs, agent_training, names, scenario_runs as runs
from ..measures import read_decisions, surrounded
from ..surroundings import DEFINITIONS, HEADER, LEAST_SECTORS, SOON, row_of

NAME = 'future_work'
TITLE = 'Future work (5.2), for the surrounded agent of figure 4.25'
SCENARIO = 'circle12_varied'
SEEDS = 10
EPISODES = runs.EPISODES
WATCHED = 2  # number of episodes of which every decision is recorded
STAY = {'action_set.stay': True}
OCCLUSION = {'vision.occlusion': True}
CONDENSED = {'state_set.type': 'condensed_occupancy'}
# By the name of the run: the label in tables, and the changed keys of the training configuration.
UNCHANGED = 'thesis'
VARIATIONS = {
    UNCHANGED: ("the thesis's agent", {}),
    'stay': ('stay action', STAY),
    'stay_02': ('stay action, cost 0.2', {**STAY, 'reward.stay_cost': 0.2}),
    'stay_1': ('stay action, cost 1', {**STAY, 'reward.stay_cost': 1.0}),
    'stay_5': ('stay action, cost 5', {**STAY, 'reward.stay_cost': 5.0}),
    'occlusion': ('occlusion', OCCLUSION),
    'condensed': ('condensed states', CONDENSED),
    'both': ('stay action, cost 1, occlusion', {**STAY, 'reward.stay_cost': 1.0, **OCCLUSION}),
}


def folder_of(setting, variation, seed):
    if variation == UNCHANGED:
        return runs.folder_of(setting, runs.MAIN, seed)
    return setting.run_folder(NAME, f'{variation}_{seed:02d}')


def plan(setting):
    """Returns a run for each variation and seed; the thesis's agent is that of the scenarios."""
    return [make_run(setting, variation, seed) for seed in setting.seeds(SEEDS) for variation in VARIATIONS
            if variation != UNCHANGED] + agent_runs.plan(setting)


def make_run(setting, variation, seed):
    """Returns a run that trains one agent as for the scenarios, then runs twelve agents on a circle with its table."""
    changes = VARIATIONS[variation][1]
    single, field = (vary_config(setting, f'agent_{part}_occupancy_thesis', changes, f'{NAME}_{part}_{variation}')
                     for part in ('single', 'field'))
    walk = agent_training.walk(setting, agent_training.TABLE, seed)
    return Run(folder_of(setting, variation, seed), [
        *agent_training.learn(setting, seed, single, field),
        walk + ['--episodes', setting.count(EPISODES, 2), '--record', 'demo.csv', setting.scenario(SCENARIO)],
        walk + ['--episodes', setting.count(WATCHED, 2), '--states', 'states', setting.scenario(SCENARIO)]], cost=1.5)


def report(setting):
    """The chapter, from the runs' records."""
    chapter = Chapter(NAME, TITLE)
    chapter.add_text(
        "State set 2, king's moves and the thesis's parameters. One agent learns alone as for the scenarios; then "
        f'twelve agents on a circle walk at varied speeds with its table ({SCENARIO}). The proposals of the thesis are '
        'applied one at a time: a stay action, without and with a cost for every tick in which the agent does '
        'not move (the reward of a full step straight to the goal is 1; an obstacle in the inner radius costs 10 for '
        'each sector); occlusion, so that hidden bodies are not perceived; and condensed states, with one nearest '
        f'distance for the whole circle. {len(setting.seeds(SEEDS))} seeds, '
        f'{setting.count(EPISODES, 2)} instances; surrounded agents are evaluated in {setting.count(WATCHED, 2)} of '
        'them.')
    records = {variation: records_of(setting, variation) for variation in VARIATIONS}
    found = {variation: measured(setting, variation) for variation in VARIATIONS}
    add_figure(chapter, setting, records, found)
    add_table(chapter, setting, records)
    chapter.add_table(f"Surrounded agents in {SCENARIO}; set 2 and thesis's parameters, with one change per row. "
                      f'{DEFINITIONS}. Sectors are those that the agent perceives as occupied. Mean ± standard '
                      'deviation over the seeds with surrounded agents (lowest-highest)', HEADER,
                      [row_of(label, found[variation]) for variation, (label, _) in VARIATIONS.items()],
                      name='surrounded')
    return chapter


def records_of(setting, variation):
    """Returns the records of all seeds."""
    records = (read_csv(folder_of(setting, variation, seed) / 'demo.csv') for seed in setting.seeds(SEEDS))
    return [of_only(record, SCENARIO) for record in records]


def of_only(record, scenario):
    """Returns the rows of a record that belong to a scenario."""
    rows = of_scenario(record, scenario)
    return {name: column[rows] for name, column in record.items() if name != 'scenario'}


def measured(setting, variation):
    """Returns a Surrounded for each seed."""
    results = []
    for seed, record in zip(setting.seeds(SEEDS), records_of(setting, variation)):
        arrived = {(int(episode), int(agent)) for episode, agent, arrives in
                   zip(record['episode'], record['agent'], record['arrived']) if arrives}
        decisions = read_decisions(folder_of(setting, variation, seed) / 'states' / f'{SCENARIO}.csv')
        results.append(surrounded(first_instances(decisions), arrived, LEAST_SECTORS, SOON))
    return results


def first_instances(decisions):
    """Returns the decisions of the first WATCHED instances; the scenarios' chapter records more."""
    chosen = decisions['instance'] < WATCHED
    return decisions[chosen]


def add_table(chapter, setting, records):
    rows = []
    for variation, (label, _) in VARIATIONS.items():
        ratios = Spread.of_numbers(median(record['path_ratio'][record['arrived'] > 0]) for record in records[variation])
        times = Spread.of_numbers(median(record['time_ratio'][record['arrived'] > 0]) for record in records[variation])
        visited = Spread(float(read_table_header(folder_of(setting, variation, seed) / agent_training.TABLE)
                               ['visited_rows']) for seed in setting.seeds(SEEDS))
        rows.append([label, *names.rate_texts(map(rates, records[variation])), ratios.text(2), times.text(2),
                     visited.text(0)])
    chapter.add_table(f"Future work: twelve on a circle at varied speeds ({SCENARIO}); set 2 and thesis's parameters, "
                      'with what is named. Mean ± standard deviation over the seeds (lowest-highest); ratios: the '
                      'median of the arrivals for each seed',
                      ['', *names.RATES, 'path ratio (arrivals only)',
                       'time ratio (arrivals only)', 'rows visited in training'], rows, name='future_work')


def add_figure(chapter, setting, records, found):
    figure, axes = style.new_figure(1, 4, 14, 4.4, sharey=True)
    panels = {'success [% of the agents]': lambda variation: [rates(record)[0] for record in records[variation]],
              'collision [% of the agents]': lambda variation: [rates(record)[2] for record in records[variation]],
              'contact [% of the agents]': lambda variation: [rates(record)[1] for record in records[variation]],
              'contact after being surrounded [%]':
                  lambda variation: [one.touched_share() for one in found[variation]]}
    for panel, (title, values_of) in zip(axes[0], panels.items()):
        for place, variation in enumerate(VARIATIONS):
            values = Spread.of_numbers(values_of(variation))
            panel.barh(place, values.mean, color='#8e5ea2', alpha=0.45)
            panel.plot(values.values, [place] * len(values.values), linestyle='', marker='o', markersize=3,
                       color='#8e5ea2')
        panel.set_title(title)
        panel.set_xlim(0, 105)
    axes[0][0].set_yticks(range(len(VARIATIONS)), [label for label, _ in VARIATIONS.values()])
    axes[0][0].invert_yaxis()
    chapter.add_figure(style.save(figure, setting.figure_file('future_work')),
                       f"Future work (5.2): {SCENARIO} with set 2 and the thesis's parameters; dots: seeds, bars: "
                       f'means. Right: share of the agents that were ever surrounded ({LEAST_SECTORS} or 8 of 8 '
                       f'sectors occupied) with a contact within the next {SOON} decisions.')
