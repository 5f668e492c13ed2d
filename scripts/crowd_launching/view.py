"""Scale with which RViz shows a whole scenario."""
VIEW = 900.0, 700.0  # [pixels] available in a window of the configuration's size
MARGIN = 1.0  # [m] around it
LEAST, MOST = 0.5, 100.0  # [pixels/m]


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
