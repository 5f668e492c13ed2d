#!/usr/bin/python3
"""The examples of the documentation: what the pages print is built and run as it stands there."""
import csv
import os
import re
import subprocess

import rospy
import support
from learning_files import QTableFile, recipe_text
from social_crowd.msg import EpisodeResult

LONG = 300.0  # [s] for a compiler on a busy machine
PAIR = """
name: pair
duration: 60
goal_tolerance: 0.3
agents:
  - {position: [0, 0], goal: [4, 0], speed: 1, radius: 0.25, heading: 90}
  - {position: [0, 5], goal: [4, 5], speed: 1, radius: 0.25}
"""


def without_devel(variable):
    """The paths in a variable of the environment, less those of the build folder."""
    return [path for path in os.environ.get(variable, '').split(':') if path and '/devel' not in path]


def examples(page):
    """The files that a page of docs/ prints, by name: `NAME`: and a block of code."""
    text = support.read_text(support.in_package('docs', page))
    return dict(re.findall(r'^`([\w.]+)`:\n\n```\w+\n(.*?)^```$', text, re.DOTALL | re.MULTILINE))


class LibraryPageTest(support.CrowdTestCase):
    """docs/library.md: a project of one's own, with an installed copy."""

    def run_here(self, *command):
        """Exit status and output of a command that knows nothing of the build folder."""
        environment = dict(os.environ, CMAKE_PREFIX_PATH='', LD_LIBRARY_PATH=':'.join(without_devel('LD_LIBRARY_PATH')))
        done = subprocess.run(list(map(str, command)), cwd=self.folder, env=environment, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, timeout=LONG, check=False)
        return done.returncode, done.stdout.decode(errors='replace')

    def run_to_its_end(self, *command):
        """What a command prints; it has to succeed."""
        status, output = self.run_here(*command)
        self.assertEqual(status, 0, f'{command}:\n{output}')
        return output

    def test_the_example_walks_and_learns(self):
        prefix = self.path('installed')
        self.run_to_its_end('cmake', '--install', rospy.get_param('~build'), '--prefix', prefix)
        files = examples('library.md')
        self.assertEqual(sorted(files), ['CMakeLists.txt', 'learn.cpp', 'walk.cpp'])
        for name, text in files.items():
            self.write(name, text)
        others = without_devel('CMAKE_PREFIX_PATH')
        self.run_to_its_end('cmake', '-S', '.', '-B', 'build', f"-DCMAKE_PREFIX_PATH={';'.join([prefix, *others])}")
        self.run_to_its_end('cmake', '--build', 'build')
        self.check_programs(os.path.join(prefix, 'share', 'social_crowd', 'config'))

    def check_programs(self, config):
        """They do what the tools do; scenarios have the names of the installed copy."""
        table = os.path.join(config, 'q_tables', 'anticipation.txt')
        walked = self.run_to_its_end('build/walk', table, 'circle6')
        self.assertRegex(walked, r'^6 of 6 arrived, 0 were in contact, \d+ ticks\n$')
        recipe = self.write('recipe.yaml', recipe_text('circle6', 2, seed=4))
        learned = self.run_to_its_end('build/learn', recipe, 'table.txt')
        self.assertRegex(learned, r'^2 episodes, \d+ decisions\n$')
        self.tool('train', recipe, '--output', self.path('expected.txt'))
        self.assertEqual(support.read_text(self.path('table.txt')), support.read_text(self.path('expected.txt')))
        _, output = self.run_here('build/walk', table, 'circel6')
        self.assert_says(output, f'{os.path.realpath(config)}/scenarios none of that name')


class OwnLearnerPageTest(support.CrowdTestCase):
    """docs/own_learner.md: a learner in Python, and how it shares a crowd with the shipped one."""

    def start_example(self, **parameters):
        """Starts the page's learner."""
        file = self.write('my_learner.py', examples('own_learner.md')['my_learner.py'])
        words = [f'_{name}:={value}' for name, value in parameters.items()]
        return self.start('my_learner', ['/usr/bin/python3', file, *words])

    def arrivals(self, episodes):
        """Which agents arrive in which episode; nobody's answer may be missing."""
        results = self.listen('episode_results', EpisodeResult)
        self.start_controller(self.write('pair.yaml', PAIR), episodes=episodes)
        results.wait(lambda result: result.episode == episodes - 1, 'of the last episode')
        self.assertEqual({result.missed_answers for result in results.messages}, {0})
        return [[agent.arrived for agent in result.agents] for result in results.messages]

    def test_it_learns_to_reach_its_goal(self):
        self.start_example()
        arrived = self.arrivals(8)
        self.assertEqual(arrived[-1], [True, True], arrived)

    def test_with_the_shipped_learner(self):
        self.start_learner(agents=[1], q_table=support.ANTICIPATION_TABLE)
        self.start_example(agents='[0]')
        arrived = self.arrivals(8)
        self.assertEqual(arrived[-1], [True, True], arrived)

    def test_the_page_names_arguments_that_there_are(self):
        page = support.read_text(support.in_package('docs', 'own_learner.md'))
        self.assertIn('demo.launch agents:="[1, 2, 3, 4, 5]"', page)
        served = self.start('roslaunch', ['roslaunch', 'social_crowd', 'demo.launch', 'rviz:=false', 'pace:=fast',
                                          'episodes:=1', 'agents:=[1, 2, 3, 4, 5]'])
        self.start_example(agents='[0]')
        self.assertEqual(served.wait(), 0, served.output())
        self.assert_says(served.output(), ' 0 answers missed')


class LearningPageTest(support.CrowdTestCase):
    """docs/learning.md: the keys that a recipe needs, and the recipe that it advises."""

    def test_what_is_advised_arrives(self):
        """The page says 100 %; the naive recipe is read at least."""
        recipes = examples('learning.md')
        recipe = self.write('advised.yaml', recipes['advised.yaml'])
        self.tool('train', recipe, '--output', self.path('table.txt'))
        self.tool('evaluate', '--q-table', self.path('table.txt'), '--episodes', 100, '--seed', 1000, '--csv',
                  self.path('figures.csv'), 'single_obstacle', 'circle12_varied')
        with open(self.path('figures.csv'), newline='', encoding='utf-8') as stream:
            rates = [(float(row['success_pct']), float(row['contact_pct'])) for row in csv.DictReader(stream)]
        self.assertEqual(rates, [(100.0, 0.0), (100.0, 0.0)])
        naive = self.write('naive.yaml', recipes['naive.yaml'])
        self.tool('train', naive, '--output', self.path('table.txt'), '--episodes', 1)

    def test_the_least_recipe_is_one(self):
        text = examples('learning.md')['least.yaml']
        self.tool('train', self.write('least.yaml', text), '--output', self.path('table.txt'), '--episodes', 1)
        self.assertGreater(QTableFile(self.path('table.txt')).header['decisions'], 0)

    def test_none_of_its_keys_may_be_left_out(self):
        text = examples('learning.md')['least.yaml']
        for key in ('state_set', 'action_set', 'reward', 'obstacle_cost', 'learning', 'scenarios', 'episodes'):
            less = re.sub(rf'^{key}:.*\n|(?<=[{{ ]){key}: [^,}}]*(, )?', '', text, flags=re.MULTILINE)
            self.assertNotEqual(less, text, key)
            file = self.write('less.yaml', less)
            done = subprocess.run(['rosrun', 'social_crowd', 'train', file, '--output', self.path('no.txt')],
                                  stderr=subprocess.PIPE, stdin=subprocess.DEVNULL, check=False)
            self.assertEqual(done.returncode, 1, less)
            self.assert_says(done.stderr.decode(), f"the key '{key}' is missing")


if __name__ == '__main__':
    support.run('documentation_test')
