#!/usr/bin/python3
"""Answers that the crowd controller refuses: counts and warnings; perceptions are published once."""
import rospy
import support
from answering import AHEAD, BACK, AbsenceTestCase, Answers, actions_for
from social_crowd.msg import LearnerStatus, Perceptions, RelativeAction

NAN, INFINITE = float('nan'), float('inf')


class WrongAnswersTest(AbsenceTestCase):
    """Wrong answers are dropped and counted, and nothing else changes."""

    def check(self, wrong, count, after=False):
        """Walks an episode without and one with wrong answers, and checks how many are dropped per tick."""
        self.start_quiet(seconds=3, paused=True, trajectories=self.path('ros'), answer_deadline=60.0)
        answers = Answers(self)
        self.step(30)
        # Not in the last tick, because its answers might arrive after the end of the episode.
        setattr(answers, 'after' if after else 'before', lambda now: wrong(now) if now.tick < 29 else [])
        self.step(30)
        results = [self.results.wait_at(episode, 30) for episode in (0, 1)]
        self.assertEqual((results[0].dropped_answers, results[0].missed_answers), (0, 0))
        self.assertEqual((results[1].dropped_answers, results[1].missed_answers), (count * 29, 0))
        self.assertEqual(self.rows(1), self.rows(0))
        self.assertAlmostEqual(self.rows(1)[30][0][0], 1.5)

    def test_drops_answers_to_an_old_tick(self):
        self.check(lambda now: [actions_for(now.episode, (now.tick - 1) % 2**64, {0: BACK})], 1)

    def test_drops_answers_to_a_future_tick(self):
        self.check(lambda now: [actions_for(now.episode, now.tick + 1, {0: BACK, 1: BACK})], 2)

    def test_drops_answers_to_another_episode(self):
        self.check(lambda now: [actions_for(episode, now.tick, {0: BACK}) for episode in (0, 2, 2**64 - 1)], 3)

    def test_drops_answers_to_another_controller(self):
        def to_another(now):
            message = actions_for(now.episode, now.tick, {0: BACK})
            message.run = now.run + 1
            return [message]

        self.check(to_another, 1)

    def test_drops_answers_for_unknown_agents(self):
        self.check(lambda now: [actions_for(now.episode, now.tick, {2: BACK, 9999: BACK, 2**32 - 1: BACK})], 3)

    def test_drops_invalid_numbers(self):
        bad = [(NAN, 1.0), (0.0, NAN), (INFINITE, 1.0), (-INFINITE, 1.0), (0.0, INFINITE), (0.0, 1.001), (0.0, -0.001)]
        self.check(lambda now: [actions_for(now.episode, now.tick, {0: action}) for action in bad], len(bad))

    def test_drops_a_second_answer_during_the_tick(self):
        """The first answer to agent 0 is carried out; the second is dropped, the third repeats the first."""
        self.check(lambda now: [actions_for(now.episode, now.tick, {0: action}) for action in (AHEAD, BACK)], 1)

    def test_drops_a_second_answer_after_all_answers(self):
        self.check(lambda now: [actions_for(now.episode, now.tick, {0: BACK, 1: BACK})], 2, after=True)

    def test_drops_a_second_answer_in_the_same_message(self):
        def twice(now):
            message = actions_for(now.episode, now.tick, {0: AHEAD})
            message.agents.append(RelativeAction(0, *BACK))
            return [message]

        self.check(twice, 1)  # the learner's own answer then repeats the first


class NamedCausesTest(AbsenceTestCase):
    """A refused answer is named with its learner and its cause, once for each cause."""

    def refuse(self, change, warning='no answer for'):
        """Lets a learner publish only wrong answers. Returns the output of the controller up to a warning."""
        self.start_quiet(start_deadline=300.0, answer_deadline=0.2, paused=True)
        answers = Answers(self)
        answers.silent = {0, 1}
        answers.before = lambda now: [change(actions_for(now.episode, now.tick, {0: AHEAD, 1: AHEAD}), now)
                                      for _ in range(3)]
        self.call_later('crowd_controller/step', ticks=2)
        return support.wait_for(lambda: warning in self.controller.output() and self.controller.output(), warning)

    def check_cause(self, output, *words):
        """Checks the one warning of the cause."""
        learner = f"'{rospy.get_name()}' answers "
        warnings = [line for line in output.splitlines() if learner in line and 'once' in line]
        self.assertEqual(len(warnings), 1, output)
        self.assert_says(warnings[0], *words)

    def check(self, change, *words):
        """Checks the warning of the cause, and that the learner is not reported as silent."""
        output = self.refuse(change)
        self.check_cause(output, *words)
        silence = next(line for line in output.splitlines() if 'no answer for' in line)
        self.assert_says(silence, 'agents 0, 1', f"'{rospy.get_name()}' answers, but its answers are refused")

    def test_missing_run(self):
        def without_run(message, now):
            message.run = 0
            return message

        answer = Answers.send
        Answers.send = lambda answers, message, perceived: answers.publisher.publish(message)
        self.addCleanup(setattr, Answers, 'send', answer)
        self.check(without_run, 'without run', 'expected run')

    def test_speed_above_one(self):
        def twice_as_fast(message, now):
            for action in message.agents:
                action.speed_fraction = 2.0
            return message

        self.check(twice_as_fast, 'speed_fraction 2', 'expected 0 to 1')

    def test_rotation_not_finite(self):
        def nowhere(message, now):
            for action in message.agents:
                action.rotation = NAN
            return message

        self.check(nowhere, 'rotation nan', 'finite')

    def test_future_tick(self):
        def too_early(message, now):
            message.tick = now.tick + 7
            return message

        output = self.refuse(too_early, 'has not begun')
        self.check_cause(output, 'agents 0, 1', 'tick 7 of episode 0', 'expected episode and tick')

    def test_unknown_agents(self):
        def unknown(message, now):
            message.agents = [RelativeAction(12, *AHEAD)]
            return message

        self.check(unknown, 'agent 12', 'expected agents of the perceptions')


class TwoLearnersTest(AbsenceTestCase):
    """Two learners that serve the same agents."""

    def test_warning_names_both_learners_once(self):
        self.start_quiet(paused=True)
        self.start_learner('learner_a')
        self.start_learner('learner_b')

        def is_said_after_a_tick():
            self.step(1)
            return 'two learners' in self.controller.output()

        support.wait_for(is_said_after_a_tick, 'the warning')
        self.step(20)
        warnings = [line for line in self.controller.output().splitlines() if 'two learners' in line]
        self.assertEqual(len(warnings), 1, warnings)
        self.assert_says(warnings[0], 'agents 0, 1', f"'{self.namespace}/learner_a'", f"'{self.namespace}/learner_b'",
                         '~agents')

    def test_no_warning_for_learners_with_different_agents(self):
        status = self.listen('learner_status', LearnerStatus)
        self.start_quiet(seconds=3, paused=True, answer_deadline=60.0)
        self.start_pair()
        # A learner that needs more than 3 s to start is named.
        support.wait_for(lambda: len({message.node for message in status.messages}) == 2, 'both learners')
        self.step(30)
        self.assertEqual(self.results.wait_at(0, 30).dropped_answers, 0)
        self.assertNotIn('WARN', self.controller.output())


class SentOnceTest(AbsenceTestCase):
    """Perceptions are sent once, and again to a learner that joins later; repeated answers do not count as dropped."""

    def test_perceptions_are_sent_once_while_waiting(self):
        heard = self.listen('perceptions', Perceptions)
        self.start_quiet(seconds=3, answer_deadline=2.0, start_deadline=300.0, paused=True)
        heard.wait_connected()
        later = self.call_later('crowd_controller/step', ticks=30)
        support.wait_for(lambda: 'no answer for' in self.controller.output(), 'the warning, 3 s after the perceptions')
        self.assertEqual(len(heard.messages), 1)
        self.start_learner()
        later.result()
        result = self.results.wait_at(0, 30)
        self.assertEqual((result.dropped_answers, result.missed_answers), (0, 0))
        heard.wait_at(0, 30)
        self.assertEqual(len([message for message in heard.messages if message.tick > 0 and not message.episode]), 30)

    def test_perceptions_are_not_repeated_if_no_answer_is_awaited(self):
        self.start_quiet(paused=True)
        self.start_learner()
        self.step(1)
        heard = self.listen('perceptions', Perceptions).wait_connected()
        self.step(1)
        self.assertEqual([message.tick for message in [heard.wait_at(0, 1)] + heard.messages], [1, 1])

    def test_reported_waiting_time_continues_after_the_deadline(self):
        self.start_quiet(start_deadline=0.1, answer_deadline=0.1)
        self.agents.wait(lambda message: message.tick >= 2)

        def warnings():
            return [line for line in self.controller.output().splitlines() if 'no answer for' in line]

        support.wait_for(lambda: len(warnings()) >= 2, 'two warnings, 5 s apart')
        seconds = [float(line.split(' s: ')[0].split()[-1]) for line in warnings()]
        self.assertGreaterEqual(seconds[1], seconds[0] + 4.5)


if __name__ == '__main__':
    support.run('answers_test')
