"""What a program shows: an episode that `evaluate` walks, or a recording; the options that say which."""
import pathlib
import sys
import tempfile

from crowd_drawing.files import find_scenario
from crowd_experiments.arguments import above_zero, add_file, add_tools, at_least_zero, whole
from crowd_experiments.runs import output_of
from crowd_experiments.tools import find_config, find_tools
from crowd_recordings.formats import read_shown

ROBOT = 'reactive'  # controller of robots


def add_source(parser):
    """Adds the options for read_source(), and those of the part that is shown."""
    add = parser.add_argument
    add('scenario', nargs='?', metavar='SCENARIO', help='a scenario file, or a name in config/scenarios; not required '
        'with --trajectories')
    add_file(parser, '--q-table', help='Q-table (default: human for scenarios place_*, else anticipation)')
    add('--seed', type=whole, metavar='N', help='seed of the episode (default: 1)')
    add('--robot', metavar='CONTROLLER', help=f'of robots, see evaluate --help (default: {ROBOT})')
    add_file(parser, '--trajectories', help="show this recording: CSV of evaluate, its --robot-log, JuPedSim's text "
                                            "format, or obsmat.txt")
    add('--frame-rate', type=above_zero, metavar='HZ', help='of the recording, in place of that in the file')
    add('--instance', type=whole, metavar='N', help='episode of the recording (default: the first)')
    add('--start', type=at_least_zero, default=0.0, metavar='S', help='simulated time of the first frame [s]')
    add('--duration', type=above_zero, default=float('inf'), metavar='S',
        help='simulated time that is shown [s] (default: to the end)')
    add_tools(parser, 'evaluate')


def check_source(parser, arguments):
    """Ends the program if there is no source, or if options contradict each other."""
    if not (arguments.scenario or arguments.trajectories):
        parser.error('expected a SCENARIO or --trajectories')
    for name, value in (('--q-table', arguments.q_table), ('--seed', arguments.seed), ('--robot', arguments.robot)):
        if arguments.trajectories and value is not None:
            parser.error(f'{name}: a recording is not walked again; expected either {name} or --trajectories')


def read_source(arguments, program):
    """Returns the Scene, and the Tracks by agent. Raises InputError, OSError."""
    if arguments.trajectories:
        return read_shown(arguments.trajectories, arguments.scenario, arguments.instance, arguments.frame_rate)[:2]
    with tempfile.TemporaryDirectory(prefix='social_crowd_') as folder:
        is_place = pathlib.Path(arguments.scenario).stem.startswith('place_')  # as in demo.launch
        table = find_config() / 'q_tables' / ('human.txt' if is_place else 'anticipation.txt')
        seed = 1 if arguments.seed is None else arguments.seed
        return walk(arguments.scenario, find_tools(arguments.tools) / 'evaluate', arguments.q_table or table, seed,
                    arguments.robot or ROBOT, pathlib.Path(folder), program)


def walk(scenario, evaluate, table, seed, robot, folder, program):
    """Walks one episode with `evaluate`, with a controller of its robots. Returns the scene as drawn, and the Tracks by
    agent. Raises RunError."""
    file = pathlib.Path(find_scenario(scenario)).resolve()
    print(f'{program}: walking {file.stem}', file=sys.stderr, flush=True)
    log = folder / 'log.jsonl'
    output_of([evaluate, '--q-table', table, '--episodes', 1, '--seed', seed, '--trajectories', folder, '--scenes',
               folder, '--robot', robot, '--robot-log', log, file])
    has_robots = log.is_file() and log.stat().st_size > 0
    return read_shown(log if has_robots else folder / f'{file.stem}.csv', folder / file.name)[:2]
