"""The program `convert_trajectories`."""
import math

from crowd_drawing.files import DEFAULT_TICK
from crowd_drawing.errors import check_output
from crowd_experiments.arguments import above_zero, add_file, parser_of, whole
from crowd_recordings.formats import WRITTEN, read_recording, write_recording

EXAMPLES = '''examples:
  convert_trajectories recordings/circle6.csv --output circle6.txt      for PedPy and JuPedSim
  convert_trajectories obsmat.txt --output people.csv                   for plot_paths; film needs --frame-rate 2.5

A CSV file has no frame rate: give it with --frame-rate, unless it is 10 Hz (a tick of 0.1 s).
Exit status: 0 success, 1 an error, 2 wrong usage, 130 interrupted.'''


def parser():
    """Returns the parser of the command line."""
    result = parser_of('convert_trajectories',
                       "Converts recorded trajectories: CSV files of `evaluate --trajectories`, "
                       "JuPedSim's text format, and obsmat.txt of the ETH and UCY data sets (input only).", EXAMPLES)
    result.add_argument('input', metavar='IN', help='a recording; its format is recognised')
    add_file(result, '--output', required=True, metavar='OUT', help="OUT.csv, or OUT.txt in JuPedSim's format")
    result.add_argument('--instance', type=whole, metavar='N', help='episode of a CSV file (default: the first)')
    result.add_argument('--frame-rate', type=above_zero, metavar='HZ',
                        help='frames in a second, in place of that of IN (CSV: 10; obsmat.txt: 2.5)')
    return result


def main(words=None):
    """Runs the program with command line words."""
    checked = parser()
    arguments = checked.parse_args(words)
    if arguments.output.suffix.lower() not in WRITTEN:
        checked.error(f"--output: expected a name with {' or '.join(WRITTEN)}, got '{arguments.output}'")
    check_output(arguments.output)
    recording = read_recording(arguments.input, arguments.instance).at_rate(arguments.frame_rate)
    if recording.frame_duration is None:
        recording = recording.at_rate(1 / DEFAULT_TICK)
    write_recording(arguments.output, recording)
    rows = sum(map(len, recording.walks.values()))
    people = '1 person' if len(recording.walks) == 1 else f'{len(recording.walks)} people'
    print(f'{arguments.output}: {people}, {rows} positions, '
          f'{1 / recording.frame_duration:g} frames a second')
    if arguments.output.suffix.lower() == '.csv' and not math.isclose(recording.frame_duration, DEFAULT_TICK):
        print(f'A CSV file has no frame rate: give --frame-rate {1 / recording.frame_duration:g} to programs that read '
              'it.')
