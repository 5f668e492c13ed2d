"""How RViz shows a scenario: scale, and whether it draws in software."""
import glob

VIEW = 900.0, 700.0  # [pixels] available in a window of the configuration's size
MARGIN = 1.0  # [m] around it
LEAST, MOST = 0.5, 100.0  # [pixels/m]
GRAPHICS = '/dev/dri/*', '/dev/nvidia[0-9]*', '/dev/dxg'  # devices with which OpenGL draws in hardware


def draws_in_software(environment, devices=GRAPHICS):
    """Returns whether OpenGL draws without graphics hardware here, as far as that can be known."""
    forced = environment.get('LIBGL_ALWAYS_SOFTWARE', '').lower() in ('1', 'true', 'yes', 'y')
    return forced or not any(glob.glob(device) for device in devices)


def sides_of(scenario):
    """Returns width and height of the bounding box of agents, goals, obstacles and walls [m].

    Returns an empty list for a Scenario without any of them.
    """
    points = [point for agent in scenario.agents for point in (agent.pose, agent.goal)]
    points += [obstacle.position for obstacle in scenario.obstacles]
    points += [end for wall in scenario.walls for end in (wall.from_, wall.to)]  # `from` is a keyword of Python
    return [max(values) - min(values) for values in zip(*((point.x, point.y) for point in points))]


def scale_for(scenario):
    """Returns the scale [pixels/m] with which a whole Scenario is visible."""
    scales = [pixels / (side + 2 * MARGIN) for pixels, side in zip(VIEW, sides_of(scenario))]
    return min([MOST, *(max(LEAST, scale) for scale in scales)])
