"""Ports for ROS masters."""
import socket


def free_port():
    """Returns a TCP port of this machine that is free at present."""
    with socket.socket() as probe:
        probe.bind(('127.0.0.1', 0))
        return probe.getsockname()[1]
