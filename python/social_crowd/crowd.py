"""A crowd that walks tick by tick, evaluations and trainings, without ROS."""
import dataclasses
import os
import tempfile

from social_crowd import _core
from social_crowd.checks import whole_number
from social_crowd.inputs import as_scenario, as_table, dump


class Crowd(_core.Crowd):
    """One episode of a scenario, tick by tick.

    `positions`, `headings`, `velocities`, `goals`, `radii`, `max_speeds`, `ids`, `statuses` and `in_contact` are
    read-only NumPy arrays without copies: step() updates them in place. When agents appear or leave, there are new
    ones, and the old arrays stay as they are; so get them anew after step() where a scenario has sources or sinks.
    """

    def __init__(self, scenario, table='anticipation', *, seed=1, episode=0, threads=1):
        """Begins an episode.

        scenario: see as_scenario(); table: a QTable, the name of one of the package, or a file
        seed, episode: what is drawn; the same as those of `evaluate`, bit for bit
        threads: that share the agents, for large crowds; 0: one for each processor. Results do not depend on it
        """
        super().__init__(as_scenario(scenario), as_table(table), whole_number('seed', seed),
                         whole_number('episode', episode), whole_number('threads', threads))


@dataclasses.dataclass
class Evaluation:
    """Results of evaluate(): `means` by name, as the program `evaluate` prints them, and a dict for each episode.

    The dict of an episode has the counts of its agents, and in `robots` one dict for each robot, with the metrics of
    docs/metrics.md by name.
    """

    means: dict
    episodes: list


def evaluate(table, scenario, *, episodes=0, seed=1, threads=0, robot='none'):
    """Runs episodes in which all agents decide greedily. Returns an Evaluation. Ctrl-C ends it.

    episodes: 0: each document of the scenario once; threads: 0: one for each processor
    robot: controller of all robots: none (they stand), straight, reactive, learned, orca, social_force (docs/robots.md)
    """
    return Evaluation(*_core.evaluate(as_table(table), as_scenario(scenario), whole_number('episodes', episodes),
                                      whole_number('seed', seed), whole_number('threads', threads), robot))


def train(config, *, episodes=None, seed=None, begin=None, threads=0, on_turn=None):
    """Learns a Q-table as the program `train` does. Returns the QTable.

    config: a training configuration (docs/learning.md): a file, or a dict with its keys, whose scenarios are names or
    absolute paths
    episodes, seed: instead of those of the configuration; begin: a table to go on from
    on_turn: called after each turn with the Training and a list of the episodes of the turn (dicts); False ends it
    """
    training = _begin_training(config, episodes, seed, None if begin is None else as_table(begin), threads)
    while not training.is_done:
        results = training.run_next_turn()
        if on_turn is not None and on_turn(training, results) is False:
            break
    return training.table()


def _begin_training(config, *options):
    if not isinstance(config, dict):
        return _core.Training(os.fspath(config), *options)
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, 'config.yaml')
        with open(file, 'w', encoding='utf-8') as stream:
            stream.write(dump(config))
        return _core.Training(file, *options)
