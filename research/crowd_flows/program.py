"""The command line of research/flows; copies of Q-tables whose agents have other bodies."""
import pandas
from crowd_drawing.errors import InputError
from crowd_experiments.arguments import add_file, parser_of
from crowd_tables.body import with_body

from . import door_flow, fundamental_diagram

DESCRIPTION = '''Measures speed against density in corridors and the flow through doors, and writes tables
(CSV) and figures; or copies a Q-table and gives its agents other bodies: mass, gait, a time gap and personal space.'''
EXAMPLES = '''examples:
  research/flows measure human.txt --evaluate .build/devel/lib/social_crowd/evaluate --data DATA --output flows
  research/flows body anticipation.txt my_human.txt 'time_gap: 0.9, motion: {acceleration: 3, braking: 3}' \\
      --personal-space 0.3'''


def main(words=None):
    parser = parser_of('flows', DESCRIPTION, EXAMPLES)
    commands = parser.add_subparsers(dest='command', required=True)
    measure = commands.add_parser('measure', help='measure the crowds of one or more Q-tables')
    add_file(measure, 'tables', nargs='+', metavar='Q_TABLE')
    add_file(measure, '--evaluate', required=True, help='the program evaluate')
    add_file(measure, '--data', required=True, metavar='FOLDER', help='folder of the measurements of people')
    add_file(measure, '--output', required=True, metavar='FOLDER', help='folder of tables and figures')
    measure.add_argument('--seeds', type=int, default=3, help='number of placements (default: 3)')
    copy = commands.add_parser('body', help='copy a Q-table, and give its agents another body')
    add_file(copy, 'q_table')
    add_file(copy, 'output')
    copy.add_argument('keys', help='keys of the action set after lookout: time_gap, time_gap_width, motion, gait')
    copy.add_argument('--personal-space', type=float, default=0.0, metavar='METRES',
                      help='of the state set (default: %(default)s)')
    arguments = parser.parse_args(words)
    if arguments.command == 'body':
        try:
            contents = with_body(arguments.q_table.read_bytes(), arguments.keys, arguments.personal_space)
        except ValueError as error:
            raise InputError(f'{arguments.q_table}: {error}') from None
        arguments.output.write_bytes(contents)
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
