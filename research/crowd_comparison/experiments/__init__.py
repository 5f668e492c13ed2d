"""The experiments of the comparison. Each module has NAME, TITLE, plan(setting) and report(setting)."""
from . import ablations, benchmark, crowds, lanes, moving_obstacles

ALL = (benchmark, crowds, moving_obstacles, lanes, ablations)
