"""Where everything of the comparison is."""
import dataclasses
import pathlib
import typing

from crowd_experiments.setting import Setting


@dataclasses.dataclass(frozen=True)
class ComparisonSetting(Setting):
    """With the steering benchmark's folder, if there is one."""
    benchmark: typing.Optional[pathlib.Path] = None

    def learning(self, model):
        """A shipped training configuration."""
        return self.config / 'learning' / f'{model}.yaml'

    def table(self, model):
        """A shipped Q-table."""
        return self.config / 'q_tables' / f'{model}.txt'

    def benchmark_scenarios(self):
        """The benchmark's scenario files."""
        return sorted((self.benchmark / 'scenarios').glob('*.yaml'))
