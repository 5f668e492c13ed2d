"""A progress bar with the remaining time, on standard error."""
import sys
import time

WIDTH = 30
PLAIN_PERIOD = 10.0  # [s] between two lines without a terminal


class ProgressBar:
    """Shows the progress of runs of different lengths, or of other things: `name` is their plural."""

    def __init__(self, total, runs, name='runs'):
        self.total = total
        self.runs = runs
        self.name = name
        self.done = 0.0
        self.runs_done = 0
        self.start = time.monotonic()
        self.is_terminal = sys.stderr.isatty()
        self.next = self.start if self.is_terminal else self.start + PLAIN_PERIOD

    def add(self, cost):
        """Counts a finished run."""
        self.done += cost
        self.runs_done += 1
        self.show()

    def show(self):
        """Draws the bar; without a terminal only periodically."""
        now = time.monotonic()
        if now < self.next:
            return
        self.next = now if self.is_terminal else now + PLAIN_PERIOD
        share = self.done / self.total if self.total else 1.0
        bar = '#' * round(share * WIDTH)
        left = text_of((now - self.start) * (1 - share) / share) if share else '?'
        line = (f'[{bar:.<{WIDTH}}] {self.runs_done}/{self.runs} {self.name}  took {text_of(now - self.start)}  '
                f'left {left}')
        sys.stderr.write(f'\r{line}\x1b[K' if self.is_terminal else f'{line}\n')
        sys.stderr.flush()

    def end(self):
        """Ends the line of the bar."""
        if self.is_terminal:
            sys.stderr.write('\n')


def text_of(seconds):
    """65 -> 1:05"""
    return f'{int(seconds) // 60}:{int(seconds) % 60:02d}'
