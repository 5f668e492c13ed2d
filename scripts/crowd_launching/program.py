"""Runs another program and forwards signals to it."""
import signal
import subprocess


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
        """Forwards a signal."""
        self.is_stopped = True
        if self.process:
            self.process.send_signal(number)

    def wait(self):
        """Waits for the end of the program. Returns the exit status as a shell does."""
        status = self.process.wait()
        return status if status >= 0 else 128 - status
