"""Judges the claims of section 4.3: the scenarios."""
import numpy

from crowd_experiments.records import Spread, median, of_scenario

from . import groups, names, scenario_figures, scenario_runs as runs, surroundings
from .claim import NOT_CONFIRMED, Judgement, decide, decide_all, decide_each, decide_greater, versus
from .crowd_verdicts import RARE, both, graded, is_good, is_rare, rates_text
from .measures import COLLISION_RADIUS, CONTACT_OVERLAP, RADIUS, centre_distances, share


def filling_was_needed(setting):
    texts, verdicts = [], []
    for scenario in ('circle6', 'circle12'):
        first, then = (list(zip(*runs.measured(setting, runs.MAIN, scenario, file)))[1]
                       for file in ('single.csv', 'demo.csv'))
        texts.append(f'{scenario}: ' + versus('one obstacle', first, 'several obstacles', then, 1))
        verdicts.append(decide_greater(first, then))
    return Judgement(f'contact % after each part of the training. {"; ".join(texts)}', decide_all(*verdicts))


def path_ratios(setting, scenario):
    """Returns the median path ratio of the agents that arrived, for each seed."""
    records = (runs.record_of(setting, runs.MAIN, seed) for seed in setting.seeds(runs.SEEDS))
    return [median(record['path_ratio'][of_scenario(record, scenario) & (record['arrived'] > 0)]) for record in records]


def dummies(setting):
    texts, verdicts = [], []
    for parameters, scenario in (('thesis', 'dummies'), ('thesis', runs.WIDE), ('better', 'dummies')):
        table = 'agent', 'occupancy', parameters
        texts.append(f'{scenario}, {names.PARAMETER_NAMES[parameters]}: '
                     + names.rates_sentence(runs.measured(setting, table, scenario)))
        if parameters == 'thesis':
            verdicts.append(graded(runs.clean_share(setting, table, seed, scenario)
                                   for seed in setting.seeds(runs.SEEDS)))
    return Judgement('; '.join(texts), decide_all(*verdicts))


def without_incidents(scenario):
    """Judges whether in most episodes all agents arrive without a contact, and without a collision."""
    def judge(setting):
        shares = [[runs.clean_share(setting, runs.MAIN, seed, scenario, incident) for seed in
                   setting.seeds(runs.SEEDS)] for incident in ('touched', 'collided')]
        contact, collision = (Spread(of_seeds).text(1) for of_seeds in shares)
        return Judgement(f'{rates_text(setting, scenario)}; all agents arrive without a contact in {contact} % of the '
                         f'episodes, without a collision in {collision} %', decide_all(*map(graded, shares)))
    return judge


def deviated(setting):
    """Judges whether agents arrive whose path is at least twice the straight-line distance."""
    found, arriving = [], []
    for seed in setting.seeds(runs.SEEDS):
        record = runs.record_of(setting, runs.MAIN, seed)
        rows = of_scenario(record, 'line6')
        lengths = record['path_length'][rows].reshape(-1, 6)
        straight = numpy.array([numpy.hypot(8.0, 2 * y) for y in (3.25, 1.95, 0.65, -0.65, -1.95, -3.25)])
        most = numpy.argmax(lengths / straight, axis=1)
        far = (lengths / straight).max(axis=1) >= 2.0
        arrives = record['arrived'][rows].reshape(-1, 6)[numpy.arange(len(lengths)), most] > 0
        found.append(share(far.sum(), len(far)))
        arriving.append(share((far & arrives).sum(), far.sum()))
    arrivals = Spread.of_numbers(arriving)
    return Judgement(f'{rates_text(setting, "line6")}; the path of an agent is at least twice the straight-line '
                     f'distance in {Spread(found).text(1)} % of the episodes; this agent arrives in '
                     f'{arrivals.text(1)} % of these', decide(is_good(arrivals.mean), map(is_good, arrivals.values)))


def nearest_to_moving_obstacle(setting, seed):
    """Returns the smallest distance of each agent to the moving obstacle's centre [m], in the recorded instances."""
    obstacle = runs.obstacle_places(setting, 'line6_mover', 2001)
    nearest = []
    for places in runs.tracks_of(setting, runs.MAIN, seed, 'line6_mover').values():
        offsets = places - obstacle[:len(places), None]
        nearest += list(numpy.nanmin(numpy.hypot(offsets[..., 0], offsets[..., 1]), axis=0))
    return numpy.array(nearest)


def avoids_moving_obstacle(setting):
    nearest = [nearest_to_moving_obstacle(setting, seed) for seed in setting.seeds(runs.SEEDS)]
    rim = groups.OBSTACLE_RADIUS
    touching, colliding = ([100.0 * float(numpy.mean(of_seed < limit)) for of_seed in nearest]
                           for limit in (rim + RADIUS - CONTACT_OVERLAP, rim + COLLISION_RADIUS))
    ratios = [Spread(path_ratios(setting, scenario)).mean for scenario in ('line6', 'line6_mover')]
    return Judgement(f'{rates_text(setting, "line6_mover")}; {Spread(touching).text(1)} % of the agents have a contact '
                     f'with the moving obstacle, {Spread(colliding).text(1)} % a collision; path ratio {ratios[1]:.2f} '
                     f'with and {ratios[0]:.2f} without it', both((touching, colliding), (is_rare, is_rare)))


def nearness(setting, scenario):
    """Returns the mean distance to the nearest companion before the first arrival, for each seed [m]."""
    return [numpy.mean([groups.companions(places).mean() for places in
                        groups.groups_of(setting, runs.MAIN, seed, scenario)]) for seed in setting.seeds(runs.SEEDS)]


def remain_closer(setting):
    together, apart = nearness(setting, 'same_goal6'), nearness(setting, 'line6')
    rates_of = zip(*runs.measured(setting, runs.MAIN, 'same_goal6'))
    return Judgement(f'{rates_text(setting, "same_goal6")}; distance to the nearest companion [m]: ' +
                     versus('line6', apart, 'same_goal6', together),
                     decide_all(both(rates_of, (is_good, is_rare, is_rare)), decide_greater(apart, together)))


def grouping(setting):
    start, end = map(numpy.array, zip(*groups.last_metre(setting, runs.MAIN, 'same_goal6')))
    apart_start, apart_end = map(numpy.array, zip(*groups.last_metre(setting, runs.MAIN, 'line6')))
    return Judgement('distance to the nearest companion [m]: ' + versus('at the start', start, 'at the end', end)
                     + '; decrease: ' + versus('one goal', start - end, 'line6', apart_start - apart_end),
                     decide_all(decide_greater(start, end), decide_greater(start - end, apart_start - apart_end)))


def phases(setting, measure):
    return groups.measured(setting, runs.MAIN, measure)


PASSED, ARRIVING = 2, 3  # of groups.TIMES
MEASURES = {'nearest companion': groups.companions, 'centre of the group': centre_distances}


def breached(setting):
    texts, verdicts = [], []
    for name, measure in MEASURES.items():
        values = phases(setting, measure)[:, PASSED]
        compared = versus('with the obstacle', values[:, 0], 'without', values[:, 1])
        texts.append(f'distance to the {name} [m]: {compared}')
        verdicts.append(decide_greater(values[:, 0], values[:, 1]))
    return Judgement(f'after the passage, {"; ".join(texts)}', decide_all(*verdicts))


def grouped_again(setting):
    texts, verdicts = [], []
    for name, measure in MEASURES.items():
        passed, arriving = phases(setting, measure)[:, (PASSED, ARRIVING), 0].T
        compared = versus('after the passage', passed, 'at the first arrival', arriving)
        texts.append(f'distance to the {name} [m]: {compared}')
        verdicts.append(decide_greater(passed, arriving))
    free = phases(setting, groups.companions)[:, ARRIVING, 1]
    return Judgement(f'{"; ".join(texts)}; nearest companion at the first arrival, without the obstacle '
                     f'{Spread(free).text()}', decide_all(*verdicts))


def twelve_like_six(setting):
    six, twelve = (list(zip(*runs.measured(setting, runs.MAIN, scenario))) for scenario in ('circle6', 'circle12'))
    differences = [numpy.abs(numpy.subtract(a, b)) for a, b in zip(six[:2], twelve[:2])]
    best = scenario_figures.episode_sentence(setting, runs.MAIN, 'circle12',
                                             scenario_figures.best_of(setting, runs.MAIN, 'circle12'))
    return Judgement(f'six: {rates_text(setting, "circle6")}; twelve: {rates_text(setting, "circle12")} (similar: '
                     f'within {RARE:g} points); the best recorded episode of twelve, {best}',
                     both(differences, (is_rare, is_rare)))


def longer_than_six(setting):
    six, twelve = path_ratios(setting, 'circle6'), path_ratios(setting, 'circle12')
    return Judgement('median path ratio of the agents that arrive: ' + versus('twelve', twelve, 'six', six),
                     decide_greater(twelve, six))


def varied_speeds(setting):
    texts, verdicts = [], []
    for index, name in ((1, 'contact %'), (2, 'collision %')):
        steady, varied = (list(zip(*runs.measured(setting, runs.MAIN, scenario)))[index]
                          for scenario in ('circle12', 'circle12_varied'))
        texts.append(f'{name}: ' + versus('varied speeds', varied, 'one speed', steady, 1))
        verdicts.append(decide_greater(varied, steady))
    shares = [[one.per_thousand() for one in surroundings.measured(setting, runs.MAIN, scenario)]
              for scenario in ('circle12_varied', 'circle12')]
    texts.append('decisions while surrounded, per 1,000: ' + versus('varied speeds', shares[0], 'one speed', shares[1]))
    exact, together = (Spread(list(zip(*runs.measured(setting, runs.MAIN, scenario)))[1]).text(1)
                       for scenario in runs.EXACT)
    texts.append(f'contact of twelve agents that start exactly on the circle {exact} %, if they also move '
                 f'simultaneously {together} %')
    return Judgement('; '.join(texts), decide_all(*verdicts, decide_greater(*shares)))


def surrounded_touch(setting):
    found = surroundings.measured(setting, runs.MAIN, 'circle12_varied')
    pairs = [(one.inside.contact_share(), one.outside.contact_share()) for one in found if one.inside.decisions]
    if not pairs:
        return Judgement('no agent was ever surrounded', NOT_CONFIRMED)
    inside, outside = zip(*pairs)
    agents = Spread.of_numbers(share(one.surrounded_touched, one.surrounded) for one in found)
    verdict = decide_all(decide_greater(inside, outside), decide_each(inside, is_good))
    compared = versus('surrounded', inside, 'not surrounded', outside, 1)
    return Judgement(f'contact within {surroundings.SOON} decisions %: {compared}; of the agents that were ever '
                     f'surrounded, {agents.text(1)} % then have a contact', verdict)
