"""Lane formation of two crowds in a corridor.

The order parameter is that of M. Rex and H. Löwen, Lane formation in oppositely charged colloids driven by an electric
field, Phys. Rev. E 75, 051402 (2007), applied to pedestrians by S. Nowak and A. Schadschneider (Quantitative
analysis of pedestrian counterflow in a cellular automaton model, Phys. Rev. E 85, 066128, 2012):

    phi = mean over walkers of ((same - opposite) / (same + opposite))^2

over the other walkers in a lane around the walker. Nowak and Schadschneider also subtract the value expected by chance:
with n others in random directions, the mean of the square is 1 / n.
"""
import numpy
import pandas
from crowd_drawing.files import read_scene, read_walks
from crowd_experiments import style
from crowd_experiments.records import Spread, read_tracks
from crowd_studies.program import Report
from crowd_studies.scene_figures import draw_moment

from ..models import COLOURS, LEARNED, NAMES, TEXTS, success_and_contact, walked

NAME = 'lanes'
SCENARIO = 'corridor_two_way'
TICK, SHOWN_TIME = 0.1, 25.0  # [s]
JUDGED = (8.0, 18.0)  # [s] time in which the crowds overlap
MOMENTS = (1.0, 14.0)  # [s]
DRAWN = ('anticipation', 'thesis_nearest')
DIRECTION_COLOURS = {1: '#d55e00', -1: '#0072b2'}
STRETCH = 5.0  # [m] distance from the middle of the corridor within which walkers count
LEAST_WALKERS = 4  # minimum number of walkers of each direction in the stretch; with fewer, the order is nan
HALF_WIDTH = 0.3  # [m] half of the width of a lane, which is centred on the walker


def plan(setting):
    """Returns a run for each model, with the shipped table."""
    return [walked(setting, NAME, model, SCENARIO, setting.count(10, 2), 6.0) for model in LEARNED]


def lane_order(places, directions):
    """Returns the order parameter and its value expected by chance; nan if all walkers are alone in their lanes.
    @param places (n, 2) along and across the corridor [m]; nan: not present
    @param directions (n) 1 or -1"""
    here = numpy.abs(places[:, 0]) <= STRETCH  # false for nan
    aside = places[here, 1]
    direction = numpy.asarray(directions)[here]
    in_lane = numpy.abs(aside[:, None] - aside[None]) <= HALF_WIDTH
    numpy.fill_diagonal(in_lane, False)
    company = in_lane.sum(axis=1)
    balance = (in_lane * direction[None]).sum(axis=1)[company > 0]  # surplus of one direction; the sign is irrelevant
    company = company[company > 0]
    if len(company) == 0:
        return float('nan'), float('nan')
    return float(numpy.mean((balance / company) ** 2)), float(numpy.mean(1.0 / company))


def order_above_chance(places, directions):
    """Returns the order above chance: 0 is chance, 1 is perfect lanes."""
    order, chance = lane_order(places, directions)
    return (order - chance) / (1.0 - chance) if chance < 1.0 else float('nan')


def order_over_time(track, directions):
    """Returns the order above chance at every tick of a track; nan with fewer than LEAST_WALKERS in one direction."""
    here = numpy.abs(track[:, :, 0]) <= STRETCH
    counts = [here[:, numpy.equal(directions, direction)].sum(axis=1) for direction in (1, -1)]
    enough = numpy.minimum(*counts) >= LEAST_WALKERS
    return numpy.array([order_above_chance(places, directions) if is_enough else float('nan')
                        for places, is_enough in zip(track, enough)])


def report(setting):
    folders = {model: setting.run_folder(NAME, model) for model in LEARNED}
    curves = {model: curves_of(folder) for model, folder in folders.items()}
    chapter = Report(NAME, TEXTS, setting)
    chapter.say('intro', width=2 * HALF_WIDTH, stretch=STRETCH)
    add_curves(chapter, curves)
    add_moments(chapter, folders)
    begin, end = (round(moment / TICK) for moment in JUDGED)
    chapter.tabulate('order', ['', 'order', 'success %', 'contact %'], [
        [NAMES[model], Spread.of_numbers(numpy.nanmean(curves[model][:, begin:end], axis=1)).text(2),
         *success_and_contact(folder)] for model, folder in folders.items()], begin=JUDGED[0], end=JUDGED[1])
    return chapter


def curves_of(folder):
    """Returns an array (placement, tick) of the order; agents that start on the left walk to the right."""
    curves = [order_over_time(track, numpy.where(track[0, :, 0] < 0.0, 1, -1)) for track in
              read_tracks(folder / f'{SCENARIO}.csv').values()]
    ticks = range(round(SHOWN_TIME / TICK) + 1)
    return pandas.DataFrame(curves).reindex(columns=ticks).to_numpy()


def add_curves(chapter, curves):
    figure, ((panel,),) = style.new_figure(1, 1, 9, 4)
    for model, values in curves.items():
        present = ~numpy.isnan(values).any(axis=0)
        time = TICK * numpy.arange(values.shape[1])[present]
        mean, deviation = values[:, present].mean(axis=0), values[:, present].std(axis=0)
        panel.plot(time, mean, color=COLOURS[model], label=NAMES[model])
        panel.fill_between(time, mean - deviation, mean + deviation, color=COLOURS[model], alpha=0.2, linewidth=0)
    panel.axhline(0.0, color=style.REFERENCE, linewidth=1, linestyle='--', label='chance')
    panel.set(xlim=(0.0, SHOWN_TIME), ylim=(-0.1, 1.0), xlabel='time [s]', ylabel='order above chance')
    panel.legend(loc='upper left')
    chapter.draw(figure, 'lane_order')


def add_moments(chapter, folders):
    """Adds an early and a late moment of the first placement, coloured by direction."""
    figure, axes = style.new_figure(len(DRAWN), len(MOMENTS), 7.0 * len(MOMENTS), 2.1 * len(DRAWN), sharex=True,
                                    sharey=True)
    for model, row in zip(DRAWN, axes):
        scene = read_scene(folders[model] / f'{SCENARIO}.yaml', 0)
        _, walks = read_walks(folders[model] / f'{SCENARIO}.csv', 0)
        colours = [DIRECTION_COLOURS[1 if walks[agent][0][1] < 0.0 else -1] for agent in range(len(scene.agents))]
        for panel, moment in zip(row, MOMENTS):
            draw_moment(panel, scene, walks, round(moment / scene.tick), colours, with_paths=False).frame()
            panel.set(xlim=(-11.0, 11.0), ylim=(-2.6, 2.6), title=f'{NAMES[model]}, {moment:g} s')
    chapter.draw(figure, 'corridor')
