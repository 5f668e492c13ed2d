"""Which frames of a motion are kept."""
import numpy


def keyframes(values, bounds):
    """Returns which rows to keep so that all others are within bounds (of the same shape, or one for all) of what
    linear interpolation gives: each part is made longer until a row before its end would be out of bounds."""
    bounds = numpy.broadcast_to(bounds, values.shape)
    kept, low, high = [0], -numpy.inf, numpy.inf
    for row in range(1, len(values)):
        slope = (values[row] - values[kept[-1]]) / (row - kept[-1])
        if ((slope < low) | (slope > high)).any():
            kept.append(row - 1)
            low, high, slope = -numpy.inf, numpy.inf, values[row] - values[row - 1]
        room = bounds[row] / (row - kept[-1])
        low, high = numpy.maximum(low, slope - room), numpy.minimum(high, slope + room)
    return numpy.unique([*kept, len(values) - 1])
