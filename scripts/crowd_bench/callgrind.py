"""Valgrind's callgrind, which counts instructions: of small runs, compared with stored counts, to detect slower code
independently of the machine's speed and load; and of functions, for profiles."""
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import typing

import pandas
import yaml
from crowd_experiments.arguments import add_tools, parser_of
from crowd_experiments.interruption import EXIT_FAILED, EXIT_FINE
from crowd_experiments.runs import RunError, output_of
from crowd_experiments.tools import REPOSITORY, find_tools

from .core_benchmarks import PROGRAM, filter_of

# What valgrind prints of an instruction that it does not emulate, and the innermost function that contains it.
UNKNOWN_INSTRUCTION = re.compile(r'unhandled instruction bytes: .*|Unrecognised instruction at address .*')
INNERMOST = re.compile(r'Unrecognised instruction at address .*\n==\d+== +at 0x\w+: (.*)')
MOST_LINES, LEAST_SHARE = 12, 0.5  # of a table; [%]
LINE = re.compile(r'^\s*[\d,]+ \(\s*([\d.]+)%\)\s+(?:\S*?:)?(.+?)(?: \[.*\])?$')
LIBRARIES = 'mathematics, memory, the standard library'
ARGUMENTS = re.compile(r'\(.*$')


def why_not(program):
    """Returns why valgrind cannot run a program here, as with an instruction that it does not emulate; or ''."""
    if shutil.which('valgrind') is None:
        return 'there is no valgrind, see scripts/install_dependencies'
    done = subprocess.run(['valgrind', '--tool=none', program, '--help'], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, errors='replace', check=False)
    if done.returncode == 0:
        return ''
    return f'valgrind cannot start {pathlib.Path(program).name} on this processor: {cause_in(done.stdout)}'


def cause_in(output):
    """Returns what valgrind prints of an instruction that it does not emulate, else the last line."""
    causes = [match[0] for match in [UNKNOWN_INSTRUCTION.search(output)] if match]
    causes += [f'in {match[1]}' for match in [INNERMOST.search(output)] if match]
    return ' '.join(causes) or (output.strip().splitlines() or ['it printed nothing'])[-1]


def require_valgrind(program):
    """Throws RunError with the reason if valgrind cannot run a program here."""
    reason = why_not(program)
    if reason:
        raise RunError(reason)


def collect(function, command, folder, environment=None):
    """Counts instructions within a function while a command runs. Returns the file of the counts."""
    output = pathlib.Path(folder) / 'callgrind.out'
    output_of(['valgrind', '--tool=callgrind', '--collect-atstart=no', '--quiet', f'--toggle-collect={function}',
               f'--callgrind-out-file={output}', *command], cwd=folder, env=environment)
    return output


class Profile(typing.NamedTuple):
    """A benchmark that is run once, and the function of it that is profiled."""
    name: str
    title: str
    benchmark: str
    function: str
    by_class: bool = False  # sums by class, for many small functions

    def measure(self, measuring):
        """Returns header and rows of the table of the functions or classes with the largest shares; no picture."""
        require_valgrind(measuring.folder / PROGRAM)
        with tempfile.TemporaryDirectory() as scratch:
            output = collect(self.function, [measuring.folder / PROGRAM, filter_of(self.benchmark),
                                             '--benchmark_min_time=0'], scratch)
            shares = read_annotation(output_of(['callgrind_annotate', '--threshold=100', output], cwd=scratch))
        header = ['class' if self.by_class else 'function', '% of all instructions']
        return header, rows(by_class(shares) if self.by_class else shares), None


def read_annotation(text):
    """Returns [(function, share)] from the output of callgrind_annotate."""
    matches = [match for line in text.splitlines() if 'PROGRAM TOTALS' not in line and (match := LINE.match(line))]
    if not matches:
        raise RunError('callgrind has counted nothing: the profiled function was not called')
    return summed((ARGUMENTS.sub('', match[2].replace('(anonymous namespace)::', '')), float(match[1]))
                  for match in matches)


def by_class(shares):
    return summed((name.rpartition('::')[0] if name.startswith('crowd::') else LIBRARIES, share)
                  for name, share in shares)


def summed(shares):
    """Returns the sums of shares of the same name, the largest first."""
    sums = pandas.DataFrame(shares, columns=['name', 'share']).groupby('name', sort=False)['share'].sum()
    return list(sums.sort_values(ascending=False, kind='stable').items())


def rows(shares):
    shown = [(name, share) for name, share in shares[:MOST_LINES] if share >= LEAST_SHARE]
    others = 100.0 - sum(share for _, share in shown)
    return [[name if name == LIBRARIES else f'`{name}`', f'{share:.1f}'] for name, share in shown] + [
        ['all others', f'{max(0.0, others):.1f}']]


PROFILES = (
    Profile('profile_crowd_step', 'crowd step, 1,000 agents', 'crowd_step_agents/1000', 'crowd::CrowdWalk::step()'),
    Profile('profile_training', 'training, thesis set 2, one obstacle', 'train_occupancy',
            'crowd::Training::runNextTurn()', by_class=True),
)


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
        'train', CONFIG / 'learning' / 'thesis_occupancy_field.yaml', '--output', 'table.txt', '--threads', '1',
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
    text = ('# Instructions of small runs; research/count_instructions --keep writes this file.\n'
            + yaml.safe_dump({'kind': kind, 'counts': counts}, sort_keys=False, width=120))
    pathlib.Path(file).write_text(text, encoding='utf-8')


def change(count, kept):
    return 100.0 * (count - kept) / kept


def is_fine(count, kept):
    """Returns whether a count is within the tolerance. A much lower count is not: a later loss of half of the
    gain would not be detected."""
    return abs(change(count, kept)) <= TOLERANCE


def main(words=None):
    """Runs research/count_instructions with command line words. Returns the exit status."""
    parser = parser_of('count_instructions', 'Counts the instructions of small runs and compares them with those in '
                       f'{KEPT.name}.', 'example:\n  research/count_instructions', STATUSES)
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
