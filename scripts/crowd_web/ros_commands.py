"""Commands of the page as calls of services of the crowd_controller."""
import rospy
from crowd_drawing.errors import InputError
from crowd_web.page_commands import heading_towards
from geometry_msgs.msg import Point, Pose2D, Vector3
from social_crowd.srv import (AddWallRequest, ChooseAgentRequest, ListScenariosRequest, LoadScenarioRequest,
                              RemoveAgentRequest, RemoveObstacleRequest, RemoveWallRequest, ResetRequest,
                              SetGoalRequest, SetRealTimeFactorRequest, SpawnAgentRequest, SpawnObstacleRequest,
                              StepRequest)
from std_msgs.msg import Int32
from std_srvs.srv import SetBoolRequest

CONTROLLER, MARKERS = 'crowd_controller', 'crowd_markers'  # names of nodes


class RosCommands:
    """Functions for the commands of a page, mixed into RosSource."""
    choice = None  # publisher of the chosen agent, where there is no node of markers

    async def ask(self, name, request):
        """Calls a service of the controller. Returns the response. Raises InputError if it is refused."""
        node = rospy.resolve_name(CONTROLLER) if self.controller is None else self.controller.node
        response = await self.graph.call(f'{node}/{name}', request)
        if not response.success:
            raise InputError(response.message)
        return response

    async def scenario_names(self):
        try:
            return (await self.ask('list_scenarios', ListScenariosRequest())).names
        except InputError:  # there is no controller yet
            return []

    async def do_play(self, _):
        await self.ask('pause', SetBoolRequest(False))

    async def do_pause(self, _):
        await self.ask('pause', SetBoolRequest(True))

    async def do_step(self, _, ticks):
        await self.ask('step', StepRequest(ticks))

    async def do_speed(self, _, factor):
        await self.ask('set_real_time_factor', SetRealTimeFactorRequest(factor))

    async def do_scenario(self, _, name):
        if name not in await self.scenario_names():
            raise InputError(f"there is no scenario '{name}'")
        await self.ask('load_scenario', LoadScenarioRequest(name))

    async def do_reset(self, _, seed):
        await self.ask('reset', ResetRequest(seed is None, seed or 0))

    async def do_add_agent(self, _, position, goal, radius, max_speed, heading):
        heading = heading_towards(position, goal) if heading is None else heading
        await self.ask('spawn_agent', SpawnAgentRequest(Pose2D(*position, heading), Point(*goal, 0), max_speed, radius))

    async def do_remove_agent(self, _, agent):
        await self.ask('remove_agent', RemoveAgentRequest(agent))

    async def do_set_goal(self, _, agent, goal):
        await self.ask('set_goal', SetGoalRequest(agent, Point(*goal, 0)))

    async def do_add_obstacle(self, _, position, radius):
        await self.ask('spawn_obstacle', SpawnObstacleRequest(Point(*position, 0), Vector3(), radius))

    async def do_remove_obstacle(self, _, obstacle):
        await self.ask('remove_obstacle', RemoveObstacleRequest(obstacle))

    async def do_add_wall(self, _, **ends):
        await self.ask('add_wall', AddWallRequest(Point(*ends['from'], 0), Point(*ends['to'], 0)))

    async def do_remove_wall(self, _, wall):
        await self.ask('remove_wall', RemoveWallRequest(wall))

    async def choose_agent(self, agent):
        """Chooses the agent of decision_values: by crowd_markers, or itself where there is none."""
        service = rospy.resolve_name(f'{MARKERS}/choose_agent')
        await self.graph.refresh()
        if service in self.graph.services:
            response = await self.graph.call(service, ChooseAgentRequest(agent))
            if not response.success:
                raise InputError(response.message)
            return
        if self.choice is None:
            self.choice = rospy.Publisher('chosen_agent', Int32, queue_size=10, latch=True)
        self.choice.publish(agent)
