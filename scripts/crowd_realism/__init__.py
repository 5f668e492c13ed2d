"""Recorded people replaced by simulated ones, for the program `realism`."""
