"""Copies of Q-table files whose agents have other bodies: keys of `anticipation` and `goal_relative`."""
import re

CHECKSUM = b'checksum: '
FNV_OFFSET, FNV_PRIME = 0xcbf29ce484222325, 0x100000001b3


def fnv1a(data):
    value = FNV_OFFSET
    for byte in data:
        value = (value ^ byte) * FNV_PRIME & 0xffffffffffffffff
    return value


def with_line(contents, pattern, replacement):
    """Returns the contents of a Q-table file with another line of the header. Throws ValueError if it is not one."""
    body, found, checksum = contents.rpartition(CHECKSUM)
    if not found or checksum.strip() != b'%016x' % fnv1a(body):
        raise ValueError('expected a Q-table file with a valid checksum')
    body, replaced = re.subn(pattern, replacement, body, count=1, flags=re.MULTILINE)
    if replaced == 0:
        raise ValueError('expected the state set anticipation and the action set goal_relative')
    return body + CHECKSUM + b'%016x\n' % fnv1a(body)


def with_body(contents, keys, personal_space=0.0):
    """Returns the contents of a Q-table file with another personal space [m] in its state set, and other keys after
    `lookout` in its action set, such as 'time_gap: 0.9, time_gap_width: 0.8', in the order of the file. Throws
    ValueError if it is not one."""
    space = b', personal_space: %g' % personal_space if personal_space else b''
    added = b', ' + keys.encode() if keys else b''
    contents = with_line(contents, rb'^(state_set: \{type: anticipation,.*?)(, personal_space: [^,}]*)?\}$',
                         lambda match: match[1] + space + b'}')
    return with_line(contents, rb'^(action_set: \{type: goal_relative,.*?, lookout: [^,}]*).*\}$',
                     lambda match: match[1] + added + b'}')


def without_gait(contents):
    """Returns the contents of a Q-table file that has a gait without it. Throws ValueError if it has none."""
    return with_line(contents, rb'^(action_set: \{type: goal_relative,.*), gait: \{[^}]*\}', rb'\1')
