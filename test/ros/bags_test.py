#!/usr/bin/python3
"""An episode in a rosbag."""
import rosbag
import support
from broadcasting import TOPICS, BroadcastTestCase
from recording import RecordingTestCase
from roslib.packages import find_node

PUBLISHERS = {topic: 'learner' if topic in ('actions', 'learner_status') else 'crowd_controller' for topic in TOPICS}


class BagTest(BroadcastTestCase, RecordingTestCase):
    """An episode in a rosbag."""

    def record(self):
        """Starts rosbag record and waits until it has subscribed to all topics."""
        command = find_node('rosbag', 'record')[:1] + ['--output-name', self.path('crowd.bag'), '__name:=recorder']
        recorder = self.start('recorder', command + [f'{self.namespace}/{topic}' for topic in TOPICS])
        support.wait_for(lambda: all(self.is_heard(node, f'{self.namespace}/{topic}')
                                     for topic, node in PUBLISHERS.items()), 'rosbag to listen to all topics')
        return recorder

    def has_all(self, topic):
        """Returns whether the recorder has received all messages on a topic that were sent to it."""
        name = f'{self.namespace}/{topic}'
        return 0 < self.sent(PUBLISHERS[topic], name) <= self.received(name)

    def recorded(self):
        """Returns the messages of episode 0 in the bag, by topic and tick."""
        recorded = {name: {} for name in TOPICS}
        with rosbag.Bag(self.path('crowd.bag')) as bag:
            for topic, message, _ in bag.read_messages():
                if message.episode == 0:
                    recorded[topic.split('/')[-1]][message.tick] = message
        return recorded

    def test_bag_contains_the_episode(self):
        self.start_all()
        recorder = self.record()
        self.walk_an_episode()
        self.step(5)  # of the next episode, so that all messages of this one are received
        support.wait_for(lambda: all(map(self.has_all, TOPICS)), 'the messages to reach the recorder')
        self.assertEqual(recorder.stop(), 0)
        recorded = self.recorded()
        for name, ear in self.ears.items():
            expected = {message.tick: message for message in ear.messages
                        if message.episode == 0 and not is_start_of(name, message)}
            ticks = [tick for tick, message in recorded[name].items() if not is_start_of(name, message)]
            self.assertEqual(sorted(ticks), sorted(expected), name)
            for tick, message in expected.items():
                self.assertEqual(str(recorded[name][tick]), str(message), f'{name} {tick}')


def is_start_of(topic, message):
    """Returns whether a message is the state at the start, which may be published before the recorder connects."""
    return topic == 'agents' and (message.episode, message.tick) == (0, 0)


if __name__ == '__main__':
    support.run('bags_test')
