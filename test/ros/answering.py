"""Helpers for tests of answers to the crowd controller: a simple scene, and a learner with prepared answers."""
import math

import rospy
import support
from social_crowd.msg import AgentStates, EpisodeResult, Perceptions, RelativeAction, RelativeActions

AHEAD, BACK = (0.0, 1.0), (math.pi, 1.0)  # rotation, fraction of the maximum speed
# Two agents without neighbours that walk straight ahead during the whole episode.
QUIET = """
name: quiet
duration: {seconds}
goal_tolerance: 0.3
agents:
  - {{position: [0, 0], goal: [100, 0], speed: 0.5, radius: 0.25}}
  - {{position: [0, 10], goal: [100, 10], speed: 0.5, radius: 0.25}}
"""


class AbsenceTestCase(support.CrowdTestCase):
    """A crowd controller with short deadlines for answers."""

    def start_quiet(self, seconds=1000, **parameters):
        """Starts the controller and listens to it."""
        self.agents = self.listen('agents', AgentStates)
        self.results = self.listen('episode_results', EpisodeResult)
        self.file = self.write('quiet.yaml', QUIET.format(seconds=seconds))
        patience = {'answer_deadline': 1.0, 'misses_until_absent': 2}
        self.controller = self.start_controller(self.file, **dict(patience, **parameters))
        self.agents.wait_connected()
        self.results.wait_connected()

    def start_pair(self):
        """A learner for each agent; the second one can be killed."""
        self.start_learner('learner_0', agents=[0])
        self.second = self.start_learner('learner_1', agents=[1])

    def remove_all(self):
        """Ends the episode with the next tick."""
        for agent in (0, 1):
            self.succeed('crowd_controller/remove_agent', agent=agent)

    def rows(self, instance=0):
        """Returns the recording of an instance: {tick: {agent: (x, y)}}."""
        rows = {}
        for (found, tick, agent), place in support.read_recording(self.path('ros/quiet.csv')).items():
            if found == instance:
                rows.setdefault(tick, {})[agent] = place
        return rows

    def ticks_at_rest(self, agent, instance=0):
        """Returns the number of ticks in which an agent did not move."""
        walk = [places[agent] for _, places in sorted(self.rows(instance).items()) if agent in places]
        return sum(before == after for before, after in zip(walk, walk[1:]))


class Answers:
    """A learner that lets all agents walk straight ahead, and sends additional answers of a test."""

    def __init__(self, test):
        self.silent = set()  # agents that get no answer
        self.before = lambda perceived: []  # answers sent before the right one
        self.after = lambda perceived: []  # answers sent after it
        self.answered = set()  # (episode, tick); perceptions may come again
        self.publisher = rospy.Publisher(f'{test.namespace}/actions', RelativeActions, queue_size=1000)
        test.addCleanup(self.publisher.unregister)
        support.wait_for(lambda: self.publisher.get_num_connections() > 0, 'the controller to listen')
        self.subscriber = rospy.Subscriber(f'{test.namespace}/perceptions', Perceptions, self.answer, tcp_nodelay=True)
        test.addCleanup(self.subscriber.unregister)

    def answer(self, perceived):
        """Answers perceptions."""
        now = (perceived.episode, perceived.tick)
        if perceived.last or now in self.answered:
            return
        self.answered.add(now)
        agents = [agent.agent for agent in perceived.agents if agent.agent not in self.silent]
        right = actions_for(perceived.episode, perceived.tick, {agent: AHEAD for agent in agents})
        for message in self.before(perceived) + [right] + self.after(perceived):
            self.send(message, perceived)

    def send(self, message, perceived):
        """Publishes an answer, of this run unless it names another one."""
        message.header = perceived.header
        message.run = message.run or perceived.run
        self.publisher.publish(message)


def actions_for(episode, tick, actions):
    """Returns a message with an answer: {agent: (rotation, fraction of the maximum speed)}."""
    message = RelativeActions(episode=episode, tick=tick)
    message.agents = [RelativeAction(agent, *action) for agent, action in actions.items()]
    return message
