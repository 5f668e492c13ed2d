#!/usr/bin/python3
"""Q-tables are saved and loaded; a file that does not fit is refused, and the table does not change."""
import os
import re

import support
from learning_files import QTableFile, config_text, q_table_text
from perceiving import Perceiver, all_situations
from q_table_rows import TABLE_A, TableTestCase, full
from social_crowd.msg import LearnerStatus


class SaveAndLoadTest(TableTestCase):
    """save_q_table and load_q_table of one learner."""

    def trained_table(self):
        """Returns a table that gives other decisions than that of the thesis."""
        scenario = support.in_package('config', 'scenarios', 'training_single.yaml')
        config = self.write('config.yaml', config_text(scenario, 20))
        self.tool('train', config, '--output', self.path('trained.txt'))
        return self.path('trained.txt')

    def test_loaded_table_gives_the_same_decisions(self):
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

    def test_saving_a_loaded_table_gives_the_same_file(self):
        """Loading and saving a table preserves every bit, once its visits without a source have a name."""
        self.start_learner()
        self.succeed('learner/load_q_table', file='thesis_nearest')
        self.succeed('learner/save_q_table', file=self.path('first.txt'))
        self.succeed('learner/load_q_table', file=self.path('first.txt'))
        self.succeed('learner/save_q_table', file=self.path('second.txt'))
        self.assertEqual(support.read_text(self.path('first.txt')), support.read_text(self.path('second.txt')))
        self.assertEqual(QTableFile(self.path('first.txt')).rows, QTableFile(support.NEAREST_TABLE).rows)

    def bad_files(self):
        """Returns invalid files for this learner: name, content."""
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

    def test_invalid_files_are_refused_and_the_table_does_not_change(self):
        self.start_learner()
        perceiver = Perceiver(self)
        before = perceiver.ask(all_situations()), self.saved('learner')
        for name, content in self.bad_files().items():
            self.refuse('learner/load_q_table', name, file=self.write(name, content))
        self.refuse('learner/load_q_table', 'no_such_file.txt', file=self.path('no_such_file.txt'))
        self.refuse('learner/load_q_table', self.folder, file=self.folder)
        self.refuse('learner/load_q_table', support.OCCUPANCY_TABLE, 'another state set', file='thesis_occupancy')
        after = perceiver.ask(all_situations(tick=1)), self.saved('learner')
        self.assertEqual(after, before)

    def test_unwritable_file_is_reported(self):
        self.start_learner()
        self.refuse('learner/save_q_table', 'file', file='')
        self.refuse('learner/load_q_table', 'file', file='')
        file = self.write('file.txt', '')
        self.refuse('learner/save_q_table', file, file=file + '/table.txt')
        self.refuse('learner/save_q_table', self.path('none'), file='none/table.txt')

    def test_own_tables_are_saved_by_agent(self):
        self.start_learner(q_table=self.write('a.txt', q_table_text(TABLE_A)), tables='own', agents=[4])
        self.assertEqual(self.saved('learner', agent=4), full(TABLE_A))
        self.refuse('learner/save_q_table', 'agent 3 is not served by', 'it serves agent 4',
                    file=self.path('other.txt'), agent=3)

    def test_single_agent_need_not_be_named(self):
        self.start_learner(q_table=self.write('a.txt', q_table_text(TABLE_A)), tables='own', agents=[4])
        response = self.succeed('learner/save_q_table', file=self.path('saved.txt'))
        self.assert_says(response.message, 'agent 4', self.path('saved.txt'))
        self.assertEqual(QTableFile(self.path('saved.txt')).rows, full(TABLE_A))
        self.assert_says(self.succeed('learner/share_q_table').message, 'the Q-table of agent 4')

    def test_reply_names_the_agent_of_a_learner_of_one_agent(self):
        self.start_learner(agents=[4])
        response = self.succeed('learner/save_q_table', file=self.path('saved.txt'))
        self.assert_says(response.message, 'of the table of agent 4 to ')

    def test_one_of_several_agents_must_be_named(self):
        self.start_learner(q_table=self.write('a.txt', q_table_text(TABLE_A)), tables='own', agents=[4, 5])
        for service in ('save_q_table', 'share_q_table'):
            request = {'file': self.path('saved.txt')} if service == 'save_q_table' else {}
            self.refuse(f'learner/{service}', 'agent 0 is not served by', 'it serves agents 4, 5', **request)

    def test_replies_contain_the_absolute_path(self):
        """A path is relative to ~data_folder."""
        self.start_learner()
        file = './table.txt'
        self.assert_says(self.succeed('learner/save_q_table', file=file).message, f' to {self.path("table.txt")}')
        self.assert_says(self.succeed('learner/load_q_table', file=file).message, f' from {self.path("table.txt")}:')
        self.refuse('learner/load_q_table', f'there is no file {self.path("none.txt")}', file='none.txt')
        self.refuse('learner/load_q_table', f'{self.path("none.txt")}: ', file='./none.txt')

    def test_errors_quote_nothing_of_other_files(self):
        self.start_learner()
        for secret in ('password: secret\n', 'secret', 'social_crowd Q-table of secrets\n'):
            response = self.refuse('learner/load_q_table', 'no Q-table of this package', "'social_crowd Q-table 1'",
                                   file=self.write('private.txt', secret))
            self.assertNotIn('secret', response.message)
        response = self.refuse('learner/take_q_table', 'no Q-table of this package', q_table='secret\n')
        self.assertNotIn('secret', response.message)


class SaveToTest(support.CrowdTestCase):
    """~save_to and ~save_every."""

    def test_table_is_saved_during_training_and_at_the_end(self):
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

    def test_message_contains_the_absolute_path(self):
        learner = self.start_learner(save_to=os.path.relpath(self.path('table.txt')))
        self.listen('learner_status', LearnerStatus).wait()
        self.assertEqual(learner.stop(), 0)
        self.assert_says(learner.output(), f' to {self.path("table.txt")}\n')

    def test_failure_to_save_is_reported_after_an_interrupt(self):
        os.mkdir(self.path('folder'))
        learner = self.start_learner(save_to=self.path('folder/table.txt'))
        self.listen('learner_status', LearnerStatus).wait()
        os.rmdir(self.path('folder'))
        self.assertEqual(learner.stop(), 1)
        self.assert_says(learner.output(), '[FATAL]', f'{self.path("folder/table.txt")}: cannot be written',
                         f'there is no folder {self.path("folder")}\n')


if __name__ == '__main__':
    support.run('q_tables_test')
