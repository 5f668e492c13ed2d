"""Counts the instructions of small runs and compares them with stored counts, to detect slower code independently of
the machine's speed and load."""
import os
import pathlib
import re
import tempfile
import typing

import yaml
from crowd_experiments.arguments import add_tools, parser_of
from crowd_experiments.interruption import EXIT_FAILED, EXIT_FINE
from crowd_experiments.runs import RunError
from crowd_experiments.tools import REPOSITORY, find_tools

from .callgrind import collect, require_valgrind

KEPT = REPOSITORY / 'test' / 'data' / 'instruction_counts.yaml'
CONFIG = REPOSITORY / 'config'
BUILD_KIND = 'build_kind.txt'  # beside the tools: compiler, flags
TOLERANCE = 2.0  # [%]; repeated counts differ by less than a hundredth of this
VECTORS = ('avx2', 'fma')  # processor features by which libraries select their code
STATUSES = f'0 all differ by less than {TOLERANCE:g} %, 1 an error or a larger difference, 2 wrong usage.'
TOTAL = re.compile(r'^(?:summary|totals): (\d+)', re.MULTILINE)


class CountedRun(typing.NamedTuple):
    """A run of a tool, and the function within which instructions are counted, without the start of the program."""
    name: str
    function: str
    command: tuple

    def count(self, tools):
        # With the kernels for this processor, which valgrind chooses as well.
        environment = {name: value for name, value in os.environ.items() if name != 'SOCIAL_CROWD_SIMD'}
        with tempfile.TemporaryDirectory() as folder:
            output = collect(self.function, [tools / self.command[0], *self.command[1:]], folder, environment)
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
    """Returns a text with the compiler, its flags, and the processor features, on which the counts depend."""
    try:
        build = (tools / BUILD_KIND).read_text(encoding='utf-8')
    except OSError:
        raise RunError(f'{tools}: has no {BUILD_KIND}') from None
    processor = pathlib.Path('/proc/cpuinfo').read_text(encoding='utf-8')
    return ' '.join(build.split()) + ', ' + ' '.join(word for word in VECTORS if re.search(rf'\b{word}\b', processor))


def read_kept(file=KEPT):
    """Returns the stored {'kind': text, 'counts': {name: count}}."""
    return yaml.safe_load(pathlib.Path(file).read_text(encoding='utf-8'))


def write_kept(kind, counts, file=KEPT):
    text = ('# Instructions of small runs; scripts/count_instructions --keep writes this file.\n'
            + yaml.safe_dump({'kind': kind, 'counts': counts}, sort_keys=False, width=120))
    pathlib.Path(file).write_text(text, encoding='utf-8')


def change(count, kept):
    return 100.0 * (count - kept) / kept


def is_fine(count, kept):
    """Returns whether a count is within the tolerance. A much lower count is not: a later loss of half of the
    gain would not be detected."""
    return abs(change(count, kept)) <= TOLERANCE


def main(words=None):
    """Runs scripts/count_instructions with command line words. Returns the exit status."""
    parser = parser_of('count_instructions', 'Counts the instructions of small runs and compares them with those in '
                       f'{KEPT.name}.', 'example:\n  scripts/count_instructions', STATUSES)
    parser.add_argument('--keep', action='store_true', help='store these counts instead of comparing them')
    add_tools(parser)
    arguments = parser.parse_args(words)
    tools = find_tools(arguments.tools)
    require_valgrind(tools / RUNS[0].command[0])
    counts = {run.name: run.count(tools) for run in RUNS}
    kind = kind_of(tools)
    if arguments.keep:
        write_kept(kind, counts)
    kept = read_kept()
    if kind != kept['kind']:
        print(f"The counts are for '{kind}', the stored counts are for '{kept['kind']}'")
    for name, count in counts.items():
        stored = kept['counts'][name]
        print(f'{name:10} {count:>15,}  stored {stored:>15,}  {change(count, stored):+.2f} %')
    fine = kind == kept['kind'] and all(is_fine(count, kept['counts'][name]) for name, count in counts.items())
    return EXIT_FINE if fine else EXIT_FAILED
