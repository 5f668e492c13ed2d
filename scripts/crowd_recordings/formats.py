"""Reads and writes recordings; the format of a file is recognised by its first line."""
import os
import pathlib

from crowd_drawing.errors import InputError
from crowd_drawing.files import HEADER, read_walks
from crowd_recordings import jupedsim_text, obsmat
from crowd_recordings.recording import Recording

CSV_HEADER = ','.join(HEADER)


def read_recording(file, instance=None):
    """Reads a recording. Returns a Recording. `instance`: which episode of a CSV file; None: the first.

    Raises InputError, OSError."""
    with open(file, encoding='utf-8', errors='replace') as stream:
        first = next((line for line in stream if line.strip()), '').strip()
        stream.seek(0)
        if first.startswith(HEADER[0]):
            return Recording(read_walks(file, instance)[1])
        if instance not in (None, 0):
            raise InputError(f'{file}: has no instance {instance}, expected 0')
        for recognise, read in ((jupedsim_text.is_jupedsim, jupedsim_text.read), (obsmat.is_obsmat, obsmat.read)):
            if recognise(first):
                return read(file, stream)
    raise InputError(f'{file}:1: is not a recording; expected the header {CSV_HEADER}, the text format of JuPedSim '
                     '(comments with #, then id frame x y z), or the 8 columns of obsmat.txt')


def write_csv(stream, recording):
    """Writes a Recording as evaluate does: one instance with the frames as ticks."""
    stream.write(CSV_HEADER + '\n')
    rows = sorted((frame, person, x, y) for person, walk in recording.walks.items() for frame, x, y in walk)
    for frame, person, x, y in rows:
        stream.write(f'0,{frame},{person},{x!r},{y!r}\n')


WRITERS = {'.csv': write_csv, '.txt': jupedsim_text.write}


def write_recording(file, recording):
    """Writes a recording in the format of the file's ending; the file appears when it is complete. Raises OSError."""
    file = pathlib.Path(file)
    part = file.with_name(f'.{file.name}.part')
    try:
        with open(part, 'w', encoding='utf-8') as stream:
            WRITERS[file.suffix.lower()](stream, recording)
        os.replace(part, file)
    finally:
        part.unlink(missing_ok=True)
