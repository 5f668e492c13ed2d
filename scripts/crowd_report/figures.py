"""Figures of a report."""
import textwrap

import numpy
from crowd_drawing.files import Scene, read_scene, read_walks, shipped_scenarios
from crowd_drawing.picture import Picture, colours_of
from crowd_drawing.surroundings import draw_surroundings
from crowd_experiments.records import read_tracks
from crowd_experiments.style import new_figure, save
from crowd_report.crowding import separations, speed_by_density, speeds_and_densities

WIDTH = 5.6  # [inch] of a panel
ROOM = 0.5  # [inch] for its title
MOST_COLUMNS = 3  # of panels
TITLE_WIDTH = 44  # [characters]
BIN = 0.1  # [m] of the histogram
FARTHEST = 4.0  # [m]
MOST_OPAQUE = 30  # paths; more are paler


def scenario_of(file):
    """Returns the scenario file of a file of trajectories: NAME.yaml beside it, as `evaluate --scenes` writes it, else
    the package's scenario of this name; None if there is neither."""
    beside = file.with_suffix('.yaml')
    return beside if beside.is_file() else shipped_scenarios().get(file.stem)


def scene_of(file):
    """Returns the scenario of a file of trajectories; an empty scene if it is unknown. Raises InputError, OSError."""
    scenario = scenario_of(file)
    return read_scene(scenario, 0) if scenario else Scene({}, str(file))


def draw_paths(target, groups):
    """Draws the paths of the first episode of each label's first file. Groups: sources by label. Returns the file."""
    columns = min(MOST_COLUMNS, len(groups))
    rows = -(-len(groups) // columns)
    figure, axes = new_figure(rows, columns, WIDTH * columns, WIDTH * rows)
    ratios = []
    for panel, (label, sources) in zip(axes.flat, groups.items()):
        _, walks = read_walks(sources[0].file, None)
        width, height = draw_walks(Picture(panel), scene_of(sources[0].file), walks).frame()
        ratios.append(height / width)
        panel.set_xlabel('x [m]')
        panel.set_ylabel('y [m]')
        panel.set_title('\n'.join(textwrap.wrap(label, TITLE_WIDTH)))
    for panel in list(axes.flat)[len(groups):]:
        panel.set_axis_off()
    figure.set_size_inches(WIDTH * columns, (min(1.5, max(ratios)) * WIDTH + ROOM) * rows)
    return save(figure, target)


def draw_walks(picture, scene, walks):
    """Draws the paths of an episode in its scene. Returns the picture."""
    draw_surroundings(picture, scene, 0.0)
    for wall in scene.walls:
        picture.draw_wall(wall)
    for obstacle in scene.obstacles:
        picture.draw_obstacle(obstacle, max(walk[-1][0] for walk in walks.values()) * scene.tick)
    opacity = min(0.9, max(0.15, MOST_OPAQUE / len(walks)))
    for (agent, walk), colour in zip(sorted(walks.items()), colours_of(len(walks))):
        places, radius = numpy.array(walk)[:, 1:], scene.radius_of(agent)
        for corner in (places.min(axis=0), places.max(axis=0)):
            picture.show(corner, radius)
        picture.axes.plot(*places.T, color=colour, linewidth=1.2, alpha=opacity, zorder=5)
        picture.disc(places[-1], radius, fill=False, edgecolor=colour, alpha=opacity, zorder=6)
    return picture


def tracks_of(sources):
    """Yields the Tracks (arrays) of all episodes of files, with the duration of their ticks [s]."""
    for source in sources:
        tick = scene_of(source.file).tick
        for track in read_tracks(source.file).values():
            yield track, tick


def draw_separations(target, groups):
    """Draws the histogram of the distances to the nearest person, for each label. Returns the file, or None if no
    moment has two people."""
    apart = {label: numpy.concatenate([separations(*track) for track in tracks_of(sources)])
             for label, sources in groups.items()}
    if not any(map(len, apart.values())):
        return None
    figure, axes = new_figure(1, 1, 1.5 * WIDTH, 0.75 * WIDTH)
    for (label, values), colour in zip(apart.items(), colours_of(len(apart))):
        if len(values):
            axes[0, 0].hist(values, numpy.arange(0, FARTHEST + BIN, BIN), histtype='step', linewidth=1.6, color=colour,
                            weights=numpy.full(len(values), 100 / len(values)),
                            label=f'{label} (least {values.min():.2f} m)')
    axes[0, 0].set_xlabel('distance to the nearest person, centre to centre [m]')
    axes[0, 0].set_ylabel('share of all moments [%]')
    axes[0, 0].set_xlim(0, FARTHEST)
    axes[0, 0].legend()
    return save(figure, target)


def draw_speeds(target, groups):
    """Draws mean speed against density, with the standard deviation, for each label. Returns the file, or None if there
    was only one density."""
    points = {}
    for label, sources in groups.items():
        pairs = [speeds_and_densities(*track) for track in tracks_of(sources)]
        points[label] = speed_by_density(*map(numpy.concatenate, zip(*pairs)))
    if len({density for rows in points.values() for density in rows[:, 0]}) < 2:
        return None
    figure, axes = new_figure(1, 1, 1.5 * WIDTH, 0.75 * WIDTH)
    for (label, rows), colour in zip(points.items(), colours_of(len(points))):
        if len(rows):
            axes[0, 0].errorbar(*rows.T[:2], yerr=rows[:, 2], color=colour, marker='o', markersize=4, capsize=3,
                                linewidth=1.2, label=label)
    axes[0, 0].set_xlabel('people within 2 m [1/m²]')
    axes[0, 0].set_ylabel('speed [m/s]')
    axes[0, 0].set_ylim(bottom=0)
    axes[0, 0].legend()
    return save(figure, target)
