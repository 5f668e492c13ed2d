"""Measures which lines and branches of the core its unit tests execute."""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re

from crowd_experiments.tools import REPOSITORY, build_folder, programs_in
from crowd_mutants.program import run

LEAST = (95.0, 85.0)  # of lines and branches [%]
# Left out: other tests execute the same code with fewer random cases.
LONG_TESTS = ('BrakingWorlds.PreventsAllContactsWithinTheLimits', 'DistributedCrowd.WalksAsOneEpisodeInSolidWorlds',
              'MergeCopies.StaysInTheRangeOfOldValueAndTargets',
              'RobotSeparation.AgentsNeverMoveIntoRobotsNorIntoTheirReach',
              'SeparationProperty.NobodyTouchesAnythingInAMillionRandomTicks')
EPILOG = f'''
Builds the core without optimisation in a folder of its own, runs the unit tests of the existing build (scripts/build
--tests) with it, two at a time, and prints what gcovr (in Debian: gcovr) counts, by folder of src/. Not counted are
branches that the compiler adds for exceptions, those of lines without code, and what only these long
tests execute:
  {"""
  """.join(LONG_TESTS)}
Lines that were not executed are named in lines.txt in the folder, branches in branches.txt.

Exit status: 0 at least 95 % of the lines and 85 % of the branches were executed, 1 fewer, or a test failed.

Example:
  research/coverage --folder /tmp/coverage
'''


def test_layers(folder, tests):
    """Runs the unit tests of all layers of the core that was built in the folder."""
    environment = dict(os.environ, LD_LIBRARY_PATH=f"{folder}:{os.environ.get('LD_LIBRARY_PATH', '')}")
    for counts in folder.rglob('*.gcda'):
        counts.unlink()
    layers = re.search(r'foreach\(LAYER (.*)\)', (REPOSITORY / 'src' / 'core.cmake').read_text())[1].split()

    def test(layer):
        run(tests / f'{layer}_test', '--gtest_brief=1', f"--gtest_filter=-{':'.join(LONG_TESTS)}", env=environment,
            cwd=folder)

    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        list(pool.map(test, ('simd', *layers, 'ranks')))


def measure(folder, tests):
    """Builds the core and runs its tests. Returns gcovr's summary."""
    run('cmake', '-S', pathlib.Path(__file__).parent, '-B', folder)
    run('cmake', '--build', folder, '--parallel', '2')
    test_layers(folder, tests)
    counts, summary = folder / 'counts.json', folder / 'summary.json'
    run('gcovr', '--root', REPOSITORY, '--filter', REPOSITORY / 'src', '--filter', REPOSITORY / 'include',
        '--object-directory', folder, '--exclude-throw-branches', '--exclude-unreachable-branches', '-j', '2',
        '--json', counts, folder)
    merged = ('gcovr', '--root', REPOSITORY, '--add-tracefile', counts)
    run(*merged, '--txt', folder / 'lines.txt', '--json-summary', summary)
    run(*merged, '--branches', '--txt', folder / 'branches.txt')
    return json.loads(summary.read_text())


def executed(files, kind):
    """Returns the executed share of the lines or branches of files of a summary [%]."""
    return 100.0 * sum(file[f'{kind}_covered'] for file in files) / max(1, sum(file[f'{kind}_total'] for file in files))


def shares(files):
    """Returns the executed shares of lines and branches by folder, and of all files."""
    folders = {}
    for file in files:
        folders.setdefault(pathlib.Path(file['filename']).parts[1], []).append(file)
    return {name: (executed(part, 'line'), executed(part, 'branch'))
            for name, part in (*sorted(folders.items()), ('all', files))}


def main():
    """The program."""
    parser = argparse.ArgumentParser(prog='coverage', description=__doc__, epilog=EPILOG,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--folder', type=pathlib.Path, default=build_folder() / 'coverage',
                        help='for the build and the reports (default: coverage/ in the build folder)')
    parser.add_argument('--tests', type=pathlib.Path, default=programs_in(build_folder() / 'devel'),
                        help='folder of the unit tests (default: those of the build)')
    arguments = parser.parse_args()
    reached = shares(measure(arguments.folder.absolute(), arguments.tests.absolute())['files'])
    print(f"{'folder':<14}lines branches [%]")
    for name, (lines, branches) in reached.items():
        print(f'{name:<14}{lines:5.1f} {branches:8.1f}')
    return 0 if all(share >= least for share, least in zip(reached['all'], LEAST)) else 1
