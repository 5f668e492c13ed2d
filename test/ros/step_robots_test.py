#!/usr/bin/python3
"""The service step_robots: commands of robots and ticks in one call."""
import math

import support
from geometry_msgs.msg import Point, Twist
from robots import RobotTestCase, command, scenario


class StepRobotsTest(RobotTestCase):
    """Commands, observations, and errors."""

    def refuse_steps(self, *words, robots=(), commands=(), ticks=1):
        """Calls the service, which must refuse."""
        self.refuse('crowd_controller/step_robots', *words, robots=list(robots), commands=list(commands), ticks=ticks,
                    with_scan=False)

    def test_commands_hold_for_all_ticks(self):
        self.start_all(scenario(more=', goal: [4, 0]'))
        response = self.step_robots(['tug'], [command(0.5)], ticks=20, with_scan=True)
        self.assertEqual((response.tick, response.done), (20, False))
        seen = response.observations[0]
        self.assertAlmostEqual(seen.pose.x, 2.0, places=9)
        self.assertAlmostEqual(seen.goal.x, 2.0, places=9)
        self.assertEqual((seen.name, seen.twist.linear.x, seen.arrived), ('tug', 0.5, False))
        self.assertEqual(len(seen.scan.ranges), 720)
        self.assertAlmostEqual(seen.scan.ranges[360], 3.0, places=6)
        # The person walks from x = 0 towards x = 1 in this time.
        self.assertGreater(seen.clearance, math.hypot(1.0, 20.0) - 0.55 - 0.01)
        self.assertLess(seen.clearance, math.hypot(2.0, 20.0) - 0.55 + 0.01)

    def test_without_ticks_it_observes(self):
        self.start_all()
        first = self.step_robots(ticks=0, with_scan=True)
        self.assertEqual((first.tick, first.observations[0].pose.x), (0, 1.0))
        self.assertEqual(self.step_robots(ticks=0, with_scan=True).observations[0].scan.ranges,
                         first.observations[0].scan.ranges)

    def test_it_ends_with_the_episode(self):
        self.start_all(scenario(duration=2))
        response = self.step_robots(['tug'], [command(0.5)], ticks=100)
        self.assertEqual((response.episode, response.tick, response.done), (0, 20, True))
        self.assertAlmostEqual(response.observations[0].pose.x, 2.0, places=9)
        following = self.step_robots(ticks=0)
        self.assertEqual((following.episode, following.tick), (1, 0))
        self.assertEqual(following.observations[0].pose.x, 1.0)

    def test_commands_of_topics_are_not_used(self):
        self.start_all(scenario(more=', cmd_timeout: 100'))
        self.send(self.commander(), command(1.0), 1)
        before = self.step_robots(ticks=0).observations[0].pose.x
        after = self.step_robots(['tug'], [command(0.0)], ticks=3).observations[0].pose.x
        self.assertEqual(after, before)

    def test_robots_that_are_commanded_by_it_have_no_timeouts(self):
        self.start_all()
        self.send(self.commander(), command(0.1), 1)
        before = self.states.messages[-1].robots[0].command_timeouts
        response = self.step_robots(['tug'], [command(0.5)], ticks=20)
        self.assertEqual(self.states.wait_at(response.episode, response.tick).robots[0].command_timeouts, before)
        self.assertEqual(self.walk(10).command_timeouts, before + 1)

    def test_clearance_is_that_of_the_footprint(self):
        # The person stands 1 m beside a robot that is 2 m long and 0.4 m wide.
        text = scenario().replace('radius: 0.3', 'footprint: [[-1, -0.2], [1, -0.2], [1, 0.2], [-1, 0.2]]')
        self.start_all(text.replace('[0, 20], goal: [100, 20]', '[1.5, 1], goal: [9, 1]'))
        self.assertAlmostEqual(self.step_robots(ticks=0).observations[0].clearance, 1.0 - 0.2 - 0.25, places=9)

    def test_contacts_are_those_of_all_ticks(self):
        # A person crosses the way of a robot that stands: in the middle of these ticks they touch (ghosts).
        text = scenario().replace('[0, 20], goal: [100, 20]', '[1, -2], goal: [1, 9]').replace('solid', 'ghost')
        self.start_all(text.replace('max_speed: 1.0', 'max_speed: 1.0, perceived: false'))
        seen = self.step_robots(ticks=100).observations[0]
        self.assertEqual((list(seen.contacts), list(seen.contacts_by_person)), ([0], [0]))
        self.assertEqual(list(self.step_robots(ticks=1).observations[0].contacts), [])
        self.assertEqual(list(self.step_robots(ticks=0).observations[0].contacts), [])

    def test_scans_show_changes_within_a_tick(self):
        self.start_all()
        self.assert_ahead(4.0)
        wall = self.succeed('crowd_controller/add_wall', begin=Point(3.0, -1.0, 0.0), end=Point(3.0, 1.0, 0.0)).wall
        self.assert_ahead(2.0)
        self.succeed('crowd_controller/remove_wall', wall=wall)
        self.assert_ahead(4.0)

    def assert_ahead(self, expected):
        """Checks the range ahead of the robot, without a tick."""
        observed = self.step_robots(ticks=0, with_scan=True).observations[0]
        self.assertAlmostEqual(observed.scan.ranges[360], expected, places=6)

    def test_remaining_distance_is_that_via_all_goals(self):
        self.start_all(scenario(more=', goals: [[3, 0], [3, 4], [2, 4]]'))
        self.assertAlmostEqual(self.step_robots(ticks=0).observations[0].remaining_distance, 7.0, places=9)
        self.assertAlmostEqual(self.step_robots(['tug'], [command(0.5)], ticks=20).observations[0].remaining_distance,
                               6.0, places=9)

    def test_the_same_commands_give_the_same_observations(self):
        noisy = ', scan: {rays: 100, noise: 0.02, dropout: 0.1}, odometry: {distance: 0.1}'
        self.start_all(scenario(more=noisy))

        def run(seed):
            self.succeed('crowd_controller/reset', keep_seed=False, seed=seed)
            seen = [self.step_robots(['tug'], [command(0.5, 0.1 * i)], with_scan=True).observations[0]
                    for i in range(10)]
            return [(repr(one.pose), repr(one.twist), repr(one.scan.ranges)) for one in seen]

        first = run(3)
        self.assertEqual(run(3), first)
        self.assertNotEqual(run(4), first)

    def test_errors(self):
        self.start_all()
        self.refuse_steps("no robot 'cart'", robots=['cart'], commands=[Twist()])
        self.refuse_steps('expected one for each of 1 robots, got 0', robots=['tug'])
        self.refuse_steps("'tug' is there twice", robots=['tug', 'tug'], commands=[Twist(), Twist()])
        self.refuse_steps('finite', robots=['tug'], commands=[command(math.nan)])
        self.assertEqual(self.step_robots(ticks=0).tick, 0)
        self.succeed('crowd_controller/pause', data=False)
        self.refuse_steps('call ~pause first')

    def test_without_robots(self):
        self.start_learner()
        self.start_controller(support.CIRCLE6, paused=True)
        self.refuse_steps('no robots')


if __name__ == '__main__':
    support.run('step_robots_test')
