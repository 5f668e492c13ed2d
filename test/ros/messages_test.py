#!/usr/bin/python3
"""Messages of the nodes: headers, episodes and ticks, contacts, turns, frames, clock."""
import math

import rosgraph
import rospy
import support
from broadcasting import SCENE, BroadcastTestCase
from rosgraph_msgs.msg import Clock
from social_crowd.msg import Scenario
from tf2_msgs.msg import TFMessage

# An agent in a closed box, whose walls it touches after 1 cm, for 2 ticks.
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


class HeadersTest(BroadcastTestCase):
    """Header, episode and tick of every message."""

    def test_all_messages_have_frame_stamp_episode_and_tick(self):
        self.start_all()
        self.walk_an_episode()
        now = rospy.Time.now()
        for name, ear in self.ears.items():
            for message in ear.messages:
                where = f'{name}, episode {message.episode}, tick {message.tick}'
                self.assertEqual(message.header.frame_id, 'map', where)
                self.assertTrue(self.began <= message.header.stamp <= now, where)

    def test_stamps_increase(self):
        self.start_all()
        self.walk_an_episode()
        for name, ear in self.ears.items():
            stamps = [message.header.stamp for message in ear.messages]
            self.assertEqual(stamps, sorted(stamps), name)

    def test_no_tick_is_missing(self):
        self.start_all()
        self.walk_an_episode()
        ticks = {name: sorted({m.tick for m in self.ears[name].messages if m.episode == 0}) for name in self.ears}
        self.assertEqual(ticks['perceptions'], list(range(31)))
        self.assertEqual(ticks['actions'], list(range(30)))
        self.assertEqual([tick for tick in ticks['agents'] if tick > 0], list(range(1, 31)))  # 0 may be missed
        self.assertEqual(ticks['scenario'], [0])
        self.assertEqual(ticks['episode_results'], [30])

    def test_answers_have_the_stamp_of_their_perceptions(self):
        self.start_all()
        self.walk_an_episode()
        stamps = {(m.episode, m.tick): m.header.stamp for m in self.ears['perceptions'].messages}
        for answer in self.ears['actions'].messages:
            self.assertEqual(answer.header.stamp, stamps[answer.episode, answer.tick])

    def test_scenario_message_agrees_with_the_file(self):
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

    def test_people_who_walk_together_have_the_same_group(self):
        person = '  - {{position: [{0}, 0], goal: [{0}, 9], speed: 1, radius: 0.2}}\n'
        text = 'name: groups\nduration: 1\ngoal_tolerance: 0.2\ngroups: [{members: [1, 3]}]\nagents:\n'
        file = self.write('groups.yaml', text + ''.join(map(person.format, range(4))))
        self.start_controller(file)
        scenario = self.listen('scenario', Scenario).wait()
        self.assertEqual([agent.group for agent in scenario.agents], [0, 2, 0, 2])

    def test_result_agrees_with_the_recording(self):
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

    def test_blocked_moves_are_published_and_counted(self):
        self.start_all(BOX)
        self.step(2)
        result = self.ears['episode_results'].wait_at(0, 2)
        self.assertEqual(self.ears['scenario'].wait().contact, Scenario.SOLID)
        for tick in (1, 2):
            agent = self.ears['agents'].wait_at(0, tick).agents[0]
            state = (agent.blocked, agent.blocked_moves, agent.in_contact, agent.touched)
            self.assertEqual(state, (True, tick, True, True))
            self.assertLess(math.hypot(agent.pose.x, agent.pose.y), 0.015)
        self.assertEqual((result.blocked_moves, result.agents[0].blocked_moves), (2, 2))
        self.assertEqual((result.contact_percent, result.agents[0].touched), (100.0, True))


class SequentialTest(BroadcastTestCase):
    """Sequential scenarios, and the collision radius."""

    def test_each_agent_is_perceived_in_its_own_turn(self):
        self.start_all(SCENE + 'order: sequential\n', table=support.ANTICIPATION_TABLE)
        self.step(2)
        self.assertEqual(self.ears['scenario'].wait().order, Scenario.SEQUENTIAL)
        asked = [self.perceptions_at(tick, turn) for tick in (0, 1) for turn in (0, 1)]
        self.assertEqual([[agent.agent for agent in message.agents] for message in asked], [[0], [1], [0], [1]])
        velocity = asked[1].neighbours[0].velocity_x
        self.assertNotEqual(velocity, 0.0, 'agent 1 should perceive that agent 0 has moved in this tick')

    def perceptions_at(self, tick, turn):
        """Waits for the perceptions of a turn."""
        return self.ears['perceptions'].wait(lambda message: (message.tick, message.turn) == (tick, turn),
                                             f'of tick {tick}, turn {turn}')

    def test_states_are_published_at_the_end_of_a_tick(self):
        self.start_all(SCENE + 'order: sequential\n', agents_rate=0.0)
        self.step(3)
        for tick in (1, 2, 3):
            state = self.ears['agents'].wait_at(0, tick)
            self.assertAlmostEqual(state.obstacles[0].position.x, 3 + 0.05 * tick)

    def test_collisions_are_published_and_counted(self):
        self.start_all(BOX)  # walls 0.26 m from the agent's centre
        self.step(2)
        result = self.ears['episode_results'].wait_at(0, 2)
        scenario = self.ears['scenario'].wait()
        self.assertEqual((scenario.order, scenario.collision_radius), (Scenario.SIMULTANEOUS, 0.5))
        agent = self.ears['agents'].wait_at(0, 2).agents[0]
        self.assertEqual((agent.in_collision, agent.collided), (True, True))
        self.assertEqual((result.collision_percent, result.agents[0].collided), (100.0, True))

    def test_no_collision_beyond_the_collision_radius(self):
        self.start_all(BOX + 'collision_radius: 0.2\n')
        self.step(2)
        result = self.ears['episode_results'].wait_at(0, 2)
        self.assertEqual(self.ears['scenario'].wait().collision_radius, 0.2)
        self.assertEqual((result.collision_percent, result.agents[0].collided), (0.0, False))


class FramesTest(BroadcastTestCase):
    """tf and clock on request."""

    def published(self):
        """Returns the topics that the controller publishes."""
        publishers, _, _ = rosgraph.Master('/social_crowd_test').getSystemState()
        return {topic for topic, nodes in publishers if f'{self.namespace}/crowd_controller' in nodes}

    def test_neither_is_published_by_default(self):
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
        """Returns the transforms of an agent's frame in episode 0 from tick 1 on; tick 0 may be missed. The controller
        publishes the states of a tick before its frames."""
        began = self.ears['agents'].wait_at(0, 1).header.stamp
        begun_again = self.ears['scenario'].wait_at(1, 0).header.stamp
        return [frame for message in list(frames.messages) for frame in message.transforms
                if frame.child_frame_id == child and began <= frame.header.stamp < begun_again]

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


if __name__ == '__main__':
    support.run('messages_test')
