"""Commands of the page: their keys, and what these may contain."""
import json
import math

from crowd_drawing.errors import InputError

GREATEST_PLACE = 1e6  # [m]
GREATEST_NUMBER = 2**53  # that JSON has exactly
LONGEST_NAME = 200
MOST_TICKS = 10000  # of a step
FASTEST = 1e6
REQUIRED = object()


def number(low, high):
    """Returns a function that returns a number within these limits as float, or raises ValueError."""
    def read(value):
        if isinstance(value, bool) or not isinstance(value, (int, float)) or not low <= value <= high:
            raise ValueError(f'a number from {low:g} to {high:g}')
        return float(value)
    return read


def whole(low, high=GREATEST_NUMBER):
    """The same for whole numbers."""
    def read(value):
        if isinstance(value, bool) or not isinstance(value, int) or not low <= value <= high:
            raise ValueError(f'a whole number from {low} to {high}')
        return value
    return read


def point(value):
    """Returns x, y. Raises ValueError."""
    try:
        x, y = value if isinstance(value, list) else ()
        return tuple(map(number(-GREATEST_PLACE, GREATEST_PLACE), (x, y)))
    except ValueError:
        raise ValueError(f'[x, y] with numbers from {-GREATEST_PLACE:g} to {GREATEST_PLACE:g}') from None


def name(value):
    """Returns a text of at least one character. Raises ValueError."""
    if not isinstance(value, str) or not 0 < len(value) <= LONGEST_NAME:
        raise ValueError(f'a text of 1 to {LONGEST_NAME} characters')
    return value


def or_null(read):
    """The same, or null."""
    return lambda value: None if value is None else read(value)


AGENT = whole(0, 2**31 - 1)
LENGTH = number(0.001, 1000)
# By command, its keys: how each is read, and its default.
COMMANDS = {
    'play': {},
    'pause': {},
    'step': {'ticks': (whole(1, MOST_TICKS), 1)},
    'speed': {'factor': (number(0, FASTEST), REQUIRED)},
    'scenario': {'name': (name, REQUIRED)},
    'reset': {'seed': (or_null(whole(0)), None)},
    'add_agent': {'position': (point, REQUIRED), 'goal': (point, REQUIRED), 'radius': (LENGTH, 0.25),
                  'max_speed': (LENGTH, 1.3), 'heading': (or_null(number(-1e3, 1e3)), None)},
    'remove_agent': {'agent': (AGENT, REQUIRED)},
    'set_goal': {'agent': (AGENT, REQUIRED), 'goal': (point, REQUIRED)},
    'add_obstacle': {'position': (point, REQUIRED), 'radius': (LENGTH, REQUIRED)},
    'remove_obstacle': {'obstacle': (AGENT, REQUIRED)},
    'add_wall': {'from': (point, REQUIRED), 'to': (point, REQUIRED)},
    'remove_wall': {'wall': (AGENT, REQUIRED)},
    'select': {'agent': (or_null(AGENT), REQUIRED)},
    'recordings': {},
    'open_recording': {'name': (name, REQUIRED)},
}


class NotTheProtocol(Exception):
    """A message is not one of the protocol at all."""


def message_of(text, key):
    """Returns the JSON object in a text, and its text under a key. Raises NotTheProtocol."""
    try:
        message = json.loads(text)
    except (ValueError, RecursionError):
        raise NotTheProtocol('expected JSON') from None
    if not isinstance(message, dict) or not isinstance(message.get(key), str):
        raise NotTheProtocol(f"expected a JSON object with a text under '{key}'")
    return message, message[key]


def arguments_of(command, message):
    """Returns the values of the keys of a command. Raises InputError."""
    if command not in COMMANDS:
        raise InputError(f"unknown command '{command[:LONGEST_NAME]}', expected one of {', '.join(COMMANDS)}")
    keys = COMMANDS[command]
    unknown = sorted(message.keys() - keys.keys() - {'command'})
    if unknown:
        raise InputError(f"unknown key '{unknown[0][:LONGEST_NAME]}', expected " +
                         (', '.join(keys) if keys else 'no keys beside command'))
    values = {}
    for key, (read, default) in keys.items():
        if key not in message and default is REQUIRED:
            raise InputError(f'{key}: is missing')
        try:
            values[key] = read(message[key]) if key in message else default
        except (ValueError, OverflowError) as error:
            raise InputError(f'{key}: expected {error}, got {shown(message[key])}') from None
    return values


def shown(value):
    """Returns the begin of a value as JSON, for a message."""
    text = json.dumps(value)
    return text if len(text) <= 60 else text[:57] + '...'


def heading_towards(position, goal):
    """Returns the heading from a place to another one [rad]."""
    return math.atan2(goal[1] - position[1], goal[0] - position[0])
