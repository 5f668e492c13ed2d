#!/usr/bin/python3
"""The files of messages and services, and calls of services on the command line."""
import concurrent.futures
import glob
import os
import re

import rospy
import support
from broadcasting import TOPICS


class MessageFilesTest(support.CrowdTestCase):
    """The .msg and .srv files."""

    def test_rosmsg_and_rossrv_show_all_files(self):
        commands = [['rosmsg', 'show', f'social_crowd/{name}'] for name in self.names('msg')]
        commands += [['rossrv', 'show', f'social_crowd/{name}'] for name in self.names('srv')]
        with concurrent.futures.ThreadPoolExecutor(2) as pool:  # all at once take long on a busy machine
            for status, output in pool.map(self.run_program, commands):
                self.assertEqual(status, 0, output)

    def run_program(self, command):
        """Runs a program to its end. Returns exit status and output."""
        process = self.start('_'.join(command[1:]).replace('/', '_'), command)
        return process.wait(), process.output()

    def names(self, kind):
        """Returns the names of all messages or services."""
        names = [os.path.splitext(os.path.basename(file))[0] for file in self.files(kind)]
        self.assertTrue(names, f'there are no .{kind} files')
        return names

    def files(self, kind):
        """Returns all message or service files."""
        return sorted(glob.glob(support.in_package(kind, f'*.{kind}')))

    def test_every_field_has_a_comment(self):
        bare = [f'{os.path.basename(file)}:{number}: {line}' for file in self.files('msg') + self.files('srv')
                for number, line in enumerate(support.read_text(file).splitlines(), 1) if is_bare_field(line)]
        self.assertEqual(bare, [], 'fields without a comment')

    def test_every_file_begins_with_a_description(self):
        for file in self.files('msg') + self.files('srv'):
            self.assertTrue(support.read_text(file).startswith('# '), file)

    def test_every_published_message_has_header_episode_and_tick(self):
        for kind in TOPICS.values():
            self.assertEqual(kind.__slots__[:3], ['header', 'episode', 'tick'], kind.__name__)


class CommandLineTest(support.CrowdTestCase):
    """Services called on the command line."""

    def call_set_learning_parameters(self, argument):
        """Calls the service on the command line. Returns exit status and output."""
        service = f'{self.namespace}/learner/set_learning_parameters'
        rospy.wait_for_service(service, support.PATIENCE)
        caller = self.start('rosservice', ['rosservice', 'call', service, argument])
        return caller.wait(), caller.output()

    def test_example_of_the_service_file_sets_learning_parameters(self):
        self.start_learner()
        request = support.read_text(support.in_package('srv', 'SetLearningParameters.srv')).split('---')[0]
        argument = re.search(r'rosservice call /learner/set_learning_parameters "(.*)"', request)[1]
        status, output = self.call_set_learning_parameters(argument)
        self.assertEqual(status, 0, output)
        self.assert_says(output, 'success: True', 'alpha from 0.1 to 0.05')

    def test_wrong_requests_do_not_set_learning_parameters(self):
        """Unknown fields in a request are refused, and missing parameters are not set to 0."""
        self.start_learner()
        status, output = self.call_set_learning_parameters('{alpha: 0.05}')
        self.assertNotEqual(status, 0, output)
        self.assert_says(output, 'alpha')
        self.assert_says(self.call('learner/set_learning_parameters', parameters='{}').message, 'alpha: 0.1')


def is_bare_field(line):
    """Returns whether a line declares a field without a comment; `bool success` needs none."""
    field, _, comment = line.partition('#')
    is_field = re.match(r'[\w/]+(\[\d*\])?\s+\w+\s*$', field)  # a constant has a value behind its name
    return bool(is_field) and not comment.strip() and field.split() != ['bool', 'success']


if __name__ == '__main__':
    support.run('message_files_test')
