#!/usr/bin/python3
"""Learning parameters of a learner and its status."""
import math

import support
from learning_files import QTableFile, config_text
from perceiving import add_agent, ahead, perceptions
from teaching import LearnerTestCase


class LearningParametersTest(LearnerTestCase):
    """set_learning_parameters and learner_status."""

    def in_force(self):
        """Returns the parameters in the last status."""
        status = self.status.messages[-1]
        return status.alpha, status.gamma, status.trace_decay, status.epsilon

    def set_parameters(self, parameters):
        """Sets some of the parameters. Returns the message of the response."""
        return self.succeed('learner/set_learning_parameters', parameters=parameters).message

    def test_parameters_that_are_not_named_do_not_change(self):
        self.start_untrained()
        self.assertEqual(self.in_force(), (0.2, 0.9, 0.0, 0.0))
        self.assertEqual(self.set_parameters('{gamma: 0.5}'),
                         'changed gamma from 0.9 to 0.5; present values: {alpha: 0.2, alpha_decay: 0, gamma: 0.5, '
                         'lambda: 0, mirrored: false, ties: first, epsilon: 0}')
        self.status.wait(lambda status: status.gamma == 0.5)
        self.assertEqual(self.in_force(), (0.2, 0.5, 0.0, 0.0))
        self.set_parameters('{alpha: 0.25, lambda: 0.75, epsilon: 1}')
        self.status.wait(lambda status: status.alpha == 0.25)
        self.assertEqual(self.in_force(), (0.25, 0.5, 0.75, 1.0))
        self.assert_says(self.set_parameters('{}'), 'nothing changed', 'alpha: 0.25')
        self.assertEqual(self.in_force(), (0.25, 0.5, 0.75, 1.0))

    def test_all_parameters_can_be_set(self):
        self.start_untrained()
        self.assert_says(self.set_parameters('{alpha_decay: 0.5, mirrored: true, ties: random}'),
                         'alpha_decay from 0 to 0.5', 'mirrored from false to true', 'ties from first to random')
        header = self.saved().header
        self.assertEqual((header['alpha_decay'], header['mirrored'], header['ties']), (0.5, True, 'random'))

    def test_errors_name_key_range_and_value_and_change_nothing(self):
        self.start_untrained()
        service = 'learner/set_learning_parameters'
        self.refuse(service, 'alpha: expected a number above 0, at most 1, got 0', parameters='{alpha: 0}')
        self.refuse(service, "unknown key 'alfa'", 'alpha, alpha_decay, gamma, lambda, mirrored, ties, epsilon',
                    parameters='{alfa: 0.1}')
        self.refuse(service, "gamma: expected a number, got '.nan'", parameters='{gamma: .nan}')
        self.refuse(service, 'expected a map', parameters='')
        # One invalid value makes the whole request invalid.
        self.refuse(service, 'gamma: expected', 'got 1', parameters='{alpha: 0.5, gamma: 1}')
        self.set_parameters('{epsilon: 0.125}')
        self.status.wait(lambda status: status.epsilon == 0.125)
        self.assertEqual(self.in_force(), (0.2, 0.9, 0.0, 0.125))

    def test_new_parameters_take_effect(self):
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

    def test_contains_model_parameters_and_counts(self):
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

    def test_lists_agents_that_a_learner_of_all_has_served(self):
        self.start_one()
        self.assertEqual((self.status.messages[-1].serves_all, tuple(self.status.messages[-1].agents)), (True, ()))
        self.perceiver.ask(add_agent(add_agent(perceptions(7, 3), 5, ahead(0, 1)), 2, ahead(0, 1)))
        status = self.status.wait(lambda message: message.episode == 7)
        self.assertEqual((status.serves_all, tuple(status.agents), status.tick), (True, (2, 5), 3))


if __name__ == '__main__':
    support.run('learning_parameters_test')
