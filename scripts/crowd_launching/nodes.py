"""Starts nodes of this package from another one, and stops them."""
import os
import signal
import subprocess
import time

import roslib.packages
import rospy

PATIENCE = 7.0  # [s] time for nodes to write their files and end; roslaunch ends this process after 15 s


class NodeError(Exception):
    """A program of the package is missing or has failed, or a node has refused a request."""


def find_program(name):
    """Returns the file of a program of the package. Raises NodeError if it is not built."""
    files = roslib.packages.find_node('social_crowd', name)
    if not files:
        raise NodeError(f"the program '{name}' is not built: scripts/build builds all programs")
    return files[0]


def start_node(kind, name, parameters):
    """Starts a node in the namespace of this one, with these parameters in place of those of an earlier node of this
    name. Returns its process. Raises NodeError if it is not built."""
    program = find_program(kind)
    rospy.set_param(rospy.resolve_name(name), parameters)
    # In its own process group, so that Ctrl-C is sent to this node only, which then stops the others.
    return subprocess.Popen([program, '__name:=' + name, '__ns:=' + rospy.get_namespace()], start_new_session=True)


def stop_nodes(processes, number=signal.SIGINT):
    """Ends nodes that have process groups of their own, as Ctrl-C does, so that they write their files. Kills those
    that do not end in time."""
    for process in processes:
        if process.poll() is None:
            os.killpg(process.pid, number)
    end = time.monotonic() + PATIENCE
    for process in processes:
        try:
            process.wait(max(0.0, end - time.monotonic()))
        except subprocess.TimeoutExpired:
            process.kill()


def ending_of(status):
    if status >= 0:
        return 'ended with exit status %d' % status
    name = {number.value: ' (%s)' % number.name for number in signal.Signals}.get(-status, '')
    return 'was killed by signal %d%s' % (-status, name)
