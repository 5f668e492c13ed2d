"""The program `crowded_robot`: move_base among a hundred people, on two floors."""
import pathlib
import re
import typing

import numpy
from crowd_experiments.arguments import add_file, parser_of, positive
from crowd_experiments.pages import Chapter, fill_document, require_table
from crowd_experiments.records import read_csv
from crowd_experiments.runs import LOG, Run, execute_left
from crowd_experiments.tools import REPOSITORY
from crowd_recordings.robot_log import read_robot_log
from crowd_robots.driving import DRIVEN

FLOORS = pathlib.Path(__file__).with_name('crowded')
SCENES = {'crowded_hall': 'hall', 'crowded_halls': 'two halls'}
SEEDS = (1, 2, 3)
CHAPTER = 'crowded'  # of documents, whose tables are named after robots
RECORD, LOGS = 'robots.csv', 'logs'  # in a run's folder
LONG = 300.0  # [s] of a run, roughly
ENCOUNTER = 1.0  # between the rims of robot and person, at most [m]
STANDS = 0.05  # speed below which robots and people stand [m/s]
PERCENTILE = 5
NO_PATH = re.compile('failed to produce path')
HEADER = ['floor', 'seed', 'goals', 'time [s]', 'stands [%], longest [s]', 'intimate space [%]', 'contacts',
          'clearance, 5th percentile [m]', 'DWA found no path']
EXAMPLE = '''It needs move_base in the ROS environment, as scripts/drive_robots does. Runs are not repeatable. Completed
runs are kept unless their scenario or its map has changed; the same command continues from there.

example:
  research/crowded_robot --document research/docs/robots.md'''


class Walk(typing.NamedTuple):
    """What a log says of the robot's drive."""
    goals: int  # that were given
    reached: int
    stands: float  # share of the ticks
    longest: float  # time in which it stood [s]
    clearances: list  # least ones of each encounter, while the person walked [m]


def run_of(robot, scene, seed, config, output):
    """Returns the run of a seed; `config` is the folder of move_base's parameters, or None."""
    parameters = [word for folder in [config] if folder for word in ('--config', folder.absolute())]
    command = [REPOSITORY / 'scripts' / 'drive_robots', '--robot', robot, *parameters, '--seed', seed, '--robots-csv',
               RECORD, '--robot-logs', LOGS, FLOORS / f'{scene}.yaml']
    texts = tuple(file.read_text(encoding='utf-8') for file in sorted(pathlib.Path(config).iterdir())) if config else ()
    return Run(output / robot / f'{scene}_{seed}', [command], LONG, texts)


def speeds_of(places, tick):
    """Returns the speed in each tick but the first, of places [tick, 2]."""
    return numpy.linalg.norm(numpy.diff(places, axis=0), axis=1) / tick


def longest_true(flags):
    """Returns the largest number of successive true ones."""
    ends = numpy.flatnonzero(~numpy.concatenate([[False], flags, [False]]))
    return int(numpy.diff(ends).max()) - 1


def encounters_of(rims, walks):
    """Returns the least distances of the rims of robot and person, given those of all ticks and whether the person
    walks in each, of the times in which they are near each other."""
    near = rims < ENCOUNTER
    numbers = numpy.cumsum(near & ~numpy.concatenate([[False], near[:-1]]))
    chosen = near & walks
    return [float(rims[chosen & (numbers == number)].min()) for number in numpy.unique(numbers[chosen])]


def read_walk(file):
    """Returns the Walk of the only episode of a log, in which all people are there all the time."""
    log = read_robot_log(file)
    tick, robot = log.header['tick_duration'], log.header['robots'][0]
    way = numpy.array(log.robots[0])[:, 1:3]
    reached = 0
    for place in way:
        while reached < len(robot['goals']) and (numpy.linalg.norm(place - robot['goals'][reached])
                                                 <= robot['goal_tolerance']):
            reached += 1
    stood = speeds_of(way, tick) < STANDS
    clearances = []
    for person, walk in log.walks.items():
        places = numpy.array(walk)[:, 1:]
        rims = numpy.linalg.norm(places - way, axis=1) - robot['radius'] - log.radii[person]
        clearances += encounters_of(rims[1:], speeds_of(places, tick) >= STANDS)
    return Walk(len(robot['goals']), reached, float(stood.mean()), tick * longest_true(stood), clearances)


def row_of(run, scene, seed):
    record = read_csv(run.folder / RECORD)
    walk = read_walk(run.folder / LOGS / f'{scene}.jsonl')
    output = (run.folder / LOG).read_text(encoding='utf-8', errors='replace')
    has_all = record['success'][0] > 0
    clearance = f'{numpy.percentile(walk.clearances, PERCENTILE):.3f}' if walk.clearances else '-'
    return [SCENES[scene], str(seed), f'{walk.reached} of {walk.goals}',
            f"{record['time_to_reach_goal'][0]:.0f}" if has_all else '-',
            f'{100 * walk.stands:.0f}, {walk.longest:.0f}', f"{record['intimate_space_intrusions'][0]:.0f}",
            f"{record['people_contacts'][0]:.0f}", clearance, str(len(NO_PATH.findall(output)))]


def main(words=None):
    parser = parser_of('crowded_robot', 'Drives a robot to ten goals among a hundred people, 0.33 per square metre, '
                       'on two floors, with move_base through ROS.', EXAMPLE)
    parser.add_argument('--robot', choices=DRIVEN, default='move_base', help='see scripts/drive_robots --help '
                        '(default: %(default)s)')
    add_file(parser, '--config', metavar='FOLDER', help='parameters of move_base (default: config/move_base)')
    parser.add_argument('--seeds', type=positive, nargs='+', default=SEEDS, metavar='S',
                        help=f'of placements (default: {" ".join(map(str, SEEDS))})')
    add_file(parser, '--output', default=pathlib.Path('results/crowded'), metavar='FOLDER',
             help='folder of all results (default: %(default)s)')
    add_file(parser, '--document', metavar='FILE.md', help='also update the table of this document')
    arguments = parser.parse_args(words)
    if arguments.document:
        require_table(arguments.document, f'{CHAPTER}/{arguments.robot}')
    runs = {(scene, seed): run_of(arguments.robot, scene, seed, arguments.config, arguments.output.absolute())
            for scene in SCENES for seed in arguments.seeds}
    execute_left([*runs.values()], 1)
    chapter = Chapter(CHAPTER, 'A robot among a hundred people')
    chapter.add_table('Each run', HEADER, [row_of(run, *key) for key, run in runs.items()], arguments.robot)
    for table in chapter.tables():
        table.print()
    if arguments.document:
        fill_document(arguments.document, [chapter])
    return 0
