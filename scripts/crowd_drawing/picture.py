"""A drawing of a scene in metres, and of what surrounds a crowd: maps, walls, places to come and leave, queues."""
import colorsys
import math

import matplotlib
import numpy
from crowd_drawing.files import is_open

matplotlib.use('Agg')
from matplotlib import pyplot  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402
from matplotlib.patches import Circle, FancyArrowPatch, Patch, Rectangle  # noqa: E402
from matplotlib.patheffects import Normal, Stroke  # noqa: E402
from matplotlib.transforms import ScaledTranslation  # noqa: E402

LONGER_SIDE = 7.0  # of the axes [inch]
MARGIN = 0.5  # of the picture around its contents [m]
OBSTACLE_COLOUR = '0.62'
ROBOT_COLOUR = '#f2a900'
RECORDED_COLOUR = '#1f2129'  # of recorded people
SOURCE_COLOUR, SINK_COLOUR, GATE_COLOUR = '#8ecbf5', '#a5dba0', '#e07b00'
START_ALPHA = 0.55
PATH_OF_MOMENT = 10.0  # [s]
# Strong colours that are easy to distinguish, without grey.
FEW_COLOURS = ['#1f77b4', '#d62728', '#2ca02c', '#ff7f0e', '#9467bd', '#17becf', '#8c564b', '#e377c2', '#9a9a00']


def colours_of(count):
    """Returns `count` colours; adjacent colours in the list are easy to distinguish."""
    if count <= len(FEW_COLOURS):
        return FEW_COLOURS[:count]
    golden = (math.sqrt(5) - 1) / 2
    return [colorsys.hls_to_rgb((0.58 + golden * i) % 1.0, (0.32, 0.44, 0.56)[i % 3], 0.75) for i in range(count)]


def mark_of(label, colour, size=10, marker='o', **style):
    """Returns an entry of a legend."""
    return Line2D([], [], linestyle='', marker=marker, color=colour, markersize=size, label=label, **style)


class Picture:
    """A drawing in metres whose limits grow with its contents; in its own figure, or in given axes."""

    def __init__(self, axes=None):
        self.figure, self.axes = (axes.figure, axes) if axes is not None else pyplot.subplots()
        self.low, self.high = numpy.full(2, math.inf), numpy.full(2, -math.inf)
        self.has_goals = self.has_obstacles = self.has_recorded = False
        self.further_entries = []  # of the legend

    def show(self, points, radius=0.0):
        """Extends the limits of the picture to include a disc at a point, or at several."""
        points = numpy.reshape(points, (-1, 2))
        self.low = numpy.min([self.low, *(points - radius)], axis=0)
        self.high = numpy.max([self.high, *(points + radius)], axis=0)

    def disc(self, centre, radius, **style):
        self.axes.add_patch(Circle(centre, radius, **style))

    def arrow(self, start, end, style, **line):
        self.axes.add_patch(FancyArrowPatch(start, end, arrowstyle=style, mutation_scale=12, shrinkA=0, shrinkB=0,
                                            color='0.35', linewidth=1.2, zorder=2, **line))

    def draw_obstacle(self, obstacle, duration):
        """Draws a disc at the start of an obstacle, and arrows along its path within the duration [s]."""
        start, radius = obstacle['position'], obstacle['radius']
        if start is None:
            return
        self.has_obstacles = True
        self.disc(start, radius, facecolor=OBSTACLE_COLOUR, edgecolor='0.35', linewidth=0.8, zorder=1)
        velocity = obstacle['velocity']
        if velocity != (0, 0):
            end = (start[0] + velocity[0] * duration, start[1] + velocity[1] * duration)
            self.disc(end, radius, fill=False, edgecolor='0.35', linestyle='--', linewidth=0.8, zorder=1)
            self.arrow(start, end, '-|>')
        stops = [start] + obstacle['to_and_fro']
        self.show(stops + obstacle['waypoints'], radius)
        for here, there in zip(stops, stops[1:]):
            self.arrow(here, there, '<|-|>')
        stops = [start] + obstacle['waypoints'] + [start]
        for here, there in zip(stops, stops[1:]) if len(stops) > 2 else []:
            self.arrow(here, there, '-|>', linestyle='--' if there is start else '-')

    def draw_wall(self, wall):
        self.show(wall)
        self.axes.plot(*zip(*wall), color='black', linewidth=3, solid_capstyle='round', zorder=3)

    def draw_goals(self, goals, radius, colour):
        """Draws a cross at each goal, smaller than the body."""
        arm = 0.55 * radius
        for x, y in goals:
            self.has_goals = True
            self.show((x, y), radius)
            for slope in (-1, 1):
                self.axes.plot([x - arm, x + arm], [y - slope * arm, y + slope * arm], color=colour, linewidth=2,
                               zorder=8, path_effects=[Stroke(linewidth=4, foreground='white'), Normal()])

    def draw_walk(self, walk, radius, ticks_per_dot, colour):
        """Draws the path with a dot each second, the body at its start, and the outline of the body at its end."""
        places = [(x, y) for _, x, y in walk]
        dots = [(x, y) for tick, x, y in walk if tick % ticks_per_dot == 0]
        self.show(places, radius)
        self.axes.plot(*zip(*places), color=colour, linewidth=1.6, solid_joinstyle='round', zorder=5)
        if dots:
            self.axes.plot(*zip(*dots), linestyle='', marker='o', color=colour, markersize=3.2, zorder=6)
        self.disc(places[0], radius, facecolor=colour, edgecolor='none', alpha=START_ALPHA, zorder=4)
        self.disc(places[-1], radius, fill=False, edgecolor=colour, linewidth=1.4, zorder=7)

    def draw_moment(self, walk, tick, ticks_of_path, radius, colour):
        """Draws the body at a tick if the agent is in the world then, and its path in the ticks before."""
        places = [(x, y) for at, x, y in walk if tick - ticks_of_path <= at <= tick]
        self.show(places, radius)
        if places:
            self.axes.plot(*zip(*places), color=colour, linewidth=0.9, alpha=0.6, zorder=5)
        if places and walk[-1][0] >= tick:
            self.disc(places[-1], radius, facecolor=colour, edgecolor='black', linewidth=0.4, zorder=7)

    def draw_recorded(self, track, radius, end, moment):
        """Draws the path of a recorded person until the end of the episode, or the body at a moment, if it is not None
        [s]."""
        places = track.places[track.times <= end]
        if moment is None and len(places):
            self.has_recorded = True
            self.show(places, radius)
            self.axes.plot(*places.T, color=RECORDED_COLOUR, linewidth=1.0, alpha=0.6, zorder=4)
        elif moment is not None and track.is_present(moment):
            self.has_recorded = True
            self.show(track.place_at(moment), radius)
            self.disc(track.place_at(moment), radius, facecolor=RECORDED_COLOUR, zorder=6)

    def add_legend(self, scene, is_moment=False):
        grey = '0.25'
        entries = [
            mark_of('person', grey, 7),
            Line2D([], [], color=grey, alpha=0.6, linewidth=0.9, label=f'path of the last {PATH_OF_MOMENT:g} s'),
        ] if is_moment else [
            mark_of('start', grey, alpha=START_ALPHA),
            Line2D([], [], marker='o', color=grey, markersize=3.2, linewidth=1.6, label='path, a dot each second'),
            mark_of('end', grey, fillstyle='none'),
        ]
        entries += [mark_of('goal', grey, 8, marker='x', markeredgewidth=2)] if self.has_goals else []
        entries += [mark_of('obstacle', OBSTACLE_COLOUR, markeredgecolor='0.35')] if self.has_obstacles else []
        entries += [mark_of('recorded person', RECORDED_COLOUR, 7)] if self.has_recorded else []
        entries += [Line2D([], [], color='black', linewidth=3, label='wall')] if scene.walls else []
        entries += self.further_entries
        below_labels = ScaledTranslation(0, -0.45, self.figure.dpi_scale_trans)  # [inch]
        self.axes.legend(handles=entries, loc='upper center', bbox_to_anchor=(0.5, 0), ncol=len(entries),
                         bbox_transform=self.axes.transAxes + below_labels, frameon=False, fontsize=9,
                         handletextpad=0.5, columnspacing=1.4)

    def frame(self):
        """Sets the limits so that everything is within them; returns width and height [m]."""
        xlim, ylim = zip(self.low - MARGIN, self.high + MARGIN)
        self.axes.set(xlim=xlim, ylim=ylim, aspect='equal', axisbelow=True)
        self.axes.grid(color='0.92', linewidth=0.8)
        return self.high - self.low + 2 * MARGIN

    def save(self, file, title):
        size = self.frame()
        self.axes.set(title=title, xlabel='x [m]', ylabel='y [m]')
        self.figure.set_size_inches(LONGER_SIDE / max(size) * size + 1.5)
        self.figure.savefig(file, dpi=150, bbox_inches='tight')


def draw_surroundings(picture, scene, time):
    """Draws everything but agents, robots and obstacles; gates as they are at a time [s], none if it is None."""
    population = scene.population
    if scene.map is not None:
        picture.show(scene.map.corners())
        width, height = scene.map.size
        picture.axes.imshow(scene.map.pixels, extent=(0, width, 0, height), interpolation='nearest', zorder=0.6,
                            transform=scene.map.transform() + picture.axes.transData)
    for wall in scene.walls:
        picture.draw_wall(wall)
    for areas, colour, name in ((population.source_areas, SOURCE_COLOUR, 'people come'),
                                (population.sink_areas, SINK_COLOUR, 'people leave')):
        for area in areas:
            draw_area(picture, area, colour)
        if areas:
            picture.further_entries.append(Patch(facecolor=colour, label=name))
    for head, last in population.queues:
        picture.axes.plot(*zip(head, last), color='0.45', linewidth=1, linestyle=':', zorder=3)
        picture.disc(head, 0.12, facecolor='0.45', zorder=3)
    if population.queues:
        picture.further_entries.append(Line2D([], [], color='0.45', marker='o', markersize=4, linestyle=':',
                                              label='queue'))
    for wall, periods in population.gates if time is not None else []:
        style = (0, (1, 2)) if is_open(periods, time) else '-'
        picture.axes.plot(*zip(*wall), color=GATE_COLOUR, linewidth=2.5, linestyle=style, zorder=4)
    if population.gates:
        picture.further_entries.append(Line2D([], [], color=GATE_COLOUR, linewidth=2.5, label='gate (dotted: open)'))


def draw_area(picture, area, colour):
    """Draws the area of a source or a sink, except for points."""
    if 'box' in area:
        (left, bottom), (right, top) = area['box']
        picture.axes.add_patch(Rectangle((left, bottom), right - left, top - bottom, facecolor=colour, zorder=1))
    elif 'ring' in area:
        radius = area['ring']['radius']
        picture.axes.add_patch(Circle(area['ring']['centre'], max(radius) if isinstance(radius, list) else radius,
                                      facecolor=colour, zorder=1))
