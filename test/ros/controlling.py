"""A crowd controller with a learner, listeners, and calls of its services."""
import re

import support
from social_crowd.msg import AgentStates, EpisodeResult, Perceptions, Scenario

# Two agents without neighbours that walk straight ahead, and a distant obstacle.
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


def place_in(message):
    """Returns episode and tick of a message."""
    return tuple(map(int, re.search(r'episode (\d+), tick (\d+)', message).groups()))


class ControllerTestCase(support.CrowdTestCase):
    """A crowd controller that starts paused, a learner, and listeners."""

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
        """Calls a service of the controller, which must refuse."""
        return super().refuse(f'crowd_controller/{service}', *words, **request)

    def do(self, service, **request):
        """Calls a service of the controller, which must succeed."""
        return self.succeed(f'crowd_controller/{service}', **request)

    def walk(self, ticks=1):
        """Walks a number of ticks. Returns the state after them."""
        response = self.step(ticks)
        return self.agents.wait_at(response.episode, response.tick)

    def places(self, message):
        """Returns positions by agent."""
        return {agent.agent: (agent.pose.x, agent.pose.y) for agent in message.agents}

    def assert_place(self, message, agent, x, y):
        """Checks the position of an agent."""
        got = self.places(message)[agent]
        self.assertAlmostEqual(got[0], x, places=9)
        self.assertAlmostEqual(got[1], y, places=9)
