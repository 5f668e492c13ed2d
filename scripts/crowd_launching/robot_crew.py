"""Starts launch files for each robot of a scenario, see scripts/robot_crew."""
import math
import os
import shutil
import signal
import subprocess
import time

import roslaunch.config
import roslaunch.core
import roslaunch.xmlloader
import roslib.packages
import rospkg
import rospy
from geometry_msgs.msg import PoseWithCovarianceStamped
from social_crowd.msg import RobotStates, Scenario
from std_msgs.msg import String

from .init_node import init_node, is_ending
from .nodes import ending_of, stop_nodes

RUNNING, CRASHED = 'running', 'crashed'
PERIOD = 0.05  # [s] between two checks
VARIANCES = {0: 0.01, 7: 0.01, 35: 0.005}  # of an initial pose: x, y [m^2], yaw [rad^2]


class StartError(Exception):
    """A launch file cannot be started."""


def arguments_of(robot, scenario, more):
    """Returns the arguments of the launch files of a robot."""
    prefix = robot.name_space + '/' if robot.name_space else ''
    return {'prefix': prefix, 'name': robot.name, 'drive': robot.drive, 'radius': robot.radius,
            'max_speed': robot.max_speed, 'max_rotation': robot.max_rotation, 'acceleration': robot.acceleration,
            'rotation_acceleration': robot.rotation_acceleration, 'goal_tolerance': robot.goal_tolerance,
            'command_period': scenario.tick_duration, 'map': scenario.has_map, 'map_topic': rospy.resolve_name('map'),
            **more}


def text_of(value):
    return str(value).lower() if isinstance(value, bool) else str(value)


def require_nodes(file, words):
    """Checks that a launch file can be read and that its nodes are installed."""
    config = roslaunch.config.ROSLaunchConfig()
    loader = roslaunch.xmlloader.XmlLoader()
    loader.ignore_unset_args = False  # load() needs it for its message
    try:
        loader.load(file, config, argv=words, verbose=False)
    except (roslaunch.core.RLException, roslaunch.xmlloader.XmlParseException, OSError) as error:
        raise StartError(f'{file}: {error}') from None
    for node in config.nodes:
        try:
            found = roslib.packages.find_node(node.package, node.type)
        except (roslib.packages.ROSPkgException, rospkg.ResourceNotFound):
            found = None
        if not found:
            raise StartError(f'{file}: there is no node {node.package}/{node.type} in the ROS environment')


class RobotCrew:
    """Starts, checks and stops the launch files of all robots."""

    def __init__(self):
        self.files = {what: rospy.get_param('~' + what, '') for what in ('navigation', 'localisation')}
        self.more = {name: text_of(value) for name, value in rospy.get_param('~arguments', {}).items()}
        if rospy.get_param('~has_map', False):
            self.more['map'] = 'true'
        if rospy.get_param('~command_period', 0.0) > 0.0:
            self.more['command_period'] = rospy.get_param('~command_period')
        self.scenario = None  # the first one that was received
        self.launched = {}  # processes of roslaunch, by robot and what they are for
        self.states = {}  # publishers, by robot
        self.poses = {}  # publishers of initial poses, by robot
        self.episode = None  # of which initial poses were published
        rospy.Subscriber('scenario', Scenario, self.note_scenario, queue_size=10)
        if self.files['localisation']:
            rospy.Subscriber('robots', RobotStates, self.publish_poses, queue_size=10)

    def note_scenario(self, scenario):
        if self.scenario is None:
            self.scenario = scenario
        elif scenario.robots != self.scenario.robots:
            rospy.logwarn('the robots of the scenario are other ones now; their navigation remains that of the first')

    def start(self, robot):
        """Starts the launch files of a robot in its namespace."""
        self.states[robot.name] = rospy.Publisher(f'{robot.name_space}/navigation'.lstrip('/'), String, queue_size=1,
                                                  latch=True)
        environment = dict(os.environ, ROS_NAMESPACE=rospy.get_namespace() + robot.name_space)
        words = [f'{name}:={text_of(value)}' for name, value in arguments_of(robot, self.scenario, self.more).items()]
        for what, file in self.files.items():
            if not file or robot.drive == 'external':
                continue
            require_nodes(file, words)
            command = [shutil.which('roslaunch'), '--disable-title', '--skip-log-check', file, *words]
            self.launched[robot.name, what] = subprocess.Popen(command, env=environment, start_new_session=True)
        if any(name == robot.name for name, _ in self.launched):
            self.states[robot.name].publish(RUNNING)

    def publish_poses(self, states):
        """Publishes the places of the robots at the start of an episode, for their localisation."""
        if states.episode == self.episode or self.scenario is None:
            return
        names = {robot.name: robot.name_space for robot in self.scenario.robots}
        for state in states.robots:
            if state.name not in self.poses:
                topic = f'{names.get(state.name, "")}/initialpose'.lstrip('/')
                self.poses[state.name] = rospy.Publisher(topic, PoseWithCovarianceStamped, queue_size=1, latch=True)
            pose = PoseWithCovarianceStamped()
            pose.header = states.header
            pose.pose.pose.position.x, pose.pose.pose.position.y = state.pose.x, state.pose.y
            orientation = pose.pose.pose.orientation
            orientation.z, orientation.w = math.sin(state.pose.theta / 2), math.cos(state.pose.theta / 2)
            for place, variance in VARIANCES.items():
                pose.pose.covariance[place] = variance
            self.poses[state.name].publish(pose)
        self.episode = states.episode

    def check(self):
        """Reports launch files that have ended."""
        for (name, what), process in list(self.launched.items()):
            if process.poll() is None:
                continue
            rospy.logerr("robot '%s': %s: crashed; its launch file %s. The crowd goes on", name, what,
                         ending_of(process.returncode))
            self.states[name].publish(CRASHED)
            del self.launched[name, what]

    def run(self):
        try:
            while self.scenario is None and not is_ending():
                time.sleep(PERIOD)
            for robot in self.scenario.robots if self.scenario else []:
                if not is_ending():
                    self.start(robot)
            while not is_ending():
                time.sleep(PERIOD)
                if not is_ending():
                    self.check()
        finally:
            # A SIGINT while roslaunch reads its files would print a traceback.
            stop_nodes(list(self.launched.values()), signal.SIGTERM)


def main():
    init_node('robot_crew')
    try:
        RobotCrew().run()
    except rospy.ROSException:
        if not is_ending():  # else a topic was closed by the shutdown
            raise
    except StartError as error:
        rospy.logfatal('%s', error)
        return 1
    return 0
