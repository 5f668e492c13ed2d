"""Where people put their feet: steps planned along the path of a body that is known in advance.

All lengths are in units of the figure, which is scaled afterwards: a child takes the steps of an adult, smaller and
quicker. Frames are moments at a constant rate."""
import typing

import numpy
from scipy.ndimage import gaussian_filter1d

SIDES = (1.0, -1.0)  # left, right
STANCE_WIDTH, TOE_OUT = 0.09, 0.1  # half distance of the feet [m]; [rad]
# Length of a step over steps a second, constant in adults at all speeds: 0.0064 m/(steps/min), Sekiya and Nagasaki,
# Reproducibility of the walking patterns of normal young adults, Gait & Posture 7, 1998.
WALK_RATIO = 0.0064 * 60
SHORTEST, LONGEST = 0.36, 0.9  # duration of a step [s]
SWING = 0.8  # share of a step in which the other foot is off the floor: 40 % of a cycle of two steps
TURN = 0.8  # greatest rotation in a step [rad]
AWAY, ASKEW = 0.06, 0.3  # distance [m] and angle [rad] from its place at which a foot of a person who stands moves
SMOOTHING, TURN_SMOOTHING = 0.12, 0.25  # standard deviations of the path and of the heading in time [s]
TOLERANCE = 0.05  # greatest distance of the smoothed path from the recorded one [m]
MARGIN = 1.5  # time before and after the recording in which people walk straight on [s]
ENDS = 0.3  # part of the recording that gives the velocity then [s]


class Body(typing.NamedTuple):
    """The path of a body: one row for each frame."""
    times: numpy.ndarray  # [s]
    places: numpy.ndarray  # x, y [m]
    headings: numpy.ndarray  # [rad] continuous
    shown: slice  # the frames that are recorded; those before and after are continued


class Step(typing.NamedTuple):
    """A foot is lifted at a frame and put down at another one; places are x, y [m], headings [rad]."""
    foot: int
    lifted: int
    landed: int
    place: numpy.ndarray
    heading: float
    length: float  # as long as an ordinary step: 1


def body_of(track, times, scale):
    """Returns the smoothed Body of a crowd_recordings Track at frames [s], in units of a figure."""
    frame = times[1] - times[0] if len(times) > 1 else 1 / 30
    extra = round(MARGIN / frame)
    longer = numpy.concatenate([times[0] - frame * numpy.arange(extra, 0, -1), times,
                                times[-1] + frame * numpy.arange(1, extra + 1)])
    exact = numpy.column_stack([numpy.interp(longer, track.times, track.places[:, axis]) for axis in (0, 1)])
    for end, inner in ((track.times[0], ENDS), (track.times[-1], -ENDS)):
        outside = longer < end if inner > 0 else longer > end
        velocity = (track.place_at(end + inner) - numpy.array(track.place_at(end))) / inner
        exact[outside] += (longer[outside] - end)[:, None] * velocity
    away = gaussian_filter1d(exact, SMOOTHING / frame, axis=0) - exact
    away *= numpy.minimum(1.0, TOLERANCE / numpy.maximum(numpy.linalg.norm(away, axis=1), 1e-9))[:, None]
    headings = numpy.interp(longer, track.times, track.headings)
    return Body(longer, (exact + away) / scale, gaussian_filter1d(headings, TURN_SMOOTHING / frame),
                slice(extra, extra + len(times)))


class Planner:
    """Plans the steps of a person. A foot lands where the body will be in the middle of the time that it stands."""

    def __init__(self, body, scale):
        self.last = len(body.times) - 1
        frame = body.times[1] - body.times[0]
        self.durations = self.step_durations(body, frame, scale)
        self.swings = numpy.maximum(2, numpy.round(SWING * self.durations)).astype(int)
        across = numpy.column_stack([-numpy.sin(body.headings), numpy.cos(body.headings)])
        self.places = [body.places + side * STANCE_WIDTH * across for side in SIDES]
        self.headings = [body.headings + side * TOE_OUT for side in SIDES]
        self.goals = numpy.minimum(self.last, numpy.arange(self.last + 1) + self.swings + self.durations // 2)
        self.feet = [(self.places[foot][0], self.headings[foot][0]) for foot in (0, 1)]

    @staticmethod
    def step_durations(body, frame, scale):
        """Returns for each frame how many frames a step takes that begins then."""
        ahead = max(1, round(0.5 / frame))
        way = numpy.r_[0.0, numpy.cumsum(numpy.linalg.norm(numpy.diff(body.places, axis=0), axis=1))]
        turn = numpy.r_[0.0, numpy.cumsum(numpy.abs(numpy.diff(body.headings)))]
        speed, rate = ((numpy.r_[sums[ahead:], numpy.full(ahead, sums[-1])] - sums) / (ahead * frame)
                       for sums in (way, turn))
        # Durations are those of an adult times the root of the scale: dynamic similarity.
        duration = numpy.sqrt(WALK_RATIO * scale ** -0.5 / numpy.maximum(speed, 1e-3)) * scale ** 0.25
        duration = numpy.minimum(duration, TURN / numpy.maximum(rate, 1e-3))
        return numpy.round(numpy.clip(duration, SHORTEST, LONGEST) / frame).astype(int)

    def wants(self, foot, frames):
        """Returns whether a foot is far from its place if a step of it begins at these frames."""
        goals, (place, heading) = self.goals[frames], self.feet[foot]
        away = numpy.linalg.norm(self.places[foot][goals] - place, axis=1)
        return (away > AWAY) | (numpy.abs(self.headings[foot][goals] - heading) > ASKEW)

    def steps(self):
        """Returns all Steps, in their order."""
        steps, foot, frame = [], 0, 0
        while frame < self.last:
            found = next(((at, which) for at, which in self.candidates(foot, frame)), None)
            if found is None:
                break
            frame, foot = found
            steps.append(self.step(foot, frame))
            frame += self.durations[frame]
            foot = 1 - foot
        return steps

    def candidates(self, foot, frame):
        """Yields the frame and the foot of the next step; the given foot is the one whose turn it is."""
        window = 16
        while frame < self.last:
            frames = numpy.arange(frame, min(frame + window, self.last))
            own, other = self.wants(foot, frames), self.wants(1 - foot, frames)
            if own.any() or other.any():
                at = int(numpy.argmax(own | other))
                yield frame + at, foot if own[at] else 1 - foot
            frame, window = frame + window, 2 * window

    def step(self, foot, frame):
        """Returns the step of a foot that begins at a frame, after which the foot stands there."""
        landed, goal = min(self.last, frame + self.swings[frame]), self.goals[frame]
        place, heading = self.places[foot][goal], self.headings[foot][goal]
        length = numpy.linalg.norm(place - self.feet[foot][0]) / 2
        self.feet[foot] = place, heading
        return Step(foot, frame, landed, place, heading, min(1.0, length / 0.6))
