#!/usr/bin/python3
"""Motion limits of agents through ROS: those of the learners, or of the scenario, are known to all learners."""
import rospy
import support
from answering import Answers
from social_crowd.msg import LearnerStatus, Perceptions
from walking import WalkTestCase

TABLES = {name: support.in_package('config', 'q_tables', name + '.txt') for name in ('anticipation', 'human')}
LIMITS = {'anticipation': (0.0, 0.0, 0.0), 'human': (3.0, 3.0, 0.0)}  # acceleration, braking, turn rate; 0: unlimited
# A dense crowd among walls, in which everybody brakes.
CROWD = """
name: dense
duration: 20
goal_tolerance: 0.3
agents:
  - {count: 24, position: {box: [[-4, -4], [4, 4]]}, goal: {box: [[-4, -4], [4, 4]]}, speed: [0.8, 1.6], radius: 0.25}
walls:
  - [[-2, 0], [2, 0]]
  - [[0, 1], [0, 3]]
"""


def limits_of(message):
    """Returns acceleration, braking and turn rate of a message."""
    return message.acceleration, message.braking, message.turn_rate


class MotionTestCase(WalkTestCase):
    """Waits for perceptions with motion limits."""

    def expect(self, source, limits):
        """Walks until the perceptions have motion limits."""
        def is_used():
            response = self.step()
            message = self.perceptions.wait_at(response.episode, response.tick - 1)
            return (message.motion_source, limits_of(message)) == (source, limits)

        support.wait_for(is_used, f'perceptions with the motion limits {limits}')


class ReportedLimitsTest(MotionTestCase):
    """The limits of the perceptions depend on the reports of learners and on the scenario."""

    def start_reported(self, motion=''):
        """Starts a controller and a learner that reports nothing."""
        self.statuses = {}
        self.perceptions = self.listen('perceptions', Perceptions)
        self.controller = self.start_controller(self.write('crowd.yaml', CROWD.replace('20', '1000') + motion),
                                                paused=True)
        self.perceptions.wait_connected()
        self.answers = Answers(self)

    def report(self, learner, *limits):
        """Publishes the status of a learner."""
        if learner not in self.statuses:
            self.statuses[learner] = rospy.Publisher(f'{self.namespace}/learner_status', LearnerStatus, queue_size=0)
            self.addCleanup(self.statuses[learner].unregister)
            support.wait_for(lambda: self.statuses[learner].get_num_connections() > 0, 'the controller to subscribe')
        status = LearnerStatus(node=learner, vision_radius=6.0)
        status.acceleration, status.braking, status.turn_rate = limits
        self.statuses[learner].publish(status)

    def test_the_highest_limits_of_all_learners(self):
        self.start_reported()
        self.expect(Perceptions.MOTION_UNKNOWN, (0.0, 0.0, 0.0))
        self.report('/a', 2.0, 3.0, 4.0)
        self.expect(Perceptions.MOTION_OF_LEARNERS, (2.0, 3.0, 4.0))
        self.report('/b', 2.5, 2.5, 5.0)
        self.expect(Perceptions.MOTION_OF_LEARNERS, (2.5, 3.0, 5.0))
        self.report('/b', 0.0, 0.0, 0.0)
        self.expect(Perceptions.MOTION_OF_LEARNERS, (0.0, 0.0, 0.0))

    def test_limits_of_the_scenario_come_first(self):
        self.start_reported('motion: {acceleration: 1.5, braking: 2}\n')
        self.report('/a', 2.0, 3.0, 4.0)
        self.expect(Perceptions.MOTION_OF_SCENARIO, (1.5, 2.0, 0.0))

    def test_invalid_limits_are_ignored(self):
        self.start_reported()
        for wrong in ((-1.0, 3.0, 0.0), (2.0, 0.0, 0.0), (float('nan'), 3.0, 0.0)):
            self.report('/a', *wrong)
        self.report('/b', 2.0, 3.0, 0.0)
        self.expect(Perceptions.MOTION_OF_LEARNERS, (2.0, 3.0, 0.0))
        support.wait_for(lambda: self.controller.output().count('invalid motion limits') == 3, 'three warnings')


class SameAsHeadlessTest(MotionTestCase):
    """Agents with motion limits walk the same with and without ROS."""

    def check(self, table, motion=''):
        """Compares a recording with that of `evaluate`."""
        scenario = self.write('crowd.yaml', CROWD + motion)
        self.start_learner(q_table=TABLES[table])
        self.assert_same_recording(self.walk(scenario, episodes=2),
                                   self.headless(scenario, TABLES[table], episodes=2, seed=5))

    def test_limits_of_the_table(self):
        self.check('human')

    def test_limits_of_the_scenario(self):
        self.check('anticipation', 'motion: {acceleration: 2, braking: 2.5, turn_rate: 7}\n')

    def test_an_unlimited_scenario(self):
        self.check('human', 'motion: unlimited\n')

    def test_limits_of_a_learner_that_decided_for_nobody_in_an_episode_end(self):
        self.perceptions = self.listen('perceptions', Perceptions)
        first = self.start_learner('first', q_table=TABLES['anticipation'])
        self.start_walk(self.write('crowd.yaml', CROWD), episodes=9, paused=True)
        self.perceptions.wait_connected()
        self.expect(Perceptions.MOTION_OF_LEARNERS, LIMITS['anticipation'])
        self.assertEqual(first.stop(), 0)
        self.start_learner('second', q_table=TABLES['human'])
        self.succeed('crowd_controller/reset')
        self.expect(Perceptions.MOTION_OF_LEARNERS, LIMITS['anticipation'])  # the first one decided in the last episode
        self.succeed('crowd_controller/reset')
        self.expect(Perceptions.MOTION_OF_LEARNERS, LIMITS['human'])

    def test_a_crowd_of_both_tables_is_unlimited_and_without_contacts(self):
        self.perceptions = self.listen('perceptions', Perceptions)
        self.start_learner('one', q_table=TABLES['human'], agents=list(range(12)))
        self.start_learner('other', q_table=TABLES['anticipation'], agents=list(range(12, 24)))
        self.start_walk(self.write('crowd.yaml', CROWD), episodes=1, paused=True)
        self.perceptions.wait_connected()
        self.expect(Perceptions.MOTION_OF_LEARNERS, LIMITS['anticipation'])
        self.succeed('crowd_controller/pause', data=False)
        self.finish_walk()
        self.assertEqual([agent.touched for agent in self.results.messages[-1].agents], [False] * 24)


if __name__ == '__main__':
    support.run('motion_test')
