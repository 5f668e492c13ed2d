#!/usr/bin/python3
"""The crowd controller uses the widest vision that learners report; each learner decides within its own vision."""
import rospy
import support
from answering import Answers
from learning_files import NEAREST_MODEL, QTableFile, config_text
from social_crowd.msg import EpisodeResult, LearnerStatus, Perceptions
from walking import EPISODES, SCENARIO, WalkTestCase

MARGIN = 1e-6  # [m], by which a model's vision exceeds that of its state set
DEFAULT = (6.0, 0, False)  # radius [m], maximum number of neighbours, occlusion
NOT_THERE = 99  # id of an agent that is in no scenario
# Three slow agents in a row, so that the middle one hides the last from the first; a wall behind them.
ROW = """
name: row
duration: 1000
goal_tolerance: 0.2
agents:
  - {position: [0, 0], goal: [9, 5], speed: 0.001, radius: 0.25}
  - {position: [2, 0], goal: [9, 0], speed: 0.001, radius: 0.25}
  - {position: [4, 0], goal: [9, -5], speed: 0.001, radius: 0.25}
walls:
  - [[5, -0.1], [5, 0.1]]
"""
# Two agents 3.5 m apart, which evade each other at once if their vision is larger.
HEAD_ON = """
name: head_on
duration: 20
goal_tolerance: 0.2
agents:
  - {position: [-2, 0], goal: [4, 0], speed: 1, radius: 0.25}
  - {position: [2, 0.1], goal: [-4, 0], speed: 1, radius: 0.25}
"""
PROGRESS = 'reward: {type: progress}'


def vision_of(message):
    """Returns radius, number of neighbours and occlusion of a message."""
    return message.vision_radius, message.max_neighbours, message.occlusion


class VisionTestCase(WalkTestCase):
    """Walks until the controller has received what learners report."""

    def perceived(self):
        """Returns the perceptions of the next tick."""
        response = self.step()
        return self.perceptions.wait_at(response.episode, response.tick - 1)

    def expect(self, *vision):
        """Walks until the controller uses a vision. Returns the perceptions."""
        def is_used():
            message = self.perceived()
            return message if vision_of(message) == vision else None

        return support.wait_for(is_used, f'perceptions with vision {vision}')


class WidestVisionTest(VisionTestCase):
    """The vision of the perceptions depends on the reports of learners."""

    def start_row(self, **parameters):
        """Starts a controller and a learner that reports nothing."""
        self.statuses = {}
        self.perceptions = self.listen('perceptions', Perceptions)
        self.controller = self.start_controller(self.write('row.yaml', ROW), **dict({'paused': True}, **parameters))
        self.perceptions.wait_connected()
        self.answers = Answers(self)

    def report(self, learner, radius, max_neighbours=0, occlusion=False, wall_distance=0.0):
        """Publishes the status of a learner."""
        if learner not in self.statuses:
            # rospy drops the oldest of many messages at once, unless the queue is unlimited.
            self.statuses[learner] = rospy.Publisher(f'{self.namespace}/learner_status', LearnerStatus, queue_size=0)
            self.addCleanup(self.statuses[learner].unregister)
            support.wait_for(lambda: self.statuses[learner].get_num_connections() > 0, 'the controller to subscribe')
        self.statuses[learner].publish(LearnerStatus(node=learner, vision_radius=radius, occlusion=occlusion,
                                                     wall_distance=wall_distance, max_neighbours=max_neighbours))

    def test_default_before_any_report(self):
        self.start_row()
        message = self.perceived()
        self.assertEqual(vision_of(message), DEFAULT)
        self.assertEqual([(agent.neighbour_count, agent.wall_count) for agent in message.agents], [(2, 1)] * 3)

    def test_largest_radius_and_number_of_neighbours(self):
        self.start_row()
        self.report('/a', 3.0, max_neighbours=4)
        message = self.expect(3.0, 4, False)
        self.assertEqual([agent.neighbour_count for agent in message.agents], [1, 2, 1])
        self.report('/b', 5.0, max_neighbours=1)
        self.expect(5.0, 4, False)
        self.report('/b', 5.0)
        self.expect(5.0, 0, False)

    def test_largest_distance_to_walls(self):
        self.start_row()
        self.report('/a', 6.0, wall_distance=0.1)
        self.assertEqual([agent.wall_count for agent in self.expect_walls(0.1).agents], [0, 0, 0])
        self.report('/b', 6.0, wall_distance=0.2)
        self.expect_walls(0.2)
        self.report('/b', 6.0)
        self.assertEqual([agent.wall_count for agent in self.expect_walls(0.0).agents], [1, 1, 1])

    def expect_walls(self, distance):
        """Walks until the controller perceives walls up to a distance; 0: all. Returns the perceptions."""
        def is_used():
            message = self.perceived()
            return message if message.wall_distance == distance else None

        return support.wait_for(is_used, f'walls up to {distance} m')

    def test_occlusion_if_all_learners_request_it_with_the_same_radius(self):
        self.start_row()
        self.report('/a', 7.0, max_neighbours=5, occlusion=True)
        message = self.expect(7.0, 5, True)
        self.assertEqual([(agent.neighbour_count, agent.wall_count) for agent in message.agents],
                         [(1, 0), (2, 0), (1, 1)])
        self.report('/b', 7.0, max_neighbours=6, occlusion=True)
        self.expect(7.0, 6, True)
        self.report('/b', 5.0, max_neighbours=6, occlusion=True)
        self.expect(7.0, 0, False)  # learners then compute occlusion from all bodies
        self.report('/b', 7.0, max_neighbours=6)
        self.report('/c', 8.0, max_neighbours=2)
        self.expect(8.0, 0, False)

    def test_new_report_replaces_the_previous_one(self):
        self.start_row()
        self.report('/a', 9.0)
        self.expect(9.0, 0, False)
        self.report('/a', 3.0, max_neighbours=2)
        self.expect(3.0, 2, False)

    def test_reports_without_a_valid_radius(self):
        self.start_row()
        self.report('/a', 0.0)  # no request
        self.report('/a', float('nan'))
        self.report('/a', float('inf'))
        self.report('/b', 3.0, max_neighbours=2)
        self.expect(3.0, 2, False)
        support.wait_for(lambda: self.controller.output().count('is ignored') == 2, 'two warnings')
        self.assert_says(self.controller.output(), "'/a' requests a vision radius of nan")

    def test_reports_beyond_the_limits(self):
        self.start_row()
        self.report('/a', 1e17)
        self.report('/a', 9.0, max_neighbours=2**32 - 1)
        self.report('/b', 3.0, max_neighbours=2)
        self.expect(3.0, 2, False)
        support.wait_for(lambda: self.controller.output().count('is ignored') == 2, 'two warnings')
        self.assert_says(self.controller.output(), 'a vision radius of 1e+17; expected at most 1e+06 m.',
                         'up to 4294967295 neighbours; expected at most 1000, or 0 for all.')

    def test_wider_vision_while_answers_are_awaited(self):
        """The tick is perceived again; accepted answers stay valid."""
        self.start_row()
        self.answers.silent = {2}
        task = self.call_later('crowd_controller/step', ticks=1)
        self.perceptions.wait_at(0, 0)
        self.report('/a', 9.0)
        again = self.perceptions.wait(lambda message: message.vision_radius == 9.0, 'with the wider vision')
        self.assertEqual((again.tick, vision_of(again)), (0, (9.0, 0, False)))
        self.assertEqual([agent.agent for agent in again.agents], [0, 1, 2])
        self.assertFalse(task.is_done())
        self.start_learner(agents=[2])
        self.assertTrue(task.result('the end of the tick').success)

    def test_agents_spawned_and_removed_before_a_wider_vision(self):
        """The tick is perceived again, for the agents of that time."""
        results = self.listen('episode_results', EpisodeResult)
        self.start_controller(self.write('row.yaml', ROW.replace('duration: 1000', 'duration: 0.5')), episodes=1)
        results.wait_connected()
        self.succeed('crowd_controller/remove_agent', agent=0)
        self.succeed('crowd_controller/spawn_agent', max_speed=0.1, radius=0.2)
        self.start_learner(q_table=support.ANTICIPATION_TABLE)
        result = results.wait()
        self.assertEqual((result.missed_answers, result.dropped_answers), (0, 0))
        self.assertEqual([agent.removed for agent in result.agents], [True, False, False, False])


class MixedLearnersTest(VisionTestCase):
    """Learners with different visions: each gives the same decisions and tables as without ROS."""

    def start_other(self, table):
        """Starts a learner that answers for no agent and only reports a vision."""
        self.start_learner('other', q_table=table, agents=[NOT_THERE])

    def start_paused(self, **parameters):
        """Starts the controller."""
        self.perceptions = self.listen('perceptions', Perceptions)
        self.start_walk(paused=True, **parameters)
        self.perceptions.wait_connected()

    def go_on(self):
        """Walks to the end."""
        self.succeed('crowd_controller/pause', data=False)

    def check(self, table, other, *vision):
        """Compares the recording of a learner, beside another one, with that of `evaluate`."""
        self.start_learner(q_table=table)
        self.start_other(other)
        self.start_paused()
        self.expect(*vision)
        self.go_on()
        self.check_recording(table)

    def check_recording(self, table):
        """Compares the recording with that of `evaluate`."""
        self.assert_same_recording(self.finish_walk(), self.headless(SCENARIO, table, episodes=EPISODES, seed=5))

    def test_smaller_radius_and_fewer_neighbours(self):
        table = self.train_anticipation(vision_radius=2, max_neighbours=3)
        self.check(table, support.ANTICIPATION_TABLE, 6.0 + MARGIN, 16, False)

    def test_smaller_radius_without_a_limit_of_neighbours(self):
        table = self.train_anticipation(vision_radius=1.5, max_neighbours=0)
        self.check(table, support.ANTICIPATION_TABLE, 6.0 + MARGIN, 0, False)

    def test_occlusion_beside_a_learner_without_occlusion(self):
        table = self.train_anticipation('vision: {occlusion: true}')
        self.check(table, support.NEAREST_TABLE, 6.0 + MARGIN, 0, False)

    def test_occlusion_beside_occlusion_with_another_radius(self):
        table = self.train_anticipation('vision: {occlusion: true}', vision_radius=2)
        wide = self.train_anticipation('vision: {occlusion: true}', 'wide.txt')
        self.check(table, wide, 6.0 + MARGIN, 0, False)

    def test_learner_with_wider_vision_joins_late(self):
        table = self.train_anticipation(vision_radius=2, max_neighbours=3)
        self.start_learner(q_table=table)
        self.start_paused()
        self.expect(2.0 + MARGIN, 3, False)
        self.start_other(support.ANTICIPATION_TABLE)
        self.expect(6.0 + MARGIN, 16, False)
        self.go_on()
        self.check_recording(table)

    def test_crowd_waits_for_a_learner_with_wider_vision(self):
        """The first perceptions have the smaller vision; the learner with the wider vision does not answer them."""
        scenario = self.write('head_on.yaml', HEAD_ON)
        narrow = self.start_learner('narrow')
        self.start_paused(scenario=scenario, episodes=1)
        self.expect(1.0 + MARGIN, 0, False)
        self.assertEqual(narrow.stop(), 0)
        self.succeed('crowd_controller/reset', keep_seed=True)
        self.go_on()
        first = self.perceptions.wait_at(1, 0)
        self.assertEqual(vision_of(first), (1.0 + MARGIN, 0, False))
        self.start_learner(q_table=support.ANTICIPATION_TABLE)
        self.assert_same_recording(self.finish_walk(), self.headless(scenario, support.ANTICIPATION_TABLE))

    def test_training_beside_a_learner_with_wider_vision(self):
        """The reward depends on all neighbours in the perceptions."""
        model = NEAREST_MODEL.replace('reward: {goal: cosine_cubed, arrival: 100, obstacle_cost: 80}', PROGRESS)
        config = self.write('config.yaml', config_text(SCENARIO, EPISODES, 5, model=model))
        expected = self.path('headless.txt')
        self.tool('train', config, '--output', expected)
        self.start_learner(mode='training', config=config, seed=5)
        self.start_other(support.ANTICIPATION_TABLE)
        self.start_paused()
        self.expect(6.0 + MARGIN, 0, False)
        self.go_on()
        self.finish_walk()
        self.wait_until_learned('learner', QTableFile(expected).header['decisions'])
        self.succeed('learner/save_q_table', file=self.path('ros.txt'))
        self.assertEqual(support.read_text(self.path('ros.txt')), support.read_text(expected))


if __name__ == '__main__':
    support.run('vision_test')
