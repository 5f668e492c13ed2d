"""Sweeps: cost of a crowd step against one variable, and their pictures."""
import dataclasses

from crowd_bench.catalogue import AGENT_STEPS, DECISIONS
from crowd_experiments import style

COLOUR = '#1f77b4'
PANEL = (4.6, 3.2)  # [inch]


@dataclasses.dataclass(frozen=True)
class Sweep:
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
        """Draws the measured points. Returns the file."""
        figure, axes = style.new_figure(1, 1, *PANEL)
        panel = axes[0][0]
        points = self.points(measured)
        panel.plot(*zip(*points), marker='o', color=COLOUR)
        if self.threads:
            panel.plot([1, points[-1][0]], [1, points[-1][0]], color=style.REFERENCE, linestyle='--', linewidth=1)
            panel.set_xticks([point for point, _ in points])
        if self.logarithmic:
            panel.set_xscale('log')
        panel.set_ylim(0, 1.15 * max(value for _, value in points))
        panel.set_title(self.title)
        panel.set_xlabel(self.label)
        panel.set_ylabel(self.value_label)
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
