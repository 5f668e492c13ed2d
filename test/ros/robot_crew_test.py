#!/usr/bin/python3
"""robot_lab.launch: what drives the robots is started for each of them, and may die without ending the crowd."""
import os
import signal
import xmlrpc.client

import rosgraph
import rospy
import support
from robot_launching import RobotLaunchTestCase
from social_crowd.msg import EpisodeResult
from std_msgs.msg import String

SCENARIO = """
name: lab
duration: 3
goal_tolerance: 0.3
contact: solid
ends: robots
agents:
  - {position: [0, 20], goal: [100, 20], speed: 0.5, radius: 0.25}
robots:
  - {name: tug, position: [0, 0], goal: [50, 0], radius: 0.21, max_speed: 0.8}
  - {name: cart, position: [0, 5], goal: [50, 5], radius: 0.35, max_speed: 0.5, drive: holonomic}
"""
# A stack that stores what it is told of its robot, and drives it.
STACK = """
<launch>
  <arg name="radius"/>
  <arg name="drive"/>
  <arg name="prefix" default=""/>
  <param name="told" type="str" value="$(arg prefix) $(arg drive) $(arg radius)"/>
  <node name="driver" pkg="rostopic" type="rostopic" args="pub -r 20 cmd_vel geometry_msgs/Twist '{linear: {x: 0.4}}'"
        required="true"/>
</launch>
"""


def process_of(node):
    """Returns the process id of a node; None if it is not there yet."""
    try:
        uri = rosgraph.Master('/robot_crew_test').lookupNode(node)
        return xmlrpc.client.ServerProxy(uri).getPid('/robot_crew_test')[2]
    except (rosgraph.MasterException, OSError):
        return None


class RobotCrewTest(RobotLaunchTestCase):
    """Two robots."""

    def begin(self, navigation='controller', **arguments):
        """Starts the launch. Returns it."""
        self.results = self.listen('episode_results', EpisodeResult)
        launched = self.drive('robot_lab.launch', scenario=self.write('lab.yaml', SCENARIO), navigation=navigation,
                              **dict({'real_time_factor': 'fast'}, **arguments))
        self.results.wait_connected()
        return launched

    def navigation_of(self, number):
        """Returns the navigation of both robots in a result, once it is there."""
        support.wait_for(lambda: len(self.results.messages) > number, f'result {number}')
        return [robot.navigation for robot in self.results.messages[number].robots]

    def kill(self, node):
        name = f'{self.namespace}/{node}'
        support.wait_for(lambda: process_of(name), name)
        os.kill(process_of(name), signal.SIGKILL)

    def test_a_navigation_that_dies_is_a_result_and_the_crowd_goes_on(self):
        launched = self.begin()
        support.wait_for(lambda: all(state.commands_taken > 0 for state in self.robots()) and self.robots(), 'commands')
        self.kill('cart/robot_controller')
        support.wait_for(lambda: self.robots()[1].navigation == 'crashed', 'the crash')
        self.assertEqual(self.robots()[0].navigation, 'running')
        self.results.messages.clear()
        self.assertEqual(self.navigation_of(0), ['running', 'crashed'])
        self.assertEqual(self.navigation_of(1), ['running', 'crashed'])  # it is still dead
        self.assert_says(launched.output(), "robot 'cart': navigation: crashed",
                         "robot 'cart': navigation: crashed; its launch file ended", "robot 'tug': navigation: running")
        self.assertEqual(launched.stop(), 0)

    def test_a_record_goes_on_without_it(self):
        """record_robots does not wait for the first command of a robot that has none."""
        stack = self.write('dead.launch', '<launch><node name="dead" pkg="rostopic" type="rostopic" required="true" '
                                          'args="list"/></launch>')
        launched = self.begin(stack, robots_csv=self.path('robots.csv'), episodes=2)
        self.assertEqual(launched.wait(), 0, launched.output())
        rows = support.read_bytes(self.path('robots.csv')).decode().splitlines()
        self.assertEqual(len(rows), 5)
        self.assertEqual({row.split(',')[rows[0].split(',').index('navigation')] for row in rows[1:]}, {'crashed'})

    def test_a_stack_of_your_own_gets_what_the_scenario_says(self):
        launched = self.begin(self.write('stack.launch', STACK))
        # Not at the same time: episodes are short, and each robot is driven by a program of its own.
        support.wait_for(lambda: {robot.name for message in list(self.states.messages) for robot in message.robots
                                  if robot.twist.linear.x > 0.3} == {'tug', 'cart'}, 'motion of both robots')
        self.assertEqual([rospy.get_param(f'{self.namespace}/{robot}/told') for robot in ('tug', 'cart')],
                         ['tug/ differential 0.21', 'cart/ holonomic 0.35'])
        self.assertEqual(launched.stop(), 0)

    def test_a_node_that_is_not_installed(self):
        stack = self.write('missing.launch', '<launch><node name="a" pkg="no_such_package" type="node"/></launch>')
        launched = self.drive('robot_lab.launch', scenario=self.write('lab.yaml', SCENARIO), navigation=stack)
        launched.wait()
        self.assert_says(launched.output(), 'missing.launch: there is no node no_such_package/node')

    def test_all_parameters_can_be_reached(self):
        launched = self.begin('none', localisation='none', visible_people_only='true', command_period=0.2,
                              command_deadline=0.3, real_time_factor=5, progress_time=3)
        name = f'{self.namespace}/crowd_controller/'
        support.wait_for(lambda: self.robots(), 'robots')
        self.assertEqual({key: rospy.get_param(name + key) for key in ('publish_localisation', 'visible_people_only',
                                                                       'command_period', 'command_deadline',
                                                                       'progress_time')},
                         {'publish_localisation': False, 'visible_people_only': True, 'command_period': 0.2,
                          'command_deadline': 0.3, 'progress_time': 3.0})
        self.assertEqual(self.robots()[0].navigation, 'none')
        state = rospy.Publisher(f'{self.namespace}/tug/navigation', String, queue_size=1, latch=True)
        self.addCleanup(state.unregister)
        state.publish('crashed')  # a stack that was started elsewhere
        support.wait_for(lambda: self.robots()[0].navigation == 'crashed', 'the crash')
        state.publish('asleep')
        support.wait_for(lambda: "navigation: expected running or crashed, got 'asleep'" in launched.output(),
                         'warning')
        self.assertEqual(launched.stop(), 0)


if __name__ == '__main__':
    support.run('robot_crew_test')
