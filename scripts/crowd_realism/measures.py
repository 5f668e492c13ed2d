"""How people walk, and how well their ways were predicted."""
import numpy

from .people import LEAST_STEPS, STEP

MOVING = 0.3  # [m/s] at least; slower people stand
FIGURES = {'speed': 'speed [m/s]', 'path_ratio': 'path over straight line', 'turning': 'turning [rad/m]',
           'acceleration': 'acceleration, rms [m/s²]', 'lateral': 'lateral acceleration, rms [m/s²]',
           'nearest': 'least distance to another [m]', 'stop_share': 'share of time standing'}
BODY = 0.1  # [m] radius of the discs of Col-I and Col-II


def figures_of(walkers):
    """Returns the FIGURES of walkers, as arrays by name, with a value for each walker (`nearest`: with company)."""
    found = {name: [] for name in FIGURES}
    crowds = {}
    for number, walker in enumerate(walkers):
        velocity = numpy.diff(walker.places, axis=0) / STEP
        speed = numpy.hypot(*velocity.T)
        if len(speed) < LEAST_STEPS:
            continue
        for name, value in motion_of(walker, velocity, speed).items():
            found[name].append(value)
        for time, place in zip(walker.times, walker.places):
            crowds.setdefault(round(time / STEP + 1e-6), []).append((number, place))
    nearest = {}
    for crowd in crowds.values():
        places = numpy.array([place for _, place in crowd])
        apart = numpy.hypot(*(places[:, None] - places[None]).transpose(2, 0, 1))
        numpy.fill_diagonal(apart, numpy.inf)
        for (number, _), distance in zip(crowd if len(crowd) > 1 else [], apart.min(axis=1)):
            nearest[number] = min(distance, nearest.get(number, numpy.inf))
    found['nearest'] = list(nearest.values())
    return {name: numpy.array(values) for name, values in found.items()}


def motion_of(walker, velocity, speed):
    """Returns those FIGURES of a walker that do not depend on others."""
    is_moving = speed > MOVING
    both = is_moving[1:] & is_moving[:-1]
    turns = (numpy.diff(numpy.arctan2(velocity[:, 1], velocity[:, 0])) + numpy.pi) % (2 * numpy.pi) - numpy.pi
    acceleration = numpy.diff(velocity, axis=0) / STEP
    left = numpy.column_stack([-velocity[1:, 1], velocity[1:, 0]]) / numpy.maximum(speed[1:], 0.1)[:, None]
    way = numpy.hypot(*(walker.places[-1] - walker.places[0]))
    return {'speed': speed.mean(), 'path_ratio': speed.sum() * STEP / max(way, 0.1),
            'turning': numpy.abs(turns[both]).sum() / max(speed[1:][both].sum() * STEP, 0.1),
            'acceleration': numpy.sqrt((acceleration**2).sum(axis=1).mean()),
            'lateral': numpy.sqrt(((acceleration * left).sum(axis=1)**2).mean()), 'stop_share': (~is_moving).mean()}


def ks_distance(first, second):
    """Returns the Kolmogorov-Smirnov distance: the greatest difference of two cumulated distributions; nan if one is
    empty."""
    if min(len(first), len(second)) == 0:
        return numpy.nan
    grid = numpy.concatenate([first, second])
    shares = [numpy.searchsorted(numpy.sort(values), grid, 'right') / len(values) for values in (first, second)]
    return float(numpy.abs(shares[0] - shares[1]).max())


def collides(path, others):
    """Returns whether a person, path (step, 2), touches one of others (person, step, 2) on a segment that both walk:
    whether they are within two radii at its ends or its middle, as TrajNet++ defines it."""
    starts, ends = others[:, :-1] - path[:-1], others[:, 1:] - path[1:]
    return any((numpy.hypot(*(starts + share * (ends - starts)).transpose(2, 0, 1)) <= 2 * BODY).any()
               for share in (0.0, 0.5, 1.0))


def distances_of(moment, predicted, person):
    """Returns the distances of a predicted person from its recorded places [m], for each step."""
    return numpy.hypot(*(predicted[person] - moment.future[person]).T)


def errors_of(moments, predictions):
    """Returns the metrics of TrajNet++ of predictions [m], arrays (person, step, 2) by Moment, over all windows.
    They are mean and final displacement error [m]; share of windows whose predicted person touches another predicted
    one (of those with another one), and another recorded one [%]."""
    distances, touched, touched_true = [], [], []
    for moment, predicted in zip(moments, predictions):
        for person in numpy.flatnonzero(moment.complete()):
            distances.append(distances_of(moment, predicted, person))
            others = numpy.arange(len(predicted)) != person
            if others.any():
                touched.append(collides(predicted[person], predicted[others]))
            touched_true.append(collides(predicted[person], moment.future[others]))
    distances = numpy.array(distances)
    share = 100.0 * numpy.mean(touched) if touched else 0.0
    return {'windows': len(distances), 'ADE': distances.mean(), 'FDE': distances[:, -1].mean(), 'Col-I': share,
            'Col-II': 100.0 * numpy.mean(touched_true)}
