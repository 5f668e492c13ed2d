"""Parts of scenario files as text."""
import json
import re

PLAIN_NAME = re.compile(r'[A-Za-z_][A-Za-z0-9_]*')
WORDS_OF_YAML = {'true', 'false', 'yes', 'no', 'on', 'off', 'null', 'y', 'n'}


def number_text(value):
    """Returns a number with up to ten digits, without trailing zeros."""
    return format(value + 0.0, '.10g')  # 0 instead of -0


def name_text(name):
    """Returns a name, in quotes where YAML needs them."""
    is_plain = PLAIN_NAME.fullmatch(name) and name.lower() not in WORDS_OF_YAML
    return name if is_plain else json.dumps(name, ensure_ascii=False)


def point(numbers):
    """Returns [x, y], or [low, high]."""
    return f"[{', '.join(map(number_text, numbers))}]"


def box(middle, sides):
    """Returns the place of a box from its middle and its sides [m]."""
    low, high = ([at + sign * side / 2 for at, side in zip(middle, sides)] for sign in (-1, 1))
    return f'{{box: [{point(low)}, {point(high)}]}}'


def region(middle, sides):
    """Returns the middle if the box has no extent, otherwise the place of the box."""
    return box(middle, sides) if max(sides) > 0 else point(middle)


def ring(disc):
    """Returns the place of a disc with `centre` and `radius` [m]."""
    if disc.radius == 0:
        return point(disc.centre)
    return f'{{ring: {{centre: {point(disc.centre)}, radius: [0, {number_text(disc.radius)}]}}}}'


def section(key, entries):
    """Returns a key with a list of entries, or with named entries, which begin with a space or a line break."""
    if not entries:
        return ''
    if isinstance(entries, dict):
        return f'{key}:\n' + ''.join(f'  {name_text(name)}:{entry}\n' for name, entry in entries.items())
    return f'{key}:\n' + ''.join(f'  - {entry}\n' for entry in entries)
