"""Draws learning curves."""
import dataclasses

import numpy
from crowd_curves.records import band_of
from crowd_drawing.picture import colours_of
from crowd_experiments.style import new_figure, save
from matplotlib.ticker import MaxNLocator

MOST_COLUMNS = 3  # of panels
PANEL = 3.9, 2.9  # [inch]
BAND_ALPHA = 0.2
LEGEND_LINE = 0.22  # [inch]


@dataclasses.dataclass(frozen=True)
class Measure:
    """A column of a record as it is drawn."""
    column: str
    title: str
    factor: float = 1.0
    limits: tuple = (None, None)  # of the axis
    range: tuple = (-numpy.inf, numpy.inf)  # of the shown values, which confidence intervals do not leave

    def shown(self, band):
        """Returns mean, low and high end of a Band in the shown unit."""
        return [numpy.clip(self.factor * values, *self.range) for values in (band.mean, band.low, band.high)]


FROM_ZERO = {'limits': (0, None), 'range': (0, numpy.inf)}
PERCENT = {'factor': 100.0, 'limits': (-3, 103), 'range': (0, 100)}
# Those whose columns the records have are drawn.
MEASURES = [
    Measure('arrived', 'success [%]', **PERCENT),
    Measure('touched', 'contact [%]', **PERCENT),
    Measure('collided', 'collision [%]', **PERCENT),
    Measure('success', 'success [%]', **PERCENT),
    Measure('contact', 'contact [%]', **PERCENT),
    Measure('collision', 'collision [%]', **PERCENT),
    Measure('reward', 'reward'),
    Measure('visited_rows', 'visited rows', **FROM_ZERO),
    Measure('epsilon', 'epsilon', **FROM_ZERO),
    Measure('ticks', 'decisions in an episode', **FROM_ZERO),
    Measure('gain_per_tick', 'distance gained [m a decision]'),
    Measure('turn_per_metre', 'turning [rad/m]', **FROM_ZERO),
]


def measures_of(runs, columns=None):
    """Returns the Measures that all runs have, or those of the given columns, in their order."""
    if columns is None:
        return [measure for measure in MEASURES if all(measure.column in run.columns for run in runs)]
    known = {measure.column: measure for measure in MEASURES}
    return [known.get(column, Measure(column, column)) for column in columns]


def draw_curves(file, runs, measures, window, title=''):
    """Draws a panel for each measure, with a curve and a band for each label of runs. Returns the file."""
    labels = list(dict.fromkeys(run.label for run in runs))
    columns = min(MOST_COLUMNS, len(measures))
    rows = -(-len(measures) // columns)
    heights = [PANEL[1]] * rows + [LEGEND_LINE * len(labels) + 0.4]
    figure, axes = new_figure(rows + 1, columns, PANEL[0] * columns, sum(heights),
                              gridspec_kw={'height_ratios': heights})
    for panel, measure in zip(axes.flat, measures):
        for label, colour in zip(labels, colours_of(len(labels))):
            draw_band(panel, band_of(label, [run for run in runs if run.label == label], measure.column, window),
                      measure, colour)
        panel.set(title=measure.title, xlabel='episode')
        panel.set_xlim(left=0)
        panel.xaxis.set_major_locator(MaxNLocator(5, integer=True))
        panel.set_ylim(*measure.limits)
    for panel in list(axes.flat)[len(measures):]:
        panel.set_axis_off()
    below = axes[-1, 0].legend(*axes.flat[0].get_legend_handles_labels(), loc='upper left',
                               frameon=False)
    below.set_in_layout(False)  # it may be wider than the panel above it
    if title:
        figure.suptitle(title, fontsize=12)
    return save(figure, file)


def draw_band(panel, band, measure, colour):
    """Draws a curve and its band."""
    noun = 'run' if band.runs == 1 else 'runs'
    name = f'{band.label}, {band.runs} {noun}' if band.label else f'{band.runs} {noun}'
    mean, low, high = measure.shown(band)
    panel.plot(band.episodes, mean, color=colour, linewidth=1.5, label=name,
               marker='o' if len(band.episodes) == 1 else None)
    panel.fill_between(band.episodes, low, high, color=colour, alpha=BAND_ALPHA, linewidth=0)
