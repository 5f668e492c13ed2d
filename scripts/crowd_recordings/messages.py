"""The messages of a recorded crowd, as crowd_controller publishes them."""
import math

import numpy
from crowd_drawing.maps import OCCUPIED_COLOUR, UNKNOWN_COLOUR
from crowd_drawing.motion import place_of
from geometry_msgs.msg import Point, Pose2D, Pose, Quaternion, Vector3
from nav_msgs.msg import MapMetaData, OccupancyGrid
from social_crowd.msg import AgentState, AgentStates, ObstacleState, Scenario, Wall
from std_msgs.msg import Header

FRAME = 'map'
LONGEST_TICK = 0.1  # [s] between two messages; recordings with fewer frames are interpolated
OCCUPIED, FREE, UNKNOWN = 100, 0, -1


class Messages:
    """Makes the messages of a recording. People are numbered from 0 in the order in which they appear; the list in a
    message contains those who have appeared so far. `names`: their numbers in the file, by these numbers."""

    def __init__(self, name, scene, tracks, frame_duration):
        self.name, self.scene = name, scene
        self.names = sorted(tracks, key=lambda person: (tracks[person].times[0], person))
        self.tracks = [tracks[person] for person in self.names]
        self.tick_duration = frame_duration / math.ceil(frame_duration / LONGEST_TICK - 1e-9)
        self.first = self.tracks[0].times[0]
        last = max(track.times[-1] for track in self.tracks)
        self.last_tick = round((last - self.first) / self.tick_duration)

    def scenario(self, episode, stamp):
        """Returns the Scenario of an episode, with all people at their first places, so that a view has all."""
        people = [self.agent(number, track, track.times[0], False) for number, track in enumerate(self.tracks)]
        return Scenario(header=Header(stamp=stamp, frame_id=FRAME), episode=episode, name=self.scene.name or self.name,
                        instance=episode, tick_duration=self.tick_duration, max_ticks=self.last_tick,
                        agents=people, obstacles=self.obstacles(0),
                        walls=[wall_of(wall) for wall in self.scene.walls])

    def states(self, episode, tick, stamp):
        """Returns the AgentStates of a tick."""
        return AgentStates(header=Header(stamp=stamp, frame_id=FRAME), episode=episode, tick=tick,
                           time=tick * self.tick_duration, agents=self.agents(tick), obstacles=self.obstacles(tick))

    def time_of(self, tick):
        """Returns the time of a tick in the recording [s], whose first tick may be later than 0."""
        return self.first + tick * self.tick_duration

    def agents(self, tick):
        """Returns the states of all people who have appeared by a tick."""
        time = self.time_of(tick)
        soon = 0.5 * self.tick_duration  # times are multiples of the tick up to rounding
        return [self.agent(number, track, time, time > track.times[-1] + soon)
                for number, track in enumerate(self.tracks) if track.times[0] <= time + soon]

    def agent(self, number, track, time, has_left):
        """Returns the state of a person at a time [s]."""
        (x, y), before = track.place_at(time), track.place_at(time - self.tick_duration)
        goal = track.places[-1]
        state = AgentState(agent=number, pose=Pose2D(x, y, track.heading_at(time)), goal=Point(goal[0], goal[1], 0),
                           radius=self.scene.radius_of(self.names[number]),
                           status=AgentState.ARRIVED if has_left else AgentState.WALKING)
        state.velocity = Vector3((x - before[0]) / self.tick_duration, (y - before[1]) / self.tick_duration, 0)
        return state

    def obstacles(self, tick):
        """Returns the states of the obstacles whose place is known."""
        time = self.time_of(tick)
        known = [obstacle for obstacle in self.scene.obstacles if obstacle['position'] is not None]
        return [ObstacleState(obstacle=number, radius=obstacle['radius'], position=Point(*place_of(obstacle, time), 0))
                for number, obstacle in enumerate(known)]


def wall_of(ends):
    """Returns the message of a wall."""
    return Wall(*(Point(x, y, 0) for x, y in ends))


def grid_of(floor, stamp):
    """Returns the map of a scene, a MapPicture, as an OccupancyGrid; its first row is the lowest."""
    rows = floor.pixels[::-1]
    cells = numpy.full(rows.shape[:2], FREE, dtype=numpy.int8)
    cells[(rows == OCCUPIED_COLOUR).all(axis=2)] = OCCUPIED
    cells[(rows == UNKNOWN_COLOUR).all(axis=2)] = UNKNOWN
    x, y, yaw = floor.origin
    origin = Pose(Point(x, y, 0), Quaternion(0, 0, math.sin(yaw / 2), math.cos(yaw / 2)))
    return OccupancyGrid(Header(stamp=stamp, frame_id=FRAME),
                         MapMetaData(stamp, floor.resolution, cells.shape[1], cells.shape[0], origin),
                         cells.ravel().tolist())
