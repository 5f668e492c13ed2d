"""Starts nodes of this package from another one, and stops them."""
import signal
import subprocess

import roslib.packages
import rospy

PATIENCE = 5.0  # [s] time for a node to write its files and end


def start_node(kind, name, parameters):
    """Starts a node in the namespace of this one, with these parameters in place of those of an earlier node of this
    name. Returns its process."""
    rospy.set_param(rospy.resolve_name(name), parameters)
    program = roslib.packages.find_node('social_crowd', kind)[0]
    # In its own process group, so that Ctrl-C is sent to this node only, which then stops the others.
    return subprocess.Popen([program, '__name:=' + name, '__ns:=' + rospy.get_namespace()], start_new_session=True)


def stop_nodes(processes):
    """Ends nodes as Ctrl-C does, so that they write their files; kills those that do not end in time."""
    for process in processes:
        process.send_signal(signal.SIGINT)
    for process in processes:
        try:
            process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            process.kill()


def ending_of(status):
    if status >= 0:
        return 'ended with exit status %d' % status
    name = {number.value: ' (%s)' % number.name for number in signal.Signals}.get(-status, '')
    return 'was killed by signal %d%s' % (-status, name)
