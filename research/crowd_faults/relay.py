"""A node between crowd controller and learner that delays, repeats, reorders or loses messages."""
import random
import threading
import time

import rospy
from social_crowd.msg import Perceptions, RelativeActions

CHANCE = 0.2  # that a message has a fault
LONGEST = 0.4  # [s] delay: longer than the controller waits for an answer
REMAPPINGS = ['perceptions:=relayed/perceptions', 'actions:=relayed/actions']  # of the learner behind it
FAULTS = ('delayed', 'repeated', 'reordered', 'lost')


def unread(kind):
    """Returns a type of message that is passed on as it came, without being read."""
    class Unread(kind):
        def deserialize(self, buff):
            self.bytes = bytes(buff)
            return self

        def serialize(self, buff):
            buff.write(self.bytes)

    return Unread


class Direction:
    """Passes the messages of a topic on."""

    def __init__(self, source, target, kind, fault, seed):
        self.fault, self.draw, self.sent_at = fault, random.Random(seed), 0.0
        self.lock = threading.Lock()
        self.timers = []
        self.publisher = rospy.Publisher(target, unread(kind), queue_size=1000, tcp_nodelay=True)
        self.subscriber = rospy.Subscriber(source, unread(kind), self.take, tcp_nodelay=True)

    def take(self, message):
        with self.lock:
            for delay in self.delays():
                if delay > 0.0:
                    self.later(delay, message)
                else:
                    self.publisher.publish(message)

    def delays(self):
        """Returns after which times a message is passed on [s]."""
        is_faulty = self.draw.random() < CHANCE
        delay = self.draw.uniform(0.0, LONGEST) if is_faulty else 0.0
        if self.fault == 'delayed':  # in order
            now = time.monotonic()
            self.sent_at = max(self.sent_at, now + delay)
            return [self.sent_at - now]
        if self.fault is None or not is_faulty:
            return [0.0]
        return {'lost': [], 'repeated': [0.0, delay], 'reordered': [delay]}[self.fault]

    def later(self, delay, message):
        self.timers.append(threading.Timer(delay, self.publisher.publish, [message]))
        self.timers[-1].start()

    def close(self):
        self.subscriber.unregister()
        for timer in self.timers:
            timer.join()
        self.publisher.unregister()


class Relay:
    """Context manager that passes perceptions and answers on, with a kind of fault."""

    def __init__(self, fault, seed):
        self.directions = [Direction('perceptions', 'relayed/perceptions', Perceptions, fault, seed),
                           Direction('relayed/actions', 'actions', RelativeActions, fault, seed + 1)]

    def heal(self):
        for direction in self.directions:
            direction.fault = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for direction in self.directions:
            direction.close()
