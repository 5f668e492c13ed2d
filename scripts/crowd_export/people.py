"""People of a recording as figures: what they look like, their walks, and both in glTF."""
import dataclasses

import numpy
from crowd_figures import gait
from crowd_figures.bodies import BUILDS, skeleton_of
from crowd_figures.footsteps import body_of
from crowd_figures.skeleton import turned
from scipy.spatial.transform import Rotation

HEIGHTS = 0.92, 0.96, 1.0, 1.03, 1.06  # as of figures in RViz
CHILD_HEIGHT = 0.6
COLOURS = {
    'skin': [(0.87, 0.69, 0.58), (0.74, 0.54, 0.41), (0.45, 0.31, 0.23), (0.93, 0.77, 0.66)],
    'hair': [(0.16, 0.12, 0.1), (0.35, 0.22, 0.13), (0.62, 0.45, 0.24), (0.1, 0.1, 0.11), (0.45, 0.2, 0.1)],
    'shirt': [(0.75, 0.2, 0.18), (0.16, 0.36, 0.6), (0.93, 0.9, 0.84), (0.2, 0.45, 0.32), (0.9, 0.62, 0.16),
              (0.36, 0.26, 0.48), (0.5, 0.66, 0.76), (0.22, 0.24, 0.28)],
    'trousers': [(0.17, 0.21, 0.32), (0.16, 0.16, 0.18), (0.46, 0.4, 0.33), (0.3, 0.36, 0.44), (0.36, 0.35, 0.35)],
    'shoes': [(0.09, 0.08, 0.08), (0.3, 0.19, 0.12), (0.86, 0.85, 0.83)]}
OLD_HAIR, RECORDED, BELONGINGS = (0.75, 0.75, 0.76), (0.2, 0.21, 0.23), (0.13, 0.14, 0.17)
OUTFITS = 24  # different clothes of a build
GOLDEN = 0.6180339887  # spreads numbers evenly


@dataclasses.dataclass
class Person:
    """A person with its walk at the frames in which it is there."""
    name: str
    number: int
    figure: str  # adult, child, old, wheelchair or trolley
    recorded: bool  # one of Scene.recorded, who yields to nobody
    scale: float
    build: str
    skeleton: list
    times: numpy.ndarray  # [s]
    trunk: gait.Trunk
    rotations: dict  # local ones by joint
    feet: list  # gait.Foot of left and right; none of who sits

    def places(self):
        """Returns the places on the floor [m]."""
        return self.scale * self.trunk.places


def person_of(name, number, track, figure, recorded, times):
    """Returns the Person of a Track at its frames."""
    build = 'child' if figure == 'child' else ('broad', 'slim')[number % 2]
    scale = (CHILD_HEIGHT if figure == 'child' else 1.0) * HEIGHTS[int(len(HEIGHTS) * (GOLDEN * number % 1.0))]
    skeleton = skeleton_of(BUILDS[build])
    body = body_of(track, times, scale)
    if figure == 'wheelchair':
        trunk, rotations, feet = gait.sit(body)
    else:
        trunk, rotations, feet = gait.walk(body, skeleton, scale, 0.75 + 0.5 * (7 * GOLDEN * number % 1.0))
        if figure in ('trolley', 'old'):
            hold(rotations, figure)
    return Person(name, number, figure, recorded, scale, build, skeleton, times, trunk, rotations, feet)


def hold(rotations, figure):
    """The right arm pulls a suitcase, or leans on a stick."""
    upper, lower = (0.42, -0.1) if figure == 'trolley' else (-0.12, -0.45)
    count = len(rotations['hips'])
    rotations['right_upper_arm'] = turned('y', numpy.full(count, upper)) * turned('x', numpy.full(count, -0.06))
    rotations['right_forearm'] = turned('y', numpy.full(count, lower))


def colours_of(person):
    """Returns the colours of a person, by what has them."""
    if person.recorded:
        return {name: RECORDED if name != 'skin' else options[0] for name, options in COLOURS.items()}
    random = numpy.random.default_rng(person.number % OUTFITS)
    found = {name: options[random.integers(len(options))] for name, options in COLOURS.items()}
    return {**found, 'hair': OLD_HAIR} if person.figure == 'old' else found


def local(points):
    """Returns points of a figure (ahead, left, up) in the axes of glTF's models: x left, y up, z ahead."""
    return numpy.asarray(points)[..., [1, 2, 0]]


def floor(points):
    """Returns points of the map (x, y, z) in the world of glTF: y up."""
    points = numpy.asarray(points, float)
    return numpy.stack([points[..., 0], points[..., 2], -points[..., 1]], axis=-1)


def local_quaternions(rotation):
    """Returns rotations of joints as quaternions x, y, z, w in the axes of models, without jumps of the sign."""
    return continuous(rotation.as_quat()[:, [1, 2, 0, 3]])


def person_quaternions(headings):
    """Returns the rotations of persons with these headings."""
    return continuous(Rotation.from_euler('y', headings + numpy.pi / 2).as_quat())


def continuous(quaternions):
    """Changes signs so that neighbours are near each other."""
    turns = numpy.sum(quaternions[1:] * quaternions[:-1], axis=1) < 0
    return quaternions * numpy.where(numpy.r_[False, numpy.cumsum(turns) % 2 == 1], -1, 1)[:, None]
