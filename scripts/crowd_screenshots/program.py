"""The program `screenshots`."""
from crowd_experiments.arguments import add_file, parser_of
from crowd_experiments.tools import REPOSITORY

from .page_pictures import film, report
from .rviz_pictures import rviz

KINDS = {'rviz': rviz, 'film': film, 'report': report}
DESCRIPTION = '''Makes pictures in docs/images: of RViz (the panel, the tools that draw on the floor, the values of
an agent's moves, and walking people), the film of README.md, and a report.

Runs demo.launch on a separate screen, so that no display is needed. The picture of the report needs chromium.'''
EXAMPLES = '''examples:
  scripts/screenshots --output /tmp
  scripts/screenshots rviz film

Exit status: 0 success, 1 an error, 2 wrong usage, 130 interrupted.'''


def main(words=None):
    """Runs the program with command line words."""
    parser = parser_of('screenshots', DESCRIPTION, EXAMPLES)
    parser.add_argument('kinds', nargs='*', metavar='KIND', choices=[*KINDS, []],
                        help=f"{', '.join(KINDS)} (default: all)")
    add_file(parser, '--output', default=REPOSITORY / 'docs' / 'images', metavar='FOLDER',
             help='folder of the pictures (default: docs/images)')
    arguments = parser.parse_args(words)
    arguments.output.mkdir(parents=True, exist_ok=True)
    for kind in arguments.kinds or KINDS:
        for file in KINDS[kind](arguments.output):
            print(file, flush=True)
