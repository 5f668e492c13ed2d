"""Draws the paths of the agents in a recorded episode."""
import sys

from crowd_drawing.errors import InputError
from crowd_drawing.files import find_scenario, read_scene, read_walks
from crowd_drawing.picture import PATH_OF_MOMENT, ROBOT_COLOUR, Picture, colours_of, draw_surroundings, mark_of
from crowd_experiments.arguments import at_least_zero, parser_of, whole
from crowd_recordings.formats import recorded_people
from crowd_recordings.robot_log import is_robot_log, read_robot_log

EXAMPLES = '''examples:
  rosrun social_crowd evaluate --q-table human --trajectories recordings place_corner
  rosrun social_crowd plot_paths --trajectories recordings/place_corner.csv --scenario place_corner --output paths.png
  rosrun social_crowd plot_paths --trajectories recordings/circle6.csv --scenario circle6 --moment 6 --output 6s.png
  rosrun social_crowd evaluate --q-table anticipation --robot reactive --robot-log door.jsonl \\
      robot_door
  rosrun social_crowd plot_paths --trajectories door.jsonl --scenario robot_door --output door.png'''


def draw(scene, walks, robots, file, title, moment):
    """Draws a scene with the paths of its agents, or the bodies at a moment [s], if it is not None. `robots`: those of
    its robots."""
    picture = Picture()
    last_tick = max(walk[-1][0] for walk in [*walks.values(), *robots])
    if moment is not None and moment > last_tick * scene.tick:
        print(f'plot_paths: --moment {moment:g}: the recording ends at {last_tick * scene.tick:g} s', file=sys.stderr)
    draw_surroundings(picture, scene, last_tick * scene.tick if moment is None else moment)
    for obstacle in scene.obstacles:
        picture.draw_obstacle(obstacle, last_tick * scene.tick)
    for _, track, radius in recorded_people(scene):
        picture.draw_recorded(track, radius, last_tick * scene.tick, moment)
    colours = colours_of(max(max(walks, default=-1) + 1, len(scene.agents)))
    people = [(agent, walk, scene.radius_of(agent), colours[agent]) for agent, walk in sorted(walks.items())]
    for agent, walk, radius, colour in people + [(None, walk, robot['radius'], ROBOT_COLOUR)
                                                 for walk, robot in zip(robots, scene.robots)]:
        if moment is not None:
            picture.draw_moment(walk, round(moment / scene.tick), round(PATH_OF_MOMENT / scene.tick), radius, colour)
            continue
        if agent is not None and agent < len(scene.agents):
            goals, mirror = scene.agents[agent]['goals'], scene.agents[agent]['mirror']
            if mirror is not None:
                goals = [(2 * mirror[0] - walk[0][1], 2 * mirror[1] - walk[0][2])]
            picture.draw_goals(goals, radius, colour)
        picture.draw_walk(walk, radius, max(1, round(1.0 / scene.tick)), colour)
    picture.further_entries += [mark_of('robot', ROBOT_COLOUR, 7)] if robots else []
    picture.add_legend(scene, moment is not None)
    picture.save(file, title)


def main(words=None):
    parser = parser_of('plot_paths', __doc__, EXAMPLES)
    parser.add_argument('--trajectories', required=True, metavar='FILE',
                        help='recorded episodes: CSV, or a log of `evaluate --robot-log`')
    parser.add_argument('--scenario', required=True, metavar='SCENARIO',
                        help='scenario of the episodes: a file, or a name in config/scenarios')
    parser.add_argument('--instance', type=whole, metavar='N', help='number of the episode (default: the first)')
    parser.add_argument('--moment', type=at_least_zero, metavar='S',
                        help='draw the people as they are at this time [s], with their last steps')
    parser.add_argument('--output', required=True, metavar='FILE', help='picture, such as paths.png or paths.pdf')
    parser.add_argument('--title', help="title of the picture (default: the scenario's name)")
    arguments = parser.parse_args(words)
    robots = []
    if is_robot_log(arguments.trajectories):
        log = read_robot_log(arguments.trajectories, arguments.instance)
        instance, walks, robots = log.episode, log.walks, [[row[:3] for row in way] for way in log.robots]
    else:
        instance, walks = read_walks(arguments.trajectories, arguments.instance)
    scene = read_scene(find_scenario(arguments.scenario), instance)
    if max(walks, default=-1) >= len(scene.agents) and not scene.population.source_areas:
        raise InputError(f'{arguments.trajectories}: instance {instance} has an agent {max(walks)}, but '
                         f'{scene.place} has {len(scene.agents)} agents, counted from 0')
    draw(scene, walks, robots, arguments.output, arguments.title or scene.name, arguments.moment)
    places = [*(body['goals'] or body['mirror'] for body in scene.agents),
              *(obstacle['position'] for obstacle in scene.obstacles)]
    if arguments.moment is None and not all(places):
        print('plot_paths: goals or obstacles that were drawn at random are not in the picture; `evaluate --scenes '
              'DIR` writes a scenario file with the drawn values, for the option --scenario', file=sys.stderr)
