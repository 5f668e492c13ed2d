"""Pictures of recorded episodes."""
import itertools

import numpy
from matplotlib.collections import EllipseCollection, LineCollection

from crowd_drawing.picture import colours_of
from crowd_experiments.style import new_figure, save

WALKER_COLOUR = '#1f77b4'
STUCK_COLOUR = '#d62728'
MARGIN = 1.0  # [m]
WIDTH = 8.0  # of a picture [inch]


def shown(recordings):
    """Returns the recording to draw: the one with most people who did not arrive; the first of equal ones."""
    return max(recordings, key=lambda recording: int(numpy.isinf(recording.arrivals).sum()))


def limits(recording):
    """Returns the lowest and the highest coordinates of all walls and places, with a margin [m]."""
    points = numpy.concatenate([numpy.reshape(recording.walls, (-1, 2)), recording.tracks.reshape(-1, 2)])
    return numpy.nanmin(points, axis=0) - MARGIN, numpy.nanmax(points, axis=0) + MARGIN


def frame(axes, recording):
    """Draws the walls and sets limits that include all places."""
    axes.add_collection(LineCollection([numpy.array(wall) for wall in recording.walls], colors='black', linewidths=2))
    xlim, ylim = zip(*limits(recording))
    axes.set(xlim=xlim, ylim=ylim, aspect='equal', xlabel='x [m]', ylabel='y [m]')
    axes.grid(False)


def bodies(axes, places, radii, colours, **style):
    """Draws discs in metres, each in its colour, except at places that are nan."""
    present = ~numpy.isnan(places[:, 0])
    colours = list(itertools.compress(colours, present))
    widths = 2.0 * radii[present]
    axes.add_collection(EllipseCollection(widths, widths, numpy.zeros(len(widths)), units='xy',
                                          offsets=places[present], offset_transform=axes.transData, facecolors=colours,
                                          edgecolors='none', **style))


def draw_paths(recording, file, title, colours=None):
    """Draws all paths with a disc at the start; a red disc is the end of those who did not arrive. Returns the file."""
    figure, ((axes,),) = new_figure(1, 1, WIDTH, height_for([recording], 1))
    frame(axes, recording)
    colours = colours or colours_of(recording.people())
    for agent, colour in enumerate(colours):
        axes.plot(*recording.tracks[:, agent].T, color=colour, linewidth=1.0, zorder=2)
    bodies(axes, recording.tracks[0], recording.radii, colours, alpha=0.5, zorder=3)
    stuck = ~numpy.isfinite(recording.arrivals)
    bodies(axes, recording.last_places()[stuck], recording.radii[stuck], [STUCK_COLOUR] * int(stuck.sum()), zorder=4)
    axes.set_title(title)
    return save(figure, file)


def draw_moments(panels, file, columns):
    """Draws panels (recording, time [s], title) of crowds; red: agents that never arrive. Returns the file."""
    rows = -(-len(panels) // columns)
    height = rows * height_for([recording for recording, _, _ in panels], columns)
    figure, axes = new_figure(rows, columns, WIDTH if columns == 1 else 1.6 * WIDTH, height)
    for panel in axes.flat[len(panels):]:
        panel.set_visible(False)
    for panel, (recording, time, title) in zip(axes.flat, panels):
        frame(panel, recording)
        stuck = ~numpy.isfinite(recording.arrivals)
        bodies(panel, recording.place_at(time), recording.radii, numpy.where(stuck, STUCK_COLOUR, WALKER_COLOUR))
        panel.set_title(title)
    return save(figure, file)


def height_for(recordings, columns):
    """Returns the height of a row of panels [inch] that suits the shapes of the scenes."""
    ratios = [numpy.divide(*numpy.subtract(*limits(recording))[::-1]) for recording in recordings]
    width = WIDTH if columns == 1 else 1.6 * WIDTH / columns
    return min(7.5, (width - 0.6) * max(ratios) + 0.9)


def draw_departures(series, file, title):
    """Draws how many people have left over time. Series: (label, colour, arrivals [s]). Returns the file."""
    figure, ((axes,),) = new_figure(1, 1, WIDTH, 4.0)
    for label, colour, arrivals in series:
        times = numpy.sort(arrivals[numpy.isfinite(arrivals)])
        axes.step(numpy.concatenate([[0.0], times]), numpy.arange(len(times) + 1), where='post', color=colour,
                  label=label)
    axes.set(xlabel='time [s]', ylabel='people that have left', title=title)
    axes.legend()
    return save(figure, file)
