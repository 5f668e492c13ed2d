"""docs/python.md: its examples, and the training of a policy in a short form."""
import csv
import os
import subprocess
import sys

import pytest
from page_commands import other_blocks
from programs import in_package, page_text

BLOCKS = [block for block in other_blocks(page_text('python.md')) if 'import' in block]
TRAINING = in_package('python', 'examples', 'train_policy.py')


def run(runner, *command):
    """Returns the output of a Python program in the folder of the package, which must succeed."""
    done = subprocess.run([sys.executable, *map(str, command)], cwd=runner.folder, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, check=False)
    assert done.returncode == 0, done.stdout.decode()
    return done.stdout.decode()


class PythonPageTest:
    """Everything on the page that can be run."""

    @pytest.mark.parametrize('number', range(len(BLOCKS)))
    def test_examples(self, runner, number):
        os.symlink(in_package('config'), runner.path('config'))
        run(runner, runner.write('example.py', BLOCKS[number]))

    def test_all_examples_are_found(self):
        assert len(BLOCKS) == 5

    def test_training_of_a_policy(self, runner):
        """The return grows within a few generations, and the same seed gives the same numbers."""
        short = ('--generations', 4, '--population', 12, '--episodes', 4, '--held-out', 6, '--every', 2, '--seed', 1)
        said = run(runner, TRAINING, *short, '--output', runner.path('policy'))
        assert 'reactive rule:' in said and 'policy: ' in said
        with open(runner.path('policy.csv'), newline='', encoding='utf-8') as stream:
            rows = list(csv.DictReader(stream))
        assert len(rows) == 4 and [row['clean'] != '' for row in rows] == [True, False, True, True]
        assert float(rows[-1]['mean_return']) > float(rows[0]['mean_return'])
        assert os.path.getsize(runner.path('policy.png')) > 10000
        run(runner, TRAINING, *short, '--threads', 1, '--output', runner.path('again'))
        with open(runner.path('policy.npy'), 'rb') as one, open(runner.path('again.npy'), 'rb') as other:
            assert one.read() == other.read()

    def test_help(self, runner):
        assert '--held-out' in run(runner, TRAINING, '--help')
