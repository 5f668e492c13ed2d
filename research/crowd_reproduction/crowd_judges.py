"""Judges the claims of section 4.3 (the scenarios, with the thesis's state set 2 and parameters), 3 and 5 (use of
learned tables by other agents and in other scenarios, the effect of more training, and the stay action)."""
import numpy
from crowd_experiments.records import Spread, percent

from .claim import (CONFIRMED, GOOD, Judgement, NOT_CONFIRMED, PARTLY, RARE, compared, decide, decide_all, decide_each,
                    decide_greater, difference_text, good_and_rare, graded, is_good, joined, number_text, versus)
from .crowds import (CROWDED, DUMMIES, EXACT, GROUPING, LEAST_SECTORS, OBSTACLE_RADIUS, OBSTRUCTED, SCENARIOS, SOON,
                     agents, best_of, by_visits, companions, groups_of, hidden_shares, last_metre, middle_spreads,
                     outcome_sentence, phases, rates, record_file, recorded, surrounded)
from .experiments import future_work, learning_curves, sharing
from .measures import COLLISION_RADIUS, CONTACT_OVERLAP, RADIUS, share
from .declared import SETS, THESIS
from .results import PARAMETER_NAMES, RATES, obstacle_places, per_seed, rates_sentence

PASSED, ARRIVING = 2, 3  # of TIMES
STARTS = numpy.array([3.25, 1.95, 0.65, -0.65, -1.95, -3.25])  # of line6 [m]
COSTS = {'no cost': 'stay', 'cost 0.2': 'stay_02', 'cost 1': 'stay_1', 'cost 5': 'stay_5'}


def rates_text(setting, scenario):
    return rates_sentence(rates(agents(setting), scenario))


def filling_was_needed(setting):
    parts = []
    for scenario in ('circle6', 'circle12'):
        first, then = (agents(setting).rates(file, scenario).contact for file in ('single.csv', 'demo.csv'))
        parts.append(compared(f'{scenario}, contact: ', 'one obstacle', first, 'several obstacles', then, 1, unit=' %'))
    return joined(parts, '; ', 'after each part of the training. ')


def dummies(setting):
    texts, whole = [], []
    for parameters, scenario in DUMMIES:
        runs = agents(setting, parameters)
        texts.append(f'{scenario}, {PARAMETER_NAMES[parameters]}: {rates_sentence(rates(runs, scenario))}')
        if parameters == THESIS:
            whole.append(runs.whole(record_file(scenario), scenario, 'touched'))
    return Judgement('; '.join(texts), decide_all(*map(graded, whole)), f'arrives without a contact '
                     f'{number_text(whole[0])}; with 1.6 times the distances {number_text(whole[1])}')


def without_incidents(setting, scenario):
    """Judges whether in most episodes all agents arrive without a contact, and without a collision."""
    shares = [agents(setting).whole('demo.csv', scenario, incident) for incident in ('touched', 'collided')]
    contact, collision = (Spread(values).text(1) for values in shares)
    return Judgement(f'{rates_text(setting, scenario)}; all agents arrive without a contact in {contact} % of the '
                     f'episodes, without a collision in {collision} %', decide_all(*map(graded, shares)),
                     f'all arrive without a contact {number_text(shares[0])}; without a collision '
                     f'{number_text(shares[1])}')


def deviations(rows):
    """Returns the shares [%] of episodes of line6 with a path twice the straight one, and of those that arrive then."""
    ratios = rows['path_length'].to_numpy().reshape(-1, 6) / numpy.hypot(8.0, 2 * STARTS)
    far, farthest = ratios.max(axis=1) >= 2.0, numpy.argmax(ratios, axis=1)
    arrives = rows['arrived'].to_numpy().reshape(-1, 6)[numpy.arange(len(ratios)), farthest] > 0
    return share(far.sum(), len(far)), share((far & arrives).sum(), far.sum())


def deviated(setting):
    """Judges whether agents arrive whose path is at least twice the straight-line distance."""
    found, arriving = zip(*per_seed(agents(setting).record('demo.csv', 'line6'), deviations))
    arrivals = Spread.of_numbers(arriving)
    return Judgement(f'{rates_text(setting, "line6")}; the path of an agent is at least twice the straight-line '
                     f'distance in {Spread(found).text(1)} % of the episodes; this agent arrives in '
                     f'{arrivals.text(1)} % of these', decide(is_good(arrivals.mean), map(is_good, arrivals.values)),
                     f'arrives {number_text(arriving)}')


def avoids_moving_obstacle(setting):
    runs = agents(setting)
    obstacle = obstacle_places(setting, 'line6_mover', 2001)
    nearest = []  # smallest distance of each agent to the obstacle's centre [m], for each seed
    for seed in runs.seeds():
        offsets = [places - obstacle[:len(places), None] for places in runs.tracks(seed, 'line6_mover.csv').values()]
        nearest.append(numpy.concatenate([numpy.nanmin(numpy.linalg.norm(away, axis=2), axis=0) for away in offsets]))
    touching, colliding = ([percent(values < OBSTACLE_RADIUS + reach) for values in nearest]
                           for reach in (RADIUS - CONTACT_OVERLAP, COLLISION_RADIUS))
    without, ratio = (Spread(runs.arrivals('demo.csv', 'path_ratio', scenario)).mean
                      for scenario in ('line6', 'line6_mover'))
    return Judgement(f'{rates_text(setting, "line6_mover")}; {Spread(touching).text(1)} % of the agents have a contact '
                     f'with the moving obstacle, {Spread(colliding).text(1)} % a collision; path ratio {ratio:.2f} '
                     f'with and {without:.2f} without it', good_and_rare(rare=[touching, colliding]),
                     f'contact with it {number_text(touching)}')


def remain_closer(setting):
    runs = agents(setting)
    # Mean distances to the nearest companion before the first arrival, for each seed [m].
    apart, together = ([numpy.mean([companions(places).mean() for places in groups_of(runs, seed, scenario)])
                        for seed in runs.seeds()] for scenario in ('line6', 'same_goal6'))
    nearer = compared('', 'line6', apart, 'same_goal6', together, unit=' m')
    found = rates(runs, 'same_goal6')
    return Judgement(f'{rates_text(setting, "same_goal6")}; distance to the nearest companion [m]: {nearer.measured}',
                     decide_all(good_and_rare([found.success], [found.contact, found.collision]), nearer.verdict),
                     f'nearest companion: {nearer.number}')


def grouping(setting):
    (start, end), (apart_start, apart_end) = (last_metre(agents(setting), scenario).T
                                              for scenario in ('same_goal6', 'line6'))
    return joined([compared('nearest companion: ', 'at the start', start, 'at the end', end, unit=' m'),
                   compared('decrease: ', 'one goal', start - end, 'line6', apart_start - apart_end)], '; ',
                  'distance to the nearest companion [m]: ')


def breached(setting):
    values = {name: phases(agents(setting), measure)[:, PASSED].T for name, measure in GROUPING.items()}
    return joined([compared(f'distance to the {name} [m]: ', 'with the obstacle', crossed, 'without', free)
                   for name, (crossed, free) in values.items()], '; ', 'after the passage, ')


def grouped_again(setting):
    values = {name: phases(agents(setting), measure) for name, measure in GROUPING.items()}
    whole = joined([compared(f'distance to the {name} [m]: ', 'after the passage', found[:, PASSED, 0],
                             'at the first arrival', found[:, ARRIVING, 0]) for name, found in values.items()], '; ')
    free = values['nearest companion'][:, ARRIVING, 1]
    return Judgement(f'{whole.measured}; nearest companion at the first arrival, without the obstacle '
                     f'{Spread(free).text()}', whole.verdict, whole.number)


def twelve_like_six(setting):
    """Judges whether the best recorded episode of twelve agents is similar to the best one of six."""
    runs = agents(setting)
    six, twelve = (recorded(runs, scenario).loc[best_of(runs, scenario)[0]] for scenario in ('circle6', 'circle12'))
    rate_of = {scenario: rates_sentence(rates(runs, scenario)) for scenario in ('circle6', 'circle12')}
    similar = [abs(twelve[incident] / 12 - six[incident] / 6) <= RARE / 100 for incident in ('collided', 'touched')]
    best = f'best episode of twelve: {outcome_sentence(runs, "circle12", *best_of(runs, "circle12"))}'
    return Judgement(f'{best}; of six: {six.arrived:.0f} of 6 arrive, {six.collided:.0f} collide, {six.touched:.0f} '
                     f'have a contact (similar: within {RARE:g} points). All episodes, six: {rate_of["circle6"]}; '
                     f'twelve: {rate_of["circle12"]}', decide(twelve.not_arrived == 0, similar), best)


def longer_than_six(setting):
    twelve, six = (agents(setting).arrivals('demo.csv', 'path_ratio', scenario) for scenario in ('circle12', 'circle6'))
    return compared('median path ratio of the agents that arrive: ', 'twelve', twelve, 'six', six)


def varied_speeds(setting):
    """Judges whether agents at varied speeds reach the middle at more different times."""
    runs = agents(setting)
    varied, steady = (middle_spreads(runs, scenario) for scenario in ('circle12_varied', 'circle12'))
    exact, together = (Spread(rates(runs, scenario).contact).text(1) for scenario in EXACT)
    whole = compared('standard deviation of the times at which agents reach the middle (1 m) [s]: ', 'varied speeds',
                     varied, 'one speed', steady)
    return Judgement(f'{whole.measured}; contact of twelve agents that start exactly on the circle {exact} %, if they '
                     f'also move simultaneously {together} %', whole.verdict, whole.number)


def suddenly_surrounded(setting):
    """Judges whether agents at varied speeds are surrounded, more than at one speed."""
    varied, steady, obstructed = ([one.per_thousand() for one in surrounded(agents(setting), scenario)]
                                  for scenario in ('circle12_varied', 'circle12', OBSTRUCTED))
    whole = compared('decisions while surrounded, per 1,000: ', 'varied speeds', varied, 'one speed', steady)
    return whole._replace(measured=f'{whole.measured}; varied speeds and an obstacle {Spread(obstructed).text()}')


def ventures_inside(setting):
    """Judges whether surrounded agents go into the obstacle."""
    runs = agents(setting)
    obstacle = numpy.zeros(2)
    found = []
    for seed in runs.seeds():
        decisions = runs.decisions(seed, OBSTRUCTED)
        tracks = runs.tracks(seed, f'{OBSTRUCTED}.csv')
        ever = decisions[decisions['sectors'] >= LEAST_SECTORS].groupby(['instance', 'agent'])['tick'].min()
        touched = [numpy.nanmin(numpy.linalg.norm(tracks[instance][tick:, agent] - obstacle, axis=1)) <
                   OBSTACLE_RADIUS + RADIUS - CONTACT_OVERLAP for (instance, agent), tick in ever.items()]
        found.append(percent(touched))
    return Judgement(f'of the agents that were ever surrounded, {Spread.of_numbers(found).text(1)} % then have a '
                     'contact with the obstacle', decide_each(found, lambda value: value > 0.0),
                     f'an agent does in {sum(value > 0.0 for value in found)} of {len(found)} seeds')


def surrounded_touch(setting):
    found = surrounded(agents(setting), OBSTRUCTED)
    pairs = [(one.inside[1], one.outside[1]) for one in found if one.inside[0]]
    if not pairs:
        return Judgement('no agent was ever surrounded', NOT_CONFIRMED)
    inside, outside = zip(*pairs)
    share_of_agents = Spread.of_numbers(one.touched for one in found)
    return Judgement(f'contact within {SOON} decisions %: '
                     f'{versus("surrounded", inside, "not surrounded", outside, 1)}; of the agents that were ever '
                     f'surrounded, {share_of_agents.text(1)} % then have a contact',
                     graded(inside),
                     f'contact within {SOON} decisions {number_text(inside)}')


def experience_serves(setting):
    verdicts, texts = [], []
    for scenario in SCENARIOS:
        found = rates(agents(setting), scenario)
        verdicts.append(good_and_rare([found.success], [found.contact]))
        means = found[['success', 'contact', 'collision']].mean()
        texts.append(f'{scenario} {" / ".join(f"{value:.0f}" for value in means)}')
    fine = verdicts.count(CONFIRMED)
    return Judgement('success / contact / collision % in scenarios that were not used in training (means of '
                     f'{len(found)} seeds): {", ".join(texts)}; success at least {GOOD:g} and contact at most {RARE:g} '
                     f'in {fine} of {len(verdicts)}',
                     CONFIRMED if fine == len(verdicts) else PARTLY if fine else NOT_CONFIRMED,
                     f'in {fine} of {len(verdicts)} scenarios, {len(found)} seeds')


def versatile(setting):
    """Judges whether the agents arrive in all scenarios."""
    found = {scenario: rates(agents(setting), scenario).success for scenario in SCENARIOS}
    fine = sum(is_good(success.mean()) for success in found.values())
    texts = [f'{scenario} {success.mean():.0f}' for scenario, success in found.items()]
    return Judgement(f'success %: {", ".join(texts)}',
                     decide_all(*(CONFIRMED if is_good(success.mean()) else NOT_CONFIRMED
                                  for success in found.values())),
                     f'at least {GOOD:g} % arrive in {fine} of {len(found)} scenarios, '
                     f'{len(agents(setting).seeds())} seeds')


def occlusion_saves(setting):
    """Judges whether at least one of a hundred bodies that are checked is hidden."""
    found = {scenario: hidden_shares(agents(setting), scenario) for scenario in ('circle6', 'circle12')}
    texts = [f'{scenario} {Spread(values).text(1)} %' for scenario, values in found.items()]
    return Judgement(f'bodies within the radius of vision that nearer ones hide: {", ".join(texts)}',
                     decide_all(*(decide_each(values, lambda value: value >= 1.0) for values in found.values())),
                     f'hidden {number_text(found["circle12"])}')


def costs_match_states(setting):
    """Judges whether condensed states need another cost."""
    same, other = (future_work.rates(setting, variation).contact for variation in ('condensed', 'condensed_80'))
    return compared('contact of twelve agents: ', 'obstacle_cost 10', same, '80', other, 1, unit=' %')


def shared(setting, use, place, measure='contact'):
    """Returns a measure of the crowd with a pioneer's table, for each seed; place: of the number of episodes."""
    return sharing.curve(setting, 'occupancy', use)[place, :, list(RATES).index(measure)]


def pioneer_serves(setting):
    success, contact = (shared(setting, 'fixed', -1, measure) for measure in ('success', 'contact'))
    untrained = shared(setting, 'fixed', 0)
    return Judgement(f'twelve agents: success {Spread(success).text(1)} %; contact {Spread(contact).text(1)} %, after '
                     f'only the first part of the training {Spread(untrained).text(1)} %',
                     decide_all(decide_each(success, is_good), decide_greater(untrained, contact)),
                     f'success {number_text(success)}')


def crowd_learns_on(setting):
    fixed, shared_on, own = (shared(setting, use, -1) for use in ('fixed', 'shared', 'own'))
    return Judgement(f'contact of twelve agents: {Spread(fixed).text(1)} % with the unchanged table, '
                     f'{Spread(shared_on).text(1)} % if all continue learning in one table, {Spread(own).text(1)} % in '
                     'own tables', decide_greater(fixed, own),
                     f'contact % {difference_text("unchanged", fixed, "continue", own, 1)}')


def incomplete_table(setting):
    parts = []
    for scenario in ('circle12', 'circle12_varied'):
        outcomes = by_visits(agents(setting), scenario, CROWDED)
        pairs = [[share(part.contact.sum(), part.decisions.sum()) for part in (classes[:2], classes[3:])]
                 for classes in outcomes]
        rare, often = zip(*(pair for pair in pairs if numpy.isfinite(sum(pair))))
        parts.append(compared(f'{scenario}: ', 'rarely visited', rare, 'often visited', often, 1))
    return joined(parts, '; ', f'{CROWDED} or more sectors occupied, contact within {SOON} decisions %, rows visited '
                  'fewer than 10 and at least 100 times in training. ')


def more_training(setting):
    curve = learning_curves.Curve(setting, 'occupancy', THESIS)
    parts = []
    for scenario, of_episodes in curve.rates.items():
        for measure, first, last in zip(RATES, of_episodes[1].T, of_episodes[-1].T):
            parts.append(Judgement(
                f'{scenario}, {measure} %: after {curve.episodes[1]:,} episodes {Spread(first).text(1)}, after '
                f'{curve.episodes[-1]:,} {Spread(last).text(1)}',
                decide_greater(last, first) if measure == 'success' else decide_greater(first, last),
                f'{scenario}, {measure} % {difference_text("later", last, "before", first, 1)}'))
    return joined(parts, '; ')


def more_states(setting):
    first, second = (100.0 * curve.rows[-1] / curve.all_rows for curve in
                     (learning_curves.Curve(setting, states, THESIS) for states in SETS))
    return compared('rows visited after all training, % of all rows: ', 'set 1', first, 'set 2', second, 1)


def any_number(setting):
    six, twelve = (rates(agents(setting), scenario) for scenario in ('circle6', 'circle12'))
    return Judgement(f'one table, six: {rates_sentence(six)}; twelve: {rates_sentence(twelve)}',
                     good_and_rare([six.success, twelve.success], [six.contact, twelve.contact]),
                     f'contact of twelve {number_text(twelve.contact)}')


def staying_pays(setting):
    without, free, dear = (future_work.rates(setting, variation).success
                           for variation in ('thesis', 'stay', 'stay_5'))
    return Judgement(f'success of twelve agents at varied speeds %: {Spread(without).text(1)} without the action, '
                     f'{Spread(free).text(1)} with the action at no cost, {Spread(dear).text(1)} at a cost of 5',
                     decide_all(decide_greater(without, free), decide_greater(dear, free)),
                     f'success at no cost {number_text(free)}')


def staying_helps(setting):
    """Judges whether surrounded agents have fewer contacts if they can stay, at the costs at which agents arrive."""
    def of_surrounded(variation):
        return [one.touched for one in future_work.found_of(setting, variation)]
    without = of_surrounded(THESIS)
    parts = [compared(f'contact of agents that were surrounded, {name}: ', 'without', without, 'with the action',
                      of_surrounded(variation), 1, unit=' %')
             for name, variation in COSTS.items() if is_good(future_work.rates(setting, variation).success.mean())]
    return joined(parts, '; ', f'at the costs at which {GOOD:g} % arrive. ')
