"""The unchanging part of a film: the place, its frame, and the strips above and below."""
from crowd_drawing.errors import InputError
from crowd_drawing.picture import OBSTACLE_COLOUR, Picture
from crowd_drawing.surroundings import draw_surroundings
from matplotlib import pyplot
from matplotlib.lines import Line2D

DPI = 100
ROBOT_COLOUR = '#f2a900'
HEAD, FOOT = 28, 26  # [pixels] height of the strips above and below the place
LEAST_WIDTH = 320  # [pixels] for texts
EDGE = 10  # [pixels] at the left and right of texts
FONT_SIZE = 9.5
BAR_SHARE = 0.22  # greatest length of the scale bar, as a share of the width
BAR_LENGTHS = (1, 2, 5, 10, 20, 50, 100)  # [m]


class Stage:
    """A figure of a given size in pixels, in which a scene is drawn without its people, gates and moving obstacles.

    `view` is the part of the scene that is shown, [x0, y0, x1, y1] in metres; None: all of it, including all places
    of the tracks. `size` is the longer side of the film [pixels]."""

    def __init__(self, scene, tracks, title, size, view=None):
        self.figure, axes = pyplot.subplots(dpi=DPI)
        self.picture = Picture(axes)
        draw_surroundings(self.picture, scene, None)
        for wall in scene.walls:
            self.picture.draw_wall(wall)
        for body in scene.agents:
            for goal in body['goals'] if not scene.population.sink_areas else []:
                self.picture.show(goal, body['radius'])
        for body in [*scene.obstacles, *scene.robots]:
            if body['position'] is not None:
                self.picture.show(body['position'], body['radius'])
        for agent, track in tracks.items():
            for corner in (track.places.min(axis=0), track.places.max(axis=0)):
                self.picture.show(corner, scene.radius_of(agent))
        self.width, self.height = self.frame(size, view)
        self.write(title, scene)

    def frame(self, size, view):
        """Sets the limits and the size of the figure. Returns width and height [pixels]."""
        axes = self.picture.axes
        self.picture.frame()
        if view is not None:
            check_view(view, axes.get_xlim(), axes.get_ylim())
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
        """Writes the title, the scale bar and the legend."""
        self.figure.text(EDGE / self.width, 1 - HEAD / 2 / self.height, title, va='center', fontsize=FONT_SIZE,
                         fontweight='bold')
        middle = FOOT / 2 / self.height
        length = max((length for length in BAR_LENGTHS if length * self.scale <= BAR_SHARE * self.width), default=1)
        ends = [EDGE / self.width, (EDGE + length * self.scale) / self.width]
        self.figure.add_artist(Line2D(ends, [middle, middle], color='0.2', linewidth=2, solid_capstyle='butt'))
        self.figure.text(ends[1] + EDGE / 2 / self.width, middle, f'{length} m', va='center', fontsize=FONT_SIZE - 1)
        entries = list(self.picture.further_entries)
        if scene.obstacles:
            entries.append(mark_of('obstacle', OBSTACLE_COLOUR, 'o'))
        if scene.robots:
            entries.append(mark_of('robot', ROBOT_COLOUR, 's'))
        if entries:
            self.figure.legend(handles=entries, loc='center right', bbox_to_anchor=(1, middle), ncol=len(entries),
                               frameon=False, fontsize=FONT_SIZE - 1, handlelength=1.4, columnspacing=1.2, borderpad=0,
                               handletextpad=0.5)

    def clock(self):
        """Returns a text at the right of the upper strip."""
        return self.figure.text(1 - EDGE / self.width, 1 - HEAD / 2 / self.height, '', va='center', ha='right',
                                fontsize=FONT_SIZE, family='monospace')


def mark_of(label, colour, marker):
    """Returns an entry of a legend."""
    return Line2D([], [], linestyle='', marker=marker, color=colour, markeredgecolor='0.3', markersize=7, label=label)


def even(number):
    """Returns the nearest even number; most video formats need even sides."""
    return 2 * round(number / 2)


def check_view(view, x_limits, y_limits):
    """Raises InputError if nothing of a scene with these limits is in a view."""
    if view[0] >= x_limits[1] or view[2] <= x_limits[0] or view[1] >= y_limits[1] or view[3] <= y_limits[0]:
        corners = ' '.join(f'{value:g}' for value in (x_limits[0], y_limits[0], x_limits[1], y_limits[1]))
        raise InputError(f"--view: nothing of the scene is there, which is in {corners}; got "
                         f"{' '.join(f'{value:g}' for value in view)}")
