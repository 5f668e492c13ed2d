"""The people of a recording: walkers who are replaced all at once, and moments from which everybody in view is
predicted."""
import typing

import numpy
from crowd_drawing.errors import InputError

STEP = 0.4  # [s] between two samples
OBSERVED, PREDICTED = 8, 12  # steps
LEAST_ROWS, LEAST_STEPS = 5, 3  # of a walker
LEAST_WAY, LEAST_SPEED = 3.0, 0.5  # [m] from entry to exit, [m/s] on average


class Walker(typing.NamedTuple):
    """A person who walks from an entry to an exit."""
    times: numpy.ndarray  # [s] every STEP from the entry
    places: numpy.ndarray  # [m] one row x, y for each time

    def speeds(self):
        return numpy.hypot(*numpy.diff(self.places, axis=0).T) / STEP


def resampled(times, places):
    """Returns the Walker of places at any ascending times [s], which is at the same places at steps of STEP."""
    grid = numpy.arange(times[0], times[-1] + 1e-9, STEP)
    return Walker(grid, numpy.column_stack([numpy.interp(grid, times, places[:, axis]) for axis in (0, 1)]))


def tracks_of(recording):
    """Yields times [s] and places [m] of each person of a Recording, as arrays."""
    for walk in recording.walks.values():
        rows = numpy.array(walk, dtype=float)
        yield rows[:, 0] * recording.frame_duration, rows[:, 1:]


def walkers_of(recording):
    """Returns the Walkers of a Recording. Raises InputError if there are not enough for two halves."""
    people = [resampled(*track) for track in tracks_of(recording) if len(track[0]) >= LEAST_ROWS]
    found = [walker for walker in people if len(walker.times) > 1 and walker.speeds().mean() >= LEAST_SPEED and
             numpy.hypot(*(walker.places[-1] - walker.places[0])) >= LEAST_WAY]
    if len(found) < 2:
        raise InputError(f'the recording has {len(found)} walkers, people who walk {LEAST_WAY:g} m or more at '
                         f'{LEAST_SPEED:g} m/s or faster; expected at least 2')
    return found


def noise_of(walkers):
    """Returns the standard deviation of independent errors in the places of walkers [m], in x and in y: the product of
    two successive changes of velocity is -4 times its square on average. 0 if they are hidden by the motion."""
    changes = [numpy.diff(walker.places, n=2, axis=0) for walker in walkers]
    products = numpy.concatenate([change[1:] * change[:-1] for change in changes])
    return float(numpy.sqrt(max(0.0, -products.mean() / 4))) if len(products) else 0.0


def with_noise(walkers, deviation):
    """Returns walkers with independent errors in their places, of this standard deviation [m]."""
    random = numpy.random.default_rng(1)
    return [walker._replace(places=walker.places + random.normal(0.0, deviation, walker.places.shape))
            for walker in walkers]


class Moment(typing.NamedTuple):
    """All people in view in a frame who were there a step before, too; nan where a person is not in view."""
    seen: numpy.ndarray  # [m] (person, OBSERVED, 2), the last one in this frame
    future: numpy.ndarray  # [m] (person, PREDICTED, 2)
    ends: numpy.ndarray  # [m] (person, 2) last place in the recording

    def complete(self):
        """Returns for each person whether all observed and predicted steps are in the recording: a window."""
        return numpy.isfinite(self.seen).all(axis=(1, 2)) & numpy.isfinite(self.future).all(axis=(1, 2))


def sampled(recording):
    """Returns places of people by frames, {frame: {person: (x, y)}}, and the number of frames in STEP. Recordings whose
    frames do not divide STEP are interpolated."""
    step, places = STEP / recording.frame_duration, {}
    if abs(step - round(step)) < 1e-6 and round(step) > 0:
        step = round(step)
        for person, walk in recording.walks.items():
            for frame, x, y in walk:
                places.setdefault(frame, {})[person] = (x, y)
        return places, step
    for person, (times, track) in zip(recording.walks, tracks_of(recording)):
        for frame in range(int(numpy.ceil(times[0] / STEP)), int(times[-1] // STEP) + 1):
            places.setdefault(frame, {})[person] = tuple(numpy.interp(frame * STEP, times, axis) for axis in track.T)
    return places, 1


def moments_of(recording):
    """Returns the Moments of a Recording with a window, at most one in STEP. Raises InputError without any."""
    places, step = sampled(recording)
    ends = {person: walk[-1][1:] for person, walk in recording.walks.items()}
    found, last = [], -step
    for frame in sorted(places):
        people = [person for person in places[frame] if person in places.get(frame - step, {})]
        if frame - last < step or not people:
            continue
        last = frame
        steps = [[places.get(frame + k * step, {}).get(person, (numpy.nan, numpy.nan))
                  for k in range(1 - OBSERVED, PREDICTED + 1)] for person in people]
        track = numpy.array(steps)
        moment = Moment(track[:, :OBSERVED], track[:, OBSERVED:], numpy.array([ends[person] for person in people]))
        if moment.complete().any():
            found.append(moment)
    if not found:
        raise InputError(f'the recording has no window: nobody is in view for {OBSERVED + PREDICTED} samples '
                         f'at steps of {STEP:g} s')
    return found
