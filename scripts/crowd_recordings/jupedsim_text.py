"""Trajectories in the text format of JuPedSim, which PedPy reads with load_trajectory_from_txt().

Lines `id frame x y [z ...]`, separated by white space, in metres or centimetres; comments begin with #. One of them
has the frame rate, `# framerate: 10.00`, and one the unit, `# id frame x/m y/m z/m`.
"""
import argparse
import re

from crowd_drawing.errors import InputError
from crowd_experiments.arguments import above_zero
from crowd_recordings.recording import Recording, collect, numbers_of

RATE = re.compile(r'framerate\s*:?\s*([-+.\deE]+)')
CENTIMETRES = re.compile(r'[xX]/cm|in cm')
EXPECTED = 'id, frame, x and y'


def is_jupedsim(first):
    """Returns whether a file begins as JuPedSim's: with a comment, or with 4 or 5 columns."""
    return first.startswith('#') or len(first.split()) in (4, 5)


def read(file, stream):
    """Reads a file. Returns a Recording. Raises InputError."""
    frame_duration, scale, rows = None, 1.0, []
    for line, text in enumerate(stream, 1):
        if text.startswith('#'):
            match = RATE.search(text)
            if match and frame_duration is None:
                frame_duration = duration_of(file, line, match[1])
            scale = 0.01 if CENTIMETRES.search(text) else scale
        elif text.strip():
            person, frame, x, y = numbers_of(file, line, text.split(), (0, 1, 2, 3), EXPECTED)
            rows.append((line, person, frame, scale * x, scale * y))
    return Recording(collect(file, rows), frame_duration)


def duration_of(file, line, rate):
    """Returns the time between two frames [s] of a frame rate in a header."""
    try:
        return 1 / above_zero(rate)
    except (ValueError, argparse.ArgumentTypeError):
        raise InputError(f"{file}:{line}: expected a frame rate above 0, got '{rate}'") from None


def write(stream, recording):
    """Writes a Recording with a known frame rate. Numbers are written so that reading gives the same bits."""
    stream.write('# description: social_crowd trajectories\n'
                 f'# framerate: {round(1 / recording.frame_duration, 9)}\n'
                 '# id frame x/m y/m z/m\n')
    rows = sorted((frame, person, x, y) for person, walk in recording.walks.items() for frame, x, y in walk)
    for frame, person, x, y in rows:
        stream.write(f'{person} {frame} {x!r} {y!r} 0\n')
