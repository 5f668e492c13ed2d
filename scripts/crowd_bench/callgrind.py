"""Valgrind's callgrind, which counts instructions."""
import pathlib
import re
import shutil
import subprocess

from crowd_experiments.runs import RunError

# What valgrind prints of an instruction that it does not emulate, and the innermost function that contains it.
UNKNOWN_INSTRUCTION = re.compile(r'unhandled instruction bytes: .*|Unrecognised instruction at address .*')
INNERMOST = re.compile(r'Unrecognised instruction at address .*\n==\d+== +at 0x\w+: (.*)')


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
    run(['valgrind', '--tool=callgrind', '--collect-atstart=no', '--quiet', f'--toggle-collect={function}',
         f'--callgrind-out-file={output}', *command], folder, environment)
    return output


def run(command, folder, environment=None):
    """Runs a program. Returns its output."""
    done = subprocess.run(list(map(str, command)), cwd=folder, env=environment, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        raise RunError(f"{' '.join(map(str, command))} failed:\n{done.stdout}{done.stderr}")
    return done.stdout
