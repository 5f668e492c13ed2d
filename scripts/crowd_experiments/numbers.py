"""Numbers on command lines: types for argparse, which refuse values out of range."""
import argparse
import math


def whole(text):
    """Returns a whole number from 0."""
    return checked(int, text, lambda number: number >= 0, 'a whole number from 0')


def positive(text):
    """Returns a whole number from 1."""
    return checked(int, text, lambda number: number >= 1, 'a whole number from 1')


def at_least_zero(text):
    """Returns a finite number from 0."""
    return checked(float, text, lambda number: 0 <= number < math.inf, 'a number from 0')


def above_zero(text):
    """Returns a finite number above 0."""
    return checked(float, text, lambda number: 0 < number < math.inf, 'a number above 0')


def pixels(text):
    """Returns the side of a picture."""
    return checked(int, text, lambda number: 320 <= number <= 4000, 'a whole number from 320 to 4000')


def checked(kind, text, fits, expected):
    """Returns the number of a text if it is one, and fits."""
    try:
        number = kind(text)
    except ValueError:
        number = None
    if number is None or not fits(number):
        raise argparse.ArgumentTypeError(f"expected {expected}, got '{text}'")
    return number
