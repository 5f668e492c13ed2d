"""The agents that learn alone, each trained once, and all that their tables walk for several chapters."""
from crowd_experiments.runs import Run

from . import agent_training, checkpoints, scenario_runs, twins_runs

SEEDS = 10


def plan(setting):
    """A run for each state set, set of parameters and seed."""
    return [make_run(setting, states, parameters, seed) for seed in setting.seeds(SEEDS)
            for states in agent_training.SETS for parameters in agent_training.PARAMETERS]


def make_run(setting, states, parameters, seed):
    """Trains in both parts, keeps a record of learning, walks the scenarios and the twins tests."""
    single, field = agent_training.learn(setting, states, parameters, seed)
    return Run(agent_training.folder_of(setting, states, parameters, seed), [
        single, field + checkpoints.saving(setting), *scenario_runs.agent_walks(setting, states, seed),
        *twins_runs.agent_walks(setting, seed), *checkpoints.walks(setting, seed)], cost=3.5)
