"""Runs another program and forwards signals to it; ends the launch that started this process, as launch_end.h does for
C++ nodes; ports for ROS masters."""
import os
import random
import signal
import socket
import subprocess

STOPS = {signal.SIGINT, signal.SIGTERM}
PATIENCE = 20.0  # [s] time for roslaunch to stop this process
LOWEST_PORT = 12000  # that free_port() returns: above the default port of ROS


class Program:
    """A running program, to which SIGINT and SIGTERM are forwarded."""

    def __init__(self, command):
        self.is_stopped = False  # a signal was received
        self.process = None
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, self.stop)
        self.process = subprocess.Popen(command)
        if self.is_stopped:  # before the process existed
            self.process.terminate()

    def stop(self, number, _):
        self.is_stopped = True
        if self.process:
            self.process.send_signal(number)

    def wait(self):
        """Waits for the end of the program. Returns the exit status as a shell does."""
        status = self.process.wait()
        return status if status >= 0 else 128 - status


def free_port():
    """Returns a TCP port of this machine that is free at present, below those that the system gives to programs which
    ask for any: until the caller's server has started, no other program gets it by chance."""
    with open('/proc/sys/net/ipv4/ip_local_port_range', encoding='ascii') as stream:
        lowest_given = int(stream.read().split()[0])
    while True:
        port = random.randrange(LOWEST_PORT, max(lowest_given, LOWEST_PORT + 1000))
        with socket.socket() as probe:
            try:
                probe.bind(('127.0.0.1', port))
            except OSError:
                continue
        return port


def end_launch():
    """Interrupts the roslaunch that started this process, if one did, and waits until it stops this process."""
    parent = os.getppid()
    try:
        with open('/proc/%d/cmdline' % parent, 'rb') as stream:
            command = [os.fsdecode(word) for word in stream.read().split(b'\0')]
    except OSError:
        return
    if 'roslaunch' not in map(os.path.basename, command[:2]) or '-c' in command[2:]:  # child of one on another machine
        return
    signal.pthread_sigmask(signal.SIG_BLOCK, STOPS)
    os.kill(parent, signal.SIGINT)
    signal.sigtimedwait(STOPS, PATIENCE)


def end_all(processes, seconds):
    """Interrupts processes one after the other, the latest first, and kills those that do not end in this time [s]."""
    for process in reversed(processes):
        process.send_signal(signal.SIGINT)
        try:
            process.wait(seconds)
        except subprocess.TimeoutExpired:
            process.kill()
