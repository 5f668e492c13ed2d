"""Messages of ROS as JSON and back, as rosbridge has them: times as secs and nsecs, bytes as base64, and null for
numbers that JSON does not have."""
import base64
import io
import math
import struct

import genpy
import genpy.message
from crowd_drawing.errors import InputError

BYTES = ('uint8', 'char')
FLOATS = ('float32', 'float64')


def to_json(value, kind):
    """Returns what JSON has for a value of a type, such as geometry_msgs/Point[]."""
    if kind.endswith(']'):
        of = kind[:kind.rindex('[')]
        if of in BYTES:
            return base64.b64encode(bytes(value)).decode()
        return [to_json(element, of) for element in value]
    if kind in FLOATS:
        return value if math.isfinite(value) else None
    if isinstance(value, genpy.TVal):
        return {'secs': value.secs, 'nsecs': value.nsecs}
    if isinstance(value, genpy.Message):
        return {name: to_json(getattr(value, name), of) for name, of in zip(value.__slots__, value._slot_types)}
    return value.decode('utf-8', 'replace') if isinstance(value, bytes) else value


def fill(message, values):
    """Fills a message with a dict by the names of its fields, or a list in their order. Raises InputError."""
    try:
        genpy.message.fill_message_args(message, [values] if isinstance(values, dict) else values)
        message.serialize(io.BytesIO())
    except (genpy.MessageException, genpy.SerializationError, ArithmeticError, AttributeError, LookupError,
            RecursionError, TypeError, ValueError, struct.error) as error:
        raise InputError(f'the arguments do not fit {message._type}: {str(error)[:500]}') from None
    return message
