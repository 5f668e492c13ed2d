"""Folders and files of the comparison."""
import dataclasses
import pathlib
import typing

from crowd_experiments.setting import Setting


@dataclasses.dataclass(frozen=True)
class ComparisonSetting(Setting):
    """A Setting with an optional folder of the steering benchmark."""
    benchmark: typing.Optional[pathlib.Path] = None

    def learning(self, model):
        """Returns a shipped training configuration."""
        return self.config / 'learning' / f'{model}.yaml'

    def table(self, model):
        """Returns a shipped Q-table."""
        return self.config / 'q_tables' / f'{model}.txt'

    def benchmark_scenarios(self):
        """Returns the scenario files of the benchmark."""
        return sorted((self.benchmark / 'scenarios').glob('*.yaml'))
