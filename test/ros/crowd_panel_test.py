#!/usr/bin/python3
"""The panel in a real RViz on a separate screen, used with mouse and keyboard."""
import os
import shutil
import signal

import support
import yaml
from controlling import QUIET, ControllerTestCase
from screens import DrivenRviz, Screen
from social_crowd.msg import ControllerStatus, LearnerStatus


class PanelTestCase(ControllerTestCase):
    """RViz with the panel on a screen, beside a paused crowd."""

    def setUp(self):
        super().setUp()
        self.screen = Screen()
        self.addCleanup(self.screen.close)
        self.status = self.listen('controller_status', ControllerStatus)
        self.learners = self.listen('learner_status', LearnerStatus)

    def open_rviz(self, name='rviz', **arguments):
        """Opens RViz and waits until the panel shows the paused crowd."""
        rviz = DrivenRviz(self.screen, self.namespace, name, log=self.path(f'{name}.log'), **arguments)
        self.addCleanup(rviz.clean_up)
        rviz.wait_enabled('step')
        return rviz

    def open_both(self, text=QUIET, **parameters):
        """Starts a paused crowd, and opens RViz."""
        self.start_all(text, **parameters)
        return self.open_rviz()

    def wait_status(self, fits, what):
        """Waits until the newest status of the controller meets the condition."""
        return support.wait_for(lambda: self.status.messages and fits(self.status.messages[-1]), what)

    def wait_learner(self, fits, what):
        """Waits until the newest status of the learner meets the condition."""
        return support.wait_for(lambda: self.learners.messages and fits(self.learners.messages[-1]), what)


class CrowdPanelTest(PanelTestCase):
    """What a click does."""

    def test_step_play_and_pause(self):
        rviz = self.open_both()
        self.assertFalse(rviz.is_enabled('pause'))
        rviz.click('step')
        self.wait_status(lambda status: status.tick == 1, 'a step')
        rviz.wait_text('tick', lambda text: text.startswith('1 '), 'tick 1')
        rviz.click('play')
        self.wait_status(lambda status: not status.paused and status.tick > 3, 'a walking crowd')
        rviz.click('pause')
        rviz.wait_enabled('step')
        tick = self.step().tick
        rviz.wait_text('tick', lambda text: text.replace(' ', '').startswith(str(tick)), f'tick {tick}')
        self.assertEqual(rviz.close(), 0)

    def test_steps_speed_reset_and_scenario(self):
        rviz = self.open_both()
        rviz.enter('ticks', '7')
        rviz.click('step')
        self.wait_status(lambda status: status.tick == 7, 'seven ticks')
        rviz.enter('speed', '2.5')
        self.wait_status(lambda status: status.real_time_factor == 2.5, 'the speed')
        for factor, text in ((0.004, '0.004 x real time'), (5000, '5000 x real time'), (0, 'fast')):
            self.do('set_real_time_factor', factor=factor)
            rviz.wait_text('speed', lambda shown, text=text: shown == text, text)
        rviz.click('reset')
        self.wait_status(lambda status: status.tick == 0 and status.episode == 1, 'a reset')
        rviz.choose('scenario', 'circle6')
        self.wait_status(lambda status: status.scenario == 'circle6' and status.agents == 6, 'another scenario')
        rviz.wait_text('success', lambda text: text == '0 of 6 (0 %)', 'six agents')

    def test_floor_is_saved_as_a_scenario_and_opened(self):
        rviz = self.open_both()
        rviz.click('step')
        self.wait_status(lambda status: status.tick == 1, 'a step')
        file = self.path('floor.yaml')
        rviz.click('save_scenario')
        rviz.choose_file(file)
        rviz.wait_text('message', lambda text: text.endswith(f'to {file}'), 'the file')
        rviz.click('open_scenario')
        rviz.choose_file(file)
        self.wait_status(lambda status: status.scenario == 'floor' and status.tick == 0, 'the saved scenario')

    def test_dialogs_open_in_the_data_folder(self):
        rviz = self.open_both(data_folder=self.path('data'))
        support.wait_for(lambda: os.path.isdir(self.path('data')), 'the folder that the controller tells')
        rviz.choose('scenario', 'circle6')
        rviz.wait_text('success', lambda text: text == '0 of 6 (0 %)', 'another scenario')
        rviz.click('save_scenario')
        rviz.choose_file('floor')
        rviz.wait_text('message', lambda text: text.endswith(f'to {self.path("data/floor.yaml")}'), 'the file')
        rviz.click('open_scenario')
        rviz.choose_file(self.file)
        rviz.wait_text('message', lambda text: 'is not in the folder' in text and '~allow_any_path' in text,
                       'the error')

    def test_mode_parameters_and_tables(self):
        rviz = self.open_both()
        rviz.choose('mode', 'training')
        self.wait_learner(lambda status: status.mode == 'training', 'training mode')
        for name, value in (('epsilon', 0.25), ('alpha', 0.125), ('gamma', 0.75)):
            rviz.enter(name, str(value))
            self.wait_learner(lambda status, n=name, v=value: getattr(status, n) == v, name)
        file = self.path('table.txt')
        rviz.click('save_table')
        rviz.choose_file(file)
        support.wait_for(lambda: os.path.exists(file), 'the saved table')
        rviz.click('load_table')
        rviz.choose_file(file)
        rviz.wait_text('message', lambda text: text.startswith('loaded ') and file in text, 'the loaded table')
        self.assertFalse(rviz.is_enabled('share_table'))  # there is one table

    def test_table_of_an_agent_is_shared(self):
        self.start_all()
        self.start_learner('learner_1', agents=[1], q_table=support.NEAREST_TABLE)
        rviz = self.open_rviz()
        rviz.wait_text('learner', lambda text: text == 'all learners', 'several learners')
        rviz.click('share_table')
        rviz.wait_text('message', lambda text: 'agent 1' in text, 'who has taken the table')

    def test_refusal_is_shown(self):
        rviz = self.open_both()
        broken = self.write('broken.yaml', 'name: broken\nduration: -1\n')
        rviz.click('open_scenario')
        rviz.choose_file(broken)
        rviz.wait_text('message', lambda text: 'broken.yaml' in text and 'duration' in text, 'the error')
        self.assertEqual(self.status.messages[-1].scenario, 'scene')

    def test_agent_is_chosen(self):
        self.start_all()
        self.start_node('crowd_markers', 'crowd_markers', {})
        rviz = self.open_rviz()
        rviz.wait_text('agent', lambda text: text == '0', 'the agent of the parameter')
        rviz.enter('agent', '1')
        rviz.wait_text('message', lambda text: text == 'agent 1 is shown', 'the answer')
        rviz.wait_text('agent', lambda text: text == '1', 'the chosen agent')


class PanelTroubleTest(PanelTestCase):
    """Nodes that go away, several panels, large crowds."""

    def test_controller_goes_away_and_comes_back(self):
        rviz = self.open_both()
        self.controller.kill()
        for button in ('play', 'pause', 'step', 'reset', 'speed', 'scenario'):
            rviz.wait_enabled(button, False)
        rviz.wait_text('state', lambda text: text.endswith('crowd_controller is away'), 'who is away')
        self.controller = self.start_controller(self.file, paused=True)
        rviz.click('step')
        rviz.wait_text('tick', lambda text: text.startswith('1 '), 'tick 1')

    def test_learner_goes_away_and_comes_back(self):
        self.start_all(answer_deadline=0.5, start_deadline=1.0)
        learner = next(process for process in self.processes if process.name == 'learner')
        rviz = self.open_rviz()
        rviz.wait_enabled('epsilon')
        learner.kill()
        rviz.wait_enabled('epsilon', False)
        rviz.wait_text('table', lambda text: text.endswith('learner is away'), 'who is away')
        rviz.click('play')
        rviz.wait_text('missing', lambda text: text.startswith('0, 1'), 'agents without answers')
        self.start_learner()
        rviz.wait_enabled('epsilon')
        rviz.wait_text('missing', lambda text: text.startswith('none'), 'no missing agents')

    def test_rviz_is_closed_during_a_call(self):
        rviz = self.open_both(real_time_factor=1.0)
        rviz.enter('ticks', '100000')
        rviz.click('step')
        rviz.wait_text('state', lambda text: text == 'stepping', 'steps in progress')
        self.assertEqual(rviz.close(), 0)
        self.assertTrue(self.controller.is_running())
        self.do('pause', data=False)

    def test_rviz_goes_on_while_the_controller_hangs(self):
        rviz = self.open_both()
        self.addCleanup(self.controller.signal, signal.SIGCONT)
        self.controller.signal(signal.SIGSTOP)
        rviz.click('play')
        rviz.enter('epsilon', '0.25')
        self.wait_learner(lambda status: status.epsilon == 0.25, 'a change of the learner')
        self.controller.signal(signal.SIGCONT)
        self.wait_status(lambda status: not status.paused, 'a walking crowd')

    def test_rviz_is_closed_while_the_controller_hangs(self):
        rviz = self.open_both()
        self.addCleanup(self.controller.signal, signal.SIGCONT)
        self.controller.signal(signal.SIGSTOP)
        rviz.click('reset')
        self.assertEqual(rviz.close(), 0)

    def test_two_panels(self):
        self.start_all()
        first = self.open_rviz('first')
        second = self.open_rviz('second')
        # Both windows lie at the same place: the second one is above the first one.
        second.click('step')
        for rviz in (first, second):
            rviz.wait_text('tick', lambda text: text.startswith('1 '), 'tick 1')
        second.enter('speed', '3')
        first.wait_text('speed', lambda text: text == '3 x real time', 'the speed of the other panel')
        self.assertEqual(second.close(), 0)
        first.click('play')
        self.wait_status(lambda status: not status.paused, 'a walking crowd')

    def test_thousand_agents(self):
        rviz = self.open_both(support.read_text(support.in_package('config', 'scenarios', 'crowd_random_1000.yaml')))
        rviz.wait_text('success', lambda text: text == '0 of 1000 (0 %)', 'a thousand agents')
        rviz.enter('ticks', '3')
        rviz.click('step')
        rviz.wait_text('tick', lambda text: text.startswith('3 '), 'tick 3')
        rviz.click('play')
        rviz.wait_text('decisions', lambda text: text not in ('0', '-'), 'decisions')
        rviz.click('pause')
        rviz.wait_text('decisions', lambda text: text == '0', 'no decisions')


class PanelSettingsTest(PanelTestCase):
    """Settings in the configuration of RViz."""

    def panel_of(self, file):
        """Returns the settings of the panel in a configuration; none while RViz writes the file."""
        try:
            panels = yaml.safe_load(support.read_text(file))['Panels']
            return next(panel for panel in panels if panel['Class'] == 'social_crowd/CrowdPanel')
        except (yaml.YAMLError, LookupError, TypeError, StopIteration):  # half of a file
            return {}

    def test_settings_are_kept(self):
        self.start_all()
        file = shutil.copy(support.in_package('rviz', 'social_crowd.rviz'), self.path('kept.rviz'))
        rviz = self.open_rviz(configuration=file)
        rviz.enter('ticks', '12')
        rviz.click('save_scenario')
        rviz.choose_file(self.path('floor.yaml'))
        rviz.wait_text('message', lambda text: 'floor.yaml' in text, 'the file')
        rviz.click('rviz::RenderPanel')  # the keyboard is that of the window again
        self.screen.use('key', 'ctrl+s')
        expected = {'Ticks': 12, 'Folder': self.folder}
        support.wait_for(lambda: expected.items() <= self.panel_of(file).items(), 'the saved configuration')
        self.assertEqual(rviz.close(), 0)
        rviz = self.open_rviz(configuration=file)
        self.assertEqual(rviz.text('ticks'), '12 ticks')

    def test_namespace_is_chosen(self):
        self.start_all()
        rviz = DrivenRviz(self.screen, '/elsewhere', log=self.path('rviz.log'))
        self.addCleanup(rviz.clean_up)
        rviz.wait_text('state', lambda text: text == '/elsewhere/crowd_controller is away', 'who is away')
        rviz.enter('name_space', self.namespace)
        rviz.wait_enabled('step')
        rviz.enter('name_space', 'not a name')
        rviz.wait_enabled('step', False)


if __name__ == '__main__':
    support.run('crowd_panel_test')
