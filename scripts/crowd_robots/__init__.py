"""Robots that other nodes drive: starting them, recording their results."""
