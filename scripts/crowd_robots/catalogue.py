"""Scenarios, controllers and published figures of the benchmark of robots."""
SCENARIOS = ('robot_corridor_with', 'robot_corridor_against', 'robot_crossing', 'robot_overtaking', 'robot_door',
             'robot_corner', 'robot_circle_5', 'robot_circle_20', 'robot_circle_50', 'robot_hall', 'robot_queue',
             'robot_station')
CONTROLLERS = ('straight', 'reactive', 'learned')  # of `evaluate --robot`
PLACEMENTS = 20  # episodes of each scenario

# CrowdNav's setting: a circle of 4 m, five people, bodies of 0.3 m, 1 m/s, 25 s.
CROWDNAV = 'robot_circle_5'
CROWDNAV_EPISODES = 500
VISIBLE, INVISIBLE = 'visible', 'invisible'
# Published results of ORCA as the robot among people that walk by ORCA: episodes that it reached its goal without a
# contact, episodes with a contact, and the mean time of the former [s].
CROWDNAV_ORCA = {VISIBLE: (500, 0, 10.02), INVISIBLE: (213, 284, 10.86)}
