"""Converts a scene of pedsim_ros into a scenario file.

Obstacles become walls; waypoints, queues and sinks become routes; agents and sources are carried over. What is not
carried over, or is changed, is printed and written at the top of the scenario file, with its line in the scene.
"""
import pathlib
import sys

from crowd_experiments.arguments import above_zero, parser_of
from crowd_import.pedsim_conversion import Conversion, name_text, number_text, section
from crowd_import.pedsim_scene import PedsimScene

EXAMPLES = '''example:
  rosrun social_crowd pedsim_import hall.xml --output hall.yaml --duration 120

Exit status: 0 success, 1 an error, 2 wrong usage, 130 interrupted.'''


def scenario_of(conversion, source, name, duration):
    """Returns the text of a scenario file."""
    notes = ''.join(f'#   line {line}: {note}\n' for line, note in conversion.notes)
    routes = {name: '\n' + text for text, name in conversion.routes.items()}
    sinks = {name: f' {{area: {area}}}' for name, area in conversion.sinks.items()}
    queues = {name: ' ' + queue for name, queue in conversion.queues.items()}
    parts = [
        f'# Converted from {source}, a scene of pedsim_ros.\n',
        f'# Not carried over, or changed:\n{notes}' if notes else '',
        f'name: {name_text(name)}\n',
        f'duration: {number_text(duration)}\n',
        'goal_tolerance: 0.3\n',
        section('agents', conversion.agents),
        section('obstacles', conversion.obstacles),
        section('sources', conversion.sources),
        section('sinks', sinks),
        section('queues', queues),
        section('routes', routes),
        section('walls', conversion.walls),
    ]
    return ''.join(parts)


def parse_arguments(words):
    parser = parser_of('pedsim_import', __doc__, EXAMPLES)
    parser.add_argument('scene', metavar='FILE.xml', help='scene of pedsim_ros')
    parser.add_argument('--output', required=True, metavar='SCENARIO.yaml', help='scenario file to write')
    parser.add_argument('--duration', type=above_zero, default=300.0, metavar='S',
                        help='duration of the scenario [s], default 300')
    parser.add_argument('--radius', type=above_zero, default=0.2, metavar='M', help='radius of people [m], default 0.2')
    parser.add_argument('--spawn-period', type=above_zero, default=5.0, metavar='S',
                        help="pedsim_ros's parameter: time between two groups of a source [s], default 5")
    parser.add_argument('--skip-unknown', action='store_true',
                        help='leave out waypoints of routes that the scene does not define, instead of an error')
    return parser.parse_args(words)


def main(words=None):
    """Runs the program with command line words."""
    arguments = parse_arguments(words)
    scene = PedsimScene(arguments.scene, arguments.skip_unknown)
    conversion = Conversion(scene, arguments.radius, arguments.spawn_period)
    output = pathlib.Path(arguments.output)
    source = pathlib.Path(arguments.scene).name
    output.write_text(scenario_of(conversion, source, output.stem, arguments.duration), encoding='utf-8')
    for line, note in conversion.notes:
        print(f'{arguments.scene}:{line}: {note}', file=sys.stderr)
