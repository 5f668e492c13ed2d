"""The program `plot_learning`."""
import argparse
import csv
import pathlib
import sys

from crowd_curves.bands import band_of, default_window
from crowd_curves.drawing import draw_curves, measures_of
from crowd_curves.records import read_run
from crowd_drawing.errors import InputError
from crowd_experiments.labels import labelled
from crowd_experiments.numbers import positive

EXAMPLES = '''examples:
  for seed in 1 2 3; do rosrun social_crowd train config/learning/anticipation.yaml --seed $seed \\
      --output table_$seed.txt --record learning_$seed.csv; done
  plot_learning learning_*.csv --output learning.png
  plot_learning small=a_1.csv small=a_2.csv large=b_1.csv large=b_2.csv --output comparison.png

A curve is the mean over the runs of a label, in windows of episodes; the band is the 95 % confidence interval of the
mean (Student's t). A single run has no band. Exit status: 0 success, 1 an error, 2 wrong usage, 130 interrupted.'''


def parser():
    """Returns the parser of the command line."""
    result = argparse.ArgumentParser(prog='plot_learning', description='Draws learning curves over several seeds, from '
                                     'records of `train --record`.', epilog=EXAMPLES,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    result.add_argument('records', nargs='+', metavar='[LABEL=]CSV', help='a record for each run; runs with the same '
                        'label are one curve')
    result.add_argument('--output', type=pathlib.Path, required=True, metavar='FILE',
                        help='picture, such as learning.png, .svg or .pdf')
    result.add_argument('--window', type=positive, metavar='N',
                        help='number of episodes in a point of a curve (default: a fiftieth of all)')
    result.add_argument('--columns', metavar='NAME,...', help='columns of the records that are drawn (default: '
                        'success, contact, collision and others, as far as the records have them)')
    result.add_argument('--scenario', metavar='NAME', help='only episodes of this scenario')
    result.add_argument('--title', default='', help='title of the picture')
    return result


def plot(arguments):
    """Reads the records, draws the curves, and prints the last point of each."""
    named = [labelled(word) for word in arguments.records]
    runs = [read_run(label or '', file, arguments.scenario) for label, file in named]
    columns = arguments.columns.split(',') if arguments.columns else None
    for column in columns or []:
        for run in runs:
            if column not in run.columns:
                raise InputError(f"{run.file}: has no column '{column}'; there are {', '.join(run.columns)}")
    measures, window = measures_of(runs, columns), arguments.window or default_window(runs)
    if not measures:
        raise InputError('the records have no common column to draw; name some with --columns')
    draw_curves(arguments.output, runs, measures, window, arguments.title)
    print(f'{arguments.output}: the last {window} of the episodes, mean (95 % confidence interval):')
    for label in dict.fromkeys(run.label for run in runs):
        for measure in measures:
            band = band_of(label, [run for run in runs if run.label == label], measure.column, window)
            mean, low, high = (values[-1] for values in measure.shown(band))
            spread = f'{low:.4g} to {high:.4g}' if band.runs > 1 else 'one run'
            print(f"  {label + ', ' if label else ''}{measure.title}: {mean:.4g} ({spread})")


def main(words=None):
    """Runs the program with command line words. Returns the exit status."""
    arguments = parser().parse_args(words)
    try:
        plot(arguments)
    except OSError as error:
        print(f'plot_learning: {error.filename or arguments.output}: {error.strerror or error}', file=sys.stderr)
        return 1
    except (InputError, ValueError, csv.Error) as error:
        print(f'plot_learning: {error}', file=sys.stderr)
        return 1
    return 0
