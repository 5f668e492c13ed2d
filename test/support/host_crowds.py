"""A crowd on one host whose learners are on others."""
import json
import os
import subprocess
import sys

from programs import ANTICIPATION_TABLE, PATIENCE, read_text, wait_for
from roslib.packages import find_node

AGENTS = 200
RECORDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'crowd_recorder.py')
BOX = '{box: [[-14, -14], [14, 14]]}'
# A crowd at 0.25 agents per square metre that walks to and fro, so that no agent arrives.
CROWD = ('name: crowd\nduration: {seconds}\ngoal_tolerance: 0.3\nagents:\n'
         '  - {{count: {agents}, position: {box}, goals: [{goals}], speed: [0.9, 1.4], radius: [0.2, 0.3]}}\n')


def crowd_scenario(seconds):
    """Returns a scenario with AGENTS agents that walk during the whole episode."""
    return CROWD.format(seconds=seconds, agents=AGENTS, box=BOX, goals=', '.join([BOX] * (10 + int(seconds / 5))))


def program(name):
    """Returns a program of the package."""
    return find_node('social_crowd', name)[0]


class HostCrowd:
    """Master and controller on the first host, and a learner on each other host for its share of the agents."""

    def __init__(self, runner, network, learners=2):
        self.runner = runner
        self.crowd = network.add('crowd')
        self.learners = [network.add(f'learner{i}') for i in range(learners)]

    def start(self, host, name, command):
        """Starts a program on a host."""
        return self.runner.start(f'{host.name}_{name}', host.command(*command), host.environment())

    def start_master(self):
        """Starts the ROS master."""
        return self.start(self.crowd, 'master', ['/usr/bin/rosmaster', '--core', '-p', '11311'])

    def start_learners(self):
        """Starts the learners."""
        for i, host in enumerate(self.learners):
            self.start(host, 'learner', [program('learner'), f'__name:=learner_{i}', f'_q_table:={ANTICIPATION_TABLE}',
                                         f'_share:={i}', f'_shares:={len(self.learners)}'])

    def start_controller(self, scenario, **parameters):
        """Starts the controller."""
        words = [f'_{name}:={value}' for name, value in dict({'scenario': scenario}, **parameters).items()]
        return self.start(self.crowd, 'controller', [program('crowd_controller'), *words])

    def start_recorder(self):
        """Starts to record what the controller says."""
        self.records = self.runner.path('records.json')
        return self.start(self.crowd, 'recorder', [sys.executable, RECORDER, self.records])

    def recorded(self, topic):
        """Returns what the controller has said on a topic so far."""
        lines = read_text(self.records).splitlines(keepends=True) if os.path.exists(self.records) else []
        found = [json.loads(line) for line in lines if line.endswith('\n')]
        return [record for record in found if record['topic'] == topic]

    def wait(self, topic, fits, what, seconds=PATIENCE):
        """Waits for the newest record of a topic to meet a condition. Returns it."""
        def newest():
            records = self.recorded(topic)
            return records[-1] if records and fits(records[-1]) else None
        return wait_for(newest, what, seconds)

    def call(self, service, *arguments):
        """Calls a service of the controller."""
        command = self.crowd.command('rosservice', 'call', f'/crowd_controller/{service}', *arguments)
        done = subprocess.run(command, env={**os.environ, **self.crowd.environment()}, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, timeout=PATIENCE, check=False)
        assert done.returncode == 0 and 'success: True' in done.stdout, done.stdout

    def share_of(self, learner):
        """Returns the agents of a learner."""
        return set(range(learner, AGENTS, len(self.learners)))
