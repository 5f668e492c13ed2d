"""The experiments, in the thesis's order. Each module has NAME, TITLE, plan(setting) and report(setting)."""
from . import ambiguity, reward_evaluation

ALL = (reward_evaluation, ambiguity)
