"""Recorded crowds, and the formats of their files, which are recognised by the first line: CSV of `evaluate`,
JuPedSim's text format (`id frame x y [z ...]`, with comments that begin with #, as PedPy reads it), and obsmat.txt of
the ETH and UCY data sets (`frame person x z y vx vz vy`, annotated every 0.4 s)."""
import argparse
import collections
import dataclasses
import functools
import math
import os
import pathlib
import re

from crowd_drawing.errors import InputError
from crowd_drawing.files import HEADER, read_walks
from crowd_experiments.arguments import above_zero


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
    """Returns the walks of rows (line, person, frame, x, y), in any order. Raises InputError."""
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
    """Returns columns of a line: two whole numbers, maybe as 7.8000000e+02, and two numbers. Raises InputError."""
    try:
        values = [float(words[column]) for column in columns]
        if not (values[0].is_integer() and values[1].is_integer()):
            raise ValueError
        return int(values[0]), int(values[1]), values[2], values[3]
    except (ValueError, IndexError, OverflowError):
        raise InputError(f"{file}:{line}: expected {expected}, got '{' '.join(words)}'") from None


COLUMNS = 8
PERIOD = 0.4  # [s] between two annotated frames
OBSMAT_COLUMNS = 'frame, person, x, z, y, vx, vz and vy'


def read_obsmat(file, stream):
    """Reads a file. Returns a Recording whose frames are the annotated ones, counted from 0. Raises InputError."""
    rows = []
    for line, text in enumerate(stream, 1):
        if text.strip():
            words = text.split() if len(text.split()) == COLUMNS else []
            frame, person, x, y = numbers_of(file, line, words, (0, 1, 2, 4), OBSMAT_COLUMNS)
            rows.append((line, person, frame, x, y))
    walks = collect(file, rows)
    step, first = step_of(walks), min(walk[0][0] for walk in walks.values())
    steps = collections.Counter(there[0] - here[0] for walk in walks.values() for here, there in zip(walk, walk[1:]))
    annotated = steps.most_common(1)[0][0] if steps else step  # frames between two rows of a person
    return Recording({person: [((frame - first) // step, x, y) for frame, x, y in walk]
                      for person, walk in walks.items()}, PERIOD / (annotated / step))


RATE = re.compile(r'framerate\s*:?\s*([-+.\deE]+)')
CENTIMETRES = re.compile(r'[xX]/cm|in cm')
JUPEDSIM_COLUMNS = 'id, frame, x and y'


def read_jupedsim(file, stream):
    """Reads a file. Returns a Recording. Raises InputError."""
    frame_duration, scale, rows = None, 1.0, []
    for line, text in enumerate(stream, 1):
        if text.startswith('#'):
            match = RATE.search(text)
            if match and frame_duration is None:
                frame_duration = duration_of(file, line, match[1])
            scale = 0.01 if CENTIMETRES.search(text) else scale
        elif text.strip():
            person, frame, x, y = numbers_of(file, line, text.split(), (0, 1, 2, 3), JUPEDSIM_COLUMNS)
            rows.append((line, person, frame, scale * x, scale * y))
    return Recording(collect(file, rows), frame_duration)


def duration_of(file, line, rate):
    """Returns the time between two frames [s] of a frame rate in a header."""
    try:
        return 1 / above_zero(rate)
    except (ValueError, argparse.ArgumentTypeError):
        raise InputError(f"{file}:{line}: expected a frame rate above 0, got '{rate}'") from None


def read_recording(file, instance=None):
    """Reads a Recording. `instance`: which episode of a CSV file; None: the first. Raises InputError, OSError."""
    with open(file, encoding='utf-8', errors='replace') as stream:
        first = next((line for line in stream if line.strip()), '').strip()
        stream.seek(0)
        if first.startswith(HEADER[0]):
            return Recording(read_walks(file, instance)[1])
        if instance not in (None, 0):
            raise InputError(f'{file}: has no instance {instance}, expected 0')
        columns = len(first.split())
        if first.startswith('#') or columns in (4, 5):
            return read_jupedsim(file, stream)
        if columns == COLUMNS:
            return read_obsmat(file, stream)
    raise InputError(f"{file}:1: is not a recording; expected the header {','.join(HEADER)}, the text format of "
                     'JuPedSim (comments with #, then id frame x y z), or the 8 columns of obsmat.txt')


# Head and line of a file of one instance, as evaluate or JuPedSim write it, by its ending. The numbers are read as the
# same bits.
WRITTEN = {'.csv': (','.join(HEADER) + '\n', '0,{frame},{person},{x!r},{y!r}\n'),
           '.txt': ('# description: social_crowd trajectories\n# framerate: {rate}\n# id frame x/m y/m z/m\n',
                    '{person} {frame} {x!r} {y!r} 0\n')}


def write_recording(file, recording):
    """Writes a recording in the format of the file's ending; the file appears when it is complete. Raises OSError."""
    file = pathlib.Path(file)
    part = file.with_name(f'.{file.name}.part')
    try:
        with open(part, 'w', encoding='utf-8') as stream:
            head, line = WRITTEN[file.suffix.lower()]
            stream.write(head.format(rate=round(1 / recording.frame_duration, 9)))
            for frame, person, x, y in sorted((frame, person, x, y) for person, walk in recording.walks.items()
                                              for frame, x, y in walk):
                stream.write(line.format(frame=frame, person=person, x=x, y=y))
        os.replace(part, file)
    finally:
        part.unlink(missing_ok=True)
