"""A robot among people as an environment with reset() and step(), in the conventions of Gymnasium."""
import numpy
import rospy
from geometry_msgs.msg import Twist
from social_crowd.srv import Reset, StepRobots
from std_srvs.srv import SetBool


class CrowdEnvError(RuntimeError):
    """A call of the crowd controller failed."""


def default_reward(before, after):
    """Returns by how much the way via the remaining goals became shorter [m], minus 1 in contact with people.

    Both arguments are messages RobotObservation, before and after a step. A goal counts as reached within its
    tolerance, so the way may become shorter there by up to twice the tolerance.
    """
    nearer = before.remaining_distance - after.remaining_distance
    return nearer - (1.0 if after.contacts else 0.0)


class CrowdEnv:
    """Drives one robot of a crowd controller, tick by tick.

    The controller is paused and walks only in step(), so that the same seed and actions give the same observations.
    An observation is a dict of numpy arrays: `goal` (x ahead, y left [m]; zeros without a goal), `velocity`
    (ahead [m/s], rotation [rad/s]) and `scan` (ranges [m], REP 117). A ROS node must have been initialised.
    """

    def __init__(self, robot='', ticks=1, reward=default_reward, timeout=10.0, controller='crowd_controller'):
        """Connects to the crowd controller.

        robot: its name; empty: the first one
        ticks: that one action holds
        reward: function of the messages RobotObservation before and after a step
        timeout: for the start of the controller [s]
        """
        self.robot = robot
        self.ticks = ticks
        self.reward = reward
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
        self._observed = None
        self._random = numpy.random.default_rng()

    def reset(self, *, seed=None, options=None):
        """Begins an episode. Returns the observation and a dict of information.

        With a seed, the scenario is drawn from that seed, and later episodes from it, too: the same calls give the same
        episodes. Without one, the scenario is drawn anew. `options` are not used.
        """
        if seed is not None:
            self._random = numpy.random.default_rng(seed)
        drawn = int(self._random.integers(2 ** 31)) if seed is None else seed
        self._call('reset', keep_seed=False, seed=drawn)
        response = self._step(None, 0)
        self._observed = self._own(response)
        return self._arrays(self._observed), self._info(response)

    def step(self, action):
        """Drives at (speed ahead [m/s], rotation [rad/s]), or (ahead, left, rotation) for a holonomic robot.

        Returns observation, reward, terminated (arrived, or in contact with people in this step), truncated (the
        episode is over) and a dict of information.
        """
        if self._observed is None:
            raise CrowdEnvError('call reset() first')
        before = self._observed
        response = self._step(action, self.ticks)
        after = self._own(response)
        terminated = bool(after.arrived or after.contacts)
        truncated = bool(response.done and not terminated)
        self._observed = None if terminated or truncated else after
        return self._arrays(after), self.reward(before, after), terminated, truncated, self._info(response)

    def close(self):
        """Lets the crowd walk on."""
        self._call('pause', data=False)
        self._services['step_robots'].close()

    def _call(self, name, **request):
        response = self._services[name](**request)
        if not response.success:
            raise CrowdEnvError(f'{name}: {response.message}')
        return response

    def _step(self, action, ticks):
        robots, commands = [], []
        if action is not None:
            if len(action) not in (2, 3):
                raise CrowdEnvError(f'action: expected 2 or 3 numbers, got {len(action)}')
            twist = Twist()
            twist.linear.x, *left, twist.angular.z = (float(value) for value in action)
            if left:
                twist.linear.y = left[0]
            robots, commands = [self.robot or self._observed.name], [twist]
        return self._call('step_robots', robots=robots, commands=commands, ticks=ticks, with_scan=True)

    def _own(self, response):
        for observed in response.observations:
            if not self.robot or observed.name == self.robot:
                return observed
        names = ', '.join(observed.name for observed in response.observations)
        raise CrowdEnvError(f"there is no robot '{self.robot}', only: {names}")

    @staticmethod
    def _arrays(observed):
        return {
            'goal': numpy.array([observed.goal.x, observed.goal.y]),
            'velocity': numpy.array([observed.twist.linear.x, observed.twist.angular.z]),
            'scan': numpy.array(observed.scan.ranges, dtype=numpy.float32),
        }

    @staticmethod
    def _info(response):
        return {'episode': response.episode, 'tick': response.tick}
