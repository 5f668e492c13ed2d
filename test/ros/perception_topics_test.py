#!/usr/bin/python3
"""Learners with a list of agents receive the perceptions of these agents only, on topics of their own."""
import copy
import io
import math

import rosgraph
import rospy
import support
from answering import AHEAD, Answers, actions_for
from social_crowd.msg import LearnerStatus, Perceptions, RelativeActions
from walking import WalkTestCase

# Six agents on a circle that sees all of itself, and walls.
SIX = """
name: six
order: {order}
duration: {duration}
goal_tolerance: 0.3
agents:
{agents}
walls:
  - [[0.5, -4], [0.5, -3]]
  - [[-4, 3.5], [4, 3.5]]
"""
WIDE = 9.0  # [m]


def six(order='simultaneous', duration=4):
    """Returns a scenario with six agents. Some of them arrive earlier than others."""
    lines = []
    for i in range(6):
        x, y = 3 * math.cos(i * math.pi / 3), 3 * math.sin(i * math.pi / 3) + 0.01 * i
        share = (1, 0.1, 0.9, 0.2, 0.3, 0.4)[i]  # of the way to the other side
        goal = [x * (1 - 2 * share), y * (1 - 2 * share)]
        lines.append(f'  - {{position: [{x:.3f}, {y:.3f}], goal: [{goal[0]:.3f}, {goal[1]:.3f}], speed: 1.2, '
                     'radius: 0.25}')
    return SIX.format(order=order, duration=duration, agents='\n'.join(lines))


def cut(message, agents):
    """Returns a copy of a message with some of its agents only."""
    part = copy.copy(message)
    part.agents, part.neighbours, part.walls = [], [], []
    for agent in message.agents:
        if agent.agent not in agents:
            continue
        mine = copy.copy(agent)
        mine.first_neighbour, mine.first_wall = len(part.neighbours), len(part.walls)
        part.neighbours += message.neighbours[agent.first_neighbour:agent.first_neighbour + agent.neighbour_count]
        part.walls += message.walls[agent.first_wall:agent.first_wall + agent.wall_count]
        part.agents.append(mine)
    return part


def serialized(message):
    """Returns the bytes of a message on the wire, without the number that its publisher counts."""
    message.header.seq = 0
    buffer = io.BytesIO()
    message.serialize(buffer)
    return buffer.getvalue()


def turn_of(message):
    """Returns what identifies the perceptions."""
    return message.episode, message.tick, message.turn, message.last


def without_repeats(messages):
    """Returns the messages without those that were published again, which must be equal."""
    turns = {}
    for message in messages:
        found = turns.setdefault(turn_of(message), message)
        assert serialized(found) == serialized(message), f'different perceptions of {turn_of(message)}'
    return list(turns.values())


class TopicsTestCase(WalkTestCase):
    """Helpers of all tests."""

    def full(self, learner):
        """Returns the topic of a learner of this test."""
        return f'{self.namespace}/perceptions{self.namespace}/{learner}'

    def listen_to(self, learner):
        """Listens to the topic of a learner."""
        return self.listen(self.full(learner), Perceptions).wait_connected()

    def subscribers(self, topic):
        """Returns the nodes that subscribe to a topic, without this test."""
        subscribers = dict(rosgraph.Master('/perception_topics_test').getSystemState()[1])
        return [name for name in subscribers.get(topic, []) if name != rospy.get_name()]

    def is_published(self, topic):
        """Returns whether the master knows a publisher of a topic."""
        return topic in dict(rosgraph.Master('/perception_topics_test').getSystemState()[0])


class SplitTest(TopicsTestCase):
    """What learner nodes receive."""

    def walk_split(self, scenario, shares, **parameters):
        """Walks an episode with a learner for each share of the agents. Returns what the topics contained, by learner,
        with all perceptions as None; the recording must be that of a run without ROS."""
        file = self.write('six.yaml', scenario)
        for name, agents in shares.items():
            self.start_learner(name, q_table=support.ANTICIPATION_TABLE, agents=agents)
        self.start_walk(file, episodes=2, paused=True, **parameters)
        listeners = {name: self.listen_to(name) for name in shares}
        listeners[None] = self.listen('perceptions', Perceptions).wait_connected()
        self.succeed('crowd_controller/pause', data=False)
        expected = self.headless(file, support.ANTICIPATION_TABLE, episodes=2, seed=5)
        self.assert_same_recording(self.finish_walk(), expected)
        for listener in listeners.values():
            listener.wait(lambda message: message.last and message.episode == 1, 'that is the last one')
        return {name: without_repeats(list(listener.messages)) for name, listener in listeners.items()}

    def check_split(self, messages, shares):
        """Compares the messages of each topic with those parts of the complete messages. The complete ones and those of
        the learner arrive with different connections, so each may lack the first ones."""
        complete = messages[None]
        for name, agents in shares.items():
            found, began = {turn_of(message): serialized(message) for message in messages[name]}, set()
            for message in complete:
                part = cut(message, agents)
                key = turn_of(message)
                if part.agents or message.last or message.episode not in began:
                    began.add(message.episode)
                    self.assertEqual(found.pop(key, None), serialized(part), f'{name}: {key}')
            self.assertEqual(list(found), [], f'{name}: turns of other agents')

    def test_two_learners_with_half_of_the_agents(self):
        shares = {'even': [0, 2, 4], 'odd': [1, 3, 5]}
        messages = self.walk_split(six(), shares)
        self.check_split(messages, shares)
        walking = [len(message.agents) for message in messages['odd']]
        self.assertEqual(max(walking), 3)
        self.assertEqual(walking.count(0), 2, 'when all of them have arrived, the ends of the two episodes only')
        self.assertEqual(sum(len(message.agents) for message in messages[None]),
                         sum(len(message.agents) for name in shares for message in messages[name]))

    def test_only_its_own_turn_in_sequential_order(self):
        shares = {'one': [4], 'rest': [0, 1, 2, 3, 5]}
        messages = self.walk_split(six('sequential', 1), shares)
        self.check_split(messages, shares)
        turns = [message.turn for message in messages['one'] if message.agents and not message.last]
        self.assertEqual(set(turns), {4})
        empty = [(message.episode, message.tick, message.last) for message in messages['one'] if not message.agents]
        self.assertEqual([key for key in empty if not key[2]], [(0, 0, False), (1, 0, False)])

    def test_a_learner_for_each_agent_with_nobody_on_the_complete_topic(self):
        file = self.write('six.yaml', six())
        self.start_node('learner_crew', 'learner_crew', {'learner/q_table': support.ANTICIPATION_TABLE})
        expected = self.headless(file, support.ANTICIPATION_TABLE, episodes=3, seed=5)
        self.start_walk(file, episodes=3, paused=True)
        for agent in range(6):
            self.listen_to(f'learner_{agent}')
        self.assertEqual(self.subscribers(f'{self.namespace}/perceptions'), [])
        self.succeed('crowd_controller/pause', data=False)
        self.assert_same_recording(self.finish_walk(), expected)

    def test_bytes_are_proportional_to_the_agents(self):
        shares = {'one': [0], 'two': [2, 5], 'three': [1, 3, 4]}
        self.start_controller(self.write('six.yaml', six(duration=100)), paused=True)
        for name, agents in shares.items():
            self.start_learner(name, q_table=support.ANTICIPATION_TABLE, agents=agents)
        listeners = {name: self.listen_to(name) for name in shares}
        complete = self.listen('perceptions', Perceptions).wait_connected()
        self.step(1)
        sizes = {name: len(serialized(listener.wait_at(0, 0))) for name, listener in listeners.items()}
        whole = len(serialized(complete.wait_at(0, 0)))
        empty = len(serialized(cut(complete.wait_at(0, 0), [])))
        self.assertEqual(sum(size - empty for size in sizes.values()), whole - empty)
        for name, agents in shares.items():  # each of the six sees about as much as the others
            self.assertAlmostEqual((sizes[name] - empty) / (whole - empty), len(agents) / 6, delta=0.05)

    def test_learner_that_joins_late(self):
        """It gets the awaited perceptions when it connects."""
        self.start_learner('first', q_table=support.ANTICIPATION_TABLE, agents=[0, 1, 2])
        self.start_controller(self.write('six.yaml', six()), paused=True)
        first = self.listen_to('first')
        task = self.call_later('crowd_controller/step', ticks=1)
        first.wait_at(0, 0)
        self.assertFalse(task.is_done())
        self.start_learner('second', q_table=support.ANTICIPATION_TABLE, agents=[3, 4, 5])
        self.assertEqual(task.result('the end of the tick').tick, 1)
        second = self.listen_to('second')
        self.step(1)
        self.assertEqual([agent.agent for agent in second.wait_at(0, 1).agents], [3, 4, 5])

    def test_learner_that_is_restarted_with_other_agents(self):
        """Its topic then contains those, also in the tick that waits for it."""
        file = self.write('six.yaml', six())
        learner = self.start_learner('first', q_table=support.ANTICIPATION_TABLE, agents=[0, 1, 2])
        other = self.start_learner('other', q_table=support.ANTICIPATION_TABLE, agents=[3, 4, 5])
        self.start_walk(file, episodes=1, paused=True)
        topic = self.listen_to('first')
        self.step(2)
        self.assertEqual([learner.stop(), other.stop()], [0, 0])
        task = self.call_later('crowd_controller/step', ticks=1)
        self.assertEqual([agent.agent for agent in topic.wait_at(0, 2).agents], [0, 1, 2])
        self.start_learner('first', q_table=support.ANTICIPATION_TABLE, agents=[0, 1, 2, 3, 4, 5])
        self.assertEqual(task.result('the end of the tick').tick, 3)
        topic.wait(lambda message: message.tick == 2 and len(message.agents) == 6, 'with all agents')
        self.succeed('crowd_controller/pause', data=False)
        expected = self.headless(file, support.ANTICIPATION_TABLE, seed=5)
        self.assert_same_recording(self.finish_walk(), expected)

    def test_wider_vision_while_answers_are_awaited(self):
        self.start_controller(self.write('six.yaml', six()), paused=True)
        self.start_learner('first', agents=[0, 1])  # 1 m
        first = self.listen_to('first')
        task = self.call_later('crowd_controller/step', ticks=1)
        self.assertLess(first.wait_at(0, 0).vision_radius, 2.0)
        self.start_learner('second', q_table=support.ANTICIPATION_TABLE, agents=[2, 3, 4, 5])  # 6 m
        self.assertTrue(task.result('the end of the tick').success)
        again = first.wait(lambda message: message.vision_radius > 6.0, 'with the wider vision')
        self.assertEqual((again.tick, [agent.agent for agent in again.agents]), (0, [0, 1]))


class ReportedTopicsTest(TopicsTestCase):
    """Topics in the status of learners of another kind."""

    def setUp(self):
        super().setUp()
        self.statuses = {}
        self.controller = self.start_controller(self.write('six.yaml', six(duration=100)), paused=True)
        self.answers = Answers(self)  # on the complete topic

    def report(self, learner, topic, agents=(), **fields):
        """Publishes the status of a learner."""
        if learner not in self.statuses:
            # rospy drops the oldest of many messages at once, unless the queue is unlimited.
            self.statuses[learner] = rospy.Publisher(f'{self.namespace}/learner_status', LearnerStatus, queue_size=0)
            self.addCleanup(self.statuses[learner].unregister)
            support.wait_for(lambda: self.statuses[learner].get_num_connections() > 0, 'the controller to subscribe')
        self.statuses[learner].publish(LearnerStatus(node=learner, perceptions_topic=topic, agents=agents, **fields))

    def expect_agents(self, ear, agents):
        """Walks until a topic contains these agents."""
        def has_these():
            perceptions = ear.wait_at(0, self.step().tick - 1)
            return [agent.agent for agent in perceptions.agents] == agents

        support.wait_for(has_these, f'perceptions of {agents}')

    def test_learners_that_share_a_topic(self):
        host = f'{self.namespace}/perceptions/host_2'
        self.report('/a', host, [1, 5])
        ear = self.listen(host, Perceptions).wait_connected()
        self.expect_agents(ear, [1, 5])
        self.report('/b', host, [2, 1])
        self.expect_agents(ear, [1, 2, 5])
        self.report('/a', host, [0])
        self.expect_agents(ear, [0, 1, 2])
        self.report('/b', '')
        self.expect_agents(ear, [0])
        self.report('/a', f'{self.namespace}/perceptions/elsewhere', [0])
        support.wait_for(lambda: not self.is_published(host), 'the end of the topic')
        support.wait_for(lambda: self.is_published(f'{self.namespace}/perceptions/elsewhere'), 'the other topic')

    def test_learner_in_python_with_a_topic_of_its_own(self):
        """It answers for its agents, another one for the rest; the topic has no publisher before the status."""
        mine, topic = {1, 4}, f'{self.namespace}/perceptions/my_learner'
        self.answers.silent = mine
        received = self.listen(topic, Perceptions)
        actions = rospy.Publisher(f'{self.namespace}/actions', RelativeActions, queue_size=10, latch=True)
        self.addCleanup(actions.unregister)

        def answer(message):
            reply = actions_for(message.episode, message.tick, {agent.agent: AHEAD for agent in message.agents})
            reply.header, reply.run = message.header, message.run
            actions.publish(reply)

        subscriber = rospy.Subscriber(topic, Perceptions, answer, tcp_nodelay=True)
        self.addCleanup(subscriber.unregister)
        task = self.call_later('crowd_controller/step', ticks=5)
        self.report('/my_learner', topic, sorted(mine))
        self.assertTrue(task.result('answers of both learners').success)
        received.wait_at(0, 4)
        self.assertEqual({agent.agent for message in received.messages for agent in message.agents}, mine)

    def test_invalid_topics_are_refused(self):
        parent = f'{self.namespace}/perceptions'
        invalid = ['perceptions/relative', '/perceptions/elsewhere', f'{self.namespace}/actions', parent, f'{parent}/',
                   f'{parent}/a b', f'{parent}//twice', f'{parent}/end/', f'{parent}_not_below/it']
        for number, topic in enumerate(invalid):
            self.report(f'/bad_{number}', topic, [0])
            self.report(f'/bad_{number}', topic, [0])  # one warning each
        self.report('/bad_all', f'{parent}/all', serves_all=True)
        self.report('/good', f'{parent}/good', [3, 2**32 - 1])  # agents that do not exist
        ear = self.listen(f'{parent}/good', Perceptions).wait_connected()
        self.expect_agents(ear, [3])

        def warnings():
            return [line for line in self.controller.output().splitlines() if 'perceptions_topic' in line]

        support.wait_for(lambda: len(warnings()) >= len(invalid) + 1, 'warnings')
        for number, (topic, warning) in enumerate(zip(invalid, warnings())):
            self.assert_says(warning, f"'/bad_{number}'", f"'{topic}'", f"below '{parent}/'")
        self.assert_says(warnings()[-1], "'/bad_all'", 'expected a learner that serves a list or a share of agents')
        self.assertEqual(len(warnings()), len(invalid) + 1)
        published = dict(rosgraph.Master('/perception_topics_test').getSystemState()[0])
        self.assertEqual([topic for topic in published if topic.startswith(f'{parent}/')], [f'{parent}/good'])

    def test_invalid_topic_after_a_valid_one(self):
        parent = f'{self.namespace}/perceptions'
        self.report('/a', f'{parent}/a', [0])
        support.wait_for(lambda: self.is_published(f'{parent}/a'), 'the topic')
        self.report('/a', '/a', [0])
        support.wait_for(lambda: not self.is_published(f'{parent}/a'), 'the end of the topic')


if __name__ == '__main__':
    support.run('perception_topics_test')
