"""Folders and numbers that all experiments share."""
import dataclasses
import pathlib
import typing

from .tools import REPOSITORY


@dataclasses.dataclass(frozen=True)
class Setting:
    """Folders and numbers that all experiments share."""
    tools: pathlib.Path  # folder of train and evaluate
    config: pathlib.Path  # the package's config/
    results: pathlib.Path
    quick: bool = False  # minimal numbers, to test the programs
    experiments: pathlib.Path = REPOSITORY / 'research' / 'experiments'  # training configurations
    benchmark: typing.Optional[pathlib.Path] = None  # folder of the steering benchmark

    def count(self, full, quick):
        """Returns the number of seeds, episodes etc."""
        return quick if self.quick else full

    def seeds(self, full, quick=2):
        """Returns the seeds 1, 2, ..."""
        return range(1, self.count(full, quick) + 1)

    def tool(self, name):
        """Returns the program `train` or `evaluate`."""
        return self.tools / name

    def config_file(self, name):
        """Returns a training configuration of the experiments."""
        return self.experiments / f'{name}.yaml'

    def scenario(self, name):
        """Returns a scenario file."""
        return self.config / 'scenarios' / f'{name}.yaml'

    def learning(self, model):
        """Returns a shipped training configuration."""
        return self.config / 'learning' / f'{model}.yaml'

    def table(self, model):
        """Returns a shipped Q-table."""
        return self.config / 'q_tables' / f'{model}.txt'

    def run_folder(self, experiment, run):
        """Returns the folder of a run."""
        return self.results / 'runs' / experiment / run

    def figure_file(self, name):
        """Returns the file of a figure."""
        return self.results / 'figures' / f'{name}.png'
