"""Starts one learner node per agent, see scripts/learner_crew."""
import os
import signal
import subprocess
import sys
import time

import roslib.packages
import rospy
from social_crowd.msg import Scenario


def ending_of(status):
    if status >= 0:
        return 'ended with exit status %d' % status
    name = {number.value: ' (%s)' % number.name for number in signal.Signals}.get(-status, '')
    return 'was killed by signal %d%s' % (-status, name)


class LearnerCrew:
    """Starts, checks and stops the learners."""

    PATIENCE = 5.0  # [s] time for a learner to save its table and end
    PERIOD = 0.05  # [s] between two checks

    def __init__(self):
        self.learner = roslib.packages.find_node('social_crowd', 'learner')[0]
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
        # Replaces all parameters of an earlier learner with this name.
        rospy.set_param(rospy.resolve_name(name), parameters)
        # In its own process group, so that Ctrl-C is sent to this node only, which then stops the learners.
        self.learners[agent] = subprocess.Popen([self.learner, '__name:=' + name, '__ns:=' + rospy.get_namespace()],
                                                start_new_session=True)

    def check(self):
        for agent, learner in self.learners.items():
            if learner.poll() is not None and agent not in self.ended:
                rospy.logerr('learner_%d %s', agent, ending_of(learner.returncode))
                self.ended.add(agent)
                if learner.returncode > 0:  # the start failed; a learner that was killed has a negative code
                    raise ChildProcessError('learner_%d could not be started' % agent)

    def run(self):
        try:
            while not rospy.is_shutdown():
                for agent in range(self.wanted):
                    if agent not in self.learners and (not self.agents or agent in self.agents):
                        self.start_learner(agent)
                self.check()
                time.sleep(self.PERIOD)
        finally:
            self.stop()

    def stop(self):
        for learner in self.learners.values():
            learner.send_signal(signal.SIGINT)  # as Ctrl-C: the learner saves its table and ends
        for learner in self.learners.values():
            try:
                learner.wait(self.PATIENCE)
            except subprocess.TimeoutExpired:
                learner.kill()


def main():
    try:
        rospy.init_node('learner_crew')
    except rospy.ROSInitException:
        if rospy.is_shutdown():  # interrupted during initialisation
            return
        raise
    learners = rospy.get_param('~learners', 'per_agent')
    if learners != 'per_agent':
        sys.exit("learner_crew: ~learners: expected one, per_agent or none, got '%s'" % learners)
    try:
        LearnerCrew().run()
    except ChildProcessError as error:
        sys.exit('learner_crew: %s' % error)
