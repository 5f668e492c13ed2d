"""Plays a bag, then ends the launch."""
import os
import sys

import roslib.packages

from .program import Program, end_launch

STAY, NO_FILE = '--stay', 'none'  # the latter is the default of replay.launch
FIRST_BYTES = b'#ROSBAG'


def problem_of(file):
    """Returns why a file cannot be played; an empty text if the reason is unknown."""
    path = os.path.abspath(file)
    if not os.path.isfile(path):
        return 'there is no file %s' % path + ('' if os.path.isabs(file) else '; give an absolute path')
    with open(path, 'rb') as stream:
        return '' if stream.read(len(FIRST_BYTES)) == FIRST_BYTES else '%s is not a bag' % path


def main():
    arguments = [word for word in sys.argv[1:] if word != STAY]
    files = [word for word in arguments if not word.startswith('-') and ':=' not in word]
    if files in ([], [NO_FILE]):
        print('play_bag: no recording is given; expected bag:=FILE or trajectories:=FILE', file=sys.stderr)
        return 2
    player = Program([roslib.packages.find_node('rosbag', 'play')[0], *arguments])
    status = player.wait()
    if player.is_stopped:
        return status
    if status == 0 and STAY not in sys.argv:
        end_launch()
    if status != 0 and problem_of(files[-1]):
        print('play_bag: %s' % problem_of(files[-1]), file=sys.stderr)
    return status
