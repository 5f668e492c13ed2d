"""Valgrind's callgrind, which counts instructions: profiles with the shares of functions."""
import pathlib
import re
import shutil
import subprocess
import tempfile
import typing

import pandas
from crowd_experiments.runs import RunError, output_of

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
