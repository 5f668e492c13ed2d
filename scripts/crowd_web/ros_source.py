"""The back end of the page with ROS: the crowd of a crowd_controller. It listens only while there is a page."""
import asyncio
import math

import numpy
from crowd_web.agent_states import AgentStates, tick_of
from crowd_web.page_source import (IN_CONTACT, PLACES, KnownAgents, PageSource, bounds_of, corners_of, frame_of, map_of,
                                   obstacles_of, scan_of, walls_of)
from crowd_web.ros_commands import RosCommands
from nav_msgs.msg import OccupancyGrid
from rosgraph.names import ns_join
from sensor_msgs.msg import LaserScan
from social_crowd.msg import ControllerStatus, DecisionValues, LearnerStatus, RobotStates, Scenario, Walls

SETTLING = 0.05  # [s] in which the messages that belong to a scene arrive


def read(kind, data):
    """Returns a deserialised message."""
    return kind().deserialize(data)


class RosSource(RosCommands, PageSource):
    """Shows topics of a crowd_controller."""
    BACK_END = 'ros'

    def __init__(self, graph, recordings=None):
        PageSource.__init__(self, recordings)
        self.graph = graph
        self.handles = []  # of the topics that it listens to
        self.mind_handle = None
        self.scan_handles = {}  # by name of the robot
        self.forget()

    def forget(self):
        """Forgets all messages, which are old when it listens again."""
        self.scenario = self.walls = self.grid = self.controller = self.states = self.vision = None
        self.scans = {}
        self.scene = self.status = self.latest_frame = self.shown_episode = None
        self.timer = None
        self.known = KnownAgents()

    def add(self, client):
        if not self.clients:
            self.listen()
        super().add(client)

    def remove(self, client):
        super().remove(client)
        if not self.clients:
            self.stop_listening()
        self.listen_to_minds()

    def listen(self):
        for topic, take in (('controller_status', self.take_status), ('scenario', self.take_scenario),
                            ('walls', self.take_walls), ('map', self.take_map), ('agents', self.take_agents),
                            ('robots', self.take_robots), ('learner_status', self.take_learner)):
            self.handles.append(self.graph.listen(topic, take))

    def stop_listening(self):
        for handle in [*self.handles, *self.scan_handles.values()]:
            self.graph.stop_listening(handle)
        self.handles, self.scan_handles = [], {}
        if self.timer is not None:
            self.timer.cancel()
        for throttle in (*self.throttles, self.statuses):
            throttle.cancel()
        self.forget()

    def take_status(self, data, _):
        self.controller = read(ControllerStatus, data)
        self.show_status()

    def show_status(self):
        status = self.controller
        self.statuses.offer({
            'playing': not status.paused, 'speed': status.real_time_factor, 'tick': status.tick, 'time': status.time,
            'walking': status.walking, 'arrived': status.arrived,
            'contacts': 0 if self.states is None else int(self.states.agents['in_contact'].sum()),
            'episode': status.episode, 'over': False})  # the next episode begins by itself

    def take_scenario(self, data, _):
        self.scenario = read(Scenario, data)
        self.listen_to_scans()
        self.scene_has_changed()

    def take_walls(self, data, _):
        self.walls = read(Walls, data)
        self.scene_has_changed()

    def take_map(self, data, _):
        grid = read(OccupancyGrid, data)
        origin = grid.info.origin
        yaw = 2 * math.atan2(origin.orientation.z, origin.orientation.w)
        cells = numpy.array(grid.data, 'i1')
        shown = numpy.where(cells < 0, 255, numpy.where(cells >= 65, 100, numpy.where(cells <= 25, 0, 255)))
        self.grid = None if not len(cells) else map_of(
            grid.info.width, grid.info.height, grid.info.resolution, (origin.position.x, origin.position.y, yaw), shown)
        self.scene_has_changed()

    def scene_has_changed(self):
        """Shows the scene anew, when the messages that belong together are there."""
        if self.timer is None:
            self.timer = asyncio.get_running_loop().call_later(SETTLING, self.show_scene)

    def show_scene(self):
        self.timer = None
        scenario = self.scenario
        if scenario is None or self.walls is None or self.walls.episode != scenario.episode or (
                scenario.has_map and self.grid is None):
            return
        states = self.states if self.states is not None and self.states.episode == scenario.episode else None
        known = known_at_start(scenario) if states is None else known_of(states.agents)
        obstacles = [(o.obstacle, o.position.x, o.position.y, o.radius)
                     for o in scenario.obstacles] if states is None else obstacle_rows(states)
        ends = [[getattr(wall, name) for name in wall.__slots__] for wall in self.walls.walls]  # `from` or `from_`
        rows = [(begin.x, begin.y, end.x, end.y) for begin, end in ends]
        grid = self.grid if scenario.has_map else None
        self.shown_episode = scenario.episode
        self.send_scene({
            'scenario': scenario.name, 'tick_duration': scenario.tick_duration,
            'bounds': bounds_of([known.goals, [(a.pose.x, a.pose.y) for a in scenario.agents], rows,
                                 [row[1:3] for row in obstacles], *([] if grid is None else [corners_of(grid)])]),
            'obstacles': obstacles_of(numpy.reshape(obstacles, (-1, 4))), 'walls': walls_of(self.walls.numbers, rows),
            'map': grid, 'robots': [{'name': robot.name, 'radius': robot.radius} for robot in scenario.robots]}, known)
        if states is not None:
            self.frames.offer(packed, states)

    def take_agents(self, data, _):
        if self.shown_episode != tick_of(data)[0]:
            self.states = AgentStates(data)  # for the scene that follows
            return
        self.frames.offer(self.frame, data)

    def frame(self, data):
        """Returns the frame of serialised AgentStates, and shows what else they have."""
        last, self.states = self.states, AgentStates(data)
        if self.states.episode != self.shown_episode:
            return None
        rows = obstacle_rows(self.states)
        if last is not None and not numpy.array_equal(rows, obstacle_rows(last)):
            self.obstacles.offer(self.states.tick, rows)
        self.agents.offer(known_of(self.states.agents))
        return packed(self.states)

    def take_robots(self, data, _):
        message = read(RobotStates, data)
        if message.episode == self.shown_episode:
            self.robots.offer(message.tick, [
                {'name': robot.name, 'pose': [robot.pose.x, robot.pose.y, robot.pose.theta],
                 'goal': [robot.goal.x, robot.goal.y] if robot.has_goal else None,
                 'scan': self.scans.get(robot.name)} for robot in message.robots])

    def listen_to_scans(self):
        """Listens to the scans of the robots of the scenario."""
        robots = {robot.name: robot.name_space for robot in self.scenario.robots}
        for name in set(self.scan_handles) - set(robots):
            self.graph.stop_listening(self.scan_handles.pop(name))
            self.scans.pop(name, None)
        for name in set(robots) - set(self.scan_handles):
            self.scan_handles[name] = self.graph.listen(ns_join(robots[name], 'scan'),
                                                        lambda data, _, name=name: self.take_scan(name, data))

    def take_scan(self, name, data):
        scan = read(LaserScan, data)
        self.scans[name] = scan_of(scan.angle_min, scan.angle_increment, scan.ranges)

    def take_learner(self, data, _):
        status = read(LearnerStatus, data)
        self.vision = status.vision_radius, status.max_neighbours

    async def selection_changed(self, agent):
        if agent is not None:
            await self.choose_agent(agent)
        self.listen_to_minds()

    def listen_to_minds(self):
        """The learner computes values only while somebody listens."""
        is_wanted = bool(self.selected())
        if is_wanted and self.mind_handle is None:
            self.mind_handle = self.graph.listen('decision_values', self.take_mind)
        elif not is_wanted and self.mind_handle is not None:
            self.graph.stop_listening(self.mind_handle)
            self.mind_handle = None

    def take_mind(self, data, _):
        values = read(DecisionValues, data)
        states = self.states
        at = [] if states is None else numpy.flatnonzero(states.agents['agent'] == values.agent)
        if values.episode != self.shown_episode or not len(at):
            return
        speed = float(states.agents['max_speed'][at[0]])
        self.minds.offer([{
            'agent': values.agent, 'tick': values.tick, 'chosen': values.chosen,
            'actions': [{'direction': move.direction, 'speed': round(move.speed_fraction * speed, PLACES),
                         'value': move.value, 'visits': move.visits} for move in values.actions],
            'neighbours': neighbours_of(states.agents, at[0], self.vision)}])


def packed(states):
    """Returns the frame of AgentStates."""
    agents = states.agents
    pose, velocity = agents['pose'], agents['velocity']
    return frame_of(states.tick, states.time, agents['agent'], pose[:, 0], pose[:, 1], pose[:, 2],
                    numpy.hypot(velocity[:, 0], velocity[:, 1]), agents['status'] + IN_CONTACT * agents['in_contact'])


def known_of(agents):
    return KnownAgents(agents['agent'], agents['radius'], agents['goal'][:, :2])


def known_at_start(scenario):
    return KnownAgents([agent.agent for agent in scenario.agents], [agent.radius for agent in scenario.agents],
                       [(agent.goal.x, agent.goal.y) for agent in scenario.agents])


def obstacle_rows(states):
    """Returns number, x, y, radius of each obstacle."""
    obstacles = states.obstacles
    return numpy.column_stack([obstacles['obstacle'], obstacles['position'][:, :2], obstacles['radius']])


def neighbours_of(agents, at, vision):
    """Returns the agents that one perceives by the vision of the learner, nearest rim first, but for what hides them.
    at: its index"""
    radius, most = vision or (0.0, 0)
    places = agents['pose'][:, :2]
    distances = numpy.hypot(*(places - places[at]).T) - agents['radius']
    distances[at] = numpy.inf
    distances[~numpy.isin(agents['status'], (0, 3))] = numpy.inf
    order = numpy.argsort(distances, kind='stable')[:most or None]
    return agents['agent'][order[distances[order] <= radius]].tolist()
