"""Binary STL files."""
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
