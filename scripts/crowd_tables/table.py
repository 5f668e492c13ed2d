"""Reads Q-table files (docs/q_tables.md, "Q-table files"), and sums up their rows."""
import dataclasses
import itertools

import numpy
import yaml
from crowd_drawing.errors import InputError


def row_visits(table):
    """Returns the number of visits of each row."""
    return table.visits.sum(axis=1)


def row_values(table, kind):
    """Returns the value of each row; nan if it was not visited.

    If all actions share a row, as in most state sets, it is the highest value of a visited action: what the agent
    expects there. With `anticipation` each action has a row of its own: the mean over actions, weighted by visits."""
    visited = table.visits > 0
    known = visited.any(axis=1)
    if kind == 'anticipation':
        weighed = (table.visits * table.values).sum(axis=1)
        return numpy.divide(weighed, row_visits(table), out=numpy.full(len(known), numpy.nan), where=known)
    return numpy.where(known, numpy.where(visited, table.values, -numpy.inf).max(axis=1), numpy.nan)


def greedy_actions(table):
    """Returns the action with the highest value in each row, the first of several; 0 without a visit."""
    return table.values.argmax(axis=1)


MAGIC = 'social_crowd Q-table 1'
NEEDED = ('state_set', 'action_set', 'rows', 'actions', 'visited_rows')
MOST_VALUES = 10**8  # of a table; they have to fit in memory


@dataclasses.dataclass(frozen=True)
class Table:
    """A Q-table: its header, and visits and values as arrays (row, action). Values that were never visited are 0."""
    file: str
    header: dict
    visits: numpy.ndarray
    values: numpy.ndarray


def read_table(file):
    """Reads a Q-table file. The checksum is not verified. Raises InputError, OSError."""
    with open(file, encoding='utf-8', errors='replace') as stream:
        if next(stream, '').rstrip('\n') != MAGIC:
            raise InputError(f"{file}:1: is not a Q-table; expected '{MAGIC}'")
        lines = list(itertools.takewhile(lambda line: not line.startswith('---'), stream))
        header = header_of(file, ''.join(lines))
        shape = header['rows'], header['actions']
        visits, values = numpy.zeros(shape, dtype=numpy.int64), numpy.zeros(shape)
        first = len(lines) + 3  # number of the first line with a row
        for line in range(first, first + header['visited_rows']):
            row, *cells = next(stream, '').split() or ['']
            put(f'{file}:{line}', row, cells, visits, values)
    return Table(str(file), header, visits, values)


def header_of(file, text):
    """Returns the header as a map."""
    try:
        header = yaml.safe_load(text)
        missing = [key for key in NEEDED if key not in header]
    except (yaml.YAMLError, TypeError) as error:
        raise InputError(f"{file}: the header is not a map: {' '.join(str(error).split())}") from None
    if missing:
        raise InputError(f"{file}: the header has no {', '.join(missing)}")
    for key in NEEDED[:2]:
        if not isinstance(header[key], dict):
            raise InputError(f"{file}: {key}: expected a map, got '{header[key]}'")
    for key in NEEDED[2:]:
        if not isinstance(header[key], int) or header[key] < 0:
            raise InputError(f"{file}: {key}: expected a whole number, got '{header[key]}'")
    if header['rows'] * header['actions'] > MOST_VALUES:
        raise InputError(f"{file}: rows: expected at most {MOST_VALUES} values, got {header['rows']} rows of "
                         f"{header['actions']} actions")
    return header


def put(place, row, cells, visits, values):
    """Stores a line: the number of a row, and visits and value of each action."""
    try:
        number = int(row)
        numbers = [float(cell) for cell in cells]
    except ValueError:
        number, numbers = -1, []
    if not (0 <= number < len(visits) and len(numbers) == 2 * visits.shape[1] and numpy.isfinite(numbers).all()):
        raise InputError(f'{place}: expected a row from 0 to {len(visits) - 1}, with visits and value of '
                         f'{visits.shape[1]} actions')
    visits[number], values[number] = numbers[::2], numbers[1::2]
