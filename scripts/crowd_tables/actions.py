"""What the actions of a Q-table mean (docs/learning.md, "Actions")."""
from crowd_drawing.errors import InputError


def action_names(table):
    """Returns a name for each action of a Table."""
    given = table.header['action_set']
    try:
        names = READERS.get(given.get('type'), lambda _: [])(given)
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


READERS = {'kings_moves': kings_moves, 'goal_relative': goal_relative}
