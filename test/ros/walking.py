"""Episodes that are walked through ROS, for comparison with runs without ROS."""
import support
from social_crowd.msg import EpisodeResult

# A circle, walls, moving obstacles, several goals, random places, solid bodies, sequential order, kept headings,
# agents that stay where they arrive.
SCENARIO = support.data('lockstep.yaml')
EPISODES = 12  # so that each of the six documents is walked twice


class WalkTestCase(support.CrowdTestCase):
    """Walks episodes through ROS and records them."""

    def start_walk(self, scenario=SCENARIO, episodes=EPISODES, seed=5, paused=False, **parameters):
        """Starts the controller. It walks when its results are heard: all episodes may be over sooner than this test is
        connected."""
        self.scenario, self.episodes = scenario, episodes
        self.results = self.listen('episode_results', EpisodeResult)
        self.controller = self.start_controller(scenario, episodes=episodes, seed=seed, trajectories=self.path('ros'),
                                                paused=True, **parameters)
        self.results.wait_connected()
        if not paused:
            self.succeed('crowd_controller/pause', data=False)

    def finish_walk(self):
        """Waits for the end of the episodes. Returns the recording. No answer may be missed or dropped."""
        self.assertEqual(self.controller.wait(), 0)
        support.wait_for(lambda: len(self.results.messages) >= self.episodes, 'the results of all episodes')
        # The first answer may arrive twice: when it is published and, because it is latched, after the connection.
        counts = [(result.missed_answers, result.episode and result.dropped_answers)
                  for result in self.results.messages]
        self.assertEqual(counts, [(0, 0)] * self.episodes, 'missed and dropped answers')
        self.blocked = sum(result.blocked_moves for result in self.results.messages)
        return support.read_bytes(self.path('ros/' + support.recording_of(self.scenario)))

    def walk(self, *arguments, **parameters):
        """Walks episodes. Returns the recording."""
        self.start_walk(*arguments, **parameters)
        return self.finish_walk()

    def train_anticipation(self, vision='', name='table.txt', **keys):
        """Trains a table of the state set `anticipation` with these keys. Returns its file."""
        config = support.read_text(support.in_package('config', 'learning', 'anticipation.yaml'))
        config = config.replace('../scenarios', support.in_package('config', 'scenarios'))
        state_set = ''.join(f'\n  {key}: {value}' for key, value in keys.items())
        config = config.replace('type: anticipation', 'type: anticipation' + state_set, 1)
        self.tool('train', self.write('config.yaml', f'{config}{vision}\n'), '--output', self.path(name),
                  '--episodes', 20)
        return self.path(name)
