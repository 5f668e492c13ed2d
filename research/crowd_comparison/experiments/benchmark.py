"""The steering benchmark: learned models with several training seeds, compared with ORCA and social force."""
import sys

from crowd_experiments import style
from crowd_experiments.pages import Chapter
from crowd_experiments.records import Spread
from crowd_experiments.runs import Run, processor_seconds

from .. import bars
from ..metrics_csv import (COLOURS, LEARNED, NAMES, ORCA, OURS, REFERENCES, greatest, judged, largest_difference,
                           least, not_slower, read_metrics, time_against)

NAME = 'benchmark'
TITLE = 'The steering benchmark'
SEEDS = 10
QUICK_EPISODES = {'thesis_nearest': 20, 'thesis_occupancy': 20, 'anticipation': 5}
COSTS = {'thesis_nearest': 2.0, 'thesis_occupancy': 12.0, 'anticipation': 14.0}  # [s]
MEASURES = {'contact_pct': ('contact %', 1), 'clean_pct': ('clean %', 0), 'time_ratio': ('time', 3),
            'path_ratio': ('path', 3), 'turn_rad_per_m': ('turn rad/m', 2)}
SCORER = 'score.py'


def plan(setting):
    """Returns a run for each learned model and training seed, and one for the benchmark's scorer; an empty list without
    a benchmark."""
    if not setting.benchmark:
        return []
    runs = [make_run(setting, model, seed) for seed in setting.seeds(SEEDS) for model in LEARNED]
    return runs + ([make_scored_run(setting)] if (setting.benchmark / SCORER).is_file() else [])


def run_folder(setting, model, seed):
    return setting.run_folder(NAME, f'{model}_{seed:02d}')


def scored_folder(setting):
    return setting.run_folder(NAME, 'scored')


def make_run(setting, model, seed):
    return Run(run_folder(setting, model, seed), [
        [setting.tool('train'), setting.learning(model), '--output', 'q_table.txt', '--seed', seed]
        + (['--episodes', QUICK_EPISODES[model]] if setting.quick else []),
        [setting.tool('evaluate'), '--q-table', 'q_table.txt', '--threads', 1, '--csv', 'metrics.csv',
         *sorted((setting.benchmark / 'scenarios').glob('*.yaml'))],
    ], cost=COSTS[model])


def make_scored_run(setting):
    """Returns a run that evaluates the shipped table with `evaluate` and with the benchmark's scorer."""
    return Run(scored_folder(setting), [
        [setting.tool('evaluate'), '--q-table', setting.table(OURS), '--threads', 1, '--csv', 'metrics.csv',
         '--trajectories', 'trajectories', *sorted((setting.benchmark / 'scenarios').glob('*.yaml'))],
        [sys.executable, setting.benchmark / SCORER, setting.benchmark / 'scenarios', 'trajectories', '--csv',
         'scored.csv'],
    ], cost=20.0)


def report(setting):
    """Returns the chapter, from the runs' metrics."""
    learned = {model: [read_metrics(run_folder(setting, model, seed) / 'metrics.csv')
                       for seed in setting.seeds(SEEDS)] for model in LEARNED}
    references = {model: read_metrics(setting.benchmark / 'reference.csv', model) for model in REFERENCES}
    seconds = [processor_seconds(run_folder(setting, OURS, seed))[0] for seed in setting.seeds(SEEDS)]
    chapter = Chapter(NAME, TITLE)
    chapter.add_text(
        f'All models use the same fixed scenes; learned models have {len(setting.seeds(SEEDS))} training seeds. '
        'Contact: agents whose body overlapped another body or a wall by more than 1 mm at the end of any tick; clean: '
        'instances in which all agents arrived and none had a contact; time: time x maximum speed / straight-line '
        'distance; path: distance walked / straight-line distance, both of the agents that arrived. Means over '
        'scenarios exclude door12, which requires path planning around walls. Spreads are mean (lowest-highest) over '
        'the training seeds.')
    chapter.add_table(f'Requirements (bars) and aims for {NAMES[OURS]}', bars.HEADER,
                      bars.rows(learned[OURS], references[ORCA], seconds), 'bars')
    add_overview(chapter, learned, references)
    add_times(chapter, setting, learned, references)
    for key, (label, decimals) in MEASURES.items():
        add_measure(chapter, learned, references, key, label, decimals)
    add_score(chapter, setting)
    return chapter


def spread_text(values, decimals):
    """Returns mean (lowest-highest), or only the mean if there is no spread."""
    spread = Spread(values)
    mean, low, high = (f'{value:.{decimals}f}' for value in (spread.mean, spread.low, spread.high))
    return mean if low == high else f'{mean} ({low}-{high})'


def all_models(learned, references):
    """Returns lists of metrics by model: one for each seed, a single one for the references."""
    return {**learned, **{model: [metrics] for model, metrics in references.items()}}


def add_overview(chapter, learned, references):
    orca = references[ORCA]
    columns = {
        'time / ORCA': lambda metrics: time_against(metrics, orca), 'not slower in': lambda f: not_slower(f, orca),
        'greatest contact %': lambda f: greatest(f, 'contact_pct'),
        'least clean %': lambda f: least(f, 'clean_pct', judged(f)),
        'longest path': lambda f: greatest(f, 'path_ratio'),
        'most turning rad/m': lambda f: greatest(f, 'turn_rad_per_m')}
    decimals = (3, 0, 2, 0, 3, 2)
    rows = [[NAMES[model], *(spread_text([measure(metrics) for metrics in seeds], places)
                             for measure, places in zip(columns.values(), decimals))]
            for model, seeds in all_models(learned, references).items()]
    chapter.add_table(f'Overview: geometric mean of time / time of ORCA with parameters chosen for each scenario; '
                      f'number of scenarios of {len(judged(orca))} in which the time is not above; and the values of '
                      'the worst scenario (clean: without door12)', ['', *columns], rows, 'overview')


def add_measure(chapter, learned, references, key, label, decimals):
    models = all_models(learned, references)
    rows = [[scenario, *(spread_text([metrics[scenario][key] for metrics in seeds], decimals)
                         for seeds in models.values())] for scenario in references[ORCA]]
    chapter.add_table(f'Scenario by scenario: {label}', ['scenario', *(NAMES[model] for model in models)], rows, key)


def add_times(chapter, setting, learned, references):
    """Adds time / ORCA's time in every scenario: a mark for each model, a line over the training seeds."""
    orca = references[ORCA]
    scenarios = sorted(orca, key=lambda name: Spread(f[name]['time_ratio'] for f in learned[OURS]).mean
                       / orca[name]['time_ratio'])
    figure, axes = style.new_figure(1, 1, 9, 0.9 + 0.3 * len(scenarios))
    panel = axes[0][0]
    places = range(len(scenarios))
    for model, seeds in all_models(learned, references).items():
        if model == ORCA:
            continue
        spreads = [Spread(f[name]['time_ratio'] / orca[name]['time_ratio'] for f in seeds) for name in scenarios]
        panel.plot([spread.mean for spread in spreads], places, color=COLOURS[model], label=NAMES[model], linestyle='',
                   marker='o' if model == OURS else 'd', markersize=7 if model == OURS else 5,
                   zorder=6 if model == OURS else 4)
        panel.hlines(places, [s.low for s in spreads], [s.high for s in spreads], color=COLOURS[model], linewidth=1)
    panel.axvline(1.0, color=COLOURS[ORCA], linewidth=1.5, label=NAMES[ORCA])
    panel.set_yticks(list(places), scenarios)
    panel.set_xscale('log')
    panel.set_xticks([0.6, 0.8, 1.0, 1.5, 2.0, 3.0], ['0.6', '0.8', '1', '1.5', '2', '3'])
    panel.minorticks_off()
    panel.set_xlabel("time / ORCA's time with its parameters picked for the scenario (left: faster)")
    panel.legend(loc='lower right')
    chapter.add_figure(style.save(figure, setting.figure_file('steering_times')),
                       'Time / ORCA\'s time by scenario; lines: lowest to highest over the training seeds. The '
                       'thesis\'s sets and social force walk through other agents, so their times are not comparable.')


def add_score(chapter, setting):
    if not (setting.benchmark / SCORER).is_file():
        chapter.add_text(f'The benchmark has no {SCORER}: the metrics of evaluate are not checked against it.')
        return
    folder = scored_folder(setting)
    scored = read_metrics(folder / 'scored.csv')
    difference = largest_difference(read_metrics(folder / 'metrics.csv'), scored)
    chapter.add_table(
        "Metrics of evaluate for the shipped table, compared with those of the benchmark's scorer, which reads the "
        'recorded trajectories',
        ['scenarios', 'metrics compared', 'greatest difference'],
        [[str(len(scored)), str(sum(len(row) for row in scored.values())), f'{difference:.1g}']], 'scorer')
