"""Copies of Q-table files whose agents have no gait."""
import re

CHECKSUM = b'checksum: '
FNV_OFFSET, FNV_PRIME = 0xcbf29ce484222325, 0x100000001b3


def fnv1a(data):
    value = FNV_OFFSET
    for byte in data:
        value = (value ^ byte) * FNV_PRIME & 0xffffffffffffffff
    return value


def without_gait(contents):
    """Returns the contents of a Q-table file that has a gait without it. Throws ValueError if it has none."""
    body, found, checksum = contents.rpartition(CHECKSUM)
    if not found or checksum.strip() != b'%016x' % fnv1a(body):
        raise ValueError('expected a Q-table file with a valid checksum')
    body, removed = re.subn(rb'^(action_set: \{type: goal_relative,.*), gait: \{[^}]*\}', rb'\1', body, count=1,
                            flags=re.MULTILINE)
    if removed == 0:
        raise ValueError('expected the action set goal_relative with a gait')
    return body + CHECKSUM + b'%016x\n' % fnv1a(body)
