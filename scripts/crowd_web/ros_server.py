"""What the server offers with ROS."""
import rospy
from crowd_web.foxglove import PROTOCOL, FoxgloveSession
from crowd_web.ros_graph import RosGraph
from crowd_web.ros_source import RosSource
from crowd_web.rosbridge import RosbridgeSession


async def add_ros(server, recordings):
    """Begins a node, and adds the protocols that need ROS. Returns the source of the page and what is to be run."""
    rospy.init_node('web_server', disable_signals=True)
    graph = RosGraph()
    server.add('/', lambda client: FoxgloveSession(client, graph), PROTOCOL)
    server.add('/rosbridge', lambda client: RosbridgeSession(client, graph))
    return RosSource(graph, recordings), graph.run_forever()
