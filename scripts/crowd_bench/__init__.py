"""Measures what crowds cost: runs the benchmarks, draws sweeps, counts instructions."""
