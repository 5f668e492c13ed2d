"""Floors that are drawn cell by cell, and written in the format of map_server."""
import struct
import zlib

RESOLUTION = 0.05  # [m]
CELLS_PER_METRE = 20
MARGIN = 0.5  # of unknown cells around the floor [m]
OCCUPIED, UNKNOWN, FREE = 0, 205, 254  # grey values of map_server's map_saver

YAML = '''image: {name}.png
resolution: {resolution}
origin: [{origin}, {origin}, 0]
occupied_thresh: 0.65
free_thresh: 0.196
negate: 0
'''


def cells(metres):
    """Returns the number of the cell border at a coordinate, which must be a multiple of the resolution."""
    border = round(metres * CELLS_PER_METRE)
    if abs(border - metres * CELLS_PER_METRE) > 1e-6:
        raise ValueError(f'{metres} m is not a multiple of {RESOLUTION} m')
    return border


class Floor:
    """A rectangular floor whose lower left inner corner is the origin. Coordinates in metres, multiples of 0.05."""

    def __init__(self, width, height, wall=0.2):
        self.size = [cells(side + 2 * MARGIN) for side in (width, height)]
        self.rows = [bytearray([UNKNOWN]) * self.size[0] for _ in range(self.size[1])]  # from the bottom
        self.fill(-wall, -wall, width + wall, height + wall, OCCUPIED)
        self.fill(0, 0, width, height, FREE)

    def fill(self, left, bottom, right, top, value):
        """Gives a value to the cells of a box."""
        margin = cells(MARGIN)
        first, last = cells(left) + margin, cells(right) + margin
        for row in range(cells(bottom) + margin, cells(top) + margin):
            self.rows[row][first:last] = bytes([value]) * (last - first)

    def block(self, left, bottom, right, top):
        """Adds a wall or a piece of furniture."""
        self.fill(left, bottom, right, top, OCCUPIED)

    def opening(self, left, bottom, right, top):
        """Removes walls, for a door."""
        self.fill(left, bottom, right, top, FREE)

    def png(self):
        """Returns the map as a PNG file of 8-bit grey values, whose first row is the uppermost."""
        raw = b''.join(b'\0' + bytes(row) for row in reversed(self.rows))
        header = struct.pack('>IIBBBBB', *self.size, 8, 0, 0, 0, 0)
        chunks = [(b'IHDR', header), (b'IDAT', zlib.compress(raw, 9)), (b'IEND', b'')]
        return b'\x89PNG\r\n\x1a\n' + b''.join(chunk(kind, data) for kind, data in chunks)

    def yaml(self, name):
        """Returns the text of map_server's YAML file."""
        return YAML.format(name=name, resolution=RESOLUTION, origin=-MARGIN)


def chunk(kind, data):
    """Returns a chunk of a PNG file."""
    return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))
