#!/usr/bin/python3
"""Runs the example of docs/own_learner.md."""
import os
import re

import rosgraph
import support
from social_crowd.msg import EpisodeResult, Perceptions

PAIR = """
name: pair
duration: 60
goal_tolerance: 0.3
agents:
  - {position: [0, 0], goal: [4, 0], speed: 1, radius: 0.25, heading: 90}
  - {position: [0, 5], goal: [4, 5], speed: 1, radius: 0.25}
"""


class OwnLearnerPageTest(support.CrowdTestCase):
    """docs/own_learner.md: a learner in Python, and how it shares a crowd with the shipped one."""

    def start_example(self, **parameters):
        """Starts the page's learner."""
        file = self.write('my_learner.py', support.page_examples('own_learner.md')['my_learner.py'])
        words = [f'_{name}:={value}' for name, value in parameters.items()]
        os.chmod(file, 0o755)
        return self.start('my_learner', [file, *words])

    def start_with_own_topic(self, **parameters):
        """Starts the page's learner with the change that gives it a topic of its own."""
        page = support.read_text(support.in_package('docs', 'own_learner.md'))
        code = support.page_examples('own_learner.md')['my_learner.py']
        change = re.search(r'^## Only its own agents$.*?^```python\n(.*?)^```$', page, re.DOTALL | re.MULTILINE)[1]
        subscription = re.search(r'^ +rospy.Subscriber.*\n', code, re.MULTILINE)[0]
        code = code.replace(subscription, change).replace('import Perceptions', 'import LearnerStatus, Perceptions')
        file = self.write('my_learner.py', code)
        os.chmod(file, 0o755)
        return self.start('my_learner', [file, *(f'_{name}:={value}' for name, value in parameters.items())])

    def arrivals(self, episodes):
        """Returns the number of arrivals in each episode; no answer may be missed."""
        results = self.listen('episode_results', EpisodeResult)
        self.start_controller(self.write('pair.yaml', PAIR), episodes=episodes, paused=True)
        results.wait_connected()
        self.succeed('crowd_controller/pause', data=False)
        results.wait(lambda result: result.episode == episodes - 1, 'of the last episode')
        self.assertEqual({result.missed_answers for result in results.messages}, {0})
        return [[agent.arrived for agent in result.agents] for result in results.messages]

    def test_example_learns_to_reach_its_goal(self):
        self.start_example()
        arrived = self.arrivals(8)
        self.assertEqual(arrived[-1], [True, True], arrived)

    def test_example_shares_a_crowd_with_the_shipped_learner(self):
        self.start_learner(agents=[1], q_table=support.ANTICIPATION_TABLE)
        self.start_example(agents='[0]')
        arrived = self.arrivals(8)
        self.assertEqual(arrived[-1], [True, True], arrived)

    def test_example_with_a_topic_of_its_own(self):
        self.start_learner(agents=[1], q_table=support.ANTICIPATION_TABLE)
        self.start_with_own_topic(agents='[0]')
        topic = f'{self.namespace}/perceptions{self.namespace}/my_learner'
        received = self.listen(topic, Perceptions)
        arrived = self.arrivals(8)
        self.assertEqual(arrived[-1], [True, True], arrived)
        self.assertEqual({agent.agent for message in received.messages for agent in message.agents}, {0})
        subscribers = dict(rosgraph.Master('/documentation_test').getSystemState()[1])
        self.assertIn(f'{self.namespace}/my_learner', subscribers[topic])
        self.assertNotIn(f'{self.namespace}/perceptions', subscribers)

    def test_arguments_on_the_page_exist(self):
        page = support.read_text(support.in_package('docs', 'own_learner.md'))
        self.assertIn('demo.launch agents:="[1, 2, 3, 4, 5]"', page)
        served = self.start('roslaunch', ['roslaunch', 'social_crowd', 'demo.launch', 'rviz:=false',
                                          'real_time_factor:=fast', 'episodes:=1', 'agents:=[1, 2, 3, 4, 5]'])
        self.start_example(agents='[0]')
        self.assertEqual(served.wait(), 0, served.output())
        self.assert_says(served.output(), ' 0 answers missed')


if __name__ == '__main__':
    support.run('documentation_test')
