"""Nodes that run other programs, and that end the launch when the program ends."""
