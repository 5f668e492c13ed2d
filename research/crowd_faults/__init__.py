"""Faults in a running ROS graph: nodes that die, hang or are started twice, no master, messages that are lost."""
import importlib.util

from crowd_drawing.errors import RunError

if importlib.util.find_spec('social_crowd') is None:
    raise RunError('the package is not in the ROS environment: source .build/devel/setup.bash')
