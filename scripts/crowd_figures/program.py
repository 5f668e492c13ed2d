"""The program `draw_figures`."""
from crowd_experiments.arguments import add_file, parser_of
from crowd_experiments.tools import REPOSITORY

from . import belongings, people
from .shapes import write

EXAMPLE = '''Each build has a head, and for each picture of the walking cycle (frames 0 to 7, and 8: standing)
a shirt and a mesh of the dark parts: hair, trousers or skirt, shoes. There are also a person who sits, a wheelchair,
a suitcase and a stick.

example:
  scripts/draw_figures --output /tmp/meshes'''


def main(words=None):
    parser = parser_of('draw_figures', 'Makes the meshes of people who walk, which crowd_markers shows in RViz.',
                       EXAMPLE)
    add_file(parser, '--output', default=REPOSITORY / 'meshes', metavar='FOLDER',
             help='folder of the meshes (default: meshes)')
    folder = parser.parse_args(words).output
    folder.mkdir(parents=True, exist_ok=True)
    shapes = {**people.shapes(), **belongings.shapes()}
    files = [write(folder / f'{name}.stl', shape) for name, shape in shapes.items()]
    print(f'{len(files)} meshes, {sum(file.stat().st_size for file in files) / 1e3:.0f} kB')
