"""The program `same_results`."""
import os
import pathlib
import re

from crowd_drawing.errors import InputError
from crowd_experiments.arguments import above_zero, add_tools, parser_of, positive
from crowd_experiments.runs import LOG, STAMP, Run, execute_left, output_of
from crowd_experiments.tools import REPOSITORY, build_folder, find_table, find_tools, programs_in

COMPILERS = ('g++ -O0', 'clang++ -O3 -DNDEBUG')
TABLES = ('anticipation', 'human', 'thesis_nearest')
CONFIG = REPOSITORY / 'config'
REFERENCE = 'reference'
EXAMPLE = '''Builds the program evaluate with each compiler, and walks an episode of all scenarios of the package with
several Q-tables. All files of results (trajectories, measures of agents and of robots) must have the same bytes as
those of the reference build. Prints the files that differ, each with its first line that does. Builds and results
are kept in the folder; later runs repeat only what has changed.

examples:
  research/same_results
  research/same_results --compiler 'clang++ -O1' --table human --scenario place_office'''


def build(compiler, folder):
    """Builds evaluate with a compiler and its flags. Returns the folder of the programs."""
    name, _, flags = compiler.partition(' ')
    commands = [['cmake', '-S', REPOSITORY, '-B', folder, '-DCMAKE_BUILD_TYPE=None', f'-DCMAKE_CXX_COMPILER={name}',
                 f'-DCMAKE_CXX_FLAGS={flags}', '-DPYTHON_EXECUTABLE=/usr/bin/python3', '-DCATKIN_ENABLE_TESTING=OFF'],
                ['cmake', '--build', folder, '--parallel', os.cpu_count(), '--target', 'evaluate']]
    print(f'Building with {compiler}', flush=True)
    for command in commands:
        output_of(command)
    return programs_in(folder / 'devel')


def shortened(text, seconds):
    """Returns a scenario file whose episodes end after some seconds; in units of the thesis, durations are in ticks."""
    if re.search(r'^units: *thesis', text, re.MULTILINE):
        return text
    return re.sub(r'^duration: *([\d.e+]+)', lambda found: f'duration: {min(float(found[1]), seconds):g}', text,
                  flags=re.MULTILINE)


def write_scenarios(folder, seconds):
    """Writes shortened copies of all scenarios, beside the files that they name. Returns their files."""
    files = sorted((CONFIG / 'scenarios').rglob('*.yaml'))
    copies = [folder / file.relative_to(CONFIG) for file in files]
    for file, copy in zip(files, copies):
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text(shortened(file.read_text(encoding='utf-8'), seconds), encoding='utf-8')
    for path in CONFIG.iterdir():
        if path.name != 'scenarios' and not (folder / path.name).exists():
            (folder / path.name).symlink_to(path)
    return copies


def plan(programs, folder, tables, scenarios):
    """Returns the runs of a build: a scenario with a Q-table each."""
    return [Run(folder / table / file.stem, [[
        programs / 'evaluate', '--q-table', find_table(table), '--episodes', 1, '--robot', 'reactive', '--threads', 1,
        '--trajectories', '.', '--record', 'agents.csv', '--robots-csv', 'robots.csv', file]])
        for table in tables for file in scenarios]


def results_in(folder):
    """Returns the contents of all files of results below a folder, by their names."""
    return {str(file.relative_to(folder)): file.read_bytes() for file in sorted(folder.rglob('*'))
            if file.is_file() and file.name not in (LOG, STAMP)}


def differences(reference, other):
    """Returns a line for each file whose bytes differ, or that only one of the builds has written."""
    lines = []
    for name in sorted({*reference, *other}):
        if name not in reference or name not in other:
            lines.append(f'{name}: written by one of the builds only')
        elif reference[name] != other[name]:
            ours, theirs = reference[name].split(b'\n'), other[name].split(b'\n')
            line = next((i for i, pair in enumerate(zip(ours, theirs), 1) if pair[0] != pair[1]),
                        min(len(ours), len(theirs)))
            lines.append(f'{name}: differs from line {line} on')
    return lines


def compare(reference, runs, compiler):
    """Prints what the runs of a compiler have in common with the reference. Returns whether all is the same."""
    different, total, size = [], 0, 0
    for one, other in zip(reference, runs):
        ours = results_in(one.folder)
        lines = differences(ours, results_in(other.folder))
        total, size = total + len(ours), size + sum(map(len, ours.values()))
        different += [f'  {one.folder.parent.name}/{one.folder.name}/{line}' for line in lines]
    print(f'{compiler}: {total - len(different)} of {total} files ({size / 1e6:.0f} MB) are the same', *different,
          sep='\n', flush=True)
    return not different


def main(words=None):
    """The program."""
    parser = parser_of('same_results', 'Compares the results of builds by other compilers.', EXAMPLE,
                       '0 all are the same, 1 results differ or another error, 2 wrong usage, 130 interrupted.')
    add = parser.add_argument
    add('--compiler', action='append', metavar="'NAME FLAGS'",
        help=f'can be repeated (default: {", ".join(map(repr, COMPILERS))})')
    add('--table', action='append', metavar='NAME', help=f'can be repeated (default: {", ".join(TABLES)})')
    add('--scenario', action='append', metavar='NAME', help='can be repeated (default: all)')
    add('--seconds', type=above_zero, default=60.0, help='episodes end then at the latest (default: %(default)s); '
        'those in units of the thesis after their own number of ticks')
    add('--processes', type=positive, default=os.cpu_count(), metavar='N',
        help='runs at a time (default: one per processor)')
    add('--folder', type=pathlib.Path, help='for builds and results (default: same_results/ in the build folder)')
    add_tools(parser, 'the reference build')
    arguments = parser.parse_args(words)
    folder = (arguments.folder or build_folder() / 'same_results').absolute()
    scenarios = [file for file in write_scenarios(folder / 'config', arguments.seconds)
                 if not arguments.scenario or file.stem in arguments.scenario]
    if len(scenarios) < len(set(arguments.scenario or [])):
        raise InputError(f"{', '.join(arguments.scenario)}: not all are scenarios of the package")
    compilers = arguments.compiler or COMPILERS
    programs = {REFERENCE: find_tools(arguments.tools)}
    for compiler in compilers:
        programs[compiler] = build(compiler, folder / 'build' / re.sub(r'\W+', '_', compiler))
    runs = {name: plan(path, folder / 'runs' / re.sub(r'\W+', '_', name), arguments.table or TABLES, scenarios)
            for name, path in programs.items()}
    execute_left([run for group in runs.values() for run in group], arguments.processes)
    return 0 if all([compare(runs[REFERENCE], runs[compiler], compiler) for compiler in compilers]) else 1
