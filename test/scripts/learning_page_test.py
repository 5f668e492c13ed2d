"""Pages on learning: required keys of a training configuration, and the recommended configuration."""
import csv
import re
import subprocess

from learning_files import QTableFile
from programs import assert_says, page_examples


class LearningPageTest:
    """docs/learning.md."""

    def test_agents_arrive_with_the_recommended_configuration(self, runner):
        """The page states 100 %; the naive training configuration is only read."""
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

    def test_the_minimal_configuration_is_valid(self, runner):
        text = page_examples('learning.md')['least.yaml']
        runner.tool('train', runner.write('least.yaml', text), '--output', runner.path('table.txt'), '--episodes', 1)
        assert QTableFile(runner.path('table.txt')).header['decisions'] > 0

    def test_all_of_its_keys_are_required(self, runner):
        text = page_examples('learning.md')['least.yaml']
        for key in ('state_set', 'action_set', 'reward', 'obstacle_cost', 'learning', 'scenarios', 'episodes'):
            less = re.sub(rf'^{key}:.*\n|(?<=[{{ ]){key}: [^,}}]*(, )?', '', text, flags=re.MULTILINE)
            assert less != text, key
            file = runner.write('less.yaml', less)
            done = subprocess.run(['rosrun', 'social_crowd', 'train', file, '--output', runner.path('no.txt')],
                                  stderr=subprocess.PIPE, stdin=subprocess.DEVNULL, check=False)
            assert done.returncode == 1, less
            assert_says(done.stderr.decode(), f"the key '{key}' is missing")
