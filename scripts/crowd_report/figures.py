"""Figures of a report: paths, how close people are to each other, and how fast they walk at which density."""
import math
import textwrap

import numpy
from crowd_drawing.files import Scene, read_scene, read_walks, shipped_scenarios
from crowd_drawing.picture import Picture, colours_of, draw_surroundings
from crowd_experiments.records import read_tracks
from crowd_experiments.style import new_figure, save

STEP = 0.5  # [s] between two moments that are measured; people hardly move in a tick
RADIUS = 2.0  # [m] of the disc in which people are counted
SPAN = 1.0  # [s] over which speeds are measured
WIDTH = 5.6  # [inch] of a panel
ROOM = 0.5  # [inch] for its title
MOST_COLUMNS = 3  # of panels
TITLE_WIDTH = 44  # [characters]
BIN = 0.1  # [m] of the histogram
FARTHEST = 4.0  # [m]
MOST_OPAQUE = 30  # paths; more are paler


def separations(track, tick):
    """Returns the distance from each person to the nearest other one [m], at moments 0.5 s apart, of a track."""
    found = []
    for places in track[::stride(STEP, tick)]:
        here = places[numpy.isfinite(places[:, 0])]
        if len(here) > 1:
            found.append(distances(here).min(axis=1))
    return numpy.concatenate(found) if found else numpy.empty(0)


def distances(places):
    """Returns the distances between all places; infinite from a place to itself."""
    apart = numpy.hypot(*(places[:, None, :] - places[None, :, :]).transpose(2, 0, 1))
    numpy.fill_diagonal(apart, numpy.inf)
    return apart


def speeds_and_densities(track, tick):
    """Returns speed [m/s] and density [1/m2] of each person that is recorded for a whole second, at moments 0.5 s
    apart. The speed is the displacement in this second, divided by it; the density is the number of people within 2 m
    in its middle, including the person, divided by the area of this disc."""
    span, half = stride(SPAN, tick), stride(SPAN, tick) // 2
    speeds, densities = [], []
    for start in range(0, len(track) - span, stride(STEP, tick)):
        begin, middle, end = track[start], track[start + half], track[start + span]
        there = numpy.isfinite(middle[:, 0])
        whole = there & numpy.isfinite(begin[:, 0]) & numpy.isfinite(end[:, 0])
        if whole.any():
            near = (distances(middle[there]) <= RADIUS).sum(axis=1) + 1
            speeds.append(numpy.hypot(*(end - begin)[whole].T) / (span * tick))
            densities.append(near[whole[there]] / (math.pi * RADIUS**2))
    return (numpy.concatenate(speeds), numpy.concatenate(densities)) if speeds else (numpy.empty(0), numpy.empty(0))


def stride(duration, tick):
    """Returns a duration in ticks, at least 1."""
    return max(1, round(duration / tick))


def speed_by_density(speeds, densities, least=20):
    """Returns density [1/m2], mean and standard deviation of speeds [m/s] for densities with enough values."""
    rows = [(density, speeds[densities == density]) for density in numpy.unique(densities)]
    return numpy.array([(density, values.mean(), values.std()) for density, values in rows
                        if len(values) >= least]).reshape(-1, 3)


def scenario_of(file):
    """Returns the scenario of a file of trajectories: NAME.yaml beside it, else the package's; None without either."""
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
        (_, walks), scene, picture = read_walks(sources[0].file, None), scene_of(sources[0].file), Picture(panel)
        draw_surroundings(picture, scene, 0.0)
        for obstacle in scene.obstacles:
            picture.draw_obstacle(obstacle, max(walk[-1][0] for walk in walks.values()) * scene.tick)
        opacity = min(0.9, max(0.15, MOST_OPAQUE / len(walks)))
        for (agent, walk), colour in zip(sorted(walks.items()), colours_of(len(walks))):
            places, radius = numpy.array(walk)[:, 1:], scene.radius_of(agent)
            picture.show(places, radius)
            panel.plot(*places.T, color=colour, linewidth=1.2, alpha=opacity, zorder=5)
            picture.disc(places[-1], radius, fill=False, edgecolor=colour, alpha=opacity, zorder=6)
        width, height = picture.frame()
        ratios.append(height / width)
        panel.set(xlabel='x [m]', ylabel='y [m]', title='\n'.join(textwrap.wrap(label, TITLE_WIDTH)))
    for panel in list(axes.flat)[len(groups):]:
        panel.set_axis_off()
    figure.set_size_inches(WIDTH * columns, (min(1.5, max(ratios)) * WIDTH + ROOM) * rows)
    return save(figure, target)


def tracks_of(sources):
    """Yields the Tracks (arrays) of all episodes of files, with the duration of their ticks [s]."""
    for source in sources:
        tick = scene_of(source.file).tick
        for track in read_tracks(source.file).values():
            yield track, tick


def draw_separations(target, groups):
    """Draws the histogram of the distances to the nearest person. Returns the file; None if nobody has company."""
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
    axes[0, 0].set(xlabel='distance to the nearest person, centre to centre [m]', ylabel='share of all moments [%]',
                   xlim=(0, FARTHEST))
    axes[0, 0].legend()
    return save(figure, target)


def draw_speeds(target, groups):
    """Draws mean speed against density, with the standard deviation. Returns the file; None with only one density."""
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
    axes[0, 0].set(xlabel='people within 2 m [1/m²]', ylabel='speed [m/s]')
    axes[0, 0].set_ylim(bottom=0)
    axes[0, 0].legend()
    return save(figure, target)
