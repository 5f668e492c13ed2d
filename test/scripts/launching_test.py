"""Python programs that roslaunch starts: scripts/show_crowd, learner_crew, robot_crew and play_bag."""
import itertools
import os
import random
import signal
import socket
import types

import pytest
import rospy
from crowd_launching import back_off, robot_crew
from crowd_launching.nodes import ending_of
from crowd_launching.program import LOWEST_PORT, free_port
from crowd_launching.rviz import MOST, draws_in_software, scale_for, sides_of
from geometry_msgs.msg import Point, Pose2D
from nav_msgs.msg import Odometry
from programs import assert_says, wait_for
from roslib.packages import find_node
from sensor_msgs.msg import LaserScan
from social_crowd.msg import (AgentState, ObstacleState, RobotDescription, RobotState, RobotStates, Scenario,
                              Wall)

# Substitute for rospy whose import never ends.
SLOW_IMPORT = """
import time
open({!r}, 'w').close()
while True:
    time.sleep(0.1)
"""


def program(name):
    """Returns the path of a program."""
    return find_node('social_crowd', name)[0]


class PortTest:
    """Ports for ROS masters."""

    def test_no_program_that_asks_for_any_port_gets_it(self):
        with open('/proc/sys/net/ipv4/ip_local_port_range', encoding='ascii') as stream:
            lowest_given = int(stream.read().split()[0])
        if lowest_given <= LOWEST_PORT:
            pytest.skip('the system gives all ports')
        assert all(LOWEST_PORT <= free_port() < lowest_given for _ in range(20))

    def test_a_port_in_use_is_not_returned(self, monkeypatch):
        with socket.socket() as server:
            used = free_port()
            server.bind(('127.0.0.1', used))
            draws = itertools.chain((used, used), itertools.count(used + 1))
            monkeypatch.setattr(random, 'randrange', lambda *_: next(draws))
            assert free_port() > used


class SoftwareTest:
    """Whether RViz draws in software, where edges are not smoothed."""

    def test_by_variable_and_devices(self, tmp_path):
        card = tmp_path / 'card0'
        assert draws_in_software({}, [str(card)])
        card.touch()
        assert not draws_in_software({}, [str(tmp_path / 'card*')])
        assert not draws_in_software({'LIBGL_ALWAYS_SOFTWARE': '0'}, [str(card)])
        assert draws_in_software({'LIBGL_ALWAYS_SOFTWARE': '1'}, [str(card)])


class ViewTest:
    """Scale with which RViz shows a whole scenario."""

    def test_agents_goals_obstacles_and_walls(self):
        scenario = Scenario(agents=[AgentState(pose=Pose2D(1.0, 2.0, 0.0), goal=Point(3.0, 5.0, 0.0))])
        assert sides_of(scenario) == [2.0, 3.0]
        scenario.obstacles = [ObstacleState(position=Point(4.0, 2.0, 0.0))]
        assert sides_of(scenario) == [3.0, 3.0]
        scenario.walls = [Wall(Point(-6.0, 3.0, 0.0), Point(2.0, 12.0, 0.0))]
        assert sides_of(scenario) == [10.0, 10.0]
        assert scale_for(scenario) == pytest.approx(700.0 / 12.0)

    def test_walls_alone_and_nothing(self):
        assert sides_of(Scenario(walls=[Wall(Point(0.0, 0.0, 0.0), Point(98.0, 0.0, 0.0))])) == [98.0, 0.0]
        assert scale_for(Scenario()) == MOST


class StartTest:
    """Behaviour before the connection to a ROS master."""

    @pytest.mark.parametrize('name', ['show_crowd', 'learner_crew'])
    def test_stopped_while_it_starts(self, runner, name):
        mark = runner.path('importing')
        runner.write('rospy.py', SLOW_IMPORT.format(mark))
        path = f"{runner.folder}:{os.environ['PYTHONPATH']}"
        process = runner.start(name, [program(name)], {'PYTHONPATH': path, 'DISPLAY': ':0'})
        wait_for(lambda: os.path.exists(mark), 'the import')
        process.signal(signal.SIGINT)
        process.wait()
        assert process.output() == ''

    @pytest.mark.parametrize('display', [{}, {'DISPLAY': ''}])
    def test_no_display(self, runner, display, monkeypatch):
        monkeypatch.delenv('DISPLAY', raising=False)
        process = runner.start('show_crowd', [program('show_crowd')], display)
        assert process.wait() == 1
        assert_says(process.output(), 'there is no display', 'DISPLAY', 'rviz:=false')
        assert 'Traceback' not in process.output()


class BackOffTest:
    """Backing off, with messages in place of a robot."""

    def start(self, monkeypatch):
        """Returns a BackOff that has begun to drive, and its commands [m/s]."""
        commands = []
        monkeypatch.setattr(back_off.rospy, 'get_param', lambda name, default: default)
        monkeypatch.setattr(back_off.rospy, 'Subscriber', lambda *arguments, **options: None)
        monkeypatch.setattr(back_off.rospy, 'Publisher', lambda *arguments, **options: types.SimpleNamespace(
            publish=lambda command: commands.append(command.linear.x)))
        started = back_off.BackOff()
        started.note_scan(LaserScan(angle_min=0.0, angle_increment=1.0, ranges=[5.0]))
        assert not started.is_done()
        started.drive(odometry_at(0.0, 1))
        started.drive(odometry_at(-0.1, 2))
        return started, commands

    def test_stops_the_robot_on_its_way(self, monkeypatch):
        started, commands = self.start(monkeypatch)
        assert commands == [-back_off.SPEED, -back_off.SPEED]
        started.stop()
        assert commands[2:] == [0.0]
        started.drive(odometry_at(-0.2, 3))  # comes too late
        started.stop()
        assert commands[2:] == [0.0]

    def test_ends_after_its_way(self, monkeypatch):
        started, commands = self.start(monkeypatch)
        started.drive(odometry_at(-0.3, 3))
        started.drive(odometry_at(-0.3, 4))
        assert commands[2:] == [0.0]


def odometry_at(place, seconds):
    """Returns a message of the odometry at a place [m] and a time."""
    message = Odometry()
    message.pose.pose.position.x = place
    message.header.stamp = rospy.Time(seconds)
    return message


class CrewTest:
    """Messages of learner_crew for learners that end."""

    def test_endings(self):
        assert ending_of(2) == 'ended with exit status 2'
        assert ending_of(-signal.SIGKILL) == 'was killed by signal 9 (SIGKILL)'
        assert ending_of(-40) == 'was killed by signal 40'


class RobotCrewTest:
    """robot_crew, with messages in place of a scenario's robots."""

    def test_one_publisher_of_poses_a_robot(self, monkeypatch):
        topics, published = [], []

        def publisher(topic, *_arguments, **_options):
            topics.append(topic)
            return types.SimpleNamespace(publish=published.append)

        monkeypatch.setattr(robot_crew.rospy, 'get_param', lambda name, default: default)
        monkeypatch.setattr(robot_crew.rospy, 'Subscriber', lambda *arguments, **options: None)
        monkeypatch.setattr(robot_crew.rospy, 'Publisher', publisher)
        crew = robot_crew.RobotCrew()
        crew.note_scenario(Scenario(robots=[RobotDescription(name='tug', name_space='robots/tug'),
                                            RobotDescription(name='cart')]))
        for episode in (1, 1, 2, 3):
            crew.publish_poses(RobotStates(episode=episode, robots=[RobotState(name='tug'), RobotState(name='cart')]))
        assert topics == ['robots/tug/initialpose', 'initialpose']
        assert len(published) == 2 * 3
