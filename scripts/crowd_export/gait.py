"""How people walk: rotations of all joints from the steps of the feet. Feet that stand do not move."""
import typing

import numpy
from crowd_figures.skeleton import ANKLE, HEEL, SHANK, THIGH, TOE, reach, rest_places, turned, world
from scipy.ndimage import gaussian_filter1d, minimum_filter1d, uniform_filter1d
from scipy.spatial.transform import Rotation

from .footsteps import Planner, SIDES

HEEL_STRIKE, PUSH_OFF = 0.3, 0.65  # pitch of the foot as it lands, toes up, and as it leaves the floor, heel up [rad]
LANDING, ROLLING = 0.15, 0.5  # shares of the stance: until the foot is flat, and from which on its heel rises
CLEARANCE = 0.025  # height of the foot in the middle of its swing [m]
STRAIGHT = 0.993  # longest leg, as a share of a straight one
EASE = 5  # frames to each side over which the height of the hips changes
SWAY = 0.025  # of the hips to the foot that stands [m]
HIP_TURN, CHEST_TURN = 0.14, 0.3  # with each metre that a foot is ahead of the other one [rad/m]
ARM_SWING, ELBOW_SWING = 0.75, 0.5  # [rad/m]
ARM_AWAY, ELBOW = 0.09, 0.25  # arm from the trunk, bend of the elbow [rad]
LEAN = 0.03  # of the trunk with each m/s [rad]


class Foot(typing.NamedTuple):
    """A foot: one row for each frame."""
    ankle: numpy.ndarray  # place [m]
    heading: numpy.ndarray  # [rad]
    pitch: numpy.ndarray  # [rad], toes up above 0
    stands: numpy.ndarray  # whether it bears weight


class Walk(typing.NamedTuple):
    """A person who walks."""
    rotations: dict  # local rotations by joint, and the 'place' of the hips in the frame of the person
    feet: list  # left, right


def smooth(share):
    """Returns 0 to 1 for 0 to 1, with rest at both ends."""
    share = numpy.clip(share, 0.0, 1.0)
    return share * share * (3 - 2 * share)


def ankle_of(place, heading, pitch, clearance):
    """Returns the place of the ankle of a foot that stands on its heel (pitch above 0) or on its toes."""
    pivot = numpy.where(pitch > 0, HEEL, TOE)
    cosine, sine = numpy.cos(pitch), numpy.sin(pitch)
    ahead = pivot - pivot * cosine - ANKLE * sine
    height = ANKLE * cosine - pivot * sine + clearance
    return numpy.column_stack([place + ahead[:, None] * numpy.column_stack([numpy.cos(heading), numpy.sin(heading)]),
                               height])


def foot_of(foot, planner, steps):
    """Returns the Foot that makes its share of the steps. The planner has its first place."""
    count = planner.last + 1
    place, heading = planner.places[foot][0], planner.headings[foot][0]
    places, headings = numpy.tile(place, (count, 1)), numpy.full(count, heading)
    pitches, clearances, stands = numpy.zeros(count), numpy.zeros(count), numpy.ones(count, bool)
    own = [step for step in steps if step.foot == foot]
    for step, following in zip(own, [*own[1:], None]):
        swing = numpy.arange(step.lifted, step.landed + 1)
        share = (swing - step.lifted) / max(1, step.landed - step.lifted)
        path = smooth(share)
        places[swing] = place + path[:, None] * (step.place - place)
        headings[swing] = heading + path * (step.heading - heading)
        pitches[swing] = (pitches[step.lifted] * (1 - smooth(share / 0.7)) +
                          HEEL_STRIKE * step.length * smooth((share - 0.5) / 0.5))
        clearances[swing] = CLEARANCE * numpy.sin(numpy.pi * share)
        stands[swing[1:-1]] = False
        place, heading = step.place, step.heading
        places[step.landed:], headings[step.landed:] = place, heading
        end = following.lifted if following else count - 1
        stance = numpy.arange(step.landed, end + 1)
        share = (stance - step.landed) / max(1, end - step.landed)
        pitches[stance] = HEEL_STRIKE * step.length * (1 - smooth((stance - step.landed) / 5))
        if following:
            pitches[stance] -= PUSH_OFF * following.length * smooth((stance - end + 9) / 9) ** 1.5
    return Foot(ankle_of(places, headings, pitches, clearances), headings, pitches, stands)


def hips_of(body, feet, pelvis, skeleton):
    """Returns the places of the hips in the world: over the path, swaying, as high as the legs permit."""
    rest = rest_places(skeleton)
    weight = gaussian_filter1d(feet[0].stands.astype(float) - feet[1].stands, 4.0)
    across = numpy.column_stack([-numpy.sin(body.headings), numpy.cos(body.headings)])
    places = numpy.column_stack([body.places + SWAY * weight[:, None] * across, numpy.zeros(len(weight))])
    heights = numpy.full(len(weight), ANKLE + STRAIGHT * (THIGH + SHANK))
    for side, foot in zip(('left', 'right'), feet):
        hip = places + pelvis.apply(rest[f'{side}_thigh'] - rest['hips'])
        away = numpy.linalg.norm((foot.ankle - hip)[:, :2], axis=1)
        length = STRAIGHT * (THIGH + SHANK)
        heights = numpy.minimum(heights, foot.ankle[:, 2] + numpy.sqrt(numpy.maximum(length ** 2 - away ** 2, 0.1)))
    for _ in range(2):  # a mean of minima is nowhere above what it is of
        heights = uniform_filter1d(minimum_filter1d(heights, EASE), EASE)
    places[:, 2] = heights + rest['hips'][2] - rest['left_thigh'][2]
    return places


def walk(body, skeleton, scale, manner):
    """Returns the Walk of a Body; `manner`: how far the arms swing, 1 is usual."""
    planner = Planner(body, scale)
    steps = planner.steps()
    feet = [foot_of(foot, planner, steps) for foot in range(len(SIDES))]
    turns = turned('z', body.headings)
    ways = [turns.inv().apply(foot.ankle - numpy.column_stack([body.places, numpy.zeros(len(body.times))]))
            for foot in feet]
    ahead = gaussian_filter1d(ways[0][:, 0] - ways[1][:, 0], 1.5)  # of the left foot before the right one
    pelvis = turned('z', -HIP_TURN * ahead)
    hips = hips_of(body, feet, turns * pelvis, skeleton)
    speed = gaussian_filter1d(numpy.linalg.norm(numpy.gradient(body.places, axis=0), axis=1), 6.0) / (
        body.times[1] - body.times[0])
    rotations = {'place': turns.inv().apply(hips - numpy.column_stack([body.places, numpy.zeros(len(speed))])),
                 'hips': pelvis, 'spine': turned('y', LEAN * speed),
                 'chest': turned('z', (HIP_TURN + CHEST_TURN) * ahead), 'head': turned('z', -CHEST_TURN * ahead)}
    for side, sign, foot in zip(('left', 'right'), SIDES, feet):
        swing = -sign * ahead * manner  # of the arm, ahead above 0
        rotations[f'{side}_upper_arm'] = turned('y', 0.06 - ARM_SWING * swing) * turned('x', sign * ARM_AWAY +
                                                                                         0 * swing)
        rotations[f'{side}_forearm'] = turned('y', -ELBOW - ELBOW_SWING * (swing + 0.35 * numpy.abs(ahead)))
        rotations.update(leg_of(side, foot, hips, turns * pelvis, body, skeleton))
    return Walk(rotations, feet)


def leg_of(side, foot, hips, pelvis, body, skeleton):
    """Returns the rotations of thigh, knee and foot. The knee points between the hips' direction and the foot's."""
    offset = next(joint.offset for joint in skeleton if joint.name == f'{side}_thigh')
    middle = 0.5 * (foot.heading + body.headings)
    ahead = numpy.column_stack([numpy.cos(middle), numpy.sin(middle), 0 * middle])
    thigh, knee = reach(hips + pelvis.apply(offset), foot.ankle, ahead)
    shank = turned('y', knee)
    world = turned('z', foot.heading) * turned('y', -foot.pitch)
    return {f'{side}_thigh': pelvis.inv() * thigh, f'{side}_shank': shank,
            f'{side}_foot': (thigh * shank).inv() * world}


def world_of(person):
    """Returns place [m] and rotation of each joint of a Person in the world."""
    places = numpy.column_stack([person.places, numpy.zeros(len(person.times))]) / person.scale
    found = world(person.skeleton, places, turned('z', person.headings), person.rotations)
    return {name: (person.scale * place, turn) for name, (place, turn) in found.items()}
