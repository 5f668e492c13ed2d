"""Errors in files that are drawn."""


class InputError(Exception):
    """A file cannot be drawn; the message contains the file, the place and the reason."""
