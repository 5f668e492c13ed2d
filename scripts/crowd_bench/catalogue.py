"""The benchmarks, with their units and required values (bars)."""
import dataclasses
import pathlib

import yaml

DECISIONS, AGENT_STEPS, TICKS, REAL_TIME, MILLISECONDS, MEGABYTES, SHARE_OF_CORE = (
    'decisions/s', 'agent steps/s', 'ticks/s', 'x real time', 'ms', 'MB', '% of a core')
FILE = pathlib.Path(__file__).with_name('benchmarks.yaml')
# Units of which lower values are better; all other units are rates.
COSTS = (MILLISECONDS, MEGABYTES, SHARE_OF_CORE)


@dataclasses.dataclass(frozen=True)
class Benchmark:
    """One line of the table.

    The ratio is the benchmark's time divided by the yardstick's time (rates: yardstick / value, times: value /
    yardstick). With `ratio_is_rate` it is the benchmark's rate divided by the yardstick's rate (value / yardstick)."""
    name: str
    title: str
    unit: str
    bar: float = None
    yardstick: str = ''  # in words; empty: none
    ratio_bar: float = None
    ratio_is_rate: bool = False
    ros: bool = False  # measured through ROS
    mpi: bool = False  # measured under mpirun
    repetitions: int = None  # None: as requested on the command line

    def ratio(self, value, yardstick):
        """Returns the ratio of the benchmark and its yardstick."""
        return value / yardstick if self.ratio_is_rate or self.unit in COSTS else yardstick / value

    def result(self, value, yardstick=None, ratio=None, spread=None):
        """Returns the result as a dictionary.
        @param spread lowest and highest of the repetitions, of which the value is the median"""
        return {'name': self.name, 'value': value, 'unit': self.unit, 'spread': spread, 'yardstick': yardstick,
                'ratio': ratio}

    def clears_bar(self, result):
        """Returns whether value and ratio meet the bars."""
        value, ratio = result['value'], result['ratio']
        fine = self.bar is None or (value <= self.bar if self.unit in COSTS else value >= self.bar)
        if self.ratio_bar is None:
            return fine
        return fine and ratio is not None and (
            ratio >= self.ratio_bar if self.ratio_is_rate else ratio <= self.ratio_bar)


BENCHMARKS = tuple(Benchmark(**entry) for entry in yaml.safe_load(FILE.read_text(encoding='utf-8')))
