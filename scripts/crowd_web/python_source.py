"""The back end without ROS: a crowd of the Python module `social_crowd`, which walks while a page looks at it."""
import asyncio
import concurrent.futures
import pathlib
import types

import numpy
import social_crowd
from crowd_drawing.errors import InputError
from crowd_web.page_commands import heading_towards
from crowd_web.page_source import (IN_CONTACT, KnownAgents, PageSource, bounds_of, corners_of, frame_of, map_of,
                                   obstacles_of, scan_of, walls_of)

WALKING = 0  # status of an agent
LATEST = 0.5  # [s] by which ticks may be behind real time and still catch up


def table_of(scenario):
    """Returns the name of the Q-table with which demo.launch shows a scenario."""
    return 'human' if pathlib.Path(scenario).stem.startswith('place_') else 'anticipation'


def shown(robot):
    """Returns what pages see of a robot and its scan."""
    scan = robot['scan']
    return {'name': robot['name'], 'pose': robot['pose'], 'goal': robot['goal'],
            'scan': scan_of(scan['first_angle'], scan['increment'], scan['ranges'].tolist())}


class PythonSource(PageSource):
    """Walks one crowd for all pages. The crowd is used in one thread of its own."""
    BACK_END = 'python'

    def __init__(self, scenario, table=None, seed=1, threads=1, recordings=None):
        super().__init__(recordings)
        self.table, self.threads = table, threads
        self.scenario, self.seed, self.episode = scenario, seed, 0
        self.crowd = self.make(scenario, seed, 0)
        self.view = None  # what pages see of the crowd
        self.speed, self.is_playing = 1.0, False
        self.changed = asyncio.Event()  # by a command, or there is a page
        self.thread = concurrent.futures.ThreadPoolExecutor(1)

    def make(self, scenario, seed, episode):
        return social_crowd.Crowd(scenario, self.table or table_of(scenario), seed=seed, episode=episode,
                                  threads=self.threads)

    async def scenario_names(self):
        return social_crowd.Scenario.names()

    async def ask(self, act, *arguments):
        """Returns what a function returns in the thread of the crowd. Raises InputError if it is refused."""
        try:
            return await asyncio.get_running_loop().run_in_executor(self.thread, act, *arguments)
        except social_crowd.CrowdError as error:
            raise InputError(str(error)) from None

    def add(self, client):
        super().add(client)
        self.changed.set()

    async def run_forever(self):
        """Walks until it is cancelled."""
        loop = asyncio.get_running_loop()
        due = loop.time()
        while True:
            if not (self.is_playing and self.clients):
                self.changed.clear()
                await self.changed.wait()
                due = loop.time()
                continue
            await self.walk()
            due = max(due + self.view.tick_duration / self.speed, loop.time() - LATEST) if self.speed else loop.time()
            await asyncio.sleep(due - loop.time())

    async def walk(self):
        """Walks a tick, and shows the world after it."""
        def act(agents):
            self.crowd.step()
            return self.look(agents)
        self.show(await self.ask(act, self.selected()))

    async def edit(self, act, shows_scene=True):
        """Changes the world between two ticks."""
        await self.ask(act)
        await self.show_scene() if shows_scene else self.show(await self.ask(self.look, self.selected()))

    def look(self, agents=()):
        """Returns a copy of what pages see, with the minds of some agents. In the thread of the crowd."""
        crowd = self.crowd
        view = types.SimpleNamespace(
            tick=crowd.tick, time=crowd.time, tick_duration=crowd.tick_duration, is_over=crowd.is_over,
            robots=[dict(robot, scan=crowd.scan(i)) for i, robot in enumerate(crowd.robots)],
            obstacles=crowd.obstacles, arrived=crowd.arrived,
            minds=[dict(mind, agent=agent, tick=crowd.tick) for agent, mind in (
                (agent, crowd.mind(agent)) for agent in agents) if mind])
        for name in ('ids', 'positions', 'headings', 'velocities', 'statuses', 'in_contact', 'goals', 'radii'):
            setattr(view, name, getattr(crowd, name).copy())
        return view

    def show(self, view):
        """Sends what there is to see."""
        last, self.view = self.view, view
        if view.is_over:
            self.is_playing = False
        self.frames.offer(packed, view)
        self.show_status()
        self.agents.offer(KnownAgents(view.ids, view.radii, view.goals))
        if view.robots:
            self.robots.offer(view.tick, view.robots)
        if last is not None and not numpy.array_equal(view.obstacles, last.obstacles):
            self.obstacles.offer(view.tick, view.obstacles)
        if view.minds:
            self.minds.offer(view.minds)

    def send_robots(self, tick, robots):
        super().send_robots(tick, [shown(robot) for robot in robots])  # not in each tick

    def show_status(self):
        view = self.view
        self.statuses.offer({
            'playing': self.is_playing, 'speed': self.speed, 'tick': view.tick, 'time': view.time,
            'walking': int((view.statuses == WALKING).sum()), 'arrived': view.arrived,
            'contacts': int(view.in_contact.sum()), 'episode': self.episode, 'over': view.is_over})

    async def show_scene(self):
        """Sends the scene as it is now, then the agents in it."""
        def act():
            return self.look(self.selected()), self.crowd.walls, self.crowd.wall_ids.tolist(), self.crowd.map
        view, walls, wall_ids, grid = await self.ask(act)
        grid = None if grid is None else map_of(**grid)
        self.send_scene({
            'scenario': pathlib.Path(self.scenario).stem, 'tick_duration': view.tick_duration,
            'bounds': bounds_of([view.positions, view.goals, walls, view.obstacles[:, 1:3],
                                 *([] if grid is None else [corners_of(grid)])]),
            'obstacles': obstacles_of(view.obstacles),
            'walls': walls_of(wall_ids, walls), 'map': grid,
            'robots': [{'name': robot['name'], 'radius': robot['radius']} for robot in view.robots]
        }, KnownAgents(view.ids, view.radii, view.goals))
        self.view = None
        self.show(view)

    async def begin(self, scenario, seed, episode):
        """Begins an episode."""
        self.crowd = await self.ask(self.make, scenario, seed, episode)
        self.scenario, self.seed, self.episode = scenario, seed, episode
        await self.show_scene()

    async def selection_changed(self, _):
        self.show(await self.ask(self.look, self.selected()))

    async def do_play(self, _):
        if self.view.is_over:
            await self.begin(self.scenario, self.seed, self.episode + 1)
        self.is_playing = True
        self.changed.set()
        self.show_status()

    async def do_pause(self, _):
        self.is_playing = False
        self.show_status()

    async def do_step(self, _, ticks):
        if self.is_playing:
            raise InputError('expected a pause before')
        if self.view.is_over:
            raise InputError('the episode is over')
        for _ in range(ticks):
            await self.walk()
            if self.view.is_over:
                break

    async def do_speed(self, _, factor):
        self.speed = factor
        self.show_status()

    async def do_scenario(self, _, name):
        if name not in await self.scenario_names():
            raise InputError(f"there is no scenario '{name}'")
        await self.begin(name, self.seed, 0)

    async def do_reset(self, _, seed):
        await self.begin(self.scenario, self.seed if seed is None else seed, 0)

    async def do_add_agent(self, _, position, goal, radius, max_speed, heading):
        heading = heading_towards(position, goal) if heading is None else heading
        await self.edit(lambda: self.crowd.spawn_agent(position, goal, heading, max_speed, radius), False)

    async def do_remove_agent(self, _, agent):
        await self.edit(lambda: self.crowd.remove_agent(agent), False)

    async def do_set_goal(self, _, agent, goal):
        await self.edit(lambda: self.crowd.set_goal(agent, goal), False)

    async def do_add_obstacle(self, _, position, radius):
        await self.edit(lambda: self.crowd.add_obstacle(position, radius))

    async def do_remove_obstacle(self, _, obstacle):
        await self.edit(lambda: self.crowd.remove_obstacle(obstacle))

    async def do_add_wall(self, _, **ends):
        await self.edit(lambda: self.crowd.add_wall(ends['from'], ends['to']))

    async def do_remove_wall(self, _, wall):
        await self.edit(lambda: self.crowd.remove_wall(wall))


def packed(view):
    """Returns the frame of a view."""
    return frame_of(view.tick, view.time, view.ids, view.positions[:, 0], view.positions[:, 1], view.headings,
                    numpy.hypot(view.velocities[:, 0], view.velocities[:, 1]),
                    view.statuses + IN_CONTACT * view.in_contact)
