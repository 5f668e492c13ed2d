"""Files of a user, which lines of the README name."""
import rosbag
import rospy
from geometry_msgs.msg import Point, Pose2D
from social_crowd.msg import AgentState, AgentStates, Scenario

MY_SCENARIO = '''
name: my
duration: 60
goal_tolerance: 0.3
agents:
  - {position: [0, 0], goal: [6, 0], speed: 1, radius: 0.25}
  - {position: [6, 1], goal: [0, 1], speed: 1, radius: 0.25}
'''
PEDSIM_SCENE = '''<?xml version="1.0" encoding="UTF-8"?>
<scenario>
  <obstacle x1="0" y1="0" x2="20" y2="0"/>
  <waypoint id="west" x="2" y="5" r="1.5"/>
  <waypoint id="east" x="18" y="5" r="2"/>
  <agent x="4" y="5" n="3" dx="2" dy="4" type="0">
    <addwaypoint id="west"/>
    <addwaypoint id="east"/>
  </agent>
</scenario>
'''
TICKS = 300


def obsmat():
    """Returns a recording of a person who walks for a minute, annotated every 6 frames (0.4 s)."""
    return ''.join(f'{6 * i} 7 {0.4 * i} 0 1.0 1.0 0 0\n' for i in range(150))


def write_bag(file):
    """Writes a bag of two agents who walk for 30 s."""
    with rosbag.Bag(file, 'w') as bag:
        messages = [('/scenario', Scenario(name='two', agents=agents_at(0)))]
        messages += [('/agents', AgentStates(tick=tick, agents=agents_at(tick))) for tick in range(TICKS)]
        for i, (topic, message) in enumerate(messages):
            bag.write(topic, message, rospy.Time(1000.0 + 0.1 * i))


def agents_at(tick):
    """Returns the states of the agents of the bag."""
    return [AgentState(agent=i, pose=Pose2D(0.05 * tick, i, 0.0), radius=0.25, goal=Point(20.0, i, 0.0))
            for i in range(2)]
