#!/usr/bin/python3
"""The view in a real RViz, which follows a change of the scenario."""
import support
import yaml
from controlling import QUIET, ControllerTestCase
from screens import DrivenRviz, Screen

# The floor is 40 m x 30 m; its middle is (120.25, 65), and the frame `crowd` at (120, 65).
OTHER = """
name: other
duration: 60
goal_tolerance: 0.3
agents:
  - {position: [100.25, 50], goal: [140.25, 50], speed: 0.5, radius: 0.25}
walls:
  - [[110, 60], [110, 80]]
"""
WIDE, HIGH, MARGIN = 40.0, 30.0, 1.0  # [m]
SCALE = 66.0  # [pixels/m], that of rviz/social_crowd.rviz


class ViewTest(ControllerTestCase):
    """RViz beside a paused crowd."""

    def setUp(self):
        super().setUp()
        self.screen = Screen()
        self.addCleanup(self.screen.close)
        self.start_all(QUIET)
        self.start_node('crowd_markers', 'crowd_markers', {})

    def open_rviz(self, change=lambda settings: None):
        """Opens RViz with changed settings."""
        settings = yaml.safe_load(support.read_text(support.in_package('rviz', 'social_crowd.rviz')))
        change(settings)
        configuration = self.write('changed.rviz', yaml.safe_dump(settings, sort_keys=False))
        self.rviz = DrivenRviz(self.screen, self.namespace, configuration=configuration, log=self.path('rviz.log'))
        self.addCleanup(self.rviz.clean_up)
        self.rviz.wait_enabled('step')
        self.rviz.wait_text('scenario', lambda text: text == 'scene', 'the first scenario')

    def load_other(self):
        """Loads the other scenario, and waits until the panel shows it."""
        self.do('load_scenario', scenario=self.write('other.yaml', OTHER))
        self.rviz.wait_text('success', lambda text: text == '0 of 1 (0 %)', 'one agent')

    def number(self, name):
        """Returns a property of the view."""
        return float(self.rviz.ask('view', name))

    def expected_scale(self):
        """Returns the scale with which the other floor and a margin fill the window."""
        width, height = map(int, self.rviz.ask('size', 'rviz::RenderPanel').split())
        return min(width / (WIDE + 2 * MARGIN), height / (HIGH + 2 * MARGIN))

    def test_view_fits_the_floor_of_another_scenario(self):
        self.open_rviz()
        self.assertEqual(self.number('Scale'), SCALE)  # the first scenario leaves the view as it is
        self.load_other()
        try:
            support.wait_for(lambda: abs(self.number('Scale') - self.expected_scale()) < 0.01, 'the scale of the floor')
        except AssertionError as error:
            size = self.rviz.ask('size', 'rviz::RenderPanel')
            raise AssertionError(f'{error}; it is {self.number("Scale")} for {size} pixels') from None
        self.assertLess(self.number('Scale'), SCALE)
        self.assertAlmostEqual(self.number('X'), 0.25, places=5)
        self.assertAlmostEqual(self.number('Y'), 0.0, places=5)
        self.do('reset', keep_seed=True)
        self.walk()
        self.assertAlmostEqual(self.number('Scale'), self.expected_scale(), delta=0.01)

    def test_view_from_above_in_perspective_looks_at_the_floor(self):
        def orbit(settings):
            settings['Visualization Manager']['Views']['Current'] = {
                'Class': 'rviz/XYOrbit', 'Distance': 5.0, 'Target Frame': 'map', 'Pitch': 0.8, 'Yaw': 1.0,
                'Focal Point': {'X': 0, 'Y': 0, 'Z': 0}}
        self.open_rviz(orbit)
        self.load_other()
        support.wait_for(lambda: self.number('Distance') > 30.0, 'a view of the whole floor')  # 16 m / tan 22.5 degrees
        self.assertEqual(self.rviz.ask('view', 'Focal Point'), '120.25; 65; 0')
        self.assertAlmostEqual(self.number('Pitch'), 0.8, places=5)

    def test_view_stays_with_the_setting_off(self):
        def keep(settings):
            for panel in settings['Panels']:
                panel['Fit view'] = False
        self.open_rviz(keep)
        self.load_other()
        self.do('step', ticks=1)
        self.rviz.wait_text('tick', lambda text: text.startswith('1 '), 'tick 1')
        self.assertEqual(self.number('Scale'), SCALE)


if __name__ == '__main__':
    support.run('rviz_view_test')
