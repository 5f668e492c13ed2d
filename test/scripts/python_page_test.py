"""docs/python.md: its examples, and the training of a policy in a short form."""
import csv
import os
import re
import shutil
import subprocess
import sys

import numpy
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
        os.makedirs(runner.path('python/examples'))
        shutil.copy(TRAINING, runner.path('python/examples'))
        numpy.save(runner.path('policy.npy'), numpy.zeros(82))  # as many as an untrained policy has
        run(runner, runner.write('example.py', BLOCKS[number]))

    def test_all_examples_are_found(self):
        assert len(BLOCKS) == 5

    def test_training_of_a_policy(self, runner):
        """A few generations are better than no training."""
        said = run(runner, TRAINING, '--generations', 6, '--population', 16, '--episodes', 4, '--held-out', 10,
                   '--every', 3, '--seed', 1, '--threads', 1, '--output', runner.path('policy'))
        before, after = (float(re.search(f'{name}: (\\d+) % arrived', said).group(1))
                         for name in ('untrained', 'policy'))
        assert after >= before + 20
        with open(runner.path('policy.csv'), newline='', encoding='utf-8') as stream:
            assert [row['clean'] != '' for row in csv.DictReader(stream)] == [True, False, False, True, False, True]
        assert os.path.getsize(runner.path('policy.png')) > 10000

    @pytest.mark.parametrize('arguments, said', [
        (('--output', 'nowhere/policy'), "train_policy.py: [Errno 2] No such file or directory: 'nowhere/policy.npy'"),
        (('--scenario', 'robot_circle_5'), 'train_policy.py: robot_circle_5: the policy drives robots with drive:'),
        (('--scenario', 'robot_cirle_5'), "train_policy.py: no scenario 'robot_cirle_5'"),
        (('--generations', 0), '--generations: expected at least 1, got 0'),
    ])
    def test_wrong_arguments_are_refused_before_the_training(self, runner, arguments, said):
        done = subprocess.run([sys.executable, TRAINING, *map(str, arguments)], cwd=runner.folder, text=True,
                              stderr=subprocess.PIPE, check=False)
        assert done.returncode != 0 and said in done.stderr and 'Traceback' not in done.stderr

    def test_help(self, runner):
        assert '--held-out' in run(runner, TRAINING, '--help')
