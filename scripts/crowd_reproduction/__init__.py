"""Repeats the experiments of the thesis: runs the tools, keeps their results, draws figures and writes a page."""
