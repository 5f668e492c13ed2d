#!/usr/bin/python3
"""Q-tables are saved, loaded and shared; what does not fit is refused, and the table stays."""
import os
import re
import threading

import support
from learning_files import QTableFile, config_text, q_table_text
from perceiving import Perceiver, add_agent, ahead, all_situations, perceptions
from social_crowd.msg import LearnerStatus

TABLE_A = {0: {0: (3, 1.0)}, 5: {2: (7, -2.5)}}  # {row: {action: (visits, value)}}
TABLE_B = {0: {0: (1, 5.0)}, 9: {1: (2, 0.25)}}
MERGED = {0: {0: (4, 2.0)}, 5: {2: (7, -2.5)}, 9: {1: (2, 0.25)}}  # means weighted by visits; visits add up


def full(rows):
    """Rows as a file holds them, with all actions."""
    return {row: [actions.get(action, (0, 0.0)) for action in range(8)] for row, actions in rows.items()}


class TableTestCase(support.CrowdTestCase):
    """Saves tables to look at them."""

    def saved(self, learner, agent=0):
        """The rows of an agent's table."""
        file = self.path('saved.txt')
        self.succeed(f'{learner}/save_q_table', file=file, agent=agent)
        return QTableFile(file).rows


class SaveAndLoadTest(TableTestCase):
    """save_q_table and load_q_table of one learner."""

    def trained_table(self):
        """A table that decides otherwise than the thesis's."""
        scenario = support.in_package('config', 'scenarios', 'training_single.yaml')
        config = self.write('config.yaml', config_text(scenario, 20))
        self.tool('train', config, '--output', self.path('trained.txt'))
        return self.path('trained.txt')

    def test_a_saved_table_decides_alike_elsewhere(self):
        self.start_learner('learner_a', q_table=self.trained_table(), agents=list(range(136)))
        by_a = Perceiver(self).ask(all_situations())
        self.assertEqual(len(by_a), 136)
        self.succeed('learner_a/save_q_table', file=self.path('table.txt'))
        self.assertEqual(self.processes[-1].stop(), 0)

        self.start_learner('learner_b')
        perceiver = Perceiver(self)
        self.assertNotEqual(perceiver.ask(all_situations(tick=1)), by_a, 'the tables should differ before')
        response = self.succeed('learner_b/load_q_table', file=self.path('table.txt'))
        self.assert_says(response.message, self.path('table.txt'))
        self.assertEqual(perceiver.ask(all_situations(tick=2)), by_a)
        self.assertEqual(self.saved('learner_b'), QTableFile(self.path('table.txt')).rows)

    def test_saved_twice_is_the_same_file(self):
        """A table read and written again loses no bit."""
        self.start_learner()
        self.succeed('learner/save_q_table', file=self.path('first.txt'))
        self.succeed('learner/load_q_table', file=self.path('first.txt'))
        self.succeed('learner/save_q_table', file=self.path('second.txt'))
        self.assertEqual(support.read_text(self.path('first.txt')), support.read_text(self.path('second.txt')))
        self.assertEqual(QTableFile(self.path('first.txt')).rows, QTableFile(support.NEAREST_TABLE).rows)

    def bad_files(self):
        """Files that are no tables for this learner: name, content."""
        good = support.read_text(support.NEAREST_TABLE)
        lines = good.splitlines(keepends=True)
        changed = lines[20].replace(' ', ' 1', 1)
        other_actions = good.replace('rotations: 8', 'rotations: 4')
        return {
            'empty.txt': '',
            'cut_short.txt': good[:len(good) // 2],
            'a_line_less.txt': ''.join(lines[:20] + lines[21:]),
            'changed.txt': ''.join(lines[:20] + [changed] + lines[21:]),
            'more_after_the_end.txt': good + 'more\n',
            'another_version.txt': good.replace('Q-table 1', 'Q-table 2', 1),
            'not_a_table.txt': 'name: circle6\n',
            'not_finite.txt': q_table_text({0: {0: (1, float('inf'))}}),
            'another_action_set.txt': other_actions,
        }

    def test_bad_files_are_refused_and_the_table_stays(self):
        self.start_learner()
        perceiver = Perceiver(self)
        before = perceiver.ask(all_situations()), self.saved('learner')
        for name, content in self.bad_files().items():
            self.refuse('learner/load_q_table', name, file=self.write(name, content))
        self.refuse('learner/load_q_table', 'no_such_file.txt', file=self.path('no_such_file.txt'))
        self.refuse('learner/load_q_table', self.folder, file=self.folder)
        self.refuse('learner/load_q_table', support.OCCUPANCY_TABLE, 'another state set', file=support.OCCUPANCY_TABLE)
        after = perceiver.ask(all_situations(tick=1)), self.saved('learner')
        self.assertEqual(after, before)

    def test_a_file_that_cannot_be_written_is_told(self):
        self.start_learner()
        self.refuse('learner/save_q_table', 'file', file='')
        self.refuse('learner/load_q_table', 'file', file='')
        self.refuse('learner/save_q_table', support.NEAREST_TABLE, file=support.NEAREST_TABLE + '/table.txt')

    def test_own_tables_are_saved_by_agent(self):
        self.start_learner(q_table=self.write('a.txt', q_table_text(TABLE_A)), tables='own', agents=[4])
        self.assertEqual(self.saved('learner', agent=4), full(TABLE_A))
        self.refuse('learner/save_q_table', 'agent 3 is not served by', 'it serves agent 4',
                    file=self.path('saved.txt'), agent=3)

    def test_the_only_agent_need_not_be_named(self):
        self.start_learner(q_table=self.write('a.txt', q_table_text(TABLE_A)), tables='own', agents=[4])
        response = self.succeed('learner/save_q_table', file=self.path('saved.txt'))
        self.assert_says(response.message, 'agent 4', self.path('saved.txt'))
        self.assertEqual(QTableFile(self.path('saved.txt')).rows, full(TABLE_A))
        self.assert_says(self.succeed('learner/share_q_table').message, 'the Q-table of agent 4')

    def test_the_table_of_a_learner_of_one_agent_is_that_agents(self):
        self.start_learner(agents=[4])
        response = self.succeed('learner/save_q_table', file=self.path('saved.txt'))
        self.assert_says(response.message, 'of the table of agent 4 to ')

    def test_one_of_many_must_be_named(self):
        self.start_learner(q_table=self.write('a.txt', q_table_text(TABLE_A)), tables='own', agents=[4, 5])
        for service in ('save_q_table', 'share_q_table'):
            request = {'file': self.path('saved.txt')} if service == 'save_q_table' else {}
            self.refuse(f'learner/{service}', 'agent 0 is not served by', 'it serves agents 4, 5', **request)

    def test_replies_name_the_absolute_path(self):
        """A path is relative to the learner's working directory."""
        self.start_learner()
        file = os.path.relpath(self.path('table.txt'), os.getcwd())
        self.assert_says(self.succeed('learner/save_q_table', file=file).message, f' to {self.path("table.txt")}')
        self.assert_says(self.succeed('learner/load_q_table', file=file).message, f' from {self.path("table.txt")}:')
        self.refuse('learner/load_q_table', f'{self.path("none.txt")}: ', file=os.path.relpath(self.path('none.txt')))

    def test_nothing_is_told_of_files_that_are_no_q_tables(self):
        self.start_learner()
        for secret in ('password: secret\n', 'secret', 'social_crowd Q-table of secrets\n'):
            response = self.refuse('learner/load_q_table', 'no Q-table of this package', "'social_crowd Q-table 1'",
                                   file=self.write('private.txt', secret))
            self.assertNotIn('secret', response.message)
        response = self.refuse('learner/take_q_table', 'no Q-table of this package', q_table='secret\n')
        self.assertNotIn('secret', response.message)


class ShareTest(TableTestCase):
    """share_q_table between learner_a (agents 0 and 1) and learner_b (agents 2 and 3)."""

    def start_both(self, tables='own', **parameters):
        """Starts both; they know each other then, and each has its table."""
        self.a = self.write('a.txt', q_table_text(TABLE_A))
        self.b = self.write('b.txt', q_table_text(TABLE_B))
        self.start_learner('learner_a', q_table=self.a, agents=[0, 1], tables=tables)
        self.start_learner('learner_b', q_table=self.b, agents=[2, 3], tables=tables, **parameters)
        self.wait_until_known('learner_a', 0, 2)
        self.succeed('learner_b/load_q_table', file=self.b)

    def wait_until_known(self, learner, from_agent, to_agent):
        """Waits until a learner can share with another one; that one has its table then."""
        support.wait_for(lambda: self.share(learner, from_agent, [to_agent], 'replace').success,
                         f'{learner} to know the learner of agent {to_agent}')

    def share(self, learner, from_agent, to_agents=(), method=''):
        """Asks a learner to share."""
        return self.call(f'{learner}/share_q_table', from_agent=from_agent, to_agents=list(to_agents), method=method)

    def rows_of_all(self):
        """Rows by agent."""
        learners = {0: 'learner_a', 1: 'learner_a', 2: 'learner_b', 3: 'learner_b'}
        return {agent: self.saved(learner, agent) for agent, learner in learners.items()}

    def check_rows(self, *expected):
        """Checks the tables of all agents, in order."""
        self.assertEqual(self.rows_of_all(), {agent: full(rows) for agent, rows in enumerate(expected)})

    def test_to_everybody(self):
        self.start_both()
        response = self.share('learner_a', 0)
        self.assertTrue(response.success, response.message)
        self.assertEqual({0} | set(response.taken_by), {0, 1, 2, 3})
        self.assert_says(response.message, '1', '2', '3')
        self.check_rows(TABLE_A, TABLE_A, TABLE_A, TABLE_A)

    def test_to_a_list(self):
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

    def test_each_receiver_may_choose_the_method(self):
        self.start_both(on_share='merge')
        self.assertTrue(self.share('learner_a', 0, [2]).success)
        self.assertTrue(self.share('learner_a', 0, [3], 'replace').success)
        self.check_rows(TABLE_A, TABLE_A, MERGED, TABLE_A)

    def test_shared_tables(self):
        """With a shared table whoever gets it gives it to all agents of its learner."""
        self.start_both(tables='shared')
        response = self.share('learner_a', 0, [2], 'merge')
        self.assertTrue(response.success, response.message)
        self.assertEqual(set(response.taken_by), {2, 3})
        self.check_rows(TABLE_A, TABLE_A, MERGED, MERGED)

    def test_merging_within_a_shared_table_counts_nothing_twice(self):
        self.start_both(tables='shared')
        response = self.share('learner_a', 0, [1], 'merge')
        self.assertTrue(response.success, response.message)
        self.check_rows(TABLE_A, TABLE_A, TABLE_B, TABLE_B)

    def test_an_unknown_agent_is_told_and_the_others_take_it(self):
        self.start_both()
        response = self.share('learner_a', 0, [2, 77])
        self.assertFalse(response.success)
        self.assert_says(response.message, 'agent 77 did not get it: no learner serves agent 77')
        self.assertEqual(tuple(response.taken_by), (2,))
        self.check_rows(TABLE_A, TABLE_A, TABLE_A, TABLE_B)

    def test_the_one_who_shares_need_not_be_given_it(self):
        self.start_both()
        self.refuse('learner_a/share_q_table', 'agent 0 is the one who shares it', from_agent=0, to_agents=[0])

    def test_bad_requests_change_nothing(self):
        self.start_both()
        self.refuse('learner_a/share_q_table', 'agent 2', from_agent=2)
        self.refuse('learner_a/share_q_table', 'replace or merge', 'mix', from_agent=0, method='mix')
        self.refuse('learner_b/take_q_table', 'line 1', q_table='no table')
        self.refuse('learner_b/take_q_table', 'checksum', q_table=support.read_text(self.a).replace('-2.5', '-2.4'))
        self.refuse('learner_b/take_q_table', 'agent 5', to_agents=[2, 5], q_table=support.read_text(self.a))
        self.check_rows(TABLE_A, TABLE_A, TABLE_B, TABLE_B)

    def test_a_learner_that_was_killed_is_told_and_the_others_take_it(self):
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

    def test_a_learner_of_another_state_set_refuses(self):
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

    def test_many_share_with_each_other_at_the_same_time(self):
        """Each call waits for the other learner to take the table: nobody may wait for ever."""
        # Large tables take a while, so that all calls are under way at once.
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
        """Shares in a thread of its own as soon as all threads are there."""
        def share():
            start.wait(support.PATIENCE)
            return self.share(learner, agent)

        return support.Task(share)


class SharedPastTest(TableTestCase):
    """What tables have in common counts once. learner_a serves agent 0, learner_b agent 1."""

    TICKS = 6

    def start_both(self):
        """Starts both, which learn; they know each other then, and learner_b has the table of learner_a."""
        config = self.write('config.yaml', config_text(support.CIRCLE6, 1))
        self.start_learner('learner_a', q_table=support.NEAREST_TABLE, mode='training', agents=[0])
        self.start_learner('learner_b', config=config, mode='training', agents=[1])
        self.past = QTableFile(support.NEAREST_TABLE).visits()
        told = support.wait_for(lambda: self.share('learner_a', [1], 'replace'), 'learner_a to know learner_b')
        self.assert_says(told, f'replaced the table of agent 1 ({self.past} visits, {self.past} of them new)')
        support.wait_for(lambda: self.share('learner_b', [0], 'merge'), 'learner_b to know learner_a')

    def share(self, learner, to_agents, method):
        """Shares with some agents; what the learner says, nothing if they did not take it."""
        response = self.call(f'{learner}/share_q_table', to_agents=to_agents, method=method)
        return response.message if response.success else None

    def visits(self, learner):
        """All visits of a learner's table."""
        self.succeed(f'{learner}/save_q_table', file=self.path('counted.txt'))
        return QTableFile(self.path('counted.txt')).visits()

    def walk(self, perceiver, episode):
        """Both agents walk; each learns from one decision less than there are ticks."""
        for tick in range(self.TICKS):
            message = add_agent(perceptions(episode, tick), 0, ahead(45, 5))
            perceiver.tell(add_agent(message, 1, ahead(-90, 5)))
            support.wait_for(lambda: self.answered(perceiver, episode, tick) >= {0, 1}, f'answers of tick {tick}')

    @staticmethod
    def answered(perceiver, episode, tick):
        """Agents that were answered for."""
        return {action.agent for message in list(perceiver.actions.messages)
                if (message.episode, message.tick) == (episode, tick) for action in message.agents}

    def test_replaced_then_merged_three_times(self):
        """Nobody walks meanwhile: visits stay what they are."""
        self.start_both()
        rows = self.saved('learner_a')
        for _ in range(3):
            for learner, agent in (('learner_a', 1), ('learner_b', 0)):
                self.assert_says(self.share(learner, [agent], 'merge'),
                                 f'merged into the table of agent {agent} ({self.past} visits, 0 of them new)')
        self.assertEqual((self.visits('learner_a'), self.visits('learner_b')), (self.past, self.past))
        self.assertEqual((self.saved('learner_a'), self.saved('learner_b', 1)), (rows, rows))

    def test_what_each_learned_since_counts_once(self):
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

    def test_a_file_on_the_way_is_recognised(self):
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


class SaveToTest(support.CrowdTestCase):
    """~save_to and ~save_every."""

    def test_tables_are_saved_on_the_way_and_at_the_end(self):
        scenario = support.in_package('config', 'scenarios', 'training_single.yaml')
        file = self.path('table.txt')
        learner = self.start_learner(mode='training', save_to=file, save_every=2)
        controller = self.start_controller(scenario, episodes=3)
        self.assertEqual(controller.wait(), 0)
        support.wait_for(lambda: os.path.exists(file), 'the table after two episodes')
        on_the_way = QTableFile(file)
        told = rf'\[ INFO\] \[[\d.]+\]: saved \d+ visited rows of {on_the_way.header["rows"]} to {re.escape(file)}\n'
        support.wait_for(lambda: re.search(told, learner.output()), 'the message that it was saved')
        self.assertEqual(learner.stop(), 0)
        self.assertEqual(len(re.findall(told, learner.output())), 2, learner.output())
        at_the_end = QTableFile(file)
        before = QTableFile(support.NEAREST_TABLE)
        self.assertGreater(on_the_way.header['decisions'], before.header['decisions'])
        self.assertGreater(at_the_end.header['decisions'], on_the_way.header['decisions'])

    def test_the_message_names_the_absolute_path(self):
        learner = self.start_learner(save_to=os.path.relpath(self.path('table.txt')))
        self.listen('learner_status', LearnerStatus).wait()
        self.assertEqual(learner.stop(), 0)
        self.assert_says(learner.output(), f' to {self.path("table.txt")}\n')

    def test_that_it_cannot_be_saved_is_told_after_ctrl_c(self):
        os.mkdir(self.path('folder'))
        learner = self.start_learner(save_to=self.path('folder/table.txt'))
        self.listen('learner_status', LearnerStatus).wait()
        os.rmdir(self.path('folder'))
        self.assertEqual(learner.stop(), 1)
        self.assert_says(learner.output(), '[FATAL]', f'{self.path("folder/table.txt")}: cannot be written',
                         f'there is no folder {self.path("folder")}\n')


if __name__ == '__main__':
    support.run('q_tables_test')
