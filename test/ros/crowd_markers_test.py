#!/usr/bin/python3
"""The node crowd_markers: messages written by hand, and the markers that RViz would show."""
import math
import os
import subprocess
import unittest

import roslib.packages
import rospy
import rostest
from geometry_msgs.msg import Point, Pose2D
from picturing import Picture, agent_at, fills, sectors_of
from social_crowd.msg import (AgentPerception, AgentState, AgentStates, LearnerStatus, ObstacleState, Neighbour,
                              Perceptions, RobotState, RobotStates, Scenario, Wall)
from support import PATIENCE, in_package, wait_for
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import Marker

PACKAGE = 'social_crowd'
NODE = 'crowd_markers'
KINDS = {'bodies', 'headings', 'goals', 'paths', 'obstacles', 'walls', 'radii', 'sectors', 'robots'}
PARTS = 3  # markers of a figure
COLLISION_RADIUS, VISION_RADIUS = 0.6, 1.5  # [m]
MODEL = f'''state_set: {{type: %s, collision_radius: {COLLISION_RADIUS}, vision_radius: {VISION_RADIUS}}}
action_set: {{type: kings_moves, rotations: 8}}
reward: {{goal: cosine_cubed, arrival: 100, obstacle_cost: 10}}
'''


class CrowdMarkersTest(unittest.TestCase):

    episode = 0

    @classmethod
    def setUpClass(cls):
        rospy.init_node('crowd_markers_test')
        cls.agents = rospy.Publisher('agents', AgentStates, queue_size=5000)
        cls.scenario = rospy.Publisher('scenario', Scenario, queue_size=10, latch=True)
        cls.perceptions = rospy.Publisher('perceptions', Perceptions, queue_size=10, latch=True)
        cls.robots = rospy.Publisher('robots', RobotStates, queue_size=100)
        cls.status = rospy.Publisher('learner_status', LearnerStatus, queue_size=10, latch=True)

    def setUp(self):
        self.picture = Picture('markers')
        self.addCleanup(self.picture.close)
        for publisher in (self.agents, self.scenario, self.status, self.robots):
            wait_for(lambda publisher=publisher: publisher.get_num_connections() == 4,
                     f'all nodes subscribe to {publisher.name}')
        wait_for(lambda: self.perceptions.get_num_connections() == 1, 'one node subscribes to perceptions')
        CrowdMarkersTest.episode += 1
        self.tick = 0

    def begin(self, *agents, **others):
        self.scenario.publish(Scenario(episode=self.episode, agents=agents, **others))
        self.show(*agents)

    def show(self, *agents, **others):
        self.agents.publish(AgentStates(episode=self.episode, tick=self.tick, agents=agents, **others))
        self.tick += 1

    def show_robots(self, *robots):
        self.robots.publish(RobotStates(episode=self.episode, tick=self.tick, robots=robots))

    def perceive(self, pose, bodies, **others):
        self_perception = AgentPerception(agent=0, pose=pose, radius=0.25, goal_x=3.0, neighbour_count=len(bodies),
                                          **others)
        other = AgentPerception(agent=1, goal_x=1.0, first_neighbour=len(bodies))
        self.perceptions.publish(Perceptions(episode=self.episode, agents=[other, self_perception], neighbours=bodies))

    def learn(self, state_set, **others):
        self.status.publish(LearnerStatus(serves_all=True, model=MODEL % state_set, **others))

    def test_shows_all_kinds_of_markers_from_topics_only(self):
        wall, obstacle = Wall(to=Point(4.0, 0.0, 0.0)), ObstacleState(position=Point(2.0, 2.0, 0.0), radius=0.5)
        self.begin(agent_at(0, 0.0, 0.0), agent_at(1, 1.0, 0.0), walls=[wall], obstacles=[obstacle])
        self.show(agent_at(0, 0.5, 0.0), agent_at(1, 1.0, 0.5), obstacles=[obstacle])
        self.learn('occupancy')
        self.perceive(Pose2D(0.5, 0.0, 0.0), [Neighbour(x=0.5, y=0.5, radius=0.25)])
        self.show_robots(RobotState(radius=0.3))
        wait_for(lambda: self.picture.kinds() == KINDS, 'markers of all kinds')
        for marker in self.picture.markers():
            self.assertEqual(marker.header.frame_id, 'map')
            self.assertEqual(len(marker.colors), len(marker.points), marker.ns)
        self.assertEqual(self.picture.points('walls'), [(0.0, 0.0), (4.0, 0.0)])

    def test_publishes_a_frame_in_the_middle_of_the_scenario(self):
        """The view of RViz refers to it; without any transform RViz also reports an error of its fixed frame."""
        frames = []
        ear = rospy.Subscriber('/tf_static', TFMessage, lambda message: frames.extend(message.transforms))
        self.addCleanup(ear.unregister)
        far = Point(106.0, 8.0, 0.0)
        self.begin(agent_at(0, 100.0, 20.0, goal=(102.0, 20.0)), agent_at(1, float('nan'), 0.0, goal=(103.0, 22.0)),
                   walls=[Wall(Point(101.0, 10.0, 0.0), far)], name='far away')

        def is_there():
            moves = [(frame.header.frame_id, frame.child_frame_id, frame.transform.translation.x,
                      frame.transform.translation.y) for frame in list(frames)]
            return ('map', 'crowd', 103.0, 15.0) in moves  # the middle of x 100 to 106, y 8 to 22
        wait_for(is_there, 'the frame in the middle')

    def test_shows_the_radii_of_the_state_set(self):
        self.begin(agent_at(0, 0.0, 0.0), agent_at(1, 50.0, 0.0))
        self.learn('occupancy')

        def radii():
            return {round(math.hypot(x, y), 3) for x, y in self.picture.points('radii')}
        wait_for(lambda: radii() == {COLLISION_RADIUS, VISION_RADIUS}, 'two circles around the chosen agent alone')
        self.assertEqual(self.colours_of_radii(), {COLLISION_RADIUS: 'red', VISION_RADIUS: 'amber'})

    def colours_of_radii(self):
        """Returns the colour of each circle by its radius."""
        [marker] = self.picture.markers('radii')
        return {round(math.hypot(point.x, point.y), 3): 'red' if colour.g < 0.4 else 'amber'
                for point, colour in zip(marker.points, marker.colors)}

    def test_radius_of_vision_is_not_red(self):
        """Anticipation has no collision radius."""
        self.begin(agent_at(0, 0.0, 0.0))
        model = (f'state_set: {{type: anticipation, vision_radius: {VISION_RADIUS}}}\n'
                 'action_set: {type: goal_relative}\nreward: {type: progress}\n')
        self.status.publish(LearnerStatus(serves_all=True, model=model))
        wait_for(lambda: self.picture.markers('radii') and self.colours_of_radii() == {VISION_RADIUS: 'amber'},
                 'one amber circle')

    def test_large_crowd_needs_few_markers(self):
        self.picture.most_markers = 0
        crowd = [agent_at(i, i % 25, i // 25, in_contact=i % 2 == 0) for i in range(500)]
        self.begin(*crowd)
        self.show(*(agent_at(i, i % 25 + 0.5, i // 25, in_contact=i % 2 == 0) for i in range(500)))
        wait_for(lambda: self.picture.body_count() == 500 and len(self.picture.points('paths')) >= 1000,
                 '500 bodies and paths')
        self.assertLess(self.picture.most_markers, 20)

    def test_arrived_agent_keeps_only_path_and_goal(self):
        self.begin(agent_at(0, 0.0, 0.0), agent_at(1, 0.0, 5.0))
        self.show(agent_at(0, 1.0, 0.0), agent_at(1, 1.0, 5.0))
        wait_for(lambda: self.picture.body_count() == 2, 'two bodies')
        self.show(agent_at(0, 2.0, 0.0), agent_at(1, 1.5, 5.0, status=AgentState.ARRIVED))
        wait_for(lambda: self.picture.body_count() == 1, 'one body')
        self.assertEqual(len(self.picture.colours('bodies')), 1)
        self.assertEqual(len(self.picture.colours('goals')), 2)
        path = {(0.0, 5.0), (1.0, 5.0), (1.5, 5.0)}
        wait_for(lambda: path | {(2.0, 0.0)} <= set(self.picture.points('paths')), 'both paths')
        self.show(agent_at(0, 2.0, 0.0), agent_at(1, 1.5, 5.0, status=AgentState.STAYING))
        wait_for(lambda: self.picture.body_count() == 2, 'the body of an agent that stays')
        self.show(agent_at(0, 2.0, 0.0), agent_at(1, 1.5, 5.0, status=AgentState.REMOVED))
        wait_for(lambda: len(self.picture.colours('goals')) == 1, 'no goal of the removed one')

    def test_contact_is_highlighted(self):
        touching = [agent_at(0, 0.0, 0.0, in_contact=True), agent_at(1, 0.4, 0.0, in_contact=True)]
        self.begin(*touching, agent_at(2, 3.0, 0.0))
        wait_for(lambda: len(self.picture.colours('bodies')) == 4, 'three bodies and the colour of contacts')
        self.show(agent_at(0, 0.0, 0.0), agent_at(1, 0.6, 0.0), agent_at(2, 3.0, 0.0))
        wait_for(lambda: len(self.picture.colours('bodies')) == 3, 'three bodies alone')

    def test_a_new_episode_clears_everything(self):
        self.begin(agent_at(0, 0.0, 0.0), agent_at(1, 0.0, 5.0), walls=[Wall()])
        self.show(agent_at(0, 1.0, 0.0), agent_at(1, 1.0, 5.0))
        wait_for(lambda: len(self.picture.points('paths')) >= 4, 'two paths')
        CrowdMarkersTest.episode += 1
        self.tick = 0
        self.begin(agent_at(0, 7.0, 7.0))
        wait_for(lambda: self.picture.body_count() == 1 and not self.picture.points('paths'), 'no path, one body')
        self.assertEqual(self.picture.kinds() & {'walls', 'sectors'}, set())
        self.assertEqual(len(self.picture.colours('goals')), 1)

    def test_repeated_episode_clears_paths(self):
        self.begin(agent_at(0, 0.0, 0.0))
        self.show(agent_at(0, 1.0, 0.0))
        wait_for(lambda: self.picture.points('paths'), 'a path')
        self.tick = 0
        self.show(agent_at(0, 0.0, 0.0))
        wait_for(lambda: not self.picture.points('paths'), 'no path')

    def test_shows_the_scenario_before_the_first_tick(self):
        self.scenario.publish(Scenario(episode=self.episode, agents=[agent_at(0, 0.0, 0.0), agent_at(1, 3.0, 0.0)]))
        wait_for(lambda: self.picture.body_count() == 2, 'bodies before the first tick')

    def test_long_paths_become_coarser_but_not_shorter(self):
        plain = Picture('plain_markers')
        self.addCleanup(plain.close)
        wait_for(plain.markers, 'the plain node draws')
        self.begin(agent_at(0, 0.0, 0.0))
        for i in range(1, 1001):
            self.show(agent_at(0, 0.01 * i, 0.0))
            if i % 50 == 0:  # no node is to drop messages because its queue is full
                wait_for(lambda x=0.01 * i: all((x, 0.0) in one.points('paths') for one in (plain, self.picture)),
                         'the end of the path')
        points = plain.points('paths')
        self.assertIn((0.0, 0.0), points)
        self.assertLessEqual(len(points), 2 * 200)  # both ends of each line
        wait_for(lambda: len(self.picture.points('paths')) >= 2 * 160, 'the finer path of the other node')

    def test_shows_the_sectors_of_the_state_set(self):
        pose = Pose2D(2.0, 1.0, math.pi / 2)
        self.begin(agent_at(0, 2.0, 1.0), agent_at(1, 9.0, 9.0))
        self.learn('occupancy')
        # Straight ahead (90 degrees in the map) and near; to the right and farther; behind and out of sight.
        self.perceive(pose, [Neighbour(x=0.7, radius=0.2), Neighbour(y=-1.2, radius=0.2),
                             Neighbour(x=-9.0, radius=0.2)])

        def sectors(near, far):
            parts = sectors_of(self.picture.points('sectors'), (2.0, 1.0))
            return fills(parts.get(COLLISION_RADIUS), near) and fills(parts.get(VISION_RADIUS), far)
        wait_for(lambda: sectors((67.5, 112.5), (-22.5, 22.5)), 'sectors of 45 degrees')
        self.assertEqual(len(self.picture.colours('sectors')), 2)
        self.learn('nearest_obstacle')
        wait_for(lambda: sectors((90.0, 105.0), None), 'the left one of two sectors of 15 degrees')
        self.perceive(pose, [])
        wait_for(lambda: 'sectors' not in self.picture.kinds(), 'no sector')

    def test_hides_sectors_of_other_episodes_and_removed_agents(self):
        near = [Neighbour(x=0.5, radius=0.25)]
        self.begin(agent_at(0, 0.0, 0.0))
        self.learn('occupancy')
        self.perceive(Pose2D(), near)
        wait_for(lambda: 'sectors' in self.picture.kinds(), 'a sector')
        self.show(agent_at(0, 0.0, 0.0, status=AgentState.ARRIVED))
        wait_for(lambda: 'sectors' not in self.picture.kinds(), 'no sector of an agent that has arrived')
        self.show(agent_at(0, 0.0, 0.0))
        wait_for(lambda: 'sectors' in self.picture.kinds(), 'a sector again')
        CrowdMarkersTest.episode += 1
        self.begin(agent_at(0, 0.0, 0.0))
        wait_for(lambda: 'sectors' not in self.picture.kinds(), 'no sector of the episode before')

    def test_sectors_stay_during_turns_of_other_agents(self):
        self.begin(agent_at(0, 0.0, 0.0), agent_at(1, 9.0, 9.0))
        self.learn('occupancy')
        self.perceive(Pose2D(), [Neighbour(x=0.5, radius=0.25)])
        wait_for(lambda: 'sectors' in self.picture.kinds(), 'a sector')
        turn = Perceptions(episode=self.episode, turn=1, agents=[AgentPerception(agent=1, goal_x=1.0)])
        self.perceptions.publish(turn)
        self.show(agent_at(0, 0.0, 0.0), agent_at(1, 8.0, 9.0))
        wait_for(lambda: max(x for x, _ in self.picture.points('bodies')) < 8.5, 'what came after the turn')
        self.assertIn('sectors', self.picture.kinds())
        turn.tick = 2  # the selected agent had no turn in tick 1
        self.perceptions.publish(turn)
        wait_for(lambda: 'sectors' not in self.picture.kinds(), 'no sector of two ticks ago')

    def test_shows_no_sectors_without_a_selected_agent(self):
        plain = Picture('plain_markers')
        self.addCleanup(plain.close)
        self.begin(agent_at(0, 0.0, 0.0), agent_at(1, 40.0, 0.0))
        self.learn('occupancy')
        self.perceive(Pose2D(), [Neighbour(x=0.5, radius=0.25)])
        wait_for(lambda: 'sectors' in self.picture.kinds(), 'a sector of the other node')
        wait_for(lambda: any(x > 30.0 for x, _ in plain.points('radii')), 'radii of all agents')
        self.assertNotIn('sectors', plain.kinds())
        self.assertEqual(self.perceptions.get_num_connections(), 1)

    def test_subscribes_to_perceptions_only_if_markers_are_subscribed(self):
        self.picture.close()
        wait_for(lambda: self.perceptions.get_num_connections() == 0, 'no subscription to perceptions')
        self.picture = Picture('markers')
        self.addCleanup(self.picture.close)
        wait_for(lambda: self.perceptions.get_num_connections() == 1, 'a node subscribes to perceptions again')
        wait_for(self.picture.markers, 'markers for the new subscriber')

    def test_shows_footprints_goals_and_paths_of_robots(self):
        self.begin(agent_at(0, 50.0, 50.0))
        # An L of two squares of 1 m side on a third one, turned by a quarter, and a disc.
        corners = [Point(x, y, 0.0) for x, y in ((-0.5, -0.5), (1.5, -0.5), (1.5, 0.5), (0.5, 0.5), (0.5, 1.5),
                                                 (-0.5, 1.5))]
        cart = RobotState(robot=0, pose=Pose2D(1.0, 2.0, math.pi / 2.0), footprint=corners, has_goal=True,
                          goal=Point(5.0, 6.0, 0.0))
        disc = RobotState(robot=1, pose=Pose2D(-4.0, 0.0, 0.0), radius=0.3)
        self.show_robots(cart, disc)

        def footprints():
            markers = self.picture.markers('robots')
            return markers[0].points if len(markers) == 2 else []
        # Until the new scenario arrives, robots of an earlier test are shown.
        wait_for(lambda: any(point.y > 3.0 for point in footprints()), 'footprints and headings of two robots')
        points = footprints()
        area = sum(abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2.0
                   for a, b, c in (points[i:i + 3] for i in range(0, len(points), 3)))
        self.assertAlmostEqual(area, 3.0 + math.pi * 0.3 ** 2, delta=0.01)
        ahead = max(point.y for point in points if point.x > -3.0)
        self.assertAlmostEqual(ahead, 2.0 + 1.5, places=6)  # its front is at y = 3.5
        self.assertIn((5.0, 6.0), [(round((a.x + b.x) / 2.0, 6), round((a.y + b.y) / 2.0, 6))
                                   for marker in self.picture.markers('goals')
                                   for a, b in zip(marker.points[::2], marker.points[1::2])])
        cart.pose.y, cart.contacts = 3.0, [0]
        self.tick += 1
        self.show_robots(cart, disc)
        wait_for(lambda: {(1.0, 2.0), (1.0, 3.0)} <= set(self.picture.points('paths')), 'the path of the robot')
        wait_for(lambda: len(self.picture.markers('robots')) == 3, 'the outline of a contact')
        CrowdMarkersTest.episode += 1
        self.begin(agent_at(0, 0.0, 0.0))  # without robots
        wait_for(lambda: 'robots' not in self.picture.kinds() and not self.picture.points('paths'), 'no robot')

    # Walking people

    def show_people(self):
        people = Picture('people_markers')
        self.addCleanup(people.close)
        wait_for(people.markers, 'the node with people draws')
        return people

    @staticmethod
    def meshes(people, agent):
        """Returns the names of the meshes of an agent."""
        return sorted(marker.mesh_resource.split('/')[-1][:-len('.stl')] for marker in people.markers('figures')
                      if marker.id // PARTS == agent)

    def test_people_are_meshes_that_exist_at_the_poses_of_the_agents(self):
        people = self.show_people()
        small = agent_at(3, 5.0, 2.0)
        small.radius, small.pose.theta = 0.2, math.pi / 2.0
        self.begin(small)
        wait_for(lambda: len(people.markers('figures')) == PARTS == len(self.meshes(people, 3)), 'one figure')
        self.assertNotIn('headings', people.kinds())
        for marker in people.markers('figures'):
            self.assertEqual(marker.type, Marker.MESH_RESOURCE)
            prefix = 'package://social_crowd/'
            self.assertTrue(marker.mesh_resource.startswith(prefix), marker.mesh_resource)
            self.assertTrue(os.path.exists(in_package(marker.mesh_resource[len(prefix):])), marker.mesh_resource)
            self.assertEqual((marker.pose.position.x, marker.pose.position.y), (5.0, 2.0))
            self.assertAlmostEqual(marker.pose.orientation.z, math.sin(math.pi / 4.0))
            self.assertAlmostEqual(marker.scale.x, 0.2 / 0.25)
            self.assertEqual((marker.header.frame_id, marker.color.a), ('map', 1.0))
        shirt = [marker.color for marker in people.markers('figures') if 'shirt' in marker.mesh_resource]
        self.begin(agent_at(4, 5.0, 2.0))
        wait_for(lambda: self.meshes(people, 4) and not self.meshes(people, 3), 'another agent')
        others = [marker.color for marker in people.markers('figures') if 'shirt' in marker.mesh_resource]
        self.assertNotEqual(shirt, others)

    def test_figures_of_children_and_wheelchairs(self):
        people = self.show_people()
        child = agent_at(0, 0.0, 0.0, figure=AgentState.CHILD)
        chair = agent_at(1, 3.0, 0.0, figure=AgentState.WHEELCHAIR)
        child.radius, chair.radius = 0.125, 0.4
        self.begin(child, chair, agent_at(2, 6.0, 0.0, figure=AgentState.OLD), agent_at(3, 9.0, 0.0, figure=200))

        def belongings():
            return {marker.id: os.path.basename(marker.mesh_resource) for marker in people.markers('belongings')}
        wait_for(lambda: belongings() == {1: 'wheelchair.stl', 2: 'stick.stl'}, 'what they have with them')
        self.assertEqual(self.meshes(people, 0), ['broad_dark_8', 'broad_head', 'broad_shirt_8'])
        self.assertEqual(self.meshes(people, 1), ['sitting_dark', 'sitting_head', 'sitting_shirt'])
        self.assertEqual(self.meshes(people, 3), ['slim_dark_8', 'slim_head', 'slim_shirt_8'])  # of an unknown figure
        for marker in people.markers('belongings') + people.markers('figures'):
            self.assertTrue(os.path.exists(in_package(marker.mesh_resource[len('package://social_crowd/'):])))
        height = {marker.id: marker.scale.z for marker in people.markers('figures')}
        self.assertLess(height[0], 0.7 * height[PARTS])
        self.assertEqual([marker.scale.x for marker in people.markers('figures') if marker.id < 2 * PARTS],
                         PARTS * [0.5] + PARTS * [1.0])
        CrowdMarkersTest.episode += 1
        self.begin(agent_at(1, 3.0, 0.0, figure=AgentState.TROLLEY), agent_at(2, 6.0, 0.0))
        wait_for(lambda: belongings() == {1: 'trolley.stl'}, 'other figures')

    def test_people_step_with_the_distance_walked_and_stand(self):
        people = self.show_people()
        self.begin(agent_at(0, 0.0, 0.0))
        standing = ['broad_dark_8', 'broad_head', 'broad_shirt_8']
        wait_for(lambda: self.meshes(people, 0) == standing, 'standing')
        for x, frame in ((0.2, 1), (0.6, 3), (1.3, 7), (1.5, 0)):  # a cycle of 8 frames is 1.4 m
            self.show(agent_at(0, x, 0.0))
            wait_for(lambda frame=frame: self.meshes(people, 0)[::2] == [f'broad_dark_{frame}', f'broad_shirt_{frame}'],
                     f'frame {frame} at {x} m')
        for _ in range(3):
            self.show(agent_at(0, 1.5, 0.0))
        wait_for(lambda: self.meshes(people, 0) == standing, 'standing again')

    def test_people_who_leave_are_deleted(self):
        people = self.show_people()
        self.begin(*(agent_at(i, i, 0.0) for i in range(3)))
        wait_for(lambda: len(people.markers('figures')) == 3 * PARTS, 'three figures')
        arrived = agent_at(1, 1.0, 0.0, status=AgentState.ARRIVED)
        self.show(agent_at(0, 0.0, 0.0), arrived, agent_at(2, 2.0, 0.0))
        wait_for(lambda: not self.meshes(people, 1) and len(people.markers('figures')) == 2 * PARTS, 'one has arrived')
        self.show(agent_at(0, 0.0, 0.0))
        wait_for(lambda: len(people.markers('figures')) == PARTS, 'one is not in the message')
        CrowdMarkersTest.episode += 1
        self.begin(agent_at(7, 0.0, 0.0))
        wait_for(lambda: self.meshes(people, 7) and not self.meshes(people, 0), 'another episode')

    def test_large_crowds_are_discs(self):
        people = self.show_people()
        crowd = [agent_at(i, i % 25, i // 25) for i in range(201)]
        self.begin(*crowd[:200])
        wait_for(lambda: len(people.markers('figures')) == 200 * PARTS, '200 figures')
        self.show(*crowd)
        wait_for(lambda: people.body_count() == 201 and not people.markers('figures'), '201 discs')
        self.show(*crowd[:200])
        wait_for(lambda: not people.body_count() and len(people.markers('figures')) == 200 * PARTS, '200 figures again')

    def test_old_parts_of_paths_fade_and_vanish(self):
        fading = Picture('fading_markers')
        self.addCleanup(fading.close)
        wait_for(fading.markers, 'the node with fading paths draws')
        self.begin(agent_at(0, 0.0, 0.0))
        for second in range(11):
            self.show(agent_at(0, float(second), 0.0), time=float(second))
        wait_for(lambda: {x for x, _ in fading.points('paths')} == {7.0, 8.0, 9.0, 10.0}, 'the last 4 s of the path')
        colours = {round(point.x): colour.g for marker in fading.markers('paths')
                   for point, colour in zip(marker.points, marker.colors)}
        self.assertEqual(sorted(colours, key=colours.get), [10, 9, 8, 7])  # older ones are nearer to white
        wait_for(lambda: (0.0, 0.0) in self.picture.points('paths'), 'the whole path of the other node')

    # Errors

    def test_ignores_invalid_messages(self):
        nan = float('nan')
        self.begin(agent_at(0, 0.0, 0.0), walls=[Wall(to=Point(nan, 0.0, 0.0)), Wall(to=Point(1.0, 0.0, 0.0))])
        self.status.publish(LearnerStatus(serves_all=True, model='state_set: {type: none}'))
        self.perceive(Pose2D(), [], first_wall=7, wall_count=9)
        self.perceive(Pose2D(nan, nan, nan), [Neighbour(x=nan, radius=0.25), Neighbour(x=0.5, radius=0.25)])
        self.show(agent_at(0, 0.0, 0.0), agent_at(1, nan, 0.0), agent_at(2, 0.0, 1e300),
                  agent_at(3, 0.0, 0.0, goal=(nan, 0.0)))
        self.show_robots(RobotState(pose=Pose2D(nan, 0.0, 0.0), radius=0.3), RobotState(radius=nan),
                         RobotState(radius=0.3, footprint=[Point(nan, 0.0, 0.0)]))
        wait_for(lambda: self.picture.body_count() == 2, 'the two bodies that are fine')
        self.assertEqual(len(self.picture.colours('goals')), 3)
        for kind in KINDS:
            self.assertTrue(all(math.isfinite(x + y) for x, y in self.picture.points(kind)), kind)

    def test_error_names_all_invalid_parameters(self):
        command = roslib.packages.find_node(PACKAGE, NODE)[0]
        arguments = ['__name:=bad_markers', '_rate:=-1', '_radii:=some', '_agent:=0.5', '_figures:=ghosts',
                     '_values:=often', '_colour:=red']
        run = subprocess.run([command] + arguments, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                             timeout=PATIENCE, check=False)
        output = run.stdout.decode()
        self.assertEqual(run.returncode, 1, output)
        for name in ('~rate', '~radii', '~agent', '~figures', '~values', '~colour'):
            self.assertIn(f'{name}: ', output)


if __name__ == '__main__':
    rostest.rosrun(PACKAGE, 'crowd_markers_test', CrowdMarkersTest)
