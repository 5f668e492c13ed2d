"""Figures 4.13-4.16: two obstacles side by side, of which state set 1 sees the nearer one only."""
from crowd_experiments import style
from crowd_experiments.chapter import Chapter
from crowd_experiments.records import Spread, median, of_scenario, rates, read_csv, read_table_header
from crowd_experiments.runs import Run
from crowd_experiments.scene_figures import draw_scene

from .. import names

NAME = 'ambiguity'
TITLE = 'Ambiguity of state set 1: the twins tests (figures 4.13-4.16)'
SETS = ('nearest', 'occupancy')
PARAMETERS = ('thesis', 'better')
TESTS = {'twins_a': 'a: overlapping', 'twins_b': 'b: close', 'twins_c': 'c: gap too small', 'twins_d': 'd: tight gap'}
SEEDS = 10
EPISODES = 100
DEMO_SEED = 1000


def run_name(states, parameters, seed):
    return f'{states}_{parameters}_{seed:02d}'


def plan(setting):
    """A run for each state set, set of parameters and seed."""
    return [make_run(setting, states, parameters, seed) for seed in setting.seeds(SEEDS) for states in SETS
            for parameters in PARAMETERS]


def make_run(setting, states, parameters, seed):
    return Run(setting.run_folder(NAME, run_name(states, parameters, seed)), [
        [setting.tool('train'), setting.recipe(f'twins_{states}_{parameters}'), '--output', 'q_table.txt',
         '--seed', seed] + (['--episodes', 40] if setting.quick else []),
        [setting.tool('evaluate'), '--q-table', 'q_table.txt', '--threads', 1, '--seed', DEMO_SEED + seed, '--episodes',
         setting.count(EPISODES, 5), '--record', 'demo.csv', *map(setting.scenario, TESTS)],
        [setting.tool('evaluate'), '--q-table', 'q_table.txt', '--threads', 1, '--seed', DEMO_SEED + seed, '--episodes',
         1, '--scenes', '.', '--trajectories', '.', *map(setting.scenario, TESTS)],
    ], cost=2.0)


def report(setting):
    """The chapter, from the runs' records."""
    chapter = Chapter(NAME, TITLE)
    chapter.tell(
        'An agent and two obstacles of radius 0.4 m side by side across its way: a: they overlap; b: they all but '
        'touch; c: the gap of 0.4 m is narrower than the agent (0.5 m); d: the gap of 1.1 m can be passed without '
        'coming within the collision radius. State set 1 sees the nearer of the two only and cannot tell a gap from a '
        f'wall. One table for all four tests, trained on them for 16,000 episodes; {len(setting.seeds(SEEDS))} seeds, '
        f'{setting.count(EPISODES, 5)} episodes a test with start and goal at other places than in training.')
    add_paths(chapter, setting)
    add_table(chapter, setting)
    return chapter


def add_paths(chapter, setting):
    """The first seed's walk through each test, both sets one above the other."""
    for parameters in PARAMETERS:
        figure, axes = style.new_figure(2, 4, 13, 7.4, sharex=True, sharey=True)
        for row, states in enumerate(SETS):
            folder = setting.run_folder(NAME, run_name(states, parameters, 1))
            for panel, (test, title) in zip(axes[row], TESTS.items()):
                draw_scene(panel, folder / f'{test}.yaml', folder / f'{test}.csv', 0, style.SET_COLOURS[states])
                panel.set_title(f'{title}\n{style.SET_NAMES[states]}')
                panel.set_xlim(-3.1, 3.1)
                panel.set_ylim(-3.3, 3.3)
                panel.label_outer()
        chapter.add_figure(style.save(figure, setting.figure_file(f'twins_{parameters}')),
                           'After figures 4.13-4.16: walked paths of one demo episode, '
                           f'{names.PARAMETER_NAMES[parameters]}, seed 1. Above: state set 1, below: state set 2. '
                           'Disc: start; circle: end; cross: goal; grey: obstacles. A path that ends far from the '
                           'goal dances on the spot until time is up.')


def add_table(chapter, setting):
    rows = []
    for parameters in PARAMETERS:
        for states in SETS:
            folders = [setting.run_folder(NAME, run_name(states, parameters, seed)) for seed in setting.seeds(SEEDS)]
            records = [read_csv(folder / 'demo.csv') for folder in folders]
            visited = Spread(float(read_table_header(folder / 'q_table.txt')['visited_rows']) for folder in folders)
            for test, title in TESTS.items():
                chosen = [of_scenario(record, test) for record in records]
                success, contact = (Spread(rates(record, rows_of)[index] for record, rows_of in zip(records, chosen))
                                    for index in (0, 1))
                ratios = [median(record['path_ratio'][rows_of & (record['arrived'] > 0)])
                          for record, rows_of in zip(records, chosen)]
                rows.append([f'{names.PARAMETER_NAMES[parameters]}, {style.SET_NAMES[states]}, {title}',
                             success.text(1), contact.text(1), Spread.of_numbers(ratios).text(2), visited.text(0)])
    chapter.add_table('Twins tests: mean ± standard deviation over the seeds (lowest-highest)',
                      ['', 'success %', 'contact %', 'path ratio', 'rows visited in training'], rows)
