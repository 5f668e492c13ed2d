"""The parts of the comparison. Each module has NAME, TITLE, plan(setting) and report(setting)."""
from . import ablations, benchmark, crowds, lanes, movers

ALL = (benchmark, crowds, movers, lanes, ablations)
