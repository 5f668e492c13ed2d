"""Command lines: parsers, and types of numbers, which refuse values out of range."""
import argparse
import math
import os
import pathlib

STATUSES = '0 success, 1 an error, 2 wrong usage, 130 interrupted.'


def number_type(kind, fits, expected):
    """Returns a type for argparse: a number that fits."""
    def read(text):
        try:
            number = kind(text)
        except ValueError:
            number = None
        if number is None or not fits(number):
            raise argparse.ArgumentTypeError(f"expected {expected}, got '{text}'")
        return number
    return read


whole = number_type(int, lambda number: number >= 0, 'a whole number from 0')
positive = number_type(int, lambda number: number >= 1, 'a whole number from 1')
at_least_zero = number_type(float, lambda number: 0 <= number < math.inf, 'a number from 0')
above_zero = number_type(float, lambda number: 0 < number < math.inf, 'a number above 0')
pixels = number_type(int, lambda number: 320 <= number <= 4000, 'a whole number from 320 to 4000')


def parser_of(name, description, epilog, statuses=STATUSES):
    """Returns a parser whose help keeps the line breaks of these texts, and ends with the exit statuses."""
    return argparse.ArgumentParser(prog=name, description=description, epilog=f'{epilog}\n\nExit status: {statuses}',
                                   formatter_class=argparse.RawDescriptionHelpFormatter)


def add_file(parser, name, **options):
    parser.add_argument(name, type=pathlib.Path, **{'metavar': 'FILE', **options})


def add_tools(parser, tools='train and evaluate'):
    """Adds the option --tools, for find_tools()."""
    add_file(parser, '--tools', metavar='FOLDER', help=f'folder of {tools} (default: the folder of this program; if '
             'they are not there, the package is built)')


def labelled(word):
    """Returns label and file of a word [LABEL=]FILE; None without a label. A sign in the name of a folder, such as
    runs/000_gamma=0.1/record.csv, does not end a label: a label has no slash, and the name of a file has no label."""
    label, sign, file = word.partition('=')
    return (None, word) if not label or not sign or '/' in label or os.path.exists(word) else (label, file)
