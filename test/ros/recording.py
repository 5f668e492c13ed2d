"""Base of the tests of rosbags."""
import xmlrpc.client

import rosgraph
import support


class RecordingTestCase(support.CrowdTestCase):
    """Knows which topics a recorder hears."""

    def node(self, name):
        """Returns the XML-RPC interface of a node."""
        return xmlrpc.client.ServerProxy(rosgraph.Master('/social_crowd_test').lookupNode(f'{self.namespace}/{name}'))

    def is_heard(self, node, topic):
        """Returns whether the recorder is connected to a node's topic."""
        connections = self.node(node).getBusInfo('/social_crowd_test')[2]
        return any('recorder' in str(connection[1]) and connection[2] == 'o' and connection[4] == topic
                   for connection in connections)

    def sent(self, node, topic):
        """Returns the number of messages on a topic that a node has sent to the recorder."""
        links = [link[0] for link in self.node(node).getBusInfo('/social_crowd_test')[2] if 'recorder' in str(link[1])]
        published, _ = self.node(node).getBusStats('/social_crowd_test')  # roscpp has no status before
        return sum(link[3] for name, counts in published if name == topic for link in counts if link[0] in links)

    def received(self, topic):
        """Returns the number of messages on a topic that the recorder has received."""
        _, subscribed = self.node('recorder').getBusStats('/social_crowd_test')
        return sum(link[2] for name, links in subscribed if name == topic for link in links)
