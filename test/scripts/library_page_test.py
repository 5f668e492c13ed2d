"""docs/library.md: the example project is built with an installed copy of the package, and run."""
import os
import pathlib
import re
import subprocess

import pytest
from learning_files import config_text
from programs import ANTICIPATION_TABLE, assert_says, page_examples, page_text, read_text, wait_for
from terminal import Terminal

LONG = 300.0  # [s] time limit for a compiler on a busy machine


def without_devel(variable):
    """Returns the paths in an environment variable without those of the build folder."""
    return [path for path in os.environ.get(variable, '').split(':') if path and '/devel' not in path]


class LibraryPageTest:
    """docs/library.md: a separate project with an installed copy of the package."""

    def run_here(self, runner, *command):
        """Returns exit status and output of a command whose environment does not contain the build folder."""
        environment = dict(os.environ, CMAKE_PREFIX_PATH='', LD_LIBRARY_PATH=':'.join(without_devel('LD_LIBRARY_PATH')))
        done = subprocess.run(list(map(str, command)), cwd=runner.folder, env=environment, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, timeout=LONG, check=False)
        return done.returncode, done.stdout.decode(errors='replace')

    def run_successfully(self, runner, *command):
        """Returns the output of a command, which must succeed."""
        status, output = self.run_here(runner, *command)
        assert status == 0, f'{command}:\n{output}'
        return output

    def install(self, runner, build, prefix):
        """Installs the package as described on the page; restores the build folder afterwards."""
        environment = pathlib.Path(build, 'catkin_generated', 'setup_cached.sh')  # environment of tests
        kept = environment.read_bytes()
        with open(os.path.join(build, 'CMakeCache.txt'), encoding='utf-8') as cache:
            before = re.search('^CMAKE_INSTALL_PREFIX:PATH=(.*)$', cache.read(), re.MULTILINE).group(1)
        try:
            subprocess.run(['cmake', build, f'-DCMAKE_INSTALL_PREFIX={prefix}'], stdout=subprocess.DEVNULL, check=True)
            self.run_successfully(runner, 'cmake', '--install', build)
        finally:
            subprocess.run(['cmake', build, f'-DCMAKE_INSTALL_PREFIX={before}'], stdout=subprocess.DEVNULL, check=True)
            environment.write_bytes(kept)
        found = self.run_successfully(runner, 'env', '-i', 'PATH=/usr/bin:/bin', 'bash', '-c',
                                      f'source {prefix}/setup.bash && rospack find social_crowd')
        assert found.strip() == os.path.join(prefix, 'share', 'social_crowd')

    def test_the_example_walks_and_learns(self, runner, request):
        build = request.config.getoption('--build')
        if build is None:
            pytest.skip('needs --build, the folder from which the package is installed')
        prefix = runner.path('installed')
        self.install(runner, build, prefix)
        files = page_examples('library.md')
        assert sorted(files) == ['CMakeLists.txt', 'decide.cpp', 'learn.cpp', 'simulate.cpp', 'step_crowd.py',
                                 'walk.cpp']
        for name, text in files.items():
            runner.write(name, text)
        others = without_devel('CMAKE_PREFIX_PATH')
        prefixes = ';'.join([prefix, *others])
        self.run_successfully(runner, 'cmake', '-S', '.', '-B', 'build', f'-DCMAKE_PREFIX_PATH={prefixes}')
        self.run_successfully(runner, 'cmake', '--build', 'build')
        self.check_programs(runner, os.path.join(prefix, 'share', 'social_crowd', 'config'))

    def test_the_example_through_ros(self, runner):
        """The program prints the places of a walk without ROS."""
        launch, step = (re.search(f'^    ({words} .*)$', page_text('library.md'), re.MULTILINE)[1]
                        for words in ('roslaunch', 'python3'))
        terminal = Terminal(runner, runner.path('clone'))
        terminal.write('step_crowd.py', page_examples('library.md')['step_crowd.py'])
        crowd = terminal.start(launch)
        wait_for(terminal.has_master, 'the ROS master')
        printed = terminal.run(step).splitlines()
        terminal.interrupt(crowd)
        assert len(printed) == 60
        rows = [row.split(',') for row in runner.headless('circle6', ANTICIPATION_TABLE).decode().splitlines()]
        assert printed[-6:] == [f'10.0 s: agent {agent} at {float(x):.3f}, {float(y):.3f}'
                                for _, tick, agent, x, y in rows if tick == '100']

    def check_programs(self, runner, config):
        """Compares the programs with the tools; scenarios are found by name in the installed copy."""
        table = os.path.join(config, 'q_tables', 'anticipation.txt')
        walked = self.run_successfully(runner, 'build/walk', table, 'circle6')
        assert re.search(r'^6 of 6 arrived, 0 were in contact, \d+ ticks\n$', walked)
        status, output = self.run_here(runner, 'build/walk', 'missing.txt', 'circle6')
        assert status == 1, output
        assert_says(output, "no Q-table 'missing.txt'")
        assert self.run_successfully(runner, 'build/walk', 'anticipation', 'circle6') == walked
        assert self.run_successfully(runner, 'build/decide') == '6 agents arrived, 0 were in contact\n'
        simulated = self.run_successfully(runner, 'build/simulate')
        ticks = int(re.search(r'^arrived after (\d+) ticks\n$', simulated)[1])
        assert 32 <= ticks < 60, '4.2 m at 1.3 m/s, and a detour'
        training = runner.write('config.yaml', config_text('circle6', 2, seed=4))
        learned = self.run_successfully(runner, 'build/learn', training, 'table.txt', 'single_free')
        assert re.search(r'^2 episodes, \d+ decisions\n\d+% arrived, 0% were in contact\n$', learned)
        runner.tool('train', training, '--output', runner.path('expected.txt'))
        assert read_text(runner.path('table.txt')) == read_text(runner.path('expected.txt'))
        _, output = self.run_here(runner, 'build/walk', table, 'circel6')
        assert_says(output, f'{os.path.realpath(config)}/scenarios none of that name')
