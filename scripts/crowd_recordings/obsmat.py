"""Recordings of people filmed from above, as in the ETH and UCY data sets: obsmat.txt.

Lines `frame person x z y vx vz vy`, separated by white space, in metres and metres per second; z is not used. People
were annotated every 0.4 s; the frames between are not in the file.
"""
import collections

from crowd_recordings.recording import Recording, collect, numbers_of, step_of

COLUMNS = 8
PERIOD = 0.4  # [s] between two annotated frames
EXPECTED = 'frame, person, x, z, y, vx, vz and vy'


def is_obsmat(first):
    """Returns whether a file begins as obsmat.txt."""
    return len(first.split()) == COLUMNS


def read(file, stream):
    """Reads a file. Returns a Recording whose frames are the annotated ones, counted from 0. Raises InputError."""
    rows = []
    for line, text in enumerate(stream, 1):
        if text.strip():
            words = text.split()
            frame, person, x, y = numbers_of(file, line, words if len(words) == COLUMNS else [], (0, 1, 2, 4), EXPECTED)
            rows.append((line, person, frame, x, y))
    walks = collect(file, rows)
    step, first = step_of(walks), min(walk[0][0] for walk in walks.values())
    return Recording({person: [((frame - first) // step, x, y) for frame, x, y in walk]
                      for person, walk in walks.items()}, PERIOD / (annotated_step(walks, step) / step))


def annotated_step(walks, default):
    """Returns the most frequent number of frames between two rows of a person."""
    steps = collections.Counter(there[0] - here[0] for walk in walks.values() for here, there in zip(walk, walk[1:]))
    return steps.most_common(1)[0][0] if steps else default
