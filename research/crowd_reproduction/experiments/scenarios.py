"""Figures 4.17-4.25: crowds that use the table of one agent."""
from crowd_experiments import style
from crowd_experiments.pages import Chapter
from crowd_experiments.records import Spread, median, of_scenario, read_table_header

from .. import agent_runs, agent_training, groups, names, scenario_figures, scenario_runs as runs, surroundings

NAME = runs.NAME
TITLE = 'Scenarios (figures 4.17-4.25)'


def plan(setting):
    """Returns the runs of the agents that learn alone, and of the crowds that are trained together."""
    return agent_runs.plan(setting) + runs.plan(setting)


def report(setting):
    """Returns the chapter, from the runs' records."""
    chapter = Chapter(NAME, TITLE)
    chapter.add_text(
        "The thesis's agents always walk at full speed, and walk through bodies that they do not avoid. "
        f'{agent_training.DESCRIPTION} All agents of the scenarios use its table, which does not change; none of the '
        'scenarios was used in the training. This is the protocol of 4.3; set 2 with the thesis\'s parameters is the '
        'main result. For comparison, "crowd trained together": all agents learned in one table, in '
        f'{setting.count(runs.MIX_EPISODES, 16):,} episodes of a mix of eight scenarios, most of which are also used '
        f'in the test. {len(setting.seeds(runs.SEEDS))} training seeds, {setting.count(runs.EPISODES, 2)} '
        'instances per scenario with random starts.')
    add_tables(chapter, setting)
    scenario_figures.add_dummies(chapter, setting)
    add_dummies_table(chapter, setting)
    for scenario in scenario_figures.NUMBERS:
        scenario_figures.add_moments(chapter, setting, scenario)
    scenario_figures.add_best(chapter, setting)
    scenario_figures.add_worst(chapter, setting)
    groups.add_figure(chapter, setting)
    groups.add_table(chapter, setting)
    surroundings.add_table(chapter, setting)
    surroundings.add_visits_table(chapter, setting)
    add_synchronicity(chapter, setting)
    add_first_part(chapter, setting)
    add_rows(chapter, setting)
    return chapter


def rate_texts(setting, table, scenario, file=runs.DEMO):
    """Returns the texts of success, collision and contact."""
    return names.rate_texts(runs.measured(setting, table, scenario, file))


def scenario_row(setting, scenario, states, parameters, label):
    """Returns a row with the results of one agent's table, followed by those of a crowd's table."""
    table = ('agent', states, parameters)
    seeds = setting.seeds(runs.SEEDS)
    ratios = []
    for seed in seeds:
        record = runs.record_of(setting, table, seed)
        ratios.append(median(record['path_ratio'][of_scenario(record, scenario) & (record['arrived'] > 0)]))
    clean = [Spread(runs.clean_share(setting, table, seed, scenario, incident) for seed in seeds).text(1)
             for incident in ('touched', 'collided')]
    return [label, *rate_texts(setting, table, scenario), *clean, Spread.of_numbers(ratios).text(2),
            *rate_texts(setting, ('crowd', states, parameters), scenario)]


def add_tables(chapter, setting):
    header = ['', *names.RATES, 'episodes: all arrive, no contact %', 'episodes: all arrive, no collision %',
              'path ratio (arrivals only)', *(f'crowd trained together: {rate}' for rate in names.RATES)]
    spread = 'mean ± standard deviation over the seeds (lowest-highest); path ratio: the median of each seed'
    chapter.add_table(f"Set 2, thesis's parameters, one agent's table; {spread}", header,
                      [scenario_row(setting, scenario, 'occupancy', 'thesis', scenario) for scenario in runs.SCENARIOS],
                      name='set2_thesis')
    rows = [scenario_row(setting, scenario, states, parameters,
                         f'{scenario}, {style.short_set_name(states)}, {names.PARAMETER_NAMES[parameters]}')
            for scenario in runs.SCENARIOS for states, parameters in
            (('nearest', 'thesis'), ('nearest', 'better'), ('occupancy', 'better'))]
    chapter.add_table(f"The other sets and parameters, one agent's table; {spread}", header, rows, name='others')


def add_synchronicity(chapter, setting):
    rows = []
    for scenario, label in (('circle12_exact', 'starts exactly on the circle'),
                            ('circle12_exact_simultaneous', 'starts exactly on the circle, simultaneous moves'),
                            ('circle12', 'starts up to 5 cm off'), ('circle12_varied', 'varied speeds')):
        rates = runs.measured(setting, runs.MAIN, scenario)
        clean = sum(arrived == 100 and touched == 0 for arrived, touched, _ in rates)
        rows.append([f'{scenario}: {label}', *names.rate_texts(rates), f'{clean} of {len(rates)}'])
    chapter.add_table("Synchronicity: set 2, thesis's parameters, one agent's table; mean ± standard deviation over "
                      'the seeds (lowest-highest)',
                      ['', *names.RATES, 'seeds in which all arrive without a contact'],
                      rows, name='synchronicity')


def add_first_part(chapter, setting):
    rows = [[scenario, *rate_texts(setting, runs.MAIN, scenario, 'single.csv'),
             *rate_texts(setting, runs.MAIN, scenario)] for scenario in runs.SCENARIOS]
    chapter.add_table("Effect of the more thorough training: set 2, thesis's parameters, one agent's table "
                      'after each part of the training; mean ± standard deviation over the seeds (lowest-highest)',
                      ['', *(f'{label}: {rate}' for label in
                             ('after one obstacle (4.1)', 'after several obstacles (4.3)') for rate in names.RATES)],
                      rows, name='first_part')


def add_rows(chapter, setting):
    rows = []
    for learner, label in runs.LEARNERS.items():
        for parameters in runs.PARAMETERS:
            for states in runs.SETS:
                headers = [read_table_header(runs.folder_of(setting, (learner, states, parameters), seed)
                                             / agent_training.TABLE) for seed in setting.seeds(runs.SEEDS)]
                visited = Spread(float(header['visited_rows']) for header in headers)
                decisions = Spread(float(header['decisions']) / 1e6 for header in headers)
                rows.append([f'{label}, {style.SET_NAMES[states]}, {names.PARAMETER_NAMES[parameters]}',
                             headers[0]['rows'], visited.text(0), decisions.text(1)])
    chapter.add_table('Rows of the table that were visited in training; mean ± standard deviation over the seeds '
                      '(lowest-highest)', ['', 'rows', 'visited', 'decisions in training [million]'], rows,
                      name='rows')


def add_dummies_table(chapter, setting):
    rows = [[f'{names.PARAMETER_NAMES[parameters]}, {scenario}',
             *rate_texts(setting, ('agent', 'occupancy', parameters), scenario)]
            for scenario in ('dummies', runs.WIDE) for parameters in runs.PARAMETERS]
    chapter.add_table(f"Dummies, and the same dummies at {runs.WIDER:g} times the distances ({runs.WIDE}); set 2, one "
                      "agent's table; mean ± standard deviation over the seeds (lowest-highest)",
                      ['', *names.RATES], rows, name='dummies')
