#!/usr/bin/python3
"""Services that change and save what is on the floor."""
import os

import support
from controlling import ControllerTestCase
from geometry_msgs.msg import Point, Pose2D
from social_crowd.msg import AgentState

# Everything that moves, in a solid world; coordinates have no exact decimals after a few ticks.
FULL = """
name: full
duration: 60
goal_tolerance: 0.3
contact: solid
agents:
  - {position: [0, 0], goals: [[7, 1], [9, 9]], speed: 0.7, radius: 0.25}
  - {position: [0, 5], goal: [9, 4], kind: wheelchair, speed: 1.1, radius: 0.3}
  - {position: [0, 9], goal: [9, 8], speed: 1.1, radius: 0.3}
obstacles:
  - {position: [5, 20], radius: 0.4}
  - {position: [5, 22], radius: 0.4, velocity: [0.3, 0.1]}
  - {position: [0, 30], radius: 0.4, to_and_fro: [[0.5, 30]], speed: 0.3}
  - {position: [5, 30], radius: 0.4, waypoints: [[6, 30], [6, 31]], speed: 0.7}
walls:
  - [[-3, -3], [-3, 3]]
robots:
  - {name: tug, position: [20, 0], goal: [26, 0], radius: 0.3, max_speed: 1}
"""


def moves_of(state):
    """Returns positions and headings of agents on their way, and positions of obstacles."""
    return ([(agent.pose.x, agent.pose.y, agent.pose.theta, agent.goal.x, agent.goal.y, agent.max_speed, agent.radius,
              agent.figure)
             for agent in state.agents if agent.status == agent.WALKING],
            [(obstacle.position.x, obstacle.position.y, obstacle.radius) for obstacle in state.obstacles])


class SaveScenarioTest(ControllerTestCase):
    """What is on the floor, as a scenario file."""

    def save_and_load(self):
        """Saves and loads. Returns the states before and after."""
        file = self.path('floor.yaml')
        saved = self.do('save_scenario', file=file, overwrite=True)
        self.assert_says(saved.message, file)
        before = self.agents.messages[-1]
        self.do('load_scenario', scenario=file)
        after = self.agents.wait(lambda state: state.episode > before.episode and state.tick == 0, 'at its start')
        return before, after

    def test_file_reads_back_the_same(self):
        self.start_all(FULL)
        self.walk(37)
        self.do('remove_agent', agent=2)
        self.do('spawn_agent', pose=Pose2D(-1.1, 7.7, 0.3), goal=Point(3.3, 7.7, 0), max_speed=1.3,
                radius=0.21)
        self.do('add_wall', begin=Point(-2.1, -3, 0), end=Point(-2.1, 3, 0))
        self.walk()
        before, after = self.save_and_load()
        self.assertEqual(moves_of(after), moves_of(before))
        self.assertEqual(after.agents[1].figure, AgentState.WHEELCHAIR)
        scenario = self.scenarios.wait(lambda message: message.episode == after.episode)
        self.assertEqual([(wall.from_.x, wall.to.x) for wall in scenario.walls], [(-3, -3), (-2.1, -2.1)])

    def test_obstacles_go_on_as_before(self):
        """Also those along waypoints, at any point of their ways."""
        self.start_all(FULL)
        for ticks in (5, 12, 17, 29):
            with self.subTest(ticks=ticks):
                self.walk(ticks)
                self.do('save_scenario', file=self.path('floor.yaml'), overwrite=True)
                expected = moves_of(self.walk(25))[1]
                self.do('load_scenario', scenario=self.path('floor.yaml'))
                got = moves_of(self.walk(25))[1]
                for one, other in zip(got, expected):
                    for a, b in zip(one, other):
                        self.assertAlmostEqual(a, b, places=9)

    def test_goals_that_are_left_are_saved(self):
        self.start_all('name: two\nduration: 60\ngoal_tolerance: 0.3\nagents:\n'
                       '  - {position: [0, 0], goals: [[1, 0], [9, 0]], speed: 1, radius: 0.25}\n')
        state = support.wait_for(lambda: (lambda s: s.agents[0].goal.x == 9 and s)(self.walk()), 'the second goal')
        before, after = self.save_and_load()
        self.assertEqual((before, after.agents[0].goal.x), (state, 9))
        self.assertNotIn('[1, 0]', support.read_text(self.path('floor.yaml')))

    def test_places_keep_their_population_and_map(self):
        self.start_all(support.read_text(support.in_package('config', 'scenarios', 'place_office.yaml')).replace(
            '../maps', support.in_package('config', 'maps')))
        self.walk(30)
        before, after = self.save_and_load()
        # Agents begin their routes again, so that their goals may be others.
        poses = [[row[:3] + row[5:] for row in moves_of(state)[0]] for state in (before, after)]
        self.assertEqual(poses[1], poses[0])
        self.assertTrue(poses[0])
        self.walk(5)

    def test_floor_that_no_scenario_can_have_is_refused(self):
        """In a ghost world agents may walk through each other."""
        self.start_all('name: ghosts\nduration: 60\ngoal_tolerance: 0.3\nway_finding: false\nagents:\n'
                       '  - {position: [0, 0], goal: [4, 0], speed: 1, radius: 0.25}\n'
                       'obstacles:\n  - {position: [6, 0], radius: 1, velocity: [-4, 0]}\n')
        support.wait_for(lambda: self.walk().agents[0].in_contact, 'a contact')
        file = self.write('floor.yaml', 'before')
        self.refuse('save_scenario', 'not saved', 'overlap', file=file, overwrite=True)
        self.assertEqual(support.read_text(file), 'before')

    def test_invalid_files_are_refused(self):
        self.start_all()
        self.refuse('save_scenario', 'expected a file name', file='')
        self.refuse('save_scenario', '/none/of/these', file='/none/of/these/floor.yaml')
        self.assertFalse(os.path.exists('/none'))


class AddedPopulationTest(ControllerTestCase):
    """Services ~add_source and ~add_gate."""

    SOURCE = {'position': Point(0, 15, 0), 'goal': Point(9, 15, 0), 'rate': 5.0, 'max_speed': 1.2, 'radius': 0.2}
    GATE = {'begin': Point(30, 0, 0), 'end': Point(30, 4, 0)}

    def test_source_makes_agents_that_walk_to_the_goal(self):
        self.start_all(FULL)
        self.walk(3)
        self.assertEqual(self.do('add_source', count=2, **self.SOURCE).source, 0)
        state = support.wait_for(lambda: (lambda now: len(now.agents) == 5 and now)(self.walk()), 'two more agents')
        self.assertEqual([(a.goal.x, a.goal.y, a.max_speed, a.radius) for a in state.agents[3:]],
                         [(9, 15, 1.2, 0.2)] * 2)

    def test_gate_is_opened_by_its_name(self):
        self.start_all(FULL)
        self.assertEqual(self.do('add_gate', **self.GATE).gate, 'gate_0')
        self.assertEqual(self.do('add_gate', open_from=[0, 5], open_until=[1, 6], **self.GATE).gate, 'gate_1')
        self.assertEqual(self.do('add_gate', gate='mine', open=True, **self.GATE).gate, 'mine')
        self.walk()
        self.do('set_gate', gate='gate_0', open=True)
        self.do('set_gate', gate='mine', open=False)

    def test_both_are_saved_and_read_back(self):
        self.start_all(FULL)
        self.do('add_source', **self.SOURCE)
        self.do('add_gate', gate="it's", open_from=[0, 0.5], open_until=[0.25, 0.75], **self.GATE)
        files = [self.path('first.yaml'), self.path('second.yaml')]
        self.do('save_scenario', file=files[0])
        self.do('load_scenario', scenario=files[0])
        self.do('save_scenario', file=files[1])
        first, second = (support.read_text(file).replace('second', 'first') for file in files)
        self.assertEqual(second, first)
        for words in ('{area: [0, 15], rate: 5, from: 0, goals: [[9, 15]], speed: 1.2, radius: 0.2}',
                      'wall: [[30, 0], [30, 4]], open: [[0, 0.25], [0.5, 0.75]]'):
            self.assertIn(words, first)

    def test_what_no_scenario_may_have_is_refused(self):
        self.start_all(FULL)
        for words, change in ((['rate', 'above 0', '-1'], {'rate': -1.0}), (['radius', 'above 0'], {'radius': 0.0}),
                              (['speed'], {'max_speed': float('nan')}),
                              (['area', 'fits'], {'position': Point(-3, 0, 0)}),
                              (["there is no route 'tour'"], {'route': 'tour'})):
            self.refuse('add_source', *words, **dict(self.SOURCE, **change))
        for words, change in ((['wall'], {'end': Point(30, 0, 0)}), (['open'], {'open_from': [3], 'open_until': [2]}),
                              (['open_until'], {'open_from': [3]})):
            self.refuse('add_gate', *words, **dict(self.GATE, **change))
        self.do('add_gate', gate='door', **self.GATE)
        self.refuse('add_gate', "there is a gate 'door' already", gate='door', **self.GATE)
        self.do('save_scenario', file=self.path('floor.yaml'))
        self.assertNotIn('sources', support.read_text(self.path('floor.yaml')))


class MoveObstacleTest(ControllerTestCase):
    """Service ~move_obstacle."""

    def test_obstacle_is_moved_and_keeps_its_velocity(self):
        self.start_all(FULL)
        before = self.walk()
        self.do('move_obstacle', obstacle=1, position=Point(40, 50, 0))
        after = self.walk()
        moved = after.obstacles[1]
        self.assertEqual([o.radius for o in after.obstacles], [o.radius for o in before.obstacles])
        self.assertEqual(after.obstacles[0].position, before.obstacles[0].position)
        self.assertAlmostEqual(moved.position.x, 40.03)
        self.assertAlmostEqual(moved.position.y, 50.01)
        self.assertEqual(moved.radius, 0.4)

    def test_wrong_places_are_refused(self):
        self.start_all(FULL)
        self.refuse('move_obstacle', 'obstacle', '7', obstacle=7, position=Point(40, 50, 0))
        before = self.walk()
        self.refuse('move_obstacle', 'taken by agent 1', obstacle=0, position=Point(0.2, 5, 0))
        self.assertEqual(len(self.walk().obstacles), len(before.obstacles))
        self.assertEqual(self.walk().obstacles[0].position.y, 20)


if __name__ == '__main__':
    support.run('save_scenario_test')
