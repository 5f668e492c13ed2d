"""Starts one learner node per agent, see scripts/learner_crew."""
import os
import sys
import time

import rospy
from social_crowd.msg import Scenario

from .init_node import init_node, is_ending
from .nodes import NodeError, ending_of, start_node, stop_nodes


class LearnerCrew:
    """Starts, checks and stops the learners."""

    PERIOD = 0.05  # [s] between two checks

    def __init__(self):
        self.parameters = rospy.get_param('~learner', {})
        self.agents = rospy.get_param('~agents', [])  # empty: all
        self.learners = {}  # processes, by agent
        self.ended = set()  # agents whose learner has ended by itself and is not restarted
        self.wanted = 0
        rospy.Subscriber('scenario', Scenario, self.note_scenario, queue_size=10)

    def note_scenario(self, scenario):
        self.wanted = max(self.wanted, len(scenario.agents))

    def start_learner(self, agent):
        name, parameters = 'learner_%d' % agent, dict(self.parameters, agents=[agent])
        if parameters.get('save_to') and parameters.get('tables') != 'own':  # own tables: the learner adds it
            stem, ending = os.path.splitext(parameters['save_to'])
            parameters['save_to'] = '%s_agent_%d%s' % (stem, agent, ending)
        self.learners[agent] = start_node('learner', name, parameters)

    def check(self):
        for agent, learner in self.learners.items():
            if learner.poll() is not None and agent not in self.ended:
                rospy.logerr('learner_%d %s', agent, ending_of(learner.returncode))
                self.ended.add(agent)
                if learner.returncode > 0:  # the start failed; a learner that was killed has a negative code
                    raise NodeError('learner_%d could not be started' % agent)

    def run(self):
        try:
            while not is_ending():
                for agent in range(self.wanted):
                    if is_ending():
                        return
                    if agent not in self.learners and (not self.agents or agent in self.agents):
                        self.start_learner(agent)
                self.check()
                time.sleep(self.PERIOD)
        finally:
            stop_nodes(list(self.learners.values()))


def main():
    init_node('learner_crew')
    learners = rospy.get_param('~learners', 'per_agent')
    if learners != 'per_agent':
        sys.exit("learner_crew: ~learners: expected one, per_agent or none, got '%s'" % learners)
    try:
        LearnerCrew().run()
    except NodeError as error:
        sys.exit('learner_crew: %s' % error)
