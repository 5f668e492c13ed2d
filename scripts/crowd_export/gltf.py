"""Files of glTF 2.0 in binary form (.glb): numbers in one buffer, everything else in JSON."""
import json

import numpy

FLOAT, BYTE, SHORT, UNSIGNED_SHORT = 5126, 5121, 5122, 5123
NUMBERS = {'float32': FLOAT, 'uint8': BYTE, 'int16': SHORT, 'uint16': UNSIGNED_SHORT}
TYPES = {1: 'SCALAR', 3: 'VEC3', 4: 'VEC4', 16: 'MAT4'}
VERTICES, INDICES = 34962, 34963  # what a part of the buffer is for


class Document:
    """A document that grows. Nodes, meshes and so on are referred to by their numbers."""

    def __init__(self, generator):
        self.lists = {}
        self.parts = {}  # of the buffer: arrays by (target, bytes of an element)
        self.sizes = {}
        self.animation = {'name': 'walk', 'channels': [], 'samplers': []}
        self.roots = []
        self.asset = {'version': '2.0', 'generator': generator}

    def add(self, kind, entry):
        """Adds an entry to the list of its kind, such as 'nodes'. Returns its number."""
        entries = self.lists.setdefault(kind, [])
        entries.append(entry)
        return len(entries) - 1

    def accessor(self, values, target=None, with_limits=False):
        """Adds an array; int16 are shares of 32767. Returns the number of its accessor."""
        values = numpy.ascontiguousarray(values)
        width = values.shape[1] if values.ndim == 2 else 1
        key = target, values.itemsize * width
        self.parts.setdefault(key, []).append(values)
        offset = self.sizes.get(key, 0)
        self.sizes[key] = offset + values.nbytes
        entry = {'bufferView': key, 'byteOffset': offset, 'componentType': NUMBERS[values.dtype.name],
                 'count': len(values), 'type': TYPES[width]}
        if values.dtype == numpy.int16:
            entry['normalized'] = True
        if with_limits:
            table = values.reshape(len(values), width)
            entry.update(min=table.min(axis=0).tolist(), max=table.max(axis=0).tolist())
        return self.add('accessors', entry)

    def node(self, name, parent=None, **entry):
        """Adds a node. Returns its number."""
        number = self.add('nodes', {'name': name, **entry})
        if parent is None:
            self.roots.append(number)
        else:
            self.lists['nodes'][parent].setdefault('children', []).append(number)
        return number

    def animate(self, node, path, times, values, interpolation='LINEAR'):
        """Adds keyframes of a property of a node. `times`: accessor."""
        sampler = {'input': times, 'output': self.accessor(values)}
        if interpolation != 'LINEAR':
            sampler['interpolation'] = interpolation
        self.animation['samplers'].append(sampler)
        self.animation['channels'].append({'sampler': len(self.animation['samplers']) - 1,
                                           'target': {'node': node, 'path': path}})

    def material(self, name, colour):
        """Adds a material with an sRGB colour, 0 to 1. Returns its number."""
        linear = [round(((part + 0.055) / 1.055) ** 2.4 if part > 0.04045 else part / 12.92, 4) for part in colour]
        return self.add('materials', {'name': name, 'pbrMetallicRoughness': {
            'baseColorFactor': [*linear, 1.0], 'metallicFactor': 0.0, 'roughnessFactor': 0.85}})

    def primitive(self, points, normals, indices, joints=None, weights=None):
        """Adds the triangles of a mesh. Returns its attributes and indices; a material is still missing."""
        attributes = {'POSITION': self.accessor(points.astype('float32'), VERTICES, True),
                      'NORMAL': self.accessor(normals.astype('float32'), VERTICES)}
        if joints is not None:
            attributes['JOINTS_0'] = self.accessor(joints.astype('uint8'), VERTICES)
            attributes['WEIGHTS_0'] = self.accessor(weights.astype('float32'), VERTICES)
        return {'attributes': attributes, 'indices': self.accessor(indices.astype('uint16').ravel(), INDICES)}

    def write(self, file):
        """Writes the document. Returns its size [bytes]."""
        views, offset, chunks = {}, 0, []
        for (target, stride), parts in self.parts.items():
            chunk = b''.join(part.tobytes() for part in parts)
            view = {'buffer': 0, 'byteOffset': offset, 'byteLength': len(chunk)}
            if target is not None:
                view['target'] = target
            if target == VERTICES:
                view['byteStride'] = stride
            views[target, stride] = self.add('bufferViews', view)
            chunk += b'\0' * (-len(chunk) % 4)
            offset += len(chunk)
            chunks.append(chunk)
        for accessor in self.lists['accessors']:
            accessor['bufferView'] = views[accessor['bufferView']]
        if self.animation['channels']:
            self.add('animations', self.animation)
        document = {'asset': self.asset, 'scene': 0, 'scenes': [{'nodes': self.roots}], **self.lists,
                    'buffers': [{'byteLength': offset}]}
        text = json.dumps(document, separators=(',', ':')).encode()
        text += b' ' * (-len(text) % 4)
        sizes = numpy.array([len(text), offset])
        total = int(12 + 16 + sizes.sum())
        with open(file, 'wb') as stream:
            stream.write(b'glTF' + numpy.array([2, total], '<u4').tobytes())
            stream.write(numpy.uint32(sizes[0]).tobytes() + b'JSON' + text)
            stream.write(numpy.uint32(sizes[1]).tobytes() + b'BIN\0')
            stream.writelines(chunks)
        return total


def smoothed(shape):
    """Returns points, normals and indices of triangles [triangle, corner, coordinate]: round, with edges that are
    sharper than 60 degrees."""
    faces = numpy.cross(shape[:, 1] - shape[:, 0], shape[:, 2] - shape[:, 0])
    shape, faces = shape[numpy.linalg.norm(faces, axis=1) > 1e-9], faces[numpy.linalg.norm(faces, axis=1) > 1e-9]
    directions = faces / numpy.linalg.norm(faces, axis=1)[:, None]
    corners = shape.reshape(-1, 3)
    _, places = numpy.unique(numpy.round(corners, 5), axis=0, return_inverse=True)
    of = numpy.repeat(numpy.arange(len(faces)), 3)
    near = (places[:, None] == places[None]) & (directions[of] @ directions[of].T > 0.5)
    normals = near.astype(float) @ faces[of]
    normals /= numpy.linalg.norm(normals, axis=1)[:, None]
    rows, indices = numpy.unique(numpy.round(numpy.hstack([corners, normals]), 4), axis=0, return_inverse=True)
    units = rows[:, 3:] / numpy.linalg.norm(rows[:, 3:], axis=1)[:, None]
    return rows[:, :3], units, indices.ravel()
