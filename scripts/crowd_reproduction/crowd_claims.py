"""Claims of chapters 3, 4.2, 4.3 and 5 about crowds, and what they are judged by."""
import numpy

from crowd_experiments.records import Spread, median, of_scenario, rates

from . import groups, names, scenario_runs as runs, surroundings, twins_runs
from .claim import (COMES_OUT, IN_PART, NOT, Claim, Judgement, decide, decide_all, decide_each, decide_greater, versus)
from .experiments import ambiguity, future_work, learning_curves, scenarios, sharing
from .measures import COLLISION_RADIUS, CONTACT_OVERLAP, RADIUS, centre_distances, share

TITLE = ('Claims about states, crowds and what is learned (chapters 3, 4.2, 4.3, 5). Where nothing else is said: state '
         "set 2, thesis's parameters, one agent's table. Of a share of successes: comes out from 90 % (mean over the "
         'seeds), in part from 50 %')
NEEDS = (ambiguity, scenarios, sharing, learning_curves, future_work)
GOOD, HALF = 90.0, 50.0  # [%]: what "successfully" is to mean, and what is enough to come out in part
RARE = 10.0  # [%]: what "avoids" leaves
TWINS = tuple(twins_runs.TESTS)


def is_good(value):
    return value >= GOOD


def graded(values):
    """The verdict on 'it succeeds', given the share of successes [%] for each seed."""
    mean = float(numpy.mean(list(values)))
    return COMES_OUT if mean >= GOOD else IN_PART if mean >= HALF else NOT


def is_rare(value):
    return value <= RARE


def both(values, conditions):
    """The verdict on several conditions, each on its own values of the seeds."""
    return decide_all(*(decide_each(of_seeds, condition) for of_seeds, condition in zip(values, conditions)))


# 3: what is learned can be used elsewhere, and by others.


def experience_serves(setting):
    verdicts, told = [], []
    for scenario in runs.SCENARIOS:
        success, contact, collision = zip(*runs.measured(setting, runs.MAIN, scenario))
        verdicts.append(both((success, contact), (is_good, is_rare)))
        told.append(f'{scenario} {numpy.mean(success):.0f} / {numpy.mean(contact):.0f} / {numpy.mean(collision):.0f}')
    fine = sum(verdict == COMES_OUT for verdict in verdicts)
    verdict = COMES_OUT if fine == len(verdicts) else IN_PART if fine else NOT
    return Judgement(f'success / contact / collision % in scenarios never met in training (means of {seeds(setting)}): '
                     f'{", ".join(told)}; at least {GOOD:g} and at most {RARE:g} in {fine} of {len(verdicts)}', verdict)


def seeds(setting):
    return f'{len(setting.seeds(runs.SEEDS))} seeds'


def shared(setting, use, episodes, measure):
    """Of a crowd by a pioneer's table, for each seed."""
    place = list(sharing.episodes_of(setting)).index(episodes)
    return sharing.curve(setting, 'occupancy', use)[place, :, sharing.MEASURES[measure]]


def pioneer_serves(setting):
    first, last = sharing.episodes_of(setting)[0], sharing.episodes_of(setting)[-1]
    success, contact = (shared(setting, 'fixed', last, measure) for measure in ('success', 'contact'))
    untrained = shared(setting, 'fixed', first, 'contact')
    verdict = decide_all(decide_each(success, is_good), decide_greater(untrained, contact))
    return Judgement(f'twelve agents: success {Spread(success).text(1)} %; contact {Spread(contact).text(1)} %, after '
                     f'the first part of its training alone {Spread(untrained).text(1)} %', verdict)


def crowd_learns_on(setting):
    last = sharing.episodes_of(setting)[-1]
    fixed, shared_on, own = (shared(setting, use, last, 'contact') for use in ('fixed', 'shared', 'own'))
    verdict = decide_all(decide_greater(fixed, shared_on), decide_greater(fixed, own))
    return Judgement(f'contact of twelve agents: {Spread(fixed).text(1)} % with the table as it is, '
                     f'{Spread(shared_on).text(1)} % when all learn on in one table, {Spread(own).text(1)} % in own '
                     'tables', verdict)


# 4.2: ambiguity.


def same_row(setting):
    rows = {states: ambiguity.rows_of(setting, states) for states in twins_runs.SETS}
    holds = len(set(rows['nearest'])) == 1, len(set(rows['occupancy'])) == len(rows['occupancy'])
    return Judgement(f'rows of set 1: {rows["nearest"]}, of set 2: {rows["occupancy"]}',
                     (NOT, IN_PART, COMES_OUT)[sum(holds)])


def clean_shares(setting, agent, test):
    """The share of the walks [%] that arrive without a collision, for each seed."""
    return [100.0 * float(numpy.mean((record['arrived'] > 0)[rows] & (record['collided'] == 0)[rows]))
            for record in twins_runs.records_of(setting, agent) for rows in [of_scenario(record, test)]]


SET_1 = ('single', 'nearest', 'thesis')


def alone_behaves(setting):
    values = clean_shares(setting, SET_1, twins_runs.ALONE)
    return Judgement(f'set 1 arrives without a collision in {Spread(values).text(1)} % of the walks',
                     graded(values))


def two_confuse(setting):
    alone = clean_shares(setting, SET_1, twins_runs.ALONE)
    two = numpy.mean([clean_shares(setting, SET_1, test) for test in TWINS], axis=0)
    return Judgement('set 1, walks that arrive without a collision %: ' + versus('one in sight', alone, 'two', two, 1),
                     decide_greater(alone, two))


def set_2(training):
    return training, 'occupancy', 'thesis'


def handles(test):
    """Judges whether set 2 handles a test: arrives without a collision."""
    def judge(setting):
        values = {training: clean_shares(setting, set_2(training), test) for training in twins_runs.TRAININGS}
        told = '; '.join(f'{twins_runs.TRAININGS[training]}: {Spread(of_seeds).text(1)} %'
                         for training, of_seeds in values.items())
        better = Spread(clean_shares(setting, ('field', 'occupancy', 'better'), test)).text(1)
        return Judgement(f'arrives without a collision, {told}; better parameters, {twins_runs.TRAININGS["field"]}: '
                         f'{better} %', best_of(map(graded, values.values())))
    return judge


def best_of(verdicts):
    """The verdict under the reading of the thesis under which a claim fares best."""
    verdicts = set(verdicts)
    return next(verdict for verdict in (COMES_OUT, IN_PART, NOT) if verdict in verdicts)


def second_set_is_better(setting):
    told, verdicts = [], []
    for training, name in twins_runs.TRAININGS.items():
        first, second = (numpy.mean([clean_shares(setting, (training, states, 'thesis'), test) for test in TWINS],
                                    axis=0) for states in twins_runs.SETS)
        told.append(f'{name}: ' + versus('set 2', second, 'set 1', first, 1))
        verdicts.append(decide_greater(second, first))
    return Judgement(f'all four tests, walks that arrive without a collision %. {"; ".join(told)}',
                     decide_all(*verdicts))


def squeezes(setting):
    told, verdicts = [], []
    for training, name in twins_runs.TRAININGS.items():
        between, around = ambiguity.passages(setting, set_2(training))
        told.append(f'{name}: between {Spread(between).text(1)} %, around {Spread(around).text(1)} %')
        verdicts.append(graded(between))
    return Judgement(f'walks of test d that pass: {"; ".join(told)}', best_of(verdicts))


def takes_longer(setting):
    told, verdicts = [], []
    for training, name in twins_runs.TRAININGS.items():
        needed = {test: numpy.array(ambiguity.decisions_needed(setting, set_2(training), test)) for test in TWINS}
        others = [numpy.nanmean(line) if numpy.isfinite(line).any() else numpy.nan
                  for line in numpy.transpose([needed[test] for test in TWINS[:3]])]
        pairs = [(tight, other) for tight, other in zip(needed['twins_d'], others) if numpy.isfinite(tight + other)]
        if pairs:
            verdicts.append(decide_greater(*zip(*pairs)))
            told.append(f'{name}: ' + versus('d', [a for a, _ in pairs], 'a to c', [b for _, b in pairs], 0))
        else:
            told.append(f'{name}: no seed arrives in d and elsewhere')
    return Judgement(f'decisions of those who arrive. {"; ".join(told)}', decide_all(*verdicts) if verdicts else NOT)


# 4.3: scenarios.


def filling_was_needed(setting):
    told, verdicts = [], []
    for scenario in ('circle6', 'circle12'):
        first, then = (list(zip(*runs.measured(setting, runs.MAIN, scenario, file)))[1]
                       for file in ('single.csv', 'demo.csv'))
        told.append(f'{scenario}: ' + versus('one obstacle only', first, 'then several', then, 1))
        verdicts.append(decide_greater(first, then))
    return Judgement(f'contact %, by the training. {"; ".join(told)}', decide_all(*verdicts))


def rates_text(setting, scenario):
    success, contact, collision = zip(*runs.measured(setting, runs.MAIN, scenario))
    return (f'success {Spread(success).text(1)} %, collision {Spread(collision).text(1)} %, contact '
            f'{Spread(contact).text(1)} %')


def path_ratios(setting, scenario):
    """Of those who arrived, the median for each seed."""
    records = (runs.record_of(setting, runs.MAIN, seed) for seed in setting.seeds(runs.SEEDS))
    return [median(record['path_ratio'][of_scenario(record, scenario) & (record['arrived'] > 0)]) for record in records]


def dummies(setting):
    told, verdicts = [], []
    for parameters, scenario in (('thesis', 'dummies'), ('thesis', runs.WIDE), ('better', 'dummies')):
        table = 'agent', 'occupancy', parameters
        success, contact, collision = zip(*runs.measured(setting, table, scenario))
        told.append(f'{scenario}, {names.PARAMETER_NAMES[parameters]}: success {Spread(success).text(1)} %, collision '
                    f'{Spread(collision).text(1)} %, contact {Spread(contact).text(1)} %')
        if parameters == 'thesis':
            verdicts.append(graded(runs.clean_share(setting, table, seed, scenario)
                                   for seed in setting.seeds(runs.SEEDS)))
    return Judgement('; '.join(told), decide_all(*verdicts))


def without_incidents(scenario):
    """Judges whether all arrive without incidents in most episodes: without a contact, and without a collision."""
    def judge(setting):
        shares = [[runs.clean_share(setting, runs.MAIN, seed, scenario, incident) for seed in
                   setting.seeds(runs.SEEDS)] for incident in ('touched', 'collided')]
        contact, collision = (Spread(of_seeds).text(1) for of_seeds in shares)
        return Judgement(f'{rates_text(setting, scenario)}; all arrive without contact in {contact} % of the episodes, '
                         f'without a collision in {collision} %', decide_all(*map(graded, shares)))
    return judge


def deviated(setting):
    """Episodes in which an agent walks at least twice its straight way, and whether that agent arrives."""
    found, arriving = [], []
    for seed in setting.seeds(runs.SEEDS):
        record = runs.record_of(setting, runs.MAIN, seed)
        rows = of_scenario(record, 'line6')
        ways = record['path_length'][rows].reshape(-1, 6)
        straight = numpy.array([numpy.hypot(8.0, 2 * y) for y in (3.25, 1.95, 0.65, -0.65, -1.95, -3.25)])
        most = numpy.argmax(ways / straight, axis=1)
        far = (ways / straight).max(axis=1) >= 2.0
        arrives = record['arrived'][rows].reshape(-1, 6)[numpy.arange(len(ways)), most] > 0
        found.append(share(far.sum(), len(far)))
        arriving.append(share((far & arrives).sum(), far.sum()))
    told = Spread.of_numbers(arriving)
    return Judgement(f'{rates_text(setting, "line6")}; an agent walks twice its straight way or more in '
                     f'{Spread(found).text(1)} % of the episodes, and arrives in {told.text(1)} % of these',
                     decide(is_good(told.mean), map(is_good, told.values)))


def nearest_to_mover(setting, seed):
    """How near each agent comes to the moving obstacle's centre [m], in the recorded instances."""
    obstacle = runs.obstacle_places(setting, 'line6_mover', 2001)
    nearest = []
    for places in runs.tracks_of(setting, runs.MAIN, seed, 'line6_mover').values():
        offsets = places - obstacle[:len(places), None]
        nearest += list(numpy.nanmin(numpy.hypot(offsets[..., 0], offsets[..., 1]), axis=0))
    return numpy.array(nearest)


def avoids_mover(setting):
    nearest = [nearest_to_mover(setting, seed) for seed in setting.seeds(runs.SEEDS)]
    rim = groups.OBSTACLE_RADIUS
    touching, colliding = ([100.0 * float(numpy.mean(of_seed < limit)) for of_seed in nearest]
                           for limit in (rim + RADIUS - CONTACT_OVERLAP, rim + COLLISION_RADIUS))
    ratios = [Spread(path_ratios(setting, scenario)).mean for scenario in ('line6', 'line6_mover')]
    return Judgement(f'{rates_text(setting, "line6_mover")}; {Spread(touching).text(1)} % of the agents touch the '
                     f'moving obstacle, {Spread(colliding).text(1)} % collide with it; path ratio {ratios[1]:.2f} with '
                     f'and {ratios[0]:.2f} without it', both((touching, colliding), (is_rare, is_rare)))


def nearness(setting, scenario):
    """The distance to the nearest companion, mean over all time in which all are there, for each seed [m]."""
    return [numpy.mean([groups.companions(places).mean() for places in
                        groups.groups_of(setting, runs.MAIN, seed, scenario)]) for seed in setting.seeds(runs.SEEDS)]


def remain_closer(setting):
    together, apart = nearness(setting, 'same_goal6'), nearness(setting, 'line6')
    rates_of = zip(*runs.measured(setting, runs.MAIN, 'same_goal6'))
    return Judgement(f'{rates_text(setting, "same_goal6")}; distance to the nearest companion [m]: ' +
                     versus('line6', apart, 'same_goal6', together),
                     decide_all(both(rates_of, (is_good, is_rare, is_rare)), decide_greater(apart, together)))


def grouping(setting):
    start, end = zip(*groups.last_metre(setting, runs.MAIN, 'same_goal6'))
    return Judgement('distance to the nearest companion [m]: ' + versus('at the start', start, 'at the end', end),
                     decide_greater(start, end))


def phases(setting, measure):
    return groups.measured(setting, runs.MAIN, measure)


PASSED, ARRIVING = 2, 3  # of groups.TIMES
MEASURES = {'nearest companion': groups.companions, 'middle of the group': centre_distances}


def breached(setting):
    told, verdicts = [], []
    for name, measure in MEASURES.items():
        values = phases(setting, measure)[:, PASSED]
        told.append(f'distance to the {name} [m]: ' + versus('the obstacle', values[:, 0], 'none', values[:, 1]))
        verdicts.append(decide_greater(values[:, 0], values[:, 1]))
    return Judgement(f'when it has passed, {"; ".join(told)}', decide_all(*verdicts))


def grouped_again(setting):
    told, verdicts = [], []
    for name, measure in MEASURES.items():
        passed, arriving = phases(setting, measure)[:, (PASSED, ARRIVING), 0].T
        compared = versus('when it has passed', passed, 'when the first one arrives', arriving)
        told.append(f'distance to the {name} [m]: {compared}')
        verdicts.append(decide_greater(passed, arriving))
    free = phases(setting, groups.companions)[:, ARRIVING, 1]
    return Judgement(f'{"; ".join(told)}; nearest companion at that time without the obstacle {Spread(free).text()}',
                     decide_all(*verdicts))


def twelve_like_six(setting):
    six, twelve = (list(zip(*runs.measured(setting, runs.MAIN, scenario))) for scenario in ('circle6', 'circle12'))
    differences = [numpy.abs(numpy.subtract(a, b)) for a, b in zip(six[:2], twelve[:2])]
    best = scenarios.told_of(setting, runs.MAIN, 'circle12', scenarios.best_of(setting, runs.MAIN, 'circle12'))
    return Judgement(f'six: {rates_text(setting, "circle6")}; twelve: {rates_text(setting, "circle12")} (similar: '
                     f'within {RARE:g} points); the best recorded episode of twelve, {best}',
                     both(differences, (is_rare, is_rare)))


def longer_than_six(setting):
    six, twelve = path_ratios(setting, 'circle6'), path_ratios(setting, 'circle12')
    return Judgement('path ratio of those who arrive (median): ' + versus('twelve', twelve, 'six', six),
                     decide_greater(twelve, six))


def varied_speeds(setting):
    told, verdicts = [], []
    for index, name in ((1, 'contact %'), (2, 'collision %')):
        steady, varied = (list(zip(*runs.measured(setting, runs.MAIN, scenario)))[index]
                          for scenario in ('circle12', 'circle12_varied'))
        told.append(f'{name}: ' + versus('varied', varied, 'one speed', steady, 1))
        verdicts.append(decide_greater(varied, steady))
    caught = [[one.per_thousand() for one in surroundings.measured(setting, runs.MAIN, scenario)]
              for scenario in ('circle12_varied', 'circle12')]
    told.append('decisions while surrounded, of 1,000: ' + versus('varied', caught[0], 'one speed', caught[1]))
    exact, together = (Spread(list(zip(*runs.measured(setting, runs.MAIN, scenario)))[1]).text(1)
                       for scenario in runs.EXACT)
    told.append(f'contact of twelve who start exactly on the circle {exact} %, if they also move at the same time '
                f'{together} %')
    return Judgement('; '.join(told), decide_all(*verdicts, decide_greater(*caught)))


def surrounded_touch(setting):
    found = surroundings.measured(setting, runs.MAIN, 'circle12_varied')
    pairs = [(one.inside.contact_share(), one.outside.contact_share()) for one in found if one.inside.decisions]
    if not pairs:
        return Judgement('no agent was ever surrounded', NOT)
    inside, outside = zip(*pairs)
    agents = Spread.of_numbers(share(one.caught_touched, one.caught) for one in found)
    verdict = decide_all(decide_greater(inside, outside), decide_each(inside, is_good))
    compared = versus('surrounded', inside, 'else', outside, 1)
    return Judgement(f'contact within {surroundings.SOON} decisions %: {compared}; of the agents ever surrounded '
                     f'{agents.text(1)} % then touch another', verdict)


# 5: conclusions and future work.


def incomplete_table(setting):
    told, verdicts = [], []
    for scenario in runs.WATCHED:
        outcomes = surroundings.visits_measured(setting, runs.MAIN, scenario, surroundings.CROWDED)
        pairs = [(join(line[:2]), join(line[3:])) for line in outcomes]
        pairs = [pair for pair in pairs if numpy.isfinite(sum(pair))]
        rare, often = zip(*pairs)
        told.append(f'{scenario}: ' + versus('rarely visited', rare, 'often', often, 1))
        verdicts.append(decide_greater(rare, often))
    return Judgement(f'{surroundings.CROWDED} or more sectors occupied, contact within {surroundings.SOON} decisions '
                     f'%, rows visited fewer than 10 and at least 100 times in training. {"; ".join(told)}',
                     decide_all(*verdicts))


def join(outcomes):
    """The share of contacts of several classes together [%]."""
    return share(sum(one.contacts for one in outcomes), sum(one.decisions for one in outcomes))


def more_training(setting):
    curve = learning_curves.Curve(setting, 'occupancy', 'thesis')
    told, verdicts = [], []
    for scenario in learning_curves.SCENARIOS:
        for measure, index in learning_curves.MEASURES.items():
            first, last = curve.rates[scenario][1, :, index], curve.rates[scenario][-1, :, index]
            told.append(f'{scenario}, {measure} %: after {curve.episodes[1]:,} episodes {Spread(first).text(1)}, after '
                        f'{curve.episodes[-1]:,} {Spread(last).text(1)}')
            verdicts.append(decide_greater(last, first) if measure == 'success' else decide_greater(first, last))
    return Judgement('; '.join(told), decide_all(*verdicts))


def more_states(setting):
    curves = {states: learning_curves.Curve(setting, states, 'thesis') for states in learning_curves.SETS}
    shares = {states: 100.0 * curve.rows[-1] / curve.all_rows for states, curve in curves.items()}
    return Judgement('rows visited after all training, % of all rows: ' +
                     versus('set 1', shares['nearest'], 'set 2', shares['occupancy'], 1),
                     decide_greater(shares['nearest'], shares['occupancy']))


def any_number(setting):
    success, contact = zip(*((list(zip(*runs.measured(setting, runs.MAIN, scenario)))[:2])
                             for scenario in ('circle6', 'circle12')))
    return Judgement(f'one table, six: {rates_text(setting, "circle6")}; twelve: {rates_text(setting, "circle12")}',
                     decide_all(both(success, (is_good,) * 2), both(contact, (is_rare,) * 2)))


def future(setting, variation):
    """Success and contact [%] with what is put in, a tuple for each seed."""
    return [rates(record)[:2] for record in future_work.records_of(setting, variation)]


def staying_pays(setting):
    (without, _), (free, _), (dear, _) = (list(zip(*future(setting, variation)))
                                          for variation in ('thesis', 'stay', 'stay_5'))
    return Judgement(f'success of twelve at varied speeds %: {Spread(without).text(1)} without, {Spread(free).text(1)} '
                     f'with the action at no cost, {Spread(dear).text(1)} at a cost of 5',
                     decide_all(decide_greater(without, free), decide_greater(dear, free)))


def staying_helps(setting):
    _, without = zip(*future(setting, 'thesis'))
    costs = {'no cost': 'stay', 'cost 0.2': 'stay_02', 'cost 1': 'stay_1', 'cost 5': 'stay_5'}
    told, verdicts = [], []
    for name, variation in costs.items():
        success, contact = zip(*future(setting, variation))
        told.append(f'{name} {Spread(contact).text(1)}')
        if is_good(numpy.mean(success)):  # an agent that stays for good touches nothing
            verdicts.append(decide_greater(without, contact))
    return Judgement(f'contact of twelve at varied speeds %: {Spread(without).text(1)} without the action; '
                     f'{", ".join(told)}; judged by the costs with which {GOOD:g} % arrive', decide_all(*verdicts))


# Why, where it is known.
DANCES = ('It dances in front of the obstacles until time is up, and which seeds do is chance. Better parameters, '
          'after the training among several obstacles, end that.')
TIGHT = ('Trained as in 4.1 it walks straight through, but only within 5 cm of the middle of the gap no rim comes '
         'within the collision radius. Trained further, the cost of occupied sectors keeps it out of the gap.')
UNTRAINED = ('Trained as in 4.1 it has not met two obstacles at once, so nothing keeps it from walking straight on; '
             'with more training it hesitates, and does not pass at all.')
BY_TRAINING = ('It depends on the training: after one obstacle set 1 is better, after several set 2 is; on the tests '
               'themselves they are alike.')
SPACE = ('It depends on the space between them, of which the thesis says nothing: 1.05 m between rims, or, in '
         f'{runs.WIDE}, {runs.WIDER:g} times the distances.')
CROWDED = 'Twelve meet states with many occupied sectors, of which training among obstacles visits few (table visits).'
IN_THE_MIDDLE = 'The ways of line6 cross, so its agents are nearer to each other in the middle.'
BEST_CASE = 'The thesis shows the best case; the mean over instances is worse.'
ONE_BY_ONE = ('That the agents move one after the other (algorithm 3.3) breaks the synchronicity already: contacts are '
              'as many if all start exactly on the circle at one speed (table synchronicity).')
ROOM = ('About ten times as many contacts as elsewhere; but a sector counts as occupied up to 1 m away, so many agents '
        'get out of it.')
SWINGS = ('Contacts go on to fall; success and collisions swing from one table to the next (constant step size, gamma '
          '0.1).')
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
    Claim('4.3', 'Lines with a moving obstacle: the agents were able to avoid it, with an efficient path (4.21).',
          avoids_mover),
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
    Claim('4.3', 'Surrounded: any decision will result in an artifact; it will go through one of the agents (4.25).',
          surrounded_touch, {IN_PART: ROOM}),
    Claim('5.1', 'An incomplete Q-table: believable for states visited several times, poor for the others.',
          incomplete_table),
    Claim('4.1.2, 5.1', 'More training improves: the results should improve over time.',
          more_training, {IN_PART: SWINGS}),
    Claim('5.1', 'The compilation of experiences can be used for any amount of characters.',
          any_number, {IN_PART: CROWDED}),
    Claim('5.2', 'Staying: without a penalty it could be valued as the go-to action.', staying_pays),
    Claim('5.2', 'Since agents cannot stay, they go through others when trapped (so staying should help).',
          staying_helps, {IN_PART: WHEN_IT_COSTS, NOT: WHEN_IT_COSTS}),
    Claim('5.2', 'With a bigger amount of states there are more scenarios that have to be tried.', more_states),
)
