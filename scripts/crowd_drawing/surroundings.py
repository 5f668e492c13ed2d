"""Draws the surroundings of a crowd: maps, walls, areas where people enter and leave, queues and gates."""
from crowd_drawing.files import is_open
from matplotlib.lines import Line2D
from matplotlib.patches import Circle, Patch, Rectangle

SOURCE_COLOUR, SINK_COLOUR, GATE_COLOUR = '#8ecbf5', '#a5dba0', '#e07b00'


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
