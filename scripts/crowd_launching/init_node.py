"""Makes this process a ROS node that SIGINT and SIGTERM shut down."""
import atexit
import signal
import sys
import threading

import rospy

PATIENCE = 10.0  # [s] for a shutdown that has begun


def init_node(name):
    """Registers this process as a node. After SIGINT or SIGTERM rospy.is_shutdown() becomes true; during the
    registration they end the process.

    rospy's own handler shuts the node down inside the handler, where it waits for ever if the interrupted code holds a
    lock that the shutdown needs. Here a thread does it.
    """
    interrupted = threading.Event()

    def shut_down():
        interrupted.wait()
        rospy.signal_shutdown('signal')

    thread = threading.Thread(target=shut_down, daemon=True)
    thread.start()
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda *_: interrupted.set())
    # Before rospy's, which does not wait for a shutdown that has begun.
    atexit.register(lambda: interrupted.is_set() and thread.join(PATIENCE))
    try:
        rospy.init_node(name, disable_signals=True)
    except rospy.ROSInitException:
        if rospy.is_shutdown():
            sys.exit()
        raise
