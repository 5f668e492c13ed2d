"""Draws floors cell by cell, and writes them in the format of map_server."""
import pathlib

import numpy
import PIL.Image
from crowd_drawing.errors import InputError, read_documents
from crowd_experiments.arguments import add_file, parser_of
from crowd_experiments.tools import REPOSITORY

FLOORS = pathlib.Path(__file__).with_name('floors.yaml')
RESOLUTION = 0.05  # [m]
MARGIN = 0.5  # of unknown cells around the floor [m]
OCCUPIED, UNKNOWN, FREE = 0, 205, 254  # grey values of map_server's map_saver
YAML = f'''image: {{name}}.png
resolution: {RESOLUTION}
origin: [{-MARGIN}, {-MARGIN}, 0]
occupied_thresh: 0.65
free_thresh: 0.196
negate: 0
'''
EXAMPLE = '''Writes NAME.png and NAME.yaml for each, in the format of map_server.

example:
  scripts/draw_maps --floors my_floors.yaml --output /tmp/maps'''


def cells(metres):
    """Returns the number of the cell border at a coordinate, which must be a multiple of the resolution."""
    border = round(metres / RESOLUTION)
    if abs(border * RESOLUTION - metres) > 1e-6:
        raise ValueError(f'{metres} m is not a multiple of {RESOLUTION} m')
    return border


class Floor:
    """A rectangular floor whose lower left inner corner is the origin; rows of cells from the bottom."""

    def __init__(self, width, height, wall=0.2):
        self.rows = numpy.full([cells(side + 2 * MARGIN) for side in (height, width)], UNKNOWN, dtype=numpy.uint8)
        self.block(-wall, -wall, width + wall, height + wall)
        self.opening(0, 0, width, height)

    def block(self, left, bottom, right, top, value=OCCUPIED):
        left, bottom, right, top = (cells(side) + cells(MARGIN) for side in (left, bottom, right, top))
        self.rows[bottom:top, left:right] = value

    def opening(self, *box):
        self.block(*box, FREE)


def drawn(file, name, description):
    """Returns the Floor of an entry of a file of floors. Throws InputError."""
    try:
        floor = Floor(*description['size'])
        for entry in description['drawn']:
            for along in entry.get('at', [0]):
                left, bottom, right, top = entry.get('block') or entry['opening']
                (floor.block if 'block' in entry else floor.opening)(left + along, bottom, right + along, top)
    except (AttributeError, KeyError, TypeError, ValueError) as error:
        raise InputError(f'{file}: {name}: expected size: [WIDTH, HEIGHT] and drawn, a list of block or opening: '
                         '[LEFT, BOTTOM, RIGHT, TOP], with at: [X, ...] if it is repeated [m]') from error
    return floor


def main(words=None):
    parser = parser_of('draw_maps', "Draws maps of floors: by default the package's own.", EXAMPLE)
    add_file(parser, '--floors', default=FLOORS, help="sizes, walls and openings (default: the package's)")
    add_file(parser, '--output', default=REPOSITORY / 'config' / 'maps', metavar='FOLDER',
             help="folder of the maps (default: the package's config/maps)")
    arguments = parser.parse_args(words)
    folder = arguments.output
    floors = {name: drawn(arguments.floors, name, description)
              for document in read_documents(arguments.floors) for name, description in (document or {}).items()}
    folder.mkdir(parents=True, exist_ok=True)
    for name, floor in floors.items():
        PIL.Image.fromarray(floor.rows[::-1]).save(folder / f'{name}.png', optimize=True)
        (folder / f'{name}.yaml').write_text(YAML.format(name=name), encoding='utf-8')
