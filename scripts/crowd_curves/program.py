"""The program `plot_learning`."""
import sys

from crowd_curves.curves import band_of, by_scenario, default_window, draw_curves, episodes_of, measures_of, read_run
from crowd_drawing.errors import InputError
from crowd_experiments.arguments import add_file, labelled, parser_of, positive
from crowd_experiments.records import t_quantile

EXAMPLES = '''examples:
  for seed in 1 2 3; do rosrun social_crowd train config/learning/anticipation.yaml --seed $seed \\
      --output table_$seed.txt --log learning_$seed.csv; done
  plot_learning learning_*.csv --output learning.png
  plot_learning small=a_1.csv small=a_2.csv small=a_3.csv large=b_1.csv large=b_2.csv large=b_3.csv \\
      --output comparison.png

A curve is the mean over the runs of a label, in windows of episodes; the band is the 95 % confidence interval of the
mean (Student's t). A single run has no band, and that of two runs is too wide to be of use. Trainings may still run: a
row that is not complete yet is left out.'''


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
        runs = [part for run in runs for part in by_scenario(run)]
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
