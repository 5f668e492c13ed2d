"""A robot among the people of a crowd controller as an environment of Gymnasium, through ROS."""
import numpy
import rospy
from geometry_msgs.msg import Twist
from social_crowd.checks import whole_number
from social_crowd.errors import CrowdError
from social_crowd.observations import PERSON, Observation
from social_crowd.rewards import progress_reward
from social_crowd.robot_env import RobotEnv, no_more, tick_of
from social_crowd.robot_task import rounded
from social_crowd.srv import Reset, StepRobots
from std_srvs.srv import SetBool


class CrowdEnvError(CrowdError, RuntimeError):
    """A call of the crowd controller failed."""


class CrowdEnv(RobotEnv):
    """Drives one robot of a crowd controller. The interface is that of Env, and gymnasium.Env (docs/python.md).

    The controller is paused and walks only in step(), so that the same seed and actions give the same observations as
    those of Env, bit for bit. A ROS node must have been initialised.
    """

    def __init__(self, robot='', ticks=1, reward=progress_reward, timeout=10.0, controller='crowd_controller', *,
                 observation='scan', action='twist', contact_ends=True, render_mode=None):
        """Connects to the crowd controller. Other arguments are those of Env.

        timeout: for the start of the controller [s]
        """
        backend = RosRobot(robot, whole_number('ticks', ticks, least=1), Observation.of(observation), timeout,
                           controller)
        super().__init__(backend, observation=observation, action=action, reward=reward, contact_ends=contact_ends,
                         render_mode=render_mode)

    def close(self):
        """Lets the crowd walk on."""
        self._task.backend.close()

    def _begin(self, scenario, seed, options):
        no_more(options, ())
        self._seed = seed
        self._task.backend.begin([(0, scenario, seed, 0, 0)])

    def _info(self):
        return {'episode_number': self._task.backend.episode, 'tick': tick_of(self._task), 'seed': self._seed}


class RosRobot:
    """The backend of CrowdEnv, see robot_task.py: the services of a crowd controller."""

    is_batch = False
    scenario_count = 1

    def __init__(self, robot, ticks, observation, timeout, controller):
        self.episode = None  # its number
        self._name = robot
        self._ticks = ticks
        self._observation = observation
        self._services = {}
        for name, kind in (('pause', SetBool), ('reset', Reset), ('step_robots', StepRobots)):
            service = rospy.resolve_name(f'{controller}/{name}')
            try:
                rospy.wait_for_service(service, timeout)
            except rospy.ROSException:
                raise CrowdEnvError(f'no service {service} within {timeout} s: '
                                    'is the crowd controller running?') from None
            self._services[name] = rospy.ServiceProxy(service, kind, persistent=name == 'step_robots')
        self._call('pause', data=True)
        self.robot = None
        self.arrays = {}
        self._observe([], [], 0)

    def begin(self, starts):
        """Begins the first episode of a seed."""
        (_, _, seed, _, _), = starts
        self._call('reset', keep_seed=False, seed=seed)
        self._observe([], [], 0)

    def step(self, commands):
        """Walks a step."""
        twist = Twist()
        twist.linear.x, twist.linear.y, twist.angular.z = map(float, commands[0])
        self._observe([self.robot['name']], [twist], self._ticks)

    def result(self, _element):
        """Returns the metrics by name."""
        result = self._observed.result[0]
        metrics = fields_of(result)
        del metrics['robot']
        metrics['goals'] = [fields_of(goal) for goal in result.goals]
        return metrics

    def scene(self, _element):
        """Returns positions and radii of the people that were observed, and no walls."""
        x, y, heading = self.arrays['pose'][0]
        c, s = numpy.cos(heading), numpy.sin(heading)
        people = self._observed.people
        positions = [(x + c * one.x - s * one.y, y + s * one.x + c * one.y) for one in people]
        return numpy.array(positions).reshape(-1, 2), numpy.array([one.radius for one in people]), numpy.empty((0, 4))

    def close(self):
        """Lets the crowd walk on."""
        self._call('pause', data=False)
        self._services['step_robots'].close()

    def _call(self, name, **request):
        response = self._services[name](**request)
        if not response.success:
            raise CrowdEnvError(f'{name}: {response.message}')
        return response

    def _observe(self, robots, commands, ticks):
        of = self._observation
        response = self._call('step_robots', robots=robots, commands=commands, ticks=ticks, with_scan=True,
                              with_people=bool(of.max_people), with_result=ticks > 0)
        self._observed = self._own(response)
        robot = description_of(self._observed)
        if self.robot is not None and rounded(robot) != rounded(self.robot):
            raise CrowdEnvError(f"the robot {self.robot['name']!r} has changed since the environment was made: "
                                'make a new one')
        self.robot = robot
        self.episode = response.episode
        self._write(response)

    def _own(self, response):
        for observed in response.observations:
            if not self._name or observed.name == self._name:
                return observed
        names = ', '.join(observed.name for observed in response.observations)
        if not names:
            raise CrowdEnvError('the scenario has no robot')
        raise CrowdEnvError(f"there is no robot '{self._name}', only: {names}")

    def _write(self, response):
        """Writes what the robot knows, as RobotBatch does."""
        of = self._observed
        arrays = {
            'pose': numpy.array([[of.pose.x, of.pose.y, of.pose.theta]]),
            'twist': numpy.array([[of.twist.linear.x, of.twist.linear.y, of.twist.angular.z]]),
            'goal': numpy.array([[of.goal.x, of.goal.y]]),
            'remaining_distance': numpy.array([of.remaining_distance]),
            'clearance': numpy.array([of.clearance]),
            'contacts': numpy.array([len(of.contacts)], numpy.uint32),
            'contacts_by_robot': numpy.array([len(of.contacts_by_robot)], numpy.uint32),
            'contacts_by_person': numpy.array([len(of.contacts_by_person)], numpy.uint32),
            'has_goal': numpy.array([of.has_goal], bool),
            'arrived': numpy.array([of.arrived], bool),
            'blocked': numpy.array([of.blocked], bool),
            'over': numpy.array([response.done], bool),
            'tick': numpy.array([response.tick], numpy.uint64),
            'scan': numpy.array([of.scan.ranges], numpy.float32),
        }
        most = self._observation.max_people
        people = of.people[:most]
        arrays['people_count'] = numpy.array([len(people)], numpy.uint32)
        if most > 0:
            arrays['people'] = numpy.zeros((1, most, PERSON))
            for row, one in zip(arrays['people'][0], people):
                row[:] = one.x, one.y, one.velocity_x, one.velocity_y, one.radius
        self.arrays = arrays


def fields_of(message):
    """Returns the fields of a message by name."""
    return {name: getattr(message, name) for name in message.__slots__}


def description_of(observed):
    """Returns the description of a robot, as RobotBatch has it."""
    scan = observed.scan
    return {'name': observed.name, 'drive': observed.drive, 'max_speed': observed.max_speed,
            'max_rotation': observed.max_rotation, 'radius': observed.radius, 'rays': len(scan.ranges),
            'first_angle': scan.angle_min, 'angle_increment': scan.angle_increment, 'min_range': scan.range_min,
            'max_range': scan.range_max}
