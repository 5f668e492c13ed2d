#!/usr/bin/python3
"""Ends of launches, with and without errors, and the arguments that roslaunch lists."""
import os
import re
import signal
import subprocess
import xml.etree.ElementTree as ElementTree

import rosgraph
import rospy
import support
import yaml
from launching import LaunchTestCase
from learning_files import QTableFile
from social_crowd.msg import AgentStates, EpisodeResult

# A substitute for RViz, which ends when a file is created.
RVIZ = """#!/bin/bash
trap exit INT TERM  # otherwise bash continues if the sleep has just ended
touch "$0.open"
until [[ -e $0.close ]]; do sleep 0.05; done
"""
# A node that holds a lock when it is interrupted. Its shutdown needs this lock.
HOLDING = """
import threading, time
import rospy
from crowd_launching.init_node import init_node, is_ending

init_node('holding')
lock = threading.Lock()
rospy.on_shutdown(lock.acquire)
with lock:
    print('holds the lock', flush=True)
    while not is_ending():
        time.sleep(0.01)
"""
INCLUDING = """
<launch>
  <include file="$(find social_crowd)/launch/{}">{}</include>
</launch>
"""


class EndTest(LaunchTestCase):
    """A completed launch ends without an error, a failed one with an error."""

    def test_nodelets_save_what_they_learned(self):
        self.assert_ends_well(self.demo(mode='training', nodelets='true', save_to=self.path('table.txt'), episodes=1))
        before = QTableFile(support.ANTICIPATION_TABLE).header['decisions']
        self.assertGreater(QTableFile(self.path('table.txt')).header['decisions'], before)

    def test_controller_with_an_invalid_scenario(self):
        for nodelets in ('false', 'true'):
            launched = self.demo(scenario='wakers6', nodelets=nodelets)
            self.assert_ends_with(launched, "no scenario 'wakers6'", 'exit code')

    def test_crash_of_the_controller(self):
        launched = self.launch('demo.launch')
        self.listen('agents', AgentStates).wait(what='that they walk')
        name = f'{self.namespace[1:]}/crowd_controller'
        process = re.search(rf'process\[{name}-\d+\]: started with pid \[(\d+)\]', launched.output()).group(1)
        os.kill(int(process), signal.SIGKILL)
        self.assert_ends_with(launched, 'exit code -9')

    def test_controller_started_without_roslaunch(self):
        """The controller exits; the process that started it gets no signal."""
        self.start_learner()
        controller = self.start_controller(support.CIRCLE6, episodes=1, ends_launch=True)
        self.assertEqual(controller.wait(), 0, controller.output())

    def test_interrupt_of_a_node_that_holds_a_lock(self):
        node = self.start('holding', ['/usr/bin/python3', '-c', HOLDING],
                          {'PYTHONPATH': f'{support.in_package("scripts")}:{os.environ["PYTHONPATH"]}'})
        support.wait_for(lambda: 'holds the lock' in node.output(), 'the lock')
        self.assertEqual(node.stop(), 0, node.output())
        self.assertNotIn('Traceback', node.output())
        nodes = rosgraph.Master(rospy.get_name()).getSystemState()[0]  # publishers of topics
        self.assertNotIn(f'{self.namespace}/holding', [name for _, names in nodes for name in names])


class RvizTest(LaunchTestCase):
    """Launches with a substitute for RViz."""

    def launch_with_rviz(self, file, **arguments):
        """Starts a launch file and waits until RViz runs."""
        self.rviz = self.write('rviz', RVIZ)
        os.chmod(self.rviz, 0o755)
        environment = {'PATH': f'{self.folder}:{os.environ["PATH"]}', 'DISPLAY': ':0'}
        launched = self.launch(file, environment, rviz='true', **arguments)
        support.wait_for(lambda: os.path.exists(f'{self.rviz}.open'), 'RViz')
        return launched

    def close_rviz(self):
        """Closes RViz as a user does."""
        self.write('rviz.close', '')

    def test_closing_rviz_ends_a_demo(self):
        launched = self.launch_with_rviz('demo.launch')
        self.close_rviz()
        self.assert_ends_well(launched)

    def test_end_of_a_demo_closes_rviz(self):
        launched = self.launch_with_rviz('demo.launch', real_time_factor='fast', episodes=1, paused='true')
        self.call('crowd_controller/pause', data=False)
        self.assert_ends_well(launched)

    def test_missing_display(self):
        launched = self.launch('demo.launch', {'DISPLAY': ''}, rviz='true')
        self.assert_ends_with(launched, 'there is no display', 'rviz:=false')

    def test_closing_rviz_does_not_end_training(self):
        """This holds also if closing RViz ended another launch before."""
        rospy.set_param(f'{self.namespace}/rviz/ends_launch', True)
        launched = self.launch_with_rviz('train.launch', output=self.path('table.txt'), episodes=0,
                                         real_time_factor=100)
        self.close_rviz()
        support.wait_for(lambda: 'process has finished cleanly' in launched.output(), 'the end of RViz')
        results = self.listen('episode_results', EpisodeResult)
        results.wait(what='after RViz was closed')
        self.assertEqual(launched.stop(), 0)
        self.assertGreater(QTableFile(self.path('table.txt')).header['decisions'], 0)


class ArgumentsTest(LaunchTestCase):
    """The arguments that roslaunch lists, and the meaning of their defaults."""

    def ask(self, *arguments):
        """Returns the output of roslaunch when it starts nothing."""
        return subprocess.run(['roslaunch', *arguments], stdout=subprocess.PIPE, timeout=support.PATIENCE,
                              check=True).stdout.decode()

    def parameters(self, *arguments):
        """Returns the parameters that a launch sets."""
        return yaml.safe_load(self.ask('--dump-params', *arguments))

    def words_of(self, file):
        """Returns by argument the default words that mean "not set"."""
        tree = ElementTree.parse(support.in_package('launch', file))
        defaults = {argument.get('name'): argument.get('default') for argument in tree.findall('arg')}
        return {name: word for name, word in defaults.items() if word in ('none', 'table', 'config')}

    def test_lists_only_required_arguments_as_required(self):
        for file, required in (('demo.launch', []), ('train.launch', ['output']), ('replay.launch', [])):
            told = self.ask('--ros-args', 'social_crowd', file).partition('Optional Arguments:')
            self.assertEqual(re.findall(r'^  (\w+): ', told[0], re.MULTILINE), required)
            self.assertIn('rviz (default', told[2])

    def test_default_words_set_no_parameter(self):
        """No parameter is set to such a word. An empty argument has the same effect."""
        for file, count in (('demo.launch', 7), ('train.launch', 8)):
            words = self.words_of(file)
            self.assertEqual(len(words), count, words)
            parameters = self.parameters('social_crowd', file, 'output:=table.txt')
            self.assertEqual([name for name, value in parameters.items() if value in words.values()], [])
            left_empty = self.parameters('social_crowd', file, 'output:=table.txt', *(f'{name}:=' for name in words))
            self.assertEqual(left_empty, parameters)

    def test_empty_arguments_set_no_parameter(self):
        for file in ('demo.launch', 'train.launch'):
            given = dict(dict.fromkeys(self.words_of(file), ''), **({'output': 't'} if file == 'train.launch' else {}))
            elements = ''.join(f'<arg name="{name}" value="{value}"/>' for name, value in given.items())
            including = self.write('including.launch', INCLUDING.format(file, elements))
            self.assertEqual(self.parameters(including), self.parameters('social_crowd', file, 'output:=t'))


if __name__ == '__main__':
    support.run('launch_end_test')
