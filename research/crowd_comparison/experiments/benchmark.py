"""The steering benchmark: learned models with several training seeds, compared with ORCA and social force."""
import sys
import typing

from crowd_experiments import style
from crowd_experiments.records import Spread
from crowd_experiments.runs import Run, processor_seconds
from crowd_studies.program import Report

from ..models import (COLOURS, EXCLUDED, LEARNED, NAMES, ORCA, OURS, REFERENCES, TEXTS, benchmark_run, judged,
                      largest_difference, not_slower, read_metrics, scenarios_of, spread_row, spread_text, time_against)

NAME = 'benchmark'
BAR_HEADER = ['metric', 'bar', 'seed 1', 'worst seed', 'bar met by', 'aim', 'aim met by']
SLACK = 1e-9  # rounding error of floating-point sums, far below the printed precision
SEEDS = 10
QUICK_EPISODES = {'thesis_nearest': 20, 'thesis_occupancy': 20, 'anticipation': 5}
COSTS = {'thesis_nearest': 2.0, 'thesis_occupancy': 12.0, 'anticipation': 14.0}  # [s]
MEASURES = {'contact_pct': ('contact %', 1), 'clean_pct': ('clean %', 0), 'time_ratio': ('time', 3),
            'path_ratio': ('path', 3), 'turn_rad_per_m': ('turn rad/m', 2)}
SCORER = 'score.py'
TICKS = [0.6, 0.8, 1.0, 1.5, 2.0, 3.0]  # of the axis of times


def plan(setting):
    """Returns a run for each learned model and seed, and one for the benchmark's scorer; none without a benchmark."""
    if not setting.benchmark:
        return []
    runs = [benchmark_run(setting, run_folder(setting, model, seed), config_of(setting, model), seed,
                          QUICK_EPISODES[model], COSTS[model]) for seed in setting.seeds(SEEDS) for model in LEARNED]
    if (setting.benchmark / SCORER).is_file():  # evaluates the shipped table with `evaluate` and with the scorer
        runs.append(Run(setting.run_folder(NAME, 'scored'), [
            [setting.tools / 'evaluate', '--q-table', setting.table(OURS), '--threads', 1, '--csv', 'metrics.csv',
             '--trajectories', 'trajectories', *scenarios_of(setting)],
            [sys.executable, setting.benchmark / SCORER, setting.benchmark / 'scenarios', 'trajectories', '--csv',
             'scored.csv']], cost=20.0))
    return runs


def config_of(setting, model):
    """Returns the training configuration of a model. Those of the thesis's sets learn in one training, in turn with one
    obstacle and with several."""
    own = setting.experiments / f'steering_{model}.yaml'
    return own if own.is_file() else setting.learning(model)


def run_folder(setting, model, seed):
    return setting.run_folder(NAME, f'{model}_{seed:02d}')


def report(setting):
    seeds = setting.seeds(SEEDS)
    models = {model: [read_metrics(run_folder(setting, model, seed) / 'metrics.csv') for seed in seeds]
              for model in LEARNED}
    models.update({model: [read_metrics(setting.benchmark / 'reference.csv', model)] for model in REFERENCES})
    orca = models[ORCA][0]
    chapter = Report(NAME, TEXTS, setting)
    chapter.say('intro', seeds=len(seeds))
    chapter.tabulate('bars', BAR_HEADER, bar_rows(models[OURS], orca, [
        processor_seconds(run_folder(setting, OURS, seed))[0] for seed in seeds]))
    columns = {
        'time / ORCA': (lambda f: time_against(f, orca), 3), 'not slower in': (lambda f: not_slower(f, orca), 0),
        'greatest contact %': (lambda f: f.contact_pct.max(), 2),
        'least clean %': (lambda f: judged(f).clean_pct.min(), 0), 'longest path': (lambda f: f.path_ratio.max(), 3),
        'most turning rad/m': (lambda f: f.turn_rad_per_m.max(), 2)}
    chapter.tabulate('overview', ['', *columns], [spread_row(NAMES[model], columns, found)
                                                  for model, found in models.items()], count=len(judged(orca)))
    add_times(chapter, models, orca)
    for key, (label, decimals) in MEASURES.items():
        chapter.tabulate(key, ['scenario', *(NAMES[model] for model in models)], [
            [scenario, *(spread_text([metrics[key][scenario] for metrics in found], decimals)
                         for found in models.values())] for scenario in orca.index], 'measure', label=label)
    add_score(chapter, setting)
    return chapter


def add_times(chapter, models, orca):
    """Adds time / ORCA's time in every scenario: a mark for each model, a line over the training seeds."""
    scenarios = sorted(orca.index, key=lambda name: Spread(f.time_ratio[name] for f in models[OURS]).mean
                       / orca.time_ratio[name])
    figure, ((panel,),) = style.new_figure(1, 1, 9, 0.9 + 0.3 * len(scenarios))
    places = range(len(scenarios))
    for model, found in models.items():
        if model == ORCA:
            continue
        spreads = [Spread(f.time_ratio[name] / orca.time_ratio[name] for f in found) for name in scenarios]
        look = {'marker': 'o', 'markersize': 7, 'zorder': 6} if model == OURS else {
            'marker': 'd', 'markersize': 5, 'zorder': 4}
        panel.plot([spread.mean for spread in spreads], places, color=COLOURS[model], label=NAMES[model], linestyle='',
                   **look)
        panel.hlines(places, [s.low for s in spreads], [s.high for s in spreads], color=COLOURS[model], linewidth=1)
    panel.axvline(1.0, color=COLOURS[ORCA], linewidth=1.5, label=NAMES[ORCA])
    panel.set_yticks(list(places), scenarios)
    panel.set_xscale('log')
    panel.set_xticks(TICKS, [f'{tick:g}' for tick in TICKS])
    panel.minorticks_off()
    panel.set_xlabel("time / ORCA's time with its parameters picked for the scenario (left: faster)")
    panel.legend(loc='lower right')
    chapter.draw(figure, 'steering_times')


def add_score(chapter, setting):
    if not (setting.benchmark / SCORER).is_file():
        chapter.say('no_scorer')
        return
    folder = setting.run_folder(NAME, 'scored')
    scored = read_metrics(folder / 'scored.csv')
    difference = largest_difference(read_metrics(folder / 'metrics.csv'), scored)
    chapter.tabulate('scorer', ['scenarios', 'metrics compared', 'greatest difference'],
                     [[str(len(scored)), str(scored.size), f'{difference:.1g}']])


class Bar(typing.NamedTuple):
    """An upper or lower limit of a metric, and a stricter limit as an aim; either may be None."""
    label: str
    measure: typing.Callable
    bar: float
    aim: float
    decimals: int = 2
    at_least: bool = False

    def row(self, seeds):
        """Returns the cells of a row: the values of the seeds' metrics, compared with bar and aim."""
        values = [self.measure(metrics) for metrics in seeds]
        worst = min(values) if self.at_least else max(values)
        first, worst = (f'{value:.{self.decimals}f}' for value in (values[0], worst))
        return [self.label, self.limit(self.bar), first, worst, self.met(values, self.bar), self.limit(self.aim),
                self.met(values, self.aim)]

    def limit(self, limit):
        return '' if limit is None else f"{'≥' if self.at_least else '≤'} {limit:.{self.decimals}f}"

    def met(self, values, limit):
        """Returns a text with the number of seeds that meet a limit."""
        if limit is None:
            return ''
        count = sum(value >= limit - SLACK if self.at_least else value <= limit + SLACK for value in values)
        return {len(values): 'all seeds', 0: 'none'}.get(count, f'{count} of {len(values)}')


def bar_rows(seeds, orca, seconds):
    """Returns a row for each bar: requirements and aims for the anticipation crowd, and whether they are met.
    @param seeds metrics of each training seed, seed 1 first
    @param orca metrics that time, path and turning are compared with
    @param seconds processor time of each training [s]"""
    count, turning = len(judged(orca)), judged(orca).turn_rad_per_m
    bars = [
        Bar('contact %, worst scenario', lambda f: f.contact_pct.max(), 0, 0),
        Bar(f'clean %, worst scenario without {EXCLUDED}', lambda f: judged(f).clean_pct.min(), 100, 100, 0,
            at_least=True),
        Bar('clean %, worst scenario', lambda f: f.clean_pct.min(), None, 100, 0, at_least=True),
        Bar(f'clean %, mean without {EXCLUDED}', lambda f: judged(f).clean_pct.mean(), 99, 100, 2, at_least=True),
        Bar(f'scenarios of {count} not slower than ORCA', lambda f: not_slower(f, orca), min(12, count), count, 0,
            at_least=True),
        Bar('time / ORCA, geometric mean', lambda f: time_against(f, orca), 1.0, 0.9, 3),
        Bar('longest path', lambda f: f.path_ratio.max(), 1.12, None, 3),
        Bar("path minus ORCA's, greatest", lambda f: judged(f.path_ratio - orca.path_ratio).max(), None, 0.02, 3),
        Bar(f'turning rad/m, greatest without {EXCLUDED}', lambda f: judged(f).turn_rad_per_m.max(), 1.0, None),
        Bar('turning rad/m, greatest', lambda f: f.turn_rad_per_m.max(), 1.0, None),
        Bar("turning / ORCA's, greatest", lambda f: (f.turn_rad_per_m / turning[turning > 0]).max(), None, 2),
        Bar('fastest tick / maximum speed', lambda f: f.max_speed_ratio.max(), 1.0, 1.0),
    ]
    time = Bar('training, processor time [s]', lambda value: value, 60, 10, 1)
    return [*(bar.row(seeds) for bar in bars), time.row(seconds)]
