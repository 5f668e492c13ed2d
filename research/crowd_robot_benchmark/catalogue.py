"""Scenarios, controllers and published figures of the benchmark of robots."""
SCENARIOS = ('robot_corridor_with', 'robot_corridor_against', 'robot_crossing', 'robot_overtaking', 'robot_door',
             'robot_corner', 'robot_circle_5', 'robot_circle_20', 'robot_circle_50', 'robot_hall', 'robot_queue',
             'robot_station')
# Robots that are run here: the controller of `evaluate --robot`, and the keys that change in the robots of a scenario.
ROBOTS = {
    'straight': ('straight', {}),
    'reactive': ('reactive', {}),
    'learned': ('learned', {}),
    'straight_stop': ('straight', {'yields': 'both'}),  # with protective stop
    'learned_stop': ('learned', {'yields': 'both'}),
}
PLACEMENTS = 20  # episodes of each scenario
ROS_PLACEMENTS = 5  # the same for DRIVEN

# CrowdNav's setting: a circle of 4 m, five people, bodies of 0.3 m, 1 m/s, 25 s.
CROWDNAV = 'robot_circle_5'
CROWDNAV_EPISODES = 500
VISIBLE, INVISIBLE = 'visible', 'invisible'
CROWDNAV_KEYS = {VISIBLE: {}, INVISIBLE: {'perceived': False}}
# Published results of ORCA as the robot among people that walk by ORCA: episodes that it reached its goal without a
# contact, episodes with a contact, and the mean time of the former [s].
CROWDNAV_ORCA = {VISIBLE: (500, 0, 10.02), INVISIBLE: (213, 284, 10.86)}
