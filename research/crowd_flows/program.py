"""Command line of research/flows."""
import pandas
from crowd_experiments.arguments import add_file, parser_of

from . import door_flow, fundamental_diagram
from .time_gap_table import add_time_gap

DESCRIPTION = '''Measures speed against density in corridors and the flow through doors, and writes tables
(CSV) and figures; or makes a Q-table whose agents keep a time gap from one whose agents do not.'''
EXAMPLES = '''examples:
  research/flows measure human.txt --evaluate .build/devel/lib/social_crowd/evaluate --data DATA --output flows
  research/flows time-gap anticipation.txt my_human.txt --time-gap 0.9 --width 0.8

Exit status: 0 success, 1 an error, 2 wrong usage, 130 interrupted.'''


def parser():
    """Returns the parser of the command line."""
    result = parser_of('flows', DESCRIPTION, EXAMPLES)
    commands = result.add_subparsers(dest='command', required=True)
    measure = commands.add_parser('measure', help='measure the crowds of one or more Q-tables')
    add_file(measure, 'tables', nargs='+', metavar='Q_TABLE')
    add_file(measure, '--evaluate', required=True, help='the program evaluate')
    add_file(measure, '--data', required=True, metavar='FOLDER', help='folder of the measurements of people')
    add_file(measure, '--output', required=True, metavar='FOLDER', help='folder of tables and figures')
    measure.add_argument('--seeds', type=int, default=3, help='number of placements (default: 3)')
    table = commands.add_parser('time-gap', help='copy a Q-table, and let its agents keep a time gap')
    add_file(table, 'q_table')
    add_file(table, 'output')
    table.add_argument('--time-gap', type=float, required=True, help='[s]')
    table.add_argument('--width', type=float, default=1.0, help='share of the sum of both radii (default: 1)')
    return result


def main(words=None):
    """Executes a command line."""
    arguments = parser().parse_args(words)
    if arguments.command == 'time-gap':
        add_time_gap(arguments.q_table, arguments.output, arguments.time_gap, arguments.width)
    else:
        measure_all(arguments)


def measure_all(arguments):
    """Measures the crowds of all tables and draws them in common figures."""
    speeds, doors = {}, {}
    for table in arguments.tables:
        folder, name = arguments.output / table.stem, table.stem
        evaluation = arguments.evaluate, table, folder, arguments.seeds, arguments.data
        rows, speeds[name], contact = fundamental_diagram.measure_crowd(*evaluation)
        doors[name] = door_flow.measure_crowd(*evaluation)
        for header, found, kind in ((fundamental_diagram.HEADER, rows, 'fundamental_diagram'),
                                    (door_flow.HEADER, doors[name], 'door_flow')):
            pandas.DataFrame(found, columns=header).to_csv(folder / f'{kind}.csv', index=False)
        print(f'{name}: highest contact rate in corridors {contact:g} %')
    fundamental_diagram.plot(speeds, arguments.data, arguments.output / fundamental_diagram.FIGURE)
    door_flow.plot(doors, arguments.data, arguments.output / door_flow.FIGURE)
