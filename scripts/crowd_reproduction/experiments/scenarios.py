"""Figures 4.17-4.25: crowds that walk by what one agent learned."""
import numpy

from crowd_drawing.files import read_scene, read_walks
from crowd_drawing.picture import colours_of
from crowd_experiments import style
from crowd_experiments.chapter import Chapter
from crowd_experiments.records import Spread, median, of_scenario, read_table_header
from crowd_experiments.scene_figures import draw_moment, draw_scene, frame_alike, last_tick_of

from .. import agent_runs, agent_training, groups, names, scenario_runs as runs, surroundings

NAME = runs.NAME
TITLE = 'Scenarios (figures 4.17-4.25)'
MOMENTS = (0.15, 0.4, 0.65, 1.0)  # of the time until the last one arrived
NUMBERS = {'circle6': '4_18', 'circle6_obstacle': '4_19', 'line6': '4_20', 'line6_mover': '4_21', 'same_goal6': '4_22',
           'same_goal6_mover': '4_23'}
DUMMY_COLOUR = '#d63ad6'  # magenta in the thesis
PATH_COLOUR = '#d62728'
SURROUNDED_COLOUR = '#ff7f0e'  # orange in the thesis
KEY = 'Discs: bodies; circles: agents that have arrived and left; crosses: goals; grey: obstacles.'


def plan(setting):
    """The agents that learned alone, and the crowds that learned together."""
    return agent_runs.plan(setting) + runs.plan(setting)


def report(setting):
    """The chapter, from the runs' records."""
    chapter = Chapter(NAME, TITLE)
    chapter.tell(
        "The thesis's agents: they always walk at full speed, and walk through what they fail to avoid. "
        f'{agent_training.TOLD} Its table, which no longer changes, is what every agent of the scenarios walks by; '
        'none of the scenarios was met in training. This is the protocol of 4.3; set 2 with the thesis\'s parameters '
        'is the main result. Beside it, labelled so: "the crowd learned together", all agents in one table, for '
        f'{setting.count(runs.MIX_EPISODES, 16):,} episodes of a mix of eight scenarios, most of them the very ones '
        f'that are tested. {len(setting.seeds(runs.SEEDS))} training seeds, {setting.count(runs.EPISODES, 2)} '
        'instances a scenario, whose starts are drawn anew each time.')
    add_tables(chapter, setting)
    add_dummies(chapter, setting)
    add_dummies_table(chapter, setting)
    for scenario in NUMBERS:
        add_moments(chapter, setting, scenario)
    add_best(chapter, setting)
    add_worst(chapter, setting)
    groups.add_figure(chapter, setting)
    groups.add_table(chapter, setting)
    surroundings.add_table(chapter, setting)
    surroundings.add_visits_table(chapter, setting)
    add_synchronicity(chapter, setting)
    add_first_part(chapter, setting)
    add_rows(chapter, setting)
    return chapter


# Tables.


def rate_texts(setting, table, scenario, file=runs.DEMO):
    """Success, collision and contact."""
    success, contact, collision = map(Spread, zip(*runs.measured(setting, table, scenario, file)))
    return [success.text(1), collision.text(1), contact.text(1)]


def scenario_row(setting, scenario, states, parameters, told):
    """By one agent's table, then by that of a crowd."""
    table = ('agent', states, parameters)
    seeds = setting.seeds(runs.SEEDS)
    ratios = []
    for seed in seeds:
        record = runs.record_of(setting, table, seed)
        ratios.append(median(record['path_ratio'][of_scenario(record, scenario) & (record['arrived'] > 0)]))
    clean = [Spread(runs.clean_share(setting, table, seed, scenario, incident) for seed in seeds).text(1)
             for incident in ('touched', 'collided')]
    return [told, *rate_texts(setting, table, scenario), *clean, Spread.of_numbers(ratios).text(2),
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
    for scenario, told in (('circle12_exact', 'all start exactly on the circle'),
                           ('circle12_exact_simultaneous', 'and all move at the same time'),
                           ('circle12', 'starts up to 5 cm off'), ('circle12_varied', 'varied speeds')):
        rates = runs.measured(setting, runs.MAIN, scenario)
        success, contact, collision = map(Spread, zip(*rates))
        clean = sum(arrived == 100 and touched == 0 for arrived, touched, _ in rates)
        rows.append([f'{scenario}: {told}', success.text(1), collision.text(1), contact.text(1),
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
                      ['', *(f'{told}: {measure} %' for told in ('one obstacle only (4.1)', 'then several (4.3)')
                             for measure in ('success', 'collision', 'contact'))], rows, name='first_part')


def add_rows(chapter, setting):
    rows = []
    for learner, told in runs.LEARNERS.items():
        for parameters in runs.PARAMETERS:
            for states in runs.SETS:
                headers = [read_table_header(runs.folder_of(setting, (learner, states, parameters), seed)
                                             / agent_training.TABLE) for seed in setting.seeds(runs.SEEDS)]
                visited = Spread(float(header['visited_rows']) for header in headers)
                decisions = Spread(float(header['decisions']) / 1e6 for header in headers)
                rows.append([f'{told}, {style.SET_NAMES[states]}, {names.PARAMETER_NAMES[parameters]}',
                             headers[0]['rows'], visited.text(0), decisions.text(1)])
    chapter.add_table('Rows of the table that were ever visited in training; mean ± standard deviation over the seeds '
                      '(lowest-highest)', ['', 'rows', 'visited', 'decisions learned from [million]'], rows,
                      name='rows')


# Figures.


def recorded(setting, table, scenario):
    """Seed and instance of each recorded episode."""
    return [(seed, instance) for seed in setting.seeds(runs.SEEDS) for instance in range(setting.count(runs.WALKED, 2))]


def all_arrive(setting, table, scenario, seed, instance):
    episodes = runs.episodes_of(setting, table, seed, scenario)
    return episodes['arrived'][instance] == episodes['agents']


def share_told(setting, table, scenario):
    """In how many of all episodes all agents arrive, and how many agents collide and touch, in words."""
    whole = Spread(100.0 * numpy.mean(episodes['arrived'] == episodes['agents']) for episodes in
                   (runs.episodes_of(setting, table, seed, scenario) for seed in setting.seeds(runs.SEEDS)))
    success, contact, collision = (Spread(values).mean for values in
                                   zip(*runs.measured(setting, table, scenario)))
    return (f'{success:.0f} % of all agents arrive, {collision:.0f} % collide, {contact:.1f} % touch; all of them '
            f'arrive in {whole.mean:.0f} % of the episodes')


def first_success(setting, table, scenario):
    """The first recorded episode in which all arrive; the very first if there is none."""
    episodes = recorded(setting, table, scenario)
    return next((episode for episode in episodes if all_arrive(setting, table, scenario, *episode)), episodes[0])


DUMMIES = (('thesis', 'dummies'), ('thesis', runs.WIDE), ('better', 'dummies'))  # the lines of figure 4.17


def add_dummies(chapter, setting):
    """Figure 4.17: four episodes with their whole paths."""
    figure, axes = style.new_figure(len(DUMMIES), 4, 13, 9, sharex='row', sharey='row')
    told = []
    sizes = [draw_dummies(line, setting, ('agent', 'occupancy', parameters), scenario, told)
             for line, (parameters, scenario) in zip(axes, DUMMIES)]
    figure.set_size_inches(13, sum(0.9 + 3.0 * height / width for width, height in sizes))
    chapter.add_figure(style.save(figure, setting.figure_file('figure_4_17_dummies')),
                       'Figure 4.17: one agent in a field of resting dummies (magenta); four episodes with their whole '
                       'paths. Set 2, one agent\'s table. The first recorded episodes, seed by seed, in which it '
                       f'arrives; where there are fewer, the first in which it does not. {runs.WIDE}: the same dummies '
                       f'{runs.WIDER:g} times as far apart. {"; ".join(told)}.')


def draw_dummies(line, setting, table, scenario, told):
    """Four episodes side by side, those first in which the agent arrives; returns width and height [m]."""
    chosen = sorted(recorded(setting, table, scenario),
                    key=lambda episode: not all_arrive(setting, table, scenario, *episode))
    pictures = []
    for panel, letter, (seed, instance) in zip(line, 'abcd', chosen):
        folder = runs.folder_of(setting, table, seed)
        pictures.append(draw_scene(panel, folder / f'{scenario}.yaml', folder / f'{scenario}.csv', instance,
                                   PATH_COLOUR, DUMMY_COLOUR))
        arrives = all_arrive(setting, table, scenario, seed, instance)
        panel.set_title(f'({letter}) seed {seed}: ' + ('arrives' if arrives else 'does not arrive'))
        panel.label_outer()
    line[0].set_ylabel(f'{names.PARAMETER_NAMES[table[2]]},\n{scenario}\ny [m]')
    success, contact, collision = (Spread(values).mean for values in zip(*runs.measured(setting, table, scenario)))
    told.append(f'{names.PARAMETER_NAMES[table[2]]}, {scenario}: {success:.0f} % of all arrive, {collision:.0f} % '
                f'collide, {contact:.0f} % touch a dummy')
    return frame_alike(pictures)


def add_dummies_table(chapter, setting):
    rows = [[f'{names.PARAMETER_NAMES[parameters]}, {scenario}',
             *rate_texts(setting, ('agent', 'occupancy', parameters), scenario)]
            for scenario in ('dummies', runs.WIDE) for parameters in runs.PARAMETERS]
    chapter.add_table(f"Dummies, and the same {runs.WIDER:g} times as far apart ({runs.WIDE}); set 2, one agent's "
                      'table; mean ± standard deviation over the seeds (lowest-highest)',
                      ['', 'success %', 'collision %', 'contact %'], rows, name='dummies')


def draw_row(line, setting, table, scenario, episode, moments=None, marked=None):
    """Four moments of an episode, side by side; returns the pictures."""
    seed, instance = episode
    folder = runs.folder_of(setting, table, seed)
    scene = read_scene(folder / f'{scenario}.yaml', instance)
    _, walks = read_walks(folder / f'{scenario}.csv', instance)
    colours = colours_of(len(scene.agents))
    if marked is not None:
        colours = [SURROUNDED_COLOUR if agent == marked else '#7a9cc6' for agent in range(len(colours))]
    last = last_tick_of(walks)
    pictures = []
    for panel, letter, tick in zip(line, 'abcd', moments or [round(moment * last) for moment in MOMENTS]):
        tick = min(max(0, tick), last)
        pictures.append(draw_moment(panel, scene, walks, tick, colours, marked=marked))
        panel.set_title(f'({letter}) {tick * scene.tick:.1f} s, seed {seed}')
    line[0].set_ylabel(f'{names.PARAMETER_NAMES[table[2]]}\ny [m]')
    return pictures


def finish(chapter, setting, figure, axes, pictures, file, caption):
    """Limits alike, and the figure into the chapter."""
    for panel in axes[-1]:
        panel.set_xlabel('x [m]')
    width, height = frame_alike(pictures)
    figure.set_size_inches(13, len(axes) * (0.75 + 3.0 * height / width))
    chapter.add_figure(style.save(figure, setting.figure_file(file)), caption)


def add_moments(chapter, setting, scenario):
    """Four moments of one episode; thesis's parameters above, better ones below."""
    figure, axes = style.new_figure(2, len(MOMENTS), 13, 6.9)
    pictures, told = [], []
    for line, parameters in zip(axes, runs.PARAMETERS):
        table = ('agent', 'occupancy', parameters)
        pictures += draw_row(line, setting, table, scenario, first_success(setting, table, scenario))
        told.append(f'{names.PARAMETER_NAMES[parameters]}: {share_told(setting, table, scenario)}')
    finish(chapter, setting, figure, axes, pictures, f'figure_{NUMBERS[scenario]}_{scenario}',
           f'Figure {NUMBERS[scenario].replace("_", ".")}: {runs.SCENARIOS[scenario]}. Four moments of the first '
           "recorded episode, seed by seed, in which all arrive. Set 2, one agent's table; above the thesis's "
           f'parameters, below better ones. {KEY} {"; ".join(told)}.')


def badness(setting, table, scenario, episode):
    """How an episode went: agents that did not arrive, that collided, that touched another, and the time it took."""
    seed, instance = episode
    episodes = runs.episodes_of(setting, table, seed, scenario)
    return (episodes['agents'] - episodes['arrived'][instance], episodes['collided'][instance],
            episodes['touched'][instance], episodes['ticks'][instance])


def told_of(setting, table, scenario, episode):
    """How an episode went, in words."""
    left, collided, touched, ticks = map(int, badness(setting, table, scenario, episode))
    return (f'{names.PARAMETER_NAMES[table[2]]}: {12 - left} of 12 arrive, {collided} collide, {touched} touch '
            f'another, {ticks} decisions')


def best_of(setting, table, scenario):
    """The best recorded episode of all seeds."""
    return min(recorded(setting, table, scenario), key=lambda episode: badness(setting, table, scenario, episode))


def add_best(chapter, setting):
    """Figure 4.24: best case."""
    scenario = 'circle12'
    figure, axes = style.new_figure(2, len(MOMENTS), 13, 6.9)
    pictures, told = [], []
    for line, parameters in zip(axes, runs.PARAMETERS):
        table = ('agent', 'occupancy', parameters)
        best = best_of(setting, table, scenario)
        pictures += draw_row(line, setting, table, scenario, best)
        told.append(told_of(setting, table, scenario, best))
    finish(chapter, setting, figure, axes, pictures, 'figure_4_24_best',
           'Figure 4.24: best case of twelve on a circle, all at one speed. Of the recorded episodes '
           f'({setting.count(runs.WALKED, 2)} instances, {len(setting.seeds(runs.SEEDS))} seeds) the one in which the '
           'most agents arrive, then the fewest collide, then the fewest touch another, then the shortest one. Set 2, '
           f"one agent's table. {KEY} {'; '.join(told)}.")


def surrounded_agent(setting, table, scenario, episode):
    """Who was surrounded for the most decisions of an episode, and its first such decision; None if nobody was."""
    seed, instance = episode
    decisions = runs.decisions_of(setting, table, seed, scenario)
    caught = (decisions['instance'] == instance) & (decisions['sectors'] >= surroundings.LEAST_SECTORS)
    if not caught.any():
        return None
    agent = int(numpy.argmax(numpy.bincount(decisions['agent'][caught])))
    return agent, int(decisions['tick'][caught & (decisions['agent'] == agent)].min())


def add_worst(chapter, setting):
    """Figure 4.25: worst case."""
    scenario = 'circle12_varied'
    figure, axes = style.new_figure(2, len(MOMENTS), 13, 6.9)
    pictures, told = [], []
    for line, parameters in zip(axes, runs.PARAMETERS):
        table = ('agent', 'occupancy', parameters)

        def harm(episode, table=table):
            left, collided, touched, ticks = badness(setting, table, scenario, episode)
            return touched, left, collided, ticks

        worst = max(recorded(setting, table, scenario), key=harm)
        found = surrounded_agent(setting, table, scenario, worst)
        moments = None if found is None else [found[1] - 40, found[1], found[1] + 20, 2000]
        pictures += draw_row(line, setting, table, scenario, worst, moments, found and found[0])
        told.append(told_of(setting, table, scenario, worst) + (
            ', no agent is surrounded' if found is None else f', agent {found[0]} is surrounded'))
    finish(chapter, setting, figure, axes, pictures, 'figure_4_25_worst',
           'Figure 4.25: worst case of twelve on a circle, at varied speeds. Of the recorded episodes '
           f'({setting.count(runs.WALKED, 2)} instances, {len(setting.seeds(runs.SEEDS))} seeds) the one in which the '
           'most agents touch another, then the fewest arrive, then the most collide, then the longest one. Orange, in '
           f'a black ring: the agent with the most decisions made with {surroundings.LEAST_SECTORS} or 8 of 8 sectors '
           'occupied; (b) is the first of these, (a) is 4 s before it, (c) 2 s after it, (d) the end. Set 2, one '
           f"agent's table. {KEY} {'; '.join(told)}.")
