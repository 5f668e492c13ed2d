"""Pictures: distributions of recorded and simulated walkers; ways of people, recorded and predicted."""
import numpy
from crowd_experiments.style import new_figure, save
from matplotlib.lines import Line2D

from .measures import FIGURES, distances_of, ks_distance

RECORDED, SIMULATED, STRAIGHT = '0.35', '#d55e00', '#0072b2'
BINS, OUTLIERS = 24, 1  # [%] of all values beyond each end of a panel
EXAMPLES, MARGIN = 7, 1.2  # [m]
NEAR = 2.0  # [m] from another person at some time


def draw_distributions(file, recorded, simulated, floors, title):
    """Draws a panel for each of the FIGURES of recorded and simulated walkers."""
    figure, panels = new_figure(2, 4, 14, 6)
    for panel, (name, label) in zip(panels.flat, FIGURES.items()):
        both = numpy.concatenate([recorded[name], simulated[name]])
        low, high = numpy.percentile(both, [OUTLIERS, 100 - OUTLIERS]) if len(both) else (0, 1)
        edges = numpy.linspace(low, max(high, low + 0.1), BINS)
        for values, options in ((recorded[name], {'color': RECORDED, 'alpha': 0.45}),
                                (simulated[name], {'color': SIMULATED, 'histtype': 'step', 'linewidth': 1.8})):
            weights = numpy.full(len(values), 100 / max(1, len(values)))
            panel.hist(numpy.clip(values, *edges[[0, -1]]), edges, weights=weights, **options)
        distance = ks_distance(recorded[name], simulated[name])
        panel.set(xlabel=label, title=f'KS distance {distance:.2f} (halves of the recording {floors[name]:.2f})')
        panel.title.set_fontsize(9)
    for panel in panels[:, 0]:
        panel.set_ylabel('share of walkers [%]')
    legend = panels.flat[len(FIGURES)]
    legend.set_axis_off()
    handles = [Line2D([], [], color=RECORDED, alpha=0.45, linewidth=8, label='recorded'),
               Line2D([], [], color=SIMULATED, linewidth=1.8, label='simulated')]
    legend.legend(handles=handles, loc='center', fontsize=12)
    figure.suptitle(title)
    return save(figure, file)


def examples_of(moments, predictions):
    """Returns (moment, person, error) of windows with company, from the best to the worst prediction."""
    found = []
    for number, (moment, predicted) in enumerate(zip(moments, predictions)):
        for person in numpy.flatnonzero(moment.complete()):
            others = numpy.delete(moment.future, person, axis=0) - moment.future[person]
            if (numpy.hypot(*others.transpose(2, 0, 1)) < NEAR).any():
                found.append((distances_of(moment, predicted, person).mean(), number, person))
    ranks = numpy.linspace(0.05, 0.95, EXAMPLES) * (len(found) - 1)
    ordered = sorted(found)
    return [ordered[rank] for rank in dict.fromkeys(ranks.round().astype(int))] if found else []


def draw_examples(file, moments, straight, simulated, title):
    """Draws windows with company: what was observed, what came, and the predictions."""
    figure, panels = new_figure(2, (EXAMPLES + 1) // 2, 14, 7.4)
    for panel in panels.flat:
        panel.set_axis_off()
    for panel, (error, number, person) in zip(panels.flat, examples_of(moments, simulated)):
        panel.set_axis_on()
        moment = moments[number]

        def draw(line, who, way, **options):
            panel.plot(*numpy.concatenate([moment.seen[who, -1:], way[who]]).T, line, **options)
        for other in numpy.delete(numpy.arange(len(moment.seen)), person):
            panel.plot(*moment.seen[other].T, '-', color='0.8', linewidth=1)
            panel.plot(*moment.future[other].T, '.', color='0.7', markersize=4)
            draw('-', other, simulated[number], color=SIMULATED, alpha=0.35, linewidth=1)
        panel.plot(*moment.seen[person].T, 'k.-', linewidth=1, markersize=5)
        panel.plot(*moment.future[person].T, 'o', color=RECORDED, markersize=4)
        draw('-', person, simulated[number], color=SIMULATED, linewidth=1.8)
        draw('--', person, straight[number], color=STRAIGHT, linewidth=1.4)
        ways = numpy.concatenate([moment.seen[person], moment.future[person], simulated[number][person]])
        middle, half = (ways.min(axis=0) + ways.max(axis=0)) / 2, numpy.ptp(ways, axis=0).max() / 2 + MARGIN
        panel.set(xlim=middle[0] + [-half, half], ylim=middle[1] + [-half, half], aspect='equal',
                  title=f'mean error {error:.2f} m', xlabel='x [m]', ylabel='y [m]')
    handles = [Line2D([], [], color='k', marker='.', label='observed, 3.2 s'),
               Line2D([], [], color=RECORDED, marker='o', linestyle='', markersize=4, label='what came, 4.8 s'),
               Line2D([], [], color=SIMULATED, linewidth=1.8, label='simulated'),
               Line2D([], [], color=STRAIGHT, linestyle='--', label='constant velocity'),
               Line2D([], [], color='0.8', label='others, observed'),
               Line2D([], [], color='0.7', marker='.', linestyle='', label='others, what came'),
               Line2D([], [], color=SIMULATED, alpha=0.35, label='others, simulated')]
    panels.flat[-1].legend(handles=handles, loc='center', fontsize=11)
    figure.suptitle(title)
    return save(figure, file)
