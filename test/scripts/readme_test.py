"""Every command line of README.md and docs/demos.md is run as printed, in a folder like a clone.

Substitutions: /tmp/ is the folder of the test; roslaunch gets rviz:=false, but for two lines, which open RViz on a
separate screen. Launches without an end are interrupted when their crowd walks.
"""
import concurrent.futures
import csv
import os
import re

import pytest
from crowd_experiments.tools import BUILT
from page_commands import command_lines, other_blocks
from programs import assert_says, in_package, read_text, tools_folder, wait_for
from readme_files import MY_SCENARIO, PEDSIM_SCENE, obsmat, write_bag
from renderer import RESTARTED
from screen import Screen
from terminal import Terminal

README = read_text(in_package('README.md')) + read_text(in_package('docs', 'demos.md'))
DEMO = 'roslaunch social_crowd demo.launch'
# Each walks until it is interrupted.
WALKING = [
    DEMO + ' scenario:=circle12_varied real_time_factor:=4',
    DEMO + ' scenario:=line6_mover learners:=per_agent',
    DEMO + ' scenario:=$PWD/my.yaml mode:=training tables:=own save_to:=$PWD/my.txt',
    'roslaunch social_crowd thesis.launch',
    'roslaunch social_crowd thesis.launch state_set:=1 scenario:=line6_mover learning:=true training:=watched '
    'training_episodes:=100',
    DEMO + ' q_table:=$(rospack find social_crowd)/config/q_tables/thesis_occupancy.txt',
    DEMO + ' scenario:=crowd_random_1000 nodelets:=true',
    'roslaunch social_crowd robot_lab.launch',
    'roslaunch social_crowd replay.launch bag:=$PWD/walk.bag',
    'roslaunch social_crowd replay.launch trajectories:=$PWD/obsmat.txt',
    *(f'{DEMO} scenario:=place_{name}' for name in ('station', 'office', 'supermarket', 'bottleneck', 'two_way_door',
                                                    'corner', 't_junction', 'museum')),
]
IN_RVIZ = [DEMO, 'roslaunch social_crowd train.launch output:=/tmp/table.txt rviz:=true real_time_factor:=20']
MOVE_BASE = 'roslaunch social_crowd robot_lab.launch navigation:=move_base scenario:=office_courier'
FILM = 'scripts/film place_station --start 28 --duration 36 --speed 3 --fps 15 --view 8 7 44 30 --output station.gif'
LEARNING = [
    'rosrun social_crowd train config/learning/anticipation.yaml --output table.txt --seed 7',
    'rosrun social_crowd evaluate --q-table table.txt --episodes 100 --trajectories recordings circle6',
    'rosrun social_crowd plot_paths --trajectories recordings/circle6.csv --scenario circle6 --output paths.png',
]
SERVICES = [
    'rosservice call /crowd_controller/pause true',
    'rosservice call /crowd_controller/step 10',
    'rosservice call /crowd_controller/load_scenario circle12',
    'rosservice call /crowd_controller/set_goal "{agent: 0, goal: {x: 2.0, y: -1.0}}"',
    'rosservice call /learner/set_mode training',
    'rosservice call /learner/save_q_table "{file: table.txt}"',
    'rosservice call /learner/share_q_table "{from_agent: 0}"',
]
ROBOT = [DEMO + ' scenario:=robot_hall',
         "rostopic pub -r 10 /cmd_vel geometry_msgs/Twist '{linear: {x: 0.5}, angular: {z: 0.2}}'"]
STEPPED = 'real_time_factor:=fast paused:=true rviz:=false'
ARGUMENTS = 'roslaunch --ros-args social_crowd demo.launch'
IMPORT = 'rosrun social_crowd pedsim_import FILE.xml --output SCENARIO.yaml'
NOT_RUN = {
    'scripts/build': 'has built what is tested',
    'source .build/devel/setup.bash': 'was done before the tests',
    'catkin_make': 'builds a workspace',
    'scripts/package': 'builds everything once more',
    'scripts/test': 'runs this test',
    'scripts/web build': 'downloads sources',
    'roslaunch social_crowd web.launch': 'has a fixed port; web_ros_test',
    'rosrun social_crowd web_server place_office': 'the same; web_server_test',
    'rosrun social_crowd drive_robots --config FOLDER --robots-csv mine.csv': 'needs move_base; robot_benchmark_test',
    'scripts/demo': 'builds, which would change the programs under test',
    'scripts/demo scenario:=circle12 real_time_factor:=4': 'the same',
}
KNOWN = [*WALKING, *IN_RVIZ, MOVE_BASE, FILM, *LEARNING, *SERVICES, *ROBOT, ARGUMENTS, IMPORT, *NOT_RUN]


@pytest.fixture(name='screen', scope='module')
def make_screen():
    """A separate screen."""
    screen = Screen()
    yield screen
    screen.close()


@pytest.fixture(name='terminal')
def make_terminal(runner):
    """A terminal in a folder of the test. Scripts use the programs under test."""
    build = tools_folder().partition('/devel/')[0]
    built = {'SOCIAL_CROWD_BUILD': build} if os.path.exists(os.path.join(build, BUILT)) else {}
    return Terminal(runner, runner.path('clone'), built)


def printed(line, terminal):
    """Returns a line with the folder of a terminal in place of /tmp."""
    return line.replace('/tmp/', terminal.folder + '/')


class ReadmeTest:
    """README.md and docs/demos.md."""

    def test_all_lines_are_tested(self):
        lines = command_lines(README)
        assert [line for line in lines if line not in KNOWN] == [], 'lines of the pages that this test does not run'
        assert [line for line in KNOWN if line not in lines] == [], 'lines that are no longer in the pages'
        assert [block.split()[0] for block in other_blocks(README)] == ['import', 'robots:', 'import']

    def test_lines_that_are_not_run(self):
        """Their scripts are there, and know the options."""
        launch = read_text(in_package('launch', 'demo.launch'))
        for line in NOT_RUN:
            script, *words = line.split()
            if not script.startswith(('scripts/', 'research/')):
                continue
            assert os.access(in_package(script), os.X_OK), line
            for word in words:
                if ':=' in word:
                    assert_says(launch, f'<arg name="{word.partition(":=")[0]}"')

    def test_films(self, terminal):
        assert_says(terminal.run(FILM), 'station.gif: 172 frames')
        assert 0 < os.path.getsize(terminal.path('station.gif')) < 3e6

    def test_learning(self, terminal):
        """The table says what the README says of it."""
        terminal.run(LEARNING[0])
        header, row = (line.split() for line in terminal.run(LEARNING[1]).splitlines()[-2:])
        shown = dict(zip(header, row))
        assert [shown[name] for name in ('success%', 'contact%', 'collision%')] == ['100.00', '0.00', '100.00']
        terminal.run(LEARNING[2])
        assert os.path.getsize(terminal.path('paths.png')) > 0
        with open(terminal.path('recordings/circle6.csv'), newline='', encoding='utf-8') as stream:
            assert {row['instance'] for row in csv.DictReader(stream)} == set(map(str, range(100)))

    def test_launch_files(self, runner):
        """Two at a time; each has a ROS master of its own."""
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            futures = {line: pool.submit(walk, runner, str(i), line) for i, line in enumerate(WALKING)}
        assert {line: str(future.exception()) for line, future in futures.items() if future.exception()} == {}

    @pytest.mark.parametrize('line', IN_RVIZ)
    def test_rviz(self, terminal, screen, line):
        """As printed, on a screen; RViz draws the crowd."""
        terminal.environment.update(screen.variables)
        process = start_rviz(terminal, screen, line)
        try:
            terminal.interrupt(process)
        except AssertionError:
            if RESTARTED not in process.output():
                raise
            # What was interrupted is the second start of an RViz that the renderer had crashed.
            terminal.interrupt(start_rviz(terminal, screen, line))
        assert os.path.exists(terminal.path('table.txt')) == ('/tmp/table.txt' in line)

    def test_move_base(self, terminal):
        found = terminal.run('rospack find move_base || true')
        if not found.startswith('/'):
            pytest.skip('move_base is not built')
        terminal.interrupt(terminal.launch(MOVE_BASE + ' rviz:=false'))

    def test_services(self, terminal):
        process = terminal.launch(DEMO + ' rviz:=false')
        for line in SERVICES:
            assert_says(terminal.run(line), 'success: True')
        assert os.path.getsize(terminal.path('.ros/social_crowd/table.txt')) > 0
        terminal.interrupt(process)

    def test_a_driven_robot(self, terminal):
        process = terminal.launch(ROBOT[0] + ' rviz:=false')
        driver = terminal.start(ROBOT[1])
        terminal.wait_message('/odom', 'm.twist.twist.linear.x > 0.4 and m.twist.twist.angular.z > 0.1')
        driver.kill()  # rostopic ends with status 1 after Ctrl-C
        terminal.interrupt(process)

    def test_crowd_env(self, terminal):
        assert STEPPED in README
        process = terminal.start(f'{ROBOT[0]} {STEPPED}')
        wait_for(terminal.has_master, 'the ROS master')
        wait_for(lambda: '/crowd_controller/step_robots' in terminal.run('rosservice list'), 'the crowd controller')
        terminal.write('drive.py', other_blocks(README)[2] + 'print("over", info["tick"])\n')
        assert re.search(r'^over [1-9]\d*$', terminal.run('/usr/bin/python3 drive.py'), re.MULTILINE)
        terminal.interrupt(process)

    def test_a_policy_of_ones_own(self, terminal):
        pytest.importorskip('social_crowd._core')
        terminal.write('policy.py', other_blocks(README)[0])
        said = terminal.run('/usr/bin/python3 policy.py')
        assert re.search(r'^arrived without a contact: \d+ of 20\nreactive rule: \d+ of 20$', said, re.MULTILINE), \
            said

    def test_the_example_of_a_robot(self, terminal):
        """It is a part of a scenario file."""
        terminal.write('robot.yaml', MY_SCENARIO + other_blocks(README)[1])
        terminal.run('rosrun social_crowd evaluate --q-table config/q_tables/human.txt robot.yaml')

    def test_arguments_of_the_launch_file(self, terminal):
        assert_says(terminal.run(ARGUMENTS), 'scenario (default "walkers6")', 'real_time_factor')

    def test_import_of_a_scene(self, terminal):
        terminal.write('FILE.xml', PEDSIM_SCENE)
        terminal.run(IMPORT)
        terminal.run('rosrun social_crowd evaluate --q-table config/q_tables/human.txt SCENARIO.yaml')


def walk(runner, name, line):
    """Runs a launch file without RViz until its crowd walks, and then interrupts it."""
    terminal = Terminal(runner, runner.path(name))
    terminal.write('my.yaml', MY_SCENARIO)
    terminal.write('obsmat.txt', obsmat())
    write_bag(terminal.path('walk.bag'))
    terminal.interrupt(terminal.launch(line + ' rviz:=false'))
    saved = [file for file in os.listdir(terminal.folder) if file.startswith('my_agent_')]
    assert sorted(saved) == (['my_agent_0.txt', 'my_agent_1.txt'] if 'my.txt' in line else []), saved


def start_rviz(terminal, screen, line):
    """Starts a launch file and waits until RViz answers, or has ended. Returns its Process."""
    process = terminal.launch(printed(line, terminal))

    def has_ended():
        return not process.is_running() or 'exit code' in process.output()

    wait_for(lambda: has_ended() or has_colours(screen, terminal.path('screen.png')), 'RViz to draw')
    # A node that is interrupted while it registers its topics reports an error, or crashes; RViz does so after it has
    # drawn, and answers when it is ready.
    answers = "rosnode info /rviz | grep -F '* /chosen_agent/goal ' && rosnode ping -c 1 /rviz | grep time= || true"
    wait_for(lambda: has_ended() or 'time=' in terminal.run(answers), 'the tools of RViz')
    return process


def has_colours(screen, file):
    """Returns whether RViz shows many colours: a window with its panels and a crowd."""
    pixels = screen.picture(file)
    return pixels is not None and len({tuple(pixel) for row in pixels[::5, ::5] for pixel in row}) > 100
