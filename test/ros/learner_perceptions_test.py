#!/usr/bin/python3
"""Answers of a learner, also to invalid perceptions."""
import math

import support
from learning_files import q_table_text
from perceiving import add_agent, ahead, all_situations, perceptions
from rosgraph_msgs.msg import Log
from teaching import LearnerTestCase

NAN = float('nan')


class PerceptionsTest(LearnerTestCase):
    """Answers of a learner to valid and invalid perceptions."""

    def test_answers_only_for_its_agents(self):
        self.start_one(agents=[1, 3])
        message = perceptions(0, 0)
        for agent in range(5):
            add_agent(message, agent, ahead(0, 5))
        self.assertEqual(set(self.perceiver.ask(message)), {1, 3})

    def test_does_not_answer_for_arrived_agents(self):
        self.start_one()
        message = add_agent(add_agent(perceptions(0, 1), 0, ahead(0, 0.1), arrived=True), 1, ahead(0, 5))
        self.assertEqual(set(self.perceiver.ask(message)), {1})

    def test_does_not_answer_the_last_perceptions(self):
        self.start_one()
        self.walk(0, 1)
        self.perceiver.tell(add_agent(perceptions(0, 1, last=True), 0, ahead(0, 5)))
        self.walk(1, 1)  # answered after an answer to the last ones of episode 0 would arrive
        answered = [(answer.episode, answer.tick) for answer in self.perceiver.actions.messages]
        self.assertEqual(answered, [(0, 0), (1, 0)])

    def test_answer_contains_run_episode_and_tick(self):
        self.start_one(q_table=self.write('back.txt', q_table_text({4: {4: (1, 1.0)}})))  # goal behind: turn back
        message = add_agent(perceptions(2**40, 2**33), 0, ahead(180, 5))
        message.run = 2**63 + 1
        rotation, speed_fraction = self.perceiver.ask(message)[0]
        self.assertAlmostEqual(abs(rotation), math.pi)
        self.assertEqual(speed_fraction, 1.0)
        answer = self.perceiver.actions.messages[-1]
        self.assertEqual((answer.header.frame_id, answer.header.stamp), ('map', message.header.stamp))
        self.assertEqual(answer.run, message.run)

    def senseless(self):
        """Returns inconsistent perceptions and perceptions with NaN, each with its own tick."""
        beyond = add_agent(perceptions(0, 1), 0, ahead(0, 5), ahead(0, 1))
        beyond.agents[0].neighbour_count = 2**32 - 1
        walls = add_agent(perceptions(0, 2), 0, ahead(0, 5))
        walls.agents[0].first_wall = 2**32 - 1
        walls.agents[0].wall_count = 1
        no_agent = add_agent(perceptions(0, 3), 2**32 - 1, ahead(0, 5))
        no_goal = add_agent(perceptions(0, 4), 0, (NAN, 1.0))
        infinite = add_agent(perceptions(0, 5), 0, (float('inf'), 1.0))
        return [beyond, walls, no_agent, no_goal, infinite]

    def test_invalid_perceptions_are_dropped_with_a_warning(self):
        log = self.listen('/rosout', Log)
        self.start_one()
        log.wait_served_by(f'{self.namespace}/learner')
        before = self.perceiver.ask(all_situations())
        for message in self.senseless():
            self.perceiver.tell(message)
        after = self.perceiver.ask(all_situations(tick=9))
        self.assertEqual(after, before)
        self.assertEqual([answer.tick for answer in self.perceiver.actions.messages], [0, 9])
        name = f'{self.namespace}/learner'
        log.wait(lambda entry: entry.name == name and 'perceptions were dropped' in entry.msg, 'a warning')

    def test_bodies_with_invalid_positions_are_harmless(self):
        self.start_one()
        for tick, place in enumerate([(NAN, 0.0), (float('inf'), 0.0), (0.0, 0.0)]):
            message = add_agent(perceptions(0, tick), 0, ahead(0, 5), place)
            self.perceiver.tell(message)
        self.perceiver.ask(add_agent(perceptions(0, 9), 0, ahead(0, 5)))
        for answer in self.perceiver.actions.messages:
            self.assertTrue(math.isfinite(answer.agents[0].rotation), f'the answer of tick {answer.tick}')


if __name__ == '__main__':
    support.run('learner_perceptions_test')
