"""Errors of films."""


class FilmError(Exception):
    """A film cannot be made; the message contains the reason and what was expected."""
