"""scripts/plot_learning: learning curves over several runs."""
import csv
import math
import os
import subprocess

import PIL.Image
import numpy
import pytest
from crowd_curves.program import band_of, default_window, measures_of, read_run, window_means
from crowd_drawing.errors import InputError
from crowd_experiments.records import bootstrap_difference, mean_interval, t_quantile
from learning_files import config_text
from programs import CIRCLE6, PATIENCE, assert_says, in_package

# Two agents in each of four episodes, of two scenarios in turn.
RECORD = '''episode,scenario,agent,arrived,touched,path_per_gain
0,one,0,0,1,nan
0,one,1,0,0,2
1,two,0,1,0,3
1,two,1,0,0,5
2,one,0,1,0,nan
2,one,1,1,0,nan
3,two,0,1,0,inf
3,two,1,1,0,nan
'''


def plot(runner, *arguments):
    """Runs the program in the test's folder. Returns exit status and output."""
    done = subprocess.run([in_package('scripts', 'plot_learning'), *map(str, arguments)], cwd=runner.folder,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=PATIENCE, check=False)
    return done.returncode, done.stdout.decode(errors='replace')


class ConfidenceTest:
    """Intervals, with numbers worked out by hand."""

    def test_mean(self):
        """1, 2, 3: the standard error is 1 / sqrt(3), and the quantile for 2 degrees of freedom is 4.302653."""
        assert mean_interval([1, 2, 3]) == pytest.approx((2, 2 - 4.302653 / 3**0.5, 2 + 4.302653 / 3**0.5))
        assert mean_interval([5])[0] == 5
        assert all(map(math.isnan, mean_interval([5])[1:] + mean_interval([])))

    def test_quantiles(self):
        """Those of tables."""
        assert [t_quantile(n) for n in (1, 30, 40, 100)] == pytest.approx([12.7062, 2.0423, 2.0211, 1.9840], abs=5e-5)

    def test_bootstrap(self):
        """Samples without spread differ by exactly 2; the interval of others contains their difference."""
        assert bootstrap_difference([1, 1, 1], [3, 3]) == (2, 2, 2)
        difference, low, high = bootstrap_difference([0, 1, 2, 3], [10, 11, 12, 13])
        assert difference == 10
        assert 8 < low < 10 < high < 12  # standard deviation of the difference: 0.79


class RecordTest:
    """Means over windows, and over runs."""

    def test_windows(self, runner):
        run = read_run('', runner.write('record.csv', RECORD))
        assert window_means(run, 'arrived', 1).tolist() == [0, 0.5, 1, 1]
        assert window_means(run, 'arrived', 2).tolist() == [0.25, 1]
        assert window_means(run, 'arrived', 3).tolist() == [0.5, 1]
        assert window_means(run, 'path_per_gain', 2)[0] == pytest.approx(10 / 3)
        assert numpy.isnan(window_means(run, 'path_per_gain', 2)[1])

    def test_one_scenario(self, runner):
        run = read_run('', runner.write('record.csv', RECORD), 'two')
        assert run.columns['arrived'].tolist() == [1, 0, 1, 1]

    def test_band(self, runner):
        """In the first window the runs have 0.25 and 0.75: a mean of 0.5, plus or minus 12.7062 x 0.25."""
        one = read_run('', runner.write('one.csv', RECORD))
        other = read_run('', runner.write('other.csv', 'episode,arrived\n0,1\n1,0.5\n'))
        band = band_of('', [one, other], 'arrived', 2)
        assert band.episodes.tolist() == [2, 4]
        assert (band.mean[0], band.low[0], band.high[0]) == pytest.approx((0.5, 0.5 - 3.176551, 0.5 + 3.176551))
        assert (band.mean[1], band.runs) == (1, 2)
        assert math.isnan(band.low[1])  # only one run has come so far
        percent = measures_of([one, other])[0]
        assert [values[0] for values in percent.shown(band)] == [50, 0, 100]

    def test_default_window(self, runner):
        text = 'episode,arrived\n' + ''.join(f'{episode},1\n' for episode in range(1000))
        assert default_window([read_run('', runner.write('long.csv', text))]) == 20
        assert default_window([read_run('', runner.write('record.csv', RECORD))]) == 1

    @pytest.mark.parametrize('text, words', [
        ('instance,tick,agent,x,y\n', ['r.csv:1: expected a record of `train --record`', "'episode'"]),
        ('', ['r.csv:1: expected a record']),
        ('episode,arrived\n0,1\n1\n', ['r.csv:3: expected 2 values, got 1']),
        ('episode,arrived\n0,yes\n', ["r.csv:2: expected a number in the column 'arrived'"]),
        ('episode,arrived\n', ['r.csv: has no rows']),
        ('episode,decisions\n0,120\n1,12', ['r.csv:3: the last line is not complete']),
    ])
    def test_errors(self, runner, text, words):
        with pytest.raises(InputError) as caught:
            read_run('', runner.write('r.csv', text))
        assert_says(str(caught.value), *words)

    @pytest.mark.parametrize('rest', ['1', '1,12', ''])
    def test_a_file_that_grows(self, runner, rest):
        """The training has not written its last row yet."""
        run = read_run('', runner.write('r.csv', 'episode,decisions\n0,120\n' + rest), grows=True)
        assert run.columns['decisions'].tolist() == [120]


class ProgramTest:
    """The program."""

    def test_records_of_train(self, runner):
        config = runner.write('config.yaml', config_text(CIRCLE6, 6))
        for seed in (1, 2):
            runner.tool('train', config, '--seed', seed, '--output', runner.path('table.txt'), '--record',
                        runner.path(f'r{seed}.csv'))
        status, output = plot(runner, 'mine=r1.csv', 'mine=r2.csv', 'single=r1.csv', '--output', 'curves.png')
        assert status == 0, output
        assert_says(output, 'the last 1 of the episodes', 'mine, success [%]: ', 'mine, decisions in an episode: ',
                    'single, contact [%]: ', '(one run)')
        with PIL.Image.open(runner.path('curves.png')) as picture:
            assert len(set(picture.convert('RGB').getdata())) > 100  # curves, bands and texts

    def test_logs_of_train(self, runner):
        """Rewards, visited rows and epsilon beside the rates; three seeds give no hint."""
        config = runner.write('config.yaml', config_text('single_obstacle, training_field', 40))
        files = [runner.path(f'l{seed}.csv') for seed in (1, 2, 3)]
        for seed, file in enumerate(files):
            runner.tool('train', config, '--seed', seed, '--output', runner.path('table.txt'), '--log', file)
        status, output = plot(runner, *files, '--output', 'curves.png', '--window', 40)
        assert status == 0, output
        with open(files[0], encoding='utf-8') as stream:
            rewards = [float(row['reward']) for row in csv.DictReader(stream)]
        means = [numpy.mean(read_run('', file).columns['reward']) for file in files]
        assert means[0] == pytest.approx(numpy.mean(rewards))
        assert_says(output, 'success [%]: ', 'contact [%]: ', 'collision [%]: ', f'reward: {numpy.mean(means):.4g} (',
                    'visited rows: ', 'epsilon: 0.3 (0.3 to 0.3)',
                    'plot_learning: curves are means over 2 scenarios (single_obstacle, training_field)')
        assert 'the band of two runs' not in output
        with PIL.Image.open(runner.path('curves.png')) as picture:
            assert len(set(picture.convert('RGB').getdata())) > 100

    def test_several_scenarios(self, runner):
        """They are not mixed without a word."""
        for name in ('a.csv', 'b.csv'):
            runner.write(name, RECORD)
        status, output = plot(runner, 'x=a.csv', 'x=b.csv', '--output', 'a.svg', '--window', 4)
        assert status == 0, output
        assert_says(output, 'x, success [%]: 62.5', 'curves are means over 2 scenarios (one, two): choose one with '
                    '--scenario', '--each-scenario', 'the band of two runs is 12.7 standard errors wide')
        status, output = plot(runner, 'x=a.csv', 'x=b.csv', 'x=b.csv', '--output', 'a.svg', '--window', 4,
                              '--each-scenario')
        assert status == 0, output
        assert_says(output, 'x one, contact [%]: 25', 'x two, contact [%]: 0')
        assert 'plot_learning:' not in output
        status, output = plot(runner, 'x=a.csv', '--output', 'a.svg', '--scenario', 'two')
        assert status == 0, output
        assert 'plot_learning:' not in output

    def test_folders_of_sweeps(self, runner):
        """Signs in the names of folders end no label; the file may be relative or missing."""
        os.mkdir(runner.path('000_gamma=0.1'))
        runner.write('000_gamma=0.1/learning.csv', RECORD)
        for word in ('000_gamma=0.1/learning.csv', runner.path('000_gamma=0.1/learning.csv'),
                     'one=000_gamma=0.1/learning.csv'):
            status, output = plot(runner, word, '--output', 'curves.png')
            assert status == 0, output
            assert ('  one, ' in output) == word.startswith('one')
        status, output = plot(runner, 'runs/000_gamma=0.1/none.csv', '--output', 'curves.png')
        assert status == 1
        assert_says(output, 'plot_learning: runs/000_gamma=0.1/none.csv: No such file')

    def test_further_columns(self, runner):
        """Columns of other programs are drawn as they are called."""
        runner.write('r.csv', 'episode,arrived,reward,pauses\n0,1,-3.5,2\n1,1,-2.5,4\n')
        status, output = plot(runner, 'r.csv', '--output', 'a.svg', '--columns', 'pauses,reward', '--window', 2)
        assert status == 0, output
        assert_says(output, 'pauses: 3 (one run)', 'reward: -3 (one run)')
        assert 'success' not in output
        status, output = plot(runner, 'r.csv', '--output', 'a.svg')
        assert_says(output, 'success [%]: 100', 'reward: -2.5')

    @pytest.mark.parametrize('status, arguments, words', [
        (2, ['record.csv'], ['--output']),
        (2, ['record.csv', '--output', 'a.png', '--window', '0'], ['--window', 'a whole number from 1']),
        (1, ['record.csv', '--output', 'a.png', '--window', '5'],
         ['--window: expected at most 4, the number of episodes, got 5']),
        (2, ['record.csv', '--output', 'a.png', '--scenario', 'one', '--each-scenario'], ['not allowed with']),
        (1, ['none.csv', '--output', 'a.png'], ['none.csv: No such file']),
        (1, ['record.csv', '--output', 'a.png', '--columns', 'speed'], ["has no column 'speed'; there are episode, "]),
        (1, ['record.csv', '--output', 'a.png', '--scenario', 'six'], ["no rows of a scenario 'six'", 'one, two']),
        (1, ['record.csv', '--output', 'a.xyz'], ['xyz', 'png']),
    ])
    def test_errors(self, runner, status, arguments, words):
        runner.write('record.csv', RECORD)
        got, output = plot(runner, *arguments)
        assert got == status, output
        assert_says(output, *words)
        assert 'Traceback' not in output
        assert os.listdir(runner.folder) == ['record.csv']
