"""A crowd whose learners are on other hosts: network namespaces, whose links are cut."""
import os
import random
import time

import pytest
from host_crowds import AGENTS, HostCrowd, crowd_scenario
from programs import (ANTICIPATION_TABLE, PATIENCE, assert_same_recording, assert_says, read_bytes, read_text,
                      wait_for)

CUT = 5.0  # [s]
FLAPPING = 60.0  # [s]
RECOVERY = 60.0  # [s] time limit; TCP sends again after at most twice the time of the cut
REACTION = 0.4  # [s] answer deadline: ten times what a busy machine needs
LONG = 400  # [s] of simulated time
SEED = int(os.environ.get('CROWD_TEST_SEED', random.SystemRandom().randrange(1_000_000)))


@pytest.fixture(name='crowd')
def make_crowd(runner, network):
    """A crowd with learners on two other hosts."""
    return HostCrowd(runner, network)


def walk_to_the_end(runner, crowd):
    """Walks two episodes in lockstep. Returns the recording and that of one machine without ROS."""
    scenario = runner.write('crowd.yaml', crowd_scenario(20))
    crowd.start_master()
    crowd.start_learners()
    controller = crowd.start_controller(scenario, real_time_factor='fast', episodes=2, seed=5, answer_deadline=60,
                                        start_deadline=120, trajectories=runner.path('walk'))
    assert controller.wait(3 * PATIENCE) == 0, controller.output()
    assert controller.output().count(' 0 answers missed, 0 dropped') == 2, controller.output()
    expected = runner.headless(scenario, ANTICIPATION_TABLE, episodes=2, seed=5)
    return read_bytes(runner.path('walk/crowd.csv')), expected


def start_walking(runner, crowd, factor):
    """Lets the crowd walk with short deadlines. Returns the controller when all agents have answers."""
    crowd.start_master()
    crowd.start_recorder()
    crowd.start_learners()
    controller = crowd.start_controller(runner.write('crowd.yaml', crowd_scenario(LONG)), real_time_factor=factor,
                                        episodes=1, seed=5, answer_deadline=REACTION, misses_until_absent=2,
                                        agents_rate=10, start_deadline=120, trajectories=runner.path('walk'))
    wait_until_all_walk(crowd)
    return controller


def wait_until_all_walk(crowd):
    """Waits until agents of all learners move. A few may choose to wait for others."""
    return crowd.wait('agents', lambda states: states['tick'] > 5 and len(states['rest']) < AGENTS / 20,
                      'all agents to walk', RECOVERY)


def finish(crowd, controller):
    """Checks the counts while the crowd is paused, and walks to the end of the episode. Returns its result."""
    crowd.call('pause', 'true')
    status = crowd.wait('status', lambda status: status['paused'], 'the status while paused')
    assert status['decisions'] + status['missed'] == AGENTS * status['tick'], 'an agent without account'
    crowd.call('set_real_time_factor', '0')
    crowd.call('pause', 'false')
    assert controller.wait() == 0, controller.output()
    result = crowd.wait('result', lambda result: True, 'the result')
    assert result['contact'] == 0.0
    assert result['tick'] == 10 * LONG
    return result


def rests(file):
    """Returns the agents that did not move, for each tick from 1 on."""
    ticks, before = {}, {}
    for line in read_text(file).splitlines()[1:]:
        _, tick, agent, place = line.split(',', 3)
        still = ticks.setdefault(int(tick), set())
        if before.get(agent) == place:
            still.add(int(agent))
        before[agent] = place
    return [still for tick, still in sorted(ticks.items()) if tick > 0]


def check_counts(runner, result):
    """Checks that agents stayed in place in each tick without an answer; a few rest because they choose so."""
    rest = sum(map(len, rests(runner.path('walk/crowd.csv'))))
    assert result['missed'] <= rest <= result['missed'] + 0.01 * AGENTS * result['tick']


class LinkTest:
    """Two learner hosts with half of 200 agents each."""

    def test_the_same_trajectories_as_on_one_machine(self, runner, crowd):
        assert_same_recording(*walk_to_the_end(runner, crowd))

    def test_a_link_is_cut_for_a_while(self, runner, crowd):
        controller = start_walking(runner, crowd, 2.0)
        first, second = crowd.share_of(0), crowd.share_of(1)
        crowd.learners[1].cut()
        cut_at = time.monotonic()
        stand = crowd.wait('agents', lambda states: second <= set(states['rest']), 'the agents of the host to stand')
        wait_for(lambda: time.monotonic() - cut_at > CUT, 'the end of the cut')
        others = crowd.wait('agents', lambda states: states['tick'] > stand['tick'] and
                            len(first & set(states['rest'])) < 5, 'the others to walk')
        assert second <= set(others['rest'])
        assert crowd.recorded('status')[-1]['missed'] >= len(second)
        crowd.learners[1].restore()
        restored_at = time.monotonic()
        back = wait_until_all_walk(crowd)
        print(f'all walk again after {time.monotonic() - restored_at:.1f} s')
        result = finish(crowd, controller)
        print(f'{result}')
        assert result['missed'] >= len(second) * (others['tick'] - stand['tick'])
        check_counts(runner, result)
        resting = rests(runner.path('walk/crowd.csv'))
        during = resting[stand['tick']:others['tick'] - 1]
        assert all(second <= still for still in during), 'they stay where they are'
        assert not second & set.intersection(*resting[back['tick']:]), 'each walks again'
        assert_says(controller.output(), 'no answer for agents 1, 3, 5', 'They are absent')

    def test_a_link_that_is_up_and_down_at_random(self, runner, crowd):
        print(f'seed {SEED}; CROWD_TEST_SEED={SEED} repeats it')
        chance = random.Random(SEED)
        controller = start_walking(runner, crowd, 1.0)
        end = time.monotonic() + FLAPPING
        cuts = 0
        while time.monotonic() < end:
            host = chance.choice(crowd.learners)
            for change, least, most in ((host.cut, 0.05, 2.5), (host.restore, 0.05, 4.0)):
                change()
                until = time.monotonic() + chance.uniform(least, most)
                wait_for(lambda: time.monotonic() > until, 'the next change')
            cuts += 1
            assert controller.is_running()
        back = wait_until_all_walk(crowd)
        result = finish(crowd, controller)
        print(f'{cuts} cuts; {back["tick"]} ticks until then; {result}')
        assert result['missed'] > 0
        check_counts(runner, result)


class SlowLinkTest:
    """Links with delay and loss, where the kernel has netem."""

    def test_the_same_trajectories_with_delay_and_loss(self, runner, crowd):
        for host in crowd.learners:
            try:
                host.impair('delay', '25ms', 'loss', '1%')  # in each direction
            except RuntimeError as error:
                pytest.skip(f'no delay and no loss here: {error}')
        assert_same_recording(*walk_to_the_end(runner, crowd))
