"""scripts/report: a page with the results of runs."""
import base64
import html.parser
import io
import math
import os
import pathlib
import re
import subprocess

import PIL.Image
import numpy
import pytest
from crowd_drawing.errors import InputError
from crowd_report.figures import scenario_of, scene_of, separations, speed_by_density, speeds_and_densities, tracks_of
from crowd_report.tables import (METRICS, RECORD, ROBOTS, comparison_rows, metrics_rows, of_kind, robot_field_rows,
                                 robot_rows, samples, source_of)
from learning_files import config_text
from programs import ANTICIPATION_TABLE, CIRCLE6, NEAREST_TABLE, PATIENCE, assert_says, in_package, page_text, read_text

METRICS_FILE = '''scenario,instances,success_pct,contact_pct,collision_pct,path_ratio,time_ratio,turn_rad_per_m
one,2,%s,0,50,1.25,1.5,2
'''
ROBOTS_FILE = '''episode,scenario,robot,success,timeout,spl,time_to_reach_goal,people_contacts
0,hall,tug,1,0,0.9,20,0
1,hall,tug,1,0,0.7,22,3
2,hall,tug,0,1,0,nan,0
'''
RECORD_FILE = '''episode,scenario,agent,arrived,touched,path_ratio
0,one,0,1,0,1.5
0,one,1,%s,0,nan
1,one,0,1,1,2
1,one,1,1,0,4
1,one,2,0,0,90
'''


class Page(html.parser.HTMLParser):
    """The tags of a page; void ones need no end."""

    def __init__(self, text):
        super().__init__()
        self.open, self.links, self.texts = [], [], []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attrs):
        self.links += [value for name, value in attrs if name in ('src', 'href')]
        if tag not in ('img', 'meta', 'br'):
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.texts.append(data.strip())


def report(runner, *arguments):
    """Runs the program in the test's folder. Returns exit status and output."""
    done = subprocess.run([in_package('scripts', 'report'), *map(str, arguments)], cwd=runner.folder,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=PATIENCE, check=False)
    return done.returncode, done.stdout.decode(errors='replace')


def track_of(*places):
    """Returns a track of people who stand at places, or walk from one place to another."""
    return numpy.array(places, dtype=float).transpose(1, 0, 2)


class CrowdingTest:
    """Separation, speed and density, worked out by hand."""

    def test_nearest(self):
        """People at 0, 1 and 3 m in a line: 1, 1 and 2 m to the nearest. Of ticks of 0.25 s every second one counts."""
        track = track_of(*[[(x, 0)] * 3 for x in (0, 1, 3)])
        assert separations(track, 0.25).tolist() == [1, 1, 2] * 2

    def test_who_is_not_there_is_not_near(self):
        nowhere = (math.nan, math.nan)
        track = track_of([(0, 0), (0, 0)], [(3, 4), (3, 4)], [nowhere, (1, 0)])
        assert separations(track, 0.5).tolist() == [5, 5, 1, math.hypot(2, 4), 1]
        assert len(separations(track[:, :1], 0.5)) == 0

    def test_speed_and_density(self):
        """Both walk 1.5 m in a second; in its middle they are 1.5 m from each other: two people in a disc of 2 m. A
        third one, who stands, is 2.25 m from the nearer one, so alone."""
        walks = [[(1.5 * tick / 2, 0) for tick in range(3)], [(1.5 * tick / 2, 1.5) for tick in range(3)], [(3, 0)] * 3]
        speeds, densities = speeds_and_densities(track_of(*walks), 0.5)
        assert speeds == pytest.approx([1.5, 1.5, 0])
        assert densities == pytest.approx([2 / (4 * math.pi), 2 / (4 * math.pi), 1 / (4 * math.pi)])

    def test_only_those_who_are_there_for_a_second(self):
        track = track_of([(0, 0)] * 3, [(math.nan, math.nan), (1, 0), (1, 0)])
        speeds, densities = speeds_and_densities(track, 0.5)
        assert (speeds.tolist(), densities.tolist()) == ([0], [2 / (4 * math.pi)])
        assert [len(values) for values in speeds_and_densities(track[:2], 0.5)] == [0, 0]

    def test_speed_by_density(self):
        points = speed_by_density(numpy.array([1, 3, 5, 7.0]), numpy.array([0.5, 0.5, 0.5, 1]), least=2)
        assert points.tolist() == [[0.5, 3, pytest.approx((8 / 3)**0.5)]]


class TableTest:
    """Tables of metrics and of differences."""

    def sources(self, runner, text, **values):
        """Writes a file for each value, and returns its sources by label."""
        found = [source_of(f'{label}={runner.write(f"{label}_{i}.csv", text % value)}')
                 for label, list_of_values in values.items() for i, value in enumerate(list_of_values)]
        return of_kind(found, found[0].kind)

    def test_metrics(self, runner):
        """90, 100 and 95: mean 95, standard error 5 / sqrt(3), times 4.303."""
        header, rows = metrics_rows(self.sources(runner, METRICS_FILE, a=(90, 100, 95), b=(80,)))
        assert header[:4] == ['', 'scenario', 'runs', 'success [%]']
        assert rows[0][:5] == ['a', 'one', '3', '95.0 ± 12.4', '0.0 ± 0.0']
        assert rows[1] == ['b', 'one', '1', '80.0', '0.0', '50.0', '1.250', '1.500', '2.00', '-']

    def test_robots(self, runner):
        """Success 100, 100 and 0: mean 66.7, standard error 33.3, times 4.303. SPL 0.9, 0.7, 0: 0.533, 0.2729. Time of
        the two that arrived: 21, 1, times 12.71."""
        groups = self.sources(runner, ROBOTS_FILE.replace('%', '%%'), a=((),))
        assert list(groups['a'])[0].kind == ROBOTS
        header, rows = robot_rows(groups)
        assert header[:7] == ['', 'scenario', 'robot', 'episodes', 'success [%]', 'SPL', 'STL']
        assert rows == [['a', 'hall', 'tug', '3', '66.7 ± 143.4', '0.53 ± 1.17', '-', '21.0 ± 12.7', '-', '1.00 ± 4.30',
                         *['-'] * (len(header) - 10)]]

    def test_robot_fields(self, runner):
        """All numbers of the record. Of one episode there is no interval."""
        groups = self.sources(runner, ROBOTS_FILE.replace('%', '%%'), a=((),))
        groups['b'] = [groups['a'][0]._replace(file=runner.write('b.csv', ROBOTS_FILE[:ROBOTS_FILE.index('1,hall')]))]
        header, rows = robot_field_rows(groups)
        assert header == ['field', 'a', 'b']
        assert [row[0] for row in rows] == ['success', 'timeout', 'spl', 'time_to_reach_goal', 'people_contacts']
        assert rows[2] == ['spl', '0.533 ± 1.174', '0.900']
        assert rows[4] == ['people_contacts', '1.000 ± 4.303', '0.000']

    def test_samples(self, runner):
        """Of one file: the episodes. Of several: the files. Values that are not finite are left out."""
        groups = self.sources(runner, RECORD_FILE, a=(0,), b=(0, 1))
        assert samples(groups['a'], 'one', 'arrived') == [0.5, pytest.approx(2 / 3)]
        assert samples(groups['a'], 'one', 'path_ratio') == [1.5, 3]  # of those who have arrived
        assert samples(groups['b'], 'one', 'arrived') == pytest.approx([7 / 12, 5 / 6])
        assert samples(groups['a'], 'two', 'arrived') == []

    def test_comparison(self, runner):
        groups = self.sources(runner, RECORD_FILE, a=(1, 1, 1), b=(0, 0, 0), c=(1,))
        header, rows = comparison_rows(groups)
        assert header[3:] == ['a', 'this', 'difference', '95 % interval', 'differs']
        assert rows[0] == ['b', 'one', 'success [%]', '83.3', '58.3', '-25.0', '-25.0 to -25.0', 'yes']
        assert rows[1] == ['b', 'one', 'contact [%]', '16.7', '16.7', '+0.0', '+0.0 to +0.0', 'no']
        assert [row[0] for row in rows] == ['b'] * 3 + ['c'] * 3

    def test_sources(self, runner):
        os.mkdir(runner.path('small'))
        file = runner.write('small/r.csv', RECORD_FILE % 1)
        assert (source_of(file).label, source_of(file).kind) == ('small', RECORD)
        assert source_of(f'large={file}').label == 'large'
        swept = '000_gamma=0.1_alpha=0.3/r.csv'  # a folder of `sweep`
        os.mkdir(runner.path(os.path.dirname(swept)))
        file = runner.write(swept, RECORD_FILE % 1)
        assert (source_of(file).label, str(source_of(file).file)) == ('000_gamma=0.1_alpha=0.3', file)
        assert (source_of(f'b={file}').label, str(source_of(f'b={file}').file)) == ('b', file)
        assert source_of(runner.write('m.csv', METRICS_FILE % 1)).kind == METRICS
        with pytest.raises(InputError, match='x.csv:1: expected one of the headers scenario,instances'):
            source_of(runner.write('x.csv', 'a,b\n'))


class ProgramTest:
    """The program."""

    def walk(self, runner):
        """Evaluates two tables, and trains one. Returns the files."""
        for label, table in (('nearest', NEAREST_TABLE), ('anticipation', ANTICIPATION_TABLE)):
            folder = runner.path(label)
            os.mkdir(folder)
            runner.tool('evaluate', '--q-table', table, '--episodes', 2, '--csv', f'{folder}/metrics.csv', '--record',
                        f'{folder}/record.csv', '--trajectories', folder, CIRCLE6)
        config = runner.write('config.yaml', config_text(CIRCLE6, 4))
        runner.tool('train', config, '--output', runner.path('t.txt'), '--record', runner.path('learning.csv'))
        return [f'{label}/{name}.csv' for label in ('nearest', 'anticipation')
                for name in ('metrics', 'record', 'circle6')]

    def test_a_page_of_real_runs(self, runner):
        status, output = report(runner, *self.walk(runner), '--training', 'mine=learning.csv', '--title', 'A & B',
                                '--output', 'report.html')
        assert status == 0, output
        page = Page(read_text(runner.path('report.html')))
        assert page.open == []
        for text in ('A & B', '7 files of nearest, anticipation, mine.', 'Metrics', 'Comparison', 'Learning curves',
                     'Paths', 'Separation, and speed against density', 'success [%]'):
            assert text in page.texts, text
        pictures = [link for link in page.links if not link.startswith('#')]
        assert len(pictures) == 4
        for picture in pictures:  # in the page itself: it needs no other file
            assert picture.startswith('data:image/png;base64,')
            with PIL.Image.open(io.BytesIO(base64.b64decode(picture.partition(',')[2]))) as opened:
                assert min(opened.size) > 200
        assert not re.search(r'https?:|<script|url\(', read_text(runner.path('report.html')))

    def test_logs_are_learning_curves(self, runner):
        """Beside records, which have other columns."""
        config = runner.write('config.yaml', config_text(CIRCLE6, 4))
        runner.tool('train', config, '--output', runner.path('t.txt'), '--log', runner.path('log.csv'), '--record',
                    runner.path('record.csv'))
        status, output = report(runner, 'mine=log.csv', '--training', 'mine=record.csv', '--output', 'report.html')
        assert status == 0, output
        page = Page(read_text(runner.path('report.html')))
        assert 'Learning curves' in page.texts and 'Comparison' not in page.texts
        assert len([link for link in page.links if link.startswith('data:image/png')]) == 2

    def test_only_some_files(self, runner):
        runner.write('m.csv', METRICS_FILE % 90)
        status, output = report(runner, 'one=m.csv', '--output', 'report.html')
        assert status == 0, output
        page = Page(read_text(runner.path('report.html')))
        assert 'Metrics' in page.texts and 'Paths' not in page.texts

    def test_people_filmed_or_without_a_scenario(self, runner):
        """The scenario is found by the name of the file; without one, only paths are drawn."""
        rows = ''.join(f'0,{tick},{agent},{tick / 10},{agent}\n' for tick in range(60) for agent in range(3))
        runner.write('street.csv', 'instance,tick,agent,x,y\n' + rows)
        status, output = report(runner, 'people=street.csv', '--output', 'report.html')
        assert status == 0, output
        assert 'Scenario unknown, a tick of 0.1 s assumed: street.csv.' in \
            ' '.join(Page(read_text(runner.path('report.html'))).texts)

    def test_the_scenario_beside_a_recording(self, runner, monkeypatch):
        """It comes before the package's, whose tick is 0.1 s; a folder of this name is no scenario."""
        os.mkdir(runner.path('circle6'))
        file = pathlib.Path(runner.write('circle6.csv', 'instance,tick,agent,x,y\n0,0,0,0,0\n'))
        monkeypatch.chdir(runner.folder)
        assert (str(scenario_of(file)), len(scene_of(file).agents)) == (CIRCLE6, 6)
        runner.write('circle6.yaml', 'tick: 0.05\n')
        assert (scenario_of(file), scene_of(file).tick) == (file.with_suffix('.yaml'), 0.05)
        assert [tick for _, tick in tracks_of([source_of(str(file))])] == [0.05]
        runner.write('circle6.yaml', 'tick: slow\n')
        with pytest.raises(InputError, match='circle6.yaml: document 1: tick: expected a number'):
            scene_of(file)

    @pytest.mark.parametrize('status, arguments, words', [
        (2, ['--output', 'a.html'], ['expected at least one file']),
        (2, ['m.csv'], ['--output']),
        (1, ['none.csv', '--output', 'a.html'], ['none.csv: No such file']),
        (1, ['m.csv', '--output', 'none/a.html'], ['none/a.html: cannot be written: there is no folder /']),
        (2, ['m.csv', '--output', 'a.txt'], ['--output: expected FILE.html']),
        (1, ['cut.csv', '--output', 'a.html'], ['cut.csv:2: expected', 'values, got']),
        (1, ['walk.csv', '--output', 'a.html'], ['walk.csv:3: the last line is not complete', 'cut off']),
        (1, ['log.csv', '--output', 'a.html'], ['log.csv:3: the last line is not complete', 'cut off']),
        (1, ['m.csv', '--training', 'm.csv', '--output', 'a.html'], ['m.csv: --training: expected a record or log']),
        (1, ['bad.csv', '--output', 'a.html'], ["bad.csv:2: expected a number in the column 'success_pct'", "'many'"]),
    ])
    def test_errors(self, runner, status, arguments, words):
        runner.write('m.csv', METRICS_FILE % 90)
        runner.write('bad.csv', METRICS_FILE % 'many')
        header = METRICS_FILE.splitlines()[0]
        runner.write('cut.csv', f'{header}\ncircle6,20\n')
        runner.write('walk.csv', 'instance,tick,agent,x,y\n0,0,0,0,0\n0,1,0,0.1,-0.0')
        runner.write('log.csv', 'episode,scenario,agents,success,decisions\n0,a,1,1,120\n1,a,1,1,12')
        got, output = report(runner, *arguments)
        assert got == status, output
        assert_says(output, *words)
        assert 'Traceback' not in output
        assert sorted(os.listdir(runner.folder)) == ['bad.csv', 'cut.csv', 'log.csv', 'm.csv', 'walk.csv']

    def test_documented(self):
        assert_says(page_text('tools.md'), '(#reports)', '--training')
