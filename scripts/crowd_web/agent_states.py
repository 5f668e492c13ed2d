"""Reads serialised social_crowd/AgentStates into arrays, without an object for each agent."""
import struct

import numpy

# As genpy serialises the fields of AgentState.msg and ObstacleState.msg: in their order, without gaps.
AGENT = numpy.dtype([
    ('id', '<u4'), ('pose', '<f8', 3), ('velocity', '<f8', 3), ('max_speed', '<f8'), ('radius', '<f8'),
    ('figure', 'u1'), ('group', '<u4'), ('goal', '<f8', 3), ('status', 'u1'), ('in_contact', 'u1'), ('touched', 'u1'),
    ('in_collision', 'u1'), ('collided', 'u1'), ('blocked', 'u1'), ('blocked_moves', '<u8')])
OBSTACLE = numpy.dtype([
    ('id', '<u4'), ('recorded', 'u1'), ('person', '<u8'), ('position', '<f8', 3), ('velocity', '<f8', 3),
    ('radius', '<f8')])


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
