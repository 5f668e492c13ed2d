"""Scenes with what was walked in them, as panels of figures."""
from crowd_drawing.files import read_scene, read_walks
from crowd_drawing.motion import place_of
from crowd_drawing.picture import OBSTACLE_COLOUR, START_ALPHA, Picture, colours_of


def draw_scene(axes, scenario, trajectories, instance, colour=None):
    """A scene with the whole paths of one instance."""
    _, walks = read_walks(trajectories, instance)
    axes.set_xlabel('x [m]')
    axes.set_ylabel('y [m]')
    draw_moment(axes, read_scene(scenario, instance), walks, last_tick_of(walks), colour, with_starts=True).frame()


def last_tick_of(walks):
    """The tick at which the last one arrived, or time was up."""
    return max(walk[-1][0] for walk in walks.values())


def draw_moment(axes, scene, walks, tick, colour=None, with_starts=False, with_ways=True):
    """Everybody at a tick, with goals and the paths so far; who has arrived is a circle at its end. All of them have
    the colour, or each its own of a list. Without ways only who is still there is drawn. Returns the picture, whose
    limits are not set yet."""
    picture = Picture(axes)
    for obstacle in scene.obstacles:
        centre = place_of(obstacle, tick * scene.tick)
        picture.disc(centre, obstacle['radius'], facecolor=OBSTACLE_COLOUR, edgecolor='0.35', linewidth=0.8)
        picture.show(centre, obstacle['radius'])
    for wall in scene.walls:
        picture.draw_wall(wall)
    if not isinstance(colour, list):
        colour = [colour] * len(scene.agents) if colour else colours_of(len(scene.agents))
    for agent, walk in sorted(walks.items()):
        if with_ways:
            draw_walker(picture, scene.agents[agent], walk, tick, colour[agent], with_starts)
        elif walk[-1][0] >= tick:
            draw_body(picture, scene.agents[agent], walk, tick, colour[agent])
    return picture


def draw_body(picture, body, walk, tick, colour):
    place = next((x, y) for at, x, y in walk if at == tick)
    picture.show(place, body['radius'])
    picture.disc(place, body['radius'], facecolor=colour, edgecolor='none', alpha=0.8, zorder=7)


def frame_alike(pictures):
    """The same limits for all, so that everything is within each of them; returns width and height [m]."""
    for picture in pictures:
        for other in pictures:
            picture.show(other.low)
            picture.show(other.high)
    return [picture.frame() for picture in pictures][0]


def draw_walker(picture, body, walk, tick, colour, with_starts):
    radius = body['radius']
    picture.draw_goals(body['goals'], radius, colour)
    places = [(x, y) for _, x, y in walk]
    so_far = [(x, y) for at, x, y in walk if at <= tick]
    for place in places:
        picture.show(place, radius)
    picture.axes.plot(*zip(*so_far), color=colour, linewidth=1.3, zorder=5)
    if with_starts:
        picture.disc(places[0], radius, facecolor=colour, edgecolor='none', alpha=START_ALPHA, zorder=4)
    has_left = walk[-1][0] < tick or with_starts
    style = {'fill': False, 'edgecolor': colour, 'linewidth': 1.2} if has_left else {
        'facecolor': colour, 'edgecolor': 'none', 'alpha': 0.8}
    picture.disc(so_far[-1], radius, zorder=7, **style)
