"""Ends the roslaunch that started this process; see launch_end.h, which does the same for nodes in C++."""
import os
import signal

STOPS = {signal.SIGINT, signal.SIGTERM}
PATIENCE = 20.0  # [s] for roslaunch to stop this process


def command_of(process):
    """Program and arguments of a process; nothing if they cannot be read."""
    try:
        with open('/proc/%d/cmdline' % process, 'rb') as stream:
            return [os.fsdecode(word) for word in stream.read().split(b'\0')]
    except OSError:
        return []


def is_roslaunch(command):
    """Whether it is roslaunch, itself or as the script of an interpreter; not one that serves another machine's."""
    return 'roslaunch' in map(os.path.basename, command[:2]) and '-c' not in command[2:]


def end_launch():
    """Asks the roslaunch that started this process to end, and waits until it stops the process.

    Does nothing where something else started it.
    """
    parent = os.getppid()
    if not is_roslaunch(command_of(parent)):
        return
    signal.pthread_sigmask(signal.SIG_BLOCK, STOPS)
    os.kill(parent, signal.SIGINT)
    signal.sigtimedwait(STOPS, PATIENCE)
