"""Reads serialised social_crowd/AgentStates into arrays, without an object for each agent."""
import struct

import genpy
import numpy
from social_crowd.msg import AgentState, ObstacleState

NUMBERS = {'bool': 'u1', 'uint8': 'u1', 'uint32': '<u4', 'uint64': '<u8', 'float64': '<f8'}


def dtype_of(message):
    """Returns the dtype of a type of messages as genpy serialises them: their fields in order, without gaps."""
    return numpy.dtype([(name, *type_of(kind)) for name, kind in zip(message.__slots__, message._slot_types)])


def type_of(kind):
    """Returns the dtype of a field, and its shape if it is a message of float64."""
    if kind in NUMBERS:
        return (NUMBERS[kind],)
    message = genpy.message.get_message_class(kind) if '/' in kind else None
    if message is None or set(message._slot_types) != {'float64'}:
        raise TypeError(f'AgentStates: expected numbers and messages of float64, got a field of {kind}')
    return NUMBERS['float64'], (len(message._slot_types),)


AGENT = dtype_of(AgentState)
OBSTACLE = dtype_of(ObstacleState)


class AgentStates:
    """Episode, tick and time of a message, and its agents and obstacles as arrays of AGENT and OBSTACLE."""

    def __init__(self, data):
        """Raises ValueError or struct.error if the data are not such a message."""
        frame_length, = struct.unpack_from('<I', data, 12)
        at = 16 + frame_length
        self.episode, self.tick, self.time = struct.unpack_from('<QQd', data, at)
        self.agents, at = read_array(data, at + 24, AGENT)
        self.obstacles, at = read_array(data, at, OBSTACLE)
        if at != len(data):
            raise ValueError(f'AgentStates: expected {at} bytes, got {len(data)}')


def read_array(data, at, dtype):
    """Returns the array at a place, with its length before it, and the place after it."""
    count, = struct.unpack_from('<I', data, at)
    return numpy.frombuffer(data, dtype, count, at + 4), at + 4 + count * dtype.itemsize


def tick_of(data):
    """Returns the episode and the tick of a serialised message."""
    frame_length, = struct.unpack_from('<I', data, 12)
    return struct.unpack_from('<QQ', data, 16 + frame_length)
