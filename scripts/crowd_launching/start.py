"""Starts a program that roslaunch starts."""
import importlib
import signal
import sys


def start(usage, module):
    """Ends this process with the exit status of main() of a module. Ctrl-C ends it without a traceback, also during
    slow imports; rospy and Program install their own signal handlers later. Prints the usage for --help."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    if {'-h', '--help'} & set(sys.argv[1:]):
        print(usage.strip())
        sys.exit()
    sys.exit(importlib.import_module(module).main())
