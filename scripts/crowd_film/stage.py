"""Draws a film: the place with its frame and the strips above and below, which do not change, and each frame."""
import math

import numpy
from crowd_drawing.errors import InputError
from crowd_drawing.files import is_open, place_of
from crowd_drawing.picture import (GATE_COLOUR, OBSTACLE_COLOUR, RECORDED_COLOUR, ROBOT_COLOUR, Picture,
                                   colours_of, draw_surroundings, mark_of)
from crowd_recordings.formats import recorded_people
from matplotlib import pyplot
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import to_rgb
from matplotlib.lines import Line2D

DPI = 100
HEAD, FOOT = 28, 26  # [pixels] height of the strips above and below the place
LEAST_WIDTH = 320  # [pixels] for texts
EDGE = 10  # [pixels] at the left and right of texts
FONT_SIZE = 9.5
BAR_SHARE = 0.22  # greatest length of the scale bar, as a share of the width
BAR_LENGTHS = (1, 2, 5, 10, 20, 50, 100)  # [m]
TRAIL = 2.5  # [s]
TRAIL_POINTS = 9
NOSE = 0.09  # [m] width of the line that shows a heading
CIRCLE = numpy.array([(math.cos(angle), math.sin(angle)) for angle in numpy.linspace(0, 2 * math.pi, 33)])
OPEN, SHUT = (0, (1, 2)), '-'  # line styles of gates


class Stage:
    """A figure of a given size in pixels, in which a scene is drawn without its people, gates and moving obstacles.

    `view` is the part of the scene that is shown, [x0, y0, x1, y1] in metres; None: all of it, including all places
    of the tracks. `size` is the longer side of the film [pixels]."""

    def __init__(self, scene, tracks, title, size, view=None):
        self.figure, axes = pyplot.subplots(dpi=DPI)
        self.picture = Picture(axes)
        draw_surroundings(self.picture, scene, None)
        for body in scene.agents:
            self.picture.show(body['goals'] if not scene.population.sink_areas else [], body['radius'])
        for body in [*scene.obstacles, *scene.robots]:
            if body['position'] is not None:
                self.picture.show(body['position'], body['radius'])
        for agent, track in tracks.items():
            self.picture.show(track.places, scene.radius_of(agent))
        for robot in scene.robots:
            if 'track' in robot:
                self.picture.show(robot['track'].places, robot['radius'])
        self.recorded = [(track, radius) for _, track, radius in recorded_people(scene)]
        for track, radius in self.recorded:
            self.picture.show(track.places, radius)
        self.width, self.height = self.frame(size, view)
        self.write(title, scene)

    def frame(self, size, view):
        """Sets the limits and the size of the figure. Returns width and height [pixels]."""
        axes = self.picture.axes
        self.picture.frame()
        if view is not None:
            (left, right), (bottom, top) = axes.get_xlim(), axes.get_ylim()
            if view[0] >= right or view[2] <= left or view[1] >= top or view[3] <= bottom:
                raise InputError('--view: nothing of the scene is there, which is in {:g} {:g} {:g} {:g}; got {:g} '
                                 '{:g} {:g} {:g}'.format(left, bottom, right, top, *view))
            axes.set(xlim=(view[0], view[2]), ylim=(view[1], view[3]))
        axes.set_axis_off()
        metres = [high - low for low, high in (axes.get_xlim(), axes.get_ylim())]
        self.scale = min(size / metres[0], (size - HEAD - FOOT) / metres[1])  # [pixels/m]
        width = even(max(metres[0] * self.scale, LEAST_WIDTH))
        height = even(metres[1] * self.scale + HEAD + FOOT)
        self.figure.set_size_inches(width / DPI, height / DPI)
        axes.set_position([0, FOOT / height, 1, 1 - (HEAD + FOOT) / height])
        return width, height

    def write(self, title, scene):
        self.figure.text(EDGE / self.width, 1 - HEAD / 2 / self.height, title, va='center', fontsize=FONT_SIZE,
                         fontweight='bold')
        middle = FOOT / 2 / self.height
        length = max((length for length in BAR_LENGTHS if length * self.scale <= BAR_SHARE * self.width), default=1)
        ends = [EDGE / self.width, (EDGE + length * self.scale) / self.width]
        self.figure.add_artist(Line2D(ends, [middle, middle], color='0.2', linewidth=2, solid_capstyle='butt'))
        self.figure.text(ends[1] + EDGE / 2 / self.width, middle, f'{length} m', va='center', fontsize=FONT_SIZE - 1)
        entries = [*self.picture.further_entries,
                   *([mark_of('obstacle', OBSTACLE_COLOUR, 7, markeredgecolor='0.3')] if scene.obstacles else []),
                   *([mark_of('recorded', RECORDED_COLOUR, 7)] if self.recorded else []),
                   *([mark_of('robot', ROBOT_COLOUR, 7, 's', markeredgecolor='0.3')] if scene.robots else [])]
        if entries:
            self.figure.legend(handles=entries, loc='center right', bbox_to_anchor=(1, middle), ncol=len(entries),
                               frameon=False, fontsize=FONT_SIZE - 1, handlelength=1.4, columnspacing=1.2, borderpad=0,
                               handletextpad=0.5)


def even(number):
    """Returns the nearest even number; most video formats need even sides."""
    return 2 * round(number / 2)


class FramePainter:
    """Draws the people of a scene at any time on a Stage. Only what moves is drawn for each frame. Robots without a
    `track` stand at their start."""

    def __init__(self, stage, scene, tracks):
        self.stage, self.scene, self.tracks = stage, scene, tracks
        # People in the order of their entry have colours that are easy to distinguish.
        # Without agents in a scenario the numbers are those of a recording, which may be large.
        order = sorted({*range(len(scene.agents)), *tracks})
        self.colours = {agent: to_rgb(colour) for agent, colour in zip(order, colours_of(len(order)))}
        axes = stage.picture.axes
        self.gates = [axes.plot(*zip(*wall), color=GATE_COLOUR, linewidth=2.5, zorder=4)[0]
                      for wall, _ in scene.population.gates]
        self.trails = axes.add_collection(LineCollection([], linewidths=1.6, zorder=5))
        self.goals = axes.add_collection(LineCollection([], linewidths=1.6, zorder=5.5))
        self.ends = axes.add_collection(PolyCollection([], zorder=5.8, linewidths=1.2))
        self.bodies = axes.add_collection(PolyCollection([], zorder=7, linewidths=0.6, edgecolors='0.15'))
        self.noses = axes.add_collection(LineCollection([], colors='white', zorder=8, capstyle='round',
                                                        linewidths=max(0.5, NOSE * stage.scale * 72 / DPI)))
        self.robots = axes.add_collection(LineCollection([], colors='0.15', linewidths=1.4, zorder=8))
        self.clock = stage.figure.text(1 - EDGE / stage.width, 1 - HEAD / 2 / stage.height, '', va='center', ha='right',
                                       fontsize=FONT_SIZE, family='monospace')
        self.moving = [*self.gates, self.trails, self.goals, self.ends, self.bodies, self.noses, self.robots,
                       self.clock]
        for artist in self.moving:
            artist.set_animated(True)
        self.canvas = stage.figure.canvas
        self.canvas.draw()
        self.background = self.canvas.copy_from_bbox(stage.figure.bbox)

    def draw(self, time):
        """Returns the frame at a time [s] as an array (height, width, 3) of bytes."""
        self.place_people(time)
        for line, (_, periods) in zip(self.gates, self.scene.population.gates):
            line.set_linestyle(OPEN if is_open(periods, time) else SHUT)
        self.clock.set_text(f'{time:6.1f} s')
        self.canvas.restore_region(self.background)
        for artist in self.moving:
            self.stage.figure.draw_artist(artist)
        return numpy.array(self.canvas.buffer_rgba())[:, :, :3]

    def place_people(self, time):
        present = [(agent, track) for agent, track in self.tracks.items() if track.is_present(time)]
        discs = [(place_of(obstacle, time), obstacle['radius'], to_rgb(OBSTACLE_COLOUR))
                 for obstacle in self.scene.obstacles if obstacle['position'] is not None]
        robots = self.robots_at(time)
        discs += [(place, radius, to_rgb(ROBOT_COLOUR)) for place, _, radius in robots]
        noses = []
        for track, radius in self.stage.recorded:
            if track.is_present(time):
                discs.append((track.place_at(time), radius, to_rgb(RECORDED_COLOUR)))
                noses.append(nose_of(track, radius, time))
        segments, shades = [], []
        for agent, track in present:
            radius, colour = self.scene.radius_of(agent), self.colours[agent]
            discs.append((track.place_at(time), radius, colour))
            noses.append(nose_of(track, radius, time))
            places = track.trail(time, TRAIL, TRAIL_POINTS)
            segments += [places[i:i + 2] for i in range(TRAIL_POINTS - 1)]
            shades += [(*colour, 0.7 * (i + 1) / TRAIL_POINTS) for i in range(TRAIL_POINTS - 1)]
        self.trails.set_segments(segments)
        self.trails.set_color(shades)
        set_discs(self.bodies, discs)
        self.noses.set_segments(noses)
        self.robots.set_segments([[place, point_ahead(place, heading, radius)] for place, heading, radius in robots])
        self.show_goals(time)

    def robots_at(self, time):
        """Returns place, heading and radius of each robot at a time [s]."""
        return [(robot['track'].place_at(time), robot['track'].heading_at(time), robot['radius']) if 'track' in robot
                else (robot['position'], robot['heading'], robot['radius'])
                for robot in self.scene.robots if 'track' in robot or robot['position'] is not None]

    def show_goals(self, time):
        """Shows the last goal of each agent on its way, and the outline of each that has arrived."""
        crosses, shades, ends, rings = [], [], [], []
        for agent, track in self.tracks.items():
            goals = self.scene.agents[agent]['goals'] if agent < len(self.scene.agents) else []
            if not goals:
                continue
            radius, colour = self.scene.radius_of(agent), self.colours[agent]
            if time > track.times[-1]:
                ends.append((track.place_at(time), radius, 'none'))
                rings.append(colour)
                continue
            x, y = goals[-1]
            arm = 0.5 * radius
            crosses += [[(x - arm, y - slope * arm), (x + arm, y + slope * arm)] for slope in (-1, 1)]
            shades += [colour] * 2
        self.goals.set_segments(crosses)
        self.goals.set_color(shades)
        set_discs(self.ends, ends)
        self.ends.set_edgecolor(rings)


def set_discs(collection, discs):
    """Sets the discs (centre, radius, colour) of a collection."""
    collection.set_verts([numpy.array(centre) + radius * CIRCLE for centre, radius, _ in discs])
    collection.set_facecolor([colour for _, _, colour in discs])


def nose_of(track, radius, time):
    """Returns the line that shows the heading of a person."""
    place, heading = track.place_at(time), track.heading_at(time)
    return [point_ahead(place, heading, share * radius) for share in (0.35, 0.75)]


def point_ahead(place, heading, distance):
    """Returns the point at a distance [m] in the direction of a heading [rad]."""
    return place[0] + distance * math.cos(heading), place[1] + distance * math.sin(heading)
