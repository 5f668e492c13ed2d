#!/usr/bin/python3
"""Writes what a crowd controller says, as lines of JSON: a program for hosts that the test itself does not reach.

usage: crowd_recorder.py FILE
"""
import json
import sys

import rospy
from social_crowd.msg import AgentStates, ControllerStatus, EpisodeResult


class Recorder:
    """Writes a line for each message."""

    def __init__(self, stream):
        self.stream = stream
        for topic, message_type, write in (('agents', AgentStates, self.write_agents),
                                           ('controller_status', ControllerStatus, self.write_status),
                                           ('episode_results', EpisodeResult, self.write_result)):
            rospy.Subscriber(topic, message_type, write, queue_size=1000, tcp_nodelay=True)

    def write(self, topic, **values):
        """Writes a line."""
        self.stream.write(json.dumps({'topic': topic, **values}) + '\n')
        self.stream.flush()

    def write_agents(self, message):
        """Writes which agents did not move in the last tick."""
        rest = [agent.agent for agent in message.agents if agent.velocity.x == 0.0 and agent.velocity.y == 0.0]
        touched = sum(agent.touched for agent in message.agents)
        self.write('agents', episode=message.episode, tick=message.tick, rest=rest, touched=touched)

    def write_status(self, message):
        """Writes the counts."""
        self.write('status', episode=message.episode, tick=message.tick, paused=message.paused, walking=message.walking,
                   decisions=message.decisions, missed=message.missed_answers, dropped=message.dropped_answers)

    def write_result(self, message):
        """Writes the metrics."""
        self.write('result', episode=message.episode, tick=message.tick, contact=message.contact_percent,
                   missed=message.missed_answers, dropped=message.dropped_answers)


def main():
    """Records until the node is shut down."""
    rospy.init_node('crowd_recorder')
    with open(sys.argv[1], 'w', encoding='utf-8') as stream:
        Recorder(stream)
        rospy.spin()


if __name__ == '__main__':
    main()
