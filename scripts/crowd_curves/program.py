"""The program `plot_learning`: learning curves from records and logs of trainings, by windows of episodes."""
import sys
import typing

import numpy
import pandas
from crowd_drawing.errors import InputError, opened
from crowd_drawing.picture import colours_of
from crowd_experiments.arguments import add_file, labelled, parser_of, positive
from crowd_experiments.records import mean_interval, read_csv, t_quantile
from crowd_experiments.style import new_figure, save
from matplotlib.ticker import MaxNLocator

EPISODE, SCENARIO = 'episode', 'scenario'
WINDOWS = 50  # by default
MOST_EPISODES = 10**9  # of a training
MOST_COLUMNS, PANEL, LEGEND_LINE = 3, (3.9, 2.9), 0.22  # of panels; sizes [inch]
EXAMPLES = '''examples:
  for seed in 1 2 3; do rosrun social_crowd train config/learning/anticipation.yaml --seed $seed \\
      --output table_$seed.txt --log learning_$seed.csv; done
  plot_learning learning_*.csv --output learning.png
  plot_learning small=a_1.csv small=a_2.csv small=a_3.csv large=b_1.csv large=b_2.csv large=b_3.csv \\
      --output comparison.png

A curve is the mean over the runs of a label, in windows of episodes; the band is the 95 % confidence interval of the
mean (Student's t). A single run has no band, and that of two runs is too wide to be of use. Trainings may still run: a
row that is not complete yet is left out.'''


class Run(typing.NamedTuple):
    """The numbers of a record or log of one training, with a row for every agent or every episode."""
    label: str  # of the group of runs that it belongs to
    file: str
    columns: pandas.DataFrame
    scenarios: tuple = ()  # of its rows, in alphabetical order; empty without such a column


class Band(typing.NamedTuple):
    """The mean over runs in each window of episodes, with its 95 % confidence interval; nan where that is unknown."""
    label: str
    runs: int
    episodes: numpy.ndarray  # at the end of each window
    mean: numpy.ndarray
    low: numpy.ndarray
    high: numpy.ndarray


def read_run(label, file, scenario=None, grows=False):
    """Reads a record or log of `train`, maybe of one scenario. `grows`: see read_csv(). Raises InputError, OSError."""
    with opened(file) as stream:
        if EPISODE not in next(stream, '').rstrip('\r\n').split(','):
            raise InputError(f'{file}:1: expected a record of `train --record` or a log of `train --log`, with a '
                             f"column '{EPISODE}'")
    rows = pandas.DataFrame(read_csv(file, grows))
    wrong = rows[EPISODE][~(rows[EPISODE].between(0, MOST_EPISODES) & (rows[EPISODE] % 1 == 0))]
    for row, number in wrong.items():
        raise InputError(f"{file}:{row + 2}: expected a whole number in the column '{EPISODE}', got '{number:g}'")
    scenarios = sorted(set(rows.get(SCENARIO, ())))
    if scenario is not None and scenarios:
        rows = rows[rows[SCENARIO] == scenario]
    if rows.empty:
        raise InputError(f'{file}: has no rows' + ('' if scenario is None else
                         f" of a scenario '{scenario}'; there are {', '.join(scenarios)}"))
    return Run(label, file, rows.select_dtypes('number'), tuple(scenarios) if scenario is None else (scenario,))


def window_means(run, column, window):
    """Returns the mean of the finite values of a column in each window of episodes; nan where there are none."""
    windows = (run.columns[EPISODE] // window).astype(int)
    values = run.columns[column].where(numpy.isfinite(run.columns[column]))
    return values.groupby(windows).mean().reindex(range(windows.max() + 1)).to_numpy()


def episodes_of(runs):
    """Returns the number of episodes of the longest run."""
    return int(max(run.columns[EPISODE].max() + 1 for run in runs))


def default_window(runs):
    """Returns a number of episodes for which a curve has about fifty points."""
    return max(1, round(episodes_of(runs) / WINDOWS))


def band_of(label, runs, column, window):
    """Returns the Band of a column over runs. In windows that not all runs have reached, it is that of the others."""
    curves = pandas.DataFrame([window_means(run, column, window).tolist() for run in runs])
    points = numpy.array([mean_interval(values.dropna()) for _, values in curves.items()])
    episodes = numpy.minimum(window * numpy.arange(1, len(points) + 1), episodes_of(runs))
    return Band(label, len(runs), episodes, *points.T)


class Measure(typing.NamedTuple):
    """A column of a record as it is drawn."""
    column: str
    title: str
    factor: float = 1.0
    limits: tuple = (None, None)  # of the axis
    range: tuple = (-numpy.inf, numpy.inf)  # of the shown values, which confidence intervals do not leave

    def shown(self, band):
        """Returns mean, low and high end of a Band in the shown unit."""
        return [numpy.clip(self.factor * values, *self.range) for values in (band.mean, band.low, band.high)]


FROM_ZERO = {'limits': (0, None), 'range': (0, numpy.inf)}
PERCENT = {'factor': 100.0, 'limits': (-3, 103), 'range': (0, 100)}
# Those whose columns the records have are drawn.
MEASURES = [
    *(Measure(column, f'{title} [%]', **PERCENT) for column, title in (
        ('arrived', 'success'), ('touched', 'contact'), ('collided', 'collision'),
        ('success', 'success'), ('contact', 'contact'), ('collision', 'collision'))),
    Measure('reward', 'reward'),
    Measure('visited_rows', 'visited rows', **FROM_ZERO),
    Measure('epsilon', 'epsilon', **FROM_ZERO),
    Measure('ticks', 'decisions in an episode', **FROM_ZERO),
    Measure('gain_per_tick', 'distance gained [m a decision]'),
    Measure('turn_per_metre', 'turning [rad/m]', **FROM_ZERO),
]


def measures_of(runs, columns=None):
    """Returns the Measures that all runs have, or those of the given columns, in their order."""
    if columns is None:
        return [measure for measure in MEASURES if all(measure.column in run.columns for run in runs)]
    known = {measure.column: measure for measure in MEASURES}
    return [known.get(column, Measure(column, column)) for column in columns]


def draw_curves(file, runs, measures, window, title=''):
    """Draws a panel for each measure, with a curve and a band for each label of runs. Returns the file."""
    labels = list(dict.fromkeys(run.label for run in runs))
    columns = min(MOST_COLUMNS, len(measures))
    rows = -(-len(measures) // columns)
    heights = [PANEL[1]] * rows + [LEGEND_LINE * len(labels) + 0.4]
    figure, axes = new_figure(rows + 1, columns, PANEL[0] * columns, sum(heights),
                              gridspec_kw={'height_ratios': heights})
    for panel, measure in zip(axes.flat, measures):
        for label, colour in zip(labels, colours_of(len(labels))):
            band = band_of(label, [run for run in runs if run.label == label], measure.column, window)
            noun = 'run' if band.runs == 1 else 'runs'
            mean, low, high = measure.shown(band)
            panel.plot(band.episodes, mean, color=colour, linewidth=1.5, marker='o' if len(mean) == 1 else None,
                       label=f'{label}, {band.runs} {noun}' if label else f'{band.runs} {noun}')
            panel.fill_between(band.episodes, low, high, color=colour, alpha=0.2, linewidth=0)
        panel.set(title=measure.title, xlabel='episode')
        panel.set_xlim(left=0)
        panel.xaxis.set_major_locator(MaxNLocator(5, integer=True))
        panel.set_ylim(*measure.limits)
    for panel in list(axes.flat)[len(measures):]:
        panel.set_axis_off()
    below = axes[-1, 0].legend(*axes.flat[0].get_legend_handles_labels(), loc='upper left',
                               frameon=False)
    below.set_in_layout(False)  # it may be wider than the panel above it
    if title:
        figure.suptitle(title, fontsize=12)
    return save(figure, file)


def measures_for(arguments, runs):
    columns = arguments.columns.split(',') if arguments.columns else None
    for column in columns or []:
        for run in runs:
            if column not in run.columns:
                raise InputError(f"{run.file}: has no column '{column}'; there are {', '.join(run.columns)}")
    measures = measures_of(runs, columns)
    if not measures:
        raise InputError('the files have no common column to draw; name some with --columns')
    return measures


def hints(groups):
    """Returns texts about curves that can be misread, given the runs of each label."""
    found = []
    mixed = {run.scenarios for runs in groups.values() for run in runs if len(run.scenarios) > 1}
    for scenarios in sorted(mixed):
        found.append(f"curves are means over {len(scenarios)} scenarios ({', '.join(scenarios)}): choose one with "
                     '--scenario, or draw a curve for each with --each-scenario')
    if any(len(runs) == 2 for runs in groups.values()):
        found.append(f'the band of two runs is {t_quantile(1):.3g} standard errors wide on each side, that of three '
                     f'{t_quantile(2):.2g}: train with more seeds')
    return found


def main(words=None):
    """Reads the files of the command line, draws the curves, and prints the last point of each."""
    parser = parser_of('plot_learning',
                       'Draws learning curves over several seeds, from logs of `train --log` or records '
                       'of `train --record`.', EXAMPLES)
    parser.add_argument('records', nargs='+', metavar='[LABEL=]CSV', help='a log or record for each run; runs with the '
                        'same label are one curve')
    add_file(parser, '--output', required=True, help='picture, such as learning.png, .svg or .pdf')
    parser.add_argument('--window', type=positive, metavar='N',
                        help='number of episodes in a point of a curve, at most all (default: a fiftieth of all)')
    parser.add_argument('--columns', metavar='NAME,...', help='columns of the records that are drawn (default: '
                        'success, contact, collision and others, as far as the records have them)')
    which = parser.add_mutually_exclusive_group()
    which.add_argument('--scenario', metavar='NAME', help='only episodes of this scenario')
    which.add_argument('--each-scenario', action='store_true', help='a curve for each scenario (default: all together)')
    parser.add_argument('--title', default='', help='title of the picture')
    arguments = parser.parse_args(words)
    named = [labelled(word) for word in arguments.records]
    runs = [read_run(label or '', file, arguments.scenario, grows=True) for label, file in named]
    if arguments.each_scenario:
        runs = [part for run in runs for part in [
            read_run(f'{run.label} {scenario}'.strip(), run.file, scenario, grows=True) for scenario in run.scenarios
        ] or [run]]
    measures, window = measures_for(arguments, runs), arguments.window or default_window(runs)
    if window > episodes_of(runs):
        raise InputError(f'--window: expected at most {episodes_of(runs)}, the number of episodes, got {window}')
    draw_curves(arguments.output, runs, measures, window, arguments.title)
    groups = {label: [run for run in runs if run.label == label] for label in dict.fromkeys(run.label for run in runs)}
    print(f'{arguments.output}: the last {window} of the episodes, mean (95 % confidence interval):')
    for label, group in groups.items():
        for measure in measures:
            band = band_of(label, group, measure.column, window)
            mean, low, high = (values[-1] for values in measure.shown(band))
            spread = f'{low:.4g} to {high:.4g}' if band.runs > 1 else 'one run'
            print(f"  {label + ', ' if label else ''}{measure.title}: {mean:.4g} ({spread})", flush=True)
    for hint in hints(groups):
        print(f'plot_learning: {hint}', file=sys.stderr)
