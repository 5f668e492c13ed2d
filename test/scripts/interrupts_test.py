"""Ctrl-C and SIGTERM end evaluate soon, whatever it is doing, and leave complete files of the finished episodes."""
import os
import signal

import pytest
from programs import NEAREST_TABLE, assert_says, read_text, wait_for
from roslib.packages import find_node

SOON = 20.0  # [s] on a machine that is busy with other tests; without an end to it, it is some minutes

# The first document is walked at once. In the others, something takes minutes.
SHORT = """
name: short
duration: 1
goal_tolerance: 0.3
agents:
  - {position: [0, 0], goal: [9, 0], speed: 1, radius: 0.2}
"""
# All of them enter in the first tick.
ENTERING = SHORT + """---
name: entering
duration: 100
goal_tolerance: 0.3
sources:
  - {area: {box: [[0, 0], [2000, 2000]]}, goal: [2100, 0], speed: 1, radius: 0.2, times: [""" + '0, ' * 200_000 + """0]}
"""
# A crowd at rest that walks for a long time.
LONG = SHORT + """---
name: long
duration: 1e8
goal_tolerance: 0.3
agents:
  - {position: {box: [[0, 0], [9, 9]]}, goal: [2000, 0], speed: 1e-6, radius: 0.2, count: 20}
"""


def lines_of(file):
    """Returns the number of lines of a file, 0 without one."""
    return read_text(file).count('\n') if os.path.exists(file) else 0


class EvaluateTest:
    """A run is interrupted in its second episode."""

    @pytest.mark.parametrize('number', [signal.SIGINT, signal.SIGTERM])
    @pytest.mark.parametrize('scenario', [ENTERING, LONG], ids=['entering', 'long'])
    def test_ends_soon(self, runner, scenario, number):
        record, csv, recordings = (runner.path(name) for name in ('record.csv', 'metrics.csv', 'recordings'))
        process = runner.start('evaluate', [
            find_node('social_crowd', 'evaluate')[0], '--q-table', NEAREST_TABLE, '--threads', '1', '--record', record,
            '--csv', csv, '--trajectories', recordings, runner.write('s.yaml', scenario)])
        wait_for(lambda: lines_of(record) == 2, 'the first episode')
        process.signal(number)
        assert process.wait(SOON) == 130, process.output()
        assert_says(process.output(), 's: interrupted after 1 of 2 episodes; the results are those of these, without '
                                      'unfinished ones')
        assert lines_of(record) == 2
        assert read_text(csv).splitlines()[1].startswith('s,1,')
        rows = read_text(os.path.join(recordings, 's.csv')).splitlines()
        assert len(rows) == 12 and {row.split(',')[0] for row in rows[1:]} == {'0'}
