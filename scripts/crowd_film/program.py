"""The program `film`."""
import pathlib
import tempfile

from crowd_drawing.errors import check_output
from crowd_experiments.arguments import above_zero, add_file, add_tools, at_least_zero, parser_of, pixels, whole
from crowd_experiments.tools import find_tools
from crowd_film.pictures import need_ffmpeg
from crowd_film.production import MEGABYTE, Settings, WRITERS, make, table_for, walk
from crowd_recordings.shown import read_shown

EXAMPLES = '''examples:
  film place_station --start 20 --duration 40 --output station.gif
  film place_office --speed 8 --max-size 3 --output office.webp
  film circle6 --trajectories recordings/circle6.csv --output circle6.mp4
  film --trajectories obsmat.txt --duration 60 --output people.gif

One episode is walked with `evaluate`, or a recording of `evaluate --trajectories` is shown. MP4 needs ffmpeg.
Robots are shown at their start. Exit status: 0 success, 1 an error, 2 wrong usage, 130 interrupted.'''


def parser():
    """Returns the parser of the command line."""
    result = parser_of('film', 'Makes a film of a scenario: GIF, WebP or MP4. Needs neither a display nor ROS running.',
                       EXAMPLES)
    add = result.add_argument
    add('scenario', nargs='?', metavar='SCENARIO', help='a scenario file, or a name in config/scenarios; not required '
        'with --trajectories')
    add_file(result, '--output', required=True, help='FILE.gif, FILE.webp or FILE.mp4')
    add_file(result, '--q-table', help='Q-table (default: human for scenarios place_*, else anticipation)')
    add('--seed', type=whole, metavar='N', help='seed of the episode (default: 1)')
    add_file(result, '--trajectories', help="show this recording: CSV of evaluate, JuPedSim's text format, or "
                                            "obsmat.txt")
    add('--frame-rate', type=above_zero, metavar='HZ', help='of the recording, in place of that in the file')
    add('--instance', type=whole, metavar='N', help='episode of the recording (default: the first)')
    add('--start', type=at_least_zero, default=0.0, metavar='S', help='simulated time of the first frame [s]')
    add('--duration', type=above_zero, default=float('inf'), metavar='S',
        help='simulated time that is shown [s] (default: to the end)')
    add('--speed', type=above_zero, default=Settings.speed, metavar='X',
        help='simulated seconds in a second of the film (default: %(default)g)')
    add('--fps', type=above_zero, default=Settings.fps, metavar='N',
        help='frames in a second of the film (default: %(default)g); a GIF has at most 100')
    add('--size', type=pixels, default=Settings.size, metavar='N', help='longer side [pixels] (default: %(default)d)')
    add('--view', type=float, nargs=4, metavar=('X0', 'Y0', 'X1', 'Y1'), help='part of the scene that is shown [m]')
    add('--max-size', type=above_zero, default=float('inf'), metavar='MB',
        help='greatest size of the file [MB]; a larger film is made again with fewer pixels')
    add('--title', help="title of the film (default: the scenario's name)")
    add_tools(result, 'evaluate')
    return result


def produce(arguments):
    """Reads or walks the episode, and makes the film."""
    check_output(arguments.output)
    if arguments.output.suffix.lower() == '.mp4':
        need_ffmpeg()
    if arguments.trajectories:
        scene, tracks, _ = read_shown(arguments.trajectories, arguments.scenario, arguments.instance,
                                      arguments.frame_rate)
    else:
        with tempfile.TemporaryDirectory(prefix='social_crowd_') as folder:
            table = arguments.q_table or table_for(arguments.scenario)
            seed = 1 if arguments.seed is None else arguments.seed
            scene, tracks = walk(arguments.scenario, find_tools(arguments.tools) / 'evaluate', table, seed,
                                 pathlib.Path(folder))
    title = (scene.name or arguments.trajectories.stem) if arguments.title is None else arguments.title
    settings = Settings(arguments.output, title, arguments.start, arguments.duration, arguments.speed, arguments.fps,
                        arguments.size, arguments.max_size, arguments.view)
    width, height, frames = make(settings, scene, tracks)
    megabytes = arguments.output.stat().st_size / MEGABYTE
    print(f'{arguments.output}: {frames} frames of {width} x {height} pixels, {megabytes:.2f} MB')


def main(words=None):
    """Runs the program with command line words."""
    checked = parser()
    arguments = checked.parse_args(words)
    if arguments.view and not (arguments.view[0] < arguments.view[2] and arguments.view[1] < arguments.view[3]):
        checked.error('--view: expected X0 < X1 and Y0 < Y1')
    if arguments.output.suffix.lower() not in WRITERS:
        checked.error(f"--output: expected a name with {', '.join(WRITERS)}, got '{arguments.output}'")
    if not (arguments.scenario or arguments.trajectories):
        checked.error('expected a SCENARIO or --trajectories')
    for name, value in (('--q-table', arguments.q_table), ('--seed', arguments.seed)):
        if arguments.trajectories and value is not None:
            checked.error(f'{name}: a recording is not walked again; expected either {name} or --trajectories')
    try:
        produce(arguments)
    except KeyboardInterrupt:
        raise KeyboardInterrupt(', nothing was written') from None
