#!/usr/bin/python3
"""Learners share Q-tables; common experience counts once."""
import threading

import support
from learning_files import QTableFile, config_text, q_table_text
from perceiving import Perceiver, add_agent, ahead, perceptions
from q_table_rows import MERGED, TABLE_A, TABLE_B, TableTestCase, full
from social_crowd.msg import LearnerStatus


class ShareTest(TableTestCase):
    """share_q_table between learner_a (agents 0 and 1) and learner_b (agents 2 and 3)."""

    def start_both(self, tables='own', **parameters):
        """Starts both learners, and waits until they know each other and have their tables."""
        self.a = self.write('a.txt', q_table_text(TABLE_A))
        self.b = self.write('b.txt', q_table_text(TABLE_B))
        self.start_learner('learner_a', q_table=self.a, agents=[0, 1], tables=tables)
        self.start_learner('learner_b', q_table=self.b, agents=[2, 3], tables=tables, **parameters)
        self.wait_until_known('learner_a', 0, 2)
        self.succeed('learner_b/load_q_table', file=self.b)

    def wait_until_known(self, learner, from_agent, to_agent):
        """Waits until a learner can share with another one, which then has its table."""
        support.wait_for(lambda: self.share(learner, from_agent, [to_agent], 'replace').success,
                         f'{learner} to know the learner of agent {to_agent}')

    def share(self, learner, from_agent, to_agents=(), method=''):
        """Calls share_q_table of a learner. Returns the response."""
        return self.call(f'{learner}/share_q_table', from_agent=from_agent, to_agents=list(to_agents), method=method)

    def rows_of_all(self):
        """Returns the rows by agent."""
        learners = {0: 'learner_a', 1: 'learner_a', 2: 'learner_b', 3: 'learner_b'}
        return {agent: self.saved(learner, agent) for agent, learner in learners.items()}

    def check_rows(self, *expected):
        """Checks the tables of all agents, in order."""
        self.assertEqual(self.rows_of_all(), {agent: full(rows) for agent, rows in enumerate(expected)})

    def test_shares_with_all_agents_by_default(self):
        self.start_both()
        response = self.share('learner_a', 0)
        self.assertTrue(response.success, response.message)
        self.assertEqual({0} | set(response.taken_by), {0, 1, 2, 3})
        self.assert_says(response.message, '1', '2', '3')
        self.check_rows(TABLE_A, TABLE_A, TABLE_A, TABLE_A)

    def test_shares_with_listed_agents(self):
        self.start_both()
        response = self.share('learner_a', 0, [3], 'replace')
        self.assertTrue(response.success, response.message)
        self.assertEqual(tuple(response.taken_by), (3,))
        self.assert_says(response.message, 'replaced the table of agent 3 (10 visits, 10 of them new)')
        self.check_rows(TABLE_A, TABLE_A, TABLE_B, TABLE_A)

    def test_merging_weights_by_visits(self):
        self.start_both()
        response = self.share('learner_a', 1, [2], 'merge')
        self.assertTrue(response.success, response.message)
        self.assert_says(response.message, 'merged into the table of agent 2 (13 visits, 10 of them new)')
        self.check_rows(TABLE_A, TABLE_A, MERGED, TABLE_B)

    def test_request_overrides_the_method_of_the_receiver(self):
        self.start_both(on_share='merge')
        self.assertTrue(self.share('learner_a', 0, [2]).success)
        self.assertTrue(self.share('learner_a', 0, [3], 'replace').success)
        self.check_rows(TABLE_A, TABLE_A, MERGED, TABLE_A)

    def test_shared_table_changes_for_all_agents(self):
        """A learner with a shared table takes the given table for all its agents."""
        self.start_both(tables='shared')
        response = self.share('learner_a', 0, [2], 'merge')
        self.assertTrue(response.success, response.message)
        self.assertEqual(set(response.taken_by), {2, 3})
        self.check_rows(TABLE_A, TABLE_A, MERGED, MERGED)

    def test_merging_within_a_shared_table_changes_nothing(self):
        self.start_both(tables='shared')
        response = self.share('learner_a', 0, [1], 'merge')
        self.assertTrue(response.success, response.message)
        self.check_rows(TABLE_A, TABLE_A, TABLE_B, TABLE_B)

    def test_unknown_agent_is_reported_and_others_take_the_table(self):
        self.start_both()
        response = self.share('learner_a', 0, [2, 77])
        self.assertFalse(response.success)
        self.assert_says(response.message, 'agent 77 did not get it: no learner serves agent 77')
        self.assertEqual(tuple(response.taken_by), (2,))
        self.check_rows(TABLE_A, TABLE_A, TABLE_A, TABLE_B)

    def test_source_is_refused_as_the_only_receiver(self):
        self.start_both()
        self.refuse('learner_a/share_q_table', 'agent 0 is the source', from_agent=0, to_agents=[0])

    def test_invalid_requests_change_nothing(self):
        self.start_both()
        self.refuse('learner_a/share_q_table', 'agent 2', from_agent=2)
        self.refuse('learner_a/share_q_table', 'replace or merge', 'mix', from_agent=0, method='mix')
        self.refuse('learner_b/take_q_table', 'line 1', q_table='no table')
        self.refuse('learner_b/take_q_table', 'checksum', q_table=support.read_text(self.a).replace('-2.5', '-2.4'))
        self.refuse('learner_b/take_q_table', 'agent 5', to_agents=[2, 5], q_table=support.read_text(self.a))
        self.check_rows(TABLE_A, TABLE_A, TABLE_B, TABLE_B)

    def test_killed_learner_is_reported_and_others_take_the_table(self):
        self.start_both()
        killed = self.start_learner('learner_c', q_table=self.b, agents=[4])
        self.wait_until_known('learner_a', 0, 4)
        killed.kill()
        response = self.share('learner_a', 0)
        self.assertFalse(response.success)
        self.assert_says(response.message, 'learner_c')
        self.assertEqual({0} | set(response.taken_by), {0, 1, 2, 3})
        self.check_rows(TABLE_A, TABLE_A, TABLE_A, TABLE_A)
        self.start_learner('learner_c', q_table=self.b, agents=[4])
        support.wait_for(lambda: self.share('learner_a', 0).success, 'sharing with the learner that came back')
        self.assertEqual(self.saved('learner_c', 4), full(TABLE_A))

    def test_learner_with_another_state_set_refuses_the_table(self):
        self.start_both()
        self.start_learner('learner_c', q_table=support.OCCUPANCY_TABLE, agents=[4])
        status = self.listen('learner_status', LearnerStatus)
        status.wait(lambda message: message.node.endswith('learner_c'))

        def is_told():
            response = self.share('learner_a', 0, [4])
            self.assertFalse(response.success)
            return 'another state set' in response.message and response

        response = support.wait_for(is_told, 'learner_a to know the learner of agent 4')
        self.assert_says(response.message, 'learner_c')
        self.assertEqual(tuple(response.taken_by), ())
        self.assertEqual(self.saved('learner_c', 4), QTableFile(support.OCCUPANCY_TABLE).rows)

    def test_concurrent_sharing_does_not_deadlock(self):
        """Each call waits for the other learner to take the table; there must be no deadlock."""
        # Large tables take some time, so that the calls overlap.
        self.start_learner('learner_a', q_table=support.OCCUPANCY_TABLE, agents=[0, 1])
        self.start_learner('learner_b', q_table=support.OCCUPANCY_TABLE, agents=[2, 3])
        self.wait_until_known('learner_a', 0, 2)
        self.wait_until_known('learner_b', 2, 0)
        start = threading.Barrier(12)
        tasks = [self.share_at_once(learner, agent, start)
                 for _ in range(6) for learner, agent in (('learner_a', 0), ('learner_b', 2))]
        for task in tasks:
            response = task.result('an answer of learners that share with each other')
            self.assertTrue(response.success, response.message)

    def share_at_once(self, learner, agent, start):
        """Shares in a separate thread after all threads have started."""
        def share():
            start.wait(support.PATIENCE)
            return self.share(learner, agent)

        return support.Task(share)


class SharedPastTest(TableTestCase):
    """Common experience of tables counts once. learner_a serves agent 0, learner_b agent 1."""

    TICKS = 6

    def start_both(self):
        """Starts both learners in training mode, and gives learner_b the table of learner_a."""
        config = self.write('config.yaml', config_text(support.CIRCLE6, 1))
        self.start_learner('learner_a', q_table=support.NEAREST_TABLE, mode='training', agents=[0])
        self.start_learner('learner_b', config=config, mode='training', agents=[1])
        self.past = QTableFile(support.NEAREST_TABLE).visits()
        message = support.wait_for(lambda: self.share('learner_a', [1], 'replace'), 'learner_a to know learner_b')
        self.assert_says(message, f'replaced the table of agent 1 ({self.past} visits, {self.past} of them new)')
        support.wait_for(lambda: self.share('learner_b', [0], 'merge'), 'learner_b to know learner_a')

    def share(self, learner, to_agents, method):
        """Shares with some agents. Returns the message of the response, or None after a failure."""
        response = self.call(f'{learner}/share_q_table', to_agents=to_agents, method=method)
        return response.message if response.success else None

    def visits(self, learner):
        """Returns the sum of visits of a learner's table."""
        self.succeed(f'{learner}/save_q_table', file=self.path('counted.txt'), overwrite=True)
        return QTableFile(self.path('counted.txt')).visits()

    def walk(self, perceiver, episode):
        """Both agents walk; each learner learns from one decision fewer than there are ticks."""
        for tick in range(self.TICKS):
            message = add_agent(perceptions(episode, tick), 0, ahead(45, 5))
            perceiver.tell(add_agent(message, 1, ahead(-90, 5)))
            support.wait_for(lambda: self.answered(perceiver, episode, tick) >= {0, 1}, f'answers of tick {tick}')

    @staticmethod
    def answered(perceiver, episode, tick):
        """Returns the agents in all answers."""
        return {action.agent for message in list(perceiver.actions.messages)
                if (message.episode, message.tick) == (episode, tick) for action in message.agents}

    def test_repeated_merges_change_nothing(self):
        """Without new decisions the visits do not change."""
        self.start_both()
        rows = self.saved('learner_a')
        for _ in range(3):
            for learner, agent in (('learner_a', 1), ('learner_b', 0)):
                self.assert_says(self.share(learner, [agent], 'merge'),
                                 f'merged into the table of agent {agent} ({self.past} visits, 0 of them new)')
        self.assertEqual((self.visits('learner_a'), self.visits('learner_b')), (self.past, self.past))
        self.assertEqual((self.saved('learner_a'), self.saved('learner_b', 1)), (rows, rows))

    def test_new_visits_count_once(self):
        self.start_both()
        perceiver = Perceiver(self, 2)
        self.walk(perceiver, 0)
        news = self.TICKS - 1
        self.assert_says(self.share('learner_a', [1], 'merge'), f'({self.past + 2 * news} visits, {news} of them new)')
        self.assert_says(self.share('learner_b', [0], 'merge'), f'({self.past + 2 * news} visits, {news} of them new)')
        self.walk(perceiver, 1)
        for _ in range(2):
            self.assertTrue(self.share('learner_a', [1], 'merge'))
            self.assertTrue(self.share('learner_b', [0], 'merge'))
        self.assertEqual(self.visits('learner_a'), self.past + 4 * news)
        self.assertEqual(self.visits('learner_b'), self.past + 4 * news)

    def test_saved_and_loaded_table_is_recognised(self):
        self.start_both()
        perceiver = Perceiver(self, 2)
        self.walk(perceiver, 0)
        news = self.TICKS - 1
        self.succeed('learner_a/save_q_table', file=self.path('on_the_way.txt'))
        self.walk(perceiver, 1)
        response = self.succeed('learner_b/load_q_table', file=self.path('on_the_way.txt'))
        self.assert_says(response.message, f'replaced the table of agent 1 ({self.past + news} visits, {news} of them')
        self.assert_says(self.share('learner_a', [1], 'merge'), f'({self.past + 2 * news} visits, {news} of them new)')
        self.assert_says(self.share('learner_b', [0], 'merge'), f'({self.past + 2 * news} visits, 0 of them new)')


if __name__ == '__main__':
    support.run('sharing_test')
