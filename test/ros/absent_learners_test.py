#!/usr/bin/python3
"""Learners that are killed, come back, never come, or answer what nobody asked: the episode goes on."""
import math

import rospy
import support
from geometry_msgs.msg import Point, Pose2D
from perceiving import Perceiver, add_agent, ahead, answers_of, perceptions
from rosgraph_msgs.msg import Log
from social_crowd.msg import AgentStates, EpisodeResult, Perceptions, RelativeAction, RelativeActions

NAN, INFINITE = float('nan'), float('inf')
AHEAD, BACK = (0.0, 1.0), (math.pi, 1.0)  # rotation, share of the speed
# Two agents that see nobody and walk straight ahead for all of the episode.
QUIET = """
name: quiet
duration: {seconds}
goal_tolerance: 0.3
agents:
  - {{position: [0, 0], goal: [100, 0], speed: 0.5, radius: 0.25}}
  - {{position: [0, 10], goal: [100, 10], speed: 0.5, radius: 0.25}}
"""


class AbsenceTestCase(support.CrowdTestCase):
    """A crowd controller that waits only a moment for answers."""

    def start_quiet(self, seconds=1000, **parameters):
        """Starts the controller and listens to it."""
        self.agents = self.listen('agents', AgentStates)
        self.results = self.listen('episode_results', EpisodeResult)
        self.file = self.write('quiet.yaml', QUIET.format(seconds=seconds))
        patience = {'answer_deadline': 1.0, 'misses_until_absent': 2}
        self.controller = self.start_controller(self.file, **dict(patience, **parameters))
        self.agents.wait_connected()
        self.results.wait_connected()

    def start_pair(self):
        """A learner for each agent; the second one can be killed."""
        self.start_learner('learner_0', agents=[0])
        self.second = self.start_learner('learner_1', agents=[1])

    def remove_all(self):
        """Ends the episode with the next tick."""
        for agent in (0, 1):
            self.succeed('crowd_controller/remove_agent', agent=agent)

    def rows(self, instance=0):
        """The recording of an instance: {tick: {agent: (x, y)}}."""
        rows = {}
        for (found, tick, agent), place in support.read_recording(self.path('ros/quiet.csv')).items():
            if found == instance:
                rows.setdefault(tick, {})[agent] = place
        return rows

    def ticks_at_rest(self, agent, instance=0):
        """In how many ticks an agent stayed where it was."""
        walk = [places[agent] for _, places in sorted(self.rows(instance).items()) if agent in places]
        return sum(before == after for before, after in zip(walk, walk[1:]))


class KilledLearnerTest(AbsenceTestCase):
    """A learner that is killed and comes back."""

    def test_step_by_step(self):
        self.start_quiet(paused=True, episodes=1, trajectories=self.path('ros'))
        self.start_pair()
        self.step(5)
        self.second.kill()
        self.step(5)
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
        """Walks a tick; whether agent 1 walked too."""
        response = self.step(1)
        return self.agents.wait_at(0, response.tick).agents[1].velocity.x > 0.0

    def test_while_everybody_walks(self):
        self.start_quiet(pace=30.0, episodes=1, trajectories=self.path('ros'))
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

    def test_the_only_learner(self):
        """Nobody is left to wait for: the episode goes on at the pace of real time, and ends."""
        self.start_quiet(seconds=2, episodes=1, trajectories=self.path('ros'), paused=True, misses_until_absent=1)
        learner = self.start_learner()
        self.step(5)
        learner.kill()
        self.call_later('crowd_controller/pause', data=False).result()
        self.assertEqual(self.controller.wait(), 0)
        result = self.results.wait()
        self.assertEqual((result.tick, result.missed_answers), (20, 30))
        self.assertEqual(self.rows()[20], self.rows()[5])

    def test_it_learns_nothing_from_the_gap(self):
        """A learner that hangs for a while is told that its late answer was not carried out."""
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
    """Nobody answers at all."""

    def test_a_warning_and_no_hang(self):
        log = self.listen('/rosout', Log)
        self.start_quiet(start_deadline=0.5)
        name = f'{self.namespace}/crowd_controller'
        warning = log.wait(lambda entry: entry.name == name and entry.level == Log.WARN)
        self.assert_says(warning.msg, 'no learner', f'{self.namespace}/actions', '0, 1')
        self.agents.wait(lambda message: message.tick >= 3, 'although there is no learner')
        self.assertIn('no learner', self.controller.output())
        states = self.agents.messages[-1]
        self.assertEqual([(agent.pose.x, agent.pose.y) for agent in states.agents], [(0, 0), (0, 10)])
        self.start_learner()
        self.agents.wait(lambda message: all(agent.pose.x > 0.0 for agent in message.agents), 'once a learner is there')

    def test_services_answer_meanwhile(self):
        self.start_quiet(start_deadline=300.0)
        spawned = self.succeed('crowd_controller/spawn_agent', pose=Pose2D(0, 20, 0), goal=Point(100, 20, 0), speed=0.5,
                               radius=0.25)
        self.assertEqual(spawned.agent, 2)
        self.succeed('crowd_controller/set_goal', agent=0, goal=Point(0, 5, 0))
        self.succeed('crowd_controller/reset', keep_seed=True)
        self.succeed('crowd_controller/pause', data=True)
        self.succeed('crowd_controller/load_scenario', scenario=support.CIRCLE6)
        self.succeed('crowd_controller/pause', data=False)
        self.succeed('crowd_controller/pause', data=True)
        self.assertEqual(self.controller.stop(), 0)

    def test_a_learner_for_only_some(self):
        """The others are waited for no longer than the start deadline, together and once."""
        self.start_quiet(seconds=3, start_deadline=0.5, episodes=2, trajectories=self.path('ros'))
        self.start_learner(agents=[1])
        self.assertEqual(self.controller.wait(), 0)
        support.wait_for(lambda: len(self.results.messages) == 2, 'both results')
        self.assertEqual(self.ticks_at_rest(0, 1), 30)
        self.assertEqual(self.ticks_at_rest(1, 1), 0)
        self.assertEqual(self.results.messages[1].missed_answers, 30)


class RestartedControllerTest(AbsenceTestCase):
    """A controller that comes after another one, while the learner stays."""

    def test_answers_to_the_one_before_are_not_taken(self):
        """The learner's last answer is latched and may be for episode 0, tick 0 of the controller before."""
        self.start_learner(agents=[0, 1])
        before = Perceiver(self)
        message = add_agent(add_agent(perceptions(0, 0), 0, ahead(180, 5)), 1, ahead(180, 5))
        self.assertAlmostEqual(abs(before.ask(message)[0][0]), math.pi)
        before.publisher.unregister()
        self.start_quiet(seconds=2, episodes=1, trajectories=self.path('ros'), answer_deadline=60.0)
        self.assertEqual(self.controller.wait(), 0)
        self.assert_same_recording(support.read_bytes(self.path('ros/quiet.csv')), self.headless(self.file))


class Answers:
    """A learner that sends everybody straight ahead, and beside that whatever a test wants."""

    def __init__(self, test):
        self.silent = set()  # agents that get no answer
        self.before = lambda perceived: []  # answers sent before the right one
        self.after = lambda perceived: []  # and after it
        self.answered = set()  # (episode, tick); perceptions may come twice at first, as they are latched
        self.publisher = rospy.Publisher(f'{test.namespace}/actions', RelativeActions, queue_size=1000)
        test.addCleanup(self.publisher.unregister)
        support.wait_for(lambda: self.publisher.get_num_connections() > 0, 'the controller to listen')
        self.subscriber = rospy.Subscriber(f'{test.namespace}/perceptions', Perceptions, self.answer, tcp_nodelay=True)
        test.addCleanup(self.subscriber.unregister)

    def answer(self, perceived):
        """Answers perceptions."""
        now = (perceived.episode, perceived.tick)
        if perceived.last or now in self.answered:
            return
        self.answered.add(now)
        agents = [agent.agent for agent in perceived.agents if agent.agent not in self.silent]
        right = actions_for(perceived.episode, perceived.tick, {agent: AHEAD for agent in agents})
        for message in self.before(perceived) + [right] + self.after(perceived):
            message.header = perceived.header
            message.run = message.run or perceived.run
            self.publisher.publish(message)


def actions_for(episode, tick, actions):
    """An answer: {agent: (rotation, share of the speed)}."""
    message = RelativeActions(episode=episode, tick=tick)
    message.agents = [RelativeAction(agent, *action) for agent, action in actions.items()]
    return message


class WrongAnswersTest(AbsenceTestCase):
    """Answers that nobody asked for are dropped and counted, and nothing else changes."""

    def check(self, wrong, count, after=False):
        """Walks an episode without and one with wrong answers, of which so many are dropped a tick."""
        self.start_quiet(seconds=3, paused=True, trajectories=self.path('ros'))
        answers = Answers(self)
        self.step(30)
        # Not in the last tick, of which the answers might come after the episode's end.
        setattr(answers, 'after' if after else 'before', lambda now: wrong(now) if now.tick < 29 else [])
        self.step(30)
        results = [self.results.wait_at(episode, 30) for episode in (0, 1)]
        self.assertEqual((results[0].dropped_answers, results[0].missed_answers), (0, 0))
        self.assertEqual((results[1].dropped_answers, results[1].missed_answers), (count * 29, 0))
        self.assertEqual(self.rows(1), self.rows(0))
        self.assertAlmostEqual(self.rows(1)[30][0][0], 1.5)

    def test_for_an_old_tick(self):
        self.check(lambda now: [actions_for(now.episode, (now.tick - 1) % 2**64, {0: BACK})], 1)

    def test_for_a_tick_to_come(self):
        self.check(lambda now: [actions_for(now.episode, now.tick + 1, {0: BACK, 1: BACK})], 2)

    def test_for_another_episode(self):
        self.check(lambda now: [actions_for(episode, now.tick, {0: BACK}) for episode in (0, 2, 2**64 - 1)], 3)

    def test_for_another_controller(self):
        def to_another(now):
            message = actions_for(now.episode, now.tick, {0: BACK})
            message.run = now.run + 1
            return [message]

        self.check(to_another, 1)

    def test_for_unknown_agents(self):
        self.check(lambda now: [actions_for(now.episode, now.tick, {2: BACK, 9999: BACK, 2**32 - 1: BACK})], 3)

    def test_that_are_no_numbers(self):
        bad = [(NAN, 1.0), (0.0, NAN), (INFINITE, 1.0), (-INFINITE, 1.0), (0.0, INFINITE), (0.0, 1.001), (0.0, -0.001)]
        self.check(lambda now: [actions_for(now.episode, now.tick, {0: action}) for action in bad], len(bad))

    def test_a_second_answer_before_the_tick_ends(self):
        """The answer to agent 0 that comes first is carried out, not the two that follow."""
        self.check(lambda now: [actions_for(now.episode, now.tick, {0: action}) for action in (AHEAD, BACK)], 2)

    def test_a_second_answer_after_all_have_answered(self):
        self.check(lambda now: [actions_for(now.episode, now.tick, {0: BACK, 1: BACK})], 2, after=True)

    def test_a_second_answer_in_the_same_message(self):
        def twice(now):
            message = actions_for(now.episode, now.tick, {0: AHEAD})
            message.agents.append(RelativeAction(0, *BACK))
            return [message]

        self.check(twice, 2)


class LateLearnerTest(AbsenceTestCase):
    """What a learner that comes in the middle does."""

    def test_it_answers_the_tick_that_is_waited_for(self):
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
