"""Claims of sections 3, 4.2, 4.3 and 5 about crowds."""
from . import scenario_runs as runs
from .claim import PARTLY, NOT_CONFIRMED, Claim
from .crowd_judges import (filling_was_needed, dummies, without_incidents, deviated, avoids_moving_obstacle,
                           remain_closer,
                           grouping, breached, grouped_again, twelve_like_six, longer_than_six, varied_speeds,
                           surrounded_touch)
from .experiments import ambiguity, future_work, learning_curves, scenarios, sharing
from .knowledge_judges import (experience_serves, pioneer_serves, crowd_learns_on, incomplete_table, more_training,
                               more_states, any_number, staying_pays, staying_helps)
from .twins_judges import same_row, alone_behaves, two_confuse, handles, second_set_is_better, squeezes, takes_longer

TITLE = ('Claims about states, crowds and learning (sections 3, 4.2, 4.3, 5). Unless stated otherwise: state set 2, '
         "thesis's parameters, one agent's table. A claim of success is confirmed from 90 % (mean over the seeds), and "
         'partly confirmed from 50 %')
NEEDS = (ambiguity, scenarios, sharing, learning_curves, future_work)

# Known reasons.
OSCILLATION = ('With some seeds the agent oscillates in front of the obstacles until the time is up. With better '
               'parameters, after the training among several obstacles, this does not occur.')
TIGHT = ('Trained as in 4.1, the agent walks straight through. It stays clear of the collision radius only within 5 cm '
         'of the middle of the gap. Trained further, it avoids the gap because of the cost of occupied sectors.')
UNTRAINED = ('Trained as in 4.1, the agent has not perceived two obstacles at once, and walks straight on. With more '
             'training it hesitates, and does not pass.')
BY_TRAINING = ('It depends on the training: set 1 is better after training with one obstacle, set 2 after training '
               'with several. Trained on the tests, both are similar.')
SPACE = ('It depends on the space between the dummies, which the thesis does not state: 1.1 m between rims, or in '
         f'{runs.WIDE} {runs.WIDER:g} times the distances.')
CROWDED = ('Twelve agents get into states with many occupied sectors, which are rarely visited in training among '
           'obstacles (table visits).')
IN_THE_MIDDLE = 'The paths of line6 cross, so its agents are nearer to each other in the middle.'
BEST_CASE = 'The thesis shows the best case; the mean over instances is worse.'
ONE_BY_ONE = ('The sequential order of moves (algorithm 3.3) already breaks the synchronicity: the number of contacts '
              'is similar if all agents start exactly on the circle at one speed (table synchronicity).')
ESCAPES = ('Contacts are about ten times as frequent as otherwise. But a sector counts as occupied up to 1 m away, so '
           'many surrounded agents escape.')
VARIATION = ('The number of contacts continues to decrease; success and collisions vary from one table to the next '
             '(constant learning rate, gamma 0.1).')
WHEN_IT_COSTS = ('With a cost of staying that is high enough for the agents to arrive, they are surrounded and have '
                 'contacts about as often as without the stay action.')
INNER_RADIUS = ('Contacts are rare, but other bodies come within the inner radius, which is a collision as the thesis '
                'defines it.')


CLAIMS = (
    Claim('3', 'We presume the experiences from a learned environment can be applied to other configurations.',
          experience_serves, {PARTLY: CROWDED}),
    Claim('3', "If we give the rest of the agents the pioneer's Q-table, they can start the simulation with knowledge "
          'of how to behave', pioneer_serves),
    Claim('3', '... but still mold this to their own experiences.', crowd_learns_on),
    Claim('4.2', 'Set 1 is unable to perceive 4.13a, 4.13b and 4.13c as different situations (and set 2 is able).',
          same_row),
    Claim('4.2', 'Set 1, if it is oblivious to the existence of the other obstacle (4.14a), will behave as expected.',
          alone_behaves),
    Claim('4.2', 'Set 1: confusion comes from having two obstacles inside its radius of vision (4.14b, 4.14c).',
          two_confuse),
    Claim('4.2', 'Set 2, overlapping obstacles: it escapes the situation in a satisfactory way (4.16a).',
          handles('twins_a'), {PARTLY: OSCILLATION, NOT_CONFIRMED: OSCILLATION}),
    Claim('4.2', 'Set 2, close obstacles: it hesitates until it decides to take the right path (4.16b).',
          handles('twins_b'), {PARTLY: OSCILLATION, NOT_CONFIRMED: OSCILLATION}),
    Claim('4.2', 'Set 2, gap too small: it successfully avoids going into that absorbing state (4.16c).',
          handles('twins_c'), {PARTLY: OSCILLATION, NOT_CONFIRMED: OSCILLATION}),
    Claim('4.2', 'Set 2, tight gap: handled correctly (4.16d).', handles('twins_d'),
          {PARTLY: TIGHT, NOT_CONFIRMED: TIGHT}),
    Claim('4.2', '... it manages to fit through the gap', squeezes),
    Claim('4.2', '... and that is the case that takes the agent longer.', takes_longer, {NOT_CONFIRMED: UNTRAINED}),
    Claim('4.2', 'The change of state set was effective to handle the issues brought by more obstacles.',
          second_set_is_better, {PARTLY: BY_TRAINING}),
    Claim('4.3', 'It was necessary to fill the states where several objects can be detected before a trial in a crowd.',
          filling_was_needed),
    Claim('4.3', 'Dummies: it reached its goal, on a believable path and avoiding the dummies (4.17).',
          dummies, {PARTLY: SPACE}),
    Claim('4.3', 'Six on a circle: they pull through without incidents and reach their goals (4.18).',
          without_incidents('circle6'), {PARTLY: INNER_RADIUS}),
    Claim('4.3', 'Six on a circle with an obstacle (4.19; the thesis does not state an outcome; judged as 4.18).',
          without_incidents('circle6_obstacle'), {PARTLY: INNER_RADIUS}),
    Claim('4.3', 'Lines: an agent is totally deviated, but still manages to find a coherent way to its goal (4.20).',
          deviated),
    Claim('4.3', 'Lines with a moving obstacle: to check that the agents avoid it, with an efficient path (4.21; the '
          'thesis does not state an outcome).',
          avoids_moving_obstacle),
    Claim('4.3', 'One goal: they avoid each other but remain closer than before (4.22).',
          remain_closer, {PARTLY: IN_THE_MIDDLE}),
    Claim('4.3', 'They can achieve a grouping behavior (4.22).', grouping),
    Claim('4.3', 'The moving obstacle breaches the cohesion (4.23)', breached),
    Claim('4.3', '... but as time went by the agents grouped again.', grouped_again),
    Claim('4.3', 'Twelve on a circle, best case: performance similar to six (4.24)',
          twelve_like_six, {PARTLY: BEST_CASE}),
    Claim('4.3', '... although it took time for them to converge.', longer_than_six),
    Claim('4.3', 'Varied speeds: the synchronicity was broken, agents are suddenly surrounded (4.25).',
          varied_speeds, {PARTLY: ONE_BY_ONE, NOT_CONFIRMED: ONE_BY_ONE}),
    Claim('4.3', 'Surrounded: any decision will result in an artifact, it goes through an obstacle or through an '
          'agent (4.25; the text mentions an obstacle, our scene has none).',
          surrounded_touch, {PARTLY: ESCAPES}),
    Claim('5.1', 'An incomplete Q-table: believable for states visited several times, poor for the others.',
          incomplete_table),
    Claim('4.1.2, 5.1', 'More training improves: the visual results should improve over time (here: rates in demo).',
          more_training, {PARTLY: VARIATION}),
    Claim('5.1', 'The compilation of experiences can be used for any amount of characters.',
          any_number, {PARTLY: CROWDED}),
    Claim('5.2', 'Staying: without a penalty it could be valued as the go-to action.', staying_pays),
    Claim('5.2', 'Since agents cannot stay, they go through others when trapped (so staying should help).',
          staying_helps, {PARTLY: WHEN_IT_COSTS, NOT_CONFIRMED: WHEN_IT_COSTS}),
    Claim('5.2', 'With a bigger amount of states there are more scenarios that have to be tried.', more_states),
)
