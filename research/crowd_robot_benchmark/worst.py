"""The worst episodes of each robot, and their films, for the page of the benchmark."""
import json
import pathlib
import tempfile

from crowd_experiments.pages import Chapter
from crowd_experiments.runs import output_of
from crowd_film.program import Settings, make
from crowd_recordings.formats import read_shown

from .measures import CONTACTS
from .suite import ROBOTS

SHOWN = 5  # worst episodes of a robot
HEADER = ['scene', 'episode', 'contacts', 'arrived', 'time [s]', 'personal space [s]', 'hash']
SIZE, FPS, SPEED = 480, 12.5, 3.0  # of films: pixels, frames in a second, simulated seconds in a second
LOG = 'log.jsonl'


def badness(values):
    """Returns what episodes are ordered by: contacts, then failures, then the time near people."""
    return int(values[CONTACTS]), values['success'] != '1', float(values['personal_space_time'])


def worst_rows(columns, rows):
    """Returns (Row, its values by column) of the worst episodes, at most one of a scene, the worst first."""
    ordered = sorted(((row, dict(zip(columns, row.values))) for row in rows), key=lambda found: badness(found[1]),
                     reverse=True)
    chosen = {}
    for row, values in ordered:
        chosen.setdefault(row.identity.scenario, (row, values))
    return list(chosen.values())[:SHOWN]


def cells_of(row, values):
    arrived = values['success'] == '1'
    time = f"{float(values['time_to_reach_goal']):.1f}" if arrived else '-'
    return [row.identity.scenario, row.identity.episode, values[CONTACTS], 'yes' if arrived else 'no', time,
            f"{float(values['personal_space_time']):.1f}", row.identity.hash]


def worst_chapter(suite, columns, rows, films, folder):
    """Returns the chapter of the worst episodes, with `films` films of each robot, which are made in a folder. Episodes
    of robots that people do not perceive are left out."""
    chapter = Chapter('worst', 'Worst episodes')
    chapter.add_text('By contacts, then failures, then the time in which a person was nearer than 1.2 m; one '
                     'episode of a scene at most.')
    rows = [row for row in rows if json.loads(row.identity.keys) == ROBOTS[row.identity.baseline].keys]
    for robot in dict.fromkeys(row.identity.baseline for row in rows):
        worst = worst_rows(columns, [row for row in rows if row.identity.baseline == robot])
        chapter.add_table(robot, HEADER, [cells_of(*found) for found in worst])
        for row, _ in worst[:films]:
            identity = row.identity
            file = folder / f'{robot}_{identity.scenario}_{identity.episode}.webp'
            make_film(suite, row, file)
            chapter.add_figure(file, f'{robot} in {identity.scenario}, episode {identity.episode}, at {SPEED:g} times '
                                     'real time')
    return chapter


def make_film(suite, row, file):
    """Walks the episode of a row again, and makes its film."""
    identity = row.identity
    with tempfile.TemporaryDirectory(prefix='social_crowd_') as name:
        folder = pathlib.Path(name)
        command = suite.command(identity.controller, json.loads(identity.keys), identity.scenario, 1,
                                int(identity.episode), int(identity.seed))
        command.remove('--people-delay')  # the film ends when the robot has arrived
        output_of([*command, '--scenes', folder, '--robot-log', LOG], cwd=folder)
        scene, tracks, _ = read_shown(folder / LOG, folder / f'{identity.scenario}.yaml')
        title = f'{identity.baseline}: {identity.scenario}, episode {identity.episode}'
        make(Settings(file, title, speed=SPEED, fps=FPS, size=SIZE), scene, tracks)
