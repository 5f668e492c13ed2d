"""Figures 4.17-4.25: crowds that walk by what one agent learned."""
from crowd_experiments import style
from crowd_experiments.chapter import Chapter
from crowd_experiments.records import Spread, median, of_scenario, read_table_header

from .. import agent_runs, agent_training, groups, names, scenario_figures, scenario_runs as runs, surroundings

NAME = runs.NAME
TITLE = 'Scenarios (figures 4.17-4.25)'


def plan(setting):
    """The agents that learned alone, and the crowds that learned together."""
    return agent_runs.plan(setting) + runs.plan(setting)


def report(setting):
    """The chapter, from the runs' records."""
    chapter = Chapter(NAME, TITLE)
    chapter.add_text(
        "The thesis's agents: they always walk at full speed, and walk through what they fail to avoid. "
        f'{agent_training.DESCRIPTION} Its table, which no longer changes, is what every agent of the scenarios walks by; '
        'none of the scenarios was met in training. This is the protocol of 4.3; set 2 with the thesis\'s parameters '
        'is the main result. Beside it, labelled so: "the crowd learned together", all agents in one table, for '
        f'{setting.count(runs.MIX_EPISODES, 16):,} episodes of a mix of eight scenarios, most of them the very ones '
        f'that are tested. {len(setting.seeds(runs.SEEDS))} training seeds, {setting.count(runs.EPISODES, 2)} '
        'instances a scenario, whose starts are drawn anew each time.')
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
    """Success, collision and contact."""
    success, contact, collision = map(Spread, zip(*runs.measured(setting, table, scenario, file)))
    return [success.text(1), collision.text(1), contact.text(1)]


def scenario_row(setting, scenario, states, parameters, label):
    """By one agent's table, then by that of a crowd."""
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
    header = ['', 'success %', 'collision %', 'contact %', 'episodes: all arrive, no contact %',
              'episodes: all arrive, no collision %',
              'path ratio (arrivals only)', *(f'the crowd learned together: {measure} %' for measure in
                                              ('success', 'collision', 'contact'))]
    spread = 'mean ± standard deviation over the seeds (lowest-highest); path ratio: the median, seed by seed'
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
    for scenario, label in (('circle12_exact', 'all start exactly on the circle'),
                           ('circle12_exact_simultaneous', 'and all move at the same time'),
                           ('circle12', 'starts up to 5 cm off'), ('circle12_varied', 'varied speeds')):
        rates = runs.measured(setting, runs.MAIN, scenario)
        success, contact, collision = map(Spread, zip(*rates))
        clean = sum(arrived == 100 and touched == 0 for arrived, touched, _ in rates)
        rows.append([f'{scenario}: {label}', success.text(1), collision.text(1), contact.text(1),
                     f'{clean} of {len(rates)}'])
    chapter.add_table("Synchronicity: set 2, thesis's parameters, one agent's table; mean ± standard deviation over "
                      'the seeds (lowest-highest)',
                      ['', 'success %', 'collision %', 'contact %', 'seeds in which all arrive without contact'],
                      rows, name='synchronicity')


def add_first_part(chapter, setting):
    rows = [[scenario, *rate_texts(setting, runs.MAIN, scenario, 'single.csv'),
             *rate_texts(setting, runs.MAIN, scenario)] for scenario in runs.SCENARIOS]
    chapter.add_table("What the more thorough training is good for: set 2, thesis's parameters, one agent's table "
                      'after each part of its training; mean ± standard deviation over the seeds (lowest-highest)',
                      ['', *(f'{label}: {measure} %' for told in ('one obstacle only (4.1)', 'then several (4.3)')
                             for measure in ('success', 'collision', 'contact'))], rows, name='first_part')


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
    chapter.add_table('Rows of the table that were ever visited in training; mean ± standard deviation over the seeds '
                      '(lowest-highest)', ['', 'rows', 'visited', 'decisions learned from [million]'], rows,
                      name='rows')


def add_dummies_table(chapter, setting):
    rows = [[f'{names.PARAMETER_NAMES[parameters]}, {scenario}',
             *rate_texts(setting, ('agent', 'occupancy', parameters), scenario)]
            for scenario in ('dummies', runs.WIDE) for parameters in runs.PARAMETERS]
    chapter.add_table(f"Dummies, and the same {runs.WIDER:g} times as far apart ({runs.WIDE}); set 2, one agent's "
                      'table; mean ± standard deviation over the seeds (lowest-highest)',
                      ['', 'success %', 'collision %', 'contact %'], rows, name='dummies')
