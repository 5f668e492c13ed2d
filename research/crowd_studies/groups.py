"""The program `groups`: groups that walk together, beside measurements of people."""
import pathlib
import tempfile

import numpy
import pandas
import yaml
from crowd_experiments.arguments import add_file, parser_of, positive
from crowd_experiments.pages import Chapter, fill_document
from crowd_experiments.records import read_csv
from crowd_experiments.runs import output_of
from crowd_experiments.tools import REPOSITORY, find_tools

PAGE = REPOSITORY / 'docs' / 'groups.md'
TABLES = ('human', 'anticipation')
SIZES = (1, 2, 3, 4)
RADII = (0.15, 0.2, 0.25, 0.3)  # [m]
TICK = 0.1  # [s]
STEP = 10  # of the direction of motion [ticks]
CUT = 20  # at the start and the end of each group, where it forms and where its goals are [ticks]
LEAST_SPEED = 0.3  # at which distances and angles are measured [m/s]
PEOPLE = '{{count: 12, position: {{box: {}}}, goal: {{box: {}}}, speed: [1.0, 1.5], radius: {radius}{groups}}}'
BOTH_WAYS = (('[[1, 0.4], [9, 3.6]]', '[[31, 0.4], [39, 3.6]]'), ('[[31, 0.4], [39, 3.6]]', '[[1, 0.4], [9, 3.6]]'))
# Title, walls, and starts and goals of two dozens of people, by the name of the scene.
SCENES = {
    'hall': ('hall of 40 m x 16 m', '', (('[[0, 0], [8, 8]]', '[[32, 0], [40, 8]]'),
                                         ('[[0, 8], [8, 16]]', '[[32, 8], [40, 16]]'))),
    'corridor': ('corridor of 4 m, both ways', '[[0, 0], [40, 0]], [[0, 4], [40, 4]]', BOTH_WAYS),
    'door': ('door of 1.2 m, both ways', '[[20, -4], [20, 1.4]], [[20, 2.6], [20, 8]]', BOTH_WAYS),
}
HEADER = ['scene', 'members', 'clean', 'distance of neighbours [m]', 'angle [°]', 'speed [m/s]', 'farthest two [m]']
EXAMPLE = '''example:
  research/groups --episodes 2'''


def document_of(scene, size, radius):
    _, walls, streams = SCENES[scene]
    groups = f', groups: {{share: 1, sizes: {{{size}: 1}}}}' if size > 1 else ''
    people = ''.join('  - ' + PEOPLE.format(*stream, radius=radius, groups=groups) + '\n' for stream in streams)
    return f'name: {scene}\nduration: 180\ngoal_tolerance: 0.3\nwalls: [{walls}]\nagents:\n{people}'


def groups_of(agents):
    """Returns the lists of members by the agents of a drawn scene."""
    members = {}
    for number, agent in enumerate(agents):
        members.setdefault(agent.get('leader', number), []).append(number)
    return list(members.values())


def neighbours_of(places):
    """Returns, of places [time, member, 2] of a group in each tick, for the times at which it walks: distances [m] of
    neighbours, angles [degrees] from the line across the direction of motion, and the largest distances."""
    centre = places.mean(axis=1)
    motion = centre[STEP:] - centre[:-STEP]
    length = numpy.linalg.norm(motion, axis=1)
    walks = length > LEAST_SPEED * STEP * TICK
    forward = motion[walks] / length[walks, None]
    offsets = (places - centre[:, None])[STEP // 2:-STEP // 2][walks]
    ahead = (offsets * forward[:, None]).sum(axis=2)
    aside = forward[:, None, 0] * offsets[..., 1] - forward[:, None, 1] * offsets[..., 0]
    order = numpy.argsort(aside, axis=1)
    steps = [numpy.diff(numpy.take_along_axis(values, order, axis=1), axis=1) for values in (ahead, aside)]
    farthest = numpy.linalg.norm(offsets[:, :, None] - offsets[:, None], axis=3).max(axis=(1, 2))
    return numpy.hypot(*steps).ravel(), numpy.degrees(numpy.arctan2(abs(steps[0]), steps[1])).ravel(), farthest


def measure(walk, scene, size, episodes, folder):
    """Walks a scene with bodies of each radius. Returns a row of the table."""
    clean, speeds, found = [], [], []
    for radius in RADII:
        file = folder / f'{scene}.yaml'
        file.write_text(document_of(scene, size, radius), encoding='utf-8')
        output_of([*walk, '--episodes', episodes, '--trajectories', folder, '--scenes', folder / 'scenes', '--csv',
                   folder / 'metrics.csv', file])
        clean += list(read_csv(folder / 'metrics.csv')['clean_pct'])
        scenes = list(yaml.safe_load_all((folder / 'scenes' / file.name).read_text(encoding='utf-8')))
        paths = {key: rows[['tick', 'x', 'y']].to_numpy()
                 for key, rows in pandas.read_csv(folder / f'{scene}.csv').groupby(['instance', 'agent'])}
        for instance, drawn in enumerate(scenes):
            for members in groups_of(drawn['agents']):
                walked = [paths[instance, member] for member in members if (instance, member) in paths]
                ticks = min(len(path) for path in walked) - CUT
                if len(walked) < size or ticks < CUT + 2 * STEP:
                    continue
                places = numpy.stack([path[CUT:ticks, 1:] for path in walked], axis=1)
                way = numpy.linalg.norm(numpy.diff(places.mean(axis=1), axis=0), axis=1).sum()
                speeds.append(way / (TICK * (len(places) - 1)))
                found.append(neighbours_of(places))
    row = [SCENES[scene][0], str(size), f'{numpy.mean(clean):.0f} %']
    if size == 1:
        return row + ['', '', f'{numpy.mean(speeds):.2f}', '']
    distances, angles, farthest = (numpy.concatenate(values) for values in zip(*found))
    low, middle, high = numpy.percentile(distances, [10, 50, 90])
    return row + [f'{middle:.2f} ({low:.2f} to {high:.2f})', f'{numpy.median(angles):.0f}', f'{numpy.mean(speeds):.2f}',
                  f'{numpy.percentile(farthest, 99):.1f}']


def main(words=None):
    parser = parser_of('groups', 'Measures groups of two to four people in a hall, a corridor and at a door, and '
                       'updates the tables of docs/groups.md.', EXAMPLE)
    parser.add_argument('--episodes', type=positive, default=8, metavar='N',
                        help='episodes of each scene and each radius (default: %(default)s)')
    add_file(parser, '--document', default=PAGE, metavar='FILE.md', help='page whose tables are updated')
    add_file(parser, '--tools', metavar='FOLDER', help='folder of the program evaluate (default: the package is built)')
    arguments = parser.parse_args(words)
    evaluate = find_tools(arguments.tools) / 'evaluate'
    chapter = Chapter('groups', 'Groups')
    with tempfile.TemporaryDirectory(prefix='social_crowd_') as folder:
        for name in TABLES:
            walk = [evaluate, '--q-table', REPOSITORY / 'config' / 'q_tables' / f'{name}.txt']
            rows = []
            for scene in SCENES:
                for size in SIZES:
                    rows.append(measure(walk, scene, size, arguments.episodes, pathlib.Path(folder)))
                    print(f'{name}: ' + ' | '.join(rows[-1]), flush=True)
            chapter.add_table(name, HEADER, rows, name)
    fill_document(arguments.document, [chapter])
