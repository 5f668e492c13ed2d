"""What rows and actions of a Q-table mean (docs/state_sets.md, "State sets", "Actions")."""
import dataclasses
import math
import subprocess

import numpy
import yaml
from crowd_drawing.errors import InputError


def action_names(table):
    """Returns a name for each action of a Table."""
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
ARRANGEMENTS = {'nearest_obstacle': ([], [1], [0]), 'anticipation': ([], [0, 1], [2, 3, 4, 5])}


@dataclasses.dataclass(frozen=True)
class Quantity:
    """A quantity with its classes."""
    name: str
    classes: list  # their names

    def __len__(self):
        return len(self.classes)


@dataclasses.dataclass(frozen=True)
class Meaning:
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
        """Returns the meaning of a row as a text."""
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
    digits = numpy.array(found['rows']) if found['rows'] else digits_of(quantities)
    rows = len(digits) + len(found['extra'])
    if rows != table.header['rows']:
        raise InputError(f"{table.file}: rows: expected {rows}, the rows of the state set, got {table.header['rows']}")
    kind = table.header['state_set']['type']
    return Meaning(kind, quantities, *arrangement(kind, len(quantities)), digits, found['extra'])


def arrangement(kind, quantities):
    """Returns the quantities of panels, rows and columns of a picture."""
    if kind in ARRANGEMENTS:
        return ARRANGEMENTS[kind]
    middle = 1 + quantities // 2 if kind == 'condensed_occupancy' else (quantities + 1) // 2
    return [0], list(range(1, middle)), list(range(middle, quantities))


def digits_of(quantities):
    """Returns the classes of all rows, the first quantity being the most significant digit: array (row, quantity)."""
    sizes = [len(quantity) for quantity in quantities]
    return numpy.stack(numpy.unravel_index(numpy.arange(math.prod(sizes)), sizes), axis=1)
