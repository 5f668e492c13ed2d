#!/usr/bin/python3
"""Launches on a parameter server with parameters of earlier launches."""
import rospy
import support
from launching import LaunchTestCase


class LeftoverTest(LaunchTestCase):
    """Parameters that an earlier launch left on the parameter server have no effect."""

    def leave(self, node, **parameters):
        """Sets parameters of a node that does not run."""
        for name, value in parameters.items():
            rospy.set_param(f'{self.namespace}/{node}/{name}', value)

    def check(self, **arguments):
        """Checks that these parameters have no effect on a demo."""
        missing = self.path('missing.yaml')
        self.leave('crowd_controller', config=missing, no_such=1)
        self.leave('crowd_markers', rate=-1.0)
        self.leave('learner', config=missing, alpha=-1)
        self.leave('learner_crew/learner', config=missing, alpha=-1)
        self.leave('learner_0', config=missing, alpha=-1)
        self.assert_ends_well(self.demo(episodes=1, **arguments))

    def test_one_learner(self):
        self.check()

    def test_a_learner_for_each_agent(self):
        self.check(learners='per_agent')

    def test_nodelets(self):
        self.check(nodelets='true')

    def test_training(self):
        self.leave('crowd_controller', paused=True)
        self.leave('learner', alpha=-1)
        self.assert_ends_well(self.launch('train.launch', output=self.path('table.txt'), episodes=1))


if __name__ == '__main__':
    support.run('launch_leftovers_test')
