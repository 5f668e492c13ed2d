"""Errors that end a program with a message."""


class InputError(Exception):
    """An input is wrong; the message contains the file, the place and the reason."""


def problem_of(error):
    """Returns the message of an exception, with the file of an OSError if it names one."""
    if isinstance(error, OSError):
        return f'{error.filename}: {error.strerror}' if error.filename else str(error.strerror or error)
    return str(error)
