"""Measures performance: runs benchmarks, draws sweeps, counts instructions."""
