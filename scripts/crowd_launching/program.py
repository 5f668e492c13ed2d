"""Runs another program as if it were this one."""
import signal
import subprocess


class Program:
    """A program that gets the signals which would end this one."""

    def __init__(self, command):
        self.is_stopped = False  # told to end
        self.process = None
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, self.stop)
        self.process = subprocess.Popen(command)
        if self.is_stopped:  # before there was a process to tell
            self.process.terminate()

    def stop(self, number, _):
        """Hands a signal on."""
        self.is_stopped = True
        if self.process:
            self.process.send_signal(number)

    def wait(self):
        """Waits for its end; the exit status, as a shell tells it."""
        status = self.process.wait()
        return status if status >= 0 else 128 - status
