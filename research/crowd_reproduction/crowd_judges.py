"""Judges the claims of section 4.3: the scenarios."""
import numpy
from crowd_experiments.records import Spread, median, of_scenario

from . import groups, names, scenario_figures, scenario_runs as runs, surroundings
from .claim import (NOT_CONFIRMED, RARE, Judgement, both, compared, decide, decide_all, decide_each, decide_greater,
                    graded, is_good, is_rare, joined, versus)
from .measures import COLLISION_RADIUS, CONTACT_OVERLAP, RADIUS, centre_distances, share

RATES = {'contact %': 1, 'collision %': 2}  # places in rates
PASSED, ARRIVING = 2, 3  # of groups.TIMES
MEASURES = {'nearest companion': groups.companions, 'centre of the group': centre_distances}
STARTS = numpy.array([3.25, 1.95, 0.65, -0.65, -1.95, -3.25])  # of line6 [m]


def rates_text(setting, scenario):
    """Returns the rates of the main table in a scenario as a text."""
    return names.rates_sentence(runs.measured(setting, runs.MAIN, scenario))


def rates_of(setting, scenario, file=runs.DEMO):
    """Returns success, contact and collision [%] of the main table, each with a value for each seed."""
    return list(zip(*runs.measured(setting, runs.MAIN, scenario, file)))


def of_seeds(setting, measure):
    """Returns a value for each seed."""
    return [measure(seed) for seed in setting.seeds(runs.SEEDS)]


def filling_was_needed(setting):
    parts = []
    for scenario in ('circle6', 'circle12'):
        first, then = (rates_of(setting, scenario, file)[1] for file in ('single.csv', 'demo.csv'))
        parts.append(compared(f'{scenario}: ', 'one obstacle', first, 'several obstacles', then, 1))
    return joined(parts, '; ', 'contact % after each part of the training. ')


def path_ratios(setting, scenario):
    """Returns the median path ratio of the agents that arrived, for each seed."""
    records = of_seeds(setting, lambda seed: runs.record_of(setting, runs.MAIN, seed))
    return [median(record['path_ratio'][of_scenario(record, scenario) & (record['arrived'] > 0)]) for record in records]


def dummies(setting):
    texts, verdicts = [], []
    for parameters, scenario in scenario_figures.DUMMIES:
        table = 'agent', 'occupancy', parameters
        texts.append(f'{scenario}, {names.PARAMETER_NAMES[parameters]}: '
                     + names.rates_sentence(runs.measured(setting, table, scenario)))
        if parameters == 'thesis':
            verdicts.append(graded(of_seeds(setting, lambda seed: runs.clean_share(setting, table, seed, scenario))))
    return Judgement('; '.join(texts), decide_all(*verdicts))


def without_incidents(setting, scenario):
    """Judges whether in most episodes all agents arrive without a contact, and without a collision."""
    shares = [of_seeds(setting, lambda seed: runs.clean_share(setting, runs.MAIN, seed, scenario, incident))
              for incident in ('touched', 'collided')]
    contact, collision = (Spread(values).text(1) for values in shares)
    return Judgement(f'{rates_text(setting, scenario)}; all agents arrive without a contact in {contact} % of the '
                     f'episodes, without a collision in {collision} %', decide_all(*map(graded, shares)))


def deviated(setting):
    """Judges whether agents arrive whose path is at least twice the straight-line distance."""
    found, arriving = [], []
    for seed in setting.seeds(runs.SEEDS):
        record = runs.record_of(setting, runs.MAIN, seed)
        rows = of_scenario(record, 'line6')
        ratios = record['path_length'][rows].reshape(-1, 6) / numpy.hypot(8.0, 2 * STARTS)
        far = ratios.max(axis=1) >= 2.0
        arrives = record['arrived'][rows].reshape(-1, 6)[numpy.arange(len(ratios)), numpy.argmax(ratios, axis=1)] > 0
        found.append(share(far.sum(), len(far)))
        arriving.append(share((far & arrives).sum(), far.sum()))
    arrivals = Spread.of_numbers(arriving)
    return Judgement(f'{rates_text(setting, "line6")}; the path of an agent is at least twice the straight-line '
                     f'distance in {Spread(found).text(1)} % of the episodes; this agent arrives in '
                     f'{arrivals.text(1)} % of these', decide(is_good(arrivals.mean), map(is_good, arrivals.values)))


def nearest_to_moving_obstacle(setting, seed):
    """Returns the smallest distance of each agent to the moving obstacle's centre [m], in the recorded instances."""
    obstacle = runs.obstacle_places(setting, 'line6_mover', 2001)
    offsets = [places - obstacle[:len(places), None]
               for places in runs.tracks_of(setting, runs.MAIN, seed, 'line6_mover').values()]
    return numpy.concatenate([numpy.nanmin(numpy.hypot(away[..., 0], away[..., 1]), axis=0) for away in offsets])


def avoids_moving_obstacle(setting):
    nearest = of_seeds(setting, lambda seed: nearest_to_moving_obstacle(setting, seed))
    touching, colliding = (
        [100.0 * float(numpy.mean(values < groups.OBSTACLE_RADIUS + reach)) for values in nearest]
        for reach in (RADIUS - CONTACT_OVERLAP, COLLISION_RADIUS))
    without, ratio = (Spread(path_ratios(setting, scenario)).mean for scenario in ('line6', 'line6_mover'))
    return Judgement(f'{rates_text(setting, "line6_mover")}; {Spread(touching).text(1)} % of the agents have a contact '
                     f'with the moving obstacle, {Spread(colliding).text(1)} % a collision; path ratio {ratio:.2f} '
                     f'with and {without:.2f} without it', both((touching, colliding), (is_rare, is_rare)))


def nearness(setting, scenario):
    """Returns the mean distance to the nearest companion before the first arrival, for each seed [m]."""
    return of_seeds(setting, lambda seed: numpy.mean([
        groups.companions(places).mean() for places in groups.groups_of(setting, runs.MAIN, seed, scenario)]))


def remain_closer(setting):
    nearer = compared('', 'line6', nearness(setting, 'line6'), 'same_goal6', nearness(setting, 'same_goal6'))
    verdict = both(rates_of(setting, 'same_goal6'), (is_good, is_rare, is_rare))
    return Judgement(f'{rates_text(setting, "same_goal6")}; distance to the nearest companion [m]: {nearer.measured}',
                     decide_all(verdict, nearer.verdict))


def grouping(setting):
    (start, end), (apart_start, apart_end) = (
        map(numpy.array, zip(*groups.last_metre(setting, runs.MAIN, scenario))) for scenario in ('same_goal6', 'line6'))
    return joined([compared('', 'at the start', start, 'at the end', end),
                   compared('decrease: ', 'one goal', start - end, 'line6', apart_start - apart_end)], '; ',
                  'distance to the nearest companion [m]: ')


def phases(setting, measure):
    return groups.measured(setting, runs.MAIN, measure)


def breached(setting):
    values = {name: phases(setting, measure)[:, PASSED].T for name, measure in MEASURES.items()}
    return joined([compared(f'distance to the {name} [m]: ', 'with the obstacle', crossed, 'without', free)
                   for name, (crossed, free) in values.items()], '; ', 'after the passage, ')


def grouped_again(setting):
    parts = []
    for name, measure in MEASURES.items():
        passed, arriving = phases(setting, measure)[:, (PASSED, ARRIVING), 0].T
        parts.append(compared(f'distance to the {name} [m]: ', 'after the passage', passed, 'at the first arrival',
                              arriving))
    whole, free = joined(parts, '; '), phases(setting, groups.companions)[:, ARRIVING, 1]
    return Judgement(f'{whole.measured}; nearest companion at the first arrival, without the obstacle '
                     f'{Spread(free).text()}', whole.verdict)


def twelve_like_six(setting):
    six, twelve = (rates_of(setting, scenario)[:2] for scenario in ('circle6', 'circle12'))
    best = scenario_figures.episode_sentence(setting, runs.MAIN, 'circle12',
                                             scenario_figures.best_of(setting, runs.MAIN, 'circle12'))
    return Judgement(f'six: {rates_text(setting, "circle6")}; twelve: {rates_text(setting, "circle12")} (similar: '
                     f'within {RARE:g} points); the best recorded episode of twelve, {best}',
                     both(numpy.abs(numpy.subtract(six, twelve)), (is_rare, is_rare)))


def longer_than_six(setting):
    return compared('median path ratio of the agents that arrive: ', 'twelve', path_ratios(setting, 'circle12'), 'six',
                    path_ratios(setting, 'circle6'))


def varied_speeds(setting):
    parts = []
    for name, place in RATES.items():
        steady, varied = (rates_of(setting, scenario)[place] for scenario in runs.WATCHED)
        parts.append(compared(f'{name}: ', 'varied speeds', varied, 'one speed', steady, 1))
    steady, varied = ([one.per_thousand() for one in surroundings.measured(setting, runs.MAIN, scenario)]
                      for scenario in runs.WATCHED)
    parts.append(compared('decisions while surrounded, per 1,000: ', 'varied speeds', varied, 'one speed', steady))
    whole = joined(parts, '; ')
    exact, together = (Spread(rates_of(setting, scenario)[1]).text(1) for scenario in runs.EXACT)
    return Judgement(f'{whole.measured}; contact of twelve agents that start exactly on the circle {exact} %, if they '
                     f'also move simultaneously {together} %', whole.verdict)


def surrounded_touch(setting):
    found = surroundings.measured(setting, runs.MAIN, 'circle12_varied')
    pairs = [(one.inside.contact_share(), one.outside.contact_share()) for one in found if one.inside.decisions]
    if not pairs:
        return Judgement('no agent was ever surrounded', NOT_CONFIRMED)
    inside, outside = zip(*pairs)
    agents = Spread.of_numbers(one.touched_share() for one in found)
    return Judgement(f'contact within {surroundings.SOON} decisions %: '
                     f'{versus("surrounded", inside, "not surrounded", outside, 1)}; of the agents that were ever '
                     f'surrounded, {agents.text(1)} % then have a contact',
                     decide_all(decide_greater(inside, outside), decide_each(inside, is_good)))
