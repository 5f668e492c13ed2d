#!/usr/bin/python3
"""The status of the controller, its pace and its list of scenarios, and the agent that crowd_markers shows."""
import os
import pathlib

import support
from controlling import ControllerTestCase
from social_crowd.msg import ControllerStatus
from std_msgs.msg import Int32


class ControllerStatusTest(ControllerTestCase):
    """Topic controller_status."""

    def setUp(self):
        super().setUp()
        self.status = self.listen('controller_status', ControllerStatus)

    def newest(self, fits, what):
        """Waits until the newest status meets the condition. Returns it."""
        return support.wait_for(lambda: self.status.messages and fits(self.status.messages[-1]) and
                                self.status.messages[-1], what)

    def test_status_tells_what_the_controller_does(self):
        self.start_all(seed=5)
        first = self.newest(lambda status: True, 'a status')
        self.assertEqual((first.node, first.paused, first.real_time_factor, first.scenario, first.seed, first.tick),
                         (f'{self.namespace}/crowd_controller', True, 0.0, 'scene', 5, 0))
        self.assertEqual((first.agents, first.walking, first.arrived, first.decisions), (2, 2, 0, 0))
        self.step(3)
        third = self.newest(lambda status: status.tick == 3, 'the third tick')
        self.assertEqual(third.decisions, 6)  # of two agents
        self.assertAlmostEqual(third.time, 0.3)
        self.do('remove_agent', agent=1)
        self.newest(lambda status: (status.agents, status.walking) == (1, 1), 'one agent')
        self.do('pause', data=False)
        self.newest(lambda status: not status.paused, 'a walking crowd')

    def test_new_subscribers_get_the_status(self):
        self.start_all()
        self.newest(lambda status: True, 'a status')
        self.status.subscriber.unregister()  # two subscribers of a process would share one connection
        late = self.listen('controller_status', ControllerStatus)
        self.assertTrue(late.wait().paused)

    def test_status_names_agents_without_answers(self):
        self.start_all(answer_deadline=0.2)
        self.step()
        self.assertEqual(self.newest(lambda status: status.tick == 1, 'a tick').unanswered, ())
        next(process for process in self.processes if process.name == 'learner').kill()
        self.do('pause', data=False)
        missed = self.newest(lambda status: status.unanswered == (0, 1), 'agents without answers')
        self.assertGreaterEqual(missed.missed_answers, 2)

    def test_pace_is_changed_while_walking(self):
        self.start_all(real_time_factor=0.001)  # a tick lasts 100 s
        self.do('pause', data=False)
        response = self.do('set_real_time_factor', factor=0.0)
        self.assert_says(response.message, 'fast')
        self.newest(lambda status: status.real_time_factor == 0.0 and status.tick > 5, 'a fast crowd')
        self.refuse('set_real_time_factor', 'from 0', 'got -1', factor=-1.0)
        self.refuse('set_real_time_factor', 'got nan', factor=float('nan'))

    def test_pace_is_slowed_down(self):
        self.start_all()
        self.assert_says(self.do('set_real_time_factor', factor=2.5).message, '2.5')
        self.newest(lambda status: status.real_time_factor == 2.5, 'the factor')

    def test_scenarios_are_listed(self):
        self.start_all()
        listed = self.do('list_scenarios')
        files = pathlib.Path(support.in_package('config', 'scenarios')).rglob('*.yaml')
        self.assertEqual(listed.names, sorted(file.stem for file in files))
        self.assertIn('circle6', listed.names)
        for name in ('circle6', 'line6', 'robot_hall'):
            self.do('load_scenario', scenario=name)

    def test_scenarios_of_another_folder_are_listed(self):
        os.mkdir(self.path('own'))
        self.write('own/mine.yaml', '')
        self.start_all(scenario_folder=self.path('own'))
        self.assertEqual(self.do('list_scenarios').names, ['mine'])


class ChosenAgentTest(ControllerTestCase):
    """The agent that crowd_markers shows."""

    def test_agent_is_chosen(self):
        chosen = self.listen('chosen_agent', Int32)
        self.start_node('crowd_markers', 'crowd_markers', {'agent': 3})
        chosen.wait(lambda message: message.data == 3, 'of the parameter')
        self.succeed('crowd_markers/choose_agent', agent=1)
        chosen.wait(lambda message: message.data == 1, 'of the request')
        self.succeed('crowd_markers/choose_agent', agent=-1)
        super(ControllerTestCase, self).refuse('crowd_markers/choose_agent', 'expected', 'got -2', agent=-2)


if __name__ == '__main__':
    support.run('controller_status_test')
