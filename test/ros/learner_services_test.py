#!/usr/bin/python3
"""A learner driven by hand: training and demo mode, learning parameters, status, perceptions that make no sense."""
import math

import support
from learning_files import QTableFile, config_text, q_table_text
from perceiving import Perceiver, add_agent, ahead, all_situations, perceptions
from rosgraph_msgs.msg import Log
from social_crowd.msg import LearnerStatus

NAN = float('nan')


class LearnerTestCase(support.CrowdTestCase):
    """One learner, and a stand-in for the crowd controller."""

    def start_one(self, **parameters):
        """Starts the learner."""
        self.status = self.listen('learner_status', LearnerStatus)
        self.start_learner(**parameters)
        self.perceiver = Perceiver(self)
        self.status.wait()

    def start_untrained(self, **parameters):
        """Starts a learner that knows nothing and explores nothing."""
        config = self.write('config.yaml', config_text(support.CIRCLE6, 1))
        self.start_one(config=config, mode='training', epsilon=0.0, **parameters)

    def saved(self):
        """The learner's table."""
        self.succeed('learner/save_q_table', file=self.path('saved.txt'))
        return QTableFile(self.path('saved.txt'))

    def walk(self, episode, ticks, acted=True):
        """An agent that has its goal 45 degrees to the left, tick for tick; its answers."""
        return [self.perceiver.ask(add_agent(perceptions(episode, tick), 0, ahead(45, 5), acted=acted))
                for tick in range(ticks)]


class ModeTest(LearnerTestCase):
    """Training mode changes the table, demo mode does not."""

    def test_training_learns_from_what_followed(self):
        self.start_untrained(alpha=0.5)
        self.walk(0, 4)  # the last decision has not shown yet what it leads to
        table = self.saved()
        self.assertEqual(table.header['decisions'], 3)
        self.assertEqual(table.visits(), 3)
        self.assertEqual(set(table.rows), {1})  # the goal in sector 1, nothing perceived

    def test_a_single_update_by_hand(self):
        """The value goes half-way from 0 to the reward, cos(45 degrees)^3; what comes later is worth 0 so far."""
        self.start_untrained(alpha=0.5)
        self.walk(0, 2)
        table = self.saved()
        self.assertEqual(set(table.rows), {1})
        visits, value = table.rows[1][0]
        self.assertEqual(visits, 1)
        self.assertAlmostEqual(value, 0.5 * math.cos(math.radians(45))**3, places=12)

    def test_arriving_is_learned_from(self):
        self.start_untrained(alpha=0.5)
        self.walk(0, 1)
        self.perceiver.tell(add_agent(perceptions(0, 1, last=True), 0, ahead(45, 0.1), arrived=True))
        support.wait_for(lambda: self.saved().header['decisions'] == 1, 'the arrival to be learned from')
        self.assertEqual(self.saved().rows[1][0], (1, 50.0))

    def test_what_was_not_carried_out_teaches_nothing(self):
        self.start_untrained()
        self.walk(0, 5, acted=False)
        self.assertEqual(self.saved().visits(), 0)

    def test_a_gap_between_ticks_teaches_nothing(self):
        self.start_untrained()
        for tick in (0, 2, 4, 5):
            self.perceiver.ask(add_agent(perceptions(0, tick), 0, ahead(45, 5)))
        self.assertEqual(self.saved().visits(), 1)

    def test_demo_mode_learns_nothing(self):
        self.start_one(mode='demo')
        before = support.read_text(support.NEAREST_TABLE)
        self.walk(0, 5)
        self.succeed('learner/save_q_table', file=self.path('saved.txt'))
        rows = [text.partition('---')[2].rpartition('checksum')[0]
                for text in (before, support.read_text(self.path('saved.txt')))]
        self.assertEqual(rows[0], rows[1])

    def test_modes_can_be_switched(self):
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
        support.wait_for(lambda: self.status.messages[-1].mode == 'training', 'a status that tells of training')

    def test_an_unknown_mode_is_refused(self):
        self.start_untrained()
        self.refuse('learner/set_mode', 'training or demo', 'walking', mode='walking')
        self.walk(0, 3)
        self.assertEqual(self.saved().visits(), 2)


class ResetTracesTest(LearnerTestCase):
    """reset_traces: nothing is learned across the gap."""

    def perceive(self, episode, tick, degrees):
        """A tick of an agent alone that has its goal at a bearing: row 0 straight ahead, row 1 at 45 degrees."""
        self.perceiver.ask(add_agent(perceptions(episode, tick), 0, ahead(degrees, 5)))

    def value(self, row):
        """What the first action is worth."""
        table = self.saved()
        return table.rows[row][0][1] if row in table.rows else 0.0

    def reset(self):
        """Calls the service."""
        self.assert_says(self.succeed('learner/reset_traces').message, 'traces', 'decisions', 'values stay')

    def test_the_decision_before_it_is_not_learned_from(self):
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

    def test_earlier_decisions_are_not_reached_by_what_comes_after_it(self):
        """Corrections go half of the way; 0.9 * 0.5 = 0.45 of one reaches the decision before."""
        self.start_untrained(alpha=0.5, **{'lambda': 0.5})
        self.perceive(0, 0, 45)
        self.perceive(0, 1, 0)  # cos(0)^3 = 1, half of it
        self.assertAlmostEqual(self.value(1), 0.5, places=12)
        self.perceive(0, 2, 0)  # a correction of 0.5 in row 0
        self.assertAlmostEqual(self.value(0), 0.5, places=12)
        self.assertAlmostEqual(self.value(1), 0.725, places=12)  # 0.5 + 0.45 * 0.5
        self.perceive(1, 0, 45)
        self.perceive(1, 1, 0)  # 1 + 0.9 * 0.5 = 1.45, half of the way from 0.725
        self.assertAlmostEqual(self.value(1), 1.0875, places=12)
        self.reset()
        self.perceive(1, 2, 0)
        self.perceive(1, 3, 0)  # half of the way from 0.5 to 1.45
        self.assertAlmostEqual(self.value(0), 0.975, places=12)
        self.assertAlmostEqual(self.value(1), 1.0875, places=12)
        self.assertEqual(self.saved().header['decisions'], 4)

    def test_it_does_no_harm_where_there_is_nothing_to_forget(self):
        self.start_one()
        self.reset()
        answer = self.walk(0, 1)
        self.reset()
        self.assertEqual(self.walk(1, 1), answer)
        self.assertEqual(self.saved().header['decisions'], QTableFile(support.NEAREST_TABLE).header['decisions'])


class DemoThatLearnsTest(LearnerTestCase):
    """Training without exploration: agents walk by the table, which goes on changing."""

    def test_it_begins_by_services(self):
        """In row 1 the second action is the best one, until what it brings makes the third one better."""
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

    def test_it_begins_by_parameters(self):
        table = self.write('table.txt', q_table_text({1: {1: (1, 2.0), 2: (1, 1.0)}}))
        self.start_one(q_table=table, mode='training', epsilon=0.0, alpha=0.5, gamma=0.0)
        answers = [answer[0][0] for answer in self.walk(0, 3)]
        self.assertEqual(answers, [math.radians(45)] * 2 + [math.radians(90)])


class LearningParametersTest(LearnerTestCase):
    """set_learning_parameters and what learner_status tells of it."""

    def in_force(self):
        """The parameters that the status tells last."""
        status = self.status.messages[-1]
        return status.alpha, status.gamma, status.trace_decay, status.epsilon

    def set_parameters(self, parameters):
        """Sets some of the parameters; the answer."""
        return self.succeed('learner/set_learning_parameters', parameters=parameters).message

    def test_what_is_not_named_stays_as_it_is(self):
        self.start_untrained()
        self.assertEqual(self.in_force(), (0.2, 0.9, 0.0, 0.0))
        self.assertEqual(self.set_parameters('{gamma: 0.5}'),
                         'changed gamma from 0.9 to 0.5; in force are {alpha: 0.2, alpha_decay: 0, gamma: 0.5, '
                         'lambda: 0, mirrored: false, ties: first, epsilon: 0}')
        self.status.wait(lambda status: status.gamma == 0.5)
        self.assertEqual(self.in_force(), (0.2, 0.5, 0.0, 0.0))
        self.set_parameters('{alpha: 0.25, lambda: 0.75, epsilon: 1}')
        self.status.wait(lambda status: status.alpha == 0.25)
        self.assertEqual(self.in_force(), (0.25, 0.5, 0.75, 1.0))
        self.assert_says(self.set_parameters('{}'), 'nothing changed', 'alpha: 0.25')
        self.assertEqual(self.in_force(), (0.25, 0.5, 0.75, 1.0))

    def test_the_other_parameters_may_be_named_too(self):
        self.start_untrained()
        self.assert_says(self.set_parameters('{alpha_decay: 0.5, mirrored: true, ties: random}'),
                         'alpha_decay from 0 to 0.5', 'mirrored from false to true', 'ties from first to random')
        header = self.saved().header
        self.assertEqual((header['alpha_decay'], header['mirrored'], header['ties']), (0.5, True, 'random'))

    def test_an_error_names_key_range_and_value_and_changes_nothing(self):
        self.start_untrained()
        service = 'learner/set_learning_parameters'
        self.refuse(service, 'alpha: expected a number above 0, at most 1, got 0', parameters='{alpha: 0}')
        self.refuse(service, "unknown key 'alfa'", 'alpha, alpha_decay, gamma, lambda, mirrored, ties, epsilon',
                    parameters='{alfa: 0.1}')
        self.refuse(service, "gamma: expected a number, got '.nan'", parameters='{gamma: .nan}')
        self.refuse(service, 'expected a map', parameters='')
        # One bad value spoils the whole request.
        self.refuse(service, 'gamma: expected', 'got 1', parameters='{alpha: 0.5, gamma: 1}')
        self.set_parameters('{epsilon: 0.125}')
        self.status.wait(lambda status: status.epsilon == 0.125)
        self.assertEqual(self.in_force(), (0.2, 0.9, 0.0, 0.125))

    def test_they_take_effect(self):
        self.start_untrained()
        self.set_parameters('{alpha: 1, gamma: 0}')
        self.walk(0, 2)
        self.assertAlmostEqual(self.saved().rows[1][0][1], math.cos(math.radians(45))**3, places=12)

    def test_epsilon_set_while_running_replaces_the_schedule(self):
        learning = '{alpha: 0.2, epsilon: {from: 0.8, to: 0.2, episodes: 10}}'
        config = self.write('schedule.yaml', config_text(support.CIRCLE6, 1, learning=learning))
        self.start_one(config=config, mode='training')
        self.walk(5, 1)
        self.status.wait(lambda status: status.episode == 5 and abs(status.epsilon - 0.5) < 1e-12)
        self.assert_says(self.set_parameters('{gamma: 0.5}'), 'changed gamma from 0.1 to 0.5;', 'to: 0.2')
        self.walk(7, 1)
        self.set_parameters('{}')
        self.status.wait(lambda status: status.episode == 7 and abs(status.epsilon - 0.38) < 1e-12)
        self.set_parameters('{epsilon: 0}')
        self.walk(6, 1)
        self.set_parameters('{}')
        self.status.wait(lambda status: status.episode == 6 and status.epsilon == 0.0)


class StatusTest(LearnerTestCase):
    """learner_status."""

    def test_it_tells_all(self):
        self.start_one(agents=[3, 1])
        status = self.status.messages[-1]
        self.assertEqual(status.header.frame_id, 'map')
        self.assertGreater(status.header.stamp.to_sec(), 0)
        self.assertEqual(status.node, f'{self.namespace}/learner')
        self.assertEqual((status.mode, status.tables), ('demo', 'shared'))
        self.assertEqual((status.serves_all, tuple(status.agents)), (False, (1, 3)))
        table = QTableFile(support.NEAREST_TABLE)
        self.assertEqual((status.rows, status.actions), (137, 8))
        self.assertEqual(status.visited_rows, table.header['visited_rows'])
        self.assertEqual(status.decisions, table.header['decisions'])
        self.assert_says(status.model, 'state_set: {type: nearest_obstacle', 'action_set: {type: kings_moves', 'reward')

    def test_it_tells_whom_a_learner_of_all_has_met(self):
        self.start_one()
        self.assertEqual((self.status.messages[-1].serves_all, tuple(self.status.messages[-1].agents)), (True, ()))
        self.perceiver.ask(add_agent(add_agent(perceptions(7, 3), 5, ahead(0, 1)), 2, ahead(0, 1)))
        status = self.status.wait(lambda message: message.episode == 7)
        self.assertEqual((status.serves_all, tuple(status.agents), status.tick), (True, (2, 5), 3))


class PerceptionsTest(LearnerTestCase):
    """What a learner answers, and that nothing it is told breaks it."""

    def test_only_its_agents_are_answered_for(self):
        self.start_one(agents=[1, 3])
        message = perceptions(0, 0)
        for agent in range(5):
            add_agent(message, agent, ahead(0, 5))
        self.assertEqual(set(self.perceiver.ask(message)), {1, 3})

    def test_who_has_arrived_is_not_answered_for(self):
        self.start_one()
        message = add_agent(add_agent(perceptions(0, 1), 0, ahead(0, 0.1), arrived=True), 1, ahead(0, 5))
        self.assertEqual(set(self.perceiver.ask(message)), {1})

    def test_the_last_perceptions_are_not_answered(self):
        self.start_one()
        self.walk(0, 1)
        self.perceiver.tell(add_agent(perceptions(0, 1, last=True), 0, ahead(0, 5)))
        self.walk(1, 1)  # answered after the last ones of episode 0 would have been
        answered = [(answer.episode, answer.tick) for answer in self.perceiver.actions.messages]
        self.assertEqual(answered, [(0, 0), (1, 0)])

    def test_the_answer_names_what_it_answers(self):
        self.start_one(q_table=self.write('back.txt', q_table_text({4: {4: (1, 1.0)}})))  # goal behind: turn round
        message = add_agent(perceptions(2**40, 2**33), 0, ahead(180, 5))
        message.run = 2**63 + 1
        rotation, speed_fraction = self.perceiver.ask(message)[0]
        self.assertAlmostEqual(abs(rotation), math.pi)
        self.assertEqual(speed_fraction, 1.0)
        answer = self.perceiver.actions.messages[-1]
        self.assertEqual((answer.header.frame_id, answer.header.stamp), ('map', message.header.stamp))
        self.assertEqual(answer.run, message.run)

    def senseless(self):
        """Perceptions that contradict themselves or hold what is no number; each in a tick of its own."""
        beyond = add_agent(perceptions(0, 1), 0, ahead(0, 5), ahead(0, 1))
        beyond.agents[0].neighbour_count = 2**32 - 1
        walls = add_agent(perceptions(0, 2), 0, ahead(0, 5))
        walls.agents[0].first_wall = 2**32 - 1
        walls.agents[0].wall_count = 1
        nobody = add_agent(perceptions(0, 3), 2**32 - 1, ahead(0, 5))
        no_goal = add_agent(perceptions(0, 4), 0, (NAN, 1.0))
        infinite = add_agent(perceptions(0, 5), 0, (float('inf'), 1.0))
        return [beyond, walls, nobody, no_goal, infinite]

    def test_senseless_perceptions_are_dropped_with_a_word(self):
        log = self.listen('/rosout', Log)
        self.start_one()
        log.wait_connected()
        before = self.perceiver.ask(all_situations())
        for message in self.senseless():
            self.perceiver.tell(message)
        after = self.perceiver.ask(all_situations(tick=9))
        self.assertEqual(after, before)
        self.assertEqual([answer.tick for answer in self.perceiver.actions.messages], [0, 9])
        name = f'{self.namespace}/learner'
        log.wait(lambda entry: entry.name == name and 'perceptions were dropped' in entry.msg, 'on what was dropped')

    def test_bodies_that_are_no_numbers_do_no_harm(self):
        self.start_one()
        for tick, place in enumerate([(NAN, 0.0), (float('inf'), 0.0), (0.0, 0.0)]):
            message = add_agent(perceptions(0, tick), 0, ahead(0, 5), place)
            self.perceiver.tell(message)
        self.perceiver.ask(add_agent(perceptions(0, 9), 0, ahead(0, 5)))
        for answer in self.perceiver.actions.messages:
            self.assertTrue(math.isfinite(answer.agents[0].rotation), f'the answer of tick {answer.tick}')


if __name__ == '__main__':
    support.run('learner_services_test')
