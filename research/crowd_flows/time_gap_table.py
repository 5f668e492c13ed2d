"""Copies of Q-tables whose agents keep a time gap."""
import re

CHECKSUM = b'checksum: '
FNV_OFFSET, FNV_PRIME = 0xcbf29ce484222325, 0x100000001b3


def fnv1a(data):
    """Returns the 64-bit FNV-1a hash of bytes."""
    value = FNV_OFFSET
    for byte in data:
        value = (value ^ byte) * FNV_PRIME & 0xffffffffffffffff
    return value


def with_time_gap(contents, time_gap, width):
    """Returns the contents of a Q-table file with another time gap, 0: none. Throws ValueError if it is not one."""
    body, found, checksum = contents.rpartition(CHECKSUM)
    if not found or checksum.strip() != b'%016x' % fnv1a(body):
        raise ValueError('expected a Q-table file with a valid checksum')
    added = b', time_gap: %s, time_gap_width: %s}' % (number(time_gap), number(width)) if time_gap > 0.0 else b'}'
    body, replaced = re.subn(rb'^(action_set: \{type: goal_relative,.*?)(, time_gap: [^}]*)?\}$',
                             lambda match: match[1] + added, body, count=1, flags=re.MULTILINE)
    if replaced == 0:
        raise ValueError('expected the action set goal_relative')
    return body + CHECKSUM + b'%016x\n' % fnv1a(body)


def number(value):
    """Returns the shortest text of a number."""
    return f'{value:.15g}'.encode()


def add_time_gap(q_table, output, time_gap, width):
    """Writes a copy of a Q-table file whose agents keep a time gap [s]."""
    output.write_bytes(with_time_gap(q_table.read_bytes(), time_gap, width))
