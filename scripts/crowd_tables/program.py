"""The program `draw_q_table`."""
import os
import pathlib

from crowd_drawing.errors import InputError, check_output
from crowd_experiments.arguments import add_file, add_tools, parser_of, whole
from crowd_experiments.tools import find_config, find_tools
from crowd_tables.drawing import draw_table
from crowd_tables.table import action_names, meaning_of, read_table, row_visits

EXAMPLES = '''examples:
  draw_q_table config/q_tables/thesis_nearest.txt --output nearest.png
  draw_q_table human --row 1234'''


PICTURES = ('.png', '.pdf', '.svg')


def main(words=None):
    parser = parser_of('draw_q_table',
                       'Draws the values and visits of all rows of a Q-table as heat maps, or explains one '
                       'row.', EXAMPLES)
    parser.add_argument('table', metavar='FILE', help='a Q-table file, or a name in config/q_tables')
    add_file(parser, '--output', help='picture, such as table.png or table.pdf')
    parser.add_argument('--row', type=whole, metavar='N', help='print what row N means, with visits and values')
    parser.add_argument('--title', help='title of the picture (default: the name of the file)')
    add_tools(parser)
    arguments = parser.parse_args(words)
    if arguments.output is None and arguments.row is None:
        parser.error('expected --output or --row')
    if arguments.output and arguments.output.suffix.lower() not in PICTURES:
        parser.error(f"--output: expected a name with {', '.join(PICTURES)}, got '{arguments.output}'")
    if arguments.output:
        check_output(arguments.output)
    shipped = find_config() / 'q_tables' / f'{arguments.table}.txt'
    is_name = not os.path.exists(arguments.table) and shipped.is_file()
    table = read_table(str(shipped) if is_name else arguments.table)
    meaning = meaning_of(table, find_tools(arguments.tools) / 'train')
    if arguments.row is not None:
        if arguments.row >= table.header['rows']:
            raise InputError(f"--row: expected 0 to {table.header['rows'] - 1}, got {arguments.row}")
        print(f'row {arguments.row}: {meaning.describe(arguments.row)}')
        names = action_names(table)
        for name, visits, value in zip(names, table.visits[arguments.row], table.values[arguments.row]):
            print(f'  {name:{max(map(len, names))}}  {visits:>9} visits' + (f'  value {value:.6g}' if visits else ''))
    if arguments.output is not None:
        visits = row_visits(table)
        subtitle = f'{(visits > 0).sum()} of {len(visits)} rows visited, {visits.sum()} visits'
        draw_table(arguments.output, table, meaning, f'{arguments.title or pathlib.Path(arguments.table).name}: '
                   f'{meaning.type}, {subtitle}')
        print(f'{arguments.output}: {subtitle}')
