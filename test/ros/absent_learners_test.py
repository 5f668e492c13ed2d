#!/usr/bin/python3
"""Learners that are killed, come back, or never come: the episode goes on."""
import math

import support
from answering import QUIET, AbsenceTestCase, Answers
from geometry_msgs.msg import Point, Pose2D
from perceiving import Perceiver, add_agent, ahead, answers_of, perceptions
from rosgraph_msgs.msg import Log
from social_crowd.msg import LearnerStatus, Perceptions, RelativeActions


class KilledLearnerTest(AbsenceTestCase):
    """A learner that is killed and comes back."""

    def test_crowd_continues_when_stepped(self):
        self.start_quiet(paused=True, episodes=1, trajectories=self.path('ros'))
        self.start_pair()
        self.step(5)
        self.second.kill()
        self.step(5)
        self.assertIn('no answer for agent 1 for ', self.controller.output())
        self.assertIn('not waited for until', self.controller.output())
        states = self.agents.wait_at(0, 10)
        self.assertAlmostEqual(states.agents[0].pose.x, 0.5)
        self.assertAlmostEqual(states.agents[1].pose.x, 0.25, msg='it stays put while its learner is away')
        self.start_learner('learner_1', agents=[1])
        support.wait_for(self.second_walks, 'agent 1 to walk again')
        self.step(20)
        self.remove_all()
        self.step(1)
        missed = self.results.wait().missed_answers
        self.assertGreaterEqual(missed, 5)
        self.assertEqual(missed, self.ticks_at_rest(1))
        self.assertEqual(self.ticks_at_rest(0), 0)

    def second_walks(self):
        """Walks a tick. Returns whether agent 1 moved."""
        response = self.step(1)
        return self.agents.wait_at(0, response.tick).agents[1].velocity.x > 0.0

    def test_crowd_continues_while_walking(self):
        self.start_quiet(real_time_factor=30.0, episodes=1, trajectories=self.path('ros'))
        self.start_pair()
        self.agents.wait(lambda message: message.tick > 10)
        self.second.kill()
        stands = self.agents.wait(lambda message: message.tick > 10 and message.agents[1].velocity.x == 0.0)
        stood = self.agents.wait(lambda message: message.tick > stands.tick + 5)
        self.assertEqual(stood.agents[1].velocity.x, 0.0)
        self.start_learner('learner_1', agents=[1])
        self.agents.wait(lambda message: message.tick > stood.tick and message.agents[1].velocity.x > 0.0)
        self.remove_all()
        self.assertEqual(self.controller.wait(), 0)
        result = self.results.wait()
        self.assertGreaterEqual(result.missed_answers, 5)
        self.assertEqual(result.missed_answers, self.ticks_at_rest(1))
        self.assertEqual(self.ticks_at_rest(0), 0)

    def test_episode_ends_without_any_learner(self):
        """If all agents are absent, the episode continues in real time until its end."""
        self.start_quiet(seconds=2, episodes=1, trajectories=self.path('ros'), paused=True, misses_until_absent=1)
        learner = self.start_learner()
        self.step(5)
        learner.kill()
        self.call_later('crowd_controller/pause', data=False).result()
        self.assertEqual(self.controller.wait(), 0)
        self.assertIn('no answer for agents 0, 1 for ', self.controller.output())
        result = self.results.wait()
        self.assertEqual((result.tick, result.missed_answers), (20, 30))
        self.assertEqual(self.rows()[20], self.rows()[5])

    def test_learner_learns_nothing_from_missed_ticks(self):
        """A learner that hangs for a while perceives that its late answer was not executed."""
        heard = self.listen('perceptions', Perceptions)
        self.start_quiet(paused=True)
        heard.wait_connected()
        answers = Answers(self)
        self.step(3)
        answers.silent = {1}
        self.step(1)
        answers.silent = set()
        self.step(2)
        acted = {tick: {agent.agent: agent.acted for agent in heard.wait_at(0, tick).agents} for tick in (3, 4, 5)}
        self.assertEqual(acted, {3: {0: True, 1: True}, 4: {0: True, 1: False}, 5: {0: True, 1: True}})


class NoLearnerTest(AbsenceTestCase):
    """No learner answers."""

    def test_controller_warns_and_does_not_hang(self):
        log = self.listen('/rosout', Log)
        self.start_quiet(start_deadline=0.5, paused=True)
        name = f'{self.namespace}/crowd_controller'
        log.wait_served_by(name)
        self.succeed('crowd_controller/pause', data=False)
        warning = log.wait(lambda entry: entry.name == name and entry.level == Log.WARN)
        self.assert_says(warning.msg, 'no learner', f'{self.namespace}/actions', '0, 1')
        self.agents.wait(lambda message: message.tick >= 3, 'although there is no learner')
        self.assertIn('no learner', self.controller.output())
        states = self.agents.messages[-1]
        self.assertEqual([(agent.pose.x, agent.pose.y) for agent in states.agents], [(0, 0), (0, 10)])
        self.start_learner()
        self.agents.wait(lambda message: all(agent.pose.x > 0.0 for agent in message.agents), 'once a learner is there')

    def test_services_answer_while_waiting(self):
        self.start_quiet(start_deadline=300.0)
        spawned = self.succeed('crowd_controller/spawn_agent', pose=Pose2D(0, 20, 0), goal=Point(100, 20, 0),
                               max_speed=0.5, radius=0.25)
        self.assertEqual(spawned.agent, 2)
        self.succeed('crowd_controller/set_goal', agent=0, goal=Point(0, 5, 0))
        self.succeed('crowd_controller/reset', keep_seed=True)
        self.succeed('crowd_controller/pause', data=True)
        self.succeed('crowd_controller/load_scenario', scenario='circle6')
        self.succeed('crowd_controller/pause', data=False)
        self.succeed('crowd_controller/pause', data=True)
        self.assertEqual(self.controller.stop(), 0)

    def test_learner_for_some_agents_only(self):
        """The controller waits once for all other agents together, up to the start deadline."""
        status = self.listen('learner_status', LearnerStatus)
        self.start_quiet(seconds=3, start_deadline=0.5, episodes=2, trajectories=self.path('ros'), paused=True)
        self.start_learner(agents=[1])
        status.wait()  # it is there before the second episode
        self.succeed('crowd_controller/pause', data=False)
        self.assertEqual(self.controller.wait(), 0)
        support.wait_for(lambda: len(self.results.messages) == 2, 'both results')
        self.assertEqual(self.ticks_at_rest(0, 1), 30)
        self.assertEqual(self.ticks_at_rest(1, 1), 0)
        self.assertEqual(self.results.messages[1].missed_answers, 30)


class RestartedControllerTest(AbsenceTestCase):
    """A controller that is restarted while its learner keeps running."""

    def test_answers_to_the_previous_controller_are_refused(self):
        """The learner's last answer is latched and may be for episode 0, tick 0 of the previous controller."""
        self.start_learner(agents=[0, 1])
        before = Perceiver(self)
        message = add_agent(add_agent(perceptions(0, 0), 0, ahead(180, 5)), 1, ahead(180, 5))
        self.assertAlmostEqual(abs(before.ask(message)[0][0]), math.pi)
        before.close()
        # No listener: it may be over before they are connected. A pause would keep the latched answer out of its ticks.
        file = self.write('quiet.yaml', QUIET.format(seconds=2))
        controller = self.start_controller(file, episodes=1, trajectories=self.path('ros'), misses_until_absent=2)
        self.assertEqual(controller.wait(), 0)
        self.assert_same_recording(support.read_bytes(self.path('ros/quiet.csv')), self.headless(file))


class LateLearnerTest(AbsenceTestCase):
    """A learner that joins during an episode."""

    def test_late_learner_answers_the_awaited_tick(self):
        self.start_quiet(answer_deadline=60.0, paused=True)
        later = self.call_later('crowd_controller/step', ticks=1)
        actions = self.listen('actions', RelativeActions)
        self.start_learner()
        self.assertEqual(later.result().tick, 1)
        answer = actions.wait()
        self.assertEqual((answer.episode, answer.tick), (0, 0))
        self.assertEqual(set(answers_of(answer)), {0, 1})


if __name__ == '__main__':
    support.run('absent_learners_test')
