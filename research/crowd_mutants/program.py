"""Changes rules of the core one at a time, and runs the test that is to notice it."""
import argparse
import hashlib
import os
import pathlib
import shutil
import subprocess

import yaml
from crowd_drawing.errors import InputError, RunError
from crowd_experiments.tools import REPOSITORY, build_folder
from crowd_mutants.mutant_list import check_mutants, mutated, read_mutants

EPILOG = '''
Each mutant of research/crowd_mutants/mutants.yaml changes one place of a source of the core. The program builds the
core with this change in a folder of its own, from a copy of the sources, and runs the named unit test of the existing
build (scripts/build --tests) with that core. A test that fails, crashes or exceeds the deadline kills the mutant.

Results are kept in the folder; later runs repeat only what has changed since. Exit status: 0 all killed, 1 a mutant
survived or was not built, or a test fails without any change.

Examples:
  research/mutants --folder /tmp/mutants
  research/mutants --folder /tmp/mutants --only whole_gap_to_agents
'''
# Only the core is built, quickly. Files with mutants are compiled alone; precompiled headers save most of the time.
CMAKE = '''cmake_minimum_required(VERSION 3.16)
project(social_crowd CXX)
set(BUILD_SHARED_LIBS ON)
set(REPOSITORY ${{CMAKE_CURRENT_SOURCE_DIR}})
set(SCENARIOS_IN_PREFIX none)
include(src/core.cmake)
target_precompile_headers(social_crowd_core PRIVATE <Eigen/Core> <yaml-cpp/yaml.h> <atomic> <functional> <optional>)
set_source_files_properties({files} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
'''
QUICK = ('-DCMAKE_BUILD_TYPE=Release', '-DCMAKE_CXX_FLAGS_RELEASE=-O1')
DEADLINE = 300  # of tests, in time of the processor [s]
KILLED, SURVIVED, NOT_BUILT = 'killed', 'survived', 'not built'


class Core:
    """A copy of the sources of the core, its build, and the tests that run with it."""

    def __init__(self, folder, tests, mutants):
        self.source, self.build, self.tests = folder / 'source', folder / 'build', tests
        self.source.mkdir(parents=True, exist_ok=True)
        for name in ('include', 'src'):
            copy_changed(REPOSITORY / name, self.source / name)
        config = self.source / 'config'  # scenarios that tests find by name
        if not config.is_symlink():
            config.symlink_to(REPOSITORY / 'config')
        alone = sorted({mutant.file for mutant in mutants})
        write_changed(self.source / 'CMakeLists.txt', CMAKE.format(files=' '.join(alone)))
        run('cmake', '-S', self.source, '-B', self.build, *QUICK)

    def make(self):
        """Builds the library. Returns whether this succeeded."""
        done = subprocess.run(['cmake', '--build', self.build, '--parallel', '2'], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, check=False)
        (self.build / 'log.txt').write_bytes(done.stdout)
        return done.returncode == 0

    def passes(self, binary, tests):
        """Whether tests pass with the built library. Raises RunError if there are none of this name."""
        environment = dict(os.environ, LD_LIBRARY_PATH=f"{self.build}:{os.environ.get('LD_LIBRARY_PATH', '')}")
        command = ['prlimit', f'--cpu={DEADLINE}', self.tests / binary, f"--gtest_filter={':'.join(tests)}"]
        try:
            done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env=environment,
                                  cwd=self.build, timeout=20 * DEADLINE, check=False)
        except subprocess.TimeoutExpired:
            return False
        if b'Running 0 tests' in done.stdout:
            raise RunError(f'{self.tests / binary} has no test {tests[0]}; build it with scripts/build --tests')
        return done.returncode == 0

    def judge(self, mutant):
        """Builds and tests a mutant, and restores its file and what was compiled from it."""
        file = self.source / mutant.file
        compiled = self.build / 'CMakeFiles' / 'social_crowd_core.dir' / f'{mutant.file}.o'
        original = file.read_text()
        object_code = compiled.read_bytes() if compiled.is_file() else None  # a header has none
        try:
            file.write_text(mutated(mutant, original))
            if not self.make():
                return NOT_BUILT
            return SURVIVED if self.passes(mutant.binary, [mutant.test]) else KILLED
        finally:
            file.write_text(original)
            if object_code is not None:
                compiled.write_bytes(object_code)  # is newer than the file: it is not compiled again


def run(*command, **options):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False, **options)
    if done.returncode != 0:
        raise RunError(f"{' '.join(map(str, command))} failed: {done.stdout.decode(errors='replace')[-2000:]}")


def write_changed(path, text):
    if not path.exists() or path.read_text() != text:
        path.write_text(text)


def copy_changed(begin, end):
    """Copies what differs, so that only this is built again, and removes files that are gone."""
    names = {path.relative_to(begin) for path in begin.rglob('*') if path.is_file()}
    for path in [path for path in end.rglob('*') if path.is_file()]:
        if path.relative_to(end) not in names:
            path.unlink()
    for name in names:
        (end / name).parent.mkdir(parents=True, exist_ok=True)
        if not (end / name).exists() or (end / name).read_bytes() != (begin / name).read_bytes():
            shutil.copyfile(begin / name, end / name)


def key_of(mutant):
    """Identifies a mutant, its file, and the tests of its layer."""
    tests = sorted((REPOSITORY / 'test' / mutant.binary.removesuffix('_test')).glob('*_test.cpp'))
    content = hashlib.sha256(repr(mutant).encode())
    for file in [REPOSITORY / mutant.file, *tests]:
        content.update(file.read_bytes())
    return content.hexdigest()[:16]


def check_unchanged(core, mutants):
    """Raises RunError unless all named tests pass without a change."""
    if not core.make():
        raise RunError(f"the core does not build, see {core.build / 'log.txt'}")
    for binary in sorted({mutant.binary for mutant in mutants}):
        tests = sorted({mutant.test for mutant in mutants if mutant.binary == binary})
        if not core.passes(binary, tests):
            raise RunError(f'{binary}: tests fail without a mutant')


def parse_arguments():
    parser = argparse.ArgumentParser(prog='mutants', description=__doc__, epilog=EPILOG,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--folder', type=pathlib.Path, help='for the copy, its build and the results '
                        '(default: mutants/ in the build folder)')
    parser.add_argument('--tests', type=pathlib.Path, help='folder of the unit tests (default: those of the build)')
    parser.add_argument('--only', action='append', metavar='NAME', help='only this mutant; can be repeated')
    parser.add_argument('--list', action='store_true', help='print the names and tests of the mutants')
    return parser.parse_args()


def main():
    """The program."""
    arguments = parse_arguments()
    mutants = read_mutants()
    check_mutants(mutants)
    chosen = [mutant for mutant in mutants if not arguments.only or mutant.name in arguments.only]
    if not chosen:
        raise InputError(f"{', '.join(arguments.only)}: there is no such mutant, see --list")
    if arguments.list:
        print(*(f'{mutant.name}: {mutant.file}, {mutant.binary} {mutant.test}' for mutant in chosen), sep='\n')
        return 0
    folder = (arguments.folder or build_folder() / 'mutants').absolute()
    tests = (arguments.tests or build_folder() / 'devel' / 'lib' / 'social_crowd').absolute()
    core = Core(folder, tests, mutants)
    check_unchanged(core, chosen)
    file = folder / 'results.yaml'
    results = yaml.safe_load(file.read_text()) if file.exists() else {}
    for mutant in chosen:
        key = key_of(mutant)
        if results.get(mutant.name, {}).get('key') != key:
            results[mutant.name] = {'key': key, 'result': core.judge(mutant)}
            file.write_text(yaml.safe_dump(results))
        print(f"{mutant.name}: {results[mutant.name]['result']} ({mutant.binary} {mutant.test})", flush=True)
    killed = sum(results[mutant.name]['result'] == KILLED for mutant in chosen)
    print(f'{killed} of {len(chosen)} mutants killed')
    return 0 if killed == len(chosen) else 1
