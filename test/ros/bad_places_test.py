#!/usr/bin/python3
"""Bad maps, scenarios with bad places, and goals and names that do not exist are refused, and the crowd walks on."""
import rospy
import support
from controlling import ControllerTestCase
from geometry_msgs.msg import Point, Pose2D, Quaternion
from nav_msgs.msg import OccupancyGrid
from social_crowd.msg import Walls

NAN = float('nan')

# A room of 20 m x 10 m with a closed cell of 2 m x 2 m in a corner, and agents that walk straight ahead.
ROOM = """
name: room
duration: 60
goal_tolerance: 0.1
contact: solid
walls:
  - [[0, 0], [20, 0]]
  - [[20, 0], [20, 10]]
  - [[20, 10], [0, 10]]
  - [[0, 10], [0, 0]]
  - [[18, 0], [18, 2]]
  - [[18, 2], [20, 2]]
agents:
  - {position: [2, 5], goal: [15, 5], speed: 0.5, radius: 0.2}
  - {position: [2, 8], goal: [15, 8], speed: 0.5, radius: 0.2}
routes:
  cell: {waypoints: [{place: [19, 1]}]}
  detour: {waypoints: [{place: [5, 5]}, {place: [19, 1]}, {place: [15, 5]}]}
  rounds: {repeat: true, waypoints: [{place: [5, 5]}, {place: [15, 5]}]}
gates:
  door: {wall: [[1, 1], [2, 1]], open: true}
"""
HEAD = ROOM[:ROOM.index('agents:')]
AGENT = 'agents: [{position: [2, 5], goal: [15, 5], speed: 0.5, radius: 0.2}]\n'


class BadPlacesTestCase(ControllerTestCase):
    """A crowd in a room, whose state is compared before and after bad input."""

    def begin(self, **parameters):
        """Starts all and walks some ticks."""
        self.walls = self.listen('walls', Walls)
        self.start_all(ROOM, **parameters)
        self.walls.wait()
        self.before = self.walk(2)
        self.wall_messages = len(self.walls.messages)

    def assert_unchanged(self):
        """The crowd walks on as if nothing had been asked."""
        tick = self.before.tick
        after = self.walk(2)
        self.assertEqual((after.episode, after.tick), (self.before.episode, tick + 2))
        self.assertEqual(len(self.walls.messages), self.wall_messages)
        for agent, y in ((0, 5.0), (1, 8.0)):
            self.assert_place(after, agent, 2.0 + 0.05 * after.tick, y)
            self.assertEqual((after.agents[agent].goal.x, after.agents[agent].goal.y), (15.0, y))
        self.before = after


class ServicesTest(BadPlacesTestCase):
    """Services that change the world."""

    def test_goals_out_of_reach(self):
        self.begin()
        reach = ['agent 0', 'goal (19, 1)', 'cannot be reached', 'radius of 0.2 m']
        self.refuse('set_goal', *reach, agent=0, goal=Point(19, 1, 0))
        self.refuse('set_goal', 'agent 0', 'goal (30, 5)', 'cannot be reached', agent=0, goal=Point(30, 5, 0))
        self.refuse('set_goal', 'agent 0', 'goal (18, 1)', 'in a wall', agent=0, goal=Point(18, 1, 0))
        self.refuse('set_route', *reach, agent=0, route='cell')
        self.refuse('set_route', 'routes.detour.waypoints[1]', 'cannot be reached from (5, 5)', *reach, agent=0,
                    route='detour')
        self.refuse('teleport', 'agent 0', 'cannot be reached from (19, 1)', agent=0, pose=Pose2D(19, 1, 0))
        self.refuse('teleport', 'taken by a wall', agent=0, pose=Pose2D(18, 1, 0))
        self.refuse('spawn_agent', 'goal (19, 1)', 'cannot be reached from (10, 2)', pose=Pose2D(10, 2, 0),
                    goal=Point(19, 1, 0), max_speed=1.0, radius=0.2)
        self.assert_unchanged()

    def test_floors_that_are_too_large(self):
        self.begin()
        self.refuse('set_goal', 'too large', agent=0, goal=Point(1e6, 5, 0))
        self.refuse('add_wall', 'too large', begin=Point(1e6, 0, 0), end=Point(1e6, 1, 0))
        self.assert_unchanged()

    def test_numbers_beyond_the_limits(self):
        self.begin()
        place = 'expected a number from -1e+06 to 1e+06 m, got 1e+17'
        far = Point(1e17, 5, 0)
        near = {'position': Point(5, 2, 0), 'goal': Point(15, 2, 0)}
        body = {'pose': Pose2D(5, 2, 0), 'goal': Point(15, 2, 0)}
        self.refuse('set_goal', 'goal [m]', place, agent=0, goal=far)
        self.refuse('teleport', 'position [m]', place, agent=0, pose=Pose2D(1e17, 5, 0))
        self.refuse('add_wall', 'wall [m]', place, begin=far, end=Point(0, 0, 0))
        self.refuse('spawn_agent', 'goal [m]', place, **dict(body, goal=far, max_speed=1, radius=0.2))
        self.refuse('spawn_agent', 'max_speed [m/s]: expected at most 1000 m/s, got 1e+300', **body, max_speed=1e300,
                    radius=0.2)
        self.refuse('spawn_agent', 'radius [m]: expected at most 1000 m, got 1e+200', **body, max_speed=1, radius=1e200)
        self.refuse('spawn_obstacle', 'radius [m]: expected at most 1000 m', position=far, radius=1e200)
        self.refuse('spawn_obstacle', 'position [m]', place, position=far, radius=0.2)
        self.refuse('add_source', 'rate: expected at most 1000 agents/s', **near, rate=1e9, max_speed=1, radius=0.2)
        self.refuse('add_source', 'speed: expected at most 1000 m/s', **near, rate=1, max_speed=1e300, radius=0.2)
        self.refuse('add_source', 'radius: expected at most 1000 m', **near, rate=1, max_speed=1, radius=1e200)
        self.refuse('add_gate', 'wall', 'expected a number from -1e+06 to 1e+06 m', begin=far, end=Point(0, 0, 0))
        self.assert_unchanged()

    def test_unknown_names_and_numbers(self):
        self.begin()
        self.refuse('set_goal', 'agent 9', agent=9, goal=Point(5, 5, 0))
        self.refuse('set_route', 'agent 9', agent=9, route='rounds')
        self.refuse('set_route', "did you mean 'rounds'", agent=0, route='round')
        self.refuse('set_gate', "did you mean 'door'", gate='dor', open=False)
        self.refuse('teleport', 'agent 9', agent=9, pose=Pose2D(5, 5, 0))
        self.refuse('teleport', 'position', agent=0, pose=Pose2D(NAN, 5, 0))
        self.refuse('remove_wall', 'wall 99', wall=99)
        self.assert_unchanged()


class ScenariosTest(BadPlacesTestCase):
    """load_scenario."""

    def refuse_text(self, text, *words):
        """A scenario with this text is refused, with its file and document."""
        file = self.write('bad.yaml', text)
        self.refuse('load_scenario', file, 'document 1', *words, scenario=file)

    def test_places_and_rates(self):
        self.begin()
        source = 'sources: [{area: AREA, rate: RATE, goal: GOAL, speed: 1, radius: 0.2}]\n'
        good = {'AREA': '[5, 2]', 'RATE': '1', 'GOAL': '[15, 2]'}
        for change, words in (
                ({'RATE': '-1'}, ['rate', 'expected a number above 0']), ({'RATE': '0'}, ['rate', 'expected']),
                ({'AREA': '[18, 1]'}, ['area'])):
            text = source
            for key, value in dict(good, **change).items():
                text = text.replace(key, value)
            line = len((HEAD + AGENT).splitlines()) + 1
            self.refuse_text(HEAD + AGENT + text, f'line {line}', *words)
        self.assert_unchanged()

    def test_routes_into_walls(self):
        self.begin()
        routes = 'routes: {way: {waypoints: [{place: [18, 1]}]}}\n'
        line = len((HEAD + AGENT).splitlines()) + 1
        self.refuse_text(HEAD + AGENT.replace('goal: [15, 5]', 'route: way') + routes, f'line {line}', 'way')
        self.assert_unchanged()

    def test_maps(self):
        self.begin()
        absent = self.write('bad.yaml', 'map: absent.yaml\n' + ROOM)
        self.refuse('load_scenario', absent, 'line 1: map: ', 'absent.yaml: cannot be read', scenario=absent)
        keys = 'origin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n'
        for text, words in (
                ('image: absent.pgm\nresolution: 0.1\n' + keys, ['absent.pgm']),
                ('image: m.pgm\nresolution: -0.1\n' + keys, ['m.yaml', 'resolution', 'above 0']),
                ('image: m.pgm\nresolution: 0\n' + keys, ['m.yaml', 'resolution', 'above 0'])):
            self.write('m.pgm', 'P2 2 1 255 0 255\n')
            self.write('m.yaml', text)
            file = self.write('bad.yaml', 'map: m.yaml\n' + ROOM)
            self.refuse('load_scenario', *words, scenario=file)
        self.assert_unchanged()


class ResultsTest(BadPlacesTestCase):
    """Goals of a scenario that no way leads to."""

    def test_goals_out_of_reach_are_reported_at_the_start_and_in_the_result(self):
        caged = '  - {position: [2, 2], goal: [19, 1], speed: 0.5, radius: 0.2}\n'
        self.start_all(ROOM.replace('duration: 60', 'duration: 1').replace('routes:', caged + 'routes:'))
        warning = '1 agent has a goal out of reach (2)'
        support.wait_for(lambda: f'episode 0 (room), at its start: {warning}' in self.controller.output(),
                         'the warning at the start')
        self.assertNotIn('at its end', self.controller.output())
        self.step(10)
        result = self.results.wait()
        self.assertEqual(list(result.out_of_reach), [2])
        support.wait_for(lambda: f'episode 0 (room), at its end: {warning}' in self.controller.output(),
                         'the warning at the end')

    def test_none(self):
        self.start_all(ROOM.replace('duration: 60', 'duration: 1'))
        self.step(10)
        self.assertEqual(list(self.results.wait().out_of_reach), [])
        self.assertNotIn('out of reach', self.controller.output())

    def test_goals_in_walls(self):
        self.begin()
        text = HEAD + AGENT.replace('goal: [15, 5]', 'goal: [18, 1]')
        line = len(HEAD.splitlines()) + 1
        file = self.write('bad.yaml', text)
        self.refuse('load_scenario', f'{file}: document 1, line {line}: agents[0].goal: expected', 'got (18, 1)',
                    scenario=file)
        self.assert_unchanged()


class MapTopicTest(BadPlacesTestCase):
    """Messages on the topic of ~map_topic."""

    def grid(self, **changes):
        """A map of 2 x 1 cells, the first one is occupied, with some values replaced."""
        values = {'frame': 'map', 'resolution': 0.5, 'width': 2, 'height': 1, 'x': 5.0, 'data': [100, 0]}
        values.update(changes)
        message = OccupancyGrid()
        message.header.frame_id = values['frame']
        message.info.resolution = values['resolution']
        message.info.width, message.info.height = values['width'], values['height']
        message.info.origin.position = Point(values['x'], 1, 0)
        message.info.origin.orientation = Quaternion(0, 0, 0, 1)
        message.data = values['data']
        return message

    def test_bad_maps_are_not_used(self):
        topic = f'{self.namespace}/floor'
        publisher = rospy.Publisher(topic, OccupancyGrid, queue_size=10)
        self.addCleanup(publisher.unregister)
        self.begin(map_topic=topic)
        support.wait_for(lambda: publisher.get_num_connections() > 0, 'the controller to subscribe')
        for changes, words in (
                ({'width': 0, 'height': 0, 'data': []}, 'the map has no cells, expected at least one'),
                ({'data': [0]}, 'expected 2 values, got 1'),
                ({'resolution': 0.0}, 'resolution: expected a finite number of metres above 0, got 0'),
                ({'resolution': -0.5}, 'resolution: expected a finite number of metres above 0, got -0.5'),
                ({'x': NAN}, 'origin: expected finite numbers'),
                ({'frame': 'odom'}, "header.frame_id: expected 'map', got 'odom'"),
                ({'x': 3e7}, 'too large')):
            publisher.publish(self.grid(**changes))
            support.wait_for(lambda text=words: text in self.controller.output(), f'the error: {words}')
            self.assertTrue(self.controller.is_running())
        self.assert_unchanged()
        publisher.publish(self.grid())
        self.walls.wait(lambda message: len(message.walls) == 10)


if __name__ == '__main__':
    support.run('bad_places_test')
