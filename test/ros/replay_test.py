#!/usr/bin/python3
"""The node replay and replay.launch with trajectories: recorded people on the topics of a crowd."""
import math

import rospy
import support
from launching import LaunchTestCase
from nav_msgs.msg import OccupancyGrid
from social_crowd.msg import AgentState, AgentStates, Scenario
from visualization_msgs.msg import MarkerArray

CORRIDOR = """
name: corridor
tick: 0.05
duration: 60
goal_tolerance: 0.3
agents:
  - {position: [0, 0], goal: [4, 0], speed: 1, radius: 0.25}
  - {position: [0, 1], goal: [4, 1], speed: 1, radius: 0.4}
obstacles:
  - {position: [2, 0], radius: 0.5, velocity: [0, 2]}
walls:
  - [[0, -1], [4, -1]]
"""
# Agent 1 comes at tick 1, agent 0 leaves after tick 1.
WALK = 'instance,tick,agent,x,y\n0,0,0,0,0\n0,1,0,0.05,0\n0,1,1,0,1\n0,2,1,0.1,1.25\n0,3,1,0.1,1.5\n'
# Frames of 0.4 s; person 40 comes before person 7.
OBSMAT = ('780 40 8.5 0 3.5 0 0 0\n786 40 9.3 0 3.5 0 0 0\n792 40 10.1 0 3.9 0 0 0\n'
          '786 7 1 0 1 0 0 0\n792 7 1 0 2 0 0 0\n')
# Person 40 stands at the end for 4 s, so that the last picture is drawn before a launch ends.
STANDING = OBSMAT + ''.join(f'{792 + 6 * i} 40 10.1 0 3.9 0 0 0\n' for i in range(1, 11))


class ReplayTest(LaunchTestCase):
    """The node replay, and the launch file."""

    def setUp(self):
        super().setUp()
        self.states = self.listen('agents', AgentStates)
        self.scenarios = self.listen('scenario', Scenario)

    def start_replay(self, **parameters):
        """Starts the node. It waits until it is continued, so that no message is missed."""
        return self.start_node('replay', 'replay', dict({'delay': 0.0, 'rate': 20.0, 'paused': True}, **parameters))

    def go_on(self):
        """Continues the replay when this test is connected."""
        self.states.wait_connected()
        self.succeed('replay/pause', data=False)

    def positions(self, episode=0):
        """Returns the positions of those who are on the floor, by tick and number of the agent."""
        return {(states.tick, agent.agent): (agent.pose.x, agent.pose.y) for states in list(self.states.messages)
                if states.episode == episode for agent in states.agents if agent.status == AgentState.WALKING}

    def test_positions_of_an_episode(self):
        """All those that `evaluate` has recorded, bit for bit."""
        recording = self.path('circle6.csv')
        self.tool('evaluate', '--q-table', support.NEAREST_TABLE, '--trajectories', self.folder, 'circle6')
        expected = {key[1:]: place for key, place in support.read_recording(recording).items()}
        node = self.start_replay(trajectories=recording, scenario='circle6', rate=1000.0)
        self.go_on()
        self.assertEqual(node.wait(), 0)
        last = max(tick for tick, _ in expected)
        self.states.wait_at(0, last)
        got = self.positions()
        self.assertEqual(set(got), set(expected))
        for key, place in expected.items():
            self.assertAlmostEqual(got[key][0], place[0], 9, key)
            self.assertAlmostEqual(got[key][1], place[1], 9, key)

    def test_messages(self):
        node = self.start_replay(trajectories=self.write('walk.csv', WALK), scenario=self.write('c.yaml', CORRIDOR))
        scenario = self.scenarios.wait(what='of the recording')
        self.assertEqual((scenario.name, scenario.tick_duration, scenario.max_ticks), ('corridor', 0.05, 3))
        self.assertEqual([(wall.from_.x, wall.to.x, wall.to.y) for wall in scenario.walls], [(0, 4, -1)])
        self.assertEqual([(agent.agent, agent.pose.y, agent.goal.y) for agent in scenario.agents],
                         [(0, 0, 0), (1, 1, 1.5)])
        self.go_on()
        self.assertEqual(node.wait(), 0)
        self.states.wait_at(0, 3)
        lists = [[(agent.agent, agent.status) for agent in states.agents] for states in self.states.messages]
        there, gone = AgentState.WALKING, AgentState.ARRIVED
        self.assertEqual(lists, [[(0, there)], [(0, there), (1, there)], [(0, gone), (1, there)],
                                 [(0, gone), (1, there)]])
        one = self.states.messages[2].agents[1]
        self.assertEqual((one.radius, one.goal.x, one.goal.y), (0.4, 0.1, 1.5))
        self.assertAlmostEqual(one.velocity.x, 2.0)
        self.assertAlmostEqual(one.velocity.y, 5.0)
        self.assertAlmostEqual(self.states.messages[2].obstacles[0].position.y, 0.2)
        self.assertEqual(self.states.messages[2].header.frame_id, 'map')

    def test_a_recording_that_begins_later(self):
        """The moving obstacle is where it was at the time of the people: at tick 3 at 0.15 s * 2 m/s."""
        walk = 'instance,tick,agent,x,y\n0,3,0,0,0\n0,4,0,0.05,0\n'
        node = self.start_replay(trajectories=self.write('walk.csv', walk), scenario=self.write('c.yaml', CORRIDOR))
        scenario = self.scenarios.wait(what='of the recording')
        self.assertAlmostEqual(scenario.obstacles[0].position.y, 0.3)
        self.go_on()
        self.assertEqual(node.wait(), 0)
        self.states.wait_at(0, 1)
        places = [states.obstacles[0].position.y for states in self.states.messages]
        self.assertEqual([round(place, 9) for place in places], [0.3, 0.4])

    def test_people_filmed_from_above(self):
        """Frames of 0.4 s are interpolated to ticks of 0.1 s. People are numbered as they come."""
        node = self.start_replay(trajectories=self.write('obsmat.txt', OBSMAT))
        self.go_on()
        self.assertEqual(node.wait(), 0)
        self.states.wait_at(0, 8)
        got = self.positions()
        self.assertEqual(set(got), {(tick, 0) for tick in range(9)} | {(tick, 1) for tick in range(4, 9)})
        for key, place in {(0, 0): (8.5, 3.5), (1, 0): (8.7, 3.5), (4, 0): (9.3, 3.5), (8, 0): (10.1, 3.9),
                           (4, 1): (1, 1), (6, 1): (1, 1.5), (8, 1): (1, 2)}.items():
            self.assertAlmostEqual(got[key][0], place[0], 9, key)
            self.assertAlmostEqual(got[key][1], place[1], 9, key)
        self.assertEqual(self.scenarios.messages[0].name, 'obsmat')

    def test_map_of_the_scenario(self):
        """The lowest row of the map comes first."""
        maps = self.listen('map', OccupancyGrid)
        recording = self.write('walk.csv', 'instance,tick,agent,x,y\n0,0,0,5,5\n')
        self.start_replay(trajectories=recording, scenario='place_station')
        grid = maps.wait(what='of the station')
        self.assertAlmostEqual(grid.info.width * grid.info.resolution, 51, 3)  # the hall and its walls

        def cell(x, y):
            column = int((x - grid.info.origin.position.x) / grid.info.resolution)
            return grid.data[int((y - grid.info.origin.position.y) / grid.info.resolution) * grid.info.width + column]
        self.assertEqual([cell(25, 6.5), cell(25, 10), cell(25, 28)], [100, 0, 100])  # kiosk, hall, between platforms
        self.assertEqual(cell(7, 28), 0)  # the way to platform 1

    def test_pause(self):
        """No tick comes while it is paused; then it goes on with the next one."""
        walk = 'instance,tick,agent,x,y\n' + ''.join(f'0,{tick},0,{tick / 10},0\n' for tick in range(1000))
        self.start_replay(trajectories=self.write('long.csv', walk), rate=1.0)
        self.go_on()
        self.states.wait_at(0, 1)
        self.assertEqual(self.succeed('replay/pause', data=True).message, 'paused')
        paused = rospy.get_time()
        support.wait_for(lambda: rospy.get_time() > paused + 0.6, 'the time of six ticks')
        continued = rospy.get_time()
        self.succeed('replay/pause', data=False)
        self.states.wait_at(0, 12)
        messages = self.states.messages[:13]
        self.assertEqual([states.tick for states in messages], list(range(13)))
        meanwhile = [states.tick for states in messages if paused < states.header.stamp.to_sec() < continued]
        self.assertLessEqual(len(meanwhile), 1)  # the tick under way

    def test_loop(self):
        """The second time is another episode with the same positions."""
        self.start_replay(trajectories=self.write('walk.csv', WALK), loop=True)
        self.go_on()
        self.states.wait_at(2, 0)
        self.assertEqual(self.positions(1), self.positions(0))
        self.assertEqual([scenario.episode for scenario in self.scenarios.messages][:3], [0, 1, 2])

    def test_launch_file(self):
        """crowd_markers draws the people; without RViz the launch ends with the recording."""
        markers = self.listen('recording/markers', MarkerArray)
        self.states = self.listen('recording/agents', AgentStates)
        launched = self.launch('replay.launch', trajectories=self.write('obsmat.txt', STANDING), paused='true')

        def has_tip(array):
            points = [point for marker in array.markers if marker.ns == 'paths' for point in marker.points]
            return any(abs(point.x - 10.1) < 1e-6 for point in points)
        markers.wait_connected()
        self.go_on()
        markers.wait(has_tip, 'with a path to the last place')
        self.assert_ends_well(launched)

    def test_beside_a_demo(self):
        """Neither ends a node of the other, and each has topics of its own."""
        markers = {name: self.listen(name, MarkerArray) for name in ('markers', 'recording/markers')}
        demo = self.launch('demo.launch', scenario='circle6', episodes=0)
        markers['markers'].wait(lambda array: array.markers, 'of the demo')
        self.states = self.listen('recording/agents', AgentStates)
        replay = self.launch('replay.launch', trajectories=self.write('obsmat.txt', OBSMAT), paused='true')
        markers['recording/markers'].wait_connected()
        self.go_on()
        markers['recording/markers'].wait(lambda array: array.markers, 'of the replay')
        self.assert_ends_well(replay)
        shown = len(markers['markers'].messages)
        support.wait_for(lambda: len(markers['markers'].messages) > shown + 5, 'the demo to go on')
        self.assertEqual(demo.stop(), 0)
        self.assert_no_complaint(demo, 'WARN|ERROR|FATAL')
        self.assertNotIn('has died', demo.output())

    def test_bad_parameters(self):
        for parameters, words in (
                ({}, ['~trajectories: expected a file']),
                ({'trajectories': 'walk.csv'}, ['there is no file /', 'walk.csv; give an absolute path']),
                ({'trajectories': 'a', 'rate': -1.0, 'lop': True},
                 ['~rate: expected a number from 0', '~lop: there is no', 'trajectories, scenario']),
                ({'trajectories': 'a', 'instance': 1.7, 'rate': math.inf, 'frame_rate': math.nan},
                 ["~instance: expected a whole number from 0, got '1.7'", "~rate: expected a number from 0, got 'inf'",
                  "~frame_rate: expected a number from 0, got 'nan'"]),
                ({'trajectories': self.write('a.csv', 'x')}, ['a.csv:1: is not a recording']),
                ({'trajectories': self.write('w.csv', WALK), 'scenario': 'circel6'}, ["did you mean 'circle6'?"])):
            node = self.start_replay(**parameters)
            self.assertEqual(node.wait(), 1)
            self.assert_says(node.output(), 'replay: ', *words)
            self.assertNotIn('Traceback', node.output())

    def test_interrupted_while_paused(self):
        node = self.start_replay(trajectories=self.write('walk.csv', WALK))
        rospy.wait_for_service(f'{self.namespace}/replay/pause', support.PATIENCE)
        self.assertEqual(node.stop(), 0)


if __name__ == '__main__':
    support.run('replay_test')
