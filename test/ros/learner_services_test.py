#!/usr/bin/python3
"""Services of a learner: training and demo mode, reset of the traces."""
import math

import support
from learning_files import QTableFile, q_table_text
from perceiving import add_agent, ahead, perceptions
from teaching import LearnerTestCase


class ModeTest(LearnerTestCase):
    """Training mode changes the table, demo mode does not."""

    def test_training_updates_the_table(self):
        self.start_untrained(alpha=0.5)
        self.walk(0, 4)  # the outcome of the last decision is not known yet
        table = self.saved()
        self.assertEqual(table.header['decisions'], 3)
        self.assertEqual(table.visits(), 3)
        self.assertEqual(set(table.rows), {1})  # the goal in sector 1, nothing perceived

    def test_a_single_update_by_hand(self):
        """The value moves half-way from 0 to the reward, cos(45 degrees)^3; the value of the next state is 0."""
        self.start_untrained(alpha=0.5)
        self.walk(0, 2)
        table = self.saved()
        self.assertEqual(set(table.rows), {1})
        visits, value = table.rows[1][0]
        self.assertEqual(visits, 1)
        self.assertAlmostEqual(value, 0.5 * math.cos(math.radians(45))**3, places=12)

    def test_arrival_updates_the_table(self):
        self.start_untrained(alpha=0.5)
        self.walk(0, 1)
        self.perceiver.tell(add_agent(perceptions(0, 1, last=True), 0, ahead(45, 0.1), arrived=True))
        support.wait_for(lambda: self.saved().header['decisions'] == 1, 'the arrival to be learned from')
        self.assertEqual(self.saved().rows[1][0], (1, 50.0))

    def test_missed_answers_update_nothing(self):
        self.start_untrained()
        self.walk(0, 5, acted=False)
        self.assertEqual(self.saved().visits(), 0)

    def test_missing_ticks_update_nothing(self):
        self.start_untrained()
        for tick in (0, 2, 4, 5):
            self.perceiver.ask(add_agent(perceptions(0, tick), 0, ahead(45, 5)))
        self.assertEqual(self.saved().visits(), 1)

    def test_demo_mode_updates_nothing(self):
        self.start_one(mode='demo')
        before = support.read_text(support.NEAREST_TABLE)
        self.walk(0, 5)
        self.succeed('learner/save_q_table', file=self.path('saved.txt'))
        rows = [text.partition('---')[2].rpartition('checksum')[0]
                for text in (before, support.read_text(self.path('saved.txt')))]
        self.assertEqual(rows[0], rows[1])

    def test_mode_can_be_changed(self):
        self.start_untrained()
        self.walk(0, 3)
        self.assertEqual(self.saved().visits(), 2)
        self.assert_says(self.succeed('learner/set_mode', mode='demo').message, 'demo')
        self.status.wait(lambda status: status.mode == 'demo')
        self.walk(1, 3)
        self.assertEqual(self.saved().visits(), 2)
        self.succeed('learner/set_mode', mode='training')
        self.walk(2, 3)
        self.assertEqual(self.saved().visits(), 4)
        support.wait_for(lambda: self.status.messages[-1].mode == 'training', 'a status in training mode')

    def test_unknown_mode_is_refused(self):
        self.start_untrained()
        self.refuse('learner/set_mode', 'training or demo', 'walking', mode='walking')
        self.walk(0, 3)
        self.assertEqual(self.saved().visits(), 2)


class ResetTracesTest(LearnerTestCase):
    """reset_traces: nothing is learned across a reset."""

    def perceive(self, episode, tick, degrees):
        """Publishes a tick of a single agent with its goal at a bearing: row 0 straight ahead, row 1 at 45 degrees."""
        self.perceiver.ask(add_agent(perceptions(episode, tick), 0, ahead(degrees, 5)))

    def value(self, row):
        """Returns the value of the first action."""
        table = self.saved()
        return table.rows[row][0][1] if row in table.rows else 0.0

    def reset(self):
        """Calls the service."""
        self.assert_says(self.succeed('learner/reset_traces').message, 'traces', 'decisions', 'unchanged')

    def test_last_decision_is_not_updated(self):
        self.start_untrained()
        self.perceive(0, 0, 45)
        self.perceive(0, 1, 45)
        self.assertEqual(self.saved().header['decisions'], 1)
        self.reset()
        self.perceive(0, 2, 45)
        self.assertEqual(self.saved().header['decisions'], 1)
        self.perceive(0, 3, 45)
        self.assertEqual(self.saved().header['decisions'], 2)
        self.assertEqual(self.saved().visits(), 2)

    def test_later_updates_do_not_reach_earlier_decisions(self):
        """The learning rate is 0.5; 0.9 * 0.5 = 0.45 of an update reaches the previous decision."""
        self.start_untrained(alpha=0.5, **{'lambda': 0.5})
        self.perceive(0, 0, 45)
        self.perceive(0, 1, 0)  # cos(0)^3 = 1, half of it
        self.assertAlmostEqual(self.value(1), 0.5, places=12)
        self.perceive(0, 2, 0)  # an update of 0.5 in row 0
        self.assertAlmostEqual(self.value(0), 0.5, places=12)
        self.assertAlmostEqual(self.value(1), 0.725, places=12)  # 0.5 + 0.45 * 0.5
        self.perceive(1, 0, 45)
        self.perceive(1, 1, 0)  # 1 + 0.9 * 0.5 = 1.45, half-way from 0.725
        self.assertAlmostEqual(self.value(1), 1.0875, places=12)
        self.reset()
        self.perceive(1, 2, 0)
        self.perceive(1, 3, 0)  # half-way from 0.5 to 1.45
        self.assertAlmostEqual(self.value(0), 0.975, places=12)
        self.assertAlmostEqual(self.value(1), 1.0875, places=12)
        self.assertEqual(self.saved().header['decisions'], 4)

    def test_reset_without_decisions_succeeds(self):
        self.start_one()
        self.reset()
        answer = self.walk(0, 1)
        self.reset()
        self.assertEqual(self.walk(1, 1), answer)
        self.assertEqual(self.saved().header['decisions'], QTableFile(support.NEAREST_TABLE).header['decisions'])


class DemoThatLearnsTest(LearnerTestCase):
    """Training without exploration: agents walk greedily, and the table changes."""

    def test_started_by_services(self):
        """In row 1 the second action is the best one, until its rewards make the third one better."""
        table = self.write('table.txt', q_table_text({1: {1: (1, 2.0), 2: (1, 1.0)}}))
        self.start_one(q_table=table, mode='demo')
        first, second = math.radians(45), math.radians(90)
        self.assertEqual([answer[0][0] for answer in self.walk(0, 3)], [first] * 3)
        self.assertEqual(self.saved().rows, QTableFile(table).rows)
        self.succeed('learner/set_mode', mode='training')
        self.succeed('learner/set_learning_parameters', parameters='{alpha: 0.5, gamma: 0, epsilon: 0}')
        # The reward is cos(45 degrees)^3 = 0.354: the value falls to 1.177, then to 0.765.
        self.assertEqual([answer[0][0] for answer in self.walk(1, 3)], [first, first, second])
        visits, value = self.saved().rows[1][1]
        self.assertEqual(visits, 3)
        self.assertAlmostEqual(value, 0.5 + 0.75 * math.cos(math.radians(45))**3, places=12)

    def test_started_by_parameters(self):
        table = self.write('table.txt', q_table_text({1: {1: (1, 2.0), 2: (1, 1.0)}}))
        self.start_one(q_table=table, mode='training', epsilon=0.0, alpha=0.5, gamma=0.0)
        answers = [answer[0][0] for answer in self.walk(0, 3)]
        self.assertEqual(answers, [math.radians(45)] * 2 + [math.radians(90)])


if __name__ == '__main__':
    support.run('learner_services_test')
