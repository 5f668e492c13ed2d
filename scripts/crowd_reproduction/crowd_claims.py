"""Claims of chapters 3, 4.2, 4.3 and 5 about crowds."""
from . import scenario_runs as runs
from .claim import IN_PART, NOT, Claim
from .crowd_judges import (filling_was_needed, dummies, without_incidents, deviated, avoids_moving_obstacle,
                           remain_closer,
                           grouping, breached, grouped_again, twelve_like_six, longer_than_six, varied_speeds,
                           surrounded_touch)
from .experiments import ambiguity, future_work, learning_curves, scenarios, sharing
from .knowledge_judges import (experience_serves, pioneer_serves, crowd_learns_on, incomplete_table, more_training,
                               more_states, any_number, staying_pays, staying_helps)
from .twins_judges import same_row, alone_behaves, two_confuse, handles, second_set_is_better, squeezes, takes_longer

TITLE = ('Claims about states, crowds and what is learned (chapters 3, 4.2, 4.3, 5). Where nothing else is said: state '
         "set 2, thesis's parameters, one agent's table. Of a share of successes: comes out from 90 % (mean over the "
         'seeds), in part from 50 %')
NEEDS = (ambiguity, scenarios, sharing, learning_curves, future_work)

# Why, where it is known.
DANCES = ('In some seeds it steps to and fro in front of the obstacles until time is up. Better parameters, '
          'after the training among several obstacles, end that.')
TIGHT = ('Trained as in 4.1 it walks straight through, but only within 5 cm of the middle of the gap no rim comes '
         'within the collision radius. Trained further, the cost of occupied sectors keeps it out of the gap.')
UNTRAINED = ('Trained as in 4.1 it has not met two obstacles at once, so nothing keeps it from walking straight on; '
             'with more training it hesitates, and does not pass at all.')
BY_TRAINING = ('It depends on the training: after one obstacle set 1 is better, after several set 2 is; on the tests '
               'themselves they are alike.')
SPACE = ('It depends on the space between them, of which the thesis says nothing: 1.1 m between rims, or, in '
         f'{runs.WIDE}, {runs.WIDER:g} times the distances.')
CROWDED = 'Twelve meet states with many occupied sectors, of which training among obstacles visits few (table visits).'
IN_THE_MIDDLE = 'The ways of line6 cross, so its agents are nearer to each other in the middle.'
BEST_CASE = 'The thesis shows the best case; the mean over instances is worse.'
ONE_BY_ONE = ('That the agents move one after the other (algorithm 3.3) breaks the synchronicity already: contacts are '
              'as many if all start exactly on the circle at one speed (table synchronicity).')
ROOM = ('About ten times as many contacts as elsewhere; but a sector counts as occupied up to 1 m away, so many agents '
        'get out of it.')
SWINGS = ('Contacts go on to fall; success and collisions swing from one table to the next (constant learning rate, '
          'gamma 0.1).')
WHEN_IT_COSTS = ('Where staying costs enough that agents arrive, they are surrounded, and touch others, about as often '
                 'as without it.')
INNER_RADIUS = 'There is hardly a contact, but agents do come within the inner radius, the thesis\'s own collision.'


CLAIMS = (
    Claim('3', 'We presume the experiences from a learned environment can be applied to other configurations.',
          experience_serves, {IN_PART: CROWDED}),
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
          handles('twins_a'), {IN_PART: DANCES, NOT: DANCES}),
    Claim('4.2', 'Set 2, close obstacles: it hesitates until it decides to take the right path (4.16b).',
          handles('twins_b'), {IN_PART: DANCES, NOT: DANCES}),
    Claim('4.2', 'Set 2, gap too small: it successfully avoids going into that absorbing state (4.16c).',
          handles('twins_c'), {IN_PART: DANCES, NOT: DANCES}),
    Claim('4.2', 'Set 2, tight gap: handled correctly (4.16d).', handles('twins_d'), {IN_PART: TIGHT, NOT: TIGHT}),
    Claim('4.2', '... it manages to fit through the gap', squeezes),
    Claim('4.2', '... and that is the case that takes the agent longer.', takes_longer, {NOT: UNTRAINED}),
    Claim('4.2', 'The change of state set was effective to handle the issues brought by more obstacles.',
          second_set_is_better, {IN_PART: BY_TRAINING}),
    Claim('4.3', 'It was necessary to fill the states where several objects can be detected before a trial in a crowd.',
          filling_was_needed),
    Claim('4.3', 'Dummies: it reached its goal, on a believable path and avoiding the dummies (4.17).',
          dummies, {IN_PART: SPACE}),
    Claim('4.3', 'Six on a circle: they pull through without incidents and reach their goals (4.18).',
          without_incidents('circle6'), {IN_PART: INNER_RADIUS}),
    Claim('4.3', 'Six on a circle with an obstacle (4.19; no outcome is told, so the same is asked).',
          without_incidents('circle6_obstacle'), {IN_PART: INNER_RADIUS}),
    Claim('4.3', 'Lines: an agent is totally deviated, but still manages to find a coherent way to its goal (4.20).',
          deviated),
    Claim('4.3', 'Lines with a moving obstacle: to check that the agents avoid it, with an efficient path (4.21; no '
          'outcome is told).',
          avoids_moving_obstacle),
    Claim('4.3', 'One goal: they avoid each other but remain closer than before (4.22).',
          remain_closer, {IN_PART: IN_THE_MIDDLE}),
    Claim('4.3', 'They can achieve a grouping behavior (4.22).', grouping),
    Claim('4.3', 'The moving obstacle breaches the cohesion (4.23)', breached),
    Claim('4.3', '... but as time went by the agents grouped again.', grouped_again),
    Claim('4.3', 'Twelve on a circle, best case: performance similar to six (4.24)',
          twelve_like_six, {IN_PART: BEST_CASE}),
    Claim('4.3', '... although it took time for them to converge.', longer_than_six),
    Claim('4.3', 'Varied speeds: the synchronicity was broken, agents are suddenly surrounded (4.25).',
          varied_speeds, {IN_PART: ONE_BY_ONE, NOT: ONE_BY_ONE}),
    Claim('4.3', 'Surrounded: any decision will result in an artifact, it goes through an obstacle or through an '
          'agent (4.25; its text speaks of an obstacle, our scene has none).',
          surrounded_touch, {IN_PART: ROOM}),
    Claim('5.1', 'An incomplete Q-table: believable for states visited several times, poor for the others.',
          incomplete_table),
    Claim('4.1.2, 5.1', 'More training improves: the visual results should improve over time (here: rates in demo).',
          more_training, {IN_PART: SWINGS}),
    Claim('5.1', 'The compilation of experiences can be used for any amount of characters.',
          any_number, {IN_PART: CROWDED}),
    Claim('5.2', 'Staying: without a penalty it could be valued as the go-to action.', staying_pays),
    Claim('5.2', 'Since agents cannot stay, they go through others when trapped (so staying should help).',
          staying_helps, {IN_PART: WHEN_IT_COSTS, NOT: WHEN_IT_COSTS}),
    Claim('5.2', 'With a bigger amount of states there are more scenarios that have to be tried.', more_states),
)
