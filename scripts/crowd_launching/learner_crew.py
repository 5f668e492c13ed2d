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
    """How a process ended, by the exit status that subprocess tells."""
    if status >= 0:
        return 'ended with exit status %d' % status
    name = {number.value: ' (%s)' % number.name for number in signal.Signals}.get(-status, '')
    return 'was killed by signal %d%s' % (-status, name)


class LearnerCrew:
    """The learners started so far."""

    PATIENCE = 5.0  # [s] a learner has to save its table and end
    PERIOD = 0.05  # [s] between two looks

    def __init__(self):
        self.learner = roslib.packages.find_node('social_crowd', 'learner')[0]
        self.parameters = rospy.get_param('~learner', {})
        self.agents = rospy.get_param('~agents', [])  # empty: all
        self.learners = {}  # processes, by agent
        self.ended = set()  # agents whose learner ended by itself; not started again
        self.wanted = 0
        rospy.Subscriber('scenario', Scenario, self.note_scenario, queue_size=10)

    def note_scenario(self, scenario):
        self.wanted = max(self.wanted, len(scenario.agents))

    def parameters_of(self, agent):
        parameters = dict(self.parameters, agents=[agent])
        if parameters.get('save_to') and parameters.get('tables') != 'own':  # who has own tables names files so itself
            stem, ending = os.path.splitext(parameters['save_to'])
            parameters['save_to'] = '%s_agent_%d%s' % (stem, agent, ending)
        return parameters

    def start_learner(self, agent):
        name = 'learner_%d' % agent
        # Replaces all parameters that an earlier learner of this name left.
        rospy.set_param(rospy.resolve_name(name), self.parameters_of(agent))
        # A process group of its own, so that Ctrl-C reaches this node first and learners end in order.
        self.learners[agent] = subprocess.Popen([self.learner, '__name:=' + name, '__ns:=' + rospy.get_namespace()],
                                                start_new_session=True)

    def check(self):
        for agent, learner in self.learners.items():
            if learner.poll() is not None and agent not in self.ended:
                rospy.logerr('learner_%d %s', agent, ending_of(learner.returncode))
                self.ended.add(agent)
                if learner.returncode > 0:  # it could not even begin; who was killed (below 0) may be started again
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
            learner.send_signal(signal.SIGINT)  # as Ctrl-C: it saves what it has learned, and ends
        for learner in self.learners.values():
            try:
                learner.wait(self.PATIENCE)
            except subprocess.TimeoutExpired:
                learner.kill()


def main():
    """Runs a crew until it is told to end."""
    try:
        rospy.init_node('learner_crew')
    except rospy.ROSInitException:
        if rospy.is_shutdown():  # told to end already
            return
        raise
    learners = rospy.get_param('~learners', 'per_agent')
    if learners != 'per_agent':
        sys.exit("learner_crew: ~learners: expected one or per_agent, got '%s'" % learners)
    try:
        LearnerCrew().run()
    except ChildProcessError as error:
        sys.exit('learner_crew: %s' % error)
