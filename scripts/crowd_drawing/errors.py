"""Files that programs read and write, and errors that end a program with a message."""
import contextlib
import os
import pathlib

import yaml

LOADER = getattr(yaml, 'CSafeLoader', yaml.SafeLoader)  # the faster implementation, if available


@contextlib.contextmanager
def opened(file, newline=None):
    """Opens a text file for reading. Errors while it is read name it, as those of open() do."""
    try:
        with open(file, newline=newline, encoding='utf-8', errors='replace') as stream:
            yield stream
    except OSError as error:
        error.filename = error.filename or str(file)
        raise


def complete_lines(stream, file):
    """Yields the lines of a stream. Raises InputError if the last one has no end: the file was cut off."""
    for number, line in enumerate(stream, 1):
        if not line.endswith('\n'):
            raise InputError(f'{file}:{number}: the last line is not complete, as in a file that was cut off; expected '
                             'a line end')
        yield line


def ended_lines(stream):
    """Yields the lines of a stream that have an end: the last one may still be being written."""
    return (line for line in stream if line.endswith('\n'))


def check_output(file):
    """Raises InputError if a file cannot be written. To be called before work that takes long."""
    file = pathlib.Path(file)
    if file.is_dir():
        raise InputError(f'{file}: cannot be written: it is a folder')
    if not file.parent.is_dir():
        raise InputError(f'{file}: cannot be written: there is no folder {file.parent.absolute()}')


def flush_to_disk(path):
    """Flushes a file, or the names in a folder, to the disk."""
    descriptor = os.open(path, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


@contextlib.contextmanager
def replaced(file):
    """Gives a `with` block a file to write, which replaces the given one at its end, or is removed on failure. After a
    loss of power, the file is the old or the new one."""
    part = pathlib.Path(file).with_name(f'.{pathlib.Path(file).name}.part')
    try:
        yield part
        flush_to_disk(part)
        os.replace(part, file)
        flush_to_disk(part.parent)
    except OSError as error:
        if error.filename in (None, str(part)):
            error.filename = str(file)
        raise
    finally:
        part.unlink(missing_ok=True)


def read_documents(file):
    """Returns the YAML documents of a file, without empty ones. Raises InputError, OSError."""
    text = pathlib.Path(file).read_text(encoding='utf-8', errors='replace')
    try:
        return [document for document in yaml.load_all(text, LOADER) if document is not None]
    except yaml.YAMLError as error:
        raise InputError(f"{file}: not YAML: {' '.join(str(error).split())}") from None


class InputError(Exception):
    """An input is wrong; the message contains the file, the place and the reason."""


class RunError(InputError):
    """A tool has failed; the message contains the end of its output."""


def problem_of(error, file=None):
    """Returns the message of an exception, with the file of an OSError; `file` is named if it names none."""
    if isinstance(error, OSError):
        file = error.filename or file
        return f'{file}: {error.strerror or error}' if file else str(error.strerror or error)
    return str(error)
