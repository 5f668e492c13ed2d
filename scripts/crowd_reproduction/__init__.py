"""Repeats the experiments of the thesis."""
