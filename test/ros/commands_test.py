#!/usr/bin/python3
"""Programs and scripts from the command line: rosrun finds them at once, and what is wrong is told with a remedy."""
import os
import pathlib
import shutil
import subprocess

import support
from roslib.packages import find_node


class CommandTestCase(support.CrowdTestCase):
    """Runs commands."""

    def run_here(self, *command):
        """Exit status and output of a command that is run in the test's folder, without anybody to answer questions."""
        done = subprocess.run(list(map(str, command)), cwd=self.folder, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=support.PATIENCE, check=False)
        return done.returncode, done.stdout.decode(errors='replace')


class RosrunTest(CommandTestCase):
    """rosrun social_crowd PROGRAM."""

    def test_it_finds_one_of_each(self):
        for name in ('train', 'evaluate', 'plot_paths', 'compare', 'reproduce'):
            status, output = self.run_here('rosrun', 'social_crowd', name, '--help')
            self.assertEqual(status, 0, output)
            self.assertNotIn('non-unique', output)
            self.assertIn('usage', output.lower())

    def test_it_finds_the_crew(self):
        crew = self.start('crew', ['rosrun', 'social_crowd', 'learner_crew', '_learners:=two'])
        self.assertEqual(crew.wait(), 1)
        self.assert_says(crew.output(), 'learners: expected one or per_agent')


class ToolTest(CommandTestCase):
    """train, evaluate and plot_paths."""

    def refuse(self, status, words, name, *arguments):
        """Runs a program that is to refuse."""
        got, output = self.run_here(find_node('social_crowd', name)[0], *arguments)
        self.assertEqual(got, status, output)
        self.assert_says(output, *words)
        return output

    def test_numbers_out_of_range(self):
        recipe = support.in_package('config', 'learning', 'thesis_nearest.yaml')
        for program, given in (('train', [recipe, '--output', 'table.txt']),
                               ('evaluate', ['--q-table', support.NEAREST_TABLE, 'circle6'])):
            output = self.refuse(2, ["--episodes: expected a whole number, 1 or more, got '0'"], program, *given,
                                 '--episodes', 0)
            self.assertLess(len(output), 120)
            self.refuse(2, ["--seed: expected a whole number, 0 or more, got '-1'"], program, *given, '--seed', -1)

    def test_files_that_are_not_there(self):
        words = ['table.txt: cannot be read: No such file', os.path.join(self.folder, 'table.txt')]
        self.refuse(1, words, 'evaluate', '--q-table', 'table.txt', 'circle6')
        words = ['recipe.yaml: cannot be read', os.path.join(self.folder, 'recipe.yaml')]
        self.refuse(1, words, 'train', 'recipe.yaml', '--output', 'new.txt')

    def test_a_misspelt_scenario(self):
        words = ["no scenario 'circel6', did you mean 'circle6'? There is no file",
                 os.path.join(self.folder, 'circel6'), support.in_package('config', 'scenarios'), 'there are circle6, ']
        self.refuse(1, words, 'evaluate', '--q-table', support.NEAREST_TABLE, 'circel6')

    def test_scenarios_have_names(self):
        recording = self.path('circle6.csv')
        self.tool('evaluate', '--q-table', support.NEAREST_TABLE, '--trajectories', self.folder, 'circle6')
        drawing = ['--trajectories', recording, '--output', 'paths.png', '--scenario']
        status, output = self.run_here(find_node('social_crowd', 'plot_paths')[0], *drawing, 'circle6')
        self.assertEqual(status, 0, output)
        self.assertTrue(os.path.exists(self.path('paths.png')))
        words = ["no scenario 'circel6', did you mean 'circle6'? There is no file", 'there are circle6, ']
        self.refuse(1, words, 'plot_paths', *drawing, 'circel6')


class BuildTest(CommandTestCase):
    """scripts/build in a copied clone."""

    def copy(self, made_for, build):
        """A clone with nothing but the script in it, and a build folder that was made for another one."""
        scripts = pathlib.Path(self.path('clone/scripts'))
        scripts.mkdir(parents=True)
        shutil.copy(support.in_package('scripts', 'build'), scripts)
        stop = scripts / 'install_dependencies'  # what comes next; the script ends there
        stop.write_text('#!/bin/sh\necho looked at the build folder\nexit 7\n', encoding='utf-8')
        stop.chmod(0o755)
        pathlib.Path(build).mkdir(parents=True)
        cache = pathlib.Path(build, 'CMakeCache.txt')
        cache.write_text(f'CMAKE_HOME_DIRECTORY:INTERNAL={made_for}\n', encoding='utf-8')
        return cache

    def build(self, **environment):
        """Runs the script."""
        return self.run_here('env', *(f'{name}={value}' for name, value in environment.items()),
                             self.path('clone/scripts/build'))

    def test_a_copied_build_folder_is_made_anew(self):
        cache = self.copy('/somewhere/else', self.path('clone/.build'))
        status, output = self.build()
        self.assertEqual(status, 7, output)
        self.assert_says(output, 'clone/.build was made for /somewhere/else and is made anew', 'looked at')
        self.assertFalse(cache.exists())

    def test_its_own_is_kept(self):
        cache = self.copy(self.path('clone'), self.path('clone/.build'))
        self.assertEqual(self.build(), (7, 'looked at the build folder\n'))
        self.assertTrue(cache.exists())

    def test_one_elsewhere_may_be_in_use(self):
        cache = self.copy('/somewhere/else', self.path('theirs'))
        status, output = self.build(SOCIAL_CROWD_BUILD=self.path('theirs'))
        self.assertEqual(status, 1, output)
        self.assert_says(output, 'theirs was made for /somewhere/else', 'SOCIAL_CROWD_BUILD')
        self.assertTrue(cache.exists())


if __name__ == '__main__':
    support.run('commands_test')
