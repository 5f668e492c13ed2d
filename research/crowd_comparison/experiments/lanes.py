"""Lane formation of two crowds in a corridor."""
import numpy
from crowd_drawing.files import read_scene, read_walks
from crowd_experiments import style
from crowd_experiments.pages import Chapter
from crowd_experiments.records import Spread, rates, read_csv, read_tracks
from crowd_experiments.runs import Run
from crowd_studies.scene_figures import draw_moment

from ..lane_order import HALF_WIDTH, STRETCH, order_over_time
from ..metrics_csv import COLOURS, LEARNED, NAMES

NAME = 'lanes'
TITLE = 'Lanes in a two-way corridor'
SCENARIO = 'corridor_two_way'
EPISODES = 10
PLACEMENT_SEED = 1
TICK = 0.1  # [s]
SHOWN_TIME = 25.0  # [s]
JUDGED = (8.0, 18.0)  # [s] time in which the crowds overlap
MOMENTS = (1.0, 14.0)  # [s]
DRAWN = ('anticipation', 'thesis_nearest')
DIRECTION_COLOURS = {1: '#d55e00', -1: '#0072b2'}


def plan(setting):
    """Returns a run for each model, with the shipped table."""
    return [Run(folder(setting, model), [
        [setting.tool('evaluate'), '--q-table', setting.table(model), '--threads', 1, '--seed', PLACEMENT_SEED,
         '--episodes', setting.count(EPISODES, 2), '--scenes', '.', '--trajectories', '.', '--record', 'record.csv',
         setting.scenario(SCENARIO)]], cost=6.0) for model in LEARNED]


def folder(setting, model):
    return setting.run_folder(NAME, model)


def report(setting):
    """Returns the chapter, from the recorded trajectories."""
    curves = {model: curves_of(folder(setting, model)) for model in LEARNED}
    chapter = Chapter(NAME, TITLE)
    chapter.add_text(
        f'Two crowds of forty in a corridor 4 m wide walk through each other, {len(curves[LEARNED[0]])} placements. '
        'Order: mean over agents of ((same direction - opposite direction) / (same + opposite))^2 among the other '
        f'agents in a lane {2 * HALF_WIDTH:g} m wide around the agent, within {STRETCH:g} m of the middle (Rex and '
        'Löwen 2007, Nowak and Schadschneider 2012), less the value expected by chance: 0 is chance, 1 is perfect '
        'lanes.')
    add_curves(chapter, setting, curves)
    add_moments(chapter, setting)
    add_table(chapter, setting, curves)
    return chapter


def curves_of(run_folder):
    """Returns an array (placement, tick) of the order, nan after the last agent has left."""
    curves = [order_over_time(track, starting_directions(track)) for track in
              read_tracks(run_folder / f'{SCENARIO}.csv').values()]
    ticks = round(SHOWN_TIME / TICK) + 1
    padded = numpy.full((len(curves), ticks), numpy.nan)
    for row, curve in zip(padded, curves):
        row[:min(ticks, len(curve))] = curve[:ticks]
    return padded


def starting_directions(track):
    """Returns 1 for agents that start on the left and walk to the right, -1 for the others."""
    return numpy.where(track[0, :, 0] < 0.0, 1, -1)


def add_curves(chapter, setting, curves):
    figure, axes = style.new_figure(1, 1, 9, 4)
    panel = axes[0][0]
    for model, values in curves.items():
        present = ~numpy.isnan(values).any(axis=0)
        time = TICK * numpy.arange(values.shape[1])[present]
        mean, deviation = values[:, present].mean(axis=0), values[:, present].std(axis=0)
        panel.plot(time, mean, color=COLOURS[model], label=NAMES[model])
        panel.fill_between(time, mean - deviation, mean + deviation, color=COLOURS[model], alpha=0.2, linewidth=0)
    panel.axhline(0.0, color=style.REFERENCE, linewidth=1, linestyle='--', label='chance')
    panel.set_xlim(0.0, SHOWN_TIME)
    panel.set_ylim(-0.1, 1.0)
    panel.set_xlabel('time [s]')
    panel.set_ylabel('order above chance')
    panel.legend(loc='upper left')
    chapter.add_figure(style.save(figure, setting.figure_file('lane_order')),
                       'Lane order over time: mean and standard deviation over the placements, while all of them have '
                       'agents of both directions.')


def add_moments(chapter, setting):
    """Adds an early and a late moment of the first placement, coloured by direction."""
    figure, axes = style.new_figure(len(DRAWN), len(MOMENTS), 7.0 * len(MOMENTS), 2.1 * len(DRAWN), sharex=True,
                                    sharey=True)
    for model, row in zip(DRAWN, axes):
        run_folder = folder(setting, model)
        scene = read_scene(run_folder / f'{SCENARIO}.yaml', 0)
        _, walks = read_walks(run_folder / f'{SCENARIO}.csv', 0)
        colours = [DIRECTION_COLOURS[1 if walks[agent][0][1] < 0.0 else -1] for agent in range(len(scene.agents))]
        for panel, moment in zip(row, MOMENTS):
            draw_moment(panel, scene, walks, round(moment / scene.tick), colours, with_paths=False).frame()
            panel.set_xlim(-11.0, 11.0)
            panel.set_ylim(-2.6, 2.6)
            panel.set_title(f'{NAMES[model]}, {moment:g} s')
    chapter.add_figure(style.save(figure, setting.figure_file('corridor')),
                       'The middle of the corridor in the first placement; colours: agents that walk to the right, and '
                       'to the left.')


def add_table(chapter, setting, curves):
    begin, end = (round(moment / TICK) for moment in JUDGED)
    rows = []
    for model, values in curves.items():
        judged = Spread.of_numbers(numpy.nanmean(values[:, begin:end], axis=1))
        success, contact, _ = rates(read_csv(folder(setting, model) / 'record.csv'))
        rows.append([NAMES[model], judged.text(2), f'{success:.1f}', f'{contact:.1f}'])
    chapter.add_table(f'Order above chance from {JUDGED[0]:g} to {JUDGED[1]:g} s: mean ± standard deviation over the '
                      'placements (lowest-highest)', ['', 'order', 'success %', 'contact %'], rows, 'order')
