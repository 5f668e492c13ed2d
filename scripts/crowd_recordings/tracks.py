"""Positions and headings of recorded people at any time between two ticks."""
import dataclasses

import numpy

HEADING_SPAN = 0.3  # [s] of the motion that gives the heading; ticks alone are noisy
LEAST_MOTION = 0.02  # [m] within this span, below which the heading is unchanged


@dataclasses.dataclass(frozen=True)
class Track:
    """The recorded positions of an agent."""
    times: numpy.ndarray  # [s] ascending
    places: numpy.ndarray  # [m] one row x, y for each time
    headings: numpy.ndarray  # [rad] for each time, continuous

    def is_present(self, time):
        """Returns whether the agent is in the world at a time [s]."""
        return self.times[0] <= time <= self.times[-1]

    def has_ended(self, time):
        """Returns whether the agent has left the world before a time [s]."""
        return time > self.times[-1]

    def place_at(self, time):
        """Returns x, y [m] at a time [s], or at the first or last time of the track."""
        return [float(numpy.interp(time, self.times, self.places[:, axis])) for axis in (0, 1)]

    def heading_at(self, time):
        """Returns the heading at a time [rad]."""
        return float(numpy.interp(time, self.times, self.headings))

    def trail(self, time, duration, points):
        """Returns the path of the last seconds before a time as `points` places, oldest first [m]."""
        times = numpy.linspace(max(self.times[0], time - duration), time, points)
        return numpy.column_stack([numpy.interp(times, self.times, self.places[:, axis]) for axis in (0, 1)])


def track_of(walk, tick):
    """Returns the Track of a walk: a list of (tick, x, y) [m], with the duration of a tick [s]."""
    rows = numpy.array(walk, dtype=float)
    times = rows[:, 0] * tick
    return Track(times, rows[:, 1:], headings_of(times, rows[:, 1:]))


def headings_of(times, places):
    """Returns the direction of the recent motion at each time [rad]; where an agent stands, its last heading."""
    before = [numpy.interp(times - HEADING_SPAN, times, places[:, axis]) for axis in (0, 1)]
    motion = places - numpy.column_stack(before)
    moves = numpy.hypot(motion[:, 0], motion[:, 1]) >= LEAST_MOTION
    if not moves.any():
        return numpy.zeros(len(times))
    latest = numpy.maximum.accumulate(numpy.where(moves, numpy.arange(len(times)), -1))
    latest[latest < 0] = numpy.argmax(moves)  # before the first motion: its heading
    return numpy.unwrap(numpy.arctan2(motion[latest, 1], motion[latest, 0]))
