"""Figures 4.17-4.25: crowds that use the table of one agent."""
from crowd_experiments import style
from crowd_experiments.records import Spread

from ..crowds import (APART, CROWDED, GROUPING, LEAST_SECTORS, SCENARIOS, SOON, TIMES, VISIT_CLASSES, WATCHED,
                      add_dummies, add_figures, add_groups, agents, by_visits, last_metre, phases, rates, surrounded)
from ..measures import share
from ..declared import PARAMETERS, SETS, THESIS
from ..results import PARAMETER_NAMES, RATE_HEADER, Runs, rate_texts, report_of

# Columns of tables about surrounded agents: measure of a Surrounded and decimals, by title.
SURROUNDED = {
    'surrounded, per 1,000 decisions': (lambda one: one.per_thousand(), 2),
    'agents ever surrounded %': (lambda one: one.ever, 1),
    f'contact within {SOON} decisions %': (lambda one: one.inside[1], 1),
    'contact, other decisions %': (lambda one: one.outside[1], 1),
    f'collision within {SOON} decisions %': (lambda one: one.inside[2], 1),
    'collision, other decisions %': (lambda one: one.outside[2], 1),
    'longest [decisions]': (lambda one: one.longest, 0),
    'surrounded agents that arrive %': (lambda one: one.arrived, 1),
    f'with a contact within {SOON} decisions %': (lambda one: one.touched, 1)}
SYNCHRONICITY = {'circle12_exact': 'starts exactly on the circle',
                 'circle12_exact_simultaneous': 'starts exactly on the circle, simultaneous moves',
                 'circle12': 'starts up to 5 cm off', 'circle12_varied': 'varied speeds'}


def report(setting):
    chapter = report_of('scenarios', setting, 8, least=LEAST_SECTORS, soon=SOON)
    header = ['', *RATE_HEADER, 'episodes: all arrive, no contact %', 'episodes: all arrive, no collision %',
              'path ratio (arrivals only)', *(f'crowd trained together: {rate}' for rate in RATE_HEADER)]
    columns = PARAMETERS['occupancy']
    chapter.tabulate('summary', ['', *(PARAMETER_NAMES[parameters] for parameters in columns)], [
        [scenario, *(clean_text(agents(setting, parameters), scenario) for parameters in columns)]
        for scenario in SCENARIOS])
    chapter.tabulate('set2_thesis', header, [
        scenario_row(setting, scenario, 'occupancy', THESIS, scenario) for scenario in SCENARIOS])
    chapter.tabulate('others', header, [
        scenario_row(setting, scenario, states, parameters,
                     f'{scenario}, {style.short_set_name(states)}, {PARAMETER_NAMES[parameters]}')
        for scenario in SCENARIOS for states in SETS for parameters in PARAMETERS[states]])
    add_dummies(chapter, setting)
    chapter.tabulate('dummies', ['', *RATE_HEADER], [
        [f'{PARAMETER_NAMES[parameters]}, {scenario}', *rate_texts(rates(agents(setting, parameters), scenario))]
        for scenario in ('dummies', 'dummies_wide') for parameters in PARAMETERS['occupancy']])
    add_figures(chapter, setting)
    add_groups(chapter, setting)
    add_group_tables(chapter, setting)
    chapter.tabulate('surrounded', ['', *SURROUNDED], [
        surrounded_row(f'{PARAMETER_NAMES[parameters]}, {scenario}', surrounded(agents(setting, parameters), scenario))
        for parameters in PARAMETERS['occupancy'] for scenario in WATCHED], definitions=chapter.text_of('definitions'))
    add_visits(chapter, setting)
    add_main_tables(chapter, agents(setting))
    chapter.tabulate('rows', ['', 'rows', 'visited', 'decisions in training [million]'], [
        [f'{label}, {style.SET_NAMES[states]}, {PARAMETER_NAMES[parameters]}',
         *rows_cells(Runs.of(setting, group, states=states, parameters=parameters))]
        for group, label in (('agents', 'one agent'), ('crowds', 'crowd trained together on a mix'))
        for states in SETS for parameters in PARAMETERS[states]])
    return chapter


def clean_text(runs, scenario):
    """Returns the shares of episodes in which all arrive without a contact, and without a collision [%]."""
    shares = (runs.whole('demo.csv', scenario, incident) for incident in ('touched', 'collided'))
    return ' / '.join(f'{share_of_seeds.mean():.0f}' for share_of_seeds in shares)


def scenario_row(setting, scenario, states, parameters, label):
    """Returns a row with the results of one agent's table, followed by those of a crowd's table."""
    runs = agents(setting, parameters, states)
    clean = [Spread(runs.whole('demo.csv', scenario, incident)).text(1) for incident in ('touched', 'collided')]
    ratio = Spread.of_numbers(runs.arrivals('demo.csv', 'path_ratio', scenario)).text(2)
    crowd = Runs.of(setting, 'crowds', states=states, parameters=parameters)
    return [label, *rate_texts(rates(runs, scenario)), *clean, ratio, *rate_texts(rates(crowd, scenario))]


def add_group_tables(chapter, setting):
    rows = []
    for parameters in PARAMETERS['occupancy']:
        for title, measure in GROUPING.items():
            values = phases(agents(setting, parameters), measure)
            for i, scenario in enumerate(('with the moving obstacle', 'without it, at the same ticks')):
                rows.append([f'{PARAMETER_NAMES[parameters]}, distance to the {title}, {scenario}',
                             *(Spread.of_numbers(of_time).text(2) for of_time in values[:, :, i].T)])
    chapter.tabulate('groups', ['', *TIMES], rows)
    chapter.tabulate('groups_end', ['', 'at the start', 'at the first arrival'], [
        [f'{PARAMETER_NAMES[parameters]}, {scenario}',
         *(Spread(values).text(2) for values in last_metre(agents(setting, parameters), scenario).T)]
        for parameters in PARAMETERS['occupancy'] for scenario in ('same_goal6', 'same_goal6_mover', APART)])


def surrounded_row(label, found):
    return [label, *(Spread.of_numbers(map(measure, found)).text(decimals)
                     for measure, decimals in SURROUNDED.values())]


def add_visits(chapter, setting):
    """Adds the table of decisions in rows of the Q-table that were rarely visited in training (5.1)."""
    rows = []
    for scenario in WATCHED:
        for least, label in ((0, 'all decisions'), (CROWDED, f'{CROWDED} or more sectors occupied')):
            seeds = by_visits(agents(setting), scenario, least)
            for i, visited in enumerate(VISIT_CLASSES.values()):
                shares = [(share(outcomes.decisions[i], outcomes.decisions.sum()),
                           share(outcomes.contact[i], outcomes.decisions[i]),
                           share(outcomes.collision[i], outcomes.decisions[i])) for outcomes in seeds]
                rows.append([f'{scenario}, {label}, row visited {visited}',
                             *(Spread.of_numbers(of_seeds).text(2) for of_seeds in zip(*shares))])
    chapter.tabulate('visits', ['', 'decisions %', 'followed by contact %', 'followed by collision %'], rows)


def add_main_tables(chapter, runs):
    """Adds the tables about synchronicity and about both parts of the training, of the thesis's set 2."""
    rows = []
    for scenario, label in SYNCHRONICITY.items():
        found = rates(runs, scenario)
        clean = ((found.success == 100) & (found.contact == 0)).sum()
        rows.append([f'{scenario}: {label}', *rate_texts(found), f'{clean} of {len(found)}'])
    chapter.tabulate('synchronicity', ['', *RATE_HEADER, 'seeds in which all arrive without a contact'], rows)
    chapter.tabulate('first_part', ['', *(
        f'{label}: {rate}' for label in ('after one obstacle (4.1)', 'after several obstacles (4.3)')
        for rate in RATE_HEADER)], [[scenario, *rate_texts(runs.rates('single.csv', scenario)),
                                     *rate_texts(rates(runs, scenario))] for scenario in SCENARIOS])


def rows_cells(runs):
    rows, visited, decisions = (runs.headers('q_table.txt', key) for key in ('rows', 'visited_rows', 'decisions'))
    return [f'{rows[0]:.0f}', Spread(visited).text(0), Spread(number / 1e6 for number in decisions).text(1)]
