"""The command line of research/flows; copies of Q-tables whose agents keep a time gap."""
import re

import pandas
from crowd_experiments.arguments import add_file, parser_of

from . import door_flow, fundamental_diagram

CHECKSUM = b'checksum: '
FNV_OFFSET, FNV_PRIME = 0xcbf29ce484222325, 0x100000001b3
DESCRIPTION = '''Measures speed against density in corridors and the flow through doors, and writes tables
(CSV) and figures; or makes a Q-table whose agents keep a time gap from one whose agents do not.'''
EXAMPLES = '''examples:
  research/flows measure human.txt --evaluate .build/devel/lib/social_crowd/evaluate --data DATA --output flows
  research/flows time-gap anticipation.txt my_human.txt --time-gap 0.9 --width 0.8'''


def fnv1a(data):
    value = FNV_OFFSET
    for byte in data:
        value = (value ^ byte) * FNV_PRIME & 0xffffffffffffffff
    return value


def with_time_gap(contents, time_gap, width):
    """Returns the contents of a Q-table file with another time gap, 0: none. Throws ValueError if it is not one."""
    body, found, checksum = contents.rpartition(CHECKSUM)
    if not found or checksum.strip() != b'%016x' % fnv1a(body):
        raise ValueError('expected a Q-table file with a valid checksum')
    added = b', time_gap: %s, time_gap_width: %s}' % (b'%.15g' % time_gap, b'%.15g' % width) if time_gap > 0.0 else b'}'
    body, replaced = re.subn(rb'^(action_set: \{type: goal_relative,.*?)(, time_gap: [^}]*)?\}$',
                             lambda match: match[1] + added, body, count=1, flags=re.MULTILINE)
    if replaced == 0:
        raise ValueError('expected the action set goal_relative')
    return body + CHECKSUM + b'%016x\n' % fnv1a(body)


def add_time_gap(q_table, output, time_gap, width):
    output.write_bytes(with_time_gap(q_table.read_bytes(), time_gap, width))


def main(words=None):
    parser = parser_of('flows', DESCRIPTION, EXAMPLES)
    commands = parser.add_subparsers(dest='command', required=True)
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
    arguments = parser.parse_args(words)
    if arguments.command == 'time-gap':
        add_time_gap(arguments.q_table, arguments.output, arguments.time_gap, arguments.width)
        return
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
