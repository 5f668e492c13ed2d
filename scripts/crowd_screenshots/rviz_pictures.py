"""Pictures of the panel and of the tools of RViz."""
from .desk import Desk

SCENARIO = 'circle6_obstacle'
CROWD = 'scenario:=' + SCENARIO, 'paused:=true', 'mode:=training', 'epsilon:=0.05'
TICKS = 25  # walked before a picture
# Places on the screen with the window of rviz/social_crowd.rviz [pixels].
DRAW_WALL = 690, 42
ADD_AGENT = 476, 42
WALL = (580, 300), (1050, 270)
AGENT = (520, 660), (1120, 560)


def drag(desk, tool, begin, end, drop):
    """Drags with a tool; without `drop` the button stays down."""
    desk.mouse('mousemove', *tool, 'click', 1)
    desk.mouse('mousemove', *begin, 'mousedown', 1)
    for share in (0.3, 0.6, 1.0):
        desk.mouse('mousemove', *(round(b + share * (e - b)) for b, e in zip(begin, end)))
    if drop:
        desk.mouse('mouseup', 1)


def make(folder):
    """Makes the pictures in a folder. Yields their files."""
    folder.mkdir(parents=True, exist_ok=True)
    with Desk(*CROWD) as desk:
        desk.call('/crowd_controller/step', str(TICKS))
        desk.take(folder / 'rviz_panel.png', seconds=5.0)
        yield folder / 'rviz_panel.png'
        drag(desk, DRAW_WALL, *WALL, drop=True)
        drag(desk, ADD_AGENT, *AGENT, drop=False)
        desk.take(folder / 'rviz_tools.png')
        yield folder / 'rviz_tools.png'
