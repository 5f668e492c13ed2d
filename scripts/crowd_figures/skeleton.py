"""The skeleton of a person: joints, their places when standing, and legs that reach for a place of the foot.

Figures are in m, x ahead, y left, z up. Rotations are scipy's, with one element for each frame."""
import typing

import numpy
from scipy.spatial.transform import Rotation

# Lengths as shares of the height H after Drillis and Contini (1966), in Winter, Biomechanics and Motor Control of Human
# Movement, 2009: thigh 0.245 H, shank 0.246 H, ankle 0.039 H, upper arm 0.186 H, forearm 0.146 H; H = 1.75 m.
THIGH, SHANK, ANKLE = 0.43, 0.43, 0.07
HIP = THIGH + SHANK + ANKLE  # height when standing straight [m]
UPPER_ARM, FOREARM = 0.325, 0.255
SEAT = 0.52  # height of the hip of a person who sits [m]
HEEL, TOE = -0.07, 0.18  # where a foot touches the floor, ahead of the ankle [m]


class Joint(typing.NamedTuple):
    """A joint, and where it is in its parent when the person stands upright."""
    name: str
    parent: str
    offset: tuple


def joints(half_shoulders, half_hips=0.09):
    """Returns the joints, parents first."""
    found = [Joint('hips', None, (0.0, 0.0, HIP + 0.03)), Joint('spine', 'hips', (0.0, 0.0, 0.1)),
             Joint('chest', 'spine', (0.0, 0.0, 0.18)), Joint('head', 'chest', (0.0, 0.0, 0.27))]
    for side, sign in (('left', 1), ('right', -1)):
        found += [Joint(f'{side}_upper_arm', 'chest', (0.0, sign * half_shoulders, 0.18)),
                  Joint(f'{side}_forearm', f'{side}_upper_arm', (0.0, 0.0, -UPPER_ARM)),
                  Joint(f'{side}_hand', f'{side}_forearm', (0.0, 0.0, -FOREARM)),
                  Joint(f'{side}_thigh', 'hips', (0.0, sign * half_hips, -0.03)),
                  Joint(f'{side}_shank', f'{side}_thigh', (0.0, 0.0, -THIGH)),
                  Joint(f'{side}_foot', f'{side}_shank', (0.0, 0.0, -SHANK))]
    return found


def rest_places(skeleton):
    """Returns the place of each joint of a person who stands upright."""
    places = {}
    for joint in skeleton:
        places[joint.name] = numpy.array(joint.offset) + (places[joint.parent] if joint.parent else 0.0)
    return places


def turned(axis, angles):
    """Returns rotations about an axis, 'x', 'y' or 'z', by angles [rad]."""
    return Rotation.from_euler(axis, numpy.atleast_1d(angles))


def reach(hips, ankles, ahead):
    """Returns the rotation of the thigh in the world, and the bend of the knee [rad], that bring an ankle to its place.

    `ahead`: directions in which the knee points. An ankle that is too far away is approached with a straight leg."""
    way = ankles - hips
    distance = numpy.linalg.norm(way, axis=1)
    span = numpy.clip(distance, 0.3 * (THIGH + SHANK), 0.9999 * (THIGH + SHANK))
    down = way / distance[:, None]
    left = numpy.cross(ahead, down)
    left /= numpy.linalg.norm(left, axis=1)[:, None]
    fore = numpy.cross(down, left)
    cosine = (THIGH ** 2 + span ** 2 - SHANK ** 2) / (2 * THIGH * span)
    thigh = cosine[:, None] * down + numpy.sqrt(1 - cosine ** 2)[:, None] * fore
    rotation = Rotation.from_matrix(numpy.stack([numpy.cross(left, -thigh), left, -thigh], axis=2))
    inner = (THIGH ** 2 + SHANK ** 2 - span ** 2) / (2 * THIGH * SHANK)
    return rotation, numpy.pi - numpy.arccos(inner)


def joint_places(skeleton, rotations, hips):
    """Returns place and rotation of each joint, given the places of the hips, and local rotations by joint; a joint
    without one is not bent."""
    found = {}
    for joint in skeleton:
        place, turn = found[joint.parent] if joint.parent else (0.0, Rotation.identity(len(hips)))
        found[joint.name] = (place + turn.apply(joint.offset) if joint.parent else hips,
                             turn * rotations[joint.name] if joint.name in rotations else turn)
    return found
