#!/usr/bin/python3
"""What people do, through ROS, and the services set_route, set_gate and alarm."""
import math

import support
from controlling import QUIET, ControllerTestCase
from geometry_msgs.msg import Point, Pose2D
from social_crowd.msg import AgentState, ControllerStatus, Walls
from walking import WalkTestCase

SHOP = """
name: shop
duration: 40
goal_tolerance: 0.3
contact: solid
walls:
  - [[0, 0], [12, 0]]
  - [[12, 0], [12, 8]]
  - [[12, 8], [0, 8]]
  - [[0, 8], [0, 0]]
  - [[6, 0], [6, 3.2]]
  - [[6, 4.8], [6, 8]]
AGENTS
routes:
  shopping:
    waypoints:
      - {place: {box: [[1, 1], [5, 3]]}, wait: [1, 4], face: -90}
      - {queue: till}
      - {one_of: [{sink: north}, {sink: south}]}
  rounds: {repeat: true, waypoints: [{place: {box: [[1, 5], [5, 7]]}, wait: 2}, {place: [4, 4]}]}
sources:
  - {area: {box: [[0.5, 3], [1.5, 5]]}, rate: 0.5, from: 1, until: 30, route: shopping, speed: [1.0, 1.5],
     hurry: [0.9, 1.2], radius: 0.2, groups: {share: 0.5}}
  - {area: [3, 3.5], times: [3, 3, 9], goal: [11, 4], kind: {reader: 1, child: 1, luggage: 1}}
kinds:
  reader: {speed: {mean: 1.3, deviation: 0.3, range: [1, 1.6]}, radius: 0.25, pauses: {every: 2, duration: [1, 2]}}
sinks:
  north: {area: {box: [[10, 7], [11.5, 8]]}}
  south: {area: {box: [[10, 0], [11.5, 1]]}}
queues:
  till: {head: [8, 6], direction: 180, spacing: 0.6, service: [1, 3], face: [8, 7]}
gates:
  door: {wall: [[6, 3.2], [6, 4.8]], open: [[10, 20], [23, 40]]}
attractions:
  window: {area: {box: [[1, 6], [4, 7.5]]}, radius: 3, share: 0.5, wait: [1, 4]}
alarms:
  - {time: 33, area: {box: [[6, 0], [12, 8]]}, sink: nearest, speed_factor: 1.2, reaction_time: [0, 2]}
"""
WALKERS = """agents:
  - {count: 4, position: {box: [[1, 5], [3, 7]]}, route: rounds, speed: 1.2, radius: 0.2, reaction_time: [0, 4]}"""

ROUTES = QUIET + """
routes:
  back: {waypoints: [{place: [-2, 0]}, {place: [-1, 0]}]}
gates:
  door: {wall: [[50, 45], [50, 55]], open: false}
  hatch: {wall: [[60, 50], [61, 50]], open: true}
sinks:
  west: {area: [-8, 0]}
  east: {area: [30, 5]}
"""

LOOK = """
name: look
duration: 20
goal_tolerance: 0.3
agents:
  - {position: [0, 0], route: tour, speed: 0.5, radius: 0.25}
routes:
  tour: {waypoints: [{place: [0.4, 0], wait: 9, face: {robot: rob}}, {place: [9, 0]}]}
robots:
  - {name: rob, position: [0.2, 5], radius: 0.3, max_speed: 1, perceived: false}
"""


STREAM = """
name: stream
duration: 60
goal_tolerance: 0.3
agents:
  - {position: [0, 10], goal: [2, 10], speed: 1, radius: 0.25}
sources:
  - {area: [0, 0], rate: 0.5, interval: regular, goal: [3, 0], speed: 1, radius: 0.25}
"""


class WalkTest(WalkTestCase):
    """The recording of a run through ROS is that of `evaluate`."""

    def check(self, agents):
        """Two episodes with one learner."""
        scenario = self.write('shop.yaml', SHOP.replace('AGENTS', agents))
        expected = self.headless(scenario, support.ANTICIPATION_TABLE, episodes=2, seed=5)
        recorded = {int(line.split(',')[2]) for line in expected.decode().splitlines()[1:]}
        self.assertGreater(len(recorded), 12, 'agents of the sources are to be in the recording')
        self.start_learner(q_table=support.ANTICIPATION_TABLE)
        self.assert_same_recording(self.walk(scenario, episodes=2), expected)

    def test_agents_and_sources(self):
        self.check(WALKERS)

    def test_no_agent_at_the_start(self):
        self.check('')


RECORDED = """
name: recorded
duration: 12
goal_tolerance: 0.3
agents:
  - {count: 4, position: {box: [[-4, -4], [-2, 4]]}, goal: {box: [[2, -4], [4, 4]]}, speed: [1.0, 1.5], radius: 0.2}
robots:
  - {name: cart, position: [0, 6], goal: [0, -6], radius: 0.3, max_speed: 1}
recorded:
  - {file: walk.csv, offset: 0.5}
"""
# Person 12 comes at 0.5 s and leaves at 4.5 s, person 3 comes at 6.5 s.
RECORDING = 'instance,tick,agent,x,y\n0,0,12,0,-5\n0,20,12,0,-2\n0,40,12,1,1\n0,60,3,0,5\n0,300,3,0,-7\n'


class RecordedWalkTest(WalkTestCase):
    """People of a recording among agents, through ROS and without."""

    def test_the_same_as_without_ros(self):
        self.write('walk.csv', RECORDING)
        scenario = self.write('recorded.yaml', RECORDED)
        expected = self.headless(scenario, support.ANTICIPATION_TABLE, episodes=2, seed=5)
        self.start_learner(q_table=support.ANTICIPATION_TABLE)
        self.assert_same_recording(self.walk(scenario, episodes=2), expected)


class RecordedPeopleTest(ControllerTestCase):
    """Recorded people in messages and services."""

    def test_states_and_services(self):
        self.write('walk.csv', RECORDING)
        self.start_all(RECORDED)
        self.walk(70)
        there = {message.tick: message.obstacles for message in self.agents.messages}
        self.assertEqual(there[4], [])
        self.assertEqual({tick for tick, obstacles in there.items() if [one.person for one in obstacles] == [12]},
                         set(range(5, 46)))
        one = there[35][0]
        self.assertEqual((one.obstacle, one.recorded, one.radius), (1, 1, 0.25))  # person 3 is obstacle 0
        self.assertAlmostEqual(one.position.x, 0.5)
        self.assertAlmostEqual(one.position.y, -0.5)
        self.assertAlmostEqual(one.velocity.y, 1.5)
        self.assertEqual([one.person for one in there[65]], [3])
        self.refuse('move_obstacle', 'obstacle 0 is recorded person 3', obstacle=0, position=Point(9, 9, 0))
        self.refuse('remove_obstacle', 'obstacle 0 is recorded person 3', obstacle=0)

    def test_a_saved_scenario_goes_on(self):
        self.write('walk.csv', RECORDING)
        self.start_all(RECORDED)
        here = self.walk(35).obstacles
        response = self.do('save_scenario', file='saved.yaml')
        self.assert_says(response.message, '0 obstacles', '2 recorded walks')
        self.assertIn("recorded:\n  - {file: 'walk.csv', offset: -3, ", support.read_text(self.path('saved.yaml')))
        self.do('load_scenario', scenario=self.path('saved.yaml'))
        again = self.agents.wait(lambda state: state.episode > 0 and state.tick == 0, 'at its start').obstacles
        self.assertEqual([one.person for one in again], [12])
        for axis in 'xy':
            self.assertAlmostEqual(getattr(again[0].position, axis), getattr(here[0].position, axis))


class ServicesTest(ControllerTestCase):
    """set_route, set_gate."""

    def test_a_route(self):
        self.start_all(ROUTES)
        self.step(2)
        self.assert_says(self.do('set_route', agent=0, route='back').message, 'agent 0', 'back')
        message = self.walk(2)  # turns on the spot and walks back
        self.assertEqual((message.agents[0].goal.x, message.agents[0].goal.y), (-2, 0))
        self.assert_place(message, 0, 0.0, 0.0)
        message = self.walk(40)
        self.assertEqual((message.agents[0].goal.x, message.agents[0].status), (-1, AgentState.WALKING))
        message = self.walk(30)
        self.assertEqual(message.agents[0].status, AgentState.ARRIVED)

    def test_a_goal_ends_it(self):
        self.start_all(ROUTES)
        self.do('set_route', agent=0, route='back')
        self.do('set_goal', agent=0, goal=Point(0.6, 0, 0))
        message = self.walk(10)
        self.assertEqual(message.agents[0].status, AgentState.ARRIVED)

    def test_bad_routes_are_refused(self):
        self.start_all(ROUTES)
        self.refuse('set_route', 'bak', "did you mean 'back'", agent=0, route='bak')
        self.refuse('set_route', 'agent 7', agent=7, route='back')
        self.assert_place(self.walk(), 0, 0.05, 0.0)

    def test_a_scenario_without_routes_and_gates(self):
        self.start_all()
        self.refuse('set_route', 'no routes', agent=0, route='back')
        self.refuse('set_gate', 'no gates', gate='door', open=True)

    def test_gates(self):
        walls = self.listen('walls', Walls)
        self.start_all(ROUTES)
        walls.wait(lambda message: list(message.numbers) == [0])
        self.assert_says(self.do('set_gate', gate='door', open=True).message, 'door', 'opened')
        self.walk(1)
        walls.wait(lambda message: not message.walls)
        self.do('teleport', agent=0, pose=Pose2D(50, 50, 0))
        self.assert_says(self.do('set_gate', gate='door', open=False).message, 'door', 'no agent stands in it')
        self.walk(1)
        self.assertFalse(walls.messages[-1].walls)
        self.do('teleport', agent=0, pose=Pose2D(40, 50, 0))
        self.walk(1)
        walls.wait(lambda message: list(message.numbers) == [1])
        self.refuse('set_gate', 'gate', 'door, hatch', gate='tunnel', open=True)

    def test_an_alarm(self):
        self.start_all(ROUTES)
        self.step(2)
        response = self.do('alarm', all=True, sink='nearest', speed_factor=2)
        self.assertEqual(response.agents, 2)
        self.assert_says(response.message, '2 people walk to a sink')
        message = self.walk(2)
        self.assertEqual([(agent.goal.x, agent.goal.y) for agent in message.agents], [(-8, 0), (-8, 0)])
        before = self.places(message)[0]
        message = self.walk(20)
        self.assertAlmostEqual(math.dist(before, self.places(message)[0]), 2.0, delta=0.1)  # at 1 m/s

    def test_an_alarm_in_a_box(self):
        self.start_all(ROUTES)
        box = {'lower': Point(-1, 9, 0), 'upper': Point(9, 11, 0)}
        response = self.do('alarm', sink='east', speed_factor=1, **box)
        self.assertEqual(response.agents, 1)
        self.assertEqual([(agent.goal.x, agent.goal.y) for agent in self.walk().agents], [(20, 0), (30, 5)])
        response = self.do('alarm', speed_factor=0.5, **box)
        self.assert_says(response.message, '1 person walk')

    def test_refused_alarms(self):
        self.start_all(ROUTES)
        self.refuse('alarm', 'speed_factor: expected a number above 0', all=True, sink='nearest')
        self.refuse('alarm', "there is no sink 'wst', did you mean 'west'?", all=True, sink='wst', speed_factor=1)
        self.refuse('alarm', 'lower left corner', sink='west', speed_factor=1, lower=Point(1, 0, 0))
        self.assert_place(self.walk(), 0, 0.05, 0.0)

    def test_a_scenario_without_sinks(self):
        self.start_all()
        self.refuse('alarm', 'no sinks', all=True, sink='nearest', speed_factor=1)

    def test_where_people_look(self):
        self.start_all(LOOK)
        message = self.walk(20)
        agent, = message.agents
        self.assertAlmostEqual(agent.pose.theta, math.atan2(5 - agent.pose.y, 0.2 - agent.pose.x), places=9)


class DeparturesTest(ControllerTestCase):
    """People of a source walk for 3 s and leave."""

    def test_messages_do_not_grow(self):
        status = self.listen('controller_status', ControllerStatus)
        self.start_all(STREAM)
        for _ in range(10):
            self.walk(40)
        seen = {}  # by agent: its status in all messages
        for message in self.agents.messages:
            self.assertLessEqual(len(message.agents), 6, f'tick {message.tick}')
            for agent in message.agents:
                seen.setdefault(agent.agent, []).append(agent.status)
        walking, arrived = AgentState.WALKING, AgentState.ARRIVED
        self.assertGreater(len(seen), 18)
        self.assertEqual(sorted(seen), list(range(len(seen))))
        gone = [states for agent, states in seen.items() if 0 < agent < len(seen) - 5]
        for states in gone:
            self.assertEqual(states, [walking] * (len(states) - 2) + [arrived] * 2)
        self.assertEqual(self.agents.messages[-1].agents[0].status, arrived, 'the agent of the scenario stays')
        support.wait_for(lambda: status.messages and status.messages[-1].tick == 400, 'the last tick')
        last = status.messages[-1]
        self.assertEqual((last.agents, last.walking + last.arrived), (len(seen), len(seen)))
        self.assertGreater(last.arrived, len(gone))
        self.do('pause', data=False)
        result = self.results.wait()
        self.assertEqual([agent.agent for agent in result.agents], list(range(len(result.agents))))
        self.assertTrue(all(agent.arrived for agent in result.agents[:len(seen) - 5]))


if __name__ == '__main__':
    support.run('population_test')
