"""Reads binary glTF files, as a viewer does: where nodes are at any time."""
import json

import numpy
from scipy.spatial.transform import Rotation, Slerp

WIDTHS = {'SCALAR': 1, 'VEC3': 3, 'VEC4': 4, 'MAT4': 16}
TYPES = {5126: '<f4', 5123: '<u2', 5122: '<i2', 5121: 'u1'}


class Glb:
    """A file: its JSON `document`, and its numbers."""

    def __init__(self, file):
        content = open(file, 'rb').read()
        length = int.from_bytes(content[12:16], 'little')
        self.document, self.binary = json.loads(content[20:20 + length]), content[28 + length:]
        self.nodes = self.document['nodes']
        self.parents = {child: node for node, entry in enumerate(self.nodes) for child in entry.get('children', [])}
        animation, = self.document.get('animations', [{'channels': [], 'samplers': []}])
        self.channels = {(channel['target']['node'], channel['target']['path']):
                         animation['samplers'][channel['sampler']] for channel in animation['channels']}

    def named(self, name):
        """Returns the number of the only node of a name."""
        number, = (number for number, node in enumerate(self.nodes) if node['name'] == name)
        return number

    def below(self, node, name):
        """Returns the node of a name in the tree below a node."""
        for child in self.nodes[node].get('children', []):
            found = child if self.nodes[child]['name'] == name else self.below(child, name)
            if found is not None:
                return found
        return None

    def values(self, number):
        """Returns the numbers of an accessor, one row for each element."""
        accessor = self.document['accessors'][number]
        view = self.document['bufferViews'][accessor['bufferView']]
        kind, width = numpy.dtype(TYPES[accessor['componentType']]), WIDTHS[accessor['type']]
        found = numpy.frombuffer(self.binary, kind, accessor['count'] * width,
                                 view.get('byteOffset', 0) + accessor.get('byteOffset', 0)).reshape(-1, width)
        return numpy.maximum(found / 32767, -1.0) if accessor.get('normalized') else found.astype(float)

    def keys(self, node, path):
        """Returns the times and the values of keyframes."""
        sampler = self.channels[node, path]
        return self.values(sampler['input'])[:, 0], self.values(sampler['output'])

    def animated(self, node, path, times):
        """Returns a property of a node at times [s]."""
        if (node, path) not in self.channels:
            default = {'translation': [0, 0, 0], 'rotation': [0, 0, 0, 1], 'scale': [1, 1, 1]}[path]
            return numpy.tile(self.nodes[node].get(path, default), (len(times), 1))
        keys, values = self.keys(node, path)
        if self.channels[node, path].get('interpolation') == 'STEP':
            return values[numpy.maximum(0, numpy.searchsorted(keys, times + 1e-6, side='right') - 1)]
        times = numpy.clip(times, keys[0], keys[-1])
        if path == 'rotation':
            return Slerp(keys, Rotation.from_quat(values))(times).as_quat()
        return numpy.column_stack([numpy.interp(times, keys, column) for column in values.T])

    def world(self, node, times):
        """Returns the matrix of a node in the world for each time."""
        matrices = numpy.tile(numpy.eye(4), (len(times), 1, 1))
        turns = Rotation.from_quat(self.animated(node, 'rotation', times)).as_matrix()
        matrices[:, :3, :3] = turns * self.animated(node, 'scale', times)[:, None]
        matrices[:, :3, 3] = self.animated(node, 'translation', times)
        return self.world(self.parents[node], times) @ matrices if node in self.parents else matrices
