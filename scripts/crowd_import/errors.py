"""Errors in files that are converted."""


class InputError(Exception):
    """A file cannot be converted; the message contains the file, the line and the reason."""
