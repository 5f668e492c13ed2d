#!/usr/bin/python3
"""agents and tf are published at a limited rate, and always when the crowd is paused or an episode ends."""
import support
from social_crowd.msg import AgentStates, EpisodeResult, Perceptions
from tf2_msgs.msg import TFMessage

NEVER = 0.0001  # [Hz], less than once per test
SCENE = """
name: scene
duration: 2
goal_tolerance: 0.2
agents:
  - {position: [0, 0], goal: [9, 0], speed: 0.5, radius: 0.25}
"""


class AgentsRateTest(support.CrowdTestCase):
    """A controller with a limited rate."""

    def start_all(self, **parameters):
        """Starts a paused controller and a learner and listens."""
        self.agents = self.listen('agents', AgentStates)
        self.frames = self.listen('/tf', TFMessage)
        self.perceptions = self.listen('perceptions', Perceptions)
        self.results = self.listen('episode_results', EpisodeResult)
        self.start_learner()
        self.start_controller(self.write('scene.yaml', SCENE), paused=True, publish_tf=True, **parameters)
        for ear in (self.agents, self.frames, self.perceptions, self.results):
            ear.wait_connected()

    def published(self):
        """Returns the published episodes and ticks without the start, which may be published before the connection."""
        return [(message.episode, message.tick) for message in self.agents.messages
                if (message.episode, message.tick) != (0, 0)]

    def published_frames(self):
        """Returns the messages of tf from the first tick on."""
        began = self.perceptions.wait_at(0, 0).header.stamp
        return [message for message in list(self.frames.messages) if message.transforms[0].header.stamp > began]

    def wait_published(self, *expected):
        """Waits until exactly these episodes and ticks are published, in this order."""
        support.wait_for(lambda: len(self.published()) >= len(expected), f'{expected}, got {self.published()}')
        self.assertEqual(self.published(), list(expected))

    def test_rate_zero_publishes_each_tick(self):
        self.start_all(agents_rate=0)
        self.step(20)
        self.wait_published(*((0, tick) for tick in range(1, 21)), (1, 0))
        support.wait_for(lambda: len(self.published_frames()) >= 21, 'frames of each tick')

    def test_low_rate_publishes_only_pauses_and_ends(self):
        self.start_all(agents_rate=NEVER)
        self.step(7)
        self.wait_published((0, 7))
        self.step(20)  # 13 of this episode, 7 of the next
        self.wait_published((0, 7), (0, 20), (1, 0), (1, 7))
        self.perceptions.wait_at(1, 6)
        ticks = [message.tick for message in self.perceptions.messages if message.episode == 0]
        self.assertEqual(sorted(set(ticks)), list(range(21)), 'learners get each tick')
        support.wait_for(lambda: len(self.published_frames()) >= 4, 'frames')
        self.assertEqual(len(self.published_frames()), 4)

    def test_pause_publishes_the_states_of_the_last_tick(self):
        self.start_all(agents_rate=NEVER)
        self.step(5)
        state = self.agents.wait_at(0, 5).agents[0].pose
        perceived = self.perceptions.wait_at(0, 4).agents[0].pose
        self.assertGreater((state.x, state.y), (perceived.x, perceived.y))
        self.step(1)
        perceived = self.perceptions.wait_at(0, 5).agents[0].pose
        self.assertEqual((state.x, state.y, state.theta), (perceived.x, perceived.y, perceived.theta))


if __name__ == '__main__':
    support.run('agents_rate_test')
