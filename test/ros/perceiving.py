"""Perceptions for tests of learners without a crowd controller."""
import math

import rospy
import support
from social_crowd.msg import AgentPerception, Neighbour, Perceptions, RelativeActions

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
    """Replaces the crowd controller: publishes perceptions and receives the answers of learners."""

    def __init__(self, test, learners=1):
        self.actions = test.listen('actions', RelativeActions)
        self.publisher = rospy.Publisher(f'{test.namespace}/perceptions', Perceptions, queue_size=100, tcp_nodelay=True)
        test.addCleanup(self.publisher.unregister)
        support.wait_for(lambda: self.publisher.get_num_connections() >= learners and
                         self.actions.subscriber.get_num_connections() >= learners, f'{learners} learners to connect')

    def tell(self, message):
        """Publishes perceptions."""
        self.publisher.publish(message)

    def ask(self, message):
        """Publishes perceptions. Returns the answer: {agent: (rotation, fraction of the maximum speed)}."""
        self.tell(message)
        return answers_of(self.actions.wait_at(message.episode, message.tick))


def answers_of(message):
    """Returns an answer as {agent: (rotation, fraction of the maximum speed)}."""
    return {action.agent: (action.rotation, action.speed_fraction) for action in message.agents}
