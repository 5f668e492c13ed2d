"""A person who sits, and what people have with them: a wheelchair, a suitcase on wheels, a stick."""
import numpy

from .people import BUILDS, HIP, SHOULDER, hair, head
from .shapes import box, ellipse, join, limb, loft, wheel

SEAT = 0.52  # height of the hip of a person who sits [m]


def lowered(shape):
    """Moves a shape of a person who stands down to the seat."""
    return shape + numpy.array([0.0, 0.0, SEAT - HIP])


def sitting():
    """The parts of a person in a wheelchair: head, shirt and dark parts."""
    build = BUILDS[0]
    trunk = [loft([ellipse((0, 0, z), ahead, left, 7) for z, ahead, left in
                   ((HIP - 0.06, 0.12, build.hips), (1.12, 0.1, build.waist), (1.43, 0.115, build.shoulders),
                    (1.5, 0.05, 0.07))])]
    legs = []
    for side in (1, -1):
        shoulder = (0.0, side * (build.shoulders + 0.01), SHOULDER)
        trunk.append(limb([shoulder, (0.02, shoulder[1], 1.14), (0.26, shoulder[1], 1.1)], (0.065, 0.05, 0.04), 4))
        hip = (0.0, side * 0.09, HIP)
        legs.append(limb([hip, (0.42, hip[1], HIP), (0.5, hip[1], HIP - 0.4)], (0.088, 0.07, 0.05), 5))
        legs.append(limb([(0.46, hip[1], HIP - 0.43), (0.68, hip[1], HIP - 0.41)], (0.045, 0.035), 4))
    return {'sitting_head': lowered(head()), 'sitting_shirt': lowered(join(*trunk)),
            'sitting_dark': lowered(join(*legs, hair(build)))}


def wheelchair():
    """Two large wheels, two small ones, seat, back, foot rest and handles."""
    parts = [box((-0.2, -0.23, 0.4), (0.25, 0.23, 0.44)), box((-0.24, -0.23, 0.4), (-0.2, 0.23, 0.9)),
             box((0.42, -0.2, 0.06), (0.68, 0.2, 0.08))]
    for side in (1, -1):
        parts += [wheel((-0.08, side * 0.28, 0.31), 0.31, 0.05, 12), wheel((0.36, side * 0.2, 0.09), 0.09, 0.04, 8),
                  limb([(-0.2, side * 0.22, 0.88), (-0.38, side * 0.22, 0.9)], (0.02, 0.02), 4),
                  limb([(0.25, side * 0.18, 0.42), (0.5, side * 0.18, 0.07)], (0.02, 0.02), 4)]
    return join(*parts)


def trolley():
    """A suitcase behind the right hand, its handle and two wheels."""
    return join(box((-0.52, -0.42, 0.08), (-0.24, -0.02, 0.72)),
                limb([(-0.3, -0.22, 0.7), (-0.1, -0.22, 0.84)], (0.018, 0.018), 4),
                *(wheel((-0.46, -0.22 + side * 0.17, 0.06), 0.06, 0.04, 8) for side in (1, -1)))


def stick():
    """A walking stick in the right hand."""
    return limb([(0.22, -0.23, 0.96), (0.28, -0.23, 0.0)], (0.028, 0.022), 4)


def stick_in_hand():
    """A walking stick below a hand at the origin."""
    return limb([(0.02, 0.0, -0.07), (0.02, 0.0, -0.86)], (0.028, 0.022), 4)


def shapes():
    """All of them, by the name of their file."""
    return {**sitting(), 'wheelchair': wheelchair(), 'trolley': trolley(), 'stick': stick()}
