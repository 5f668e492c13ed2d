"""The command line of scripts/drive_robots: `evaluate --robot` for robots that move_base drives."""
import os
import shutil
import subprocess
import sys

from crowd_drawing.errors import read_documents
from crowd_experiments.arguments import add_file, parser_of, positive
from crowd_experiments.interruption import EXIT_FINE, EXIT_INTERRUPTED
from crowd_experiments.records import read_csv
from crowd_experiments.runs import RunError
from crowd_launching.program import Program, free_port

# Robots that are driven through ROS, and their arguments of move_base.launch.
DRIVEN = {'move_base': {}, 'move_base_people': {'people_layer': True}}
EXAMPLES = '''example:
  scripts/drive_robots --robot move_base --episodes 5 --robots-csv /tmp/robots.csv config/scenarios/robot_hall.yaml

It starts a ROS master of its own and move_base.launch, as fast as possible. The first episode is restarted when
move_base has sent its first command. move_base and its planners have to be in the ROS environment; for move_base_people
the package has to be built where costmap_2d is.

FILE of --robots-csv is written when all episodes are recorded.'''


def launch_arguments(scenario, robot):
    """Returns the arguments of move_base.launch for a scenario file and a robot of DRIVEN."""
    document = (read_documents(scenario) or [None])[0]
    robots = document.get('robots') if isinstance(document, dict) else None
    if not robots:
        raise RunError(f'{scenario}: expected a scenario with robots')
    if not isinstance(robots, list) or any(not isinstance(entry, dict) or 'radius' not in entry for entry in robots):
        raise RunError(f'{scenario}: robots: expected the key radius for each robot')
    for number, entry in enumerate(robots):
        if len(robots) > 1 and not (entry.get('namespace') or entry.get('name')):
            raise RunError(f'{scenario}: robots[{number}]: expected a name or a namespace, as there are several robots')
    return {
        'scenario': scenario.absolute(),
        'map': 'map' in document,
        'robots': ' '.join(entry.get('namespace') or (entry['name'] if len(robots) > 1 else '') for entry in robots),
        'radius': max(entry['radius'] for entry in robots),
        'goal_tolerance': document.get('goal_tolerance', 0.3),
        'command_period': document.get('tick', 0.1),
        **DRIVEN[robot]}


def main(words=None):
    parser = parser_of('drive_robots', 'Drives the robots of a scenario through ROS and writes their results as '
                       '`evaluate --robots-csv` does.', EXAMPLES, '0 success, 1 not all episodes were recorded or an '
                       'input is wrong, 2 wrong usage, 130 interrupted.')
    parser.add_argument('--robot', choices=DRIVEN, default='move_base',
                        help='move_base with DWA, or also with the costs of PeopleLayer (default: %(default)s)')
    parser.add_argument('--episodes', type=positive, default=1, metavar='N', help='(default: %(default)s)')
    parser.add_argument('--seed', type=int, default=1, metavar='S', help='of placements (default: %(default)s)')
    add_file(parser, '--q-table', help='of the people (default: anticipation)')
    add_file(parser, '--robots-csv', required=True, help='results of the robots')
    add_file(parser, 'scenario', metavar='SCENARIO.yaml')
    arguments = parser.parse_args(words)
    settings = launch_arguments(arguments.scenario, arguments.robot)
    if not shutil.which('roslaunch') or subprocess.run(['rospack', 'find', 'move_base'], stdout=subprocess.DEVNULL,
                                                       stderr=subprocess.DEVNULL, check=False).returncode != 0:
        raise RunError('move_base is not in the ROS environment; source the setup file of its workspace')
    record = arguments.robots_csv.absolute()
    part = record.with_name(f'.{record.name}.part')  # an earlier record stays until this one is complete
    part.unlink(missing_ok=True)
    settings.update(robots_csv=part, episodes=arguments.episodes, seed=arguments.seed, rviz=False,
                    real_time_factor='fast')
    if arguments.q_table:
        settings['q_table'] = arguments.q_table.absolute()
    os.environ.update(ROS_MASTER_URI=f'http://127.0.0.1:{free_port()}', ROS_HOSTNAME='127.0.0.1')
    launched = Program(['roslaunch', 'social_crowd', 'move_base.launch',
                        *(f'{name}:={str(value).lower() if isinstance(value, bool) else value}'
                          for name, value in settings.items())])
    status = launched.wait()
    if launched.is_stopped:
        print('drive_robots: interrupted' + (f'; recorded so far: {part}' if part.exists() else ''), file=sys.stderr)
        return EXIT_INTERRUPTED
    if status != 0:
        return status
    count = len(read_csv(part)['episode'])
    expected = arguments.episodes * len(settings['robots'].split() or [''])
    if count != expected:
        raise RunError(f'{part}: expected {expected} rows, got {count}; see the messages above')
    os.replace(part, record)
    return EXIT_FINE
