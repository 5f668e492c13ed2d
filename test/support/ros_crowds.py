"""A ROS master of a test, on a free port, and the nodes of a crowd."""
import os
import re
import subprocess

import rosgraph
from crowd_launching.program import free_port
from programs import ANTICIPATION_TABLE, CIRCLE6, PATIENCE, wait_for
from roslib.packages import find_node


def environment_of(runner, port):
    """Returns the environment of nodes with a ROS master at a port."""
    return {'ROS_MASTER_URI': f'http://127.0.0.1:{port}', 'ROS_HOSTNAME': '127.0.0.1', 'ROS_NAMESPACE': '',
            'ROS_HOME': runner.path('ros'), 'ROS_LOG_DIR': runner.path('ros/log')}


class Ros:
    """A ROS master of its own, and a crowd."""

    def __init__(self, runner):
        self.runner = runner
        port = free_port()
        self.environment = environment_of(runner, port)
        uri = self.environment['ROS_MASTER_URI']
        self.master = rosgraph.Master('/web_server_test', uri)
        runner.start('rosmaster', ['rosmaster', '--core', '-p', str(port)], self.environment)
        wait_for(self.master.is_online, 'the ROS master')

    def start_node(self, kind, **parameters):
        words = [f'_{name}:={value}' for name, value in parameters.items()]
        return self.runner.start(kind, [find_node('social_crowd', kind)[0], *words], self.environment)

    def start_crowd(self, scenario=CIRCLE6, **parameters):
        """Starts a crowd that walks in real time."""
        self.start_node('crowd_controller', scenario=scenario, **parameters)
        self.start_node('learner', q_table=ANTICIPATION_TABLE)
        wait_for(lambda: '/crowd_controller/pause' in self.services(), 'the crowd controller')

    def pause(self):
        """Pauses the crowd and waits until it rests. Returns the tick."""
        done = subprocess.run(['rosservice', 'call', '/crowd_controller/pause', 'true'], stdout=subprocess.PIPE,
                              env={**os.environ, **self.environment}, timeout=PATIENCE, check=True)
        return int(re.search(r'paused at episode \d+, tick (\d+)', done.stdout.decode())[1])

    def services(self):
        return {name for name, _ in self.master.getSystemState()[2]}

    def topics_of(self, node):
        """Returns the topics to which a node has subscribed."""
        return {topic for topic, nodes in self.master.getSystemState()[1] if node in nodes}
