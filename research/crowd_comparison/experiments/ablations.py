"""Ablations: each idea of the anticipation crowd is switched off once."""
import pathlib

import yaml
from crowd_experiments import style
from crowd_experiments.pages import Chapter
from crowd_experiments.records import Spread
from crowd_experiments.runs import Run
from crowd_experiments.variations import vary_config

from ..metrics_csv import COLOURS, ORCA, OURS, greatest, judged, least, not_slower, read_metrics, time_against
from .benchmark import spread_text

NAME = 'ablations'
TITLE = 'Ablations'
SEEDS = 3
QUICK_EPISODES = 5
WHOLE = 'everything'
# Changes of the training configuration, by the paths of keys.
ABLATIONS = yaml.safe_load(pathlib.Path(__file__).with_suffix('.yaml').read_text(encoding='utf-8'))
QUICK_ABLATIONS = (WHOLE, 'no stay')


def ablations_of(setting):
    return setting.count(list(ABLATIONS), QUICK_ABLATIONS)


def run_name(ablation, seed):
    return f"{ablation.replace(' ', '_').replace(',', '')}_{seed:02d}"


def plan(setting):
    """Returns a run for each ablation and training seed; an empty list without a benchmark."""
    if not setting.benchmark:
        return []
    return [make_run(setting, ablation, seed) for seed in setting.seeds(SEEDS, 1) for ablation in ablations_of(setting)]


def make_run(setting, ablation, seed):
    return Run(setting.run_folder(NAME, run_name(ablation, seed)), [
        [setting.tool('train'), write_config(setting, ablation), '--output', 'q_table.txt', '--seed', seed]
        + (['--episodes', QUICK_EPISODES] if setting.quick else []),
        [setting.tool('evaluate'), '--q-table', 'q_table.txt', '--threads', 1, '--csv', 'metrics.csv',
         *sorted((setting.benchmark / 'scenarios').glob('*.yaml'))],
    ], cost=14.0)


def write_config(setting, ablation):
    """Writes the shipped training configuration with one idea switched off. Returns the file."""
    return vary_config(setting, setting.learning(OURS), ABLATIONS[ablation], run_name(ablation, 0)[:-3])


def report(setting):
    """Returns the chapter, from the runs' metrics."""
    orca = read_metrics(setting.benchmark / 'reference.csv', ORCA)
    found = {ablation: [read_metrics(setting.run_folder(NAME, run_name(ablation, seed)) / 'metrics.csv')
                        for seed in setting.seeds(SEEDS, 1)] for ablation in ablations_of(setting)}
    chapter = Chapter(NAME, TITLE)
    chapter.add_text(
        'One idea is switched off at a time; all else is as in the training configuration. Each variant is trained '
        f'with {len(setting.seeds(SEEDS, 1))} seeds and evaluated with the benchmark. Contact, path and turning: the '
        'worst scenario; clean: the worst scenario without door12, and the mean. Mean (lowest-highest) over the seeds.')
    scenarios = judged(orca)
    columns = {
        'time / ORCA': (lambda f: time_against(f, orca), 3),
        'not slower in': (lambda f: not_slower(f, orca), 0),
        'contact %': (lambda f: greatest(f, 'contact_pct'), 2),
        'clean %, worst': (lambda f: least(f, 'clean_pct', scenarios), 0),
        'clean %, mean': (lambda f: Spread(f[name]['clean_pct'] for name in scenarios).mean, 1),
        'path': (lambda f: greatest(f, 'path_ratio'), 3), 'turn rad/m': (lambda f: greatest(f, 'turn_rad_per_m'), 2)}
    rows = [[ablation, *(spread_text([measure(metrics) for metrics in seeds], decimals)
                         for measure, decimals in columns.values())] for ablation, seeds in found.items()]
    chapter.add_table('Effect of each idea', ['', *columns], rows, 'ablations')
    add_figure(chapter, setting, found, orca)
    return chapter


def add_figure(chapter, setting, found, orca):
    """Adds time / ORCA's time and the mean share of clean instances, side by side."""
    scenarios = judged(orca)
    figure, axes = style.new_figure(1, 2, 11, 0.9 + 0.32 * len(found), sharey=True)
    measures = (lambda f: time_against(f, orca), lambda f: Spread(f[name]['clean_pct'] for name in scenarios).mean)
    labels = ("time / ORCA's, geometric mean (left: faster)", 'clean instances [%], mean over the scenarios')
    names = list(found)[::-1]
    for panel, measure, label in zip(axes[0], measures, labels):
        for place, ablation in enumerate(names):
            values = [measure(metrics) for metrics in found[ablation]]
            colour = COLOURS[OURS] if ablation == WHOLE else '0.35'
            panel.plot(values, [place] * len(values), 'o', color=colour, markersize=5)
        panel.axvline(Spread(measure(metrics) for metrics in found[WHOLE]).mean, color=COLOURS[OURS], linewidth=1)
        panel.set_xlabel(label)
        panel.set_yticks(range(len(names)), names)
    chapter.add_figure(style.save(figure, setting.figure_file('ablations')),
                       'Each idea switched off once; marks: training seeds; line: mean with all ideas.')
