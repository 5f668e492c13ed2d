#!/usr/bin/python3
"""The topic decision_values of a learner, and its picture in the markers."""
import math

import rospy
import support
from learning_files import q_table_text
from perceiving import add_agent, ahead, perceptions
from picturing import Picture, agent_at
from social_crowd.msg import AgentStates, DecisionValues, Scenario
from std_msgs.msg import Int32
from teaching import LearnerTestCase

BEHIND = 4  # row of a free agent whose goal lies behind it
VISITS, VALUES = (7, 0, 0, 0, 1200, 0, 3, 0), (-2.0, 0.0, 0.0, 0.0, 5.5, 0.0, 1.0, 0.0)  # of its actions


class DecisionValuesTest(LearnerTestCase):
    """A learner, and the test in place of crowd_controller and crowd_markers."""

    def start_known(self, **parameters):
        """Starts a learner with the entries of one row."""
        row = dict(enumerate(zip(VISITS, VALUES)))
        self.start_one(q_table=self.write('table.txt', q_table_text({BEHIND: row})), **parameters)

    def choose(self, agent):
        """Chooses an agent, as crowd_markers does."""
        publisher = rospy.Publisher(f'{self.namespace}/chosen_agent', Int32, queue_size=10, latch=True)
        self.addCleanup(publisher.unregister)
        publisher.publish(Int32(agent))
        return publisher

    def turn_back(self, tick, agent=2):
        """Asks for the decision of an agent whose goal lies behind it. Returns the answer."""
        message = add_agent(perceptions(0, tick), 1, ahead(0, 5))
        add_agent(message, agent, ahead(180, 5))
        return self.perceiver.ask(message)

    def values_at(self, ear, tick):
        """Returns the values of a decision that is asked for until they come: the choice may not have arrived yet."""
        ticks = iter(range(tick, 10**6))

        def come():
            asked = next(ticks)
            self.turn_back(asked)
            rospy.sleep(0.01)
            return ear.messages
        support.wait_for(come, 'values of a decision')
        return ear.messages[-1]

    def test_has_the_entries_of_the_table(self):
        self.start_known()
        self.choose(2)
        values = self.values_at(self.listen('decision_values', DecisionValues), 0)
        self.assertEqual((values.episode, values.agent, values.node), (0, 2, f'{self.namespace}/learner'))
        self.assertEqual(tuple(action.visits for action in values.actions), VISITS)
        self.assertEqual(tuple(action.value for action in values.actions), VALUES)
        self.assertEqual({action.row for action in values.actions}, {BEHIND})
        turns = [math.degrees(action.direction) % 360.0 for action in values.actions]
        for turn, expected in zip(turns, range(0, 360, 45)):
            self.assertAlmostEqual(turn, expected)
        self.assertEqual((values.chosen, values.exploration), (BEHIND, False))

    def test_tells_exploration(self):
        self.start_known(mode='training', epsilon=1.0)
        self.choose(2)
        ear = self.listen('decision_values', DecisionValues)
        self.values_at(ear, 0)
        tick = 10**6
        while {values.exploration for values in ear.messages} != {True, False}:
            tick += 2  # nothing is learned across a gap
            rotation, _ = self.turn_back(tick)[2]
            values = ear.wait_at(0, tick)
            self.assertAlmostEqual(math.cos(rotation), math.cos(values.actions[values.chosen].direction))
            self.assertEqual(values.exploration, values.chosen != BEHIND)

    def test_nothing_is_published_without_subscriber_or_chosen_agent(self):
        self.start_known(agents=[1, 2])
        chosen = self.choose(2)
        self.turn_back(0)
        self.assertEqual(chosen.get_num_connections(), 0)  # the learner does not subscribe to the chosen agent
        ear = self.listen('decision_values', DecisionValues)
        self.values_at(ear, 1)
        self.assertEqual(chosen.get_num_connections(), 1)
        for other in (-1, 3):  # none, and one of another learner
            support.wait_for(lambda other=other: self.is_silent(chosen, other, ear), f'silence with agent {other}')
        ear.subscriber.unregister()
        support.wait_for(lambda: chosen.get_num_connections() == 0, 'the learner to stop listening')

    _tick = 10**5

    def next_tick(self):
        """Returns the next number of a tick."""
        self._tick += 1
        return self._tick

    def is_silent(self, publisher, agent, ear):
        """Returns whether no values of a decision come after another agent is chosen: those of a later one have come,
        with agent 2 chosen again. The choice may not have arrived before the decision."""
        publisher.publish(Int32(agent))
        for _ in range(5):
            asked = self.next_tick()
            self.turn_back(asked)
        publisher.publish(Int32(2))

        def is_later():
            self.turn_back(self.next_tick())
            return ear.messages[-1].tick > asked
        support.wait_for(is_later, 'values again')
        return asked not in {values.tick for values in ear.messages}

    def test_markers_show_the_values_of_the_chosen_agent(self):
        self.start_known()
        self.start_node('crowd_markers', 'crowd_markers', {'agent': 2})
        picture = Picture(f'{self.namespace}/markers')
        self.addCleanup(picture.close)
        scenario = rospy.Publisher(f'{self.namespace}/scenario', Scenario, queue_size=10, latch=True)
        agents = rospy.Publisher(f'{self.namespace}/agents', AgentStates, queue_size=10)
        for publisher in (scenario, agents):
            self.addCleanup(publisher.unregister)
        scenario.publish(Scenario(episode=0, agents=[agent_at(1, 9.0, 0.0), agent_at(2, 0.0, 0.0)]))
        support.wait_for(lambda: self.turn_back(self.next_tick()) and 'values' in picture.kinds(), 'wedges')
        texts = [marker.text for marker in picture.markers('visits')]
        self.assertEqual(texts, ['7', '0', '0', '0', '1.2k', '0', '3', '0'])
        outline = picture.markers('values')[1]
        middle = sum(point.x for point in outline.points) / len(outline.points)
        self.assertLess(middle, -0.5)  # behind the agent
        self.succeed('crowd_markers/choose_agent', agent=-1)
        support.wait_for(lambda: not picture.kinds() & {'values', 'visits'}, 'no values')
        self.assertEqual(picture.markers('visits'), [])


if __name__ == '__main__':
    support.run('decision_values_test')
