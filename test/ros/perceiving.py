"""Perceptions for tests of learners without a crowd controller."""
import math
import threading

import rospy
import support
from social_crowd.msg import AgentPerception, LearnerStatus, Neighbour, Perceptions, RelativeActions

FREE = None  # no obstacle
NEAR, FAR = 0.3, 0.8  # [m] to the rim: the thesis's distance classes 1 and 2
RADIUS = 0.25  # [m] of all bodies
VISION = 10.0  # [m], more than the models of the tests need


def ahead(degrees, distance):
    """Returns a point at a bearing, in the agent's frame."""
    return distance * math.cos(math.radians(degrees)), distance * math.sin(math.radians(degrees))


def perceptions(episode, tick, last=False):
    """Returns perceptions without agents."""
    message = Perceptions(episode=episode, tick=tick, tick_duration=support.TICK, last=last, vision_radius=VISION)
    message.header.frame_id = 'map'
    message.header.stamp = rospy.Time.now()
    return message


def add_agent(message, agent, goal, body=FREE, arrived=False, acted=True):
    """Adds the perception of one agent: goal and at most one obstacle, (x, y) in its frame [m]."""
    self = AgentPerception(agent=agent, max_speed=0.3, radius=RADIUS, goal_x=goal[0], goal_y=goal[1], arrived=arrived,
                           acted=acted, first_neighbour=len(message.neighbours), first_wall=len(message.walls))
    if body is not FREE:
        self.neighbour_count = 1
        message.neighbours.append(Neighbour(kind=Neighbour.OBSTACLE, x=body[0], y=body[1], radius=RADIUS))
    message.agents.append(self)
    return message


def all_situations(episode=0, tick=0):
    """Returns perceptions of 136 agents, one in each state before arrival of the first state set of the thesis."""
    message = perceptions(episode, tick)
    for goal in range(0, 360, 45):
        bodies = [FREE] + [ahead(bearing, distance + RADIUS) for bearing in (7, 30, 70, 130, -130, -70, -30, -7)
                           for distance in (NEAR, FAR)]
        for body in bodies:
            add_agent(message, len(message.agents), ahead(goal, 5.0), body)
    return message


class Perceiver:
    """Replaces the crowd controller: publishes perceptions, also on the topics that learners report, and receives the
    answers of learners."""

    def __init__(self, test, learners=1):
        self.test = test
        self.publishers = {}  # by topic
        self.lock = threading.Lock()  # of publishers
        self.advertise(f'{test.namespace}/perceptions')
        self.status = rospy.Subscriber(f'{test.namespace}/learner_status', LearnerStatus, self.note_status)
        test.addCleanup(self.status.unregister)
        self.actions = test.listen('actions', RelativeActions)
        support.wait_for(lambda: self.connections() >= learners, f'{learners} learners to connect')
        # An answer at the moment of the connection would come twice, because it is latched.
        self.actions.wait_connected(learners)

    def advertise(self, topic):
        """Publishes perceptions on one more topic."""
        with self.lock:
            if topic not in self.publishers:
                publisher = rospy.Publisher(topic, Perceptions, queue_size=100, tcp_nodelay=True)
                self.publishers[topic] = publisher
                self.test.addCleanup(publisher.unregister)

    def note_status(self, status):
        """Publishes all perceptions on the topic of a learner, too: the learner has to select those of its agents."""
        if status.perceptions_topic:
            self.advertise(status.perceptions_topic)

    def close(self):
        """Stops publishing."""
        self.status.unregister()
        for publisher in self.publishers.values():
            publisher.unregister()

    def connections(self):
        """Returns the number of subscribers of all topics."""
        with self.lock:
            return sum(publisher.get_num_connections() for publisher in self.publishers.values())

    def tell(self, message):
        """Publishes perceptions."""
        with self.lock:
            for publisher in self.publishers.values():
                publisher.publish(message)

    def ask(self, message):
        """Publishes perceptions. Returns the answer: {agent: (rotation, fraction of the maximum speed)}."""
        self.tell(message)
        return answers_of(self.actions.wait_at(message.episode, message.tick))


def answers_of(message):
    """Returns an answer as {agent: (rotation, fraction of the maximum speed)}."""
    return {action.agent: (action.rotation, action.speed_fraction) for action in message.agents}
