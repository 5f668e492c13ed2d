"""Sweeps: training and evaluation over a grid of parameters and seeds."""
