#!/usr/bin/python3
"""Diagnostics of crowd_controller and learner on /diagnostics, and their groups in diagnostic_aggregator."""
import rospy
import support
import yaml
from controlling import QUIET, ControllerTestCase
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from roslib.packages import find_node
from social_crowd.msg import Perceptions

OK, WARN, ERROR = DiagnosticStatus.OK, DiagnosticStatus.WARN, DiagnosticStatus.ERROR
PERIOD = 0.2  # [s]


class DiagnosticsTestCase(ControllerTestCase):
    """Nodes with a short diagnostic period."""

    def setUp(self):
        super().setUp()
        self.reports = self.listen('/diagnostics', DiagnosticArray)

    def start_learner(self, *arguments, **parameters):
        return super().start_learner(*arguments, **dict({'diagnostic_period': PERIOD}, **parameters))

    def start_controller(self, *arguments, **parameters):
        return super().start_controller(*arguments, **dict({'diagnostic_period': PERIOD}, **parameters))

    def all_of(self, name, since=0):
        """Returns the reports of a name in the name space of this test, from a message on."""
        full_name = f'{self.namespace[1:]}/{name}'
        return [status for message in self.reports.messages[since:] for status in message.status
                if status.name == full_name]

    def newest(self, name):
        """Returns the newest report of a name; None: none."""
        return next(reversed(self.all_of(name)), None)

    def wait(self, name, level, words=''):
        """Waits until the newest report has this level, and a message with these words. Returns its values."""
        def fits():
            status = self.newest(name)
            return status and status.level == level and words in status.message and status
        try:
            status = support.wait_for(fits, f'{name} with level {level}: {words}')
        except AssertionError as error:
            raise AssertionError(f'{error}; newest: {self.newest(name)}') from None
        return {value.key: value.value for value in status.values}


class WalkTest(DiagnosticsTestCase):
    """A crowd that walks, and what may go wrong."""

    def test_walking_crowd(self):
        self.start_all(real_time_factor=5.0)  # 50 ticks/s
        values = self.wait('crowd_controller: ticks', OK, 'paused')
        self.assertEqual((values['agents'], values['agents on their way'], values['scenario']), ('2', '2', 'scene'))
        self.do('pause', data=False)
        values = self.wait('crowd_controller: ticks', OK, 'of 50.0 ticks/s')
        self.assertEqual(values['wanted ticks per second'], '50.0')
        self.assertEqual(values['real_time_factor'], '5')
        self.wait('crowd_controller: answers', OK, 'all answers in time')
        self.wait('crowd_controller: robots', OK, 'no robots')
        values = self.wait('learner: decisions', OK, 'demo, ')
        self.assertEqual((values['mode'], values['agents']), ('demo', '2'))
        values = self.wait('learner: table', OK, 'of 137 rows visited')
        self.assertEqual((values['rows'], values['actions'], values['bytes']), ('137', '8', str(137 * 8 * 12)))
        self.do('pause', data=True)
        self.wait('crowd_controller: ticks', OK, 'paused')
        self.wait('learner: decisions', OK, 'no perceptions for')

    def test_fast_crowd(self):
        self.start_all()
        self.do('pause', data=False)
        self.wait('crowd_controller: ticks', OK, 'as fast as possible: ')

    def test_crowd_that_lags_behind(self):
        self.start_all(real_time_factor=1e6, paused=False)
        self.wait('crowd_controller: ticks', WARN, 'lags behind: ')
        self.do('set_real_time_factor', factor=1.0)
        self.wait('crowd_controller: ticks', OK, 'of 10.0 ticks/s')

    def test_learner_that_is_killed_and_comes_back(self):
        self.start_all(real_time_factor=1.0, answer_deadline=0.1, paused=False)
        self.wait('crowd_controller: answers', OK, 'all answers in time')
        since = len(self.reports.messages)
        next(process for process in self.processes if process.name == 'learner').kill()
        # It lasts for less than a second, then it is an error.
        support.wait_for(lambda: any(status.level == WARN and 'answers missed' in status.message
                                     for status in self.all_of('crowd_controller: answers', since)), 'a warning')
        values = self.wait('crowd_controller: answers', ERROR, 'no answer for agents 0, 1')
        self.assertEqual(values['agents without an answer'], '2')
        self.assertGreaterEqual(int(values['missed answers since the start']), 2)
        self.start_learner()
        self.wait('crowd_controller: answers', OK, 'all answers in time')

    def test_crowd_without_a_learner(self):
        self.start_controller(self.write('scene.yaml', QUIET))
        self.wait('crowd_controller: answers', ERROR, 'no answer for agents 0, 1 for more than a second')
        self.wait('crowd_controller: ticks', WARN, 'no tick')

    def test_refused_answers(self):
        """Two learners answer for the same agents."""
        self.start_all(real_time_factor=1.0, paused=False)
        self.wait('crowd_controller: answers', OK, 'all answers in time')
        self.start_learner('learner_2', q_table=support.ANTICIPATION_TABLE)
        self.wait('crowd_controller: answers', WARN, 'dropped')

    def test_perceptions_that_lack_vision(self):
        """Perceptions of another controller that never receives the learner's status, and then ends."""
        self.start_learner(q_table=support.ANTICIPATION_TABLE)
        self.wait('learner: decisions', OK, 'no perceptions yet')
        sender = rospy.Publisher(f'{self.namespace}/perceptions', Perceptions, queue_size=1)
        support.wait_for(lambda: sender.get_num_connections() > 0, 'the learner')
        sender.publish(Perceptions(vision_radius=1.0))
        # For a moment this is normal: the controller has not received the status yet.
        self.wait('learner: decisions', OK, 'no perceptions for ')

        def is_warned():
            sender.publish(Perceptions(vision_radius=1.0))
            status = self.newest('learner: decisions')
            return status.level == WARN and 'less than the model needs' in status.message
        support.wait_for(is_warned, 'a warning')
        sender.unregister()
        self.wait('learner: decisions', OK, 'no perceptions for ')

    def test_empty_table(self):
        self.start_learner(mode='training', config=support.in_package('config', 'learning', 'thesis_occupancy.yaml'))
        self.wait('learner: table', OK, '0 of ')
        self.succeed('learner/set_mode', mode='demo')
        self.wait('learner: table', WARN, 'the table is empty')

    def test_period_out_of_range(self):
        node = self.start_learner(diagnostic_period=0.01)
        self.assertEqual(node.wait(), 1)
        self.assert_says(node.output(), '~diagnostic_period: expected a number from 0.1 to 3600 s, got 0.01')


class AggregatorTest(DiagnosticsTestCase):
    """config/diagnostics.yaml."""

    def test_groups(self):
        try:
            program = find_node('diagnostic_aggregator', 'aggregator_node')[:1]
        except Exception:
            program = []
        if not program:
            self.skip('diagnostic_aggregator is not installed')
        groups = self.listen('/diagnostics_agg', DiagnosticArray)
        with open(support.in_package('config', 'diagnostics.yaml'), encoding='utf-8') as file:
            rospy.set_param(f'{self.namespace}/diagnostic_aggregator', yaml.safe_load(file))
        self.start('aggregator', program + ['__name:=diagnostic_aggregator'])
        groups.wait_connected()
        self.start_all(paused=False, real_time_factor=1.0)
        space = self.namespace[1:]
        expected = {'/Crowd/Controller', '/Crowd/Learners'}
        expected |= {f'/Crowd/Controller/{space} crowd_controller: {name}' for name in ('ticks', 'answers', 'robots')}
        expected |= {f'/Crowd/Learners/{space} learner: {name}' for name in ('decisions', 'table')}

        def is_complete(message):
            levels = {status.name: status.level for status in message.status}
            return expected <= set(levels) and all(levels[name] == OK for name in expected)

        groups.wait(is_complete, f'with {sorted(expected)}')


if __name__ == '__main__':
    support.run('diagnostics_test')
