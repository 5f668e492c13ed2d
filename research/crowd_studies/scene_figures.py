"""Panels of figures with scenes, paths, and perceptions of agents."""
import math

from matplotlib.patches import Circle, Wedge

from crowd_drawing.files import place_of, read_scene, read_walks
from crowd_drawing.picture import OBSTACLE_COLOUR, START_ALPHA, Picture, colours_of

CLASS_COLOURS = {1: '#e31a1c', 2: '0.6'}  # the inner radius is red in the thesis, the rest of the surroundings grey


def draw_scene(axes, scenario, trajectories, instance, colour=None, obstacle_colour=OBSTACLE_COLOUR):
    """Draws a scene with the complete paths of one instance. Returns the picture."""
    _, walks = read_walks(trajectories, instance)
    axes.set(xlabel='x [m]', ylabel='y [m]')
    picture = draw_moment(axes, read_scene(scenario, instance), walks, last_tick_of(walks), colour, with_starts=True,
                          obstacle_colour=obstacle_colour)
    picture.frame()
    return picture


def draw_perception(axes, scene, view, sectors, radii, limits):
    """Draws the perception of an agent. View: x, y [m] and heading [degrees] of the agent; sectors: the occupied
    sectors, drawn up to the radius of their class; radii: of the classes [m]; limits: of all sectors, relative to the
    heading [degrees]."""
    x, y, heading = view
    picture = Picture(axes)
    for obstacle in scene.obstacles:
        picture.disc(obstacle['position'], obstacle['radius'], facecolor='#d9d2e9', edgecolor='0.35', linewidth=0.8)
        picture.show(obstacle['position'], obstacle['radius'])
    for sector in sectors:
        axes.add_patch(Wedge((x, y), radii[sector.distance_class - 1], heading + sector.begin, heading + sector.end,
                             facecolor=CLASS_COLOURS[sector.distance_class], alpha=0.55, edgecolor='none', zorder=3))
    for limit in limits:
        angle = math.radians(heading + limit)
        axes.plot([x, x + radii[-1] * math.cos(angle)], [y, y + radii[-1] * math.sin(angle)], color='0.45',
                  linewidth=0.6, zorder=4)
    for distance_class, radius in enumerate(radii, 1):
        axes.add_patch(Circle((x, y), radius, fill=False, edgecolor=CLASS_COLOURS[distance_class], linewidth=1.2,
                              zorder=5))
    body = scene.agents[0]
    picture.disc((x, y), body['radius'], facecolor='#1f77b4', edgecolor='none', alpha=0.9, zorder=6)
    ahead = math.radians(heading)
    axes.annotate('', (x + 0.45 * math.cos(ahead), y + 0.45 * math.sin(ahead)), (x, y), zorder=7,
                  arrowprops={'arrowstyle': '-|>', 'color': 'black'})
    picture.show((x, y), radii[-1])
    return picture


def last_tick_of(walks):
    """Returns the tick of the last arrival, or of the end of the time."""
    return max(walk[-1][0] for walk in walks.values())


def draw_moment(axes, scene, walks, tick, colour=None, with_starts=False, with_paths=True, marked=None,
                obstacle_colour=OBSTACLE_COLOUR):
    """Draws all agents at a tick, with goals and paths up to this tick; an agent that has arrived is a circle at its
    end. Colour: one for all agents, or a list; the marked agent has a black ring. Without paths, only agents that have
    not left are drawn. Returns the picture, whose limits are not set yet."""
    picture = Picture(axes)
    for obstacle in scene.obstacles:
        centre = place_of(obstacle, tick * scene.tick)
        picture.disc(centre, obstacle['radius'], facecolor=obstacle_colour, edgecolor='0.35', linewidth=0.8)
        picture.show(centre, obstacle['radius'])
    for wall in scene.walls:
        picture.draw_wall(wall)
    if not isinstance(colour, list):
        colour = [colour] * len(scene.agents) if colour else colours_of(len(scene.agents))
    for agent, walk in sorted(walks.items()):
        if with_paths:
            draw_walker(picture, scene.agents[agent], walk, tick, colour[agent], with_starts)
        elif walk[-1][0] >= tick:
            place, radius = place_at(walk, tick), scene.agents[agent]['radius']
            picture.show(place, radius)
            picture.disc(place, radius, facecolor=colour[agent], edgecolor='none', alpha=0.8, zorder=7)
    if marked is not None:
        place = place_at(walks[marked], tick)
        picture.disc(place, 1.7 * scene.agents[marked]['radius'], fill=False, edgecolor='black', linewidth=1.8,
                     zorder=9)
    return picture


def place_at(walk, tick):
    """Returns the place of an agent at a tick, or the last place before it left."""
    return next(((x, y) for at, x, y in walk if at >= tick), walk[-1][1:])


def frame_alike(pictures):
    """Sets the same limits for all pictures, which include all of their contents. Returns width and height [m]."""
    for picture in pictures:
        picture.show([corner for other in pictures for corner in (other.low, other.high)])
    return [picture.frame() for picture in pictures][0]


def draw_walker(picture, body, walk, tick, colour, with_starts):
    radius = body['radius']
    picture.draw_goals(body['goals'], radius, colour)
    places = [(x, y) for _, x, y in walk]
    so_far = [(x, y) for at, x, y in walk if at <= tick]
    picture.show(places, radius)
    picture.axes.plot(*zip(*so_far), color=colour, linewidth=1.3, zorder=5)
    if with_starts:
        picture.disc(places[0], radius, facecolor=colour, edgecolor='none', alpha=START_ALPHA, zorder=4)
    has_left = walk[-1][0] < tick or with_starts
    style = {'fill': False, 'edgecolor': colour, 'linewidth': 1.2} if has_left else {
        'facecolor': colour, 'edgecolor': 'none', 'alpha': 0.8}
    picture.disc(so_far[-1], radius, zorder=7, **style)
