"""The experiments, in the thesis's order. Each module has NAME, TITLE, plan(setting) and report(setting)."""
from . import ambiguity, future_work, learning_curves, reward_evaluation, scenarios, sharing

ALL = (reward_evaluation, ambiguity, scenarios, sharing, learning_curves, future_work)
