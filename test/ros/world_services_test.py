#!/usr/bin/python3
"""The services of the crowd controller that change the world while it runs."""
import threading

import support
from controlling import QUIET, ControllerTestCase, place_in
from geometry_msgs.msg import Point, Pose2D, Vector3
from social_crowd.msg import AgentState

NAN = float('nan')


class AgentsTest(ControllerTestCase):
    """spawn_agent, remove_agent, set_goal."""

    def spawn(self, x, y, goal=(10.0, 20.0), theta=0.0, max_speed=0.4, radius=0.3):
        """Returns a request."""
        return {'pose': Pose2D(x, y, theta), 'goal': Point(goal[0], goal[1], 0.0), 'max_speed': max_speed,
                'radius': radius}

    def test_spawned_agent_walks(self):
        self.start_all()
        self.step(2)
        response = self.do('spawn_agent', **self.spawn(0.0, 20.0))
        self.assertEqual(response.agent, 2)
        message = self.walk(1)
        self.assertEqual(message.tick, 3)
        self.assertEqual(len(message.agents), 3)
        new = message.agents[2]
        self.assertEqual((new.agent, new.status, new.max_speed, new.radius), (2, AgentState.WALKING, 0.4, 0.3))
        self.assertEqual((new.goal.x, new.goal.y), (10.0, 20.0))
        self.assert_place(message, 2, 0.04, 20.0)
        self.assert_place(self.walk(10), 2, 0.44, 20.0)

    def test_spawned_agent_counts_in_the_result(self):
        self.start_all()
        self.step(100)
        self.do('spawn_agent', **self.spawn(0.0, 20.0, goal=(0.7, 20.0)))
        self.step(100)
        agents = self.results.wait().agents
        self.assertEqual(len(agents), 3)
        self.assertTrue(agents[2].arrived)
        self.assertEqual(agents[2].ticks, 10)

    def test_invalid_agents_are_refused(self):
        self.start_all()
        for values, words in (
                ({'x': NAN}, ['position']), ({'y': float('inf')}, ['position']), ({'theta': NAN}, ['heading']),
                ({'goal': (NAN, 0.0)}, ['goal']), ({'max_speed': 0.0}, ['max_speed', 'above 0']),
                ({'max_speed': NAN}, ['max_speed']),
                ({'radius': -1.0}, ['radius', 'above 0']), ({'x': 0.1, 'y': 0.1}, ['agent 0']),
                ({'x': 0.1, 'y': 30.1}, ['obstacle 0'])):
            self.refuse('spawn_agent', *words, **self.spawn(**dict({'x': 0.0, 'y': 20.0}, **values)))
        self.assertEqual(len(self.walk().agents), 2)

    def test_agents_on_walls_are_refused(self):
        self.start_all(QUIET + 'walls:\n  - [[-5, 20], [5, 20]]\n')
        self.refuse('spawn_agent', 'wall', **self.spawn(0.0, 20.1))

    def test_removed_agent_is_not_perceived(self):
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

    def test_removing_the_last_agent_ends_the_episode(self):
        self.start_all()
        self.step(2)
        self.do('remove_agent', agent=0)
        self.do('remove_agent', agent=1)
        self.assertEqual(self.step(1).episode, 1)
        self.results.wait(lambda result: result.episode == 0)

    def test_agent_walks_to_a_new_goal(self):
        self.start_all()
        self.step(2)
        self.assert_says(self.do('set_goal', agent=1, goal=Point(-20, 10, 5)).message, 'agent 1')
        message = self.walk(2)  # turns and walks back
        self.assertEqual((message.agents[1].goal.x, message.agents[1].goal.y), (-20, 10))
        self.assert_place(message, 1, 0.0, 10.0)
        self.assert_place(message, 0, 0.2, 0.0)

    def test_new_goal_replaces_all_goals(self):
        self.start_all(QUIET.replace('goal: [20, 0]', 'goals: [[1, 0], [20, 0]]'))
        self.step(1)
        self.do('set_goal', agent=0, goal=Point(0.5, 0, 0))
        message = self.walk(5)
        self.assertEqual(message.agents[0].status, AgentState.ARRIVED)
        self.refuse('set_goal', 'agent 0', agent=0, goal=Point(1, 1, 0))
        self.refuse('remove_agent', 'agent 0', agent=0)

    def test_invalid_goals_are_refused(self):
        self.start_all()
        self.refuse('set_goal', 'goal', agent=0, goal=Point(NAN, 0, 0))
        self.refuse('set_goal', 'goal', agent=0, goal=Point(0, float('-inf'), 0))
        self.refuse('set_goal', 'agent 2', agent=2, goal=Point(1, 1, 0))
        self.assert_place(self.walk(), 0, 0.05, 0.0)


class ObstaclesTest(ControllerTestCase):
    """spawn_obstacle, remove_obstacle."""

    def spawn(self, x, y, velocity=(0.0, 0.0), radius=0.5):
        """Returns a request."""
        return {'position': Point(x, y, 0.0), 'velocity': Vector3(velocity[0], velocity[1], 0.0), 'radius': radius}

    def assert_obstacles(self, message, *expected):
        """Checks positions and radii of all obstacles, in order."""
        got = [(o.obstacle, round(o.position.x, 9), round(o.position.y, 9), o.radius) for o in message.obstacles]
        self.assertEqual(got, [(number, *values) for number, values in enumerate(expected)])

    def test_spawns_static_and_moving_obstacles(self):
        self.start_all()
        self.step(10)
        self.assertEqual(self.do('spawn_obstacle', **self.spawn(5.0, 5.0)).obstacle, 1)
        self.assertEqual(self.do('spawn_obstacle', **self.spawn(7.0, 5.0, (1.0, -2.0), 0.25)).obstacle, 2)
        message = self.walk(5)
        self.assert_obstacles(message, (0.0, 30.0, 0.4), (5.0, 5.0, 0.5), (7.5, 4.0, 0.25))
        velocity = message.obstacles[2].velocity
        self.assertEqual((velocity.x, velocity.y), (1.0, -2.0))

    def test_agents_perceive_a_spawned_obstacle(self):
        self.start_all()
        self.step(1)
        self.do('spawn_obstacle', **self.spawn(1.25, 0.0))
        self.step(1)
        perceived = self.perceptions.wait_at(0, 1)
        bodies = [(body.x, body.y, body.radius) for body in perceived.neighbours]
        self.assertEqual(bodies, [(1.2, 0.0, 0.5)])

    def test_removed_obstacle_is_not_published(self):
        self.start_all()
        self.do('spawn_obstacle', **self.spawn(5.0, 5.0))
        self.do('remove_obstacle', obstacle=0)
        self.assert_obstacles(self.walk(), (5.0, 5.0, 0.5))
        self.refuse('remove_obstacle', 'obstacle 1', obstacle=1)
        self.do('remove_obstacle', obstacle=0)
        self.assert_obstacles(self.walk())
        self.refuse('remove_obstacle', 'obstacle 0', obstacle=0)

    def test_invalid_obstacles_are_refused(self):
        self.start_all()
        for values, words in (
                ({'x': NAN}, ['position']), ({'velocity': (0.0, NAN)}, ['velocity']),
                ({'velocity': (float('inf'), 0.0)}, ['velocity']), ({'radius': 0.0}, ['radius', 'above 0']),
                ({'radius': NAN}, ['radius']), ({'x': 0.6, 'y': 0.0}, ['agent 0'])):
            self.refuse('spawn_obstacle', *words, **self.spawn(**dict({'x': 5.0, 'y': 5.0}, **values)))
        self.assert_obstacles(self.walk(), (0.0, 30.0, 0.4))


class ManyCallersTest(ControllerTestCase):
    """Concurrent calls of services while the crowd walks."""

    def test_concurrent_requests_are_all_carried_out(self):
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
        """Body of the thread of a caller."""
        for i in range(5):
            y = 40.0 + 2.0 * i
            # In an episode of 200 ticks the agent walks 6 m, away from all other places.
            response = self.do('spawn_agent', pose=Pose2D(x, y, 0.0), goal=Point(x + 60, y, 0), max_speed=0.3,
                               radius=0.25)
            spawned.append((response.agent, place_in(response.message)[0]))


if __name__ == '__main__':
    support.run('world_services_test')
