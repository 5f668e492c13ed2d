"""scripts/sweep: training and evaluation over a grid of parameters and seeds."""
import os
import pathlib
import re
import signal
import subprocess

import pytest
import yaml
from crowd_drawing.errors import InputError
from crowd_experiments.variations import Setting
from crowd_report.figures import scene_of
from crowd_sweep.plan import EXAMPLES, label_of, plan
from crowd_sweep.sweep_file import read_sweep
from learning_files import config_text
from programs import (CIRCLE6, NEAREST_TABLE, PATIENCE, assert_says, in_package, page_text, read_text, tools_folder,
                      wait_for)

SWEEP = '''config: config.yaml
parameters: {learning.gamma: [0.1, 0.8], learning.alpha: 0.3}
seeds: [3, 5]
train: {episodes: %d}
evaluate: {scenarios: [circle6], episodes: 2, seed: 1000}
'''
TABLE_SWEEP = f'''q_table: {NEAREST_TABLE}
scenario_parameters: {{agents.*.radius: [0.2, 0.25]}}
seeds: 2
evaluate: {{scenarios: [circle6], episodes: 1, trajectories: false}}
'''


def command(runner, *arguments):
    """Returns the command line of the program with its results in the test's folder."""
    return [in_package('scripts', 'sweep'), *map(str, arguments), '--tools', tools_folder(), '--results',
            runner.path('results')]


def sweep(runner, *arguments):
    """Runs the program. Returns exit status and output."""
    done = subprocess.run(command(runner, *arguments), cwd=runner.folder, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, timeout=PATIENCE, check=False)
    return done.returncode, done.stdout.decode(errors='replace')


def write_sweep(runner, episodes=4):
    """Writes a sweep with its configuration. Returns its file."""
    runner.write('config.yaml', config_text(CIRCLE6, 6))
    return runner.write('grid.yaml', SWEEP % episodes)


def stamps(runner):
    """Returns when each run was completed, by its folder."""
    folder = pathlib.Path(runner.path('results/runs'))
    return {str(file.parent.relative_to(folder)): file.stat().st_mtime_ns for file in folder.glob('*/*/done.txt')}


class FileTest:
    """The file of a sweep."""

    def test_grid(self, runner):
        found = read_sweep(write_sweep(runner))
        assert found.combinations() == [({'learning.gamma': gamma, 'learning.alpha': 0.3}, {}) for gamma in (0.1, 0.8)]
        assert (found.seeds, found.train_episodes, found.episodes, found.evaluate_seed) == ([3, 5], 4, 2, 1000)
        assert str(found.scenarios[0]) == CIRCLE6
        assert str(found.config) == runner.path('config.yaml')

    def test_table(self, runner):
        found = read_sweep(runner.write('grid.yaml', TABLE_SWEEP))
        assert found.combinations() == [({}, {'agents.*.radius': radius}) for radius in (0.2, 0.25)]
        assert (found.seeds, found.config, found.evaluate_seed, found.trajectories) == ([1, 2], None, None, False)

    def test_labels(self):
        assert label_of({'learning.gamma': 0.9, 'learning.epsilon': {'from': 1, 'to': 0}}) == \
            'gamma=0.9 epsilon=from:1,to:0'
        assert label_of({'learning.epsilon': {'from': 0.3, 'to': 0.02, 'episodes': 500}}) == 'epsilon=0.3..0.02/500'
        assert label_of({}) == 'all'

    def test_equal_labels_are_refused(self, runner):
        """Runs with the same label would count as seeds of one combination."""
        setting = Setting(pathlib.Path(tools_folder()), pathlib.Path(in_package('config')), pathlib.Path(runner.folder))
        text = TABLE_SWEEP.replace('[0.2, 0.25]', "[0.2, '0.2']")
        with pytest.raises(InputError, match="grid.yaml: two combinations have the label 'radius=0.2'"):
            plan(read_sweep(runner.write('grid.yaml', text)), setting)

    def test_equal_keys_of_configuration_and_scenario(self, runner):
        """Both are in the label."""
        runner.write('config.yaml', config_text(CIRCLE6, 6))
        text = SWEEP % 4 + 'scenario_parameters: {learning.gamma: [7]}\n'
        setting = Setting(pathlib.Path(tools_folder()), pathlib.Path(in_package('config')), pathlib.Path(runner.folder))
        labels = [member.label for member in plan(read_sweep(runner.write('grid.yaml', text)), setting)]
        assert labels[0] == 'gamma=0.1 alpha=0.3 gamma=7'

    def test_examples(self, runner):
        """Those of --help and of docs/tools.md are read without an error."""
        shown = re.search(r'FILE.yaml:\n(.*?)\n\n', EXAMPLES, re.DOTALL)[1]
        on_page = re.search(r'```yaml\n(config.*?)```', page_text('tools.md'), re.DOTALL)[1]
        os.symlink(in_package('config'), runner.path('config'))
        for text in (shown, on_page):
            assert len(read_sweep(runner.write('grid.yaml', text)).combinations()) == 4

    @pytest.mark.parametrize('old, new, words', [
        ('seeds', 'seed', ["unknown key 'seed', did you mean 'seeds'? Known are config, q_table"]),
        ('config: config.yaml', 'config: other.yaml', ['config: there is no file', '/other.yaml']),
        ('config: config.yaml', 'x: 1', ["unknown key 'x'"]),
        ('config: config.yaml\n', '', ['expected either config or q_table']),
        ('config: config.yaml', f'q_table: {NEAREST_TABLE}', ['with q_table nothing is trained']),
        ('[0.1, 0.8]', '[]', ['parameters.learning.gamma: expected at least one value']),
        ('[0.1, 0.8]', '[0.5, 0.5]', ['parameters.learning.gamma: expected different values, got [0.5, 0.5]']),
        ('[3, 5]', '[3, 3]', ['seeds: expected a number of seeds, or a list of different ones, got [3, 3]']),
        ('[3, 5]', '0', ['seeds: expected a number of seeds']),
        ('episodes: 2', 'episodes: two', ["evaluate.episodes: expected a whole number from 1, got 'two'"]),
        ('[circle6]', '[circel6]', ["no scenario 'circel6', did you mean 'circle6'"]),
        ('scenarios: [circle6], ', '', ['evaluate.scenarios: expected a list of scenarios']),
        ('train: {episodes: 4}', 'train: {episode: 4}', ["train: unknown key 'episode', did you mean 'episodes'"]),
        ('seeds: [3, 5]', 'seeds: [3', ['not YAML']),
    ])
    def test_errors(self, runner, old, new, words):
        text = read_text(write_sweep(runner))
        assert old in text
        with pytest.raises(InputError) as caught:
            read_sweep(runner.write('grid.yaml', text.replace(old, new)))
        assert_says(str(caught.value), *words)


class ProgramTest:
    """The program, with real training and evaluation."""

    def test_a_grid(self, runner):
        """Two combinations with two seeds each. The second time nothing is run; with another number of episodes all."""
        status, output = sweep(runner, write_sweep(runner), '--jobs', 2)
        assert status == 0, output
        assert_says(output, '4 runs, 0 of them done before', 'results/report.html')
        page = read_text(runner.path('results/report.html'))
        assert_says(page, 'Sweep grid', 'gamma=0.1 alpha=0.3', 'gamma=0.8 alpha=0.3', 'Learning curves', 'Paths',
                    'Differences')
        before = stamps(runner)
        assert len(before) == 4
        config = yaml.safe_load(read_text(runner.path('results/configs/001_gamma=0.8_alpha=0.3.yaml')))
        assert (config['learning']['gamma'], config['learning']['alpha']) == (0.8, 0.3)
        status, output = sweep(runner, runner.path('grid.yaml'))
        assert_says(output, '4 runs, 4 of them done before')
        assert (status, stamps(runner)) == (0, before)
        status, output = sweep(runner, write_sweep(runner, episodes=5))
        assert_says(output, '4 runs, 0 of them done before')
        after = stamps(runner)
        assert set(after) == set(before) and all(after[name] > before[name] for name in before)

    def test_seeds_and_parameters_matter(self, runner):
        """The runs differ, and each is that of `train` with its seed."""
        sweep(runner, write_sweep(runner))
        folder = pathlib.Path(runner.path('results/runs'))
        tables = {str(file.parent.relative_to(folder)): file.read_bytes() for file in folder.glob('*/*/table.txt')}
        assert len(set(tables.values())) == 4
        config = runner.path('results/configs/000_gamma=0.1_alpha=0.3.yaml')
        runner.tool('train', config, '--seed', 5, '--episodes', 4, '--output', runner.path('t.txt'))
        assert tables['000_gamma=0.1_alpha=0.3/seed_5'] == pathlib.Path(runner.path('t.txt')).read_bytes()

    def test_scenarios_without_training(self, runner):
        status, output = sweep(runner, runner.write('grid.yaml', TABLE_SWEEP))
        assert status == 0, output
        assert_says(output, '4 runs')
        page = read_text(runner.path('results/report.html'))
        assert_says(page, 'radius=0.2', 'radius=0.25')
        assert 'Learning curves' not in page and 'Paths' not in page

    def test_varied_ticks_are_those_of_the_report(self, runner):
        """Each recording is measured in the scenario that it was made in."""
        text = TABLE_SWEEP.replace('agents.*.radius: [0.2, 0.25]', 'tick: [0.05, 0.1]')
        status, output = sweep(runner, runner.write('grid.yaml', text.replace(', trajectories: false', '')))
        assert status == 0, output
        files = sorted(pathlib.Path(runner.path('results/runs')).glob('*/seed_1/trajectories/*.csv'))
        assert [(file.name, scene_of(file).tick) for file in files] == [('circle6.csv', 0.05), ('circle6.csv', 0.1)]

    def test_dry_run(self, runner):
        status, output = sweep(runner, write_sweep(runner), '--dry-run')
        assert status == 0, output
        assert_says(output, '# gamma=0.1 alpha=0.3, seed 3', '--seed 5 --output table.txt', '--episodes 2 --csv')
        assert not os.path.exists(runner.path('results/runs'))

    def test_interrupted_and_continued(self, runner):
        """The first run is short, the others are long: what is done is kept."""
        runner.write('config.yaml', config_text(CIRCLE6, 6))
        text = (SWEEP % 1).replace('learning.gamma: [0.1, 0.8]', 'training.episodes: [1, 1000000]')
        file = runner.write('grid.yaml', text.replace('train: {episodes: 1}\n', '').replace('[3, 5]', '[3]'))
        process = runner.start('sweep', command(runner, file, '--jobs', '2'))
        wait_for(lambda: len(stamps(runner)) == 1, 'the first run')
        wait_for(lambda: list(pathlib.Path(runner.path('results/runs')).glob('*000000*/seed_3/learning.csv')),
                 'the second run to begin')
        process.signal(signal.SIGINT)
        assert process.wait() == 130
        assert_says(process.output(), 'Interrupted: 1 of 2 runs are done and kept')
        before = stamps(runner)
        assert len(before) == 1
        runner.write('grid.yaml', read_text(file).replace('[1, 1000000]', '[1, 2]'))
        status, output = sweep(runner, file)
        assert status == 0, output
        assert_says(output, '2 runs, 1 of them done before')
        assert stamps(runner)[next(iter(before))] == before[next(iter(before))]

    @pytest.mark.parametrize('old, new, words', [
        ('learning.alpha', 'learning.alfa', ['gamma=0.1 alfa=0.3: ', "unknown key 'alfa', did you mean 'alpha'"]),
        ('[0.1, 0.8]', '[0.1, 8]', ['gamma=8 alpha=0.3: ', 'learning.gamma: expected a number']),
    ])
    def test_a_wrong_configuration(self, runner, old, new, words):
        """It is found before the first run, also by --dry-run; the message is that of the program, and in one line."""
        runner.write('config.yaml', config_text(CIRCLE6, 6))
        file = runner.write('grid.yaml', (SWEEP % 4).replace(old, new))
        for options in ((), ('--dry-run',)):
            status, output = sweep(runner, file, *options)
            assert status == 1, output
            assert_says(output, 'sweep: ', 'grid.yaml: ', 'the configuration is refused: ', *words)
            lines = output.splitlines()
            assert lines[:-1] == [f'sweep: checking configuration {i} of 2' for i in range(1, len(lines))]
            assert not os.path.exists(runner.path('results/runs'))

    def test_scenarios_of_the_training_by_name(self, runner):
        runner.write('config.yaml', config_text('circle6', 1))
        file = runner.write('grid.yaml', SWEEP % 1)
        status, output = sweep(runner, file)
        assert status == 0, output

    def test_errors(self, runner):
        assert sweep(runner, 'none.yaml') == (1, 'sweep: none.yaml: No such file or directory\n')
        status, output = sweep(runner, write_sweep(runner), '--jobs', 0)
        assert (status, 'a whole number from 1' in output) == (2, True)
