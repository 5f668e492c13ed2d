#!/usr/bin/python3
"""A robot follows cmd_vel; its odometry, frames, scan and goal are published."""
import importlib
import math

import rospy
import support
from geometry_msgs.msg import Pose2D, PoseArray, PoseStamped, PoseWithCovarianceStamped, Twist
from nav_msgs.msg import Odometry
from robots import RobotTestCase, command, scenario
from sensor_msgs.msg import LaserScan, PointCloud2
from social_crowd.msg import AgentState, AgentStates
from tf2_msgs.msg import TFMessage


class DrivingTest(RobotTestCase):
    """Commands and the motion that follows."""

    def test_follows_a_command_until_its_timeout(self):
        self.start_all()
        self.send(self.commander(), command(0.5), 1)
        # The command holds for five ticks of 0.1 s, wherever the steps began.
        state = self.walk(10)
        self.assertAlmostEqual(state.pose.x, 1.25, places=9)
        self.assertEqual(state.twist.linear.x, 0.0)
        self.assertEqual(state.command_timeouts, 1)
        self.assertEqual((state.commands_taken, state.commands_missed), (1, 0))

    def test_is_stopped_by_a_wall(self):
        self.start_all(scenario(more=', cmd_timeout: 100'))
        self.send(self.commander(), command(1.0), 1)
        state = self.walk(60)
        self.assertAlmostEqual(state.pose.x, 4.7, places=6)
        self.assertTrue(any(message.robots[0].blocked for message in self.states.messages))

    def test_bad_commands_are_refused_and_counted(self):
        self.start_all()
        publisher = self.commander()
        for count, bad in enumerate((math.nan, math.inf, -math.inf), 1):
            self.send(publisher, command(bad), count)
        state = self.walk(5)
        self.assertEqual((state.commands_not_finite, state.commands_taken), (3, 0))
        self.assertEqual(state.pose.x, 1.0)
        support.wait_for(lambda: 'not finite' in self.controller.output(), 'a warning')

    def test_of_two_publishers_the_first_one_commands(self):
        self.start_all(scenario(more=', cmd_timeout: 100'))
        self.send(self.commander(), command(0.1), 1)
        other = self.start('other', ['/usr/bin/rostopic', 'pub', '-r', '20', f'{self.namespace}/cmd_vel',
                                     'geometry_msgs/Twist', '{angular: {z: 1.0}}'])
        support.wait_for(lambda: self.walk().commands_of_others > 0, 'a refused command')
        other.stop()
        state = self.walk()
        self.assertEqual(state.twist.angular.z, 0.0)
        self.assertEqual(state.commands_taken, 1)
        support.wait_for(lambda: 'commands this robot' in self.controller.output(), 'a warning')


class TopicsTest(RobotTestCase):
    """What is published after each tick."""

    def test_odometry_and_frames(self):
        self.start_all(publish_clock=True)
        odometry = self.listen('odom', Odometry).wait_connected()
        frames = self.listen('/tf', TFMessage).wait_connected()
        self.step_robots(['tug'], [command(1.0, 0.5)], ticks=10)
        self.step_robots(ticks=1)
        support.wait_for(lambda: len(odometry.messages) >= 11, '11 odometry messages')
        last = odometry.messages[9]
        # An arc: radius 2 m, 0.5 rad.
        self.assertAlmostEqual(last.pose.pose.position.x, 2.0 * math.sin(0.5), places=9)
        self.assertAlmostEqual(last.pose.pose.position.y, 2.0 * (1.0 - math.cos(0.5)), places=9)
        self.assertEqual((last.twist.twist.linear.x, last.twist.twist.angular.z), (1.0, 0.5))
        self.assertEqual((last.header.frame_id, last.child_frame_id), ('odom', 'base_link'))

        def transform(child):
            return [frame for message in list(frames.messages) for frame in message.transforms
                    if frame.child_frame_id == child and frame.header.stamp == last.header.stamp]

        support.wait_for(lambda: transform('base_link') and transform('odom'), 'transforms')
        base, odom = transform('base_link')[0], transform('odom')[0]
        self.assertEqual(base.transform.translation.x, last.pose.pose.position.x)
        self.assertEqual((odom.header.frame_id, base.header.frame_id), ('map', 'odom'))
        self.assertAlmostEqual(odom.transform.translation.x, 1.0, places=9)  # where the robot began
        self.assertAlmostEqual(odom.transform.rotation.w, 1.0, places=9)

    def test_scan_sees_the_wall(self):
        self.start_all(scenario(more=', scan: {rays: 360, angles: [-180, 180], range: [0.1, 10]}'))
        scans = self.listen('scan', LaserScan).wait_connected()
        clouds = self.listen('scan_cloud', PointCloud2).wait_connected()
        self.step()
        scan = scans.wait()
        self.assertEqual(len(scan.ranges), 360)
        self.assertAlmostEqual(scan.ranges[180], 4.0, places=6)
        self.assertAlmostEqual(scan.ranges[180 + 45], 4.0 * math.sqrt(2.0), places=5)
        self.assertEqual(scan.ranges[0], math.inf)
        self.assertEqual(scan.header.frame_id, 'laser')
        self.assertAlmostEqual(scan.angle_increment, math.radians(1.0), places=6)
        hits = sum(math.isfinite(value) for value in scan.ranges)
        self.assertEqual(clouds.wait().width, hits)

    def test_scan_period_is_a_number_of_ticks(self):
        self.start_all(scenario(more=', scan: {rays: 10, period: 0.3}'))  # without simulated time
        scans = self.listen('scan', LaserScan).wait_connected()
        for _ in range(4):
            self.walk()
        self.walk(3)
        self.walk()
        # Ticks 3 and 6 of 8.
        support.wait_for(lambda: len(scans.messages) >= 2, 'two scans')
        self.assertAlmostEqual(scans.messages[0].scan_time, 0.3, places=6)
        self.assertEqual(self.ticks_of(scans), [3, 6])

    def ticks_of(self, listener):
        """Returns the ticks at which messages were published."""
        ticks = {message.header.stamp: message.tick for message in self.states.messages}
        return [ticks[message.header.stamp] for message in listener.messages]

    def test_odometry_has_covariances(self):
        self.start_all(scenario(more=', odometry: {distance: 0.1}'))
        odometry = self.listen('odom', Odometry).wait_connected()
        self.step_robots(['tug'], [command(1.0)], ticks=20)
        support.wait_for(lambda: len(odometry.messages) >= 20, '20 odometry messages')
        pose, twist = odometry.messages[-1].pose.covariance, odometry.messages[-1].twist.covariance
        # 2 m and 1 m/s with 10 %; the rest is exact, or not measured.
        self.assertAlmostEqual(pose[0], 0.04, places=9)
        self.assertAlmostEqual(twist[0], 0.01, places=9)
        for numbers in (pose, twist):
            self.assertEqual([numbers[7 * i] for i in range(1, 6)], [1e-6, 1e6, 1e6, 1e6, 1e-6])

    def people_seen(self, tracks='', **parameters):
        """Starts the nodes with a person near the robot, one behind the wall and one out of range. Returns where the
        people of people_poses are; `tracks` is that key of the robot, after a comma."""
        people = '''  - {position: [3, 1], goal: [3, 30], speed: 0.01, radius: 0.25}
  - {position: [9, 0], goal: [9, 30], speed: 0.01, radius: 0.25}
walls:'''
        text = scenario(more=', scan: {range: [0.1, 15]}' + tracks).replace('walls:', people)
        self.start_all(text, **parameters)
        poses = self.listen('people_poses', PoseArray).wait_connected()
        self.step()
        return {(round(pose.position.x), round(pose.position.y)) for pose in poses.wait().poses}

    def test_people_are_all_people(self):
        self.assertEqual(self.people_seen(), {(0, 20), (3, 1), (9, 0)})

    def test_people_are_those_that_the_scanner_sees_if_wanted(self):
        self.assertEqual(self.people_seen(visible_people_only=True), {(3, 1)})

    def test_people_are_tracks(self):
        self.assertEqual(self.people_seen(', tracks: {occlusion: true}'), {(3, 1)})

    def test_tracks_do_not_depend_on_subscribers(self):
        """They have a memory, and are the same for one who subscribes in the middle of an episode."""
        keys = ', tracks: {noise: 0.1, missed: 0.5, keep: 0.2, false_detections: 5, range: 30}'
        self.start_all(scenario(more=keys), seed=3)
        late = self.tracks_of(10, before=10)
        self.assertEqual(self.tracks_of(20)[10:], late)
        self.assertEqual(len({tuple(tick) for tick in late}), 10)  # errors differ from tick to tick

    def tracks_of(self, ticks, before=0):
        """Returns the poses of the tracks in the ticks of a new episode after some without a subscriber."""
        self.succeed('crowd_controller/reset', seed=3)
        if before:
            self.walk(before)
        poses = self.listen('people_poses', PoseArray).wait_connected()
        self.walk(ticks)
        support.wait_for(lambda: len(poses.messages) >= ticks, f'{ticks} messages')
        return [[(pose.position.x, pose.position.y) for pose in message.poses] for message in poses.messages[-ticks:]]

    def test_people_messages(self):
        try:
            from people_msgs.msg import People
        except ImportError:
            self.skip('people_msgs is not installed')
        self.start_all()
        if [f'{self.namespace}/people', 'people_msgs/People'] not in rospy.get_published_topics(self.namespace):
            self.skip('the package was built without people_msgs')
        people = self.listen('people', People).wait_connected()
        self.walk(3)
        person = people.wait(lambda message: message.people[0].velocity.x > 0.0).people[0]
        self.assertEqual((person.name, person.reliability), ('0', 1.0))
        self.assertAlmostEqual(person.position.y, 20.0, delta=0.1)
        self.assertAlmostEqual(math.hypot(person.velocity.x, person.velocity.y), 0.5, delta=0.01)

    def test_messages_of_leg_detector(self):
        measured = self.messages_of('people_msgs', 'PositionMeasurementArray', 'people_tracker_measurements')
        message = measured.wait(lambda message: message.people and message.people[0].reliability == 1.0)
        person = message.people[0]
        self.assertEqual((person.object_id, person.header.frame_id, person.initialization), ('0', 'map', 0))
        self.assertEqual([round(number, 6) for number in person.covariance],
                         [0.01, 0.0, 0.0, 0.0, 0.01, 0.0, 0.0, 0.0, 1e4])
        self.assertAlmostEqual(person.pos.y, 20.0, delta=0.6)
        predicted = measured.wait(lambda message: message.people and message.people[0].reliability < 1.0).people[0]
        self.assertGreater(predicted.covariance[0], 0.01)

    def test_messages_of_spencer(self):
        tracked = self.messages_of('spencer_tracking_msgs', 'TrackedPersons', 'tracked_persons')
        person = tracked.wait(lambda message: message.tracks and message.tracks[0].is_matched).tracks[0]
        self.assertEqual((person.track_id, person.is_occluded), (0, False))
        self.assertAlmostEqual(person.pose.covariance[7], 0.01, places=9)
        self.assertEqual((person.pose.covariance[35], person.twist.covariance[14]), (1e6, 1e6))
        self.assertAlmostEqual(person.twist.covariance[0], 0.04, places=9)
        predicted = tracked.wait(lambda message: message.tracks and message.tracks[0].is_occluded).tracks[0]
        self.assertFalse(predicted.is_matched)
        self.assertGreater(predicted.pose.covariance[7], 0.01)
        self.assertGreater(predicted.age.to_sec(), 0.0)

    def messages_of(self, package, kind, topic):
        """Returns a listener to tracks of a person who is missed in half of the ticks. Skips the test without them."""
        message_type = self.type_of(package, kind)
        self.start_all(scenario(more=', tracks: {noise: 0.1, velocity_noise: 0.2, missed: 0.5, keep: 50}'))
        listener = self.listen_if_built(topic, package, message_type)
        self.walk(20)
        return listener

    def type_of(self, package, kind):
        """Returns a type of messages. Skips the test where the package is not installed."""
        try:
            return getattr(importlib.import_module(f'{package}.msg'), kind)
        except ImportError:
            return self.skip(f'{package} is not installed')

    def listen_if_built(self, topic, package, message_type):
        """Listens to a topic. Skips the test if the package was built without the package of its messages."""
        if [f'{self.namespace}/{topic}', message_type._type] not in rospy.get_published_topics(self.namespace):
            self.skip(f'the package was built without {package}')
        return self.listen(topic, message_type).wait_connected()

    def test_all_messages_agree_with_the_true_people(self):
        """Two people walk; the third one arrives on the way and is not there any more."""
        kinds = {'people': ('people_msgs', 'People'),
                 'people_tracker_measurements': ('people_msgs', 'PositionMeasurementArray'),
                 'tracked_persons': ('spencer_tracking_msgs', 'TrackedPersons')}
        types = {topic: self.type_of(*kind) for topic, kind in kinds.items()}
        people = '''  - {position: [-3, 1], goal: [-30, 8], speed: 1.2, radius: 0.25}
  - {position: [-3, -4], goal: [-4, -5], speed: 1.0, radius: 0.25}
walls:'''
        self.start_all(scenario().replace('walls:', people), publish_clock=True)  # so that all have the same stamps
        heard = {topic: self.listen_if_built(topic, kinds[topic][0], kind) for topic, kind in types.items()}
        truth = self.listen('agents', AgentStates).wait_connected()
        self.walk(20)
        support.wait_for(lambda: all(len(listener.messages) >= 20 for listener in heard.values()), 'all messages')
        numbers = []
        for topic, listener in heard.items():
            for message in listener.messages[-20:]:
                self.assertEqual(message.header.frame_id, 'map')
                true = truth.wait(lambda state, message=message: state.header.stamp == message.header.stamp)
                present = [agent for agent in true.agents if agent.status == AgentState.WALKING]
                numbers.append([agent.agent for agent in present])
                got = message.tracks if topic == 'tracked_persons' else message.people
                self.assertEqual(len(got), len(present))
                for place, (one, agent) in enumerate(zip(got, present)):
                    getattr(self, f'check_{topic}')(one, agent, place, true.time)
        self.assertIn([0, 1, 2], numbers)
        self.assertEqual(numbers[-1], [0, 1])

    def check_people(self, person, agent, _place, _time):
        """Checks a Person of people_msgs."""
        self.assertEqual((person.name, person.reliability), (str(agent.agent), 1.0))
        self.assertEqual((person.position.x, person.position.y), (agent.pose.x, agent.pose.y))
        self.assertEqual((person.velocity.x, person.velocity.y), (agent.velocity.x, agent.velocity.y))

    def check_people_tracker_measurements(self, person, agent, _place, _time):
        """Checks a PositionMeasurement of people_msgs."""
        self.assertEqual((person.object_id, person.reliability, person.header.frame_id),
                         (str(agent.agent), 1.0, 'map'))
        self.assertEqual((person.pos.x, person.pos.y), (agent.pose.x, agent.pose.y))
        self.assertEqual(list(person.covariance), [1e-6, 0, 0, 0, 1e-6, 0, 0, 0, 1e4])

    def check_tracked_persons(self, track, agent, place, time):
        """Checks a TrackedPerson of spencer_tracking_msgs."""
        self.assertEqual((track.track_id, track.is_matched, track.is_occluded, track.detection_id),
                         (agent.agent, True, False, place))
        position, orientation = track.pose.pose.position, track.pose.pose.orientation
        self.assertEqual((position.x, position.y), (agent.pose.x, agent.pose.y))
        self.assertAlmostEqual(math.remainder(2 * math.atan2(orientation.z, orientation.w) - agent.pose.theta,
                                              2 * math.pi), 0.0, places=9)
        velocity = track.twist.twist.linear
        self.assertEqual((velocity.x, velocity.y), (agent.velocity.x, agent.velocity.y))
        self.assertAlmostEqual(track.age.to_sec(), time, places=6)

    def test_people_and_goal(self):
        self.start_all(scenario(more=', goal: [4, 0]'))
        people = self.listen('people_poses', PoseArray).wait_connected()
        goals = self.listen('goal', PoseStamped).wait_connected()
        self.assertEqual(goals.wait().pose.position.x, 4.0)
        self.step()
        self.assertEqual([pose.position.y for pose in people.wait().poses], [20.0])

    def test_a_new_goal_replaces_the_goal(self):
        # A robot with a radius of 0.3 m cannot come within 0.2 m of a wall.
        self.start_all(scenario(more=', goal: [4, 0]').replace('goal_tolerance: 0.3', 'goal_tolerance: 0.2'))
        goals = self.listen('goal', PoseStamped).wait_connected()
        goals.wait()
        publisher = self.publisher('new_goal', PoseStamped)
        for frame, x in (('base_link', 2.0), ('map', math.nan), ('map', 5.0), ('map', 2.0)):  # there is a wall at 5
            goal = PoseStamped()
            goal.header.frame_id = frame
            goal.pose.position.x = x
            publisher.publish(goal)
        self.assertEqual(goals.wait(lambda message: message.pose.position.x != 4.0).pose.position.x, 2.0)
        support.wait_for(lambda: all(text in self.controller.output() for text in (
            'expected the frame map', 'expected finite numbers', 'the goal (5, 0) is in a wall')), 'three warnings')
        self.assertEqual(self.walk().goal.x, 2.0)

    def test_a_robot_is_moved_by_a_service_and_by_a_topic(self):
        self.start_all()
        self.succeed('crowd_controller/teleport_robot', robot='tug', pose=Pose2D(-2.0, 1.0, 0.5))
        state = self.walk()
        self.assertEqual((state.pose.x, state.pose.y, state.pose.theta), (-2.0, 1.0, 0.5))
        self.refuse('crowd_controller/teleport_robot', 'taken by a wall', robot='tug', pose=Pose2D(5.1, 0.0, 0.0))
        self.refuse('crowd_controller/teleport_robot', "there is no robot 'cart'", robot='cart')
        publisher = self.publisher('new_pose', PoseWithCovarianceStamped)
        for x in (5.1, 3.0):
            pose = PoseWithCovarianceStamped()
            pose.header.frame_id = 'map'
            pose.pose.pose.position.x, pose.pose.pose.orientation.w = x, 1.0
            publisher.publish(pose)
        support.wait_for(lambda: self.walk().pose.x == 3.0, 'the new place')
        self.assertEqual(self.walk().pose.theta, 0.0)
        support.wait_for(lambda: 'a pose is refused: the place is taken by a wall' in self.controller.output(),
                         'warning')

    def test_robots_are_added_and_removed(self):
        self.start_all()
        self.succeed('crowd_controller/spawn_robot', robot='{name: cart, position: [-3, 2], radius: 0.2, max_speed: 1, '
                     'goal: [0, 2], acceleration: 100, scan: {rays: 8}}')
        odometry = self.listen('cart/odom', Odometry).wait_connected()
        scans = self.listen('cart/scan', LaserScan).wait_connected()
        goal = self.listen('cart/goal', PoseStamped).wait()
        self.assertEqual(goal.pose.position.x, 0.0)
        done = self.step_robots(['cart', 'tug'], [command(1.0), command(0.5)])
        states = self.states.wait_at(done.episode, done.tick)
        self.assertEqual([robot.name for robot in states.robots], ['tug', 'cart'])
        self.assertAlmostEqual(odometry.wait().pose.pose.position.x, 0.1)
        self.assertEqual(len(scans.wait().ranges), 8)
        for entry, words in (('{name: cart, position: [-3, 4], radius: 0.2, max_speed: 1}', "a robot 'cart' already"),
                             ('{name: van, position: [5.1, 0], radius: 0.2, max_speed: 1}', 'taken by a wall'),
                             ('{name: van, position: [0, 4], max_speed: 1}', 'radius'),
                             ('{name: van, position: {box: [[0, 1], [2, 3]]}, radius: 1, max_speed: 1}', 'fixed'),
                             ('{name: van', 'robot: ')):
            self.refuse('crowd_controller/spawn_robot', words, robot=entry)
        self.succeed('crowd_controller/remove_robot', robot='tug')
        self.refuse('crowd_controller/remove_robot', "no robot 'tug'", robot='tug')
        before = self.walk().pose.x
        publisher = self.publisher('cart/cmd_vel', Twist)
        publisher.publish(command(1.0))
        support.wait_for(lambda: self.walk().pose.x > before, 'that the other one still takes commands')
        self.assertEqual([robot.name for robot in self.states.messages[-1].robots], ['cart'])
        for number in range(2):
            self.succeed('crowd_controller/spawn_robot',
                         robot=f'{{position: [-3, {number}], radius: 0.2, max_speed: 1}}')
        self.walk()
        self.assertEqual([robot.name for robot in self.states.messages[-1].robots], ['cart', 'robot_0', 'robot_1'])
        self.succeed('crowd_controller/reset', keep_seed=True)
        self.assertEqual(self.walk().name, 'tug')

    def test_odometry_between_ticks_is_on_the_arc(self):
        """At 1 m/s and 1 rad/s, on a circle of 1 m; a fifth of a tick of 0.1 s is 0.02 s."""
        self.start_all(odometry_rate=50.0, publish_clock=True)
        odometry = self.listen('odom', Odometry).wait_connected()
        self.step_robots(['tug'], [command(1.0, 1.0)], ticks=2)
        support.wait_for(lambda: len(odometry.messages) >= 10, 'ten messages')
        self.assertEqual(len(odometry.messages), 10)
        for number, message in enumerate(odometry.messages, 1):
            angle = 0.02 * number
            self.assertAlmostEqual(message.pose.pose.position.x, math.sin(angle), places=9)
            self.assertAlmostEqual(message.pose.pose.position.y, 1.0 - math.cos(angle), places=9)
            self.assertAlmostEqual(message.twist.twist.linear.x, 1.0, places=9)
        times = [message.header.stamp.to_sec() for message in odometry.messages]
        for before, after in zip(times, times[1:]):
            self.assertAlmostEqual(after - before, 0.02, places=6)

    def test_robots_have_namespaces(self):
        text = scenario() + scenario().split('robots:\n')[1].replace('tug', 'cart').replace('[1, 0]', '[1, 3]')
        self.start_all(text)
        odometry = self.listen('cart/odom', Odometry).wait_connected()
        self.listen('tug/scan', LaserScan).wait_connected()
        self.step()
        message = odometry.wait()
        self.assertEqual((message.header.frame_id, message.child_frame_id), ('cart/odom', 'cart/base_link'))


if __name__ == '__main__':
    support.run('robot_driving_test')
