#!/usr/bin/python3
"""Parameters of crowd_controller and learner are changed by dynamic_reconfigure, with its standard client."""
import rospy
import support
import yaml
from controlling import ControllerTestCase
from dynamic_reconfigure.msg import BoolParameter, Config, DoubleParameter, IntParameter
from dynamic_reconfigure.srv import Reconfigure
from learning_files import config_text
from reconfiguring import Reconfigurer
from social_crowd.msg import AgentStates, ControllerStatus, LearnerStatus

CONTROLLER = {'real_time_factor': 0.0, 'paused': True, 'start_deadline': 120.0, 'answer_deadline': 60.0,
              'misses_until_absent': 3, 'command_deadline': 0.5, 'agents_rate': 0.0}  # as started by the tests
DYNPARAM = ['rosrun', 'dynamic_reconfigure', 'dynparam']


class ReconfigureTestCase(ControllerTestCase):
    """Nodes with clients of dynamic_reconfigure."""

    def reconfigurer(self, node):
        """Returns a client of a node."""
        client = Reconfigurer(f'{self.namespace}/{node}')
        self.addCleanup(client.close)
        return client


class ControllerTest(ReconfigureTestCase):
    """crowd_controller."""

    def start_all(self, *arguments, **parameters):
        self.status = self.listen('controller_status', ControllerStatus)
        super().start_all(*arguments, **parameters)
        self.client = self.reconfigurer('crowd_controller')

    def newest(self, fits, what):
        """Waits until the newest status meets the condition."""
        return support.wait_for(lambda: self.status.messages and fits(self.status.messages[-1]), what)

    def test_client_gets_present_values_and_ranges(self):
        self.start_all()
        self.client.wait(**CONTROLLER)
        about = self.client.descriptions()
        self.assertEqual(set(about), set(CONTROLLER))
        factor = about['real_time_factor']
        self.assertEqual((factor['type'], factor['min'], factor['max'], factor['default']), ('double', 0.0, 1e6, 1.0))
        misses = about['misses_until_absent']
        self.assertEqual((misses['type'], misses['min'], misses['default']), ('int', 1, 3))
        self.assertEqual((about['paused']['type'], about['paused']['default']), ('bool', False))

    def test_pace_and_pause_are_changed(self):
        self.start_all()
        self.assertEqual(self.client.set(real_time_factor=2.5), dict(CONTROLLER, real_time_factor=2.5))
        self.client.wait(real_time_factor=2.5)
        self.newest(lambda status: status.paused and status.real_time_factor == 2.5, 'the factor')
        self.client.set(paused=False)
        self.newest(lambda status: not status.paused and status.tick > 2, 'a walking crowd')
        self.client.set(paused=True)
        self.newest(lambda status: status.paused, 'a paused crowd')

    def test_pace_is_changed_in_the_middle_of_a_tick(self):
        self.start_all(real_time_factor=0.001, paused=False)  # a tick lasts 100 s
        self.client.set(real_time_factor=0.0)
        self.newest(lambda status: status.tick > 5, 'a fast crowd')

    def test_tiny_factors(self):
        """A tick would last longer than a duration of ROS can be; the crowd goes on with the next factor."""
        self.start_all(real_time_factor=1e-12, paused=False)
        self.newest(lambda status: status.tick == 1, 'the end of a tick')
        self.assertEqual(self.client.set(real_time_factor=5e-324)['real_time_factor'], 5e-324)  # the next tick
        self.newest(lambda status: status.tick == 2, 'the end of the next tick')
        self.client.set(real_time_factor=1.0)
        self.newest(lambda status: status.tick > 4, 'a walking crowd')

    def test_changes_by_services_are_published(self):
        self.start_all()
        self.client.wait(paused=True)
        self.do('set_real_time_factor', factor=0.5)
        self.client.wait(real_time_factor=0.5, paused=True)
        self.do('pause', data=False)
        self.client.wait(real_time_factor=0.5, paused=False)

    def test_invalid_values_change_nothing(self):
        self.start_all()
        for bad in ({'real_time_factor': -1.0}, {'answer_deadline': 0.0}, {'misses_until_absent': 0},
                    {'agents_rate': float('nan')}):
            self.assertEqual(self.client.set(real_time_factor=bad.pop('real_time_factor', 2.0), **bad), CONTROLLER)
        self.client.wait(**CONTROLLER)
        self.newest(lambda status: status.real_time_factor == 0.0, 'the factor')
        support.wait_for(lambda: 'answer_deadline: expected a number from 0.001 to 3600 s, got 0' in
                         self.controller.output(), 'a warning')

    def test_requests_without_the_standard_client(self):
        """A whole number stands for any number. Unknown names and wrong types are refused, with all of the request."""
        self.start_all()
        service = rospy.ServiceProxy(f'{self.namespace}/crowd_controller/set_parameters', Reconfigure)

        def factor_after(**lists):
            response = service(Config(**lists)).config
            return next(entry.value for entry in response.doubles if entry.name == 'real_time_factor')

        self.assertEqual(factor_after(ints=[IntParameter('real_time_factor', 2)]), 2.0)
        wanted = [DoubleParameter('real_time_factor', 3.0)]
        self.assertEqual(factor_after(doubles=wanted, bools=[BoolParameter('pausd', True)]), 2.0)
        self.assertEqual(factor_after(doubles=wanted, ints=[IntParameter('paused', 1)]), 2.0)
        self.assertEqual(factor_after(doubles=wanted), 3.0)
        for words in ('pausd: there is no such parameter', 'paused: expected a value of type bool, got 1'):
            support.wait_for(lambda text=words: text in self.controller.output(), words)

    def test_new_deadline_ends_the_wait_for_an_answer(self):
        self.start_all()
        self.step()
        next(process for process in self.processes if process.name == 'learner').kill()
        later = self.call_later('crowd_controller/step', ticks=1)  # waits for an answer for 60 s
        self.client.set(answer_deadline=0.01)
        self.assertTrue(later.result('the end of the wait').success)
        self.client.wait(answer_deadline=0.01)

    def test_number_of_misses_until_absent(self):
        self.start_all(answer_deadline=0.01, misses_until_absent=1000)
        self.step()
        next(process for process in self.processes if process.name == 'learner').kill()
        self.client.set(misses_until_absent=2)
        self.step(2)
        support.wait_for(lambda: 'They are absent' in self.controller.output(), 'absent agents')

    def test_rate_of_agents(self):
        """With 0.001 Hz, no message is published in the middle of a walk; then each tick is."""
        self.start_all(agents_rate=0.001)
        self.walk(5)
        self.assertEqual([message for message in self.agents.messages if 0 < message.tick < 5], [])
        self.client.set(agents_rate=0.0)
        self.walk(5)
        self.agents.wait_at(0, 7)

    def test_command_line_program(self):
        self.start_all()
        node = f'{self.namespace}/crowd_controller'
        for words in (['list'], ['set', node, 'answer_deadline', '2.5'], ['get', node]):
            program = self.start(f'dynparam_{words[0]}', DYNPARAM + words)
            self.assertEqual(program.wait(), 0, program.output())
            if words[0] == 'list':
                self.assertIn(node, program.output().split())
        read = yaml.safe_load(program.output()[:program.output().index(", 'groups'")] + '}')
        self.assertEqual(read, dict(CONTROLLER, answer_deadline=2.5))


class LearnerTest(ReconfigureTestCase):
    """learner."""

    def start_one(self, **parameters):
        """Starts a learner."""
        self.status = self.listen('learner_status', LearnerStatus)
        self.learner = self.start_learner(**parameters)
        self.status.wait()
        self.client = self.reconfigurer('learner')

    def newest(self, fits, what):
        """Waits until the newest status meets the condition."""
        return support.wait_for(lambda: fits(self.status.messages[-1]), what)

    def test_client_gets_present_values_and_ranges(self):
        self.start_one(alpha=0.25, gamma=0.5)
        self.client.wait(mode='demo', alpha=0.25, gamma=0.5, ties='first', mirrored=False)
        about = self.client.descriptions()
        self.assertEqual(set(about), {'mode', 'alpha', 'alpha_decay', 'gamma', 'lambda', 'epsilon', 'mirrored', 'ties'})
        self.assertEqual((about['alpha']['min'], about['alpha']['max'], about['alpha']['default']), (1e-6, 1.0, 0.25))
        self.assertEqual((about['gamma']['min'], about['gamma']['max']), (0.0, 1.0 - 1e-6))
        choices = [choice['value'] for choice in yaml.safe_load(about['mode']['edit_method'])['enum']]
        self.assertEqual(choices, ['training', 'demo'])

    def test_mode_and_parameters_are_changed(self):
        self.start_one()
        read = self.client.set(mode='training', alpha=0.5, epsilon=0.125, **{'lambda': 0.75})
        self.assertEqual((read['mode'], read['alpha'], read['epsilon'], read['lambda']), ('training', 0.5, 0.125, 0.75))
        self.newest(lambda status: (status.mode, status.alpha, status.epsilon, status.trace_decay) ==
                    ('training', 0.5, 0.125, 0.75), 'the changes')
        self.client.set(ties='random', mirrored=True)
        self.client.wait(mode='training', ties='random', mirrored=True, alpha=0.5)

    def test_changes_by_services_are_published(self):
        self.start_one()
        self.client.wait(mode='demo')
        self.succeed('learner/set_mode', mode='training')
        self.client.wait(mode='training')
        self.succeed('learner/set_learning_parameters', parameters='{alpha: 0.75}')
        self.client.wait(mode='training', alpha=0.75)

    def test_invalid_values_change_nothing(self):
        self.start_one(alpha=0.25)
        for bad in ({'alpha': 0.0}, {'gamma': 1.0}, {'epsilon': 1.5}, {'mode': 'demos'}):
            read = self.client.set(**{'lambda': 0.5}, **bad)
            self.assertEqual((read['alpha'], read['lambda'], read['mode']), (0.25, 0.0, 'demo'), bad)
        for words in ('gamma: expected a number from 0 to below 1, got 1',
                      "mode: expected training or demo, got 'demos'"):
            support.wait_for(lambda text=words: text in self.learner.output(), words)

    def test_epsilon_of_a_schedule_is_shown_and_replaced(self):
        learning = '{alpha: 0.2, epsilon: {from: 0.8, to: 0.2, episodes: 10}}'
        config = self.write('config.yaml', config_text(support.CIRCLE6, 1, learning=learning))
        self.start_one(mode='training', config=config)
        self.client.wait(epsilon=0.8)
        self.start_controller(support.CIRCLE6, paused=True)
        self.listen('agents', AgentStates).wait_connected()
        self.client.set(alpha=0.5)  # does not end the schedule
        for _ in range(2):
            self.succeed('crowd_controller/reset', keep_seed=True)
            self.step()
        self.client.wait(epsilon=0.8 - 2 * 0.06, alpha=0.5)  # the third episode
        self.client.set(epsilon=0.25)
        self.succeed('crowd_controller/reset', keep_seed=True)
        self.step()
        self.succeed('learner/set_learning_parameters', parameters='{}')  # changes nothing, publishes a status
        self.newest(lambda status: status.episode == 3 and status.epsilon == 0.25, 'an episode without the schedule')


class NodeletTest(ReconfigureTestCase):
    """Controller and two learners in one process."""

    def test_each_nodelet_has_parameters_of_its_own(self):
        self.start('manager', ['rosrun', 'nodelet', 'nodelet', 'manager', '__name:=manager'])
        for name, agents in (('learner_a', '[0]'), ('learner_b', '[1]')):
            self.start(name, ['rosrun', 'nodelet', 'nodelet', 'load', 'social_crowd/learner', 'manager',
                              f'__name:={name}', f'_q_table:={support.NEAREST_TABLE}', f'_agents:={agents}'])
        self.start('controller', ['rosrun', 'nodelet', 'nodelet', 'load', 'social_crowd/crowd_controller', 'manager',
                                  '__name:=crowd_controller', f'_scenario:={support.CIRCLE6}', '_paused:=true'])
        first, second, controller = map(self.reconfigurer, ('learner_a', 'learner_b', 'crowd_controller'))
        first.set(alpha=0.5)
        controller.set(answer_deadline=3.5)
        second.set(mode='training')
        first.wait(alpha=0.5, mode='demo')
        second.wait(alpha=0.1, mode='training')
        controller.wait(answer_deadline=3.5, paused=True)


if __name__ == '__main__':
    support.run('reconfigure_test')
