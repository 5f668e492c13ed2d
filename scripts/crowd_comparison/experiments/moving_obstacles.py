"""Obstacles that yield to nobody: who is touched, and could anybody have helped it?"""
import math

import numpy

from crowd_drawing.files import read_scene
from crowd_drawing.picture import OBSTACLE_COLOUR, Picture
from crowd_experiments import style
from crowd_experiments.chapter import Chapter
from crowd_experiments.records import rates, read_csv, read_tracks
from crowd_experiments.runs import Run

from ..avoidability import HEADINGS, LOOK_BACK, LOOK_ON, TURNED_WITHIN, Recording
from ..models import COLOURS, LEARNED, NAMES, OURS

NAME = 'moving_obstacles'
TITLE = 'Moving obstacles that yield to nobody'
SCENARIO = 'crowd_random_movers'
EPISODES = 20
SEED = 1  # of the placements
DRAWN_PANELS = 6
REACH = 2.2  # [m] around a contact that is drawn
KINDS = ('avoidable', 'hemmed in', 'overrun')


def plan(setting):
    """A run for each model, with the shipped table."""
    return [Run(folder(setting, model), [
        [setting.tool('evaluate'), '--q-table', setting.table(model), '--threads', 1, '--seed', SEED, '--episodes',
         setting.count(EPISODES, 2), '--scenes', '.', '--trajectories', '.', '--record', 'record.csv',
         setting.scenario(SCENARIO)]], cost=3.0) for model in LEARNED]


def folder(setting, model):
    return setting.run_folder(NAME, model)


def kind_of(recording, contact):
    """Whether a contact could have been avoided, and the last move that would have."""
    escape = recording.last_escape(contact)
    if escape:
        return 'avoidable', escape
    alone = recording.last_escape(contact, among_others=False)
    return ('hemmed in' if alone else 'overrun'), None


def judged_contacts(run_folder):
    """Every contact with its recording, kind and escape."""
    judged = []
    for instance, track in read_tracks(run_folder / f'{SCENARIO}.csv').items():
        recording = Recording(read_scene(run_folder / f'{SCENARIO}.yaml', instance), track)
        judged += [(recording, contact, *kind_of(recording, contact)) for contact in recording.contacts()]
    return judged


def report(setting):
    """The chapter, from the recorded walks."""
    chapter = Chapter(NAME, TITLE)
    chapter.add_text(
        'Forty agents from anywhere to anywhere among eight obstacles that walk to and fro at 0.3 to 1.2 m/s, '
        f'{setting.count(EPISODES, 2)} placements. A contact was avoidable if at any tick within {LOOK_BACK:g} s '
        f'before it a straight move (straight on at one of {HEADINGS} headings, at full or half speed, or standing) '
        f'would have kept the agent clear of everything until {LOOK_ON:g} s after it, all others walking as they did; '
        'judged with hindsight. Hemmed in: only without the other agents. Overrun: not even then. Avoidable to the '
        f'last: still from the place at the end of the tick before. Turned: the obstacle had turned round within '
        f'the last {TURNED_WITHIN:g} s.')
    contacts = {model: judged_contacts(folder(setting, model)) for model in LEARNED}
    rows = []
    for model, judged in contacts.items():
        success, contact, _ = rates(read_csv(folder(setting, model) / 'record.csv'))
        late = sum(escape is not None and escape.tick == touched.tick - 1 for _, touched, _, escape in judged)
        turned = sum(recording.had_turned(touched) for recording, touched, _, _ in judged)
        rows.append([NAMES[model], f'{success:.1f}', f'{contact:.1f}', str(len(judged)),
                     *(str(sum(kind == found for _, _, found, _ in judged)) for kind in KINDS), str(late),
                     str(turned)])
    columns = ['', 'success %', 'agents in contact %', 'contacts with moving obstacles', *KINDS,
               'avoidable to the last', 'turned']
    chapter.add_table('Contacts with moving obstacles', columns, rows, 'contacts')
    add_panels(chapter, setting, contacts[OURS])
    return chapter


def add_panels(chapter, setting, judged):
    """Some contacts of ours, the unavoidable ones first."""
    shown = sorted(judged, key=lambda entry: -KINDS.index(entry[2]))[:DRAWN_PANELS]
    if not shown:
        chapter.add_text(f'{NAMES[OURS].capitalize()}: no contact to show.')
        return
    columns = min(3, len(shown))
    rows = math.ceil(len(shown) / columns)
    figure, axes = style.new_figure(rows, columns, 4.2 * columns, 4.4 * rows)
    for panel in axes.flat[len(shown):]:
        panel.set_visible(False)
    for panel, (recording, contact, kind, escape) in zip(axes.flat, shown):
        draw_contact(panel, recording, contact, escape)
        panel.set_title(f'{kind}, {contact.tick * recording.scene.tick:.1f} s')
    chapter.add_figure(style.save(figure, setting.figure_file('moving_obstacle_contacts')),
                       f'Contacts of {NAMES[OURS]} at the moment they begin, with the ways of the {LOOK_BACK:g} s '
                       'before: orange the agent that is touched, grey the moving obstacles, blue the others; '
                       'dashed: the last '
                       'straight move that would have avoided it.')


def draw_contact(panel, recording, contact, escape):
    scene, tick = recording.scene, contact.tick
    begin = max(0, tick - round(LOOK_BACK / scene.tick))
    picture = Picture(panel)
    centre = recording.track[tick, contact.agent]
    for obstacle, radius in enumerate(recording.obstacle_radii):
        if not is_near(recording.obstacles[tick, obstacle], centre):
            continue
        way = recording.obstacles[begin:tick + 1, obstacle]
        panel.plot(*way.T, color='0.45', linewidth=1.3)
        picture.disc(way[-1], radius, facecolor=OBSTACLE_COLOUR, edgecolor='0.35')
    for agent, radius in enumerate(recording.radii):
        if not is_near(recording.track[tick, agent], centre):
            continue
        way = recording.track[begin:tick + 1, agent]
        colour = COLOURS[OURS] if agent == contact.agent else COLOURS['orca_best']
        panel.plot(*way.T, color=colour, linewidth=1.3, zorder=5)
        picture.disc(way[-1], radius, facecolor=colour, edgecolor='none', alpha=0.8, zorder=6)
    if escape:
        start = recording.track[escape.tick, contact.agent]
        end = start + (tick - escape.tick) * scene.tick * numpy.array(escape.velocity)
        panel.plot(*zip(start, end), color=COLOURS[OURS], linestyle='--', linewidth=1.5, zorder=7)
        picture.disc(end, recording.radii[contact.agent], fill=False, edgecolor=COLOURS[OURS], linestyle='--', zorder=7)
    picture.show(centre, REACH)
    picture.frame()


def is_near(place, centre):
    """Whether it can be seen in a picture around the centre; who has left is nowhere."""
    return bool((numpy.abs(place - centre) < REACH + 1.0).all())
