"""Motion of one person as BVH (Biovision hierarchy): metres, y up; a person with all rotations 0 looks along z."""
import numpy
from scipy.spatial.transform import Rotation

from .people import floor, local, person_quaternions

ORDER = 'ZXY'  # of the rotations in a line of frames
ENDS = {'head': (0.0, 0.0, 0.24), 'hand': (0.0, 0.0, -0.16), 'foot': (0.18, 0.0, -0.07)}


def hierarchy(skeleton, scale):
    """Yields the lines of the hierarchy."""
    children = {}
    for joint in skeleton:
        children.setdefault(joint.parent, []).append(joint)

    def lines(joint, depth):
        tabs = '\t' * depth
        yield f"{tabs}{'JOINT' if joint.parent else 'ROOT'} {joint.name}"
        yield f'{tabs}{{'
        yield f'{tabs}\tOFFSET {numbers(local(numpy.array(joint.offset) * scale))}'
        positions = '' if joint.parent else ' Xposition Yposition Zposition'
        yield f"{tabs}\tCHANNELS {3 if joint.parent else 6}{positions} {' '.join(f'{axis}rotation' for axis in ORDER)}"
        for child in children.get(joint.name, []):
            yield from lines(child, depth + 1)
        if joint.name not in children:
            end = local(numpy.array(ENDS[joint.name.split('_')[-1]]) * scale)
            yield f'{tabs}\tEnd Site\n{tabs}\t{{\n{tabs}\t\tOFFSET {numbers(end)}\n{tabs}\t}}'
        yield f'{tabs}}}'
    yield from lines(children[None][0], 0)


def numbers(values):
    return ' '.join(f'{value:.6g}' for value in values)


def order_of(skeleton):
    """Returns the joints in the order of the hierarchy: depth first."""
    def below(name):
        for joint in skeleton:
            if joint.parent == name:
                yield joint
                yield from below(joint.name)
    return list(below(None))


def columns_of(person):
    """Returns the columns of all frames: place of the hips, and rotations [degrees]."""
    turns = Rotation.from_quat(person_quaternions(person.trunk.headings))
    places = floor(numpy.column_stack([person.places(), numpy.zeros(len(person.times))]))
    columns = [places + turns.apply(local(person.trunk.hips * person.scale))]
    for joint in order_of(person.skeleton):
        rotation = Rotation.identity(len(person.times))
        if joint.name in person.rotations:
            rotation = Rotation.from_quat(person.rotations[joint.name].as_quat()[:, [1, 2, 0, 3]])
        columns.append((turns * rotation if joint.parent is None else rotation).as_euler(ORDER, degrees=True))
    return numpy.hstack(columns)


def write(file, person, fps):
    """Writes the walk of a person."""
    rows = columns_of(person)
    with open(file, 'w', encoding='utf-8') as stream:
        stream.write('HIERARCHY\n' + '\n'.join(hierarchy(person.skeleton, person.scale)))
        stream.write(f'\nMOTION\nFrames: {len(rows)}\nFrame Time: {1 / fps:.8f}\n')
        numpy.savetxt(stream, rows, '%.5g')
