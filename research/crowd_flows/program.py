"""The command line of research/flows."""
import pandas
from crowd_experiments.arguments import add_file, parser_of

from . import door_flow, fundamental_diagram

DESCRIPTION = '''Measures speed against density in corridors and the flow through doors, and writes tables
(CSV) and figures.'''
EXAMPLES = '''example:
  research/flows human.txt --evaluate .build/devel/lib/social_crowd/evaluate --data DATA --output flows'''


def main(words=None):
    parser = parser_of('flows', DESCRIPTION, EXAMPLES)
    add_file(parser, 'tables', nargs='+', metavar='Q_TABLE')
    add_file(parser, '--evaluate', required=True, help='the program evaluate')
    add_file(parser, '--data', required=True, metavar='FOLDER', help='folder of the measurements of people')
    add_file(parser, '--output', required=True, metavar='FOLDER', help='folder of tables and figures')
    parser.add_argument('--seeds', type=int, default=3, help='number of placements (default: 3)')
    arguments = parser.parse_args(words)
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
