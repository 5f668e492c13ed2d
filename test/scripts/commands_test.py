"""Programs and scripts on the command line: rosrun finds them, and error messages are helpful."""
import os
import pathlib
import re
import shutil
import signal
import subprocess

import pytest
from programs import CIRCLE6, NEAREST_TABLE, OCCUPANCY_TABLE, PATIENCE, assert_says, in_package, read_text, wait_for
from roslib.packages import find_node

WALK = 'instance,tick,agent,x,y\n0,0,0,0,0\n0,1,0,1,0\n'
SCENE = '''name: scene
duration: 10
goal_tolerance: 0.3
agents:
  - {position: [0, 0], goal: %s, speed: 1, radius: 0.25}
'''


def run_here(runner, *command):
    """Returns exit status and output of a command that is run in the test's folder, without standard input."""
    done = subprocess.run(list(map(str, command)), cwd=runner.folder, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=PATIENCE, check=False)
    return done.returncode, done.stdout.decode(errors='replace')


class InterruptionTest:
    """Ctrl-C."""

    @pytest.mark.parametrize('name, output', [('report', 'a.html'), ('plot_learning', 'a.png'),
                                              ('draw_q_table', 'a.png'), ('convert_trajectories', 'a.csv')])
    def test_ends_with_a_message(self, runner, name, output):
        """While it reads a pipe into which nothing is written."""
        pipe = runner.path('pipe')
        os.mkfifo(pipe)
        process = runner.start(name, [in_package('scripts', name), pipe, '--output', runner.path(output)])
        writer = wait_for(lambda: opened(pipe), f'{name} to read')
        process.signal(signal.SIGINT)
        os.close(writer)  # ends a read() that began between the signal and Python's look at it
        assert process.wait() == 130, process.output()
        assert process.output() == f'{name}: interrupted\n'
        assert not os.path.exists(runner.path(output))

    def test_evaluate_says_that_the_results_are_those_of_a_part(self, runner):
        record = runner.path('record.csv')
        process = runner.start('evaluate', [find_node('social_crowd', 'evaluate')[0], '--q-table', NEAREST_TABLE,
                                            '--episodes', '10000000', '--record', record, 'circle6'])
        wait_for(lambda: os.path.exists(record) and os.path.getsize(record) > 1000, 'the first episodes')
        assert process.stop() == 130, process.output()
        said = re.search(r'circle6: interrupted after (\d+) of 10000000 episodes', process.output())
        shown = re.search(r'^circle6 +(\d+) ', process.output(), re.MULTILINE)
        assert 0 < int(said[1]) == int(shown[1]), process.output()


def opened(pipe):
    """Opens a pipe for writing if a program reads it. Returns the descriptor, or None."""
    try:
        return os.open(pipe, os.O_WRONLY | os.O_NONBLOCK)
    except OSError:
        return None


class RosrunTest:
    """rosrun social_crowd PROGRAM."""

    @pytest.mark.parametrize('name', ['train', 'evaluate', 'plot_paths', 'compare', 'convert_trajectories',
                                      'crowded_robot', 'draw_q_table', 'drive_robots', 'film', 'goal_sender',
                                      'learner_crew', 'pedsim_import', 'plot_learning', 'record_robots', 'replay',
                                      'report', 'reproduce', 'robot_benchmark', 'robot_crew', 'show_crowd', 'sweep',
                                      'validate'])
    def test_names_are_unique(self, runner, name):
        status, output = run_here(runner, 'rosrun', 'social_crowd', name, '--help')
        assert status == 0, output
        assert 'non-unique' not in output
        assert 'usage' in output.lower()


class ToolTest:
    """train, evaluate and plot_paths."""

    def refuse(self, runner, status, words, name, *arguments):
        """Runs a program that must fail with this exit status and these words."""
        got, output = run_here(runner, find_node('social_crowd', name)[0], *arguments)
        assert got == status, output
        assert_says(output, *words)
        return output

    def test_numbers_out_of_range(self, runner):
        config = in_package('config', 'learning', 'thesis_nearest.yaml')
        for program, given in (('train', [config, '--output', 'table.txt']),
                               ('evaluate', ['--q-table', NEAREST_TABLE, 'circle6'])):
            words = ["--episodes: expected a whole number, 1 or more, got '0'"]
            output = self.refuse(runner, 2, words, program, *given, '--episodes', 0)
            assert len(output) < 120
            words = ["--seed: expected a whole number, 0 or more, got '-1'"]
            self.refuse(runner, 2, words, program, *given, '--seed', -1)

    def test_missing_files(self, runner):
        words = ["no Q-table 'table.txt': there is no file " + os.path.join(runner.folder, 'table.txt'), 'anticipation']
        self.refuse(runner, 1, words, 'evaluate', '--q-table', 'table.txt', 'circle6')
        words = ['config.yaml: cannot be read', os.path.join(runner.folder, 'config.yaml')]
        self.refuse(runner, 1, words, 'train', 'config.yaml', '--output', 'new.txt')

    def test_a_misspelt_scenario(self, runner):
        words = ["no scenario 'circel6', did you mean 'circle6'? There is no file",
                 os.path.join(runner.folder, 'circel6'), in_package('config', 'scenarios'), 'there are circle6, ']
        self.refuse(runner, 1, words, 'evaluate', '--q-table', NEAREST_TABLE, 'circel6')

    def test_goals_out_of_reach(self, runner):
        """They are reported when an episode begins, and counted at the end."""
        walls = 'walls: [[[4, -1], [6, -1]], [[6, -1], [6, 1]], [[6, 1], [4, 1]], [[4, 1], [4, -1]]]\n'
        pathlib.Path(runner.folder, 'caged.yaml').write_text(SCENE % '[5, 0]' + walls, encoding='utf-8')
        status, output = run_here(runner, find_node('social_crowd', 'evaluate')[0], '--q-table', NEAREST_TABLE,
                                  '--episodes', 3, 'caged.yaml')
        assert status == 0, output
        assert output.count('at its start: 1 agent has a goal out of reach (0)') == 1, output
        assert 'caged: 3 agents have goals out of reach\n' in output, output

    @pytest.mark.parametrize('option', ['--trajectories', '--scenes', '--states'])
    def test_two_scenarios_with_the_same_output_file(self, runner, option):
        shutil.copy(CIRCLE6, runner.path('hall.yaml'))
        os.mkdir(runner.path('other'))
        shutil.copy(CIRCLE6, runner.path('other/hall.yaml'))
        words = [f'evaluate: {option}: hall.yaml and other/hall.yaml', "'hall'"]
        self.refuse(runner, 1, words, 'evaluate', '--q-table', NEAREST_TABLE, '--episodes', 1, option, 'out',
                    '--record', 'record.csv', 'hall.yaml', 'other/hall.yaml')
        assert not os.path.exists(runner.path('out'))
        assert not os.path.exists(runner.path('record.csv'))

    def test_a_misspelt_option(self, runner):
        config = in_package('config', 'learning', 'thesis_nearest.yaml')
        words = ["train: there is no option '--epsodes', did you mean '--episodes'?", '--help']
        self.refuse(runner, 2, words, 'train', config, '--output', 'table.txt', '--epsodes', 3)
        self.refuse(runner, 2, words, 'train', config, '--output', 'table.txt', '--epsodes=3')
        self.refuse(runner, 2, ["train: there is no option '--colour'\n"], 'train', config, '--output', 'table.txt',
                    '--colour', 'red')
        self.refuse(runner, 2, ['train: unexpected argument: more'], 'train', config, 'more', '--output', 'table.txt')
        self.refuse(runner, 2, ['train: ', '--output'], 'train', config)

    def test_a_table_of_another_model(self, runner):
        config = in_package('config', 'learning', 'thesis_nearest.yaml')
        words = [f'train: {OCCUPANCY_TABLE}: was learned for another']
        self.refuse(runner, 1, words, 'train', config, '--output', 'table.txt', '--q-table', OCCUPANCY_TABLE)
        assert not os.path.exists(runner.path('table.txt'))

    def test_scenarios_have_names(self, runner):
        recording = runner.path('circle6.csv')
        runner.tool('evaluate', '--q-table', NEAREST_TABLE, '--trajectories', runner.folder, 'circle6')
        drawing = ['--trajectories', recording, '--output', 'paths.png', '--scenario']
        status, output = run_here(runner, find_node('social_crowd', 'plot_paths')[0], *drawing, 'circle6')
        assert status == 0, output
        assert os.path.exists(runner.path('paths.png'))
        words = ["no scenario 'circel6', did you mean 'circle6'? There is no file",
                 'in config/scenarios there are circle6, ']
        self.refuse(runner, 1, words, 'plot_paths', *drawing, 'circel6')

    def test_a_missing_instance(self, runner):
        recording = runner.write('walk.csv', WALK + '1,0,0,0,0\n')
        drawing = ['--trajectories', recording, '--output', 'paths.png', '--scenario', 'circle6', '--instance']
        self.refuse(runner, 1, ['walk.csv: has no instance 9, expected 0 to 1\n'], 'plot_paths', *drawing, 9)
        recording = runner.write('walk.csv', WALK)
        self.refuse(runner, 1, ['walk.csv: has no instance 1, expected 0\n'], 'plot_paths', *drawing, 1)

    def test_goals_drawn_at_random(self, runner):
        """The picture has the known goals; for the others, the program prints how to get them."""
        recording = runner.write('walk.csv', WALK)
        for goal, known in (('[3, 0]', True), ('{box: [[0, 0], [9, 9]]}', False)):
            scenario = runner.write('scene.yaml', SCENE % goal)
            status, output = run_here(runner, find_node('social_crowd', 'plot_paths')[0], '--trajectories', recording,
                                      '--output', 'paths.svg', '--scenario', scenario)
            assert status == 0, output
            assert ('evaluate --scenes DIR' in output) != known, output
            assert ('<!-- goal -->' in read_text(runner.path('paths.svg'))) == known  # in the legend


class BuildTest:
    """scripts/build in a copied clone."""

    def copy(self, runner, made_for, build):
        """Makes a clone that contains only the script, and a build folder of another clone. Returns its cache file."""
        scripts = pathlib.Path(runner.path('clone/scripts'))
        scripts.mkdir(parents=True)
        shutil.copy(in_package('scripts', 'build'), scripts)
        stop = scripts / 'install_dependencies'  # the script's next step, which ends it
        stop.write_text('#!/bin/sh\necho looked at the build folder\nexit 7\n', encoding='utf-8')
        stop.chmod(0o755)
        pathlib.Path(build).mkdir(parents=True)
        cache = pathlib.Path(build, 'CMakeCache.txt')
        cache.write_text(f'CMAKE_HOME_DIRECTORY:INTERNAL={made_for}\n', encoding='utf-8')
        return cache

    def build(self, runner, clone='clone', **environment):
        """Runs the script without the build folder of these tests, which the environment may contain."""
        return run_here(runner, 'env', '-u', 'SOCIAL_CROWD_BUILD',
                        *(f'{name}={value}' for name, value in environment.items()),
                        runner.path(f'{clone}/scripts/build'))

    def test_a_copied_build_folder_is_recreated(self, runner):
        cache = self.copy(runner, '/somewhere/else', runner.path('clone/.build'))
        status, output = self.build(runner)
        assert status == 7, output
        assert_says(output, 'clone/.build was made for /somewhere/else and is recreated', 'looked at')
        assert not cache.exists()

    def test_the_own_build_folder_is_kept(self, runner):
        cache = self.copy(runner, runner.path('clone'), runner.path('clone/.build'))
        assert self.build(runner) == (7, 'looked at the build folder\n')
        assert cache.exists()

    def test_a_folder_with_a_space(self, runner):
        self.copy(runner, runner.path('clone'), runner.path('clone/.build'))
        status, output = self.build(runner, SOCIAL_CROWD_BUILD=runner.path('my build'))
        assert status == 1, output
        assert_says(output, 'space in its name', "my build'")
        os.rename(runner.path('clone'), runner.path('a clone'))
        status, output = self.build(runner, 'a clone')
        assert status == 1, output
        assert_says(output, 'space in its name', "a clone'")
        assert 'looked at' not in output

    def test_a_build_folder_elsewhere_may_be_in_use(self, runner):
        cache = self.copy(runner, '/somewhere/else', runner.path('theirs'))
        status, output = self.build(runner, SOCIAL_CROWD_BUILD=runner.path('theirs'))
        assert status == 1, output
        assert_says(output, 'theirs was made for /somewhere/else', 'SOCIAL_CROWD_BUILD')
        assert cache.exists()
