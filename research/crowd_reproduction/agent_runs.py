"""Runs of the agents that learn alone. Each agent is trained once; several chapters use its table."""
from crowd_experiments.runs import Run

from . import agent_training as training, scenario_runs, twins_runs


def plan(setting):
    """Returns a run for each state set, set of parameters and seed."""
    return [make_run(setting, states, parameters, seed) for seed in setting.seeds(training.SEEDS)
            for states in training.SETS for parameters in training.PARAMETERS]


def make_run(setting, states, parameters, seed):
    """Returns a run that trains in both parts, saves checkpoints, and runs the scenarios and the twins tests."""
    single, field = training.learn(setting, seed, *training.configs(setting, states, parameters))
    return Run(training.folder_of(setting, states, parameters, seed), [
        single, field + ['--save-every', training.save_every(setting)],
        *scenario_runs.agent_walks(setting, states, seed), *twins_runs.agent_walks(setting, seed),
        *training.checkpoint_walks(setting, seed)], cost=3.5)
