"""Figures 4.1-4.12: which reward teaches an agent better to walk around one obstacle."""
import numpy

from crowd_experiments import style
from crowd_experiments.chapter import Chapter
from crowd_experiments.records import Spread, finite, median, rates, read_csv
from crowd_experiments.runs import Run
from crowd_experiments.scene_figures import draw_scene

from .. import names

NAME = 'reward_evaluation'
TITLE = 'Evaluation of the rewards (figures 4.1-4.12)'
REWARDS = ('distance_gained', 'cosine_cubed')
PARAMETERS = ('thesis', 'better')
MODES = ('training', 'demo')
SEEDS = 20
DEMO_EPISODES = 2000
FREE_EPISODES = 100
DEMO_SEED = 1000  # and the seed of the training: other places than those it was trained at
SPEED = 0.03  # [m per decision]
# What the thesis reports [%].
THESIS_SUCCESS = {('distance_gained', 'training'): 92.25, ('cosine_cubed', 'training'): 99.60,
                  ('distance_gained', 'demo'): 73.80, ('cosine_cubed', 'demo'): 79.10}
# The bar that the better parameters are to pass in demo [%].
LEAST_MEAN_SUCCESS, LEAST_SUCCESS, MOST_CONTACT = 99.0, 97.0, 1.0


def run_name(reward, parameters, seed):
    return f'{reward}_{parameters}_{seed:02d}'


def plan(setting):
    """A run for each reward, set of parameters and seed."""
    runs = []
    for seed in setting.seeds(SEEDS):
        for parameters in PARAMETERS:
            for reward in REWARDS:
                runs.append(make_run(setting, reward, parameters, seed))
    return runs


def make_run(setting, reward, parameters, seed):
    """Trains, then walks with the table just learned, with the obstacle and without."""
    walk = [setting.tool('evaluate'), '--q-table', 'q_table.txt', '--threads', '1', '--seed', DEMO_SEED + seed]
    training_episodes = [] if not setting.quick else ['--episodes', 40]
    return Run(setting.run_folder(NAME, run_name(reward, parameters, seed)), [
        [setting.tool('train'), setting.recipe(f'reward_{reward}_{parameters}'), '--output', 'q_table.txt',
         '--seed', seed, '--record', 'training.csv'] + training_episodes,
        walk + ['--episodes', setting.count(DEMO_EPISODES, 20), '--record', 'demo.csv',
                setting.scenario('single_obstacle')],
        walk + ['--episodes', setting.count(FREE_EPISODES, 10), '--record', 'free.csv',
                setting.scenario('single_free')],
        walk + ['--episodes', 1, '--scenes', '.', '--trajectories', '.', setting.scenario('single_obstacle')],
    ], cost=0.6)


def read(setting, reward, parameters, mode):
    """The records of all seeds."""
    return [read_csv(setting.run_folder(NAME, run_name(reward, parameters, seed)) / f'{mode}.csv')
            for seed in setting.seeds(SEEDS)]


def report(setting):
    """The chapter, from the runs' records."""
    chapter = Chapter(NAME, TITLE)
    records = {(reward, parameters, mode): read(setting, reward, parameters, mode)
               for reward in REWARDS for parameters in PARAMETERS for mode in (*MODES, 'free')}
    chapter.tell(
        'One agent, one obstacle (radius 0.4 m) about half-way to its goal 4 m away, in another direction each '
        'episode; state set 1, 2,000 training episodes of at most 2,000 decisions, then 2,000 demo episodes with the '
        f'table just learned, at other places, and 100 without the obstacle; {len(setting.seeds(SEEDS))} seeds.')
    chapter.tell(
        "The thesis's parameters: step size 0.1, gamma 0.1, lambda 0, not tuned; it leaves open how often the agent "
        'explores (here 10 % of the decisions), how ties are broken (here: the first action), the radius of the '
        'obstacle and the heading at the start (here: towards the goal). Better parameters: gamma 0.9, step size '
        '0.02, exploration that falls from 100 % to 2 % within 1,500 episodes; their training rates hold the '
        'episodes spent on exploring.')
    add_scene(chapter, setting)
    for parameters in PARAMETERS:
        add_scatters(chapter, setting, records, parameters)
    add_shares(chapter, setting, records)
    add_free(chapter, setting, records)
    add_tables(chapter, setting, records)
    return chapter


def add_scene(chapter, setting):
    folder = setting.run_folder(NAME, run_name('cosine_cubed', 'better', 1))
    figure, axes = style.new_figure(1, 1, 5.5, 4.5)
    draw_scene(axes[0][0], folder / 'single_obstacle.yaml', folder / 'single_obstacle.csv', 0,
               names.REWARD_COLOURS['cosine_cubed'])
    chapter.add_figure(style.save(figure, setting.figure_file('reward_scene')),
                       'After figure 4.1: the experiment, with the path of a demo episode (cos³, better parameters). '
                       'Disc: start; circle: end; cross: goal; grey: obstacle.')


def add_scatters(chapter, setting, records, parameters):
    """The two ratios over the episodes of the first seed, both rewards side by side."""
    for measure, label, reference, legend in (
            ('gain_per_tick', 'distance gained per step [m]', SPEED, "the agent's speed"),
            ('path_per_gain', 'path per distance gained [-]', 1.0, 'straight way')):
        figure, axes = style.new_figure(2, 2, 10, 6, sharex=True, sharey=True)
        for row, mode in enumerate(MODES):
            for column, reward in enumerate(REWARDS):
                record = records[reward, parameters, mode][0]
                scatter(axes[row][column], record, measure, reward)
                axes[row][column].axhline(reference, color=style.REFERENCE, linewidth=1, linestyle='--', label=legend)
                axes[row][column].set_title(f'{names.REWARD_NAMES[reward]}, {mode}')
            axes[row][0].set_ylabel(label)
            axes[row][0].legend(loc='best')
        for panel in axes[1]:
            panel.set_xlabel('episode')
        name = f'reward_{measure}_{parameters}'
        figures = '4.2-4.9' if parameters == 'thesis' else '4.2-4.9, repeated'
        chapter.add_figure(style.save(figure, setting.figure_file(name)),
                           f'After figures {figures}: {label} in each episode, {names.PARAMETER_NAMES[parameters]}, '
                           'seed 1; '
                           'filled: the agent arrived; crosses: it did not.' + (
                               ' Episodes in which nothing was gained have no such ratio and are left out.'
                               if measure == 'path_per_gain' else ''))


def scatter(panel, record, measure, reward):
    values, arrived = record[measure], record['arrived'] > 0
    colour = names.REWARD_COLOURS[reward]
    for chosen, look in ((arrived, {'marker': '.', 'markersize': 3, 'alpha': 0.5}),
                         (~arrived, {'marker': 'x', 'markersize': 4})):
        panel.plot(record['episode'][chosen], values[chosen], linestyle='', color=colour, **look)
    if measure == 'path_per_gain':
        panel.set_yscale('log')


def add_shares(chapter, setting, records):
    """Success and contact as shares, of all seeds."""
    figure, axes = style.new_figure(2, 2, 10, 6, sharey='row')
    for column, parameters in enumerate(PARAMETERS):
        for row, (measure, index) in enumerate((('success', 0), ('contact', 1))):
            panel = axes[row][column]
            for place, (mode, reward) in enumerate((mode, reward) for mode in MODES for reward in REWARDS):
                values = [rates(record)[index] for record in records[reward, parameters, mode]]
                draw_share(panel, place, values, names.REWARD_COLOURS[reward])
                if measure == 'success':
                    panel.plot([place], [THESIS_SUCCESS[reward, mode]], **names.THESIS_MARK,
                               label='reported in the thesis' if place == 0 else None)
            labels = [f'{names.REWARD_NAMES[reward]},\n{mode}' for mode in MODES for reward in REWARDS]
            panel.set_xticks(range(4), labels)
            panel.set_title(f'{measure}, {names.PARAMETER_NAMES[parameters]}')
        axes[0][column].set_ylim(0, 105)
    for row, measure in enumerate(('success', 'contact')):
        axes[row][0].set_ylabel(f'{measure} [% of the episodes]')
    axes[1][0].set_ylim(bottom=0)
    axes[0][0].legend(loc='lower left')
    chapter.add_figure(style.save(figure, setting.figure_file('reward_shares')),
                       'After figures 4.2-4.9: share of episodes in which the agent arrived (above), or touched the '
                       'obstacle (below). Bars: mean over the seeds; dots: single seeds; diamonds: the thesis.')


def draw_share(panel, place, values, colour):
    """A bar for the mean, a dot for each seed."""
    panel.bar([place], [numpy.mean(values)], width=0.6, color=colour, alpha=0.45)
    offsets = numpy.linspace(-0.2, 0.2, len(values))
    panel.plot(place + offsets, values, linestyle='', marker='o', markersize=3.5, color=colour, zorder=5)


def add_free(chapter, setting, records):
    """The hundred episodes without the obstacle."""
    figure, axes = style.new_figure(1, 3, 12, 3.8)
    for column, (measure, label) in enumerate((('gain_per_tick', 'distance gained per step [m]'),
                                               ('path_per_gain', 'path per distance gained [-]'))):
        panel = axes[0][column]
        for place, (parameters, reward) in enumerate((p, r) for p in PARAMETERS for r in REWARDS):
            values = [median(record[measure]) for record in records[reward, parameters, 'free']]
            draw_spread(panel, place, values, names.REWARD_COLOURS[reward])
        panel.set_ylabel(label + '\nmedian of 100 episodes')
    axes[0][0].axhline(SPEED, color=style.REFERENCE, linewidth=1, linestyle='--', label="the agent's speed")
    axes[0][1].axhline(1.0, color=style.REFERENCE, linewidth=1, linestyle='--', label='straight way')
    axes[0][1].set_yscale('log')
    for panel in axes[0][:2]:
        panel.legend()
    for place, (parameters, reward) in enumerate((p, r) for p in PARAMETERS for r in REWARDS):
        draw_share(axes[0][2], place, [rates(record)[0] for record in records[reward, parameters, 'free']],
                   names.REWARD_COLOURS[reward])
    axes[0][2].set_ylabel('success [% of the episodes]')
    labels = [f'{names.REWARD_NAMES[reward]},\n{parameters}' for parameters in PARAMETERS for reward in REWARDS]
    for panel in axes[0]:
        panel.set_xticks(range(4), labels, fontsize=8)
    chapter.add_figure(style.save(figure, setting.figure_file('reward_free')),
                       'After figures 4.10-4.12: 100 demo episodes without the obstacle; a dot is a seed, bars are '
                       'means.')


def draw_spread(panel, place, values, colour):
    numbers = finite(numpy.array(values))
    offsets = numpy.linspace(-0.2, 0.2, len(numbers))
    panel.plot(place + offsets, numbers, linestyle='', marker='o', markersize=4, color=colour)


def add_tables(chapter, setting, records):
    rows = []
    for parameters in PARAMETERS:
        for mode in MODES:
            for reward in REWARDS:
                runs = records[reward, parameters, mode]
                success, contact = (Spread(rates(record)[index] for record in runs) for index in (0, 1))
                reported = f'{THESIS_SUCCESS[reward, mode]:.2f}' if parameters == 'thesis' else ''
                rows.append([f'{names.PARAMETER_NAMES[parameters]}, {mode}, {names.REWARD_NAMES[reward]}', reported,
                             success.text(), contact.text(), ratio_text(runs, 'gain_per_tick', 4),
                             ratio_text(runs, 'path_per_gain', 2)])
    for parameters in PARAMETERS:
        for reward in REWARDS:
            runs = records[reward, parameters, 'free']
            rows.append([f'{names.PARAMETER_NAMES[parameters]}, without obstacle, {names.REWARD_NAMES[reward]}', '',
                         Spread(rates(record)[0] for record in runs).text(), '-', ratio_text(runs, 'gain_per_tick', 4),
                         ratio_text(runs, 'path_per_gain', 2)])
    chapter.add_table('The four measures: mean ± standard deviation over the seeds (lowest-highest); of the two ratios '
                      'the median over the episodes, seed by seed',
                      ['', 'thesis: success %', 'success %', 'contact %', 'distance gained per step [m]',
                       'path per distance gained'], rows)
    chapter.tell(verdict(records))


def ratio_text(runs, measure, decimals):
    return Spread.of_numbers(median(record[measure]) for record in runs).text(decimals)


def verdict(records):
    """Whether the better parameters pass the bar."""
    words = []
    for reward in REWARDS:
        success, contact = (Spread(rates(record)[index] for record in records[reward, 'better', 'demo'])
                            for index in (0, 1))
        passed = (success.mean >= LEAST_MEAN_SUCCESS and success.low >= LEAST_SUCCESS and contact.mean <= MOST_CONTACT)
        words.append(f'{names.REWARD_NAMES[reward]}: mean {success.mean:.2f} %, worst seed {success.low:.2f} %, '
                     f'contact {contact.mean:.2f} %, {"passed" if passed else "NOT passed"}')
    return (f'The bar for the better parameters in demo (success at least {LEAST_MEAN_SUCCESS:g} % in the mean, '
            f'at least {LEAST_SUCCESS:g} % for every seed, contact at most {MOST_CONTACT:g} %): {"; ".join(words)}.')
