"""Figures 4.17-4.25: crowds that walk by what was learned on a mix of scenarios."""
from crowd_drawing.files import read_scene, read_walks
from crowd_experiments import style
from crowd_experiments.chapter import Chapter
from crowd_experiments.records import Spread, median, of_scenario, rates, read_csv, read_table_header
from crowd_experiments.runs import Run
from crowd_experiments.scene_figures import draw_moment, frame_alike, last_tick_of

from .. import names

NAME = 'scenarios'
TITLE = 'Scenarios (figures 4.17-4.25)'
SETS = ('nearest', 'occupancy')
PARAMETERS = ('thesis', 'better')
SCENARIOS = {
    'dummies': 'a field of resting dummies', 'circle6': 'six on a circle, each to the opposite point',
    'circle6_obstacle': 'six on a circle around an obstacle', 'line6': 'six abreast, all ways cross',
    'line6_mover': 'six abreast, all ways cross, with a moving obstacle', 'same_goal6': 'six to one goal',
    'same_goal6_mover': 'six to one goal, with a moving obstacle', 'circle12': 'twelve on a circle',
    'circle12_varied': 'twelve on a circle, at varied speeds'}
MOMENTS = (0.0, 1 / 3, 2 / 3, 1.0)  # of the time until the last one arrived
DRAWN_PARAMETERS = 'better'
SEEDS = 4
EPISODES = 100
DEMO_SEED = 1000


def run_name(states, parameters, seed):
    return f'{states}_{parameters}_{seed:02d}'


def plan(setting):
    """A run for each state set, set of parameters and seed."""
    return [make_run(setting, states, parameters, seed) for seed in setting.seeds(SEEDS) for states in SETS
            for parameters in PARAMETERS]


def make_run(setting, states, parameters, seed):
    walk = [setting.tool('evaluate'), '--q-table', 'q_table.txt', '--threads', 1, '--seed', DEMO_SEED + seed]
    files = list(map(setting.scenario, SCENARIOS))
    return Run(setting.run_folder(NAME, run_name(states, parameters, seed)), [
        [setting.tool('train'), setting.recipe(f'scenarios_{states}_{parameters}'), '--output', 'q_table.txt',
         '--seed', seed] + (['--episodes', 20] if setting.quick else []),
        walk + ['--episodes', setting.count(EPISODES, 1), '--record', 'demo.csv', *files],
        walk + ['--episodes', 1, '--scenes', '.', '--trajectories', '.', *files],
    ], cost=12.0)


def report(setting):
    """The chapter, from the runs' records."""
    chapter = Chapter(NAME, TITLE)
    chapter.tell(
        "The thesis's agents: they always walk at full speed, and walk through what they fail to avoid. One table for "
        "all "
        'scenarios, trained on a mix (single agents among obstacles, and crowds that learn in one shared table) so '
        f'that the states of occupancy are filled; {len(setting.seeds(SEEDS))} training seeds, '
        f'{setting.count(EPISODES, 1)} instances a scenario, whose starts are drawn anew each time.')
    add_table(chapter, setting)
    add_visits(chapter, setting)
    for scenario in SCENARIOS:
        add_moments(chapter, setting, scenario)
    return chapter


def add_moments(chapter, setting, scenario):
    """Four moments of the first instance, both sets one above the other."""
    figure, axes = style.new_figure(len(SETS), len(MOMENTS), 13, 6.9)
    pictures = []
    for row, states in enumerate(SETS):
        folder = setting.run_folder(NAME, run_name(states, DRAWN_PARAMETERS, 1))
        scene = read_scene(folder / f'{scenario}.yaml', 0)
        _, walks = read_walks(folder / f'{scenario}.csv', 0)
        for panel, moment in zip(axes[row], MOMENTS):
            tick = round(moment * last_tick_of(walks))
            pictures.append(draw_moment(panel, scene, walks, tick))
            panel.set_title(f'{style.short_set_name(states)}, {tick * scene.tick:.1f} s')
        axes[row][0].set_ylabel('y [m]')
    for panel in axes[-1]:
        panel.set_xlabel('x [m]')
    width, height = frame_alike(pictures)
    figure.set_size_inches(13, len(SETS) * (0.75 + 3.0 * height / width))
    chapter.add_figure(style.save(figure, setting.figure_file(f'scenario_{scenario}')),
                       f'After figures 4.17-4.25, {scenario}: {SCENARIOS[scenario]}. Four moments of one episode; '
                       f'above state set 1, below state set 2, {names.PARAMETER_NAMES[DRAWN_PARAMETERS]}, seed 1. '
                       'Discs: bodies; circles: who has arrived and left; crosses: goals; grey: obstacles.')


def add_table(chapter, setting):
    rows = []
    records = {(states, parameters): [
        read_csv(setting.run_folder(NAME, run_name(states, parameters, seed)) / 'demo.csv')
        for seed in setting.seeds(SEEDS)] for states in SETS for parameters in PARAMETERS}
    for scenario in SCENARIOS:
        for parameters in PARAMETERS:
            for states in SETS:
                rows.append([f'{scenario}, {style.short_set_name(states)}, {names.PARAMETER_NAMES[parameters]}',
                             *measures_of(records[states, parameters], scenario)])
    chapter.add_table('Scenarios: mean ± standard deviation over the seeds (lowest-highest)',
                      ['', 'success %', 'contact %', 'path ratio'], rows)


def measures_of(records, scenario):
    """Success, contact and path ratio in a scenario, over the records of all seeds."""
    success, contact, ratio = [], [], []
    for record in records:
        rows = of_scenario(record, scenario)
        arrived, touched = rates(record, rows)
        success.append(arrived)
        contact.append(touched)
        ratio.append(median(record['path_ratio'][rows & (record['arrived'] > 0)]))
    return [Spread(success).text(1), Spread(contact).text(1), Spread.of_numbers(ratio).text(2)]


def add_visits(chapter, setting):
    rows = []
    for parameters in PARAMETERS:
        for states in SETS:
            headers = [read_table_header(setting.run_folder(NAME, run_name(states, parameters, seed)) / 'q_table.txt')
                       for seed in setting.seeds(SEEDS)]
            visited = Spread(float(header['visited_rows']) for header in headers)
            decisions = Spread(float(header['decisions']) / 1e6 for header in headers)
            rows.append([f'{style.SET_NAMES[states]}, {names.PARAMETER_NAMES[parameters]}', headers[0]['rows'],
                         visited.text(0), decisions.text(1)])
    chapter.add_table('Rows of the table that were ever visited in training',
                      ['', 'rows', 'visited', 'decisions learned from [million]'], rows)
