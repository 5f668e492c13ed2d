"""Judges the claims of 4.3: the scenarios."""
import numpy

from crowd_experiments.records import Spread, median, of_scenario

from . import groups, names, scenario_figures, scenario_runs as runs, surroundings
from .claim import NOT, Judgement, decide, decide_all, decide_each, decide_greater, versus
from .crowd_verdicts import RARE, both, graded, is_good, is_rare, rates_text
from .measures import COLLISION_RADIUS, CONTACT_OVERLAP, RADIUS, centre_distances, share


def filling_was_needed(setting):
    told, verdicts = [], []
    for scenario in ('circle6', 'circle12'):
        first, then = (list(zip(*runs.measured(setting, runs.MAIN, scenario, file)))[1]
                       for file in ('single.csv', 'demo.csv'))
        told.append(f'{scenario}: ' + versus('one obstacle only', first, 'then several', then, 1))
        verdicts.append(decide_greater(first, then))
    return Judgement(f'contact %, by the training. {"; ".join(told)}', decide_all(*verdicts))


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


def nearest_to_moving_obstacle(setting, seed):
    """How near each agent comes to the moving obstacle's centre [m], in the recorded instances."""
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
    start, end = map(numpy.array, zip(*groups.last_metre(setting, runs.MAIN, 'same_goal6')))
    apart_start, apart_end = map(numpy.array, zip(*groups.last_metre(setting, runs.MAIN, 'line6')))
    return Judgement('distance to the nearest companion [m]: ' + versus('at the start', start, 'at the end', end)
                     + '; by how much it falls: ' + versus('one goal', start - end, 'line6', apart_start - apart_end),
                     decide_all(decide_greater(start, end), decide_greater(start - end, apart_start - apart_end)))


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
    best = scenario_figures.told_of(setting, runs.MAIN, 'circle12',
                                    scenario_figures.best_of(setting, runs.MAIN, 'circle12'))
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
