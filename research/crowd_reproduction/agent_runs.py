"""Runs of the agents that learn alone. Each agent is trained once; several chapters use its table."""
from crowd_experiments.runs import Run

from . import agent_training, checkpoints, scenario_runs, twins_runs

SEEDS = 10


def plan(setting):
    """Returns a run for each state set, set of parameters and seed."""
    return [make_run(setting, states, parameters, seed) for seed in setting.seeds(SEEDS)
            for states in agent_training.SETS for parameters in agent_training.PARAMETERS]


def make_run(setting, states, parameters, seed):
    """Returns a run that trains in both parts, saves checkpoints, and runs the scenarios and the twins tests."""
    single, field = agent_training.learn(setting, states, parameters, seed)
    return Run(agent_training.folder_of(setting, states, parameters, seed), [
        single, field + checkpoints.saving(setting), *scenario_runs.agent_walks(setting, states, seed),
        *twins_runs.agent_walks(setting, seed), *checkpoints.walks(setting, seed)], cost=3.5)
