"""The program `screenshots`; the film at the beginning of README.md, and a picture of a report in a browser."""
import os
import pathlib
import shutil
import tempfile

from crowd_experiments.arguments import add_file, parser_of
from crowd_experiments.runs import RunError, output_of
from crowd_experiments.tools import REPOSITORY, find_tools

from .rviz_pictures import rviz

SCRIPTS, CONFIG = REPOSITORY / 'scripts', REPOSITORY / 'config'
# As in README.md.
FILM = 'place_station --start 28 --duration 36 --speed 3 --fps 15 --view 8 7 44 30'
SCENARIOS = 'circle6', 'place_corner'
EPISODES, LEARNED = 20, 300  # of each scenario, of each training
BROWSER = 'chromium'
WINDOW = '1080,2000'  # [pixels]; the first chapters of the report


def film(folder):
    """Makes the film. Yields its file."""
    file = folder / 'film_station.gif'
    output_of([SCRIPTS / 'film', *FILM.split(), '--output', file])
    yield file


def write_report(folder):
    """Walks and trains crowds, and writes a report about them. Returns its file."""
    tools = pathlib.Path(find_tools(None))
    files = []
    for table in ('anticipation', 'human'):
        os.makedirs(folder / table)
        output_of([tools / 'evaluate', '--q-table', CONFIG / 'q_tables' / f'{table}.txt', '--episodes', EPISODES,
                   '--trajectories', table, '--csv', f'{table}/metrics.csv', '--record', f'{table}/record.csv',
                   *SCENARIOS], cwd=folder)
        files += [f'{table}/{name}.csv' for name in ('metrics', 'record', *SCENARIOS)]
    for seed in (1, 2, 3):
        output_of([tools / 'train', CONFIG / 'learning' / 'anticipation.yaml', '--output', 'table.txt', '--episodes',
                   LEARNED, '--seed', seed, '--log', f'log_{seed}.csv'], cwd=folder)
        files.append(f'anticipation=log_{seed}.csv')
    output_of([SCRIPTS / 'report', *files, '--output', 'report.html'], cwd=folder)
    return folder / 'report.html'


def report(folder):
    """Takes a picture of a report in a browser, if there is one. Yields its file."""
    if shutil.which(BROWSER) is None:
        raise RunError(f'report.png needs the program {BROWSER}')
    file = folder / 'report.png'
    with tempfile.TemporaryDirectory(prefix='social_crowd_screenshots_') as work:
        page = write_report(pathlib.Path(work))
        output_of([BROWSER, '--headless', '--no-sandbox', '--disable-gpu', '--hide-scrollbars',
                   f'--window-size={WINDOW}', f'--screenshot={file.resolve()}', page.as_uri()])
    yield file


KINDS = {'rviz': rviz, 'film': film, 'report': report}
DESCRIPTION = '''Makes pictures in docs/images: of RViz (the panel, the tools that draw on the floor, the values of
an agent's moves, and walking people), the film of README.md, and a report.

Runs demo.launch on a separate screen, so that no display is needed. The picture of the report needs chromium.'''
EXAMPLES = '''examples:
  scripts/screenshots --output /tmp
  scripts/screenshots rviz film'''


def main(words=None):
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
