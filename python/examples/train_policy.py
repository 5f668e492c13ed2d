#!/usr/bin/python3
"""Trains a small policy that drives a robot through people who do not give way, and compares it with the reactive rule.

The policy is a learned social force (NumPy alone): from each person in sight a network with one hidden layer computes a
force; the sum of the forces and of the pull of the goal is where the robot turns to, and how fast it drives. The
cross-entropy method finds the weights: in each generation it draws policies from a normal distribution, drives each of
them through some episodes, and fits the distribution to the best ones. All episodes of a generation run side by side in
a VecEnv.

Episodes of the comparison are those of `evaluate --seed 1000`, which no training uses.
"""
import argparse
import csv
import math
import sys
import time

import numpy
import social_crowd

# Twenty people cross a square in all directions, and the robot too. They see it, but do not keep out of its way.
SCENARIO = {
    'name': 'square', 'duration': 40, 'goal_tolerance': 0.3, 'contact': 'solid', 'ends': 'robots',
    'agents': [{'count': 20, 'position': {'ring': {'centre': [0, 0], 'radius': [4, 7]}}, 'goal': {'opposite': [0, 0]},
                'speed': [1.0, 1.5], 'radius': 0.25}],
    'robots': [{'name': 'robot', 'position': [0, -7], 'goal': [0, 7], 'radius': 0.3, 'max_speed': 1,
                'yields': 'nobody', 'scan': {'rays': 360}}],
}
HELD_OUT_SEED = 1000
PEOPLE = 8  # that the policy looks at
TICKS = 2  # of 0.1 s, that an action holds
FEATURES, HIDDEN = 7, 8


def reward(before, after):
    """Progress [m], less a contact, closeness to people, and the time that passes."""
    closeness = numpy.clip(0.3 - after.clearance, 0.0, 0.3)
    return before.remaining_distance - after.remaining_distance - 20.0 * (after.contacts > 0) - closeness - 0.1


class Policy:
    """Policies side by side: one for each row of `weights`."""

    SIZE = FEATURES * HIDDEN + HIDDEN + 2 * HIDDEN + 2

    def __init__(self, weights):
        weights = numpy.atleast_2d(weights)
        parts = numpy.split(weights, numpy.cumsum([FEATURES * HIDDEN, HIDDEN, 2 * HIDDEN]), axis=1)
        self._hidden = parts[0].reshape(-1, FEATURES, HIDDEN)
        self._offset = parts[1][:, None]
        self._force = parts[2].reshape(-1, HIDDEN, 2)
        self._gains = parts[3]  # logarithms of the factors of the pull of the goal, and of the rotation

    def act(self, observation):
        """Returns an action for each row of the observations: ahead, rotation."""
        people = observation['people'].astype(float)
        present = people[..., 4:] > 0.0
        distance = numpy.maximum(1e-6, numpy.hypot(people[..., 0], people[..., 1]))[..., None]
        ahead = people[..., :2] / distance
        velocity = people[..., 2:4] - numpy.pad(observation['velocity'][:, None, :1], ((0, 0), (0, 0), (0, 1)))
        closing = -(ahead * velocity).sum(-1, keepdims=True)
        gap = numpy.maximum(0.0, distance - people[..., 4:] - 0.3)
        seen = numpy.concatenate([ahead, velocity, closing, numpy.exp(-gap), numpy.exp(-0.3 * gap)], axis=-1)
        force = numpy.tanh(seen @ self._hidden + self._offset) @ self._force
        force = (force * present * numpy.exp(-0.5 * gap)).sum(axis=1)
        goal = observation['goal'].astype(float)
        far = numpy.maximum(1e-6, numpy.hypot(goal[:, 0], goal[:, 1]))[:, None]
        wanted = numpy.exp(self._gains[:, :1]) * goal / far + force
        bearing = numpy.arctan2(wanted[:, 1], wanted[:, 0])
        speed = numpy.minimum(1.0, numpy.hypot(wanted[:, 0], wanted[:, 1])) * numpy.minimum(1.0, 2.0 * far[:, 0])
        speed = speed * numpy.maximum(0.0, numpy.cos(bearing))
        rotation = numpy.clip(2.0 * numpy.exp(self._gains[:, 1]) * bearing, -1.0, 1.0)
        return numpy.stack([speed, rotation], axis=1)


def make_env(scenario, episodes, threads):
    """Returns a VecEnv for a policy."""
    observation = social_crowd.Observation('people', max_people=PEOPLE)
    return social_crowd.VecEnv(scenario, episodes, ticks=TICKS, observation=observation, reward=reward, threads=threads)


def run_episodes(env, policy, seed, options=None):
    """Drives one episode in each environment. Returns the sums of rewards, and what is known at the end of each."""
    observation, _ = env.reset(seed=seed, options=options)
    returns = numpy.zeros(env.num_envs)
    ends = [None] * env.num_envs
    running = numpy.ones(env.num_envs, bool)
    steps = 0
    while running.any():
        observation, rewards, terminated, truncated, infos = env.step(policy.act(observation))
        steps += env.num_envs
        returns[running] += rewards[running]
        for i in numpy.flatnonzero(running & (terminated | truncated)):
            ends[i] = {name: array[i] for name, array in infos['final_info']['metrics'].items()}
        running &= ~(terminated | truncated)
    return returns, ends, steps


def score(results):
    """Returns the share of robots that arrived without a contact, and their mean time [s]. results: their metrics"""
    clean = [one for one in results if one['success'] and not one['people_contacts']]
    return len(clean) / len(results), numpy.mean([one['time_to_reach_goal'] for one in clean]) if clean else math.nan


def score_policy(scenario, policy, episodes, threads=0):
    """Returns the score() of a policy on held-out episodes."""
    options = {'episode': range(episodes)}
    _, ends, _ = run_episodes(make_env(scenario, episodes, threads), policy, [HELD_OUT_SEED] * episodes, options)
    return score(ends)


def score_controller(scenario, controller, episodes, threads=0):
    """Returns the same of a controller of `evaluate`."""
    evaluation = social_crowd.evaluate('anticipation', scenario, episodes=episodes, seed=HELD_OUT_SEED, threads=threads,
                                       robot=controller)
    return score([robot for episode in evaluation.episodes for robot in episode['robots']])


def train(scenario, arguments, on_generation):
    """Returns the weights of the mean policy of the last generation."""
    random = numpy.random.default_rng(arguments.seed)
    mean = numpy.zeros(Policy.SIZE)
    deviation = numpy.full(Policy.SIZE, 0.3)
    env = make_env(scenario, arguments.population * arguments.episodes, arguments.threads)
    elite = max(2, arguments.population // 5)
    begin = time.monotonic()
    for generation in range(arguments.generations):
        drawn = mean + deviation * random.normal(size=(arguments.population, Policy.SIZE))
        # All policies of a generation drive the same episodes.
        seeds = numpy.tile(random.integers(1, 2 ** 31, arguments.episodes), arguments.population)
        policies = Policy(numpy.repeat(drawn, arguments.episodes, axis=0))
        returns, _, steps = run_episodes(env, policies, list(seeds))
        returns = returns.reshape(arguments.population, arguments.episodes).mean(axis=1)
        best = drawn[numpy.argsort(-returns)[:elite]]
        mean = best.mean(axis=0)
        deviation = best.std(axis=0) + 0.05 * 0.95 ** generation  # so that it does not narrow too early
        on_generation(generation, returns, mean, steps, time.monotonic() - begin)
        if time.monotonic() - begin > 60.0 * arguments.minutes:
            break
    return mean


def plot(rows, baseline, output):
    """Draws the learning curves into a file."""
    import matplotlib
    matplotlib.use('Agg')
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(1, 3, figsize=(12, 3.5), constrained_layout=True)
    minutes = [row['minutes'] for row in rows]
    axes[0].plot(minutes, [row['mean_return'] for row in rows], label='mean of the generation')
    axes[0].plot(minutes, [row['best_return'] for row in rows], label='best of the generation')
    axes[0].set_ylabel('return')
    axes[0].set_title('training episodes')
    scored = [row for row in rows if row['clean'] is not None]
    for axis, name, label in zip(axes[1:], ('clean', 'time'), ('arrived without contact [%]', 'time [s]')):
        factor = 100.0 if name == 'clean' else 1.0
        axis.plot([row['minutes'] for row in scored], [factor * row[name] for row in scored], '.-', label='policy')
        axis.axhline(factor * baseline[0 if name == 'clean' else 1], color='grey', linestyle='--',
                     label='reactive rule')
        axis.set_ylabel(label)
        axis.set_title('held-out episodes')
    axes[1].set_ylim(0, 102)
    for axis in axes:
        axis.set_xlabel('training time [min]')
        axis.legend()
    figure.savefig(output)


def parse(arguments):
    """Returns the command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--scenario', help='name or file of a scenario with a robot (default: a crossing of 20 people)')
    parser.add_argument('--generations', type=int, default=40, help='(default: %(default)s)')
    parser.add_argument('--minutes', type=float, default=9.0, help='no generation begins later (default: %(default)s)')
    parser.add_argument('--population', type=int, default=32, help='policies of a generation (default: %(default)s)')
    parser.add_argument('--episodes', type=int, default=6, help='of each of them (default: %(default)s)')
    parser.add_argument('--held-out', type=int, default=100, help='episodes of the comparison (default: %(default)s)')
    parser.add_argument('--every', type=int, default=5, help='generations between comparisons (default: %(default)s)')
    parser.add_argument('--seed', type=int, default=1, help='of the training (default: %(default)s)')
    parser.add_argument('--threads', type=int, default=0, help='0: one for each processor')
    parser.add_argument('--output', default='policy', help='.npy, .csv and .png are added (default: %(default)s)')
    given = parser.parse_args(arguments)
    for name in ('generations', 'population', 'episodes', 'held_out', 'every'):
        if getattr(given, name) < 1:
            parser.error(f"--{name.replace('_', '-')}: expected at least 1, got {getattr(given, name)}")
    return given


def main():
    """Trains, compares, and writes the policy and its curves."""
    arguments = parse(sys.argv[1:])
    scenario = arguments.scenario or SCENARIO
    try:
        if make_env(scenario, 1, 1).single_action_space.shape != (2,):
            raise social_crowd.InputError(f'{scenario}: the policy drives robots with drive: differential')
        with open(f'{arguments.output}.npy', 'ab'):  # an error now, rather than after the training
            pass
        train_and_compare(scenario, arguments)
    except (social_crowd.CrowdError, OSError) as error:
        sys.exit(f'train_policy.py: {error}')


def train_and_compare(scenario, arguments):
    """Trains a policy, scores it beside the reactive rule, and writes the files."""
    baseline = score_controller(scenario, 'reactive', arguments.held_out)
    print(f'reactive rule: {100 * baseline[0]:.0f} % arrived without contact, after {baseline[1]:.1f} s')
    untrained, _ = score_policy(scenario, Policy(numpy.zeros(Policy.SIZE)), arguments.held_out)
    print(f'untrained: {100 * untrained:.0f} % arrived without contact')
    rows = []

    def on_generation(generation, returns, mean, steps, seconds):
        row = {'generation': generation, 'minutes': seconds / 60.0, 'steps': steps, 'mean_return': returns.mean(),
               'best_return': returns.max(), 'clean': None, 'time': None}
        text = f'generation {generation}: {seconds:.0f} s, return {returns.mean():.2f}, best {returns.max():.2f}'
        if generation % arguments.every == 0 or generation == arguments.generations - 1:
            row['clean'], row['time'] = score_policy(scenario, Policy(mean), arguments.held_out)
            text += f"; held out: {100 * row['clean']:.0f} %, {row['time']:.1f} s"
        rows.append(row)
        print(text, flush=True)

    weights = train(scenario, arguments, on_generation)
    numpy.save(f'{arguments.output}.npy', weights)
    with open(f'{arguments.output}.csv', 'w', newline='', encoding='utf-8') as stream:
        writer = csv.DictWriter(stream, rows[0])
        writer.writeheader()
        writer.writerows(rows)
    plot(rows, baseline, f'{arguments.output}.png')
    clean, seconds = score_policy(scenario, Policy(weights), arguments.held_out)
    print(f'policy: {100 * clean:.0f} % arrived without contact, after {seconds:.1f} s; reactive rule: '
          f'{100 * baseline[0]:.0f} %, {baseline[1]:.1f} s')


if __name__ == '__main__':
    main()
