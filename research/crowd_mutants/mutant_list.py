"""The list of mutants: changes of the sources of the core, each with the test that is to fail."""
import collections
import pathlib

import yaml
from crowd_drawing.errors import InputError
from crowd_experiments.tools import REPOSITORY

FILE = pathlib.Path(__file__).with_name('mutants.yaml')
# name; file in the repository; text that it has once, and what replaces it; executable of unit tests; which of them.
Mutant = collections.namedtuple('Mutant', 'name file before after binary test')


def read_mutants():
    """Returns the mutants of the list."""
    mutants = []
    for file, entries in yaml.safe_load(FILE.read_text()).items():
        for name, (before, after, test) in entries.items():
            binary, _, case = test.partition(' ')
            mutants.append(Mutant(name, file, str(before), str(after), binary, case))
    return mutants


def mutated(mutant, text):
    """Returns the text of its file with the change. Raises InputError unless the changed text is there once."""
    count = text.count(mutant.before)
    if count != 1 or mutant.before == mutant.after:
        raise InputError(f"{mutant.name}: {mutant.file} has '{mutant.before}' {count} times, expected once")
    return text.replace(mutant.before, mutant.after)


def check_mutants(mutants):
    """Raises InputError unless each name is unique, each change possible, and each named test exists."""
    twice = [name for name, count in collections.Counter(mutant.name for mutant in mutants).items() if count > 1]
    if twice:
        raise InputError(f"{', '.join(twice)}: there are several mutants of this name")
    tests = {}
    for mutant in mutants:
        mutated(mutant, (REPOSITORY / mutant.file).read_text())
        folder = REPOSITORY / 'test' / mutant.binary.removesuffix('_test')
        if folder not in tests:
            tests[folder] = '\n'.join(file.read_text() for file in sorted(folder.glob('*_test.cpp')))
        suite, _, case = mutant.test.partition('.')
        if not any(f'{kind}({suite}, {case})' in tests[folder] for kind in ('TEST', 'TEST_F', 'TEST_P')):
            raise InputError(f'{mutant.name}: {folder} has no test {mutant.test}')
