"""The bodies of people: shapes of one colour each around the joints of the skeleton, in m, who stand upright."""
import typing

import numpy

from .shapes import ellipse, ellipsoid, join, limb, loft
from .skeleton import ANKLE, HEEL, HIP, TOE, joints, rest_places

FINE = 8  # corners of bodies with noses, ears, and all rings
BLEND = 0.045  # half height of the part of a body that bends with a joint [m]


class Build(typing.NamedTuple):
    """A kind of body; half widths of a person 1.75 m tall [m]."""
    name: str
    shoulders: float
    waist: float
    hips: float
    skirt: bool = False
    long_hair: bool = False
    head: float = 1.0  # size
    sleeves: float = 0.6  # how far they reach down the upper arm, 2: to the wrist


BUILDS = {build.name: build for build in (
    Build('broad', 0.178, 0.15, 0.155, sleeves=2.0), Build('slim', 0.16, 0.12, 0.16, skirt=True, long_hair=True),
    Build('child', 0.155, 0.135, 0.14, head=1.32))}


class Part(typing.NamedTuple):
    """A shape of one colour. `chain`: joints from its upper end to its lower one, which move it."""
    colour: str  # skin, hair, shirt, trousers or shoes
    shape: numpy.ndarray  # triangles [triangle, corner, coordinate]
    chain: tuple


def few(rows, corners):
    """Returns rows, or every second one of those between the ends if a body has few corners."""
    return rows if corners >= FINE else [rows[0], *rows[1:-1:2], rows[-1]]


def rings(rows, corners):
    """Returns a closed shape through horizontal rings (height, centre ahead, half depth, half width), lowest first."""
    rows = few(rows, corners)
    return loft([ellipse((x, 0, z), ahead, left, corners) for z, x, ahead, left in rows])


def trunk(build, corners):
    """Pelvis and shirt."""
    shoulders, waist, hips = build.shoulders, build.waist, build.hips
    pelvis = rings([(HIP - 0.1, 0, 0.06, hips * 0.6), (HIP - 0.05, -0.008, 0.105, hips * 0.96),
                    (HIP + 0.01, -0.008, 0.11, hips - 0.002), (HIP + 0.08, -0.004, 0.085, waist - 0.02)], corners)
    shirt = rings([(HIP - 0.015, -0.006, 0.127, hips + 0.015), (HIP + 0.03, -0.006, 0.123, hips + 0.013),
                   (HIP + 0.13, 0, 0.109, waist + 0.008),
                   (1.16, 0, 0.107, waist + 0.008), (1.29, 0.004, 0.123, (waist + shoulders) / 2 + 0.008),
                   (1.38, 0, 0.118, shoulders + 0.003), (1.435, -0.008, 0.094, shoulders - 0.012),
                   (1.475, -0.012, 0.068, shoulders * 0.5), (1.495, -0.01, 0.055, 0.058)], corners)
    return [Part('trousers', pelvis, ('hips',)), Part('shirt', shirt, ('chest', 'spine', 'hips'))]


def skirt(build, corners):
    """A skirt to the knees, which both thighs move."""
    return Part('trousers', rings([(HIP - 0.4, 0.005, 0.148, 0.2), (HIP - 0.2, 0, 0.14, 0.185),
                                   (HIP - 0.03, -0.005, 0.118, build.hips + 0.006),
                                   (HIP + 0.08, 0, 0.09, build.waist - 0.01)], corners),
                ('hips', 'left_thigh right_thigh'))


def arm(build, side, sign, places, corners):
    """Sleeve, forearm and hand."""
    top, elbow, wrist = (places[f'{side}_{name}'] for name in ('upper_arm', 'forearm', 'hand'))
    chain = ('chest', f'{side}_upper_arm', f'{side}_forearm', f'{side}_hand')

    def between(share):
        return top + (elbow - top) * share if share < 1 else elbow + (wrist - elbow) * (share - 1)
    line = [between(share) for share in (0.08, 0.35, 0.7, 1.0, 1.25, 1.6, 2.0)]
    radii = numpy.array([0.05, 0.047, 0.042, 0.038, 0.038, 0.033, 0.027])
    cap = top + numpy.array([0, -sign * 0.012, 0.028])
    sleeve_end = between(build.sleeves)
    inside = [i for i, point in enumerate(line) if point[2] > sleeve_end[2] + 0.02]
    sleeve = limb([cap, top + (0, 0, -0.005), *(line[i] for i in inside), sleeve_end],
                  numpy.r_[0.022, 0.05, radii[inside] + 0.008, radii[inside[-1]] + 0.006], corners)
    palm = ellipsoid(wrist + (0.008, 0, -0.075), (0.042, 0.02, 0.085), corners, 5 if corners >= FINE else 3)
    parts = [Part('shirt', sleeve, chain[:3]), Part('skin', palm, (chain[3],))]
    return parts if build.sleeves >= 2 else [*parts, Part('skin', limb(line[1:], radii[1:], corners), chain[1:])]


def leg(build, side, places, corners):
    """Trousers or a bare leg, and a shoe."""
    hip, knee, ankle = (places[f'{side}_{name}'] for name in ('thigh', 'shank', 'foot'))
    shares = ((hip, knee, 0.04), (hip, knee, 0.35), (hip, knee, 0.75), (hip, knee, 1.0), (knee, ankle, 0.28),
              (knee, ankle, 0.7), (knee, ankle, 1.0))
    radii = (0.084, 0.08, 0.062, 0.054, 0.055, 0.042, 0.037)
    first = 2 if build.skirt else 0  # the skirt hides the rest
    line = [start + (end - start) * share for start, end, share in shares][first:]
    chain = tuple(f'{side}_{name}' for name in ('thigh', 'shank', 'foot'))
    legs = limb(line, numpy.array(radii[first:]) + (0.0 if build.skirt else 0.008), corners)
    return [Part('skin' if build.skirt else 'trousers', legs, ('hips', *chain)),
            Part('shoes', shoe(corners) + numpy.array([0, places[f'{side}_foot'][1], 0]), (chain[2],))]


def shoe(corners):
    """A shoe under an ankle at x = 0: from the heel to the toes, flat below."""
    profile = [(HEEL, 0.024, 0.05), (HEEL + 0.02, 0.034, 0.085), (0.02, 0.036, ANKLE + 0.03), (0.08, 0.042, 0.065),
               (0.13, 0.045, 0.05), (TOE, 0.036, 0.036), (TOE + 0.025, 0.016, 0.026)]
    return loft([[(x, wide, z0), (x, wide, 0.55 * high), (x, 0.55 * wide, high), (x, -0.55 * wide, high),
                  (x, -wide, 0.55 * high), (x, -wide, z0)][::-1]
                 for x, wide, high in few(profile, corners) for z0 in [0.012 if x in (HEEL, TOE + 0.025) else 0.0]])


def head(build, corners):
    """Face, nose and neck, and hair."""
    size = build.head
    middle = numpy.array([0.016, 0, 1.52 + 0.115 * size])

    def grown(shape):
        return shape * size + middle
    face = [grown(rings([(-0.118, 0.03, 0.03, 0.022), (-0.1, 0.026, 0.056, 0.046), (-0.05, 0.008, 0.083, 0.068),
                         (0.02, 0, 0.094, 0.076), (0.08, -0.004, 0.082, 0.066), (0.115, -0.01, 0.04, 0.03)], corners))]
    if corners >= FINE:
        nose = ((-0.045, 0.09, 0.022, 0.016), (-0.035, 0.093, 0.022, 0.015), (0.01, 0.088, 0.01, 0.008))
        face.append(grown(rings(nose, 5)))
        face += [grown(ellipsoid((-0.005, side * 0.077, -0.012), (0.018, 0.009, 0.03), 5, 4)) for side in (1, -1)]
    neck = rings([(1.47, -0.012, 0.056, 0.058), (1.51, -0.008, 0.05, 0.05), (1.58, 0.0, 0.05, 0.048)], corners)
    low = -0.02 if not build.long_hair else -0.03
    hair = [grown(rings([(low - 0.03, -0.062, 0.034, 0.06), (low + 0.02, -0.03, 0.072, 0.08),
                         (low + 0.075, -0.014, 0.094, 0.085), (0.098, -0.012, 0.084, 0.072),
                         (0.13, -0.016, 0.05, 0.044), (0.138, -0.02, 0.02, 0.018)], corners))]
    if build.long_hair:
        hair.append(grown(rings([(-0.19, -0.07, 0.026, 0.062), (-0.1, -0.068, 0.04, 0.084),
                                 (-0.02, -0.05, 0.052, 0.086), (0.06, -0.03, 0.07, 0.082)], corners)))
    return [Part('skin', join(*face), ('head',)), Part('skin', neck, ('head', 'chest')),
            Part('hair', join(*hair), ('head',))]


def skeleton_of(build):
    """Returns the joints of a Build."""
    return joints(build.shoulders + 0.012)


def parts_of(build, corners=10):
    """Returns skeleton and Parts of a Build; `corners`: how round its limbs are."""
    skeleton = skeleton_of(build)
    places = rest_places(skeleton)
    parts = [*head(build, corners), *trunk(build, corners), *([skirt(build, corners)] if build.skirt else [])]
    for side, sign in (('left', 1), ('right', -1)):
        parts += [*arm(build, side, sign, places, max(4, corners - 2)), *leg(build, side, places, max(4, corners - 2))]
    return skeleton, parts


def weights_of(part, points, places):
    """Returns rows (joint, weights of all points) for the joints that move the points of a part."""
    weights, left = [], numpy.ones(len(points))
    for name in part.chain[:0:-1]:  # the lowest first: below its joint, a point is its own
        first = name.split()[0]
        blend = 0.25 if ' ' in name else BLEND  # a skirt
        share = numpy.clip((places[first][2] - points[:, 2]) / (2 * blend) + 0.5, 0.0, 1.0)
        if ' ' in name:
            side = numpy.clip(points[:, 1] / 0.2 + 0.5, 0.0, 1.0)
            share = 0.75 * numpy.clip((places[first][2] - points[:, 2]) / 0.3 + 0.2, 0.0, 1.0)
            weights += [(first, share * side), (name.split()[1], share * (1 - side))]
        elif first.endswith('upper_arm'):
            share = numpy.clip((places[first][2] + 0.04 - points[:, 2]) / 0.06, 0.0, 1.0)
            weights.append((first, share * left))
        else:
            weights.append((first, share * left))
        left = left * (1 - share)
    return [*weights, (part.chain[0], left)]
