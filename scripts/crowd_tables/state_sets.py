"""What rows and actions of a Q-table mean (docs/state_sets.md, "State sets", "Actions")."""
import dataclasses
import math

import numpy
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


NAMES_OF_8 = ['ahead', 'ahead left', 'left', 'behind left', 'behind', 'behind right', 'right', 'ahead right']
# Quantities of `anticipation` by the keys of their limits, from the most significant digit of a row: name and unit.
ANTICIPATION = {
    'reciprocal_times': ('reciprocal time to collision', 's'),
    'constant_velocity_times': ('constant-velocity time to collision', 's'),
    'static_times': ('time to collision with static bodies', 's'),
    'admissible_fractions': ('admissible fraction of the move', ''),
    'turns': ('turn', '°'),
    'oncoming': ('approach of another agent', 'of the maximum speed'),
}


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


def meaning_of(table):
    """Returns the Meaning of a Table's rows. Raises InputError if state set or number of rows do not fit."""
    state_set = table.header['state_set']
    kind = state_set.get('type')
    if kind not in READERS:
        raise InputError(f"{table.file}: state_set: expected one of {', '.join(READERS)}, got '{kind}'")
    try:
        meaning = READERS[kind](state_set)
    except (TypeError, ValueError) as error:
        raise InputError(f'{table.file}: state_set: {error}') from None
    rows = len(meaning.digits) + len(meaning.extra)
    if rows != table.header['rows']:
        raise InputError(f"{table.file}: rows: expected {rows}, the rows of the state set, got {table.header['rows']}")
    return meaning


def digits_of(quantities):
    """Returns the classes of all rows, the first quantity being the most significant digit: array (row, quantity)."""
    sizes = [len(quantity) for quantity in quantities]
    return numpy.stack(numpy.unravel_index(numpy.arange(math.prod(sizes)), sizes), axis=1)


def sector_names(count):
    """Returns the names of equal sectors: directions if there are eight, else the angles of their middles."""
    middles = [(360 / count * i + 180) % 360 - 180 for i in range(count)]
    return NAMES_OF_8 if count == 8 else [f'{middle:g}°' for middle in middles]


def nearest_obstacle(given):
    """(3.2-3.4): goal sectors without an obstacle, then for each the sector and distance class of the obstacle."""
    goals = Quantity('goal', sector_names(given.get('goal_sectors', 8)))
    limits = [0, *given.get('obstacle_sectors', [15, 45, 90, 180])]
    near, far = given.get('collision_radius', 0.5), given.get('vision_radius', 1.0)
    names = [f'{side} {low:g}-{high:g}°, {distance}' for side in ('left', 'right')
             for low, high in zip(limits, limits[1:]) for distance in (f'up to {near:g} m', f'up to {far:g} m')]
    obstacles = Quantity('nearest obstacle', ['none', *names])
    with_none = [(goal, 0) for goal in range(len(goals))]
    digits = with_none + [(goal, 1 + code) for goal in range(len(goals)) for code in range(len(names))]
    return Meaning('nearest_obstacle', [goals, obstacles], [], [1], [0], numpy.array(digits), ['arrival'])


def sectors_of(given):
    """Returns the number of sectors, and the indices of the quantities of the first and the second half of them."""
    count = given.get('sectors', 8)
    return count, list(range(count // 2)), list(range(count // 2, count))


def occupancy(given):
    """(3.5): the goal sector, then the distance class of each sector."""
    count, first, second = sectors_of(given)
    near, far = given.get('collision_radius', 0.5), given.get('vision_radius', 1.0)
    classes = ['empty', f'up to {near:g} m', f'up to {far:g} m']
    quantities = [Quantity('goal', sector_names(count)), *(Quantity(f'body {name}', classes)
                                                           for name in sector_names(count))]
    return Meaning('occupancy', quantities, [0], [1 + i for i in first], [1 + i for i in second], digits_of(quantities),
                   ['arrival'])


def condensed_occupancy(given):
    """(5.2): the goal sector, whether any body is near, then whether each sector is occupied."""
    count, first, second = sectors_of(given)
    near = f"within {given.get('collision_radius', 0.5):g} m"
    quantities = [Quantity('goal', sector_names(count)), Quantity(f'any body {near}', ['no', 'yes']),
                  *(Quantity(f'body {name}', ['no', 'yes']) for name in sector_names(count))]
    return Meaning('condensed_occupancy', quantities, [0], [1] + [2 + i for i in first], [2 + i for i in second],
                   digits_of(quantities), ['arrival'])


def anticipation(given):
    """One row per action: the class of a quantity is the number of limits that it reaches."""
    quantities = [Quantity(name, class_names(given.get(key, []), unit))
                  for key, (name, unit) in ANTICIPATION.items()]
    return Meaning('anticipation', quantities, [], [0, 1], [2, 3, 4, 5], digits_of(quantities), [])


def class_names(limits, unit):
    """Returns the names of the classes between limits, such as < 1 s, 1-2 s, >= 2 s."""
    if not limits:
        return ['any']
    texts = [f'{limit:g}' for limit in limits]
    names = [f'< {texts[0]}', *(f'{low}-{high}' for low, high in zip(texts, texts[1:])), f'≥ {texts[-1]}']
    return [f'{name} {unit}'.strip() if unit != '°' else f'{name}°' for name in names]


READERS = {'nearest_obstacle': nearest_obstacle, 'occupancy': occupancy, 'condensed_occupancy': condensed_occupancy,
           'anticipation': anticipation}
