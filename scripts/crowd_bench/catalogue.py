"""The benchmarks, with their units and required values (bars)."""
import dataclasses

DECISIONS, AGENT_STEPS, TICKS, REAL_TIME, MILLISECONDS, MEGABYTES, SHARE_OF_CORE = (
    'decisions/s', 'agent steps/s', 'ticks/s', 'x real time', 'ms', 'MB', '% of a core')
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
    bar: float
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


BENCHMARKS = (
    Benchmark('train_occupancy', 'training, thesis set 2, one obstacle, one thread', DECISIONS, 8e6,
              'the same loop without learning'),
    Benchmark('train_anticipation', 'training, anticipation set, random crowds of 12, one thread', DECISIONS, 2e6),
    Benchmark('crowd_step_10000', 'crowd step, anticipation set, demo, 10,000 agents, 0.5 per m², 6 m, 16 neighbours, '
              'one thread', AGENT_STEPS, 2e6, 'finding the 16 nearest neighbours alone'),
    Benchmark('crowd_step_10000_two_threads', 'the same, two threads', AGENT_STEPS, None, 'one thread', ratio_bar=1.8,
              ratio_is_rate=True),
    Benchmark('crowd_step_mpi_2', 'the same, 100,000 agents, two ranks of one thread (MPI)', AGENT_STEPS, None,
              'one process with two threads', ratio_bar=0.8, ratio_is_rate=True, mpi=True),
    Benchmark('crowd_step_mpi_2_parts', 'the same', AGENT_STEPS, None, 'two separate crowds of half the agents',
              ratio_bar=0.85, ratio_is_rate=True, mpi=True),
    Benchmark('train_mpi_2', 'training, anticipation set, random crowds of 12, 16 learners side by side, two ranks of '
              'one thread (MPI)', DECISIONS, None, 'one process with two threads', ratio_bar=0.8, ratio_is_rate=True,
              mpi=True),
    Benchmark('ros_lockstep_1000', 'ROS lockstep, 1,000 agents, one learner node', TICKS, 250,
              'a bare round trip of such messages, plus the headless step', ratio_bar=1.6, ros=True),
    Benchmark('ros_lockstep_12', 'ROS lockstep, 12 agents, one learner node', TICKS, 6000, 'the same', ratio_bar=1.6,
              ros=True),
    Benchmark('nodelets_1000', 'nodelets, 1,000 agents', TICKS, 800, 'the headless step', ratio_bar=0.5,
              ratio_is_rate=True, ros=True),
    Benchmark('real_time_1000', 'real time 10 Hz, 1,000 agents, markers and tf on, all nodes together', SHARE_OF_CORE,
              40, ros=True),
    Benchmark('q_table_load', 'loading a Q-table of 52,489 rows, all visited', MILLISECONDS, 50,
              'reading as many bytes'),
    Benchmark('q_table_save', 'saving it', MILLISECONDS, 100, 'writing as many bytes and flushing them to the disk'),
    Benchmark('crowd_step_map_1000', 'crowd step with way-finding, 1,000 agents on a map of an office of 50 m x 40 m, '
              'one thread', AGENT_STEPS, None, 'the same crowd without walls', ratio_bar=1.5),
    Benchmark('way_to_goal', 'way to a new goal on this map', MILLISECONDS, 2),
    Benchmark('way_preparation', 'preparing this map for that: meshes, narrow passages', MILLISECONDS, 1000),
    Benchmark('way_memory', 'memory of that, and of the searches', MEGABYTES, 50, repetitions=1),
    Benchmark('scan_720_1000', 'scan of 720 rays among 1,000 people on this map, one thread', MILLISECONDS, 1),
    Benchmark('robots_10', '10 reactive robots with scans of 720 rays at 10 Hz among 200 people, one thread', REAL_TIME,
              5),
    Benchmark('memory_100000', 'most memory of a walking crowd of 100,000 agents', MEGABYTES, 200, repetitions=1),
)
