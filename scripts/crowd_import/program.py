"""Converts a scene of pedsim_ros into a scenario file.

Obstacles become walls; waypoints, queues and sinks become routes; agents and sources are carried over. What is not
carried over, or is changed, is printed and written at the top of the scenario file, with its line in the scene.
"""
import pathlib
import sys

from crowd_experiments.arguments import above_zero, parser_of
from crowd_import.pedsim_conversion import Conversion, number, text_of
from crowd_import.pedsim_scene import PedsimScene

EXAMPLES = '''example:
  rosrun social_crowd pedsim_import hall.xml --output hall.yaml --duration 120

Exit status: 0 success, 1 an error, 2 wrong usage, 130 interrupted.'''


def scenario_of(conversion, source, name, duration):
    """Returns the text of a scenario file."""
    lines = [f'# Converted from {source}, a scene of pedsim_ros.']
    if conversion.notes:
        lines += ['# Not carried over, or changed:', *(f'#   line {line}: {note}' for line, note in conversion.notes)]
    lines += [f'name: {text_of(name)}', f'duration: {number(duration)}', 'goal_tolerance: 0.3']
    for key, entries in conversion.sections().items():
        named = isinstance(entries, dict)
        lines.append(f'{key}:')
        for entry in entries:
            if key == 'routes':
                lines += [f'  {entry}:', f"    repeat: {text_of(entries[entry]['repeat'])}", '    waypoints:',
                          *(f'      - {text_of(stop)}' for stop in entries[entry]['waypoints'])]
            else:
                lines.append(f'  {text_of(entry)}: {text_of(entries[entry])}' if named else f'  - {text_of(entry)}')
    return '\n'.join([*lines, ''])


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
