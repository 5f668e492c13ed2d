"""People in a glTF document: a skin over the joints of each person, meshes that they share, and keyframes."""
import numpy
from crowd_figures import belongings
from crowd_figures.bodies import BUILDS, parts_of, weights_of
from crowd_figures.keys import keyframes
from crowd_figures.skeleton import rest_places
from scipy.spatial.transform import Rotation

from .gltf import smoothed
from .people import COLOURS, BELONGINGS, colours_of, floor, local, local_quaternions, person_quaternions

BEND, FREE_BEND = 0.0015, 0.02  # bounds of keyframes: parts of quaternions of legs that stand, and of others
LEG = 'thigh', 'shank', 'foot'


class Figures:
    """Adds people to a document, whose animation lasts from 0 to `duration` [s]."""

    def __init__(self, document, duration):
        self.document, self.duration = document, duration
        self.primitives, self.meshes, self.materials, self.binds = {}, {}, {}, {}
        self.things = {}

    def add(self, person):
        """Adds a person."""
        node = self.document.node(person.name, **self.begin(person), extras={
            'person': person.number, 'figure': person.figure, 'recorded': person.recorded})
        joints = {}
        for joint in person.skeleton:
            place = person.trunk.hips[0] if joint.parent is None else joint.offset
            rotation = {}
            if joint.name in person.rotations:
                rotation = {'rotation': local_quaternions(person.rotations[joint.name][:1])[0].tolist()}
            joints[joint.name] = self.document.node(joint.name, joints.get(joint.parent, node),
                                                    translation=local(place).tolist(), **rotation)
        skin = self.document.add('skins', {'name': person.name, 'skeleton': node, 'joints': list(joints.values()),
                                           'inverseBindMatrices': self.bind(person)})
        self.document.node(f'{person.name}_body', mesh=self.mesh(person), skin=skin)
        self.give(person, node, joints)
        self.move(person, node, joints)
        self.show(person, node)

    @staticmethod
    def begin(person):
        """Returns the properties of the node of a person at its first frame."""
        return {'translation': floor([*person.places()[0], 0.0]).tolist(), 'scale': [person.scale] * 3,
                'rotation': person_quaternions(person.trunk.headings[:1])[0].tolist()}

    def bind(self, person):
        """Returns the accessor of the inverse bind matrices of a skeleton."""
        if person.build not in self.binds:
            places = local(numpy.array(list(rest_places(person.skeleton).values())))
            matrices = numpy.tile(numpy.eye(4), (len(places), 1, 1))
            matrices[:, 3, :3] = -places  # column by column
            self.binds[person.build] = self.document.accessor(matrices.reshape(-1, 16).astype('float32'))
        return self.binds[person.build]

    def material(self, colour):
        name = '#' + ''.join(f'{round(255 * part):02x}' for part in colour)
        if name not in self.materials:
            self.materials[name] = self.document.material(name, colour)
        return self.materials[name]

    def mesh(self, person):
        """Returns the mesh of a build in the colours of a person. Meshes of a build share all numbers."""
        if person.build not in self.primitives:
            self.primitives[person.build] = self.shape(person.build)
        materials = {part: self.material(colour) for part, colour in colours_of(person).items()}
        key = person.build, *materials.values()
        if key not in self.meshes:
            self.meshes[key] = self.document.add('meshes', {'name': person.build, 'primitives': [
                {**primitive, 'material': materials[part]}
                for part, primitive in self.primitives[person.build].items()]})
        return self.meshes[key]

    def shape(self, build):
        """Returns the primitives of a build by their colours' names."""
        skeleton, parts = parts_of(BUILDS[build])
        places = rest_places(skeleton)
        numbers = {name: number for number, name in enumerate(places)}
        found = {}
        for colour in COLOURS:
            columns, count = [[], [], [], [], []], 0
            for part in (part for part in parts if part.colour == colour):
                points, normals, indices = smoothed(part.shape)
                joints, weights = influences(weights_of(part, points, places), numbers)
                for column, values in zip(columns, (local(points), local(normals), indices + count, joints, weights)):
                    column.append(values)
                count += len(points)
            found[colour] = self.document.primitive(*map(numpy.concatenate, columns))
        return found

    def thing(self, name, shape):
        """Returns the mesh of a belonging."""
        if name not in self.things:
            points, normals, indices = smoothed(shape)
            primitive = self.document.primitive(local(points), local(normals), indices)
            self.things[name] = self.document.add('meshes', {'name': name, 'primitives': [
                {**primitive, 'material': self.material(BELONGINGS)}]})
        return self.things[name]

    def give(self, person, node, joints):
        """Adds what a person has with it."""
        if person.figure in ('wheelchair', 'trolley'):
            shape = getattr(belongings, person.figure)()
            self.document.node(person.figure, node, mesh=self.thing(person.figure, shape))
        elif person.figure == 'old':
            self.document.node('stick', joints['right_hand'], mesh=self.thing('stick', belongings.stick_in_hand()),
                               rotation=local_quaternions(Rotation.from_euler('y', [0.57]))[0].tolist())

    def move(self, person, node, joints):
        """Adds the keyframes of a walk."""
        trunk, rotations = person.trunk, {name: local_quaternions(turn) for name, turn in person.rotations.items()}
        channels = [(node, 'translation', floor(numpy.column_stack([person.places(), 0 * person.times]))),
                    (node, 'rotation', person_quaternions(trunk.headings)),
                    (joints['hips'], 'translation', local(trunk.hips))]
        channels += [(joints['hips'], 'rotation', rotations.pop('hips'))] if 'hips' in rotations else []
        self.animate(person.times, trunk.keys, channels)
        for side, foot in zip(('left', 'right'), person.feet):
            bound = numpy.where(foot.stands, BEND, FREE_BEND)[:, None]
            leg = {joints[f'{side}_{bone}']: rotations.pop(f'{side}_{bone}') for bone in LEG}
            self.reduce(person.times, leg, bound)
        self.reduce(person.times, {joints[name]: values for name, values in rotations.items()}, FREE_BEND)

    def reduce(self, times, rotations, bound):
        """Adds rotations by joint with common keyframes, as few as the bound permits."""
        if rotations:
            kept = keyframes(numpy.hstack(list(rotations.values())), bound)
            self.animate(times, kept, [(joint, 'rotation', values) for joint, values in rotations.items()])

    def animate(self, times, kept, channels):
        """Adds keyframes of channels (node, path, values) that move; the others have one in their nodes."""
        accessor = None
        for node, path, values in channels:
            if numpy.ptp(values, axis=0).max() > 1e-6:
                if accessor is None:
                    accessor = self.document.accessor(times[kept].astype('float32'), None, True)
                values = values[kept]
                self.document.animate(node, path, accessor, values.astype('float32') if path == 'translation' else
                                      numpy.round(values * 32767).astype(numpy.int16))

    def show(self, person, node):
        """Lets a person appear in its first frame, and disappear after its last one."""
        end = 2 * person.times[-1] - person.times[-2]
        shown = [(0.0, 0.0), (person.times[0], person.scale), (end, 0.0)]
        if person.times[0] <= 0.0:
            shown = shown[1:]
        if end > self.duration + 1e-6:
            shown = shown[:-1]
        if len(shown) > 1:
            times = self.document.accessor(numpy.array([time for time, _ in shown], 'float32'), None, True)
            sizes = numpy.array([[size] * 3 for _, size in shown], 'float32')
            self.document.animate(node, 'scale', times, sizes, 'STEP')


def influences(rows, numbers):
    """Returns the four joints of each point and their weights, given rows (joint, weights)."""
    joints, weights = numpy.zeros((len(rows[0][1]), 4)), numpy.zeros((len(rows[0][1]), 4))
    for column, (name, shares) in enumerate(rows):
        joints[:, column], weights[:, column] = numbers[name], shares
    weights /= weights.sum(axis=1)[:, None]
    joints[weights == 0] = 0
    return joints, weights
