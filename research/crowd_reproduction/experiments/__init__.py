"""The experiments, in the order of the thesis. Each module has NAME, TITLE, plan(setting) and report(setting)."""
from . import ambiguity, future_work, learning_curves, reward_evaluation, scenarios, sensitivity, sharing
from .. import claims

ALL = (reward_evaluation, sensitivity, ambiguity, scenarios, sharing, learning_curves, future_work, claims)
