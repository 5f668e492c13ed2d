#!/usr/bin/python3
"""The panel in a real RViz on a separate screen, with clicks of a mouse."""
import os

import support
from controlling import ControllerTestCase
from screens import DrivenRviz, Screen
from social_crowd.msg import ControllerStatus


class PanelTestCase(ControllerTestCase):
    """RViz with the panel on a screen, beside a paused crowd."""

    def setUp(self):
        super().setUp()
        self.screen = Screen()
        self.addCleanup(self.screen.close)
        self.status = self.listen('controller_status', ControllerStatus)

    def open_rviz(self, name='rviz', **arguments):
        """Opens RViz."""
        rviz = DrivenRviz(self.screen, self.namespace, name, log=self.path(f'{name}.log'), **arguments)
        self.addCleanup(rviz.clean_up)
        return rviz

    def keep_picture(self):
        """Writes a picture of the screen to the file that the environment names, for people."""
        if os.environ.get('SOCIAL_CROWD_SCREENSHOT'):
            self.screen.picture(os.environ['SOCIAL_CROWD_SCREENSHOT'])


class CrowdPanelTest(PanelTestCase):
    """What a click does."""

    def test_step_play_and_pause(self):
        self.start_all()
        rviz = self.open_rviz()
        rviz.wait_text('state', lambda text: text == 'paused', 'paused')
        self.keep_picture()
        self.assertFalse(rviz.is_enabled('pause'))
        rviz.click('step')
        self.status.wait(lambda status: status.tick == 1, 'after a step')
        rviz.wait_text('tick', lambda text: text.startswith('1 '), 'tick 1')
        rviz.click('play')
        self.status.wait(lambda status: not status.paused and status.tick > 3, 'while walking')
        rviz.click('pause')
        rviz.wait_enabled('step')
        tick = self.step().tick
        rviz.wait_text('tick', lambda text: text.replace(' ', '').startswith(str(tick)), f'tick {tick}')
        self.assertEqual(rviz.close(), 0)


if __name__ == '__main__':
    support.run('crowd_panel_test')
