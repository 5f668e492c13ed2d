"""Records the results of robots that nodes drive, see scripts/record_robots."""
import math
import threading
import time

import rospy
from crowd_launching.program import end_launch
from social_crowd.msg import EpisodeResult, RobotResult, RobotStates
from social_crowd.srv import Reset

PEOPLE = {'people_compared': '0', 'people_delay': 'nan', 'people_detour': 'nan'}  # needs a second run without robots
LONG = 10.0  # [s] between two warnings
AFTER_PEOPLE = 'navigation'


def columns():
    """Returns the names of the columns, which are those of `evaluate --robots-csv`."""
    fields = [name for name in RobotResult.__slots__ if name not in ('robot', 'goals')]
    place = fields.index(AFTER_PEOPLE)
    return ['episode', 'scenario', 'robot', *fields[:place], *PEOPLE, *fields[place:]]


def row_of(result, robot):
    values = {**PEOPLE, 'episode': str(result.instance), 'scenario': result.scenario, 'robot': robot.robot}
    return [values[name] if name in values else text_of(getattr(robot, name)) for name in columns()]


def text_of(value):
    """Returns a number that is read as the same number; 1 and 0 for True and False; a text as it is."""
    if isinstance(value, str):
        return value
    return repr(value) if isinstance(value, float) else str(int(value))


class Recorder:
    """Writes a row for each robot at the end of an episode; ends the launch after ~episodes.

    With ~restart the crowd controller is reset when all robots were commanded, so that the time in which their nodes
    start is not part of the first episode.
    """

    def __init__(self, file):
        self.file = file
        self.write(columns())
        self.left = rospy.get_param('~episodes', 0)  # 0: no limit
        self.is_done = threading.Event()
        self.episode = None  # the present one
        self.waiting = []  # names of robots without a command
        self.first = None if rospy.get_param('~restart', False) else 0  # number of the first episode to record
        self.is_driven = threading.Event()
        self.subscribers = [
            rospy.Subscriber('robots', RobotStates, self.note_commands, queue_size=100),
            rospy.Subscriber('episode_results', EpisodeResult, self.take, queue_size=100)]

    def write(self, cells):
        """Writes a line immediately, as the node may be stopped after it."""
        self.file.write(','.join(cells) + '\n')
        self.file.flush()

    def note_commands(self, states):
        """Notes the number of the episode, and whether all robots were commanded in it, or will never be."""
        self.episode = states.episode
        self.waiting = [robot.name for robot in states.robots if robot.commands_taken == 0
                        and robot.navigation != 'crashed']
        if not self.waiting:
            self.is_driven.set()
            if self.first is not None:
                self.subscribers[0].unregister()

    def take(self, result):
        if self.first is None or result.episode < self.first or self.is_done.is_set():
            return
        for robot in result.robots:
            self.write(row_of(result, robot))
        self.left -= 1
        if self.left == 0:
            self.is_done.set()

    def run(self):
        """Restarts the episodes if that is wanted, then records until the node is shut down or all is recorded."""
        if self.first is None:
            while not wait_for(self.is_driven, LONG) and not rospy.is_shutdown():
                rospy.logwarn('waiting for the first command of %s', ', '.join(self.waiting) or 'the robots')
            if rospy.is_shutdown():
                return
            self.restart()
        wait_for(self.is_done)
        if self.is_done.is_set():
            end_launch()

    def restart(self):
        """Restarts with the first episode, of which no result can have come before the answer of the controller."""
        rospy.wait_for_service('crowd_controller/reset')
        self.first = self.episode + 1
        answer = rospy.ServiceProxy('crowd_controller/reset', Reset)(keep_seed=True)
        if not answer.success:
            raise rospy.ROSException('crowd_controller/reset: ' + answer.message)


def wait_for(event, seconds=math.inf):
    """Waits for an event, or the shutdown of the node, at most this long. Returns whether the event has come."""
    end = time.monotonic() + seconds
    while not event.wait(0.1) and not rospy.is_shutdown() and time.monotonic() < end:
        pass
    return event.is_set()


def main():
    rospy.init_node('record_robots')
    name = rospy.get_param('~file', '')
    try:
        with open(name, 'w', encoding='utf-8') as file:
            Recorder(file).run()
    except rospy.ROSInterruptException:
        pass
    except OSError as error:
        rospy.logfatal('~file: %s', error)
        return 1
    except (rospy.ROSException, rospy.ServiceException) as error:
        rospy.logfatal('%s', error)
        return 1
    return 0
