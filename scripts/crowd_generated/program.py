"""Writes files of the package that follow from others."""
from crowd_drawing.errors import InputError
from crowd_experiments.arguments import add_file, add_tools, parser_of
from crowd_experiments.tools import REPOSITORY
from crowd_generated import metrics, types_table

DESCRIPTION = '''Writes files of the package that follow from others:

  metrics   from the fields of results in include/social_crowd: the lists that visit the fields of robots,
            the messages, and the rows of docs/metrics.md. The comment of a field, with its unit in brackets
            at the end, becomes the comment in the message and the text of a new row; other rows keep theirs.
  types     from the lists of state sets, action sets and rewards: their table in docs/state_sets.md. The
            package is built for it.'''
EXAMPLE = '''example:
  scripts/generate metrics && git diff'''
WRITERS = {'metrics': lambda arguments: metrics.written(arguments.package),
           'types': lambda arguments: types_table.written(arguments.package, arguments.tools)}


def main(words=None):
    parser = parser_of('generate', DESCRIPTION, EXAMPLE)
    parser.add_argument('part', nargs='?', choices=WRITERS, help='what to write (default: all)')
    add_file(parser, '--package', metavar='FOLDER', default=REPOSITORY, help='the package (default: this one)')
    add_tools(parser)
    parser.add_argument('--check', action='store_true', help='write nothing; it is an error if a file would change')
    arguments = parser.parse_args(words)
    for part in [arguments.part] if arguments.part else WRITERS:
        for file, text in WRITERS[part](arguments).items():
            if text == file.read_text(encoding='utf-8'):
                continue
            if arguments.check:
                raise InputError(f'{file} does not follow from its source: call scripts/generate {part}')
            file.write_text(text, encoding='utf-8')
            print(file)
