"""Reproduces the experiments of the thesis."""
