"""The figures of RViz: people who walk, stand and sit, in meshes of one colour each: head, shirt, and dark parts (hair,
trousers or skirt, shoes). The fewer meshes, the faster RViz draws them."""
import numpy

from .bodies import BUILDS, parts_of, weights_of
from .footsteps import Body, WALK_RATIO
from .gait import sit, walk
from .skeleton import joint_places, rest_places

FRAMES = 8  # pictures of a walking cycle; one more of a person who stands
STEP = 0.7  # length of a step [m]: half a cycle of marker_gait.h
FRAMES_OF_STEP = 16  # of the walk that the pictures are taken from
CORNERS = 6  # of limbs


def straight(speed):
    """Returns a Body that walks straight on at a speed [m/s]."""
    count = 12 * FRAMES_OF_STEP
    times = numpy.arange(count) * WALK_RATIO / STEP / FRAMES_OF_STEP
    return Body(times, numpy.column_stack([speed * times, 0 * times]), 0 * times, slice(0, count))


def poses(skeleton):
    """Returns the poses of the pictures: rotations by joint, and the place of the hips."""
    found = []
    for speed, frames in ((STEP ** 2 / WALK_RATIO, FRAMES), (0.0, 1)):
        trunk, rotations, feet = walk(straight(speed), skeleton, 1.0, 1.0)
        landed = numpy.flatnonzero(numpy.diff(feet[0].stands.astype(int)) > 0)
        first = landed[len(landed) // 2] if len(landed) else 0
        for frame in first + (numpy.arange(frames) + 0.5) * 2 * FRAMES_OF_STEP / FRAMES:
            found.append(({name: turns[[int(frame)]] for name, turns in rotations.items()}, trunk.hips[[int(frame)]]))
    return found


def posed(part, skeleton, rotations, hips):
    """Returns the shape of a part of a person with these rotations."""
    rest, now = rest_places(skeleton), joint_places(skeleton, rotations, hips)
    points = part.shape.reshape(-1, 3)
    moved = sum(share[:, None] * (now[joint][1].apply(points - rest[joint]) + now[joint][0])
                for joint, share in weights_of(part, points, rest))
    return moved.reshape(part.shape.shape)


def mesh_of(part):
    """Returns in which mesh a part is."""
    if part.colour == 'skin' and part.chain[0] == 'head':
        return 'head'
    is_arm = any('arm' in joint or 'hand' in joint for joint in part.chain)
    return 'shirt' if part.colour == 'shirt' or is_arm else 'dark'


def person(skeleton, parts, rotations, hips, is_level):
    """Returns the meshes of a person by their names. `is_level`: what is above the legs is as high in all pictures, as
    the head is."""
    lift = numpy.array([0, 0, rest_places(skeleton)['hips'][2] - hips[0, 2]]) if is_level else 0.0
    found = {}
    for part in parts:
        name = mesh_of(part)
        shape = posed(part, skeleton, rotations, hips)
        found.setdefault(name, []).append(shape if name == 'dark' and part.colour != 'hair' else shape + lift)
    return {name: numpy.concatenate(shapes) for name, shapes in found.items()}


def shapes():
    """Returns all meshes by the names of their files."""
    made = {}
    for build in ('broad', 'slim'):
        skeleton, parts = parts_of(BUILDS[build], CORNERS)
        still = [part for part in parts if 'head' in part.chain]
        moving = [part for part in parts if 'head' not in part.chain]
        for frame, (rotations, hips) in enumerate(poses(skeleton)):
            meshes = person(skeleton, moving, rotations, hips, True)
            dark = meshes['dark'] - numpy.array([0, 0, meshes['dark'][:, :, 2].min()])  # the lower foot is on the floor
            heads = person(skeleton, still, {}, rest_places(skeleton)['hips'][None], False)
            made[f'{build}_dark_{frame}'] = numpy.concatenate([dark, heads['dark']])
            made[f'{build}_shirt_{frame}'] = meshes['shirt']
            made[f'{build}_head'] = heads['head']
    skeleton, parts = parts_of(BUILDS['broad'], CORNERS)
    trunk, rotations, _ = sit(straight(0.0))
    meshes = person(skeleton, parts, {name: turns[[0]] for name, turns in rotations.items()}, trunk.hips[:1], False)
    return {**made, **{f'sitting_{name}': shape for name, shape in meshes.items()}}
