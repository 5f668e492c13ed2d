"""Counts the instructions of small runs and compares them with those that are kept: a guard against slow code that does
not depend on the machine's speed or load."""
import argparse
import dataclasses
import pathlib
import re
import subprocess
import sys
import tempfile

import yaml

from crowd_experiments.program import EXIT_FAILED, EXIT_FINE, REPOSITORY, find_tools
from crowd_experiments.runs import RunError

from .callgrind import COLLECT, require_valgrind

KEPT = REPOSITORY / 'test' / 'data' / 'instruction_counts.yaml'
CONFIG = REPOSITORY / 'config'
BUILD_KIND = 'build_kind.txt'  # beside the tools: compiler, flags
TOLERANCE = 2.0  # [%]; what is counted twice differs by less than a hundredth of that
VECTORS = ('avx2', 'fma')  # of the processor, by which libraries choose what they run
TOTAL = re.compile(r'^(?:summary|totals): (\d+)', re.MULTILINE)


@dataclasses.dataclass(frozen=True)
class CountedRun:
    """A run of a tool, and the function within which instructions count: not what it takes to start."""
    name: str
    function: str
    command: tuple

    def count(self, tools):
        """Instructions."""
        with tempfile.TemporaryDirectory() as folder:
            output = pathlib.Path(folder) / 'callgrind.out'
            command = [*COLLECT, f'--toggle-collect={self.function}', f'--callgrind-out-file={output}',
                       tools / self.command[0], *self.command[1:]]
            done = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                  check=False)
            if done.returncode != 0:
                raise RunError(f'{self.name} failed:\n{done.stdout}')
            count = sum(map(int, TOTAL.findall(output.read_text(encoding='utf-8'))[:1]))
        if count == 0:
            raise RunError(f'{self.name}: {self.function} was never entered')
        return count


RUNS = (
    CountedRun('evaluate', 'crowd::evaluate(*)', (
        'evaluate', '--q-table', CONFIG / 'q_tables' / 'anticipation.txt', '--threads', '1', '--episodes', '2',
        CONFIG / 'scenarios' / 'circle12.yaml')),
    CountedRun('train', 'crowd::Training::runNextTurn()', (
        'train', CONFIG / 'learning' / 'thesis_occupancy.yaml', '--output', 'table.txt', '--threads', '1',
        '--episodes', '30')),
)


def kind_of(tools):
    """What counts depend on beside the code: compiler, flags, and what the processor can do."""
    try:
        build = (tools / BUILD_KIND).read_text(encoding='utf-8')
    except OSError:
        raise RunError(f'{tools}: has no {BUILD_KIND}') from None
    processor = pathlib.Path('/proc/cpuinfo').read_text(encoding='utf-8')
    return ' '.join(build.split()) + ', ' + ' '.join(word for word in VECTORS if re.search(rf'\b{word}\b', processor))


def read_kept(file=KEPT):
    """{'kind': text, 'counts': {name: count}}"""
    return yaml.safe_load(pathlib.Path(file).read_text(encoding='utf-8'))


def write_kept(kind, counts, file=KEPT):
    text = ('# Instructions of small runs; scripts/count_instructions --keep writes this file.\n'
            + yaml.safe_dump({'kind': kind, 'counts': counts}, sort_keys=False, width=120))
    pathlib.Path(file).write_text(text, encoding='utf-8')


def change(count, kept):
    """By how much a count differs from the one that is kept [%]."""
    return 100.0 * (count - kept) / kept


def is_fine(count, kept):
    """A count far below the one that is kept is not: it would hide that half of the gain is lost again."""
    return abs(change(count, kept)) <= TOLERANCE


def main(words=None):
    """The command line of scripts/count_instructions; returns the exit status."""
    parser = argparse.ArgumentParser(
        prog='count_instructions',
        description=f'Counts the instructions of small runs and compares them with those in {KEPT.name}. Exit status: '
                    f'0 all differ by less than {TOLERANCE:g} %%, 1 otherwise.')
    parser.add_argument('--keep', action='store_true', help='keep these counts instead of comparing')
    parser.add_argument('--tools', type=pathlib.Path, metavar='FOLDER', help='of train and evaluate')
    arguments = parser.parse_args(words)
    try:
        require_valgrind()
        tools = find_tools(arguments.tools)
        counts = {run.name: run.count(tools) for run in RUNS}
        kind = kind_of(tools)
        if arguments.keep:
            write_kept(kind, counts)
        return compare(kind, counts)
    except (RunError, OSError) as error:
        print(f'count_instructions: {error}', file=sys.stderr)
        return EXIT_FAILED


def compare(kind, counts):
    """Prints counts beside those that are kept; the exit status."""
    kept = read_kept()
    if kind != kept['kind']:
        print(f"These are counts of '{kind}', those that are kept are of '{kept['kind']}'")
    for name, count in counts.items():
        print(f"{name:10} {count:>15,}  kept {kept['counts'][name]:>15,}  {change(count, kept['counts'][name]):+.2f} %")
    fine = kind == kept['kind'] and all(is_fine(count, kept['counts'][name]) for name, count in counts.items())
    return EXIT_FINE if fine else EXIT_FAILED
