#!/usr/bin/python3
"""Services of the crowd controller: pause, step, reset, load_scenario."""
import os

import support
from controlling import QUIET, ControllerTestCase, place_in

# Places that depend on the seed; two documents.
RANDOM = """
name: random
duration: 5
goal_tolerance: 0.3
agents:
  - {count: 3, position: {box: [[0, 0], [9, 9]]}, goal: {box: [[0, 0], [9, 9]]}, speed: [0.4, 0.6], radius: 0.25}
---
name: random_too
duration: 5
goal_tolerance: 0.3
agents:
  - {count: 2, position: {box: [[0, 0], [9, 9]]}, goal: {box: [[0, 0], [9, 9]]}, speed: [0.4, 0.6], radius: 0.25}
"""


class PauseAndStepTest(ControllerTestCase):
    """pause and step."""

    def test_step_answers_when_all_ticks_are_done(self):
        self.start_all()
        for ticks, tick in ((1, 1), (3, 4), (20, 24)):
            response = self.step(ticks)
            self.assertEqual((response.episode, response.tick), (0, tick))
            self.assert_says(response.message, f'tick {tick}')
        message = self.agents.wait_at(0, 24)
        self.assert_place(message, 0, 24 * 0.05, 0)

    def test_step_continues_in_the_next_episode(self):
        self.start_all()
        response = self.step(203)  # an episode lasts 200 ticks
        self.assertEqual((response.episode, response.tick), (1, 3))
        self.results.wait(lambda result: (result.episode, result.tick) == (0, 200))

    def test_step_ends_with_the_last_episode(self):
        self.start_all(episodes=1)
        later = self.call_later('crowd_controller/step', ticks=1000)
        self.assertEqual(self.controller.wait(), 0)
        response = later.result()
        self.assertEqual((response.episode, response.tick), (0, 200))

    def test_invalid_steps_are_refused(self):
        self.start_all(real_time_factor=1.0)
        self.refuse('step', 'at least 1', ticks=0)
        later = self.call_later('crowd_controller/step', ticks=190)
        self.agents.wait(lambda message: message.tick >= 1)
        self.refuse('step', 'in progress', ticks=1)
        self.do('set_real_time_factor', factor=0.0)
        self.assertEqual(later.result().tick, 190)
        self.do('pause', data=False)
        self.refuse('step', 'pause', ticks=1)

    def test_nothing_moves_while_paused(self):
        self.start_all()
        for _ in range(10):
            seen = len(self.agents.messages)
            self.do('pause', data=False)
            support.wait_for(lambda: len(self.agents.messages) > seen, 'the crowd to walk')
            episode, tick = place_in(self.do('pause', data=True).message)
            response = self.step(1)
            over = tick + 1 == 200  # then the next episode begins
            expected = (episode + 1, 0) if over else (episode, tick + 1)
            self.assertEqual((response.episode, response.tick), expected, 'the tick after the one that was paused at')

    def test_pausing_twice_succeeds(self):
        self.start_all()
        self.do('pause', data=True)
        self.do('pause', data=True)
        self.assertEqual(self.step(1).tick, 1)

    def test_ending_the_pause_ends_a_step(self):
        """A call of 1000000 ticks returns when another call ends the pause."""
        self.start_all(real_time_factor=5.0)
        later = self.call_later('crowd_controller/step', ticks=1000000)
        self.agents.wait(lambda message: message.tick >= 1)
        self.do('pause', data=False)
        later.result()


class ResetTest(ControllerTestCase):
    """reset."""

    def record(self, ticks=50):
        """Walks a number of ticks. Returns all positions."""
        response = self.step(ticks)
        self.agents.wait_at(response.episode, response.tick)
        first = response.tick - ticks + 1
        messages = [self.agents.wait_at(response.episode, tick) for tick in range(first, response.tick + 1)]
        return [self.places(message) for message in messages]

    def test_reset_repeats_the_episode(self):
        self.start_all(RANDOM)
        first = self.record(49)
        response = self.do('reset', keep_seed=True)
        self.assert_says(response.message, 'episode 1, tick 0')
        self.assertEqual(self.record(49), first)
        scenario = self.scenarios.wait_at(1, 0)
        self.assertEqual((scenario.name, scenario.instance), ('random', 0))

    def test_reset_returns_to_the_first_instance(self):
        """A reset returns to the first document."""
        self.start_all(RANDOM)
        first = self.record(20)
        self.walk(40)  # 50 ticks an episode
        self.assertEqual(self.scenarios.wait_at(1, 0).name, 'random_too')
        self.do('reset', keep_seed=True)
        self.assertEqual(self.record(20), first)

    def test_reset_with_another_seed(self):
        self.start_all(RANDOM, seed=4)
        first = self.record(20)
        self.assert_says(self.do('reset', keep_seed=False, seed=5).message, 'seed 5')
        other = self.record(20)
        self.assertNotEqual(other, first)
        self.do('reset', keep_seed=False, seed=4)
        self.assertEqual(self.record(20), first)

    def test_reset_starts_a_new_recording(self):
        self.start_all(RANDOM, trajectories=self.path('ros'), seed=4)
        self.step(60)
        self.do('reset', keep_seed=False, seed=9)
        self.step(100)
        expected = self.headless(self.file, seed=9)
        self.assert_same_recording(support.read_bytes(self.path('ros/scene.csv')), expected)

    def test_reset_while_walking(self):
        """Resets at any time within a tick: the crowd continues to walk, and earlier answers are not used."""
        self.start_all(RANDOM)
        first = self.record(10)
        self.do('pause', data=False)
        for _ in range(20):
            self.do('reset', keep_seed=True)
        self.do('pause', data=True)
        self.do('reset', keep_seed=True)
        self.assertEqual(self.record(10), first)


class LoadScenarioTest(ControllerTestCase):
    """load_scenario."""

    def test_loads_a_file(self):
        self.start_all()
        self.step(3)
        file = self.write('random.yaml', RANDOM)
        response = self.do('load_scenario', scenario=file)
        self.assertEqual(response.documents, 2)
        self.assert_says(response.message, file)
        scenario = self.scenarios.wait(lambda message: message.name == 'random')
        self.assertEqual((scenario.episode, scenario.instance, len(scenario.agents)), (1, 0, 3))
        response = self.step(2)
        self.assertEqual((response.episode, response.tick), (1, 2))

    def test_loads_a_shipped_scenario_by_name(self):
        self.start_all()
        self.do('load_scenario', scenario='circle6')
        self.scenarios.wait(lambda message: message.name == 'circle6')
        self.refuse('load_scenario', "did you mean 'circle12'?", scenario='circel12')

    def test_starts_a_new_recording(self):
        self.start_all(trajectories=self.path('ros'))
        self.step(3)
        file = self.write('random.yaml', RANDOM)
        self.do('load_scenario', scenario=file)
        self.step(100)
        self.assert_same_recording(support.read_bytes(self.path('ros/random.csv')), self.headless(file))

    def test_invalid_scenarios_change_nothing(self):
        self.start_all()
        self.step(3)
        wrong = RANDOM.replace('name: random_too', 'name: random_too\ncolour: red')
        line = wrong.splitlines().index('colour: red') + 1
        file = self.write('wrong.yaml', wrong)
        self.refuse('load_scenario', file, 'document 2', f'line {line}', 'unknown key', scenario=file)
        overlap = self.write('overlap.yaml', QUIET.replace('[0, 10]', '[0, 0.1]'))
        self.refuse('load_scenario', overlap, 'document 1', 'overlap', scenario=overlap)
        self.refuse('load_scenario', 'line 1', scenario=self.write('no.yaml', '{'))
        self.refuse('load_scenario', 'empty.yaml', scenario=self.write('empty.yaml', ''))
        self.refuse('load_scenario', 'missing.yaml', scenario=self.path('missing.yaml'))
        self.refuse('load_scenario', self.folder, scenario=self.folder)
        self.refuse('load_scenario', scenario='')
        response = self.step(1)
        self.assertEqual((response.episode, response.tick), (0, 4))
        # A subscriber that connects during the publication may receive a latched message twice.
        self.assertEqual({(message.episode, message.name) for message in self.scenarios.messages}, {(0, 'quiet')})

    def test_unwritable_recording_changes_nothing(self):
        self.start_all(trajectories=self.path('ros'))
        self.step(3)
        os.mkdir(self.path('ros/random.csv'))
        self.refuse('load_scenario', 'random.csv', scenario=self.write('random.yaml', RANDOM))
        response = self.step(1)
        self.assertEqual((response.episode, response.tick), (0, 4))
        self.step(196)
        self.assert_same_recording(support.read_bytes(self.path('ros/scene.csv')), self.headless(self.file))


if __name__ == '__main__':
    support.run('controller_services_test')
