"""Makes this process a ROS node that SIGINT and SIGTERM shut down at any time."""
import atexit
import queue
import signal
import sys
import threading

import rospy

PATIENCE = 10.0  # [s] longest wait at the exit for a shutdown that has begun


def is_ending():
    """Returns whether the shutdown of the node has begun. rospy.is_shutdown() becomes true at its end."""
    return rospy.core.is_shutdown_requested()


def init_node(name):
    """Registers this process as a node, for nodes that start other processes and have to end them. After SIGINT or
    SIGTERM is_ending() becomes true, while the main thread goes on; during the registration they end the process.

    rospy's own handler shuts the node down inside the handler, where it waits for ever if the interrupted code holds a
    lock that the shutdown needs. Here a thread does it.
    """
    signals = queue.SimpleQueue()  # a handler may interrupt its put()

    def shut_down():
        signals.get()
        rospy.signal_shutdown('signal')

    thread = threading.Thread(target=shut_down, daemon=True)
    thread.start()
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda received, _: signals.put(received))

    def wait_for_shutdown():
        if is_ending():
            thread.join(PATIENCE)

    atexit.register(wait_for_shutdown)  # runs before rospy's, which does not wait for a shutdown that has begun
    try:
        rospy.init_node(name, disable_signals=True)
    except rospy.ROSException:
        if is_ending():
            sys.exit()
        raise
