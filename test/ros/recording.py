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
