"""Plays a bag, then ends the launch."""
import os
import sys
import time

import rosbag
import rosgraph
import roslib.packages

from .program import Program, end_launch

STAY, WAIT, INTO = '--stay', '--wait', '--into='
NO_FILE = 'none'  # the default of replay.launch
SHOWN_TOPICS = ('scenario', 'agents')
COMMON_TOPICS = '/tf', '/tf_static', '/clock', '/rosout'  # of all nodes, whatever their namespace
PATIENCE = 30.0  # [s] time for others to subscribe
PERIOD = 0.1  # [s]
FIRST_BYTES = b'#ROSBAG'


def problem_of(file):
    """Returns why a file cannot be played; an empty text if the reason is unknown."""
    path = os.path.abspath(file)
    if not os.path.isfile(path):
        return 'there is no file %s' % path + ('' if os.path.isabs(file) else '; give an absolute path')
    with open(path, 'rb') as stream:
        return '' if stream.read(len(FIRST_BYTES)) == FIRST_BYTES else '%s is not a bag' % path


def remappings(file, folder):
    """Returns arguments of `rosbag play` with which the topics of a bag in this namespace are published in a folder of
    it; none if the folder is empty or the bag cannot be read."""
    try:
        with rosbag.Bag(file) as bag:
            topics = sorted(bag.get_type_and_topic_info().topics)
    except (OSError, rosbag.ROSBagException):
        return []
    here = rosgraph.names.get_ros_namespace()
    names = [topic if topic.startswith('/') else here + topic for topic in topics]  # rosbag records them as given
    return [f'{name}:={here}{folder}/{name[len(here):]}' for name in names
            if folder and name.startswith(here) and name not in COMMON_TOPICS]


def wait_for_subscribers(folder):
    """Waits until nodes subscribe to SHOWN_TOPICS, in a folder of this namespace unless it is empty, but not longer
    than PATIENCE."""
    master = rosgraph.Master('/play_bag')
    names = [f'{folder}/{topic}' if folder else topic for topic in SHOWN_TOPICS]
    topics = {rosgraph.names.script_resolve_name('/play_bag', name) for name in names}
    deadline = time.monotonic() + PATIENCE
    while time.monotonic() < deadline and not topics <= {topic for topic, _ in master.getSystemState()[1]}:
        time.sleep(PERIOD)


def main():
    arguments = [word for word in sys.argv[1:] if word not in (STAY, WAIT) and not word.startswith(INTO)]
    folder = next((word[len(INTO):] for word in sys.argv[1:] if word.startswith(INTO)), '')
    files = [word for word in arguments if not word.startswith('-') and ':=' not in word]
    if files in ([], [NO_FILE]):
        print('play_bag: no recording is given; expected bag:=FILE or trajectories:=FILE', file=sys.stderr)
        return 2
    if WAIT in sys.argv:
        wait_for_subscribers(folder)
    player = Program([roslib.packages.find_node('rosbag', 'play')[0], *arguments, *remappings(files[-1], folder)])
    status = player.wait()
    if player.is_stopped:
        return status
    if status == 0 and STAY not in sys.argv:
        end_launch()
    if status != 0 and problem_of(files[-1]):
        print('play_bag: %s' % problem_of(files[-1]), file=sys.stderr)
    return status
