"""Faults in a running ROS graph: nodes that die, hang or come twice, a master that ends, messages that are lost."""
