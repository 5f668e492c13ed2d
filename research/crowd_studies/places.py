"""The program `walk_places`."""
import pathlib
import tempfile

import pandas
from crowd_experiments.arguments import add_file, parser_of, positive
from crowd_experiments.pages import Chapter, fill_document
from crowd_experiments.records import read_csv
from crowd_experiments.runs import output_of
from crowd_experiments.tools import REPOSITORY, find_tools

TABLE = REPOSITORY / 'config' / 'q_tables' / 'human.txt'
PAGE = REPOSITORY / 'docs' / 'places.md'
TICK = 0.1  # [s]
# Title of the picture and its moment [s], by the name of the place, in the order of the page.
PLACES = {'office': ('An office floor', 60), 'station': ('A station hall', 34), 'supermarket': ('A supermarket', 120),
          'bottleneck': ('A bottleneck', 14), 'two_way_door': ('A two-way door', 7), 'corner': ('A corner', 6),
          't_junction': ('A T-junction', 9), 'museum': ('A museum', 45)}
HEADER = ['scenario', 'people in an episode', 'arrive', 'in contact', 'stopped', 'time of a person [s]']
EXAMPLE = '''example:
  research/walk_places --episodes 10'''


def measure(walk, name, episodes, folder):
    """Walks a place. Returns a row of the table."""
    output_of([*walk, '--episodes', episodes, '--record', folder / 'record.csv', '--csv', folder / 'metrics.csv',
               scenario_of(name)])
    people = pandas.DataFrame(read_csv(folder / 'record.csv'))
    success = read_csv(folder / 'metrics.csv')['success_pct'][0]  # without people whose routes repeat
    counts = people.groupby('episode').size()
    seconds = people['ticks'][people['arrived'] > 0] * TICK
    return [f"[`place_{name}`](#{name.replace('_', '-')})",
            ' to '.join(dict.fromkeys(map(str, (counts.min(), counts.max())))), f'{success:.2f} %',
            str(int(people['touched'].sum())), str(int((people['blocked_moves'] > 0).sum())),
            f'{seconds.mean():.0f}, at most {seconds.max():.0f}' if len(seconds) else '']


def scenario_of(name):
    return REPOSITORY / 'config' / 'scenarios' / f'place_{name}.yaml'


def draw(walk, name, folder):
    title, moment = PLACES[name]
    output_of([*walk, '--episodes', 1, '--trajectories', folder, scenario_of(name)])
    output_of([REPOSITORY / 'scripts' / 'plot_paths', '--trajectories', folder / f'place_{name}.csv', '--scenario',
               scenario_of(name), '--moment', moment, '--title', f'{title}, after {moment} s', '--output',
               REPOSITORY / 'docs' / 'images' / f'place_{name}.png'])


def main(words=None):
    parser = parser_of('walk_places', 'Walks the places of config/scenarios, and updates the pictures and the table of '
                       'docs/places.md.', EXAMPLE)
    parser.add_argument('--episodes', type=positive, default=50, metavar='N',
                        help='episodes of each place (default: %(default)s)')
    add_file(parser, '--tools', metavar='FOLDER', help='folder of the program evaluate (default: the package is built)')
    arguments = parser.parse_args(words)
    walk = [find_tools(arguments.tools) / 'evaluate', '--q-table', TABLE]
    chapter = Chapter('places', 'Places')
    with tempfile.TemporaryDirectory(prefix='social_crowd_') as folder:
        rows = []
        for name in PLACES:
            draw(walk, name, pathlib.Path(folder))
            rows.append(measure(walk, name, arguments.episodes, pathlib.Path(folder)))
            print(' | '.join(rows[-1]), flush=True)
    chapter.add_table('Places', HEADER, rows, 'places')
    fill_document(PAGE, [chapter])
