"""RViz on a separate screen, which tests use as a person would: with mouse and keyboard."""
import os
import queue
import subprocess
import sys
import threading
import time

from roslib.packages import find_node
from support import PATIENCE, in_package, wait_for
from renderer import RESTARTED, crashed_at_start
from screen import Screen, end  # noqa: F401

FRAMES = 3  # after which RViz counts as started
PRESS_PATIENCE = 5.0  # [s] until a click counts as missed


class RvizEnded(AssertionError):
    """RViz ended where it should have answered."""


class DrivenRviz:
    """RViz with the panel, by the program rviz_driver, which tells where widgets are."""

    def __init__(self, screen, namespace, name='rviz', configuration=in_package('rviz', 'social_crowd.rviz'), log=None):
        self.screen = screen
        self.lock = threading.Lock()
        self.log = open(log or os.devnull, 'ab')
        self.command = find_node('social_crowd', 'rviz_driver')[:1] + ['-d', configuration, '__name:=' + name]
        self.environment = dict(screen.environment, ROS_NAMESPACE=namespace)
        since = time.monotonic()
        if not self.draws():
            if not crashed_at_start(self.process, since):
                raise AssertionError(f'RViz has ended at its start with status {self.process.returncode}')
            print(RESTARTED, file=sys.stderr, flush=True)
            assert self.draws(), 'RViz has ended at its start again'

    def draws(self):
        """Starts RViz, and waits for its first frames. Returns false if it ends before."""
        self.process = subprocess.Popen(self.command, env=self.environment, stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, stderr=self.log)
        self.answers = queue.Queue()
        threading.Thread(target=self.listen, args=(self.process, self.answers), daemon=True).start()
        try:
            wait_for(lambda: int(self.ask('frames', '')) >= FRAMES, 'the first frames of RViz')
        except RvizEnded:
            self.process.wait(PATIENCE)
            return False
        except BaseException:
            self.clean_up()
            raise
        return True

    @staticmethod
    def listen(process, answers):
        """Keeps the answers, and None when RViz has ended. Runs in a thread, so that ask() does not wait for ever."""
        for line in process.stdout:
            if line.startswith(b'answer: '):
                answers.put(line.decode()[len('answer: '):].rstrip('\n'))
        answers.put(None)

    def ask(self, verb, widget):
        """Asks for the place, text or state of a widget. Returns the answer, None if there is no such widget."""
        with self.lock:
            try:
                self.process.stdin.write(f'{verb} {widget}\n'.encode())
                self.process.stdin.flush()
            except BrokenPipeError as error:
                raise RvizEnded('RViz has ended') from error
            try:
                answer = self.answers.get(timeout=PATIENCE)
            except queue.Empty as error:
                raise AssertionError(f'RViz does not answer {verb} {widget}') from error
        if answer is None:
            raise RvizEnded('RViz has ended')
        return None if answer == 'no such widget' else answer

    def text(self, widget):
        """Returns the text that a widget shows."""
        return self.ask('text', widget)

    def is_enabled(self, widget):
        """Returns whether a widget is enabled."""
        return self.ask('enabled', widget) == 'yes'

    def place(self, widget):
        """Waits for a widget that has come to rest. Returns the middle of it on the screen [pixels]."""
        places = [None]

        def is_at_rest():
            places.append(self.ask('place', widget))
            time.sleep(0.05)
            return places[-1] is not None and places[-1] == places[-2]

        wait_for(is_at_rest, f'the widget {widget}')
        return [int(word) for word in places[-1].split()]

    def wait_enabled(self, widget, enabled=True):
        """Waits until a widget is enabled, or is not."""
        wait_for(lambda: self.ask('enabled', widget) == ('yes' if enabled else 'no'),
                 f'{widget} to be {"en" if enabled else "dis"}abled')

    def wait_text(self, widget, fits, what):
        """Waits until a widget shows a text that meets the condition. Returns the text."""
        try:
            return wait_for(lambda: (lambda text: text is not None and fits(text) and (text or ' '))(self.text(widget)),
                            f'{widget} to show {what}')
        except AssertionError as error:
            shown = ', '.join(f'{name} {self.text(name)!r}' for name in (widget, 'state', 'message'))
            raise AssertionError(f'{error}; shown: {shown}') from error

    def click(self, widget):
        """Clicks on a widget, when it is enabled. Clicks again if it missed, because the widget moved meanwhile."""

        def hits():
            self.wait_enabled(widget)
            self.screen.use('mousemove', *self.place(widget), 'click', 1)
            return self.is_pressed(widget)

        wait_for(hits, f'a click on {widget}')

    def is_pressed(self, widget):
        """Waits for a press of the mouse on a widget. Returns whether it came."""
        deadline = time.monotonic() + PRESS_PATIENCE
        while self.ask('pressed', widget) != 'yes':
            if time.monotonic() > deadline:
                return False
            time.sleep(0.02)
        return True

    def enter(self, widget, text):
        """Replaces the text of a field, when it is enabled."""
        self.click(widget)
        self.screen.use('key', 'ctrl+a')
        self.screen.use('type', '--delay', 1, text)
        self.screen.use('key', 'Return')

    def choose(self, widget, entry):
        """Chooses an entry of a choice by its text, when it is enabled."""
        self.click(widget)
        wait_for(lambda: self.ask('place', 'QComboBoxPrivateContainer'), f'the entries of {widget}')
        # Typing the entry's name would do, but Qt begins a new word after a pause of 0.4 s, as a busy machine makes.
        steps = self.ask('entries', widget).split('\t').index(entry)
        self.screen.use('key', 'Home', *['Down'] * steps, 'Return')
        self.wait_text(widget, lambda text: text == entry, entry)

    def choose_file(self, file):
        """Chooses a file in a dialog."""
        self.enter('fileNameEdit', file)

    def close(self):
        """Closes its windows. Returns its exit status."""
        if self.process.poll() is None:
            self.process.stdin.close()
        status = self.process.wait(60.0)
        self.log.close()
        return status

    def clean_up(self):
        """Ends it, if it is still running."""
        end(self.process)
