"""Where everything is, and how much of it is to be done."""
import dataclasses
import pathlib


@dataclasses.dataclass(frozen=True)
class Setting:
    """What all experiments share."""
    tools: pathlib.Path  # folder of train and evaluate
    config: pathlib.Path  # the package's config/
    results: pathlib.Path
    quick: bool = False  # tiny numbers, to see whether everything works

    def count(self, full, quick):
        """How many seeds, episodes and so on."""
        return quick if self.quick else full

    def seeds(self, full, quick=2):
        """Seeds 1, 2, ..."""
        return range(1, self.count(full, quick) + 1)

    def tool(self, name):
        """The program `train` or `evaluate`."""
        return self.tools / name

    def config_file(self, name):
        """A training configuration of the experiments."""
        return self.config / 'experiments' / f'{name}.yaml'

    def scenario(self, name):
        """A scenario file."""
        return self.config / 'scenarios' / f'{name}.yaml'

    def run_folder(self, experiment, run):
        """Where a run leaves its files."""
        return self.results / 'runs' / experiment / run

    def figure_file(self, name):
        """Where a figure is drawn."""
        return self.results / 'figures' / f'{name}.png'
