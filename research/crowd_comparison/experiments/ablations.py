"""Ablations: each idea of the anticipation crowd is switched off once."""
import pathlib

import yaml
from crowd_experiments import style
from crowd_experiments.records import Spread
from crowd_experiments.variations import vary_config
from crowd_studies.program import Report

from ..models import (COLOURS, ORCA, OURS, TEXTS, benchmark_run, judged, not_slower, read_metrics, spread_row,
                      time_against)

NAME = 'ablations'
SEEDS = 3
WHOLE = 'everything'
# Changes of the training configuration, by the paths of keys.
ABLATIONS = yaml.safe_load(pathlib.Path(__file__).with_suffix('.yaml').read_text(encoding='utf-8'))


def ablations_of(setting):
    return setting.count(list(ABLATIONS), (WHOLE, 'no stay'))


def folder_of(setting, ablation, seed):
    return setting.run_folder(NAME, f'{file_name(ablation)}_{seed:02d}')


def file_name(ablation):
    return ablation.replace(' ', '_').replace(',', '')


def plan(setting):
    """Returns a run for each ablation and training seed; an empty list without a benchmark."""
    return [benchmark_run(setting, folder_of(setting, ablation, seed),
                          vary_config(setting, setting.learning(OURS), ABLATIONS[ablation], file_name(ablation)),
                          seed, 5, 14.0)
            for seed in setting.seeds(SEEDS, 1) for ablation in ablations_of(setting)] if setting.benchmark else []


def report(setting):
    orca = read_metrics(setting.benchmark / 'reference.csv', ORCA)
    found = {ablation: [read_metrics(folder_of(setting, ablation, seed) / 'metrics.csv')
                        for seed in setting.seeds(SEEDS, 1)] for ablation in ablations_of(setting)}
    chapter = Report(NAME, TEXTS, setting)
    chapter.say('intro', seeds=len(setting.seeds(SEEDS, 1)))
    columns = {
        'time / ORCA': (lambda f: time_against(f, orca), 3), 'not slower in': (lambda f: not_slower(f, orca), 0),
        'contact %': (lambda f: f.contact_pct.max(), 2), 'clean %, worst': (lambda f: judged(f).clean_pct.min(), 0),
        'clean %, mean': (lambda f: judged(f).clean_pct.mean(), 1), 'path': (lambda f: f.path_ratio.max(), 3),
        'turn rad/m': (lambda f: f.turn_rad_per_m.max(), 2)}
    chapter.tabulate(NAME, ['', *columns], [spread_row(ablation, columns, seeds) for ablation, seeds in found.items()])
    add_figure(chapter, found, {"time / ORCA's, geometric mean (left: faster)": columns['time / ORCA'][0],
                                'clean instances [%], mean over the scenarios': columns['clean %, mean'][0]})
    return chapter


def add_figure(chapter, found, measures):
    """Adds time / ORCA's time and the mean share of clean instances, side by side."""
    figure, axes = style.new_figure(1, 2, 11, 0.9 + 0.32 * len(found), sharey=True)
    names = list(found)[::-1]
    for panel, (label, measure) in zip(axes[0], measures.items()):
        for place, ablation in enumerate(names):
            values = list(map(measure, found[ablation]))
            colour = COLOURS[OURS] if ablation == WHOLE else '0.35'
            panel.plot(values, [place] * len(values), 'o', color=colour, markersize=5)
        panel.axvline(Spread(map(measure, found[WHOLE])).mean, color=COLOURS[OURS], linewidth=1)
        panel.set_xlabel(label)
        panel.set_yticks(range(len(names)), names)
    chapter.draw(figure, NAME, 'figure')
