"""Q-table files (docs/q_tables.md, "Q-table files"): reading them, sums of their rows, and what rows and actions mean
(docs/state_sets.md, "State sets", "Actions")."""
import dataclasses
import itertools
import math
import subprocess
import typing

import numpy
import yaml
from crowd_drawing.errors import InputError, opened

MAGIC = 'social_crowd Q-table 1'
NEEDED = ('state_set', 'action_set', 'rows', 'actions', 'visited_rows')
MOST_VALUES = 10**8  # of a table; they have to fit in memory


def row_visits(table):
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


class Table(typing.NamedTuple):
    """A Q-table: its header, and visits and values as arrays (row, action). Values that were never visited are 0."""
    file: str
    header: dict
    visits: numpy.ndarray
    values: numpy.ndarray


def read_table(file):
    """Reads a Q-table file. The checksum is not verified. Raises InputError, OSError."""
    with opened(file) as stream:
        if next(stream, '').rstrip('\n') != MAGIC:
            raise InputError(f"{file}:1: is not a Q-table; expected '{MAGIC}'")
        lines = list(itertools.takewhile(lambda line: not line.startswith('---'), stream))
        header = header_of(file, ''.join(lines))
        shape = header['rows'], header['actions']
        visits, values = numpy.zeros(shape, dtype=numpy.int64), numpy.zeros(shape)
        first = len(lines) + 3  # number of the first line with a row
        for line in range(first, first + header['visited_rows']):
            try:
                numbers = [float(cell) for cell in next(stream, '').split()]
                row = int(numbers[0])
            except (ValueError, IndexError):
                numbers, row = [], -1
            if not (0 <= row < shape[0] and len(numbers) == 1 + 2 * shape[1] and numpy.isfinite(numbers).all()
                    and numbers[0] == row):
                raise InputError(f'{file}:{line}: expected a row from 0 to {shape[0] - 1}, with visits and value of '
                                 f'{shape[1]} actions')
            visits[row], values[row] = numbers[1::2], numbers[2::2]
    return Table(str(file), header, visits, values)


def header_of(file, text):
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


def action_names(table):
    given = table.header['action_set']
    try:
        names = ACTION_NAMES.get(given.get('type'), lambda _: [])(given)
    except (TypeError, ValueError) as error:
        raise InputError(f'{table.file}: action_set: {error}') from None
    return names if len(names) == table.header['actions'] else [f'action {i}' for i in range(table.header['actions'])]


def kings_moves(given):
    count = given.get('rotations', 8)
    if count < 1:
        raise ValueError(f'rotations: expected a whole number from 1, got {count}')
    names = [f'turn by {(360 / count * i + 180) % 360 - 180:+g}°' for i in range(count)]
    names[0] = 'ahead'
    return names + (['stay'] if given.get('stay', False) else [])


def goal_relative(given):
    names = [f'{side}{heading:g}° from the goal{slow}'
             for key, slow in (('headings', ''), ('slow_headings', ', slow'))
             for heading in given.get(key, []) for side in (('',) if heading in (0, 180) else ('left ', 'right '))]
    return names + (['stay'] if given.get('stay', True) else [])


ACTION_NAMES = {'kings_moves': kings_moves, 'goal_relative': goal_relative}
# Quantities of the panels, rows and columns of a picture; other state sets have a panel for each class of the first.
ARRANGEMENTS = {'nearest_obstacle': ([], [1], [0]), 'anticipation': ([], [0, 1], [2, 3, 4, 5])}


@dataclasses.dataclass(frozen=True)
class Quantity:
    """A quantity with its classes."""
    name: str
    classes: list  # their names

    def __len__(self):
        return len(self.classes)


class Meaning(typing.NamedTuple):
    """The quantities of a state set, and how a picture arranges them: one panel for each combination of the quantities
    `panels`, with the quantities `rows` from top to bottom and `columns` from left to right, outer ones first (all
    indices of `quantities`). `digits`: array (row, quantity) of class numbers; `extra`: names of further rows."""
    type: str
    quantities: list
    panels: list
    rows: list
    columns: list
    digits: numpy.ndarray
    extra: list

    def describe(self, row):
        if row >= len(self.digits):
            return self.extra[row - len(self.digits)]
        return '; '.join(f'{quantity.name}: {quantity.classes[digit]}'
                         for quantity, digit in zip(self.quantities, self.digits[row]))


def meaning_of(table, train):
    """Returns the Meaning of a Table's rows, which the program `train` describes. Raises InputError if the state set is
    unknown or has another number of rows."""
    state_set = yaml.safe_dump(table.header['state_set'], default_flow_style=True, width=math.inf).strip()
    done = subprocess.run([train, '--describe-rows', state_set], capture_output=True, encoding='utf-8', check=False)
    if done.returncode != 0:
        problem = done.stderr.partition('--describe-rows: ')[2].splitlines()[0]
        raise InputError(f"{table.file}: {problem.replace('line 1: ', '')}")
    found = yaml.load(done.stdout, yaml.CSafeLoader)
    quantities = [Quantity(**quantity) for quantity in found['quantities']]
    sizes = list(map(len, quantities))  # without a list of rows, the first quantity is the most significant digit
    digits = numpy.array(found['rows']) if found['rows'] else \
        numpy.stack(numpy.unravel_index(numpy.arange(math.prod(sizes)), sizes), axis=1)
    rows = len(digits) + len(found['extra'])
    if rows != table.header['rows']:
        raise InputError(f"{table.file}: rows: expected {rows}, the rows of the state set, got {table.header['rows']}")
    kind, count = table.header['state_set']['type'], len(quantities)
    middle = 1 + count // 2 if kind == 'condensed_occupancy' else (count + 1) // 2
    default = [0], list(range(1, middle)), list(range(middle, count))
    return Meaning(kind, quantities, *ARRANGEMENTS.get(kind, default), digits, found['extra'])
