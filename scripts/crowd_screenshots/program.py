"""The program `screenshots`: RViz on a screen of its own, films of the pages, a report and the page in a browser."""
import os
import pathlib
import shutil
import subprocess
import tempfile
import time

import yaml
from crowd_drawing.errors import read_documents
from crowd_experiments.arguments import add_file, parser_of
from crowd_experiments.runs import RunError, output_of
from crowd_experiments.tools import REPOSITORY, find_tools
from crowd_launching.program import end_all, free_port

from .web_pictures import web

SIZE = '1280x800x24'
PATIENCE = 120.0  # [s]
PERIOD = 0.2  # [s] between two looks
RVIZ = pathlib.Path(__file__).resolve().parents[2] / 'rviz' / 'social_crowd.rviz'
CROWD = 'scenario:=circle6_obstacle', 'paused:=true', 'mode:=training', 'epsilon:=0.05'
TICKS = 25  # walked before a picture
# Places on the screen with the window of rviz/social_crowd.rviz [pixels].
DRAW_WALL, WALL = (690, 42), ((580, 300), (1050, 270))
ADD_AGENT, AGENT = (476, 42), ((520, 660), (1120, 560))
# Around the chosen agent; and the floor [pixels: width, height, left, top].
VALUES_CROP, PEOPLE_CROP = (460, 400, 800, 220), (890, 600, 366, 84)
THESIS_CROP, THESIS_TICKS = (640, 640, 494, 96), 120
# From a corner of the hall of the station, over the gates.
PEOPLE_VIEW = {'Class': 'rviz/Orbit', 'Target Frame': 'map', 'Distance': 16, 'Pitch': 0.5, 'Yaw': 5.0,
               'Focal Point': {'X': 24, 'Y': 15, 'Z': 0.5}}
KINDS_VIEW = {**PEOPLE_VIEW, 'Distance': 8.5, 'Pitch': 0.45, 'Yaw': 4.7,
              'Focal Point': {'X': -0.5, 'Y': -0.5, 'Z': 0.4}}
SCRIPTS, CONFIG = REPOSITORY / 'scripts', REPOSITORY / 'config'
FILMS = {  # as in README.md and the pages that show them
    'film_station': 'place_station --start 28 --duration 36 --speed 3 --fps 15 --view 8 7 44 30',
    'film_museum': 'place_museum --start 20 --duration 27 --speed 3 --fps 12 --size 560',
    'film_two_way_door': 'place_two_way_door --start 10 --duration 27 --speed 3 --fps 12 --size 560',
    'film_robot_door': 'robot_door --duration 27 --speed 3 --fps 12 --size 560',
}
SCENARIOS = 'circle6', 'place_corner'
EPISODES, LEARNED = 20, 300  # of each scenario, of each training
BROWSER = 'chromium'
WINDOW = '1080,2000'  # [pixels]; the first chapters of the report


class Desk:
    """Runs a launch file with RViz on a screen of its own. Use it in a `with` statement."""

    def __init__(self, *arguments, launch='demo.launch'):
        self.command = ['roslaunch', 'social_crowd', launch, *arguments]
        self.folder = tempfile.TemporaryDirectory(prefix='social_crowd_screenshots_')
        self.processes = []

    def __enter__(self):
        try:
            # Without -noreset it starts anew whenever the last client leaves, and refuses clients meanwhile.
            screen = subprocess.Popen(['Xvfb', '-displayfd', '1', '-noreset', '-screen', '0', SIZE],
                                      stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
            self.processes.append(screen)
            display = ':' + screen.stdout.readline().decode().strip()
            self.environment = dict(os.environ, DISPLAY=display, LIBGL_ALWAYS_SOFTWARE='1',
                                    ROS_MASTER_URI=f'http://127.0.0.1:{free_port()}', ROS_HOSTNAME='127.0.0.1',
                                    ROS_HOME=self.folder.name)
            self.log = os.path.join(self.folder.name, 'launch.log')
            with open(self.log, 'wb') as log:
                self.processes.append(subprocess.Popen(self.command, env=self.environment, stdout=log, stderr=log))
            self.wait_for(['xdotool', 'search', '--onlyvisible', '--name', 'RViz'], 'RViz')
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        end_all(self.processes, 30.0)
        self.folder.cleanup()

    def run(self, *command):
        """Runs a command on the screen. Returns its output; None if it failed or hung."""
        try:
            done = subprocess.run(list(map(str, command)), env=self.environment, stdout=subprocess.PIPE,
                                  stderr=subprocess.DEVNULL, check=False, timeout=PATIENCE)
        except subprocess.TimeoutExpired:
            return None
        return done.stdout.decode() if done.returncode == 0 else None

    def wait_for(self, command, what, words=''):
        """Repeats a command until it succeeds and its output contains these words."""
        deadline = time.monotonic() + PATIENCE
        while (output := self.run(*command)) is None or words not in output:
            if self.processes[-1].poll() is not None:
                raise RunError(f'roslaunch ended before {what} was there:\n{self.last_words()}')
            if time.monotonic() > deadline:
                raise RunError(f'timeout of {PATIENCE:g} s while waiting for {what}; roslaunch:\n{self.last_words()}')
            time.sleep(PERIOD)

    def last_words(self):
        """Returns the end of what roslaunch and its nodes have written."""
        return '\n'.join(pathlib.Path(self.log).read_text(encoding='utf-8', errors='replace').splitlines()[-40:])

    def call(self, service, request):
        self.wait_for(['rosservice', 'call', service, request], f'the service {service}', 'success: True')

    def mouse(self, *words):
        """Moves and clicks, with the words of xdotool."""
        if self.run('xdotool', *words) is None:
            raise RunError(f'xdotool failed: {words}')

    def take(self, file, seconds=2.0, crop=None):
        """Waits until RViz has drawn, and takes a picture, or its part (width, height, left, top)."""
        time.sleep(seconds)
        part = ['-crop', '{}x{}+{}+{}'.format(*crop), '+repage'] if crop else []
        fresh = os.path.join(self.folder.name, file.name)
        if self.run('import', '-window', 'root', *part, 'png24:' + fresh) is None:
            raise RunError(f'{file} cannot be written')
        shutil.copyfile(fresh, file)
        return file


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
    with Desk('scenario:=circle6_obstacle', 'paused:=true') as desk:
        desk.call('/crowd_controller/step', str(TICKS))
        yield desk.take(folder / 'rviz_values.png', seconds=5.0, crop=VALUES_CROP)


def thesis(folder):
    """Takes a picture of a crowd with the thesis's second state set. Yields its file."""
    with Desk(launch='thesis.launch') as desk:
        desk.wait_for(['cat', desk.log], 'the end of the training', 'the crowd walks')
        desk.call('/crowd_controller/pause', 'true')
        desk.call('/crowd_controller/reset', '{keep_seed: true}')
        desk.call('/crowd_controller/step', str(THESIS_TICKS))
        yield desk.take(folder / 'rviz_thesis.png', seconds=5.0, crop=THESIS_CROP)


def floor(file, scenario, view, ticks):
    """Takes a picture of the people of a scenario after some ticks, from a place over the floor. Returns its file."""
    settings, = read_documents(RVIZ)
    settings['Visualization Manager']['Views']['Current'] = view
    for display in settings['Visualization Manager']['Displays']:
        display['Enabled'] = display['Class'] != 'rviz/InteractiveMarkers'
    with tempfile.TemporaryDirectory(prefix='social_crowd_screenshots_') as configurations:
        configuration = pathlib.Path(configurations) / 'people.rviz'
        configuration.write_text(yaml.safe_dump(settings, sort_keys=False), encoding='utf-8')
        with Desk(f'scenario:={scenario}', 'paused:=true', f'view:={configuration.with_suffix("")}') as desk:
            desk.call('/crowd_markers/choose_agent', 'agent: -1')
            desk.call('/crowd_controller/step', str(ticks))
            return desk.take(file, seconds=5.0, crop=PEOPLE_CROP)


def people(folder):
    """Takes pictures of people in a place, and of people of several kinds. Yields their files."""
    yield floor(folder / 'rviz_people.png', 'place_station', PEOPLE_VIEW, 400)
    yield floor(folder / 'rviz_kinds.png', 'kinds_hall', KINDS_VIEW, 90)


def rviz(folder):
    """Makes all of them in a folder. Yields their files."""
    for pictures in (panel_and_tools, values, thesis, people):
        yield from pictures(folder)


def films(folder):
    """Makes the films. Yields their files."""
    for name, words in FILMS.items():
        file = folder / f'{name}.gif'
        output_of([SCRIPTS / 'film', *words.split(), '--output', file])
        yield file


def write_report(folder):
    """Walks and trains crowds, and writes a report about them. Returns its file."""
    tools = pathlib.Path(find_tools(None))
    files = []
    for table in ('anticipation', 'human'):
        os.makedirs(folder / table)
        output_of([tools / 'evaluate', '--q-table', CONFIG / 'q_tables' / f'{table}.txt', '--episodes', EPISODES,
                   '--trajectories', table, '--csv', f'{table}/metrics.csv', '--record', f'{table}/record.csv',
                   *SCENARIOS], cwd=folder)
        files += [f'{table}/{name}.csv' for name in ('metrics', 'record', *SCENARIOS)]
    for seed in (1, 2, 3):
        output_of([tools / 'train', CONFIG / 'learning' / 'anticipation.yaml', '--output', 'table.txt', '--episodes',
                   LEARNED, '--seed', seed, '--log', f'log_{seed}.csv'], cwd=folder)
        files.append(f'anticipation=log_{seed}.csv')
    output_of([SCRIPTS / 'report', *files, '--output', 'report.html'], cwd=folder)
    return folder / 'report.html'


def report(folder):
    """Takes a picture of a report in a browser, if there is one. Yields its file."""
    if shutil.which(BROWSER) is None:
        raise RunError(f'report.png needs the program {BROWSER}')
    file = folder / 'report.png'
    with tempfile.TemporaryDirectory(prefix='social_crowd_screenshots_') as work:
        page = write_report(pathlib.Path(work))
        output_of([BROWSER, '--headless', '--no-sandbox', '--disable-gpu', '--hide-scrollbars',
                   f'--window-size={WINDOW}', f'--screenshot={file.resolve()}', page.as_uri()])
    yield file


KINDS = {'rviz': rviz, 'film': films, 'report': report, 'web': web}
DESCRIPTION = '''Makes pictures in docs/images: of RViz (the panel, the tools that draw on the floor, the values of
an agent's moves, the crowd of the thesis, and walking people), the films of the pages, a report, and the page in a
browser.

Runs demo.launch and thesis.launch on a separate screen, so that no display is needed. The pictures of the report and of
the page need chromium, the latter npm too.'''
EXAMPLES = '''examples:
  scripts/screenshots --output /tmp
  scripts/screenshots rviz film'''


def main(words=None):
    parser = parser_of('screenshots', DESCRIPTION, EXAMPLES)
    parser.add_argument('kinds', nargs='*', metavar='KIND', choices=[*KINDS, []],
                        help=f"{', '.join(KINDS)} (default: all)")
    add_file(parser, '--output', default=REPOSITORY / 'docs' / 'images', metavar='FOLDER',
             help='folder of the pictures (default: docs/images)')
    arguments = parser.parse_args(words)
    arguments.output.mkdir(parents=True, exist_ok=True)
    for kind in arguments.kinds or KINDS:
        for file in KINDS[kind](arguments.output):
            print(file, flush=True)
