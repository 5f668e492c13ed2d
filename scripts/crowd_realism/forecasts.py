"""What a prediction starts from, and models that predict without `evaluate`."""
import typing

import numpy

from .people import PREDICTED, STEP

FAR = 100.0  # [m] to an extrapolated goal
ROOM = 0.49  # of the distance to the nearest other, at most, is a radius
NOISE = 1.5  # 1 / the part of uncorrelated errors of places in the change of velocity


class Task(typing.NamedTuple):
    """From where and to where the people of a Moment walk, a row for each."""
    places: numpy.ndarray  # [m] last observed
    velocities: numpy.ndarray  # [m/s] estimated from what was observed
    goals: numpy.ndarray  # [m]

    def speeds(self):
        return numpy.hypot(*self.velocities.T)

    def radii(self, radius):
        """Returns radii up to the given one [m], with which nobody overlaps another one."""
        apart = numpy.hypot(*(self.places[:, None] - self.places[None]).transpose(2, 0, 1))
        numpy.fill_diagonal(apart, numpy.inf)
        return numpy.minimum(radius, ROOM * apart.min(axis=1))


def last_step(seen):
    """Returns the velocities of the last observed step [m/s]."""
    return (seen[:, -1] - seen[:, -2]) / STEP


def weighted_steps(seen):
    """Returns the mean velocities of the observed steps [m/s], each with `share` of the weight of the one after it.

    Errors of places let velocities change to and fro: if all changes were such errors, the product of two successive
    ones would be -2/3 of their square on average. The share is 1 then, and 0 for changes that keep their direction. It
    is determined by all people in view, and only by what was observed."""
    velocity = numpy.diff(seen, axis=1) / STEP
    change = numpy.diff(velocity, axis=1)
    squares, products = (change**2).sum(axis=2), (change[:, 1:] * change[:, :-1]).sum(axis=2)
    square, product = (numpy.nanmean(values) if numpy.isfinite(values).any() else 0.0 for values in (squares, products))
    share = min(1.0, max(0.0, -NOISE * product / square)) if square > 0 else 0.0
    weights = share**numpy.arange(velocity.shape[1])[::-1] * numpy.isfinite(velocity[..., 0])
    return (weights[..., None] * numpy.nan_to_num(velocity)).sum(axis=1) / weights.sum(axis=1)[:, None]


ESTIMATES = {'last': last_step, 'weighted': weighted_steps}


def task_of(moment, estimate, free_speed, knows_goal):
    """Returns the Task of a Moment, with a share of the estimated speeds. Its goals are the last places in the
    recording, or far ahead."""
    places, velocities = moment.seen[:, -1], free_speed * ESTIMATES[estimate](moment.seen)
    if knows_goal:
        return Task(places, velocities, moment.ends)
    speeds = numpy.hypot(*velocities.T)[:, None]
    ahead = numpy.where(speeds > 0, velocities / numpy.maximum(speeds, 1e-9), [1.0, 0.0])
    return Task(places, velocities, places + FAR * ahead)


def walk_straight(tasks):
    """Predicts that everybody walks straight to the goal at the estimated speed, and stands there."""
    found = []
    for task in tasks:
        ways = task.goals - task.places
        lengths = numpy.maximum(numpy.hypot(*ways.T), 1e-9)
        steps = STEP * numpy.arange(1, PREDICTED + 1)
        shares = numpy.minimum(1.0, task.speeds()[:, None] * steps / lengths[:, None])
        found.append(task.places[:, None] + shares[..., None] * ways[:, None])
    return found
