"""Lines of files that programs of the package wrote."""
from crowd_drawing.errors import InputError


def complete_lines(stream, file):
    """Yields the lines of a stream. Raises InputError if the last one has no end: the file was cut off, maybe within a
    number."""
    for number, line in enumerate(stream, 1):
        if not line.endswith('\n'):
            raise InputError(f'{file}:{number}: the last line is not complete, as in a file that was cut off; expected '
                             'a line end')
        yield line


def ended_lines(stream):
    """Yields the lines of a stream that have an end: the last one may still be being written."""
    return (line for line in stream if line.endswith('\n'))
