#!/usr/bin/python3
"""The services of the crowd controller: pause, step, reset, load_scenario, and changes of the world while it runs."""
import os
import re
import threading

import support
from geometry_msgs.msg import Point, Pose2D, Vector3
from social_crowd.msg import AgentState, AgentStates, EpisodeResult, Perceptions, Scenario

NAN = float('nan')
# Two agents that see nobody and walk straight ahead, an obstacle far away.
QUIET = """
name: quiet
duration: 20
goal_tolerance: 0.3
agents:
  - {position: [0, 0], goal: [20, 0], speed: 0.5, radius: 0.25}
  - {position: [0, 10], goal: [20, 10], speed: 0.5, radius: 0.25}
obstacles:
  - {position: [0, 30], radius: 0.4}
"""
# Places that depend on the seed; two documents.
RANDOM = """
name: random
duration: 5
goal_tolerance: 0.3
agents:
  - {count: 3, position: {box: [[0, 0], [9, 9]]}, goal: {box: [[0, 0], [9, 9]]}, speed: [0.4, 0.6], radius: 0.25}
---
name: random_too
duration: 5
goal_tolerance: 0.3
agents:
  - {count: 2, position: {box: [[0, 0], [9, 9]]}, goal: {box: [[0, 0], [9, 9]]}, speed: [0.4, 0.6], radius: 0.25}
"""


def place_in(message):
    """Episode and tick that a message tells."""
    return tuple(map(int, re.search(r'episode (\d+), tick (\d+)', message).groups()))


class ControllerTestCase(support.CrowdTestCase):
    """A crowd controller that begins paused, a learner, and ears."""

    def start_all(self, text=QUIET, **parameters):
        """Starts the nodes and listens."""
        self.agents = self.listen('agents', AgentStates)
        self.perceptions = self.listen('perceptions', Perceptions)
        self.scenarios = self.listen('scenario', Scenario)
        self.results = self.listen('episode_results', EpisodeResult)
        self.file = self.write('scene.yaml', text)
        self.start_learner()
        self.controller = self.start_controller(self.file, **dict({'paused': True}, **parameters))
        for listener in self.listeners:
            listener.wait_connected()
        self.scenarios.wait()

    def refuse(self, service, *words, **request):
        """A service of the controller is to refuse."""
        return super().refuse(f'crowd_controller/{service}', *words, **request)

    def do(self, service, **request):
        """A service of the controller is to succeed."""
        return self.succeed(f'crowd_controller/{service}', **request)

    def walk(self, ticks=1):
        """Walks so many ticks; where everybody is then."""
        response = self.step(ticks)
        return self.agents.wait_at(response.episode, response.tick)

    def places(self, message):
        """Positions by agent."""
        return {agent.agent: (agent.pose.x, agent.pose.y) for agent in message.agents}

    def assert_place(self, message, agent, x, y):
        """Checks where an agent is."""
        got = self.places(message)[agent]
        self.assertAlmostEqual(got[0], x, places=9)
        self.assertAlmostEqual(got[1], y, places=9)


class PauseAndStepTest(ControllerTestCase):
    """pause and step."""

    def test_step_answers_when_it_is_done(self):
        self.start_all()
        for ticks, tick in ((1, 1), (3, 4), (20, 24)):
            response = self.step(ticks)
            self.assertEqual((response.episode, response.tick), (0, tick))
            self.assert_says(response.message, f'tick {tick}')
        message = self.agents.wait_at(0, 24)
        self.assert_place(message, 0, 24 * 0.05, 0)

    def test_step_goes_on_into_the_next_episode(self):
        self.start_all()
        response = self.step(203)  # an episode lasts 200 ticks
        self.assertEqual((response.episode, response.tick), (1, 3))
        self.results.wait(lambda result: (result.episode, result.tick) == (0, 200))

    def test_step_ends_with_the_last_episode(self):
        self.start_all(episodes=1)
        later = self.call_later('crowd_controller/step', ticks=1000)
        self.assertEqual(self.controller.wait(), 0)
        response = later.result()
        self.assertEqual((response.episode, response.tick), (0, 200))

    def test_bad_steps_are_refused(self):
        self.start_all(pace=1.0)
        self.refuse('step', 'at least 1', ticks=0)
        later = self.call_later('crowd_controller/step', ticks=20)
        self.agents.wait(lambda message: message.tick >= 1)
        self.refuse('step', 'under way', ticks=1)
        self.assertEqual(later.result().tick, 20)
        self.do('pause', data=False)
        self.refuse('step', 'pause', ticks=1)

    def test_nothing_moves_while_paused(self):
        self.start_all()
        for _ in range(10):
            seen = len(self.agents.messages)
            self.do('pause', data=False)
            support.wait_for(lambda: len(self.agents.messages) > seen, 'the crowd to walk')
            episode, tick = place_in(self.do('pause', data=True).message)
            response = self.step(1)
            over = tick + 1 == 200  # then the next episode begins
            expected = (episode + 1, 0) if over else (episode, tick + 1)
            self.assertEqual((response.episode, response.tick), expected, 'the tick after the one that was paused at')

    def test_pausing_twice_is_fine(self):
        self.start_all()
        self.do('pause', data=True)
        self.do('pause', data=True)
        self.assertEqual(self.step(1).tick, 1)

    def test_going_on_ends_a_step(self):
        """Who steps 1000000 ticks gets an answer, at the latest when somebody else lets the crowd walk."""
        self.start_all(pace=5.0)
        later = self.call_later('crowd_controller/step', ticks=1000000)
        self.agents.wait(lambda message: message.tick >= 1)
        self.do('pause', data=False)
        later.result()


class ResetTest(ControllerTestCase):
    """reset."""

    def record(self, ticks=50):
        """Walks and returns where everybody was."""
        response = self.step(ticks)
        self.agents.wait_at(response.episode, response.tick)
        first = response.tick - ticks + 1
        messages = [self.agents.wait_at(response.episode, tick) for tick in range(first, response.tick + 1)]
        return [self.places(message) for message in messages]

    def test_the_same_again(self):
        self.start_all(RANDOM)
        first = self.record(49)
        response = self.do('reset', keep_seed=True)
        self.assert_says(response.message, 'episode 1, tick 0')
        self.assertEqual(self.record(49), first)
        scenario = self.scenarios.wait_at(1, 0)
        self.assertEqual((scenario.name, scenario.instance), ('random', 0))

    def test_from_a_later_instance(self):
        """A reset goes back to the first document."""
        self.start_all(RANDOM)
        first = self.record(20)
        self.walk(40)  # 50 ticks an episode
        self.assertEqual(self.scenarios.wait_at(1, 0).name, 'random_too')
        self.do('reset', keep_seed=True)
        self.assertEqual(self.record(20), first)

    def test_another_seed(self):
        self.start_all(RANDOM, seed=4)
        first = self.record(20)
        self.assert_says(self.do('reset', keep_seed=False, seed=5).message, 'seed 5')
        other = self.record(20)
        self.assertNotEqual(other, first)
        self.do('reset', keep_seed=False, seed=4)
        self.assertEqual(self.record(20), first)

    def test_the_recording_begins_anew(self):
        self.start_all(RANDOM, trajectories=self.path('ros'), seed=4)
        self.step(60)
        self.do('reset', keep_seed=False, seed=9)
        self.step(100)
        expected = self.headless(self.file, seed=9)
        self.assert_same_recording(support.read_bytes(self.path('ros/scene.csv')), expected)

    def test_while_walking(self):
        """Again and again, at any moment of a tick; it walks on, and answers to what was before are not taken."""
        self.start_all(RANDOM)
        first = self.record(10)
        self.do('pause', data=False)
        for _ in range(20):
            self.do('reset', keep_seed=True)
        self.do('pause', data=True)
        self.do('reset', keep_seed=True)
        self.assertEqual(self.record(10), first)


class LoadScenarioTest(ControllerTestCase):
    """load_scenario."""

    def test_a_good_one(self):
        self.start_all()
        self.step(3)
        file = self.write('random.yaml', RANDOM)
        response = self.do('load_scenario', scenario=file)
        self.assertEqual(response.documents, 2)
        self.assert_says(response.message, file)
        scenario = self.scenarios.wait(lambda message: message.name == 'random')
        self.assertEqual((scenario.episode, scenario.instance, len(scenario.agents)), (1, 0, 3))
        response = self.step(2)
        self.assertEqual((response.episode, response.tick), (1, 2))

    def test_by_name(self):
        self.start_all(scenario_folder=support.in_package('config', 'scenarios'))
        self.do('load_scenario', scenario='circle6')
        self.scenarios.wait(lambda message: message.name == 'circle6')
        self.refuse('load_scenario', 'no_such_name.yaml', scenario='no_such_name')

    def test_its_recording(self):
        self.start_all(trajectories=self.path('ros'))
        self.step(3)
        file = self.write('random.yaml', RANDOM)
        self.do('load_scenario', scenario=file)
        self.step(100)
        self.assert_same_recording(support.read_bytes(self.path('ros/random.csv')), self.headless(file))

    def test_bad_ones_change_nothing(self):
        self.start_all()
        self.step(3)
        wrong = RANDOM.replace('name: random_too', 'name: random_too\ncolour: red')
        line = wrong.splitlines().index('colour: red') + 1
        file = self.write('wrong.yaml', wrong)
        self.refuse('load_scenario', file, 'document 2', f'line {line}', 'colour', scenario=file)
        overlap = self.write('overlap.yaml', QUIET.replace('[0, 10]', '[0, 0.1]'))
        self.refuse('load_scenario', overlap, 'document 1', 'overlap', scenario=overlap)
        self.refuse('load_scenario', 'line 1', scenario=self.write('no.yaml', '{'))
        self.refuse('load_scenario', 'empty.yaml', scenario=self.write('empty.yaml', ''))
        self.refuse('load_scenario', 'missing.yaml', scenario=self.path('missing.yaml'))
        self.refuse('load_scenario', self.folder, scenario=self.folder)
        self.refuse('load_scenario', scenario='')
        response = self.step(1)
        self.assertEqual((response.episode, response.tick), (0, 4))
        self.assertEqual([message.name for message in self.scenarios.messages], ['quiet'])

    def test_a_recording_that_cannot_be_written_changes_nothing(self):
        self.start_all(trajectories=self.path('ros'))
        self.step(3)
        os.mkdir(self.path('ros/random.csv'))
        self.refuse('load_scenario', 'random.csv', scenario=self.write('random.yaml', RANDOM))
        response = self.step(1)
        self.assertEqual((response.episode, response.tick), (0, 4))
        self.step(196)
        self.assert_same_recording(support.read_bytes(self.path('ros/scene.csv')), self.headless(self.file))


class AgentsTest(ControllerTestCase):
    """spawn_agent, remove_agent, set_goal."""

    def spawn(self, x, y, goal=(10.0, 20.0), theta=0.0, speed=0.4, radius=0.3):
        """A request."""
        return {'pose': Pose2D(x, y, theta), 'goal': Point(goal[0], goal[1], 0.0), 'speed': speed, 'radius': radius}

    def test_a_new_agent_walks(self):
        self.start_all()
        self.step(2)
        response = self.do('spawn_agent', **self.spawn(0.0, 20.0))
        self.assertEqual(response.agent, 2)
        message = self.walk(1)
        self.assertEqual(message.tick, 3)
        self.assertEqual(len(message.agents), 3)
        new = message.agents[2]
        self.assertEqual((new.agent, new.status, new.speed, new.radius), (2, AgentState.WALKING, 0.4, 0.3))
        self.assertEqual((new.goal.x, new.goal.y), (10.0, 20.0))
        self.assert_place(message, 2, 0.04, 20.0)
        self.assert_place(self.walk(10), 2, 0.44, 20.0)

    def test_it_counts_in_the_result(self):
        self.start_all()
        self.step(100)
        self.do('spawn_agent', **self.spawn(0.0, 20.0, goal=(0.7, 20.0)))
        self.step(100)
        agents = self.results.wait().agents
        self.assertEqual(len(agents), 3)
        self.assertTrue(agents[2].arrived)
        self.assertEqual(agents[2].ticks, 10)

    def test_bad_ones_are_refused(self):
        self.start_all()
        for values, words in (
                ({'x': NAN}, ['position']), ({'y': float('inf')}, ['position']), ({'theta': NAN}, ['heading']),
                ({'goal': (NAN, 0.0)}, ['goal']), ({'speed': 0.0}, ['speed', 'above 0']), ({'speed': NAN}, ['speed']),
                ({'radius': -1.0}, ['radius', 'above 0']), ({'x': 0.1, 'y': 0.1}, ['agent 0']),
                ({'x': 0.1, 'y': 30.1}, ['obstacle 0'])):
            self.refuse('spawn_agent', *words, **self.spawn(**dict({'x': 0.0, 'y': 20.0}, **values)))
        self.assertEqual(len(self.walk().agents), 2)

    def test_a_wall_takes_places_too(self):
        self.start_all(QUIET + 'walls:\n  - [[-5, 20], [5, 20]]\n')
        self.refuse('spawn_agent', 'wall', **self.spawn(0.0, 20.1))

    def test_removing(self):
        self.start_all()
        self.step(2)
        self.assert_says(self.do('remove_agent', agent=0).message, 'agent 0')
        message = self.walk()
        self.assertEqual([agent.status for agent in message.agents], [AgentState.REMOVED, AgentState.WALKING])
        self.assert_place(message, 0, 0.1, 0.0)
        self.assert_place(message, 1, 0.15, 10.0)
        self.walk(1)
        perceived = self.perceptions.wait_at(0, 3)
        self.assertEqual([agent.agent for agent in perceived.agents], [1])
        self.refuse('remove_agent', 'agent 0', agent=0)
        self.refuse('remove_agent', 'agent 2', agent=2)
        self.refuse('remove_agent', 'agent 4294967295', agent=2**32 - 1)
        self.refuse('set_goal', 'agent 0', agent=0, goal=Point(1, 1, 0))

    def test_removing_the_last_one_ends_the_episode(self):
        self.start_all()
        self.step(2)
        self.do('remove_agent', agent=0)
        self.do('remove_agent', agent=1)
        self.assertEqual(self.step(1).episode, 1)
        self.results.wait(lambda result: result.episode == 0)

    def test_another_goal(self):
        self.start_all()
        self.step(2)
        self.assert_says(self.do('set_goal', agent=1, goal=Point(-20, 10, 5)).message, 'agent 1')
        message = self.walk(2)  # turns on the spot and walks back
        self.assertEqual((message.agents[1].goal.x, message.agents[1].goal.y), (-20, 10))
        self.assert_place(message, 1, 0.0, 10.0)
        self.assert_place(message, 0, 0.2, 0.0)

    def test_a_goal_replaces_all_the_agent_had(self):
        self.start_all(QUIET.replace('goal: [20, 0]', 'goals: [[1, 0], [20, 0]]'))
        self.step(1)
        self.do('set_goal', agent=0, goal=Point(0.5, 0, 0))
        message = self.walk(5)
        self.assertEqual(message.agents[0].status, AgentState.ARRIVED)
        self.refuse('set_goal', 'agent 0', agent=0, goal=Point(1, 1, 0))
        self.refuse('remove_agent', 'agent 0', agent=0)

    def test_bad_goals_are_refused(self):
        self.start_all()
        self.refuse('set_goal', 'goal', agent=0, goal=Point(NAN, 0, 0))
        self.refuse('set_goal', 'goal', agent=0, goal=Point(0, float('-inf'), 0))
        self.refuse('set_goal', 'agent 2', agent=2, goal=Point(1, 1, 0))
        self.assert_place(self.walk(), 0, 0.05, 0.0)


class ObstaclesTest(ControllerTestCase):
    """spawn_obstacle, remove_obstacle."""

    def spawn(self, x, y, velocity=(0.0, 0.0), radius=0.5):
        """A request."""
        return {'position': Point(x, y, 0.0), 'velocity': Vector3(velocity[0], velocity[1], 0.0), 'radius': radius}

    def assert_obstacles(self, message, *expected):
        """Checks positions and radii of all obstacles, in order."""
        got = [(o.obstacle, round(o.position.x, 9), round(o.position.y, 9), o.radius) for o in message.obstacles]
        self.assertEqual(got, [(number, *values) for number, values in enumerate(expected)])

    def test_at_rest_and_moving(self):
        self.start_all()
        self.step(10)
        self.assertEqual(self.do('spawn_obstacle', **self.spawn(5.0, 5.0)).obstacle, 1)
        self.assertEqual(self.do('spawn_obstacle', **self.spawn(7.0, 5.0, (1.0, -2.0), 0.25)).obstacle, 2)
        message = self.walk(5)
        self.assert_obstacles(message, (0.0, 30.0, 0.4), (5.0, 5.0, 0.5), (7.5, 4.0, 0.25))
        velocity = message.obstacles[2].velocity
        self.assertEqual((velocity.x, velocity.y), (1.0, -2.0))

    def test_agents_perceive_it(self):
        self.start_all()
        self.step(1)
        self.do('spawn_obstacle', **self.spawn(2.0, 0.0))
        self.step(1)
        perceived = self.perceptions.wait_at(0, 1)
        bodies = [(body.x, body.y, body.radius) for body in perceived.bodies]
        self.assertEqual(bodies, [(1.95, 0.0, 0.5)])

    def test_removing(self):
        self.start_all()
        self.do('spawn_obstacle', **self.spawn(5.0, 5.0))
        self.do('remove_obstacle', obstacle=0)
        self.assert_obstacles(self.walk(), (5.0, 5.0, 0.5))
        self.refuse('remove_obstacle', 'obstacle 1', obstacle=1)
        self.do('remove_obstacle', obstacle=0)
        self.assert_obstacles(self.walk())
        self.refuse('remove_obstacle', 'obstacle 0', obstacle=0)

    def test_bad_ones_are_refused(self):
        self.start_all()
        for values, words in (
                ({'x': NAN}, ['position']), ({'velocity': (0.0, NAN)}, ['velocity']),
                ({'velocity': (float('inf'), 0.0)}, ['velocity']), ({'radius': 0.0}, ['radius', 'above 0']),
                ({'radius': NAN}, ['radius']), ({'x': 0.6, 'y': 0.0}, ['agent 0'])):
            self.refuse('spawn_obstacle', *words, **self.spawn(**dict({'x': 5.0, 'y': 5.0}, **values)))
        self.assert_obstacles(self.walk(), (0.0, 30.0, 0.4))


class ManyCallersTest(ControllerTestCase):
    """Services from many sides while the crowd walks."""

    def test_nothing_is_lost(self):
        self.start_all(paused=False)
        spawned = []
        threads = [threading.Thread(target=self.spawn_some, args=(10.0 * i, spawned), daemon=True) for i in range(1, 6)]
        for thread in threads:
            thread.start()
        support.wait_for(lambda: not any(thread.is_alive() for thread in threads), 'all callers to be served')
        self.assertEqual(len(spawned), 25)
        by_episode = {}
        for agent, episode in spawned:
            by_episode.setdefault(episode, []).append(agent)
        for episode, agents in by_episode.items():
            self.assertEqual(sorted(agents), list(range(2, 2 + len(agents))), f'numbers given in episode {episode}')

    def spawn_some(self, x, spawned):
        """One of the callers."""
        for i in range(5):
            y = 40.0 + 2.0 * i
            # In an episode of 200 ticks it walks 6 m, past no other place.
            response = self.do('spawn_agent', pose=Pose2D(x, y, 0.0), goal=Point(x + 60, y, 0), speed=0.3, radius=0.25)
            spawned.append((response.agent, place_in(response.message)[0]))


if __name__ == '__main__':
    support.run('controller_services_test')
