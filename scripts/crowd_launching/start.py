"""First steps of a program that roslaunch starts. Does not import modules that load slowly."""
import signal
import sys


def start(usage):
    """Makes Ctrl-C end this program without a traceback, and prints the usage for --help.

    Must be called before slow imports. rospy and Program install their own signal handlers later.
    """
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    if {'-h', '--help'} & set(sys.argv[1:]):
        print(usage.strip())
        sys.exit()
