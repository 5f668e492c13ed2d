"""Errors that end a program with a message."""


class InputError(Exception):
    """An input is wrong; the message contains the file, the place and the reason."""


def problem_of(error, file=None):
    """Returns the message of an exception, with the file of an OSError.

    :param file: named if the OSError names none
    """
    if isinstance(error, OSError):
        file = error.filename or file
        return f'{file}: {error.strerror or error}' if file else str(error.strerror or error)
    return str(error)
