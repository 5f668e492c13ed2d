"""A recorded crowd, whatever the format of its file."""
import dataclasses
import functools
import math

from crowd_drawing.errors import InputError


@dataclasses.dataclass(frozen=True)
class Recording:
    """The positions of people. `walks`: lists of (frame, x, y) [m] by the number of the person, frames ascending;
    `frame_duration`: time between two frames [s], None if the file does not contain it."""
    walks: dict
    frame_duration: float = None

    def at_rate(self, frame_rate):
        """Returns the same recording with a frame rate [Hz] in place of that of the file, if it is not None."""
        return self if frame_rate is None else dataclasses.replace(self, frame_duration=1 / frame_rate)


def collect(file, rows):
    """Returns the walks of rows (line, person, frame, x, y), in any order. Raises InputError if a person is twice in a
    frame, if a number is negative or not finite, or if there are no rows."""
    walks = {}
    for line, person, frame, x, y in rows:
        if min(person, frame) < 0 or not (math.isfinite(x) and math.isfinite(y)):
            raise InputError(f'{file}:{line}: expected numbers of person and frame from 0, and finite positions')
        places = walks.setdefault(person, {})
        if frame in places:
            raise InputError(f'{file}:{line}: person {person} is in frame {frame} for the second time')
        places[frame] = (x, y)
    if not walks:
        raise InputError(f'{file}: has no trajectory')
    return {person: [(frame, *places[frame]) for frame in sorted(places)] for person, places in sorted(walks.items())}


def step_of(walks):
    """Returns the largest step of which all frame numbers are multiples, counted from the first one; at least 1."""
    frames = sorted({frame for walk in walks.values() for frame, _, _ in walk})
    return max(1, functools.reduce(math.gcd, (frame - frames[0] for frame in frames), 0))


def numbers_of(file, line, words, columns, expected):
    """Returns columns of a line: whole numbers for the first two, then two numbers. Whole numbers may be written as
    7.8000000e+02. Raises InputError."""
    try:
        values = [float(words[column]) for column in columns]
        if not (values[0].is_integer() and values[1].is_integer()):
            raise ValueError
        return int(values[0]), int(values[1]), values[2], values[3]
    except (ValueError, IndexError, OverflowError):
        raise InputError(f"{file}:{line}: expected {expected}, got '{' '.join(words)}'") from None
