"""Programs in a pseudo-terminal, and the screen that a user would see."""
import fcntl
import os
import pty
import re
import select
import struct
import termios
import time

from programs import PATIENCE

ESCAPE = re.compile(r'\x1b\[(\d*)([A-Za-z])')


class Screen:
    """The text on a terminal of a fixed size. Knows the control sequences that the programs of this package write."""

    def __init__(self, columns, rows):
        self.columns = columns
        self.cells = [[' '] * columns for _ in range(rows)]
        self.x = self.y = 0

    def write(self, text):
        """Shows a text."""
        place = 0
        while place < len(text):
            escape = ESCAPE.match(text, place)
            if escape:
                self.control(escape[2], int(escape[1] or 1))
                place = escape.end()
            else:
                self.put(text[place])
                place += 1

    def control(self, kind, count):
        """Carries out a control sequence."""
        if kind == 'A':
            self.y = max(0, self.y - count)
        elif kind == 'H':
            self.x = self.y = 0
        elif kind in 'JK':
            self.cells[self.y][self.x:] = [' '] * (self.columns - self.x)
            if kind == 'J':
                self.cells[self.y + 1:] = [[' '] * self.columns for _ in self.cells[self.y + 1:]]
        else:
            raise AssertionError(f'unknown control sequence {kind}')

    def put(self, character):
        """Shows a character at the cursor, or moves the cursor."""
        if character == '\r':
            self.x = 0
        elif character == '\n' or self.x == self.columns:
            self.y += 1
            self.x = 0 if character != '\n' else self.x
            if self.y == len(self.cells):
                self.cells = self.cells[1:] + [[' '] * self.columns]
                self.y -= 1
        if character not in '\r\n':
            self.cells[self.y][self.x] = character
            self.x += 1

    def lines(self):
        """Returns the lines without blanks at their ends."""
        return [''.join(line).rstrip() for line in self.cells]


def run_in_terminal(command, columns, rows, typed=''):
    """Runs a program in a terminal of this size. Types a text when the program has written something. Returns its exit
    status and the screen at its end."""
    child, terminal = pty.fork()
    if child == 0:
        fcntl.ioctl(0, termios.TIOCSWINSZ, struct.pack('HHHH', rows, columns, 0, 0))
        os.execv(command[0], command)
    written, deadline = b'', time.monotonic() + PATIENCE
    while time.monotonic() < deadline:
        if not select.select([terminal], [], [], 1.0)[0]:
            continue
        try:
            part = os.read(terminal, 1 << 16)
        except OSError:  # the program has ended
            break
        if not part:
            break
        written += part
        if typed:
            os.write(terminal, typed.encode())
            typed = ''
    os.close(terminal)
    status = os.waitpid(child, 0)[1]
    screen = Screen(columns, rows)
    screen.write(written.decode())
    return os.WEXITSTATUS(status) if os.WIFEXITED(status) else -os.WTERMSIG(status), screen
