"""Contacts with moving obstacles, which do not yield, and whether they were avoidable."""
import math

import numpy
from crowd_drawing.files import read_scene
from crowd_drawing.picture import OBSTACLE_COLOUR, Picture
from crowd_experiments import style
from crowd_experiments.records import read_tracks
from crowd_studies.program import Report

from ..avoidability import HEADINGS, LOOK_BACK, LOOK_ON, Recording, TURNED_WITHIN
from ..models import COLOURS, LEARNED, NAMES, OURS, TEXTS, success_and_contact, walked

NAME = 'moving_obstacles'
SCENARIO = 'crowd_random_movers'
DRAWN_PANELS = 6
REACH = 2.2  # [m] drawn distance around a contact
KINDS = ('avoidable', 'hemmed in', 'overrun')


def plan(setting):
    """Returns a run for each model, with the shipped table."""
    return [walked(setting, NAME, model, SCENARIO, setting.count(20, 2), 3.0) for model in LEARNED]


def kind_of(recording, contact):
    """Returns the kind of a contact, and the last move that would have avoided it."""
    escape = recording.last_escape(contact)
    if escape:
        return 'avoidable', escape
    return ('hemmed in' if recording.last_escape(contact, among_others=False) else 'overrun'), None


def report(setting):
    chapter = Report(NAME, TEXTS, setting, look_back=LOOK_BACK)
    chapter.say('intro', headings=HEADINGS, look_on=LOOK_ON, turned=TURNED_WITHIN)
    contacts = {model: [] for model in LEARNED}  # with their recordings, kinds and escapes
    for model, judged in contacts.items():
        folder = setting.run_folder(NAME, model)
        for instance, track in read_tracks(folder / f'{SCENARIO}.csv').items():
            recording = Recording(read_scene(folder / f'{SCENARIO}.yaml', instance), track)
            judged += [(recording, contact, *kind_of(recording, contact)) for contact in recording.contacts()]
    columns = ['', 'success %', 'agents in contact %', 'contacts with moving obstacles', *KINDS,
               'avoidable until the last tick', 'turned']
    chapter.tabulate('contacts', columns, [row_of(setting, model, judged) for model, judged in contacts.items()])
    add_panels(chapter, contacts[OURS])
    return chapter


def row_of(setting, model, judged):
    late = sum(escape is not None and escape.tick == contact.tick - 1 for _, contact, _, escape in judged)
    turned = sum(recording.had_turned(contact) for recording, contact, _, _ in judged)
    numbers = [len(judged), *(sum(kind == found for _, _, found, _ in judged) for kind in KINDS), late, turned]
    return [NAMES[model], *success_and_contact(setting.run_folder(NAME, model)), *map(str, numbers)]


def add_panels(chapter, judged):
    """Adds some contacts of the anticipation crowd, the unavoidable ones first."""
    shown = sorted(judged, key=lambda entry: -KINDS.index(entry[2]))[:DRAWN_PANELS]
    if not shown:
        chapter.say('none')
        return
    columns = min(3, len(shown))
    rows = math.ceil(len(shown) / columns)
    figure, axes = style.new_figure(rows, columns, 4.2 * columns, 4.4 * rows)
    for panel in axes.flat[len(shown):]:
        panel.set_visible(False)
    for panel, (recording, contact, kind, escape) in zip(axes.flat, shown):
        draw_contact(panel, recording, contact, escape)
        panel.set_title(f'{kind}, {contact.tick * recording.scene.tick:.1f} s')
    chapter.draw(figure, 'moving_obstacle_contacts')


def draw_contact(panel, recording, contact, escape):
    """Draws what is near a contact at its first tick, with paths, and the last escape."""
    scene, tick = recording.scene, contact.tick
    ticks = slice(max(0, tick - round(LOOK_BACK / scene.tick)), tick + 1)
    picture = Picture(panel)
    centre = recording.track[tick, contact.agent]
    for obstacle, radius in enumerate(recording.obstacle_radii):
        path = recording.obstacles[ticks, obstacle]
        if is_near(path[-1], centre):
            panel.plot(*path.T, color='0.45', linewidth=1.3)
            picture.disc(path[-1], radius, facecolor=OBSTACLE_COLOUR, edgecolor='0.35')
    for agent, radius in enumerate(recording.radii):
        path = recording.track[ticks, agent]
        if is_near(path[-1], centre):
            colour = COLOURS[OURS] if agent == contact.agent else COLOURS['orca_best']
            panel.plot(*path.T, color=colour, linewidth=1.3, zorder=5)
            picture.disc(path[-1], radius, facecolor=colour, edgecolor='none', alpha=0.8, zorder=6)
    if escape:
        start = recording.track[escape.tick, contact.agent]
        end = start + (tick - escape.tick) * scene.tick * numpy.array(escape.velocity)
        panel.plot(*zip(start, end), color=COLOURS[OURS], linestyle='--', linewidth=1.5, zorder=7)
        picture.disc(end, recording.radii[contact.agent], fill=False, edgecolor=COLOURS[OURS], linestyle='--', zorder=7)
    picture.show(centre, REACH)
    picture.frame()


def is_near(place, centre):
    """Returns whether a place is within or near the picture around the centre; False for agents that have left."""
    return bool((numpy.abs(place - centre) < REACH + 1.0).all())
