"""Claims of the thesis about its rewards and about training (3.2.2.3, 4.1, 5.1)."""
import math

from . import reward_runs as runs
from .claim import PARTLY, NOT_CONFIRMED, Claim
from .experiments import reward_evaluation
from .reward_judges import (both, compare, curved, each, in_course, less_in_demo, longer, more_decisions, mostly_free,
                            number, of_both, scattered, separation, similar_success, softer, training_differs)
from .reward_runs import COSINE, GAIN

TITLE = 'Claims about the rewards and about training'
NEEDS = (reward_evaluation,)
STRAIGHT = 1.0 / math.cos(math.pi / 8)  # greatest path per distance of the shortest path with eight directions
ALMOST_NONE = 1.0  # [%]
SLOWEST = 5.0  # [-] of path per distance gained
VARIES = 'success in demo varies strongly between seeds (figure 4.8), which a single run does not show'
VARIATION = dict.fromkeys((NOT_CONFIRMED, PARTLY), VARIES)

CLAIMS = [
    Claim('3.2.2.3, (3.6)', '"the best way to walk towards the goal is in a straight line" is taught by distance '
          'gained (without an obstacle: path per distance gained at most 1.08, the maximum with eight directions)',
          each(GAIN, 'free', runs.path_per_gain, lambda ratio: ratio <= STRAIGHT)),
    Claim('3.2.2.3, (3.7)', 'cos³ "translates to walking in a straight line" (the same measure)',
          each(COSINE, 'free', runs.path_per_gain, lambda ratio: ratio <= STRAIGHT)),
    Claim('4.1', '"As the agent gains experience the number of collisions should decrease" (collision in training, %)',
          of_both(in_course, runs.collision, True)),
    Claim('4.1.1, figure 4.2', 'distance gained per step "is more scattered" with distance gained than with cos³ '
          '(breadth, m)', scattered(runs.gain_breadth, 'training', GAIN, 4), {
              PARTLY: 'most episodes lie closer together with cos³; episodes in which the agent is stuck for some time '
                      'lie far below them'}),
    Claim('4.1.1, figure 4.2', 'with cos³ it is "closer to the agent\'s real velocity" (median difference from it, m)',
          compare(runs.shortfall, 'training', GAIN, 4)),
    Claim('4.1.1, figure 4.3', 'path per distance gained: cos³ "shows a more compacted graph" (breadth)',
          scattered(runs.ratio_breadth, 'training', GAIN)),
    Claim('4.1.1, figure 4.3', '"its peek values are also lower" (exceeded by one episode in a hundred)',
          compare(runs.ratio_peak, 'training', GAIN)),
    Claim('4.1.1, figure 4.3', 'cos³ makes "a more efficient way of walking" (median path per distance gained)',
          compare(runs.path_per_gain, 'training', GAIN)),
    Claim('4.1.1, figure 4.4', 'success in training is "better for the cosine function" (%)',
          compare(runs.success, 'training', COSINE)),
    Claim('4.1.1, figure 4.4', 'success in training 99.60 % with cos³, 92.25 % (all but 155 of 2000) with distance '
          'gained', both(number(COSINE, 'training'), number(GAIN, 'training'))),
    Claim('4.1.1, figure 4.5', '"almost total avoidance by using the distance gain" (collision in training, at most '
          '1 %)', each(GAIN, 'training', runs.collision, lambda rate: rate <= ALMOST_NONE)),
    Claim('4.1.1, figure 4.5', 'cos³ "presented a higher incidence of episodes with collisions" (training, %)',
          compare(runs.collision, 'training', COSINE)),
    Claim('4.1.1', 'distance gained tends "to follow longer paths, and approach the goal slowly" (training: path per '
          'distance gained; distance gained per step)', both(
              compare(runs.path_per_gain, 'training', GAIN), compare(runs.gain_per_step, 'training', COSINE, 4))),
    Claim('4.1.2, figure 4.6', '"a separation present in both charts" (distance gained per step in demo: two groups '
          'with 0.005 m between them)', of_both(separation)),
    Claim('4.1.2, figure 4.6', 'in demo "closer to the real velocity" with cos³ (median difference from it, m)',
          compare(runs.shortfall, 'demo', GAIN, 4)),
    Claim('4.1.2, figure 4.7', 'in demo path per distance gained of both is "converging below 5" (median)',
          both(*(each(variant, 'demo', runs.path_per_gain, lambda ratio: ratio < SLOWEST)
                 for variant in (GAIN, COSINE)))),
    Claim('4.1.2, figure 4.7', '"the cosine reward function looks more compact" (path per distance '
          'gained, breadth)', scattered(runs.ratio_breadth, 'demo', GAIN), VARIATION),
    Claim('4.1.2, figure 4.8', 'success in demo is "slightly better" with cos³ (%)',
          compare(runs.success, 'demo', COSINE), VARIATION),
    Claim('4.1.2, figure 4.8', 'success in demo 79.10 % with cos³, 73.80 % with distance gained',
          both(number(COSINE, 'demo'), number(GAIN, 'demo')), VARIATION),
    Claim('4.1.2', 'success is lower in demo than in training (%)', of_both(less_in_demo)),
    Claim('4.1.2', '"both training processes needed more episodes" (success in demo after more training, %)',
          of_both(longer, runs.success, True), {
              NOT_CONFIRMED: VARIES, PARTLY: f'for at most one of the rewards; {VARIES}'}),
    Claim('4.1.2', '"or that the amount of decisions made for episode should be bigger" (success in demo, %)',
          of_both(more_decisions), dict.fromkeys((NOT_CONFIRMED, PARTLY), (
              'an agent that has not arrived after 2,000 greedy decisions rarely arrives later: without random '
              'decisions it repeats its moves'))),
    Claim('4.1.2, figure 4.9', 'distance gained "was effective in teaching the agent to avoid collisions" (demo, at '
          'most 1 %)', each(GAIN, 'demo', runs.collision, lambda rate: rate <= ALMOST_NONE)),
    Claim('4.1.2, figure 4.9', 'with cos³ "avoiding obstacles does not seem to be a strict priority" (more collisions '
          'in demo than with distance gained, and more than 1 %)', both(
              compare(runs.collision, 'demo', COSINE),
              each(COSINE, 'demo', runs.collision, lambda rate: rate > ALMOST_NONE))),
    Claim('4.1.2', 'distance gained is "more focused on avoiding obstacles rather than walking directly", cos³ is '
          '"committed to follow the shortest path" (demo: path per distance gained; collision, %)', both(
              compare(runs.path_per_gain, 'demo', GAIN), compare(runs.collision, 'demo', COSINE))),
    Claim('4.1.2', 'the bet on cos³ "to improve with more training episodes" (collision in demo, %)',
          longer(COSINE, runs.collision, False)),
    Claim('4.1.2', '"they both have similar success rate" (demo, within 10 points)', similar_success, VARIATION),
    Claim('4.1.2, figure 4.10', 'without an obstacle distance gained renders a "curved path" (change of direction '
          'between legs of 0.6 m, sum)', curved),
    Claim('4.1.2, figure 4.10', 'it is "softer", "without sharp changes of direction" (the sharpest change between '
          'legs of 0.6 m; turning)', softer, {
              NOT_CONFIRMED: 'the agent walks in a zigzag of one step to the left and one to the right (45 degrees at '
                             'every step are 26.2 rad/m), and its bends are sharper'}),
    Claim('4.1.2, figure 4.11', 'without an obstacle the velocity with distance gained "is lower" (distance gained per '
          'step, m)', compare(runs.gain_per_step, 'free', COSINE, 4)),
    Claim('4.1.2, figure 4.11', 'cos³ "shows a more consistent velocity between episodes" (distance gained per step, '
          'breadth, m)', scattered(runs.gain_breadth, 'free', GAIN, 4), {
              NOT_CONFIRMED: 'the shortest path with eight directions gains 0.0277 to 0.03 m per step, depending on '
                             'the direction of the goal'}),
    Claim('4.1.2, figure 4.12', 'without an obstacle distance gained "yields paths that are longer" (path per distance '
          'gained)', compare(runs.path_per_gain, 'free', GAIN)),
    Claim('4.1.2', '"the agent sampled more states without obstacles than states with obstacles" (training)',
          of_both(mostly_free), {
              PARTLY: 'with cos³ the agent walks past the obstacle, or is stuck in front of it, within its radius of '
                      'vision'}),
    Claim('5.1', '"results during training do not necessarily depict the final results" (success in training and demo '
          'more than 5 points apart)', of_both(training_differs)),
    Claim('5.1', 'the visual results during training "should improve over time" (here: success in training, %)',
          of_both(in_course, runs.success, False), {
              NOT_CONFIRMED: 'the first 500 episodes are as good as the last; after them, the constant exploration '
                             'limits the rate'}),
]
