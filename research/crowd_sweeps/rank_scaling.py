"""Weak scaling of a crowd on several ranks: equally many agents on each, measured for few ranks, modelled for more."""
import dataclasses
import math
import shutil

from crowd_bench.rank_benchmarks import PROGRAM, measure
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
COPY = 26  # [bytes] of a copy in each tick: 260 in every tenth


def copies(ranks, agents):
    """Returns the number of copies on a rank in the middle of a square floor."""
    borders = min(ranks - 1, 2)
    side = math.sqrt(ranks * agents / DENSITY)
    return borders * DENSITY * REACH * side


@dataclasses.dataclass(frozen=True)
class Model:
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


@dataclasses.dataclass(frozen=True)
class WeakScaling:
    """Sweep over the number of ranks. Its points are (ranks, run of rank_benchmarks)."""
    name: str
    title: str

    def measure(self, measuring):
        """Returns header and rows of the table, and the picture, of equally many agents on each rank."""
        if shutil.which('mpirun') is None:
            raise RunError('there is no mpirun')
        measured = [(ranks, measure(measuring.folder / PROGRAM, ranks, ranks * AGENTS, 1)[0]) for ranks in RANKS]
        return (*self.table(measured), self.draw(measured, measuring.plots / f'{self.name}.png'))

    def table(self, measured):
        """Returns header and rows, measured and modelled."""
        model = Model.of(times(measured))
        alone = dict(times(measured))[1]
        header = ['ranks', 'computing, slowest rank [ms per tick]', 'sent by all ranks [MB per tick]', 'efficiency',
                  *(f'modelled, {agents:,} agents each' for agents in MODELLED_AGENTS)]
        runs = dict(measured)
        rows = []
        for ranks in sorted({*runs, *MODELLED_RANKS}):
            cells = ['', '', '']
            if ranks in runs:
                value = runs[ranks]['computing_ms']
                cells = [f'{value:.1f}', f"{runs[ranks]['megabytes']:.2f}", f'{alone / value:.2f}']
            rows.append([str(ranks), *cells,
                         *(f'{model.efficiency(ranks, agents):.2f}' for agents in MODELLED_AGENTS)])
        return header, rows

    def draw(self, measured, file):
        """Draws measured points and the model. Returns the file."""
        figure, axes = style.new_figure(1, 1, 5.2, 3.4)
        panel = axes[0][0]
        model = Model.of(times(measured))
        alone = dict(times(measured))[1]
        for agents, line in zip(MODELLED_AGENTS, ('-', '--')):
            panel.plot(MODELLED_RANKS, [model.efficiency(ranks, agents) for ranks in MODELLED_RANKS], linestyle=line,
                       color=style.REFERENCE, label=f'modelled, {agents:,} agents on each rank')
        panel.plot([ranks for ranks, _ in measured], [alone / value for _, value in times(measured)], marker='o',
                   linestyle='', color='#1f77b4', label=f'measured, {AGENTS:,} agents on each rank')
        panel.set_xscale('log', base=2)
        panel.set_xticks(MODELLED_RANKS, [str(ranks) for ranks in MODELLED_RANKS])
        panel.set_ylim(0, 1.1)
        panel.set_title(self.title)
        panel.set_xlabel('ranks')
        panel.set_ylabel('efficiency')
        panel.legend(loc='lower left', fontsize='small')
        return style.save(figure, file)


def times(measured):
    """Returns (ranks, computing time [ms per tick])."""
    return [(ranks, run['computing_ms']) for ranks, run in measured]


RANK_SWEEPS = (WeakScaling('crowd_ranks_weak', 'One crowd on several ranks, square floor'),)
