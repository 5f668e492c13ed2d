"""Contacts with moving obstacles, which do not yield, and whether they were avoidable."""
import math

import numpy
from crowd_drawing.files import read_scene
from crowd_drawing.picture import OBSTACLE_COLOUR, Picture
from crowd_experiments import style
from crowd_experiments.pages import Chapter
from crowd_experiments.records import rates, read_csv, read_tracks
from crowd_experiments.runs import Run

from ..avoidability import HEADINGS, LOOK_BACK, LOOK_ON, Recording, TURNED_WITHIN
from ..metrics_csv import COLOURS, LEARNED, NAMES, OURS

NAME = 'moving_obstacles'
TITLE = 'Moving obstacles that do not yield'
SCENARIO = 'crowd_random_movers'
EPISODES = 20
SEED = 1  # of the placements
DRAWN_PANELS = 6
REACH = 2.2  # [m] drawn distance around a contact
KINDS = ('avoidable', 'hemmed in', 'overrun')


def plan(setting):
    """Returns a run for each model, with the shipped table."""
    return [Run(folder(setting, model), [
        [setting.tool('evaluate'), '--q-table', setting.table(model), '--threads', 1, '--seed', SEED, '--episodes',
         setting.count(EPISODES, 2), '--scenes', '.', '--trajectories', '.', '--record', 'record.csv',
         setting.scenario(SCENARIO)]], cost=3.0) for model in LEARNED]


def folder(setting, model):
    return setting.run_folder(NAME, model)


def kind_of(recording, contact):
    """Returns the kind of a contact, and the last move that would have avoided it."""
    escape = recording.last_escape(contact)
    if escape:
        return 'avoidable', escape
    alone = recording.last_escape(contact, among_others=False)
    return ('hemmed in' if alone else 'overrun'), None


def judged_contacts(run_folder):
    """Returns every contact with its recording, kind and escape."""
    judged = []
    for instance, track in read_tracks(run_folder / f'{SCENARIO}.csv').items():
        recording = Recording(read_scene(run_folder / f'{SCENARIO}.yaml', instance), track)
        judged += [(recording, contact, *kind_of(recording, contact)) for contact in recording.contacts()]
    return judged


def report(setting):
    """Returns the chapter, from the recorded trajectories."""
    chapter = Chapter(NAME, TITLE)
    chapter.add_text(
        'Forty agents walk between random places among eight obstacles that move back and forth at 0.3 to 1.2 m/s, '
        f'in {setting.count(EPISODES, 2)} placements. A contact was avoidable if at a tick within {LOOK_BACK:g} s '
        f'before it a straight move (straight on at one of {HEADINGS} headings, at full or half speed, or standing) '
        f'would have kept the agent clear of all bodies and walls until {LOOK_ON:g} s after it, while all other bodies '
        'move as recorded; this uses hindsight. Hemmed in: avoidable only without the other agents. Overrun: not '
        'avoidable even then. Avoidable until the last tick: avoidable from the position at the end of the previous '
        f'tick. Turned: the obstacle had turned round within the last {TURNED_WITHIN:g} s.')
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
               'avoidable until the last tick', 'turned']
    chapter.add_table('Contacts with moving obstacles', columns, rows, 'contacts')
    add_panels(chapter, setting, contacts[OURS])
    return chapter


def add_panels(chapter, setting, judged):
    """Adds some contacts of the anticipation crowd, the unavoidable ones first."""
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
                       f'Contacts of {NAMES[OURS]} at their first tick, with the paths of the last {LOOK_BACK:g} s. '
                       'Orange: the agent that is touched; grey: moving obstacles; blue: other agents; dashed: the '
                       'last straight move that would have avoided the contact.')


def draw_contact(panel, recording, contact, escape):
    scene, tick = recording.scene, contact.tick
    begin = max(0, tick - round(LOOK_BACK / scene.tick))
    picture = Picture(panel)
    centre = recording.track[tick, contact.agent]
    for obstacle, radius in enumerate(recording.obstacle_radii):
        if not is_near(recording.obstacles[tick, obstacle], centre):
            continue
        path = recording.obstacles[begin:tick + 1, obstacle]
        panel.plot(*path.T, color='0.45', linewidth=1.3)
        picture.disc(path[-1], radius, facecolor=OBSTACLE_COLOUR, edgecolor='0.35')
    for agent, radius in enumerate(recording.radii):
        if not is_near(recording.track[tick, agent], centre):
            continue
        path = recording.track[begin:tick + 1, agent]
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
