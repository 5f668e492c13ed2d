"""A crowd controller with robots, and listeners to their topics."""
import rospy
import support
from geometry_msgs.msg import Twist
from social_crowd.msg import RobotStates

# A robot ahead of a wall, and a person far away; 0.1 s ticks.
ROBOT = """
name: robot
duration: {duration}
goal_tolerance: 0.3
contact: solid
agents:
  - {{position: [0, 20], goal: [100, 20], speed: 0.5, radius: 0.25}}
walls:
  - [[5, -5], [5, 5]]
robots:
  - {{name: tug, position: [1, 0], heading: 0, radius: 0.3, max_speed: 1.0, max_rotation: 1.0, acceleration: 100,
     rotation_acceleration: 100{more}}}
"""


def command(speed, rotation=0.0):
    """Returns a command of a differential robot."""
    twist = Twist()
    twist.linear.x = speed
    twist.angular.z = rotation
    return twist


def scenario(duration=60, more=''):
    """Returns a scenario with a robot; `more` are keys of the robot, after a comma."""
    return ROBOT.format(duration=duration, more=more)


class RobotTestCase(support.CrowdTestCase):
    """A crowd controller with one robot, and a learner."""

    def start_all(self, text=None, learner=True, **parameters):
        """Starts the nodes and listens to the robots. The crowd is paused, unless `parameters` say something else."""
        self.states = self.listen('robots', RobotStates)
        if learner:
            self.start_learner()
        file = self.write('robot.yaml', scenario() if text is None else text)
        self.controller = self.start_controller(file, **dict({'paused': True}, **parameters))
        self.states.wait_connected()

    def step_robots(self, robots=(), commands=(), ticks=1, with_scan=False):
        """Calls ~step_robots. Returns the response."""
        return self.succeed('crowd_controller/step_robots', robots=list(robots), commands=list(commands), ticks=ticks,
                            with_scan=with_scan)

    def publisher(self, topic, message_type, name=None):
        """Returns a publisher on a topic of the test's name space that the controller is connected to."""
        publisher = rospy.Publisher(f'{self.namespace}/{topic}', message_type, queue_size=100, tcp_nodelay=True)
        self.addCleanup(publisher.unregister)
        support.wait_for(lambda: publisher.get_num_connections() > 0, f'a subscriber of {topic}')
        return publisher

    def commander(self):
        """Returns a publisher of commands."""
        return self.publisher('cmd_vel', Twist)

    def walk(self, ticks=1):
        """Walks a number of ticks. Returns the state of the robot after them."""
        response = self.step(ticks)
        return self.states.wait_at(response.episode, response.tick).robots[0]

    def send(self, publisher, message, count):
        """Publishes a command and waits until the controller has counted it as taken or refused."""
        publisher.publish(message)
        # The step that shows the count walks a tick.
        support.wait_for(lambda: commands_of(self.walk()) >= count, f'{count} commands counted')


def commands_of(state):
    """Returns the number of commands that arrived for a robot."""
    return state.commands_taken + state.commands_not_finite + state.commands_of_others


def poses_of(state):
    """Returns the number of poses that arrived for a robot."""
    return state.poses_taken + state.poses_not_finite + state.poses_backwards + state.poses_without_frame
