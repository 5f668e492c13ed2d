#!/usr/bin/python3
"""Services that name files reach ~data_folder and shipped files only, overwrite nothing unasked, and quote nothing."""
import os

import support
from controlling import ControllerTestCase

# Files that are neither scenarios nor Q-tables, of several forms.
PRIVATE = ('root:x:0:0:secret:/root:/bin/bash\n', 'export TOKEN=secret\n', 'secret: word\n', 'name: a\nsecret: 1\n',
           'name: a\nduration: secret\n', 'social_crowd Q-table 1\nsecret: 1\n---\n', '*secret\n', '{secret\n',
           'social_crowd Q-table 1\nstate_set: {type: secret}\n---\n')
READING = {'crowd_controller/load_scenario': 'scenario', 'learner/load_q_table': 'file'}
WRITING = {'crowd_controller/save_scenario': 'file', 'learner/save_q_table': 'file'}
SERVICES = dict(READING, **WRITING)


class ServiceFilesTestCase(ControllerTestCase):
    """A controller and a learner whose data folder is a part of the test's folder."""

    def start_both(self, **parameters):
        """Starts both nodes."""
        for folder in ('data', 'data/sub'):
            os.mkdir(self.path(folder))
        self.private = self.write('private.txt', 'secret\n')
        given = dict({'data_folder': self.path('data')}, **parameters)
        self.start_learner(**given)
        self.start_controller('circle6', paused=True, **given)

    def refuse_name(self, service, name, *words):
        """A service refuses to read or write a file. Returns its message."""
        request = dict({SERVICES[service]: name}, **({'overwrite': True} if service in WRITING else {}))
        return self.refuse_of(service, *words, **request).message

    def refuse_of(self, service, *words, **request):
        """As refuse(), for a service of any node."""
        return support.CrowdTestCase.refuse(self, service, *words, **request)


class DataFolderTest(ServiceFilesTestCase):
    """What ~data_folder contains, and nothing else."""

    def test_other_files_are_refused(self):
        self.start_both()
        os.symlink(self.private, self.path('data/link.txt'))
        os.symlink(self.folder, self.path('data/home'))
        os.symlink(self.path('none.txt'), self.path('data/nowhere.txt'))
        before = sorted(os.listdir(self.folder))
        for service in SERVICES:
            for name in (self.private, self.path('new.txt'), '../private.txt', 'sub/../../private.txt', 'link.txt',
                         'home/private.txt', 'home/new.txt', 'nowhere.txt', '/etc/passwd', '/', '..'):
                message = self.refuse_name(service, name, f'is not in the folder {self.path("data")}, ',
                                           '~data_folder', '~allow_any_path')
                self.assertNotIn('secret', message)
        self.assertEqual(support.read_text(self.private), 'secret\n')
        self.assertEqual(sorted(os.listdir(self.folder)), before)

    def test_files_of_the_folder(self):
        self.start_both()
        for name in ('floor.yaml', 'sub/floor.yaml', self.path('data/full.yaml')):
            path = os.path.join(self.path('data'), name)
            self.assert_says(self.do('save_scenario', file=name).message, f' to {path}')
            self.assert_says(self.do('load_scenario', scenario=name).message, f'loaded {path}: ')
        for name in ('table.txt', 'sub/table.txt', self.path('data/full.txt')):
            path = os.path.join(self.path('data'), name)
            self.assert_says(self.succeed('learner/save_q_table', file=name).message, f' to {path}')
            self.assert_says(self.succeed('learner/load_q_table', file=name).message, f' from {path}: ')

    def test_shipped_files_have_names(self):
        self.start_both()
        self.assert_says(self.do('load_scenario', scenario='line6').message, 'config/scenarios/line6.yaml')
        self.assert_says(self.succeed('learner/load_q_table', file='thesis_nearest').message, support.NEAREST_TABLE)
        self.refuse_of('learner/load_q_table', "did you mean 'thesis_nearest'?", file='thesis_naerest')

    def test_pipes_are_refused(self):
        self.start_both()
        os.mkfifo(self.path('data/pipe'))
        for service in SERVICES:
            self.refuse_name(service, 'pipe', 'expected a regular file')

    def test_nothing_is_overwritten_unless_it_is_wanted(self):
        self.start_both()
        for service in WRITING:
            file = self.write('data/mine.txt', 'before')
            self.refuse_of(service, f'{file} exists already', 'overwrite: true', file='mine.txt')
            self.assertEqual(support.read_text(file), 'before')
            self.succeed(service, file='mine.txt', overwrite=True)
            self.assertNotEqual(support.read_text(file), 'before')

    def test_folder_is_made_in_that_of_ros(self):
        self.environment['ROS_HOME'] = self.path('home')
        self.start_both(data_folder='')
        self.assertFalse(os.path.exists(self.path('home/social_crowd')))
        self.do('save_scenario', file='floor.yaml')
        self.succeed('learner/save_q_table', file='table.txt')
        self.assertEqual(sorted(os.listdir(self.path('home/social_crowd'))), ['floor.yaml', 'table.txt'])
        self.assertEqual(self.do('list_scenarios').data_folder, self.path('home/social_crowd'))

    def test_sub_folders_are_not_made(self):
        self.start_both()
        for service in WRITING:
            self.refuse_of(service, f'there is no folder {self.path("data/new")}', file='new/file.txt')


class AnyPathTest(ServiceFilesTestCase):
    """~allow_any_path."""

    def test_other_files_are_used(self):
        self.start_both(allow_any_path=True)
        floor, table = self.path('floor.yaml'), self.path('table.txt')
        self.do('save_scenario', file=floor)
        self.do('load_scenario', scenario='../floor.yaml')
        self.succeed('learner/save_q_table', file=table)
        self.succeed('learner/load_q_table', file=table)
        self.refuse_of('learner/save_q_table', 'exists already', file=table)
        for service in READING:
            self.refuse_name(service, '/dev/zero', 'expected a regular file')

    def test_contents_are_not_quoted(self):
        self.start_both(allow_any_path=True)
        for content in PRIVATE:
            file = self.write('private.txt', content)
            for service in READING:
                self.assertNotIn('secret', self.refuse_name(service, file, file), content)


class LongNamesTest(ServiceFilesTestCase):
    """Requests with long texts."""

    def test_answers_are_short(self):
        self.start_both()
        for size in (100000, 10000000):
            for text in ('a' * size, 'a/' * (size // 2)):
                for service in SERVICES:
                    self.assertLess(len(self.refuse_name(service, text, str(size))), 200)
                for service, name in (('crowd_controller/set_gate', 'gate'), ('learner/set_mode', 'mode'),
                                      ('learner/share_q_table', 'method'), ('learner/take_q_table', 'q_table'),
                                      ('learner/set_learning_parameters', 'parameters')):
                    self.assertLess(len(self.refuse_of(service, **{name: text}).message), 300, service)

    def test_lists_are_short(self):
        self.start_both()
        many = list(range(100000))
        self.refuse_of('learner/share_q_table', 'to_agents: expected at most 10000 entries, got 100000', to_agents=many)
        self.refuse_of('learner/take_q_table', 'to_agents: expected at most 10000 entries, got 100000', to_agents=many)
        self.refuse_of('crowd_controller/add_gate', 'open_from: expected at most 1000 entries, got 100000',
                       open_from=many, open_until=many)


if __name__ == '__main__':
    support.run('service_files_test')
