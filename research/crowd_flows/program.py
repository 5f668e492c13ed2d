"""Command line of research/flows."""
import argparse
import csv
import pathlib
import subprocess
import sys

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
    result = argparse.ArgumentParser(prog='flows', description=DESCRIPTION, epilog=EXAMPLES,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = result.add_subparsers(dest='command', required=True)
    measure = commands.add_parser('measure', help='measure the crowds of one or more Q-tables')
    measure.add_argument('tables', nargs='+', type=pathlib.Path, metavar='Q_TABLE')
    measure.add_argument('--evaluate', type=pathlib.Path, required=True, help='the program evaluate')
    measure.add_argument('--data', type=pathlib.Path, required=True, help='folder of the measurements of people')
    measure.add_argument('--output', type=pathlib.Path, required=True, help='folder of tables and figures')
    measure.add_argument('--seeds', type=int, default=3, help='number of placements (default: 3)')
    table = commands.add_parser('time-gap', help='copy a Q-table, and let its agents keep a time gap')
    table.add_argument('q_table', type=pathlib.Path)
    table.add_argument('output', type=pathlib.Path)
    table.add_argument('--time-gap', type=float, required=True, help='[s]')
    table.add_argument('--width', type=float, default=1.0, help='share of the sum of both radii (default: 1)')
    return result


def main(words=None):
    """Executes a command line. Returns the exit status."""
    arguments = parser().parse_args(words)
    try:
        if arguments.command == 'time-gap':
            add_time_gap(arguments.q_table, arguments.output, arguments.time_gap, arguments.width)
        else:
            measure_all(arguments)
    except (OSError, ValueError, subprocess.CalledProcessError) as error:
        print(f'flows: {error}', file=sys.stderr)
        return 1
    return 0


def measure_all(arguments):
    """Measures the crowds of all tables and draws them in common figures."""
    speeds, doors = {}, {}
    for table in arguments.tables:
        folder = arguments.output / table.stem
        rows, values, contact = fundamental_diagram.measure_crowd(arguments.evaluate, table, folder,
                                                                  arguments.seeds, arguments.data)
        write_rows(folder / 'fundamental_diagram.csv', fundamental_diagram.HEADER, rows)
        door_rows = door_flow.measure_crowd(arguments.evaluate, table, folder, arguments.seeds, arguments.data)
        write_rows(folder / 'door_flow.csv', door_flow.HEADER, door_rows)
        print(f'{table.stem}: highest contact rate in corridors {contact:g} %')
        speeds[table.stem], doors[table.stem] = values, door_rows
    fundamental_diagram.plot(speeds, arguments.data, arguments.output / fundamental_diagram.FIGURE)
    door_flow.plot(doors, arguments.data, arguments.output / door_flow.FIGURE)


def write_rows(file, header, rows):
    """Writes a CSV file."""
    with open(file, 'w', newline='', encoding='utf-8') as stream:
        csv.writer(stream).writerows([header, *rows])
