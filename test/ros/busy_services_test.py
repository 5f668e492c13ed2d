#!/usr/bin/python3
"""Services answer while others read large files or wait."""
import support
from controlling import ControllerTestCase
from geometry_msgs.msg import Point, Pose2D

# So much YAML that a refused call takes a second or so. Before these services had threads of their own, others had to
# wait until at least three of six calls had ended.
SLOW = f'junk: [{"0, " * 600000}0]\n'
CALLS = 6
MOST_ENDED = 2


class BusyServicesTest(ControllerTestCase):
    """Calls that take long."""

    def load_slowly(self, service, name, content):
        """Makes many calls with a file that takes long. Returns them."""
        file = self.write('slow.txt', content)
        return [self.call_later(service, **{name: file}) for _ in range(CALLS)]

    def assert_busy(self, calls):
        """Most calls are still in progress; they are refused later."""
        self.assertLessEqual(sum(call.is_done() for call in calls), MOST_ENDED)
        for call in calls:
            self.assertFalse(call.result('the end of a call').success)

    def test_controller_reads_files(self):
        self.start_all()
        calls = self.load_slowly('crowd_controller/load_scenario', 'scenario', SLOW)
        self.do('pause', data=True)
        self.assertEqual(self.step(2).tick, 2)
        self.do('set_goal', agent=0, goal=Point(5, 0, 0))
        self.do('reset', keep_seed=True)
        self.do('pause', data=False)
        self.do('pause', data=True)
        self.assert_busy(calls)

    def test_learner_reads_files(self):
        self.start_all()
        calls = self.load_slowly('learner/load_q_table', 'file', f'social_crowd Q-table 1\n{SLOW}---\n')
        self.succeed('learner/set_mode', mode='training')
        self.succeed('learner/set_learning_parameters', parameters='{alpha: 0.5}')
        self.succeed('learner/reset_traces')
        self.succeed('learner/share_q_table')
        self.assertEqual(self.step(2).tick, 2)
        self.assert_busy(calls)

    def test_steps_at_the_same_time(self):
        """All but one are refused at once, and other services answer meanwhile."""
        self.start_all(real_time_factor=1.0)
        calls = [self.call_later('crowd_controller/step', ticks=1000000) for _ in range(CALLS)]
        support.wait_for(lambda: sum(call.is_done() for call in calls) == CALLS - 1, 'refusals')
        walking = next(call for call in calls if not call.is_done())
        for call in calls:
            if call is not walking:
                self.assert_says(call.result().message, 'another step request is in progress')
        self.do('pause', data=True)
        self.do('teleport', agent=0, pose=Pose2D(1, 5, 0))
        self.do('reset', keep_seed=True)
        self.assertFalse(walking.is_done())
        self.do('pause', data=False)
        self.assertTrue(walking.result().success)


if __name__ == '__main__':
    support.run('busy_services_test')
