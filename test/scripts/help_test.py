"""--help of all programs, and completion of their names by rosbash."""
import os
import pathlib
import re
import subprocess

import pytest
from programs import PATIENCE, in_package, page_text, read_text, tools_folder

SCRIPTS = sorted(file for folder in ('scripts', 'research') for file in pathlib.Path(in_package(folder)).iterdir()
                 if os.access(file, os.X_OK) and file.is_file())
# Nodes and tools, without programs for tests and benchmarks.
BUILT = [pathlib.Path(tools_folder(), name) for names in
         re.findall(r'^set\((?:NODES|TOOLS) (.*)\)$', read_text(in_package('CMakeLists.txt')), re.MULTILINE)
         for name in names.split()]
TOOLS = [file for file in BUILT if file.name in ('train', 'evaluate', 'score_robots')]
PROGRAMS = [*SCRIPTS, *BUILT]
NODES = [file for file in BUILT if file not in TOOLS]
PAGES = ('ros.md', 'rviz.md', 'robots.md')  # with the parameters of the nodes
ROSBASH = pathlib.Path('/usr/share/bash-completion/completions/rosbash')
# Prints what the Tab key would offer after some words.
TAB = '''
source {rosbash}
COMP_WORDS=("$@" "") COMP_CWORD=$#
completer=$(complete -p "$1" | sed 's/.*-F \\([^ ]*\\) .*/\\1/')
"$completer" "$1" "" "${{!#}}"
printf '%s\\n' "${{COMPREPLY[@]}}"
'''


def run(*command, environment=None):
    """Runs a program. Returns exit status and output."""
    done = subprocess.run(list(map(str, command)), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, timeout=PATIENCE, check=False,
                          env=dict(os.environ, **(environment or {})))
    return done.returncode, done.stdout.decode(errors='replace')


def offered(*words, prefix=None):
    """Returns what rosbash offers after some words; with the programs in another devel folder."""
    if not ROSBASH.is_file():
        pytest.skip('rosbash is not installed')
    environment = {'CMAKE_PREFIX_PATH': f"{prefix}:{os.environ['CMAKE_PREFIX_PATH']}"} if prefix else {}
    status, output = run('bash', '-c', TAB.format(rosbash=ROSBASH), 'bash', *words, environment=environment)
    assert status == 0, output
    return set(output.split())


class HelpTest:
    """PROGRAM --help."""

    def test_all_kinds_of_programs_are_found(self):
        assert {'film', 'train', 'crowd_controller', 'demo', 'show_crowd'} <= {file.name for file in PROGRAMS}

    @pytest.mark.parametrize('file', PROGRAMS, ids=lambda file: file.name)
    def test_usage_example_and_exit_status(self, file):
        status, output = run(file, '--help')
        assert status == 0, output
        for word in ('usage:', 'example', 'exit status'):
            assert word in output.lower(), output
        assert file.name in output[output.lower().index('example'):], 'the example calls the program'

    @pytest.mark.parametrize('file', NODES, ids=lambda file: file.name)
    def test_arguments_of_examples_are_parameters(self, file):
        """Names of a service's name space, such as crowd_controller:=OTHER, would be remapped without an effect."""
        example = run(file, '--help')[1].partition('example:')[2]
        parameters = set(re.findall(r'`~(\w+)`', ''.join(map(page_text, PAGES))))
        for argument in re.findall(r'(\S+):=', example):
            if argument not in ('__name', '__ns'):
                assert argument[0] == '_' and argument[1:] in parameters, argument

    @pytest.mark.parametrize('file', [*SCRIPTS, *TOOLS], ids=lambda file: file.name)
    def test_wrong_usage(self, file):
        """Programs that take options refuse unknown ones; those that pass arguments on are left out."""
        if 'usage: rosrun' in run(file, '--help')[1]:
            pytest.skip('takes parameters of ROS')
        status, output = run(file, '--no-such-option')
        assert status == 2, output
        assert 'Traceback' not in output

    def test_the_page_has_the_exit_statuses(self):
        assert '| 130 | interrupted' in page_text('tools.md')


class CompletionTest:
    """The Tab key after rosrun and roslaunch."""

    def test_launch_files_and_their_arguments(self):
        assert set(os.listdir(in_package('launch'))) <= offered('roslaunch', 'social_crowd')
        arguments = offered('roslaunch', 'social_crowd', 'demo.launch')
        assert {'scenario', 'real_time_factor'} <= {word.partition(':=')[0] for word in arguments}

    def test_scripts(self):
        assert {file.name for file in SCRIPTS} <= offered('rosrun', 'social_crowd')

    def test_programs(self, tmp_path):
        """In a folder without a dot in its name: rosbash leaves out what is in .build."""
        devel = tmp_path / 'devel'
        devel.symlink_to(pathlib.Path(tools_folder()).parents[1])
        assert {file.name for file in BUILT} <= offered('rosrun', 'social_crowd', prefix=devel)
