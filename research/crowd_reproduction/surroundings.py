"""Surrounded agents (figure 4.25), and rows of the Q-table that were rarely visited in training (5.1)."""
from crowd_experiments.records import Spread

from . import names, scenario_runs as runs
from .measures import by_visits, share, surrounded

LEAST_SECTORS = 7  # of 8 occupied: "in almost every single angle interval"
SOON = 10  # [ticks], in which an agent walks 0.3 m, which is more than its radius
VISIT_CLASSES = {0: 'never', 1: '1-9 times', 10: '10-99 times', 100: '100 times or more'}
CROWDED = 3  # sectors
# Columns of the table: measure and decimals, by title.
COLUMNS = {
    'surrounded, per 1,000 decisions': (lambda one: one.per_thousand(), 2),
    'agents ever surrounded %': (lambda one: share(one.surrounded, one.agents), 1),
    f'contact within {SOON} decisions %': (lambda one: one.inside.contact_share(), 1),
    'contact, other decisions %': (lambda one: one.outside.contact_share(), 1),
    f'collision within {SOON} decisions %': (lambda one: one.inside.collision_share(), 1),
    'collision, other decisions %': (lambda one: one.outside.collision_share(), 1),
    'longest [decisions]': (lambda one: one.longest, 0),
    'surrounded agents that arrive %': (lambda one: share(one.surrounded_arrived, one.surrounded), 1),
    f'with a contact within {SOON} decisions %': (lambda one: one.touched_share(), 1)}
HEADER = ['', *COLUMNS]
DEFINITIONS = (
    f'Surrounded: {LEAST_SECTORS} or 8 of 8 sectors occupied. Contact and collision: with another agent, at the '
    f'end of any of the next {SOON} decisions. Other decisions: those with fewer sectors occupied. The last two '
    'columns refer to the agents that were ever surrounded')


def measured(setting, table, scenario):
    """Returns a Surrounded for each seed."""
    return [surrounded(runs.decisions_of(setting, table, seed, scenario),
                       runs.arrivals_of(setting, table, seed, scenario), LEAST_SECTORS, SOON)
            for seed in setting.seeds(runs.SEEDS)]


def row_of(label, found):
    """Returns a row of the table, from a Surrounded for each seed."""
    return [label, *(Spread.of_numbers(map(measure, found)).text(decimals) for measure, decimals in COLUMNS.values())]


def add_table(chapter, setting):
    rows = [row_of(f'{names.PARAMETER_NAMES[parameters]}, {scenario}',
                   measured(setting, ('agent', 'occupancy', parameters), scenario))
            for parameters in runs.PARAMETERS for scenario in runs.WATCHED]
    chapter.add_table(f'Surrounded agents (figure 4.25); state set 2, one agent\'s table. {DEFINITIONS}. Mean ± '
                      'standard deviation over the seeds with surrounded agents (lowest-highest)', HEADER, rows,
                      name='surrounded')


def visits_measured(setting, table, scenario, least_sectors):
    """Returns the outcomes by classes of visits, a list for each seed."""
    return [by_visits(runs.decisions_of(setting, table, seed, scenario), runs.visits_of(setting, table, seed),
                      list(VISIT_CLASSES), SOON, least_sectors) for seed in setting.seeds(runs.SEEDS)]


def add_visits_table(chapter, setting):
    rows = []
    for scenario in runs.WATCHED:
        for least, label in ((0, 'all decisions'), (CROWDED, f'{CROWDED} or more sectors occupied')):
            seeds = visits_measured(setting, runs.MAIN, scenario, least)
            for i, visited in enumerate(VISIT_CLASSES.values()):
                of_all = [share(outcomes[i].decisions, sum(outcome.decisions for outcome in outcomes))
                          for outcomes in seeds]
                rows.append([f'{scenario}, {label}, row visited {visited}', Spread(of_all).text(2),
                             Spread.of_numbers(outcomes[i].contact_share() for outcomes in seeds).text(2),
                             Spread.of_numbers(outcomes[i].collision_share() for outcomes in seeds).text(2)])
    chapter.add_table('An incomplete table (5.1): decisions by the number of visits of their row in training, and '
                      f'contacts and collisions within the next {SOON} decisions; state set 2, thesis\'s parameters, '
                      'one agent\'s table. Mean ± standard deviation over the seeds (lowest-highest)',
                      ['', 'decisions %', 'followed by contact %', 'followed by collision %'], rows, name='visits')
