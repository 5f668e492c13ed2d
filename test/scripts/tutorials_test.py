"""docs/tutorials.md: each tutorial is done as printed."""
import os
import pathlib
import re
import shlex
import subprocess

import pytest
from page_commands import command_lines
from programs import assert_says, in_package, page_examples, page_text, read_text, tools_folder, wait_for
from terminal import Terminal

PAGE = page_text('tutorials.md')
SCENARIO, STATE_SET, MACHINES = (command_lines(part) for part in re.split('^## ', PAGE, flags=re.MULTILINE)[1:])
HOSTS = {'crowd': '127.0.0.2', 'brain': '127.0.0.3'}  # addresses of this machine
LONG = 120.0  # [s] time limit for a compiler on a busy machine
ALL_ARRIVE = re.compile(r'^\w+ +\d+ +100\.00 +0\.00 ', re.MULTILINE)  # success and contact [%]


@pytest.fixture(name='terminal')
def make_terminal(runner):
    """A terminal in a folder of the test, with all files of the page."""
    terminal = Terminal(runner, runner.path('clone'))
    for name, text in page_examples('tutorials.md').items():
        terminal.write(name, text)
    return terminal


class ScenarioTest:
    """Your first scenario."""

    def test_all_steps(self, terminal):
        evaluate, plot, demo, evaluate_door, film = SCENARIO
        assert ALL_ARRIVE.search(terminal.run(evaluate))
        terminal.run(plot)
        terminal.interrupt(terminal.launch(demo + ' rviz:=false'))
        assert ALL_ARRIVE.search(terminal.run(evaluate_door))
        terminal.run(f'{film} --tools {tools_folder()} --size 320 --duration 2')
        assert {'corridor.png', 'door.gif', 'recordings'} < set(os.listdir(terminal.folder))


class StateSetTest:
    """Your first state set. The core is linked again with the file that the tutorial writes and the one that it
    changes, and takes the place of the library of the programs."""

    def test_all_steps(self, terminal, request):
        if not request.config.getoption('--build'):
            pytest.skip('needs --build')
        build, *programs, fill = STATE_SET
        assert (build, fill) == ('scripts/build', 'scripts/generate types')
        terminal.environment['LD_PRELOAD'] = self.library(terminal, request.config.getoption('--build'))
        trained, evaluated = map(terminal.run, programs)
        assert_says(trained, '72 of 72 rows visited')
        assert len(ALL_ARRIVE.findall(evaluated)) == 2
        paths = [float(line.split()[6]) for line in evaluated.splitlines()[-2:]]
        assert all(1.35 < path < 1.65 for path in paths), 'as the tutorial says'
        assert_says(terminal.run('rosrun social_crowd train --list-types'), '| `state_set` | `near_body` |')

    def library(self, terminal, build):
        """Makes the core with the new state set. Returns its file."""
        terminal.write('state_set.cpp', changed_list())
        folders = [in_package('src'), in_package('include')]
        flags = ['-std=c++17', '-O1', '-Wall', '-Wextra', '-Werror', '-fPIC', *(f'-I{folder}' for folder in folders),
                 '-isystem', '/usr/include/eigen3']
        for name in ('near_body_states', 'state_set'):
            run(terminal.folder, ['c++', *flags, '-c', f'{name}.cpp', '-o', f'{name}.o'])
        library = terminal.path('libsocial_crowd_core.so')
        objects = [terminal.path('state_set.o'), terminal.path('near_body_states.o')]
        run(build, link_command(pathlib.Path(build), library, objects))
        return library


def changed_list():
    """Returns state_set.cpp with the lines of the tutorial."""
    declaration, entry = re.search(r'`TYPES`\.\n\n```cpp\n(.*)\n(.*)\n```', PAGE).groups()
    text = read_text(in_package('src', 'learning', 'states', 'state_set.cpp'))
    text = text.replace('\nStateSetType', f'\n{declaration}\nStateSetType', 1)
    return text.replace('TYPES = {', f'TYPES = {{\n{entry}', 1)


def link_command(build, library, objects):
    """Returns the command that links the core in a build folder of Ninja or make, with other objects for state_set.cpp,
    and another output."""
    if (build / 'build.ninja').is_file():
        commands = subprocess.run(['ninja', '-t', 'commands', 'social_crowd_core'], cwd=build, stdout=subprocess.PIPE,
                                  timeout=LONG, check=True).stdout.decode().splitlines()
        words = shlex.split(commands[-1])[2:-2]  # between ": &&" and "&& :"
    else:
        words = shlex.split(read_text(build / 'CMakeFiles' / 'social_crowd_core.dir' / 'link.txt'))
    words[words.index('-o') + 1] = library
    old = next(i for i, word in enumerate(words) if word.endswith('/state_set.cpp.o'))
    return [*words[:old], *objects, *words[old + 1:]]


def run(folder, command):
    """Runs a compiler."""
    done = subprocess.run(list(map(str, command)), cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          timeout=LONG, check=False)
    assert done.returncode == 0, done.stdout.decode()


class MachinesTest:
    """Learners on another machine. Both hosts are addresses of this one."""

    def test_all_steps(self, runner):
        crowd, brain = (Terminal(runner, runner.path(name)) for name in HOSTS)
        exports = [line for line in MACHINES if line.startswith('export')]
        launch, learn, look, listen = [line for line in MACHINES if not line.startswith('export')]
        for terminal, line in zip((crowd, brain), exports):
            terminal.environment.update(variables_of(line, crowd.port))
        walking = crowd.start(launch + ' real_time_factor:=fast')
        wait_for(crowd.has_master, 'the ROS master')
        deciding = brain.start(learn)
        assert_says(brain.run(listen), '0\n')
        assert_says(crowd.run(look), f"http://{HOSTS['brain']}:", '/crowd_controller')
        assert_says(brain.run('rosnode info /crowd_controller'), f"http://{HOSTS['crowd']}:")
        assert deciding.stop() == 0
        crowd.interrupt(walking)
        assert_says(walking.output(), '6 of 6 agents arrived', ' 0 answers missed')


def variables_of(export, port):
    """Returns the variables of a line, with addresses for names, and the port of a test."""
    pairs = [word.split('=') for word in export.split()[1:]]
    for name, address in HOSTS.items():
        pairs = [(key, re.sub(rf'\b{name}\b', address, value)) for key, value in pairs]
    return {key: value.replace(':11311', f':{port}') for key, value in pairs}
