#!/usr/bin/python3
"""Ctrl-C ends a crowd controller that is in the middle of a tick that would take minutes."""
import os
import signal

import support
from controlling import ControllerTestCase

SOON = 20.0  # [s] on a machine that is busy with other tests
# All people enter in the second tick.
ENTERING = """
name: entering
duration: 100
goal_tolerance: 0.3
sources:
  - {area: {box: [[0, 0], [2000, 2000]]}, goal: [2100, 0], speed: 1, radius: 0.2, times: [""" + (
      '0.05, ' * 200_000) + """0.05]}
"""


def computing_time(pid):
    """Returns the processor time that a process has used [s]."""
    words = support.read_text(f'/proc/{pid}/stat').rpartition(')')[2].split()
    return (int(words[11]) + int(words[12])) / os.sysconf('SC_CLK_TCK')


class LongTicksTest(ControllerTestCase):
    """A controller with people who all enter at once."""

    def test_interrupted(self):
        self.start_all(ENTERING)
        pid = self.controller.process.pid
        before = computing_time(pid)
        self.call_later('crowd_controller/step', ticks=1)
        support.wait_for(lambda: computing_time(pid) > before + 1.0, 'the controller to compute')
        self.controller.signal(signal.SIGINT)
        self.assertEqual(self.controller.wait(SOON), 0, self.controller.output())
        self.assertNotIn('FATAL', self.controller.output())


if __name__ == '__main__':
    support.run('long_ticks_test')
