"""A paused controller with a learner, and all topics."""
import rospy
import support
from social_crowd.msg import AgentStates, EpisodeResult, LearnerStatus, Perceptions, RelativeActions, Scenario

TOPICS = {
    'agents': AgentStates,
    'perceptions': Perceptions,
    'scenario': Scenario,
    'episode_results': EpisodeResult,
    'actions': RelativeActions,
    'learner_status': LearnerStatus,
}
# Two agents, one of which arrives; a wall and a moving obstacle. 3 s are 30 ticks.
SCENE = """
name: scene
duration: 3
goal_tolerance: 0.2
agents:
  - {position: [0, 0], goal: [0.8, 0.6], speed: 0.5, radius: 0.25}
  - {position: [3, 0], goal: [3, 9], speed: 0.5, radius: 0.3}
obstacles:
  - {position: [3, 1.5], radius: 0.4, velocity: [0.5, 0]}
walls:
  - [[2, -1], [4, -1]]
"""


class BroadcastTestCase(support.CrowdTestCase):
    """A paused controller with a learner."""

    def start_all(self, scene=SCENE, table=support.NEAREST_TABLE, **parameters):
        """Starts both and listens to all topics. With the table of anticipation, the agent of SCENE arrives in time."""
        self.ears = {name: self.listen(name, kind) for name, kind in TOPICS.items()}
        self.file = self.write('scene.yaml', scene)
        self.began = rospy.Time.now()
        self.start_learner(q_table=table)
        self.controller = self.start_controller(self.file, paused=True, **parameters)
        for ear in self.ears.values():
            ear.wait_connected()

    def walk_an_episode(self):
        """Walks an episode to its end and waits for all its messages."""
        self.step(30)
        self.ears['episode_results'].wait_at(0, 30)
        for name in ('agents', 'perceptions'):
            self.ears[name].wait_at(0, 30)
        self.ears['actions'].wait_at(0, 29)
        self.ears['scenario'].wait()
        self.ears['learner_status'].wait(lambda status: status.agents)
