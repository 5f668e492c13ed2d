"""What a program that roslaunch starts does before all else. Imports nothing that takes long."""
import signal
import sys


def start(usage):
    """Makes Ctrl-C end this program without a traceback, and answers --help with the usage.

    To be called before the imports that take long. rospy and Program set handlers of their own later.
    """
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    if {'-h', '--help'} & set(sys.argv[1:]):
        print(usage.strip())
        sys.exit()
