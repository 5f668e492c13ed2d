"""docs/learning.md: the keys that a training configuration needs, and the configuration that it advises."""
import csv
import re
import subprocess

from learning_files import QTableFile
from programs import assert_says, page_examples


class LearningPageTest:
    """docs/learning.md: the keys that a training configuration needs, and the configuration that it advises."""

    def test_what_is_advised_arrives(self, runner):
        """The page says 100 %; the naive training configuration is read at least."""
        configs = page_examples('learning.md')
        config = runner.write('advised.yaml', configs['advised.yaml'])
        runner.tool('train', config, '--output', runner.path('table.txt'))
        runner.tool('evaluate', '--q-table', runner.path('table.txt'), '--episodes', 100, '--seed', 1000, '--csv',
                    runner.path('metrics.csv'), 'single_obstacle', 'circle12_varied')
        with open(runner.path('metrics.csv'), newline='', encoding='utf-8') as stream:
            rates = [(float(row['success_pct']), float(row['contact_pct'])) for row in csv.DictReader(stream)]
        assert rates == [(100.0, 0.0), (100.0, 0.0)]
        naive = runner.write('naive.yaml', configs['naive.yaml'])
        runner.tool('train', naive, '--output', runner.path('table.txt'), '--episodes', 1)

    def test_the_least_config_is_one(self, runner):
        text = page_examples('learning.md')['least.yaml']
        runner.tool('train', runner.write('least.yaml', text), '--output', runner.path('table.txt'), '--episodes', 1)
        assert QTableFile(runner.path('table.txt')).header['decisions'] > 0

    def test_none_of_its_keys_may_be_left_out(self, runner):
        text = page_examples('learning.md')['least.yaml']
        for key in ('state_set', 'action_set', 'reward', 'obstacle_cost', 'learning', 'scenarios', 'episodes'):
            less = re.sub(rf'^{key}:.*\n|(?<=[{{ ]){key}: [^,}}]*(, )?', '', text, flags=re.MULTILINE)
            assert less != text, key
            file = runner.write('less.yaml', less)
            done = subprocess.run(['rosrun', 'social_crowd', 'train', file, '--output', runner.path('no.txt')],
                                  stderr=subprocess.PIPE, stdin=subprocess.DEVNULL, check=False)
            assert done.returncode == 1, less
            assert_says(done.stderr.decode(), f"the key '{key}' is missing")
