"""The program `realism`: replaces recorded people by simulated ones, and compares how both walk."""
import functools
import pathlib
import shutil
import sys
import tempfile

import numpy
import pandas
from crowd_drawing.errors import InputError, check_output, replaced
from crowd_drawing.files import DEFAULT_TICK
from crowd_experiments.arguments import above_zero, add_file, add_tools, parser_of, whole
from crowd_experiments.records import read_table_header
from crowd_experiments.tools import find_table, find_tools
from crowd_recordings.formats import read_recording
from crowd_tables.gait import without_gait

from . import peers
from .crowds import Crowd, walk_all
from .drawing import draw_distributions, draw_examples
from .forecasts import task_of, walk_straight
from .measures import FIGURES, errors_of, figures_of, ks_distance
from .people import moments_of, noise_of, walkers_of, with_noise

EXAMPLES = '''examples:
  realism obsmat.txt --replace all --plot distributions.png
  realism obsmat.txt --replace one --csv predictions.csv --plot examples.png

--replace all: every recorded walker is replaced by an agent with the same entry, exit, time and free speed. Printed are
the 10th, 50th and 90th percentiles of figures of walkers, the Kolmogorov-Smirnov distance of both distributions (0:
equal, 1: apart), the same with errors in the simulated places like those in the recorded ones, and the distance of the
two halves of the recording as its floor.
--replace one: everybody in view is predicted for 4.8 s from 3.2 s. Printed are the metrics of TrajNet++ of each model:
mean and final displacement error [m], and collisions with predicted (Col-I) and recorded others (Col-II) [%].
`velocity` is that of the last observed step, or a weighted mean of all; `goal` is far ahead, or the true one, which no
prediction can know. Models of other packages take part if rvo2 and jupedsim are installed for this Python.'''
PERCENTILES = (10, 50, 90)
REFERENCE = 'constant velocity'


def say(text):
    print(f'realism: {text}', file=sys.stderr, flush=True)


def replace_all(arguments, recording, evaluate, folder):
    """Returns the table of distributions."""
    walkers = walkers_of(recording)
    say(f'simulating {len(walkers)} walkers')
    agents = walk_all(walkers, evaluate, arguments.q_table, arguments.radius, folder)
    recorded, simulated, half = figures_of(walkers), figures_of(agents), len(walkers) // 2
    noise = noise_of(walkers)
    noisy = figures_of(with_noise(agents, noise))
    say(f'errors in the recorded places: {noise:.3f} m')
    halves = [figures_of(walkers[:half]), figures_of(walkers[half:])]
    floors = {name: ks_distance(*(figures[name] for figures in halves)) for name in FIGURES}
    rows = []
    for name in FIGURES:
        row = {'figure': name}
        for whose, values in (('recorded', recorded[name]), ('simulated', simulated[name])):
            shares = numpy.percentile(values, PERCENTILES) if len(values) else [numpy.nan] * len(PERCENTILES)
            row.update({f'{whose} {share} %': value for share, value in zip(PERCENTILES, shares)})
        distances = [ks_distance(recorded[name], figures[name]) for figures in (simulated, noisy)]
        rows.append({**row, 'KS': distances[0], 'KS with noise': distances[1], 'floor': floors[name]})
    if arguments.trajectories:
        with replaced(arguments.trajectories) as part:
            shutil.copyfile(folder / 'replaced.csv', part)
    if arguments.plot:
        draw_distributions(arguments.plot, recorded, simulated, floors,
                           f'{len(walkers)} walkers, recorded and replaced by {arguments.q_table.stem}')
    return pandas.DataFrame(rows)


def models_of(arguments, evaluate, folder):
    """Returns functions from Tasks to predictions, by the names of the models."""
    table, radius = arguments.q_table, arguments.radius
    models = {REFERENCE: walk_straight}
    for name, model in peers.installed().items():
        models[name] = functools.partial(model, radius=radius)
    models[table.stem] = Crowd(evaluate, table, radius, folder).predict
    if arguments.has_gait:
        calm = folder / table.name
        calm.write_bytes(without_gait(table.read_bytes()))
        models[f'{table.stem}, no gait'] = Crowd(evaluate, calm, radius, folder).predict
    return models


def replace_one(arguments, recording, evaluate, folder):
    """Returns the table of predictions."""
    moments, models = moments_of(recording), models_of(arguments, evaluate, folder)
    rows, shown = [], {}
    for velocity, share, goal in (('last', 1.0, 'ahead'), ('weighted', arguments.free_speed, 'ahead'),
                                  ('weighted', arguments.free_speed, 'true')):
        tasks = [task_of(moment, velocity, share, goal == 'true') for moment in moments]
        for name, predict in models.items():
            say(f'{name}, velocity: {velocity}, goal: {goal}')
            predictions = predict(tasks)
            rows.append({'model': name, 'velocity': velocity, 'goal': goal, **errors_of(moments, predictions)})
            if (velocity, goal) == (('last' if name == REFERENCE else 'weighted'), 'ahead'):
                shown[name] = predictions
    if arguments.plot:
        name = list(models)[-1]
        draw_examples(arguments.plot, moments, shown[REFERENCE], shown[name],
                      f'{rows[0]["windows"]} windows: examples from good to bad, of {name}')
    return pandas.DataFrame(rows)


def main(words=None):
    parser = parser_of('realism', 'Replaces recorded people by simulated ones, and compares how both walk.', EXAMPLES)
    add = parser.add_argument
    add('recording', metavar='RECORDING', help="obsmat.txt, JuPedSim's text format, or a CSV file of evaluate")
    add('--replace', choices=('all', 'one'), default='all', help='all walkers at once, or everybody in a window of 8 s '
        '(default: %(default)s)')
    add('--q-table', default='human', metavar='FILE', help='a Q-table, or a name in config/q_tables (default: human)')
    add('--frame-rate', type=above_zero, metavar='HZ', help='of the recording, in place of that in the file')
    add('--instance', type=whole, metavar='N', help='episode of a CSV file (default: the first)')
    add('--radius', type=above_zero, default=0.1, metavar='M', help='of agents [m] (default: %(default)g); bodies of '
        'recorded people overlap at 0.25')
    add('--free-speed', type=above_zero, default=0.98, metavar='SHARE', help='with --replace one: free speed, a share '
        'of the estimated one (default: %(default)g)')
    for name, of in (('--csv', 'the printed table'), ('--json', 'the printed table'), ('--plot', 'a picture'),
                     ('--trajectories', 'the simulated crowd of --replace all, CSV, for film')):
        add_file(parser, name, help=of)
    add_tools(parser, 'evaluate')
    arguments = parser.parse_args(words)
    if arguments.trajectories and arguments.replace == 'one':
        parser.error('--trajectories: expected --replace all')
    for file in filter(None, (arguments.csv, arguments.json, arguments.plot, arguments.trajectories)):
        check_output(file)
    arguments.q_table = find_table(arguments.q_table)
    arguments.has_gait = 'gait' in read_table_header(arguments.q_table).get('action_set', '')
    recording = read_recording(arguments.recording, arguments.instance).at_rate(arguments.frame_rate)
    if recording.frame_duration is None:
        recording = recording.at_rate(1 / DEFAULT_TICK)
    evaluate = find_tools(arguments.tools) / 'evaluate'
    with tempfile.TemporaryDirectory(prefix='social_crowd_') as folder:
        try:
            replace = replace_all if arguments.replace == 'all' else replace_one
            table = replace(arguments, recording, evaluate, pathlib.Path(folder))
        except InputError as error:
            raise InputError(f'{arguments.recording}: {error}') from None
    print(table.to_string(index=False, float_format='{:.3f}'.format))
    for file, write in ((arguments.csv, lambda part: table.to_csv(part, index=False)),
                        (arguments.json, lambda part: table.to_json(part, orient='records', indent=1))):
        if file:
            with replaced(file) as part:
                write(part)
