"""Errors in files that are drawn."""


class InputError(Exception):
    """A file cannot be drawn; the message contains the file, the place and the reason."""


def problem_of(error, file):
    """Returns the message of an exception, with the file of an OSError.

    :param file: named if the OSError names none
    """
    if isinstance(error, OSError):
        return f'{error.filename or file}: {error.strerror or error}'
    return str(error)
