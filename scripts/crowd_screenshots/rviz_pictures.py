"""Pictures of RViz: panel, tools, the values of an agent's moves, and people."""
import pathlib
import tempfile

import yaml

from .desk import Desk

RVIZ = pathlib.Path(__file__).resolve().parents[2] / 'rviz' / 'social_crowd.rviz'

SMOOTH = 'anti_aliasing:=true'
CROWD = 'scenario:=circle6_obstacle', 'paused:=true', 'mode:=training', 'epsilon:=0.05', SMOOTH
TICKS = 25  # walked before a picture
# Places on the screen with the window of rviz/social_crowd.rviz [pixels].
DRAW_WALL = 690, 42
ADD_AGENT = 476, 42
WALL = (580, 300), (1050, 270)
AGENT = (520, 660), (1120, 560)
# Around the chosen agent; and the floor [pixels: width, height, left, top].
VALUES_CROP = 460, 400, 800, 220
PEOPLE_CROP = 890, 600, 366, 84
# From a corner of the hall of the station, over the gates.
PEOPLE_VIEW = {'Class': 'rviz/Orbit', 'Target Frame': 'map', 'Distance': 16, 'Pitch': 0.5, 'Yaw': 5.0,
               'Focal Point': {'X': 24, 'Y': 15, 'Z': 0.5}}


def drag(desk, tool, begin, end, drop):
    """Drags with a tool; without `drop` the button stays down."""
    desk.mouse('mousemove', *tool, 'click', 1)
    desk.mouse('mousemove', *begin, 'mousedown', 1)
    for share in (0.3, 0.6, 1.0):
        desk.mouse('mousemove', *(round(b + share * (e - b)) for b, e in zip(begin, end)))
    if drop:
        desk.mouse('mouseup', 1)


def panel_and_tools(folder):
    """Takes pictures of a paused crowd, and of what a user draws. Yields their files."""
    with Desk(*CROWD) as desk:
        desk.call('/crowd_controller/step', str(TICKS))
        yield desk.take(folder / 'rviz_panel.png', seconds=5.0)
        drag(desk, DRAW_WALL, *WALL, drop=True)
        drag(desk, ADD_AGENT, *AGENT, drop=False)
        yield desk.take(folder / 'rviz_tools.png')


def values(folder):
    """Takes a picture of the values of an agent's moves. Yields its file."""
    with Desk('scenario:=circle6_obstacle', 'paused:=true', SMOOTH) as desk:
        desk.call('/crowd_controller/step', str(TICKS))
        yield desk.take(folder / 'rviz_values.png', seconds=5.0, crop=VALUES_CROP)


def people(folder):
    """Takes a picture of people in a place. Yields its file."""
    settings = yaml.safe_load(RVIZ.read_text(encoding='utf-8'))
    settings['Visualization Manager']['Views']['Current'] = PEOPLE_VIEW
    for display in settings['Visualization Manager']['Displays']:
        display['Enabled'] = display['Class'] != 'rviz/InteractiveMarkers'
    with tempfile.TemporaryDirectory(prefix='social_crowd_screenshots_') as configurations:
        file = pathlib.Path(configurations) / 'people.rviz'
        file.write_text(yaml.safe_dump(settings, sort_keys=False), encoding='utf-8')
        with Desk('scenario:=place_station', 'paused:=true', f'view:={file.with_suffix("")}', SMOOTH) as desk:
            desk.call('/crowd_markers/choose_agent', 'agent: -1')
            desk.call('/crowd_controller/step', '400')
            yield desk.take(folder / 'rviz_people.png', seconds=5.0, crop=PEOPLE_CROP)


def rviz(folder):
    """Makes all of them in a folder. Yields their files."""
    for pictures in (panel_and_tools, values, people):
        yield from pictures(folder)
