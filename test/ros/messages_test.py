#!/usr/bin/python3
"""What the nodes publish: headers, episodes and ticks, frames, clock, rosbags, and the message files themselves."""
import glob
import math
import os
import re
import xmlrpc.client

import rosbag
import rosgraph
import rospy
import support
from roslib.packages import find_node
from rosgraph_msgs.msg import Clock
from social_crowd.msg import AgentStates, EpisodeResult, LearnerStatus, Perceptions, RelativeActions, Scenario
from tf2_msgs.msg import TFMessage

TOPICS = {
    'agents': AgentStates,
    'perceptions': Perceptions,
    'scenario': Scenario,
    'episode_results': EpisodeResult,
    'actions': RelativeActions,
    'learner_status': LearnerStatus,
}
# Two agents, one of which arrives; a wall and a moving obstacle. 3 s are 30 ticks.
SCENE = """
name: scene
duration: 3
goal_tolerance: 0.2
agents:
  - {position: [0, 0], goal: [0.8, 0.6], speed: 0.5, radius: 0.25}
  - {position: [3, 0], goal: [3, 9], speed: 0.5, radius: 0.3}
obstacles:
  - {position: [3, 1.5], radius: 0.4, velocity: [0.5, 0]}
walls:
  - [[2, -1], [4, -1]]
"""
# An agent that no move leads out of its box, which it touches after 1 cm, for 2 ticks.
BOX = """
name: box
duration: 0.2
goal_tolerance: 0.2
contact: solid
agents:
  - {position: [0, 0], goal: [9, 0], speed: 0.5, radius: 0.25}
walls:
  - [[-0.26, -0.26], [0.26, -0.26]]
  - [[0.26, -0.26], [0.26, 0.26]]
  - [[0.26, 0.26], [-0.26, 0.26]]
  - [[-0.26, 0.26], [-0.26, -0.26]]
"""


class BroadcastTestCase(support.CrowdTestCase):
    """A paused controller with a learner."""

    def start_all(self, scene=SCENE, table=support.NEAREST_TABLE, **parameters):
        """Starts both and listens to all topics. By the table of anticipation the agent of SCENE arrives in time."""
        self.ears = {name: self.listen(name, kind) for name, kind in TOPICS.items()}
        self.file = self.write('scene.yaml', scene)
        self.began = rospy.Time.now()
        self.start_learner(q_table=table)
        self.controller = self.start_controller(self.file, paused=True, **parameters)
        for ear in self.ears.values():
            ear.wait_connected()

    def walk_an_episode(self):
        """Walks an episode to its end and waits for all that belongs to it."""
        self.step(30)
        self.ears['episode_results'].wait_at(0, 30)
        for name in ('agents', 'perceptions'):
            self.ears[name].wait_at(0, 30)
        self.ears['actions'].wait_at(0, 29)
        self.ears['learner_status'].wait(lambda status: status.agents)


class HeadersTest(BroadcastTestCase):
    """Header, episode and tick of every message."""

    def test_all_have_frame_stamp_episode_and_tick(self):
        self.start_all()
        self.walk_an_episode()
        now = rospy.Time.now()
        for name, ear in self.ears.items():
            for message in ear.messages:
                where = f'{name}, episode {message.episode}, tick {message.tick}'
                self.assertEqual(message.header.frame_id, 'map', where)
                self.assertTrue(self.began <= message.header.stamp <= now, where)

    def test_stamps_go_forward(self):
        self.start_all()
        self.walk_an_episode()
        for name, ear in self.ears.items():
            stamps = [message.header.stamp for message in ear.messages]
            self.assertEqual(stamps, sorted(stamps), name)

    def test_ticks_have_no_gap(self):
        self.start_all()
        self.walk_an_episode()
        ticks = {name: sorted({m.tick for m in self.ears[name].messages if m.episode == 0}) for name in self.ears}
        self.assertEqual(ticks['perceptions'], list(range(31)))
        self.assertEqual(ticks['actions'], list(range(30)))
        self.assertEqual(ticks['agents'], list(range(1, 31)))  # nobody listened yet when tick 0 was told
        self.assertEqual(ticks['scenario'], [0])
        self.assertEqual(ticks['episode_results'], [30])

    def test_answers_have_the_stamp_of_what_they_answer(self):
        self.start_all()
        self.walk_an_episode()
        stamps = {(m.episode, m.tick): m.header.stamp for m in self.ears['perceptions'].messages}
        for answer in self.ears['actions'].messages:
            self.assertEqual(answer.header.stamp, stamps[answer.episode, answer.tick])

    def test_the_scenario_tells_what_the_file_says(self):
        self.start_all()
        scenario = self.ears['scenario'].wait()
        self.assertEqual((scenario.name, scenario.instance, scenario.max_ticks), ('scene', 0, 30))
        self.assertEqual((scenario.tick_duration, scenario.goal_tolerance), (0.1, 0.2))
        self.assertEqual(scenario.contact, Scenario.GHOST)
        agents = [(a.agent, a.pose.x, a.pose.y, a.goal.x, a.goal.y, a.max_speed, a.radius) for a in scenario.agents]
        self.assertEqual(agents, [(0, 0, 0, 0.8, 0.6, 0.5, 0.25), (1, 3, 0, 3, 9, 0.5, 0.3)])
        obstacle = scenario.obstacles[0]
        place = (obstacle.position.x, obstacle.position.y, obstacle.velocity.x, obstacle.velocity.y, obstacle.radius)
        self.assertEqual(place, (3, 1.5, 0.5, 0, 0.4))
        walls = [(wall.from_.x, wall.from_.y, wall.to.x, wall.to.y) for wall in scenario.walls]
        self.assertEqual(walls, [(2, -1, 4, -1)])

    def test_the_result_agrees_with_the_recording(self):
        self.start_all(table=support.ANTICIPATION_TABLE, trajectories=self.path('ros'))
        self.walk_an_episode()
        result = self.ears['episode_results'].messages[0]
        self.assertEqual((result.scenario, result.instance, result.tick), ('scene', 0, 30))
        self.assertEqual([agent.arrived for agent in result.agents], [True, False])
        self.assertEqual(result.success_percent, 50.0)
        rows = support.read_recording(self.path('ros/scene.csv'))
        for agent in result.agents:
            walk = [rows[0, tick, agent.agent] for tick in range(agent.ticks + 1)]
            length = sum(math.dist(*pair) for pair in zip(walk, walk[1:]))
            self.assertAlmostEqual(agent.path_length, length)
        self.assertNotIn((0, result.agents[0].ticks + 1, 0), rows)


class SolidTest(BroadcastTestCase):
    """Blocked moves."""

    def test_they_are_told_and_counted(self):
        self.start_all(BOX)
        self.step(2)
        result = self.ears['episode_results'].wait_at(0, 2)
        self.assertEqual(self.ears['scenario'].wait().contact, Scenario.SOLID)
        for tick in (1, 2):
            agent = self.ears['agents'].wait_at(0, tick).agents[0]
            told = (agent.blocked, agent.blocked_moves, agent.in_contact, agent.touched)
            self.assertEqual(told, (True, tick, True, True))
            self.assertLess(math.hypot(agent.pose.x, agent.pose.y), 0.015)
        self.assertEqual((result.blocked_moves, result.agents[0].blocked_moves), (2, 2))
        self.assertEqual((result.contact_percent, result.agents[0].touched), (100.0, True))


class SequentialTest(BroadcastTestCase):
    """Agents that take turns, and what is within their collision radius."""

    def test_each_agent_is_asked_in_a_turn_of_its_own(self):
        self.start_all(SCENE + 'order: sequential\n', table=support.ANTICIPATION_TABLE)
        self.step(2)
        self.ears['agents'].wait_at(0, 2)
        self.assertEqual(self.ears['scenario'].wait().order, Scenario.SEQUENTIAL)
        asked = [(m.tick, m.turn, [agent.agent for agent in m.agents]) for m in self.ears['perceptions'].messages]
        for tick in (0, 1):
            for turn in (0, 1):
                self.assertIn((tick, turn, [turn]), asked)
        velocities = [m.neighbours[0].velocity_x for m in self.ears['perceptions'].messages
                      if (m.tick, m.turn) == (0, 1)]
        self.assertNotEqual(velocities[0], 0.0, 'agent 1 should perceive that agent 0 has moved in this tick')

    def test_states_are_those_of_the_end_of_a_tick(self):
        self.start_all(SCENE + 'order: sequential\n', agents_rate=0.0)
        self.step(3)
        for tick in (1, 2, 3):
            state = self.ears['agents'].wait_at(0, tick)
            self.assertAlmostEqual(state.obstacles[0].position.x, 3 + 0.05 * tick)

    def test_collisions_are_told_and_counted(self):
        self.start_all(BOX)  # walls 0.26 m from the agent's centre
        self.step(2)
        result = self.ears['episode_results'].wait_at(0, 2)
        scenario = self.ears['scenario'].wait()
        self.assertEqual((scenario.order, scenario.collision_radius), (Scenario.SIMULTANEOUS, 0.5))
        agent = self.ears['agents'].wait_at(0, 2).agents[0]
        self.assertEqual((agent.in_collision, agent.collided), (True, True))
        self.assertEqual((result.collision_percent, result.agents[0].collided), (100.0, True))

    def test_nobody_collides_beyond_the_collision_radius(self):
        self.start_all(BOX + 'collision_radius: 0.2\n')
        self.step(2)
        result = self.ears['episode_results'].wait_at(0, 2)
        self.assertEqual(self.ears['scenario'].wait().collision_radius, 0.2)
        self.assertEqual((result.collision_percent, result.agents[0].collided), (0.0, False))


class FramesTest(BroadcastTestCase):
    """tf and clock, where they are asked for."""

    def published(self):
        """The topics that the controller publishes."""
        publishers, _, _ = rosgraph.Master('/social_crowd_test').getSystemState()
        return {topic for topic, nodes in publishers if f'{self.namespace}/crowd_controller' in nodes}

    def test_neither_unless_asked_for(self):
        self.start_all()
        self.step(1)
        self.assertFalse({'/tf', '/clock'} & self.published())
        self.assertIn(f'{self.namespace}/agents', self.published())

    def test_frames(self):
        frames = self.listen('/tf', TFMessage)
        self.start_all(table=support.ANTICIPATION_TABLE, publish_tf=True)
        frames.wait_connected()
        self.walk_an_episode()
        arrived = self.ears['episode_results'].messages[0].agents[0].ticks
        support.wait_for(lambda: len(self.transforms(frames, 'agent_1')) >= 30, 'the frames of 30 ticks')
        self.assertEqual(len(self.transforms(frames, 'agent_0')), arrived - 1, 'it has a frame until it arrives')
        for agent in (0, 1):
            states = [self.ears['agents'].wait_at(0, tick).agents[agent] for tick in range(1, 31)]
            for state, frame in zip(states, self.transforms(frames, f'agent_{agent}')):
                self.check_frame(frame, state.pose)

    def transforms(self, frames, child):
        """The transforms of an agent's frame, of episode 0."""
        begun_again = self.ears['scenario'].wait_at(1, 0).header.stamp
        return [frame for message in list(frames.messages) for frame in message.transforms
                if frame.child_frame_id == child and frame.header.stamp < begun_again]

    def check_frame(self, frame, pose):
        """Compares a transform with a pose."""
        self.assertEqual(frame.header.frame_id, 'map')
        translation, rotation = frame.transform.translation, frame.transform.rotation
        self.assertEqual((translation.x, translation.y, translation.z), (pose.x, pose.y, 0.0))
        self.assertEqual((rotation.x, rotation.y), (0.0, 0.0))
        turned = math.remainder(2 * math.atan2(rotation.z, rotation.w) - pose.theta, math.tau)
        self.assertAlmostEqual(turned, 0.0)

    def test_clock(self):
        clock = self.listen('/clock', Clock)
        self.start_all(publish_clock=True)
        clock.wait_connected()
        self.step(30)
        support.wait_for(lambda: len(clock.messages) >= 30, 'the clock of 30 ticks')
        times = [message.clock for message in clock.messages]
        for before, after in zip(times, times[1:]):
            self.assertAlmostEqual((after - before).to_sec(), support.TICK)
        stamps = [self.ears['agents'].wait_at(0, tick).header.stamp for tick in range(1, 31)]
        self.assertTrue(set(stamps) <= set(times), 'messages are stamped with the time of the clock')
        self.assertAlmostEqual((stamps[-1] - stamps[0]).to_sec(), 29 * support.TICK)
        self.assertAlmostEqual(self.ears['agents'].wait_at(0, 30).time, 30 * support.TICK)


class BagTest(BroadcastTestCase):
    """An episode in a rosbag."""

    def record(self):
        """Starts rosbag record; it listens to everything when this returns."""
        topics = [f'{self.namespace}/{name}' for name in TOPICS]
        command = find_node('rosbag', 'record')[:1] + ['--output-name', self.path('crowd.bag'), '__name:=recorder']
        recorder = self.start('recorder', command + topics)
        wanted = {(node, f'{self.namespace}/{topic}') for node, topic in (
            ('crowd_controller', 'agents'), ('crowd_controller', 'perceptions'), ('crowd_controller', 'scenario'),
            ('crowd_controller', 'episode_results'), ('learner', 'actions'), ('learner', 'learner_status'))}
        support.wait_for(lambda: all(self.is_heard(*pair) for pair in wanted), 'rosbag to listen to all topics')
        return recorder

    def node(self, name):
        """What a node tells of its connections."""
        return xmlrpc.client.ServerProxy(rosgraph.Master('/social_crowd_test').lookupNode(f'{self.namespace}/{name}'))

    def is_heard(self, node, topic):
        """Whether the recorder is connected to a node's topic."""
        connections = self.node(node).getBusInfo('/social_crowd_test')[2]
        return any('recorder' in str(connection[1]) and connection[2] == 'o' and connection[4] == topic
                   for connection in connections)

    def received(self):
        """How many messages of each topic have reached the recorder."""
        _, subscribed = self.node('recorder').getBusStats('/social_crowd_test')  # roscpp gives no status before it
        return {topic.split('/')[-1]: sum(link[2] for link in links) for topic, links in subscribed}

    def recorded(self):
        """The messages of episode 0 in the bag, by topic and tick."""
        recorded = {name: {} for name in TOPICS}
        with rosbag.Bag(self.path('crowd.bag')) as bag:
            for topic, message, _ in bag.read_messages():
                if message.episode == 0:
                    recorded[topic.split('/')[-1]][message.tick] = message
        return recorded

    def test_it_holds_the_episode(self):
        self.start_all()
        recorder = self.record()
        self.walk_an_episode()
        self.step(5)  # of the next episode, so that nothing of this one is on its way any more
        heard = {name: len(ear.messages) for name, ear in self.ears.items()}
        support.wait_for(lambda: all(self.received().get(name, 0) >= heard[name] for name in TOPICS),
                         'the messages to reach the recorder')
        self.assertEqual(recorder.stop(), 0)
        recorded = self.recorded()
        for name, ear in self.ears.items():
            expected = {message.tick: message for message in ear.messages if message.episode == 0}
            self.assertEqual(sorted(recorded[name]), sorted(expected), name)
            for tick, message in expected.items():
                self.assertEqual(str(recorded[name][tick]), str(message), f'{name} {tick}')


class MessageFilesTest(support.CrowdTestCase):
    """The .msg and .srv files."""

    def test_they_can_be_shown(self):
        commands = [['rosmsg', 'show', f'social_crowd/{name}'] for name in self.names('msg')]
        commands += [['rossrv', 'show', f'social_crowd/{name}'] for name in self.names('srv')]
        processes = [self.start('_'.join(command[1:]).replace('/', '_'), command) for command in commands]
        for process in processes:
            self.assertEqual(process.wait(), 0, process.output())

    def names(self, kind):
        """Names of all messages or services."""
        names = [os.path.splitext(os.path.basename(file))[0] for file in self.files(kind)]
        self.assertTrue(names, f'there are no .{kind} files')
        return names

    def files(self, kind):
        """All message or service files."""
        return sorted(glob.glob(support.in_package(kind, f'*.{kind}')))

    def test_every_field_has_a_comment(self):
        bare = [f'{os.path.basename(file)}:{number}: {line}' for file in self.files('msg') + self.files('srv')
                for number, line in enumerate(support.read_text(file).splitlines(), 1) if is_bare_field(line)]
        self.assertEqual(bare, [], 'fields without a comment')

    def test_every_file_begins_with_what_it_is(self):
        for file in self.files('msg') + self.files('srv'):
            self.assertTrue(support.read_text(file).startswith('# '), file)

    def test_every_published_message_has_header_episode_and_tick(self):
        for kind in TOPICS.values():
            self.assertEqual(kind.__slots__[:3], ['header', 'episode', 'tick'], kind.__name__)


class CommandLineTest(support.CrowdTestCase):
    """Services as people call them by hand."""

    def call_set_learning_parameters(self, argument):
        """Calls the service by hand; the exit status and what was printed."""
        service = f'{self.namespace}/learner/set_learning_parameters'
        rospy.wait_for_service(service, support.PATIENCE)
        caller = self.start('rosservice', ['rosservice', 'call', service, argument])
        return caller.wait(), caller.output()

    def test_learning_parameters_as_the_service_file_says(self):
        self.start_learner()
        request = support.read_text(support.in_package('srv', 'SetLearningParameters.srv')).split('---')[0]
        argument = re.search(r'rosservice call /learner/set_learning_parameters "(.*)"', request)[1]
        status, output = self.call_set_learning_parameters(argument)
        self.assertEqual(status, 0, output)
        self.assert_says(output, 'success: True', 'alpha from 0.1 to 0.05')

    def test_learning_parameters_cannot_be_set_by_mistake(self):
        """Fields that a request does not have are refused: nothing is set to 0 for want of a value."""
        self.start_learner()
        status, output = self.call_set_learning_parameters('{alpha: 0.05}')
        self.assertNotEqual(status, 0, output)
        self.assert_says(output, 'alpha')
        self.assert_says(self.call('learner/set_learning_parameters', parameters='{}').message, 'alpha: 0.1')


def is_bare_field(line):
    """Whether a line declares a field and says nothing of it; `bool success` needs no words."""
    field, _, comment = line.partition('#')
    is_field = re.match(r'[\w/]+(\[\d*\])?\s+\w+\s*$', field)  # a constant has a value behind its name
    return bool(is_field) and not comment.strip() and field.split() != ['bool', 'success']


if __name__ == '__main__':
    support.run('messages_test')
