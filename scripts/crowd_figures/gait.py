"""How people walk: rotations of all joints from the steps of the feet. Feet that stand do not move."""
import typing

import numpy
from .skeleton import ANKLE, HEEL, SEAT, SHANK, THIGH, TOE, reach, rest_places, turned
from scipy.ndimage import gaussian_filter1d, minimum_filter1d, uniform_filter1d

from .footsteps import Planner, SIDES
from .keys import keyframes

HEEL_STRIKE, PUSH_OFF = 0.3, 0.65  # pitch of the foot as it lands, toes up, and as it leaves the floor, heel up [rad]
LANDING, ROLLING = 0.15, 0.35  # until a foot is flat, and in which its heel rises before it leaves the floor [s]
CLEARANCE = 0.025  # height of the foot in the middle of its swing [m]
STRAIGHT = 0.993  # longest leg, as a share of a straight one
EASE = 0.07  # over which the height of the hips is smooth, twice [s]
CALM, CALM_SWAY, CALM_SPEED = 0.05, 0.13, 0.2  # standard deviations of smoothed motions of arms, sway, speed [s]
SWAY = 0.025  # of the hips to the foot that stands [m]
HIP_TURN, CHEST_TURN = 0.14, 0.3  # with each metre that a foot is ahead of the other one [rad/m]
ARM_SWING, ELBOW_SWING = 0.75, 0.5  # [rad/m]
ARM_AWAY, ELBOW, LEAST_ELBOW = 0.06, 0.25, 0.05  # arm from the trunk, bend of the elbow [rad]
LEAN = 0.03  # of the trunk with each m/s [rad]
MOVE, BEND = 0.003, 0.01  # bounds of the key frames of the trunk [m], [rad]


class Foot(typing.NamedTuple):
    """A foot: one row for each frame."""
    ankle: numpy.ndarray  # place [m]
    heading: numpy.ndarray  # [rad]
    pitch: numpy.ndarray  # [rad], toes up above 0
    stands: numpy.ndarray  # whether it bears weight


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


def foot_of(foot, planner, steps, frame):
    """Returns the Foot that makes its share of the steps, with the duration of a frame [s]."""
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
        pitches[stance] = HEEL_STRIKE * step.length * (1 - smooth((stance - step.landed) * frame / LANDING))
        if following:
            pitches[stance] -= PUSH_OFF * following.length * smooth((stance - end) * frame / ROLLING + 1) ** 1.5
    return Foot(ankle_of(places, headings, pitches, clearances), headings, pitches, stands)


def hips_of(body, feet, pelvis, skeleton):
    """Returns the places of the hips in the world: over the path, swaying, as high as the legs permit."""
    rest, frame = rest_places(skeleton), body.times[1] - body.times[0]
    ease = 1 + 2 * round(EASE / 2 / frame)
    weight = gaussian_filter1d(feet[0].stands.astype(float) - feet[1].stands, CALM_SWAY / frame)
    across = numpy.column_stack([-numpy.sin(body.headings), numpy.cos(body.headings)])
    places = numpy.column_stack([body.places + SWAY * weight[:, None] * across, numpy.zeros(len(weight))])
    heights = numpy.full(len(weight), ANKLE + STRAIGHT * (THIGH + SHANK))
    for side, foot in zip(('left', 'right'), feet):
        hip = places + pelvis.apply(rest[f'{side}_thigh'] - rest['hips'])
        away = numpy.linalg.norm((foot.ankle - hip)[:, :2], axis=1)
        length = STRAIGHT * (THIGH + SHANK)
        heights = numpy.minimum(heights, foot.ankle[:, 2] + numpy.sqrt(numpy.maximum(length ** 2 - away ** 2, 0.1)))
    for _ in range(2):  # a mean of minima is nowhere above what it is of
        heights = uniform_filter1d(minimum_filter1d(heights, ease), ease)
    places[:, 2] = heights + rest['hips'][2] - rest['left_thigh'][2]
    return places


class Trunk(typing.NamedTuple):
    """What moves the legs: one row for each frame, linear between the key frames."""
    keys: numpy.ndarray  # frames
    places: numpy.ndarray  # x, y on the floor [m]
    headings: numpy.ndarray  # [rad]
    hips: numpy.ndarray  # place in the frame of the person [m]
    pelvis: numpy.ndarray  # rotation of the hips about z [rad]


def trunk_of(body, feet, skeleton, ahead):
    """Returns the Trunk over the feet, with few key frames: the legs are bent for it, so that feet stay in place."""
    turns, pelvis = turned('z', body.headings), -HIP_TURN * ahead
    hips = hips_of(body, feet, turned('z', body.headings + pelvis), skeleton)
    hips = turns.inv().apply(hips - numpy.column_stack([body.places, numpy.zeros(len(pelvis))]))
    exact = numpy.column_stack([body.places, body.headings, hips, pelvis])
    ends = body.shown.start, body.shown.stop - 1
    keys = keyframes(exact[body.shown], [MOVE, MOVE, BEND, MOVE, MOVE, MOVE, BEND]) + ends[0]
    near = numpy.column_stack([numpy.interp(numpy.arange(ends[0], ends[1] + 1), keys, column[keys])
                               for column in exact.T])
    return Trunk(keys - ends[0], near[:, :2], near[:, 2], near[:, 3:6], near[:, 6])


def walk(body, skeleton, scale, manner):
    """Returns the Trunk, rotations by joint, and the feet at the shown frames of a Body; `manner`: how far the arms
    swing, 1 is usual."""
    planner, frame = Planner(body, scale), body.times[1] - body.times[0]
    steps = planner.steps()
    feet = [foot_of(foot, planner, steps, frame) for foot in range(len(SIDES))]
    way = numpy.column_stack([numpy.cos(body.headings), numpy.sin(body.headings), numpy.zeros(len(body.times))])
    ahead = gaussian_filter1d(numpy.sum((feet[0].ankle - feet[1].ankle) * way, axis=1), CALM / frame)  # the left foot
    trunk = trunk_of(body, feet, skeleton, ahead)
    speed = gaussian_filter1d(numpy.linalg.norm(numpy.gradient(body.places, axis=0), axis=1),
                              CALM_SPEED / frame) / frame
    ahead, speed, feet = ahead[body.shown], speed[body.shown], [
        Foot(*(column[body.shown] for column in foot)) for foot in feet]
    rotations = {'hips': turned('z', trunk.pelvis), 'spine': turned('y', LEAN * speed),
                 'chest': turned('z', (HIP_TURN + CHEST_TURN) * ahead), 'head': turned('z', -CHEST_TURN * ahead)}
    turns = turned('z', trunk.headings + trunk.pelvis)
    hips = turned('z', trunk.headings).apply(trunk.hips) + numpy.column_stack([trunk.places, 0 * speed])
    for side, sign, foot in zip(('left', 'right'), SIDES, feet):
        swing = -sign * ahead * manner  # of the arm, ahead above 0
        rotations[f'{side}_upper_arm'] = turned('y', 0.06 - ARM_SWING * swing) * turned('x', numpy.full(
            len(swing), sign * ARM_AWAY))
        bend = ELBOW + ELBOW_SWING * (swing + 0.35 * numpy.abs(ahead))
        rotations[f'{side}_forearm'] = turned('y', -numpy.maximum(bend, LEAST_ELBOW))
        rotations.update(leg_of(side, foot, hips, turns, trunk.headings, skeleton))
    return trunk, rotations, feet


def leg_of(side, foot, hips, pelvis, headings, skeleton):
    """Returns the rotations of thigh, knee and foot. The knee points between the hips' direction and the foot's."""
    offset = next(joint.offset for joint in skeleton if joint.name == f'{side}_thigh')
    middle = 0.5 * (foot.heading + headings)
    ahead = numpy.column_stack([numpy.cos(middle), numpy.sin(middle), 0 * middle])
    thigh, knee = reach(hips + pelvis.apply(offset), foot.ankle, ahead)
    shank = turned('y', knee)
    world = turned('z', foot.heading) * turned('y', -foot.pitch)
    return {f'{side}_thigh': pelvis.inv() * thigh, f'{side}_shank': shank,
            f'{side}_foot': (thigh * shank).inv() * world}


def sit(body):
    """Returns what walk() does, of a person in a wheelchair: no feet."""
    count = body.shown.stop - body.shown.start
    exact = numpy.column_stack([body.places, body.headings])[body.shown]
    keys = keyframes(exact, [MOVE, MOVE, BEND])
    hips = numpy.tile([-0.02, 0.0, SEAT + 0.03], (count, 1))
    trunk = Trunk(keys, exact[:, :2], exact[:, 2], hips, numpy.zeros(count))
    bends = {'thigh': -1.5, 'shank': 0.9, 'foot': 0.4, 'upper_arm': 0.25, 'forearm': -1.0}
    return trunk, {f'{side}_{joint}': turned('y', numpy.full(count, bend)) for joint, bend in bends.items()
                   for side in ('left', 'right')}, []
