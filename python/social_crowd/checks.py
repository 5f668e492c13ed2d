"""Checks of numbers that users give."""
from social_crowd.errors import InputError


def whole_number(name, given, least=0):
    """Returns a whole number. Raises InputError unless it is one, and at least `least`."""
    try:
        number = given.__index__()
    except AttributeError:
        raise InputError(f'{name}: expected a whole number, got {given!r}') from None
    if number < least:
        raise InputError(f'{name}: expected at least {least}, got {number}')
    return number
