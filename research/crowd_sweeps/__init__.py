"""Sweeps of the benchmarks: cost against one variable, measured and modelled."""
