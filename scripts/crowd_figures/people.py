"""The bodies of people and their files: heads, shirts, and dark parts (hair, trousers or skirt, shoes).

Each is a mesh of one colour: the fewer meshes, the faster RViz draws them.
"""
import math
import typing

import numpy

from .shapes import ellipse, ellipsoid, join, limb, loft

FRAMES = 8
HIP_SWING = 24.0  # [degrees] to each side: with a leg of 0.88 m a cycle of 1.4 m
ARM_SWING = 22.0
THIGH, SHIN, HIP = 0.43, 0.42, 0.92  # lengths, and height of the hip when standing [m]
UPPER_ARM, FOREARM, SHOULDER = 0.29, 0.29, 1.42


def bump(phase, middle, width):
    """A smooth hump of height 1 in a cycle of length 1."""
    away = (phase - middle + 0.5) % 1.0 - 0.5
    return math.exp(-(away / width) ** 2)


def leg(phase):
    """Angles of hip and knee [degrees] at a phase of the leg's cycle, 0 to 1; its heel touches the floor at 0."""
    knee = 4.0 + 12.0 * bump(phase, 0.14, 0.1) + 56.0 * bump(phase, 0.73, 0.12)
    return 3.0 + HIP_SWING * math.cos(2 * math.pi * phase), knee


def arm(phase):
    """Angles of shoulder and elbow [degrees] at the phase of the leg on the same side: the arm swings against it."""
    swing = -math.cos(2 * math.pi * phase)
    return ARM_SWING * swing, 22.0 + 12.0 * swing


def joints(frame):
    """Angles (hip, knee, shoulder, elbow) [degrees] of left and right in a frame; FRAMES: of a person who stands."""
    if frame == FRAMES:
        return [(0.0, 0.0, 0.0, 8.0)] * 2
    phase = (frame + 0.5) / FRAMES
    return [(*leg(part), *arm(part)) for part in (phase, (phase + 0.5) % 1.0)]


class Build(typing.NamedTuple):
    """Half widths of a person 1.75 m tall [m]."""
    name: str
    shoulders: float
    waist: float
    hips: float
    skirt: bool
    long_hair: bool


BUILDS = [Build('broad', 0.20, 0.155, 0.155, False, False), Build('slim', 0.17, 0.125, 0.165, True, True)]


def chain(start, lengths, angles):
    """Points of a limb from its start, lengths of its parts and angles to the vertical [degrees], ahead > 0."""
    points = [numpy.array(start, float)]
    for length, angle in zip(lengths, numpy.radians(angles)):
        points.append(points[-1] + length * numpy.array([math.sin(angle), 0.0, -math.cos(angle)]))
    return points


def legs(build, frame):
    """Trousers or skirt, and shoes."""
    parts, feet = [], []
    for side, (hip, knee, _, _) in zip((1, -1), joints(frame)):
        points = chain((0.0, side * 0.09, HIP), (THIGH, SHIN), (hip, hip - knee))
        parts.append(limb(points, (0.088, 0.062, 0.047), 5))
        tilt = math.radians(hip - knee) * 0.6
        ahead = numpy.array([math.cos(tilt), 0.0, math.sin(tilt)])
        foot = limb([points[-1] + length * ahead for length in (-0.06, 0.06, 0.19)], (0.04, 0.05, 0.03), 4)
        parts.append(foot)
        feet.append(foot)
    parts.append(loft([ellipse((0, 0, z), ahead, left, 7) for z, ahead, left in
                       ((HIP - 0.06, 0.1, build.hips), (HIP + 0.1, 0.1, build.waist))]))
    if build.skirt:
        spread = 0.13 + 0.12 * abs(math.sin(math.radians(joints(frame)[0][0])))
        parts.append(loft([ellipse((0, 0, z), ahead, left, 7) for z, ahead, left in
                           ((HIP - 0.36, spread, 0.19), (HIP + 0.02, 0.115, build.hips + 0.01))]))
    return join(*parts), min(foot[:, :, 2].min() for foot in feet)


def shirt(build, frame):
    """Trunk and arms."""
    rings = ((HIP + 0.06, 0.108, build.waist + 0.015), (1.12, 0.1, build.waist), (1.32, 0.125, build.shoulders * 0.9),
             (1.43, 0.115, build.shoulders), (1.5, 0.05, 0.07))
    parts = [loft([ellipse((0, 0, z), ahead, left, 7) for z, ahead, left in rings])]
    for side, (_, _, shoulder, elbow) in zip((1, -1), joints(frame)):
        start = (0.0, side * (build.shoulders + 0.01), SHOULDER)
        points = chain(start, (UPPER_ARM, FOREARM), (shoulder, shoulder + elbow))
        parts.append(limb(points, (0.065, 0.048, 0.038), 4))
    return join(*parts)


def head():
    """Face and neck, which do not move with the steps."""
    neck = loft([ellipse((0, 0, z), 0.05, 0.05, 6) for z in (1.44, 1.55)])
    return join(ellipsoid((0.01, 0, 1.62), (0.1, 0.08, 0.125), 8, 5), neck)


def hair(build):
    """Covers the upper and the rear part of the head."""
    parts = [ellipsoid((-0.018, 0, 1.66), (0.1, 0.085, 0.1), 7, 4)]
    if build.long_hair:
        parts.append(loft([ellipse((-0.06, 0, z), ahead, left, 6) for z, ahead, left in
                           ((1.42, 0.03, 0.07), (1.52, 0.05, 0.09), (1.66, 0.06, 0.09))]))
    return join(*parts)


def shapes():
    """Head, shirt and dark parts of each build, by the name of their file."""
    made = {}
    for build in BUILDS:
        made[f'{build.name}_head'] = head()
        for frame in range(FRAMES + 1):
            lower, floor = legs(build, frame)
            up = numpy.array([0.0, 0.0, -floor])  # the lower foot is on the floor
            made[f'{build.name}_dark_{frame}'] = join(lower + up, hair(build))
            made[f'{build.name}_shirt_{frame}'] = shirt(build, frame) + up
    return made
