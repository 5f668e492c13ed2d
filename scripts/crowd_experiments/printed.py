"""Tables of pages in docs/ that programs print."""
import subprocess

from crowd_experiments.arguments import add_file, add_tools, parser_of
from crowd_experiments.pages import Chapter, fill_document
from crowd_experiments.tools import REPOSITORY, find_tools

# {page: {mark of the table: command that prints it as Markdown}}
PRINTED = {'state_sets.md': {'types/all': ('train', '--list-types')}}
EXAMPLE = '''They are between marks such as <!-- table types/all --> and <!-- end -->.

example:
  scripts/fill_pages          after a change of a state set, an action set or a reward'''


def chapter_of(mark, text):
    """Returns the Chapter with a printed table."""
    name, table = mark.split('/')
    header, _, *rows = [line[2:-2].split(' | ') for line in text.splitlines()]
    chapter = Chapter(name, '')
    chapter.add_table('', header, rows, table)
    return chapter


def main(words=None):
    parser = parser_of('fill_pages', 'Fills the tables of pages in docs/ that programs print.', EXAMPLE)
    add_file(parser, '--docs', default=REPOSITORY / 'docs', metavar='FOLDER',
             help="folder of the pages (default: the package's)")
    add_tools(parser)
    arguments = parser.parse_args(words)
    tools = find_tools(arguments.tools)
    for page, tables in PRINTED.items():
        texts = {mark: subprocess.run([tools / program, *options], stdout=subprocess.PIPE, text=True, check=True).stdout
                 for mark, (program, *options) in tables.items()}
        for problem in fill_document(arguments.docs / page, [chapter_of(*each) for each in texts.items()]):
            print(problem)
