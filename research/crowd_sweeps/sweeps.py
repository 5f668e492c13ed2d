"""Sweeps: cost against one variable, tables and pictures; weak scaling on several ranks is measured for few and
modelled for more."""
import math
import shutil
import typing

from crowd_bench import program
from crowd_bench.core_benchmarks import RANKS_PROGRAM, measure
from crowd_bench.table import AGENT_STEPS, DECISIONS
from crowd_experiments import style
from crowd_experiments.runs import RunError

RANKS = (1, 2, 3, 4)
AGENTS = 50_000  # on each rank
MODELLED_RANKS = (1, 2, 4, 8, 16, 32, 64)
MODELLED_AGENTS = (50_000, 500_000)
DENSITY = 0.5  # [agents per m²]
REACH = 9.5  # of the copies beyond a border, for vision of 6 m and agents of 1.6 m/s [m]; docs/mpi.md
BANDWIDTH = 1e9  # of a network [bytes/s]
ACTION = 16  # [bytes] of a copy in each tick
COLOUR = '#1f77b4'
COPY = 26  # [bytes] of a copy in each tick: 260 in every tenth


def copies(ranks, agents):
    """Returns the number of copies on a rank in the middle of a square floor."""
    borders = min(ranks - 1, 2)
    side = math.sqrt(ranks * agents / DENSITY)
    return borders * DENSITY * REACH * side


class Model(typing.NamedTuple):
    """Time of a tick: agents * per_agent + copies * per_copy + bytes / bandwidth."""
    per_agent: float  # [ms]
    per_copy: float  # [ms]

    @staticmethod
    def of(measured):
        """Fits the model to (ranks, computing time [ms]): all time beyond that of one rank is attributed to copies."""
        alone = dict(measured)[1]
        pairs = [(copies(ranks, AGENTS), value - alone) for ranks, value in measured if ranks > 1]
        slope = sum(count * more for count, more in pairs) / sum(count ** 2 for count, _ in pairs)
        return Model(alone / AGENTS, max(0.0, slope))

    def tick(self, ranks, agents):
        """Returns the time of a tick [ms]."""
        count = copies(ranks, agents)
        return agents * self.per_agent + count * self.per_copy + 1e3 * count * (ACTION + COPY) / BANDWIDTH

    def efficiency(self, ranks, agents):
        return self.tick(1, agents) / self.tick(ranks, agents)


class WeakScaling(typing.NamedTuple):
    """Sweep over the number of ranks."""
    name: str
    title: str

    def measure(self, measuring):
        """Returns header and rows of the table, and the picture, of equally many agents on each rank."""
        if shutil.which('mpirun') is None:
            raise RunError('there is no mpirun')
        runs = {ranks: measure(measuring.folder / RANKS_PROGRAM, ranks, ranks * AGENTS, 1)[0] for ranks in RANKS}
        times = {ranks: run['computing_ms'] for ranks, run in runs.items()}
        efficiencies = {ranks: times[1] / time for ranks, time in times.items()}
        model = Model.of(times.items())
        header = ['ranks', 'computing, slowest rank [ms per tick]', 'sent by all ranks [MB per tick]', 'efficiency',
                  *(f'modelled, {agents:,} agents each' for agents in MODELLED_AGENTS)]
        rows = []
        for ranks in sorted({*runs, *MODELLED_RANKS}):
            cells = [f'{times[ranks]:.1f}', f"{runs[ranks]['megabytes']:.2f}", f'{efficiencies[ranks]:.2f}'] \
                if ranks in runs else ['', '', '']
            rows.append([str(ranks), *cells,
                         *(f'{model.efficiency(ranks, agents):.2f}' for agents in MODELLED_AGENTS)])
        return header, rows, self.draw(efficiencies, model, measuring.plots / f'{self.name}.png')

    def draw(self, efficiencies, model, file):
        figure, ((panel,),) = style.new_figure(1, 1, 5.2, 3.4)
        for agents, line in zip(MODELLED_AGENTS, ('-', '--')):
            panel.plot(MODELLED_RANKS, [model.efficiency(ranks, agents) for ranks in MODELLED_RANKS], linestyle=line,
                       color=style.REFERENCE, label=f'modelled, {agents:,} agents on each rank')
        panel.plot(*zip(*efficiencies.items()), marker='o', linestyle='', color=COLOUR,
                   label=f'measured, {AGENTS:,} agents on each rank')
        panel.set_xscale('log', base=2)
        panel.set_xticks(MODELLED_RANKS, [str(ranks) for ranks in MODELLED_RANKS])
        panel.set(ylim=(0, 1.1), title=self.title, xlabel='ranks', ylabel='efficiency')
        panel.legend(loc='lower left', fontsize='small')
        return style.save(figure, file)


RANK_SWEEPS = (WeakScaling('crowd_ranks_weak', 'One crowd on several ranks, square floor'),)


class Sweep(typing.NamedTuple):
    """Benchmarks NAME/POINT of the core."""
    name: str
    title: str
    label: str  # of the axis of its points
    unit: str
    scale: float = 1.0  # from the points of the benchmarks to those of the axis
    logarithmic: bool = False
    threads: bool = False  # shown as the speedup over one thread

    def measure(self, measuring):
        """Returns header and rows of the table, and the picture."""
        measured = measuring.core.sweep(self.name, self.unit)
        return (*self.table(measured), self.draw(measured, measuring.plots / f'{self.name}.png'))

    def points(self, measured):
        """Returns points of the axis with the drawn values: microseconds per agent step, or the speedup."""
        if self.threads:
            return [(point, value / measured[0][1]) for point, value in measured]
        return [(point * self.scale, 1e6 / value) for point, value in measured]

    @property
    def value_label(self):
        return 'speedup' if self.threads else 'µs per agent step'

    def table(self, measured):
        """Returns header and rows; costs are also given relative to their minimum."""
        points = self.points(measured)
        header = [self.label, 'M ' + self.unit, self.value_label]
        rows = [[f'{point:,g}', f'{value / 1e6:.3f}', f'{drawn:.2f}']
                for (point, drawn), (_, value) in zip(points, measured)]
        if self.threads:
            return header, rows
        least = min(drawn for _, drawn in points)
        header.append('relative to minimum')
        return header, [[*row, f'{drawn / least:.2f}'] for row, (_, drawn) in zip(rows, points)]

    def draw(self, measured, file):
        figure, ((panel,),) = style.new_figure(1, 1, 4.6, 3.2)
        points = self.points(measured)
        panel.plot(*zip(*points), marker='o', color=COLOUR)
        if self.threads:
            panel.plot([1, points[-1][0]], [1, points[-1][0]], color=style.REFERENCE, linestyle='--', linewidth=1)
            panel.set_xticks([point for point, _ in points])
        if self.logarithmic:
            panel.set_xscale('log')
        panel.set(ylim=(0, 1.15 * max(value for _, value in points)), title=self.title, xlabel=self.label,
                  ylabel=self.value_label)
        return style.save(figure, file)


SWEEPS = (
    Sweep('crowd_step_agents', 'Crowd step by agents, 0.5 per m²', 'agents', AGENT_STEPS, logarithmic=True),
    Sweep('crowd_step_density', 'Crowd step by density, 10,000 agents', 'agents per m²', AGENT_STEPS, scale=0.01),
    Sweep('crowd_step_vision', 'Crowd step by radius of vision, 10,000 agents', 'radius of vision [m]', AGENT_STEPS),
    Sweep('crowd_step_threads', 'Crowd step by threads, 10,000 agents', 'threads', AGENT_STEPS, threads=True),
    Sweep('crowds_side_by_side', 'Crowds side by side, each on its own', 'threads, each with a crowd', AGENT_STEPS,
          threads=True),
    Sweep('train_threads', 'Training by threads, 16 learners side by side', 'threads', DECISIONS, threads=True),
)


def main(words=None):
    return program.main(words, {'sweeps': (*SWEEPS, *RANK_SWEEPS)}, 'research/bench_sweeps crowd_step_agents')
