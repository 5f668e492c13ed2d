"""The command line of scripts/drive_robots: `evaluate --robot` for robots that move_base drives."""
import os
import pathlib
import shutil
import subprocess
import sys

import numpy
from crowd_drawing.errors import flush_to_disk, read_documents
from crowd_drawing.files import find_scenario
from crowd_experiments.arguments import add_file, parser_of, positive
from crowd_experiments.interruption import EXIT_FINE, EXIT_INTERRUPTED
from crowd_experiments.pages import Table
from crowd_experiments.records import read_csv
from crowd_experiments.runs import RunError
from crowd_launching.program import Program, free_port

# Robots that are driven through ROS, and their arguments of robot_lab.launch.
DRIVEN = {'move_base': {'navigation': 'move_base'},
          'move_base_people': {'navigation': 'move_base', 'people_layer': True}}
# Scenes that are driven if none is named.
SCENES = ('robot_frontal', 'robot_overtaking', 'robot_corridor_against', 'robot_crossing', 'robot_intersection',
          'robot_blind_corner', 'robot_door', 'robot_obstruction', 'robot_crowd_10', 'robot_circle_20')
# Arguments of robot_lab.launch that are options here.
RECORDINGS = {'robot_series': 'time series', 'robot_logs': 'logs for learned metrics'}
EXAMPLES = '''examples:
  scripts/drive_robots --config my_move_base --robots-csv mine.csv     your configuration in ten scenes
  scripts/drive_robots --robot move_base --episodes 5 --robots-csv /tmp/robots.csv robot_hall

It starts a ROS master of its own and robot_lab.launch, as fast as possible, for one scenario after the other. The first
episode is restarted when move_base has sent its first command. move_base and its planners have to be in the ROS
environment; for move_base_people the package has to be built where costmap_2d is.

FOLDER of --config has the files of config/move_base, with your parameters. FILE of --robots-csv is written when all
episodes are recorded, and the results are printed.'''


def require_robots(scenario):
    """Checks that a scenario file has robots, before it is started. Returns their number."""
    document = (read_documents(scenario) or [None])[0]
    robots = document.get('robots') if isinstance(document, dict) else None
    if not isinstance(robots, list) or not robots:
        raise RunError(f'{scenario}: expected a scenario with robots')
    return len(robots)


def main(words=None):
    parser = parser_of('drive_robots', 'Drives the robots of scenarios through ROS and writes their results as '
                       '`evaluate --robots-csv` does.', EXAMPLES, '0 success, 1 not all episodes were recorded or an '
                       'input is wrong, 2 wrong usage, 130 interrupted.')
    parser.add_argument('--robot', choices=DRIVEN, default='move_base',
                        help='move_base with DWA, or also with the costs of PeopleLayer (default: %(default)s)')
    add_file(parser, '--config', metavar='FOLDER', help='parameters of move_base (default: config/move_base)')
    parser.add_argument('--episodes', type=positive, default=1, metavar='N',
                        help='of each scenario (default: %(default)s)')
    parser.add_argument('--seed', type=int, default=1, metavar='S', help='of placements (default: %(default)s)')
    add_file(parser, '--q-table', help='of the people (default: anticipation)')
    add_file(parser, '--robots-csv', required=True, help='results of the robots')
    for kind, what in RECORDINGS.items():
        add_file(parser, f'--{kind.replace("_", "-")}', metavar='FOLDER', help=f'folder for {what} of each scenario')
    parser.add_argument('scenarios', nargs='*', default=SCENES, metavar='SCENARIO',
                        help=f'scenario files, or names of scenarios of the package (default: {", ".join(SCENES)})')
    arguments = parser.parse_args(words)
    files = [pathlib.Path(find_scenario(name)) for name in arguments.scenarios]
    common = {'episodes': arguments.episodes, 'seed': arguments.seed, 'rviz': False, 'real_time_factor': 'fast'}
    if arguments.config:
        common['config'] = folder_of_parameters(arguments.config)
    if arguments.q_table:
        common['q_table'] = arguments.q_table.absolute()
    common.update({kind: getattr(arguments, kind).absolute() for kind in RECORDINGS if getattr(arguments, kind)})
    if any(getattr(arguments, kind) for kind in RECORDINGS) and len({file.stem for file in files}) < len(files):
        parser.error('two scenarios have the same name, and their recordings would be one file')
    counts = [require_robots(file) for file in files]
    settings = [{'scenario': file.absolute(), **DRIVEN[arguments.robot], **common} for file in files]
    if not shutil.which('roslaunch') or subprocess.run(['rospack', 'find', 'move_base'], stdout=subprocess.DEVNULL,
                                                       stderr=subprocess.DEVNULL, check=False).returncode != 0:
        raise RunError('move_base is not in the ROS environment: install ros-noetic-navigation, or build it '
                       '(docs/move_base.md), and source its setup file')
    return drive(settings, counts, arguments.robots_csv.absolute())


def folder_of_parameters(folder):
    if not (folder / 'move_base.yaml').is_file():
        raise RunError(f'{folder}: expected a folder with the files of config/move_base, found no move_base.yaml')
    return folder.absolute()


def drive(settings, counts, record):
    """Drives one scenario after the other, given the arguments of their launches and the numbers of their robots; an
    earlier record stays until the new one is complete. Returns the exit status."""
    part, finished = (record.with_name(f'.{record.name}.{end}') for end in ('part', 'finished'))
    finished.unlink(missing_ok=True)
    os.environ.update(ROS_MASTER_URI=f'http://127.0.0.1:{free_port()}', ROS_HOSTNAME='127.0.0.1')
    for number, (arguments, robots) in enumerate(zip(settings, counts)):
        part.unlink(missing_ok=True)
        launched = Program(['roslaunch', 'social_crowd', 'robot_lab.launch',
                            *(f'{name}:={str(value).lower() if isinstance(value, bool) else value}'
                              for name, value in {**arguments, 'robots_csv': part}.items())])
        status = launched.wait()
        if launched.is_stopped or status != 0:
            files = ' and '.join(str(file) for file in (finished, part) if file.exists())
            kept = f'; recorded so far: {files}' if files else ''
            what = 'interrupted' if launched.is_stopped else 'roslaunch failed'
            print(f'drive_robots: {what}{kept}', file=sys.stderr)
            return EXIT_INTERRUPTED if launched.is_stopped else status
        count = len(read_csv(part)['episode'])
        expected = arguments['episodes'] * robots
        if count != expected:
            raise RunError(f'{part}: expected {expected} rows, got {count}; see the messages above')
        with open(finished, 'a', encoding='utf-8') as stream:
            stream.writelines(part.read_text(encoding='utf-8').splitlines(True)[1 if number else 0:])
    part.unlink()
    flush_to_disk(finished)
    os.replace(finished, record)
    flush_to_disk(record.parent)
    table_of(record).print()
    return EXIT_FINE


def table_of(file):
    """Returns the results of a record, by scenario and in all."""
    record = read_csv(file)
    names = numpy.array(record['scenario'])
    rows = [row_of(name, record, names == name) for name in dict.fromkeys(record['scenario'])]
    header = ['scenario', 'episodes', 'arrived', 'without contact', 'contacts', 'time [s]', 'personal space [s]']
    return Table('Robots', header, rows + [row_of('all', record, names != '')])


def row_of(name, record, chosen):
    success, contacts = record['success'][chosen] > 0, record['people_contacts'][chosen]
    time = f"{record['time_to_reach_goal'][chosen][success].mean():.1f}" if success.any() else '-'
    return [name, str(chosen.sum()), str(success.sum()), str((success & (contacts == 0)).sum()), f'{contacts.sum():g}',
            time, f"{record['personal_space_time'][chosen].mean():.1f}"]
