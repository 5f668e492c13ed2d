"""Closed shapes of triangles, arrays [triangle, corner, coordinate] in m (x ahead, y left, z up), and their STL files.

Seen from outside, the corners of a triangle are counterclockwise."""
import numpy

TRIANGLE = numpy.dtype([('normal', '<f4', 3), ('corners', '<f4', (3, 3)), ('attributes', '<u2')])
HEADER = b'social_crowd: scripts/draw_figures'


def write(file, shape):
    """Writes triangles [triangle, corner, coordinate]. Returns the file."""
    normals = numpy.cross(shape[:, 1] - shape[:, 0], shape[:, 2] - shape[:, 0])
    rows = numpy.zeros(len(shape), TRIANGLE)
    rows['normal'] = normals / numpy.maximum(numpy.linalg.norm(normals, axis=1), 1e-12)[:, None]
    rows['corners'] = shape
    file.write_bytes(HEADER.ljust(80) + numpy.uint32(len(shape)).tobytes() + rows.tobytes())
    return file


def loft(rings):
    """A closed shape through rings [corner, coordinate], counterclockwise as seen from the end of the shape."""
    triangles = []
    count = len(rings[0])
    for low, high in zip(rings, rings[1:]):
        for i, j in zip(range(count), (*range(1, count), 0)):
            triangles += [(low[i], low[j], high[j]), (low[i], high[j], high[i])]
    for ring, order in ((rings[0], -1), (rings[-1], 1)):
        triangles += [(ring[0], *ring[i:i + 2][::order]) for i in range(1, count - 1)]
    return numpy.array(triangles)


def ellipse(centre, ahead, left, corners):
    """A horizontal ring with these half axes [m]."""
    angles = numpy.arange(corners) * 2 * numpy.pi / corners
    return numpy.array(centre) + numpy.stack([ahead * numpy.cos(angles), left * numpy.sin(angles), 0 * angles], axis=1)


def ellipsoid(centre, half_axes, corners, rings):
    """An ellipsoid; its poles are small flat ends."""
    bends = numpy.linspace(-1.35, 1.35, rings)
    return loft([ellipse((centre[0], centre[1], centre[2] + half_axes[2] * numpy.sin(bend)),
                         half_axes[0] * numpy.cos(bend), half_axes[1] * numpy.cos(bend), corners) for bend in bends])


def limb(points, radii, corners=6):
    """A tube through points [m] of a vertical plane along x, with a radius [m] at each of them."""
    points = numpy.array(points, float)
    ways = numpy.diff(points, axis=0)
    ways /= numpy.linalg.norm(ways, axis=1)[:, None]
    ways = numpy.concatenate([ways[:1], ways[:-1] + ways[1:], ways[-1:]])
    angles = numpy.arange(corners) * 2 * numpy.pi / corners
    rings = []
    for point, way, radius in zip(points, ways, radii):
        across = numpy.array([0.0, 1.0, 0.0])
        other = numpy.cross(way / numpy.linalg.norm(way), across)
        rings.append(point + radius * (numpy.cos(angles)[:, None] * across - numpy.sin(angles)[:, None] * other))
    return loft([ring[::-1] for ring in rings])


def box(low, high):
    """A box between two corners [m]."""
    corners = numpy.array([(0, 0), (1, 0), (1, 1), (0, 1)])
    low, high = numpy.array(low, float), numpy.array(high, float)
    rings = [numpy.column_stack([low[:2] + corners * (high - low)[:2], numpy.full(4, z)]) for z in (low[2], high[2])]
    return loft(rings)


def wheel(centre, radius, width, corners):
    """A disc that stands along x."""
    across = numpy.array([0.0, width / 2, 0.0])
    flat = ellipse((0, 0, 0), radius, radius, corners)[:, [0, 2, 1]]
    return loft([numpy.array(centre) + across * side + flat for side in (1, -1)])


def join(*shapes):
    """Several shapes as one."""
    return numpy.concatenate(shapes)
