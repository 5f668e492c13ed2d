"""scripts/reproduce: what it leaves and keeps, how it is interrupted; and the numbers that its tables are made of."""
import csv
import glob
import math
import os
import pathlib
import re
import stat
import statistics

import numpy
import pytest
import yaml
from crowd_drawing.motion import place_of
from crowd_experiments.chapter import Chapter
from crowd_experiments.records import (Spread, median, of_scenario, rates, read_csv, read_visits,
                                       spread_text)
from crowd_experiments.runs import Run
from crowd_experiments.setting import Setting
from crowd_experiments.variations import changed, vary_recipe, vary_scenario
from crowd_reproduction import claim, open_choices, reward_claims, reward_judges, reward_runs
from crowd_reproduction.experiments import sensitivity
from programs import assert_says, in_package, read_text, tools_folder, wait_for

REWARDS = ('distance_gained', 'cosine_cubed')


class ReproduceTest:
    """The program as a whole."""

    def reproduce(self, runner, *words):
        """Starts scripts/reproduce with results in the test's folder."""
        return runner.start('reproduce', [in_package('scripts', 'reproduce'), *words, '--tools', tools_folder(),
                                          '--results', runner.path('results')])

    def stamps(self, runner):
        """The runs that are complete."""
        return set(glob.glob(runner.path('results/runs/*/*/done.txt')))

    def test_quick_from_end_to_end(self, runner):
        document = runner.write('page.md', '<!-- table reward_evaluation/headings -->\n<!-- end -->\n')
        first = self.reproduce(runner, 'reward_evaluation', '--quick', '--document', document)
        assert first.wait() == 0, first.output()
        # Two rewards, two seeds: two sets of parameters, two other headings, longer training.
        assert len(self.stamps(runner)) == 20
        assert read_text(document).count('\n| thesis\'s parameters, heading: ') == 12
        page = read_text(runner.path('results/index.html'))
        assert '4.1-4.12' in page
        assert 'scripts/reproduce reward_evaluation' in page
        assert '<script' not in page
        figures = {'fig_4_01.png', *(f'fig_4_{number:02d}{parameters}.png' for number in range(2, 13)
                                     for parameters in ('', '_better'))}
        assert set(os.listdir(runner.path('results/figures'))) == figures
        assert page.count('<img src="data:image/png;base64,') == len(figures)
        self.check_table(runner)
        self.check_claims(runner)
        self.check_going_on(runner)

    def check_table(self, runner):
        """The success in the table is that in the records, worked out here once more."""
        table = read_text(runner.path('results/tables/reward_evaluation.md'))
        for reward, name in zip(REWARDS, ('distance gained', 'cos³')):
            shares = [self.success_in(runner, f'{reward}_better_{seed:02d}/demo.csv') for seed in (1, 2)]
            row = re.search(rf'^\| better parameters, demo, {name} \|.*$', table, re.MULTILINE)[0]
            assert (f'| {statistics.mean(shares):.2f} ± {statistics.stdev(shares):.2f} '
                    f'({min(shares):.2f}-{max(shares):.2f}) |') in row

    def success_in(self, runner, record):
        """Percent of the episodes of a record in which the agent arrived."""
        with open(runner.path(f'results/runs/reward_evaluation/{record}'), encoding='utf-8') as stream:
            rows = list(csv.DictReader(stream))
        assert len(rows) == 20
        return 100.0 * sum(row['arrived'] == '1' for row in rows) / len(rows)

    def check_claims(self, runner):
        """Each claim about the rewards is judged from the records."""
        setting = Setting(pathlib.Path(), pathlib.Path(in_package('config')),
                          pathlib.Path(runner.path('results')), quick=True)
        chapter = Chapter('claims', 'Claims')
        claim.add_claims(chapter, 'Rewards', reward_claims.CLAIMS, setting, 'rewards')
        rows = chapter.tables()[0].rows
        assert len(rows) == len(reward_claims.CLAIMS)
        assert {row[3] for row in rows} <= {claim.COMES_OUT, claim.IN_PART, claim.NOT}
        arrivals = [self.success_in(runner, f'cosine_cubed_thesis_{seed:02d}/demo.csv') for seed in (1, 2)]
        assert f'cos³ {statistics.mean(arrivals):.2f} ' in next(
            row[2] for row in rows if row[1] == 'success in demo is "slightly better" with cos³ (%)')

    def check_going_on(self, runner):
        """Runs that are done are kept; one that is not is done again."""
        os.remove(sorted(self.stamps(runner))[0])
        again = self.reproduce(runner, 'reward_evaluation', '--quick')
        assert again.wait() == 0, again.output()
        assert '20 runs, 19 of them done before' in again.output()
        assert len(self.stamps(runner)) == 20

    def test_interrupted(self, runner):
        running = self.reproduce(runner, 'ambiguity')
        wait_for(lambda: self.stamps(runner), 'the first run')
        assert running.stop() == 130, running.output()
        done = re.search(r'Interrupted: (\d+) of 80 runs are done and stay', running.output())
        assert done is not None, running.output()
        assert len(self.stamps(runner)) == int(done[1])

    def test_a_tool_that_fails(self, runner):
        for tool in ('train', 'evaluate'):
            runner.write(tool, '#!/bin/sh\necho the disk is on fire >&2\nexit 3\n')
            os.chmod(runner.path(tool), stat.S_IRWXU)
        failing = runner.start('reproduce', [in_package('scripts', 'reproduce'), 'sharing', '--quick',
                                             '--tools', runner.folder, '--results', runner.path('results')])
        assert failing.wait() == 1
        assert_says(failing.output(), 'exit status 3', 'the disk is on fire')
        assert self.stamps(runner) == set()

    def test_unknown_experiment(self, runner):
        unknown = self.reproduce(runner, 'alchemy')
        assert unknown.wait() == 2
        assert_says(unknown.output(), 'alchemy', 'reward_evaluation')


class RecordsTest:
    """What tables are made of, on numbers worked out by hand."""

    def test_spread(self):
        spread = Spread([1.0, 2.0, 6.0])
        assert (spread.mean, spread.low, spread.high) == (3.0, 1.0, 6.0)
        assert spread.deviation == pytest.approx(math.sqrt((4.0 + 1.0 + 9.0) / 2), abs=1e-7)
        assert spread.text(1) == '3.0 ± 2.6 (1.0-6.0)'
        assert Spread([4.0]).text(0) == '4 ± 0 (4-4)'

    def test_spread_of_numbers_only(self):
        assert Spread.of_numbers([1.0, math.nan, 3.0]).mean == 2.0
        assert Spread.of_numbers([math.nan]).text() == '-'

    def test_record(self, runner):
        record = read_csv(runner.write(
            'record.csv', 'episode,scenario,arrived,touched,collided,path_ratio\n'
                          '0,"a, b",1,0,1,1.5\n1,"a, b",0,0,1,nan\n2,c,1,1,1,1.25\n3,"a, b",1,1,1,2.5\n'))
        assert rates(record) == (75.0, 50.0, 100.0)
        assert median(record['path_ratio']) == 1.5
        rows = of_scenario(record, 'a, b')
        assert list(rows) == [True, True, False, True]
        success, contact, collision = rates(record, rows)
        assert success == pytest.approx(200.0 / 3.0, abs=1e-7)
        assert contact == pytest.approx(100.0 / 3.0, abs=1e-7)
        assert collision == 100.0

    def test_spread_says_where_there_is_no_number(self):
        assert spread_text([1.0, 2.0, 6.0], 1) == '3.0 ± 2.6 (1.0-6.0)'
        assert spread_text([1.0, math.inf, 3.0], 0) == '2 ± 1 (1-3); infinite in 1 of 3 seeds'
        assert spread_text([math.nan, math.nan]) == '-; none in 2 of 2 seeds'

    def test_visits(self, runner):
        file = runner.write('q_table.txt', 'a header\nrows: 3\n---\n0 5 0.25 7 -1e-3\n2 1 0.5 0 0\nchecksum: 12ab\n')
        assert read_visits(file) == {0: 12, 2: 1}

    def test_measures_of_an_episode(self):
        record = {'path_per_gain': numpy.array([1.5, math.nan, 4.0]), 'gain_per_tick': numpy.array([0.02, 0.0, 0.01]),
                  'path_ratio': numpy.array([1.4, 20.0, 3.0]), 'arrived': numpy.array([1.0, 0.0, 1.0])}
        assert reward_runs.path_per_gain(record) == 4.0  # of 1.5, 4 and an infinite one
        assert reward_runs.shortfall(record) == pytest.approx(0.02, abs=1e-7)  # of 0.01, 0.03 and 0.02
        assert reward_runs.path_ratio(record) == pytest.approx(2.2, abs=1e-7)
        assert reward_runs.breadth(numpy.arange(11.0), (10, 90)) == 8.0  # from 1 to 9
        assert reward_runs.breadth(numpy.array([1.0, math.inf]), (10, 90)) == math.inf

    def test_quarter(self):
        record = {'arrived': numpy.array([0, 1, 1, 1, 0, 0, 1, 1])}
        assert reward_judges.quarter(self.share_of_arrivals, False)(record) == 0.5
        assert reward_judges.quarter(self.share_of_arrivals, True)(record) == 1.0

    @staticmethod
    def share_of_arrivals(record):
        return record['arrived'].mean()

    def test_bends(self):
        # 1.2 m east in a zigzag, 0.6 m north, 0.6 m north-west; then the agent has left.
        steps = [(0.03, 0.01), (0.03, -0.01)] * 20 + [(0.0, 0.03)] * 20 + [(-0.03, 0.03)] * 20
        places = numpy.vstack([[0.0, 0.0], numpy.cumsum(steps, axis=0), [[math.nan, math.nan]] * 5])
        total, sharpest = reward_runs.bends(places)
        assert total == pytest.approx(90.0 + 45.0, abs=1e-7)
        assert sharpest == pytest.approx(90.0, abs=1e-7)

    def test_separation(self):
        def separated(*gains):
            return reward_judges.separated({'gain_per_tick': numpy.array(gains)})
        assert separated(0.001, 0.016, 0.0, 0.017)
        assert not separated(0.012, 0.016, 0.010, 0.014)
        # One of forty is less than a twentieth.
        assert not separated(0.0, *[0.016] * 39)
        assert separated(0.0, 0.0, *[0.016] * 38)
        # One of two hundred in between does not matter, five of them do.
        assert separated(*[0.0] * 20, 0.004, *[0.008] * 179)
        assert not separated(*[0.0] * 20, *[0.004] * 5, *[0.008] * 175)


class ClaimTest:
    """The rule by which claims are judged."""

    def test_the_mean_and_three_quarters_of_the_seeds(self):
        # 2.25 > 1, and the differences 2, 2, 2, -1 have the standard error 1.5 / 2; three of four.
        assert claim.decide_greater([3, 3, 3, 0], [1, 1, 1, 1]) == claim.COMES_OUT
        # The mean only: 4 > 1, the differences 8, 4, 0, 0 have the standard error sqrt(44 / 3) / 2 = 1.9.
        assert claim.decide_greater([9, 5, 1, 1], [1, 1, 1, 1]) == claim.IN_PART
        # The mean 1.75 > 1, but the standard error of the differences 5, 0, -1, -1 is 1.4.
        assert claim.decide_greater([6, 1, 0, 0], [1, 1, 1, 1]) == claim.NOT
        assert claim.decide_greater([2, 2, 2, 0], [1, 1, 1, 9]) == claim.IN_PART  # the seeds only
        assert claim.decide_greater([1, 1], [1, 1]) == claim.NOT  # a tie
        assert claim.decide_greater([math.inf, math.inf], [1, 2]) == claim.COMES_OUT

    def test_conditions_and_numbers(self):
        assert claim.decide_each([0.0, 0.5, 0.9, 1.5], lambda rate: rate <= 1.0) == claim.COMES_OUT
        assert claim.decide_each([0.0, 0.0, 9.0], lambda rate: rate <= 1.0) == claim.NOT
        assert claim.decide_near([70.0, 80.0], 73.8) == claim.COMES_OUT
        assert claim.decide_near([76.0, 78.0], 73.8) == claim.IN_PART  # near, but not among them
        assert claim.decide_near([0.0, 100.0], 73.8) == claim.IN_PART  # among them, but not near
        assert claim.decide_near([90.0, 100.0], 73.8) == claim.NOT

    def test_parts(self):
        assert claim.decide_all(claim.NOT, claim.NOT) == claim.NOT
        assert claim.decide_all(claim.NOT, claim.COMES_OUT) == claim.IN_PART

    def test_table(self):
        chapter = Chapter('claims', 'Claims')
        verdicts = (claim.COMES_OUT, claim.NOT, claim.NOT)
        claims = [claim.Claim('4.1', 'it works', lambda _, verdict=verdict: claim.Judgement('5 of 8', verdict),
                              {claim.NOT: 'another geometry'}) for verdict in verdicts]
        claim.add_claims(chapter, 'Claims', claims, None, 'rewards')
        table, text = chapter.parts
        assert table.name == 'rewards'
        assert table.rows == [['4.1', 'it works', '5 of 8', 'comes out', ''],
                              *[['4.1', 'it works', '5 of 8', 'does not come out', 'another geometry']] * 2]
        assert text == 'Of 3 claims 1 come out, 0 come out in part, 2 do not come out.'

    def test_versus(self):
        text = claim.versus('demo', [1, 4, 4], 'training', [2, 2, 2], 0)
        assert text == 'demo 3 ± 2 (1-4), training 2 ± 0 (2-2); greater with demo in 2 of 3 seeds'


class SensitivityTest:
    """Which choices are said to matter."""

    def test_shift(self):
        # The differences 4, 6, 5, 5 have the mean 5 and the standard error sqrt(2 / 3) / 2 = 0.41.
        assert sensitivity.shift([14, 16, 15, 15], [10, 10, 10, 10]) == 5.0
        # 0, 10, 0, 10: mean 5, standard error sqrt(100 / 3) / 2 = 2.9.
        assert sensitivity.shift([10, 20, 10, 20], [10, 10, 10, 10]) == 0.0
        assert sensitivity.shift([10.5, 10.5], [10, 10]) == 0.0  # less than a point
        assert sensitivity.shift([8, 8], [10, 10]) == -2.0

    def test_text(self):
        text = sensitivity.effects_text({'radius': [None, ('0.2', 1.5)], 'epsilon': [('0.3', -20.25), ('0.2', 3.0)],
                                         'order': [None, None]})
        assert text == ('Choices that matter: epsilon moves 2 of 2 rates, by up to 20.2 points; radius moves 1 of 2 '
                        'rates, by up to 1.5 points. No effect found: order.')

    def test_swing(self):
        text = sensitivity.swing_text({'distance_gained': [100.0, 0.0], 'cosine_cubed': [26.5, 80.0]})
        assert '(distance gained 0.0 to 100.0 %, cos³ 26.5 to 80.0 %), so 2 seeds' in text

    def test_names(self):
        variations = {variation.name() for variation in open_choices.VARIATIONS}
        assert len(variations) == len(open_choices.VARIATIONS)  # no run overwrites another's files
        assert 'sector_limits_of_set_1_degrees_22.5_67.5_112.5_180' in variations


class VariationsTest:
    """Variations of shipped files."""

    def setting(self, runner):
        """With a config/ of its own."""
        config, results = pathlib.Path(runner.path('config')), pathlib.Path(runner.path('results'))
        for folder in ('experiments', 'scenarios'):
            (config / folder).mkdir(parents=True, exist_ok=True)
        return Setting(pathlib.Path(), config, results)

    def test_changes_by_the_paths_of_keys(self):
        scene = {'agents': [{'speed': 1, 'heading': 0}, {'speed': 2}], 'order': 'sequential'}
        other = changed(scene, {'agents.*.heading': 'goal', 'agents.1.speed': [3, 4], 'order': None, 'colour': None,
                                'learning.epsilon': 0.2})
        assert other == {'agents': [{'speed': 1, 'heading': 'goal'}, {'speed': [3, 4], 'heading': 'goal'}],
                         'learning': {'epsilon': 0.2}}
        assert scene['order'] == 'sequential'  # is left as it was
        with pytest.raises(ValueError):
            changed(scene, {'obstacles.*.radius': 0.2})

    def test_recipe(self, runner):
        setting = self.setting(runner)
        runner.write('config/experiments/base.yaml', 'learning: {gamma: 0.1, epsilon: 0.1}\n'
                                                     'training: {scenarios: [../scenarios/a.yaml], episodes: 7}\n')
        changes = {'learning.epsilon': {'from': 1, 'to': 0}, 'training.episodes': 9}
        file = vary_recipe(setting, 'base', changes, 'varied')
        assert file == pathlib.Path(runner.path('results/recipes/varied.yaml'))
        training = {'scenarios': [str(pathlib.Path(runner.path('config/scenarios/a.yaml')).resolve())], 'episodes': 9}
        learning = {'gamma': 0.1, 'epsilon': {'from': 1, 'to': 0}}
        assert yaml.safe_load(read_text(file)) == {'learning': learning, 'training': training}
        os.utime(file, (1, 1))
        vary_recipe(setting, 'base', changes, 'varied')
        assert os.stat(file).st_mtime == 1  # it was as it should be
        other = vary_recipe(setting, file, {}, 'other', [pathlib.Path('/b.yaml')])
        assert yaml.safe_load(read_text(other))['training']['scenarios'] == ['/b.yaml']

    def test_scenario_with_all_its_documents(self, runner):
        setting = self.setting(runner)
        runner.write('config/scenarios/two.yaml', 'name: one\nagents: [{speed: 1}]\n---\n'
                                                  'name: two\nagents: [{speed: 2}]\n')
        file = vary_scenario(setting, 'two', {'agents.*.speed': 3}, 'fast')
        assert list(yaml.safe_load_all(read_text(file))) == [{'name': 'one', 'agents': [{'speed': 3}]},
                                                             {'name': 'two', 'agents': [{'speed': 3}]}]


class RunTest:
    """When a run that was done before counts as done."""

    def test_stamp_changes_with_all_that_it_is_made_from(self, runner):
        scenario = runner.write('scenario.yaml', 'name: one\n')
        recipe = runner.write('recipe.yaml', 'training: {scenarios: [scenario.yaml]}\n')

        def stamp(*words):
            return Run(pathlib.Path(runner.folder), [['train', recipe, *words]]).stamp()

        stamps = [stamp('--seed', 1)]
        assert stamp('--seed', 1) == stamps[0]
        stamps.append(stamp('--seed', 2))
        runner.write('scenario.yaml', 'name: another\n')
        stamps.append(stamp('--seed', 1))
        runner.write('recipe.yaml', 'training: {scenarios: [scenario.yaml], episodes: 7}\n')
        stamps.append(stamp('--seed', 1))
        os.remove(scenario)
        with pytest.raises(OSError):
            stamp('--seed', 1)
        assert len(set(stamps)) == 4


class MotionTest:
    """Where moving obstacles are drawn."""

    def place(self, time, **motion):
        """The place of an obstacle that starts at (1, 2)."""
        rest = {'position': (1.0, 2.0), 'velocity': (0.0, 0.0), 'to_and_fro': [], 'waypoints': [], 'speed': 0.5}
        return place_of(dict(rest, **motion), time)

    def test_at_rest_and_straight_on(self):
        assert self.place(9.0) == (1.0, 2.0)
        assert self.place(4.0, velocity=(0.5, -1.0)) == (3.0, -2.0)

    def test_to_and_fro(self):
        # 3 m along y and 4 m along x at 0.5 m/s: after 8 s 1 m of the second leg, after 20 s 10 m, that is 4 m back.
        way = [(1.0, 5.0), (5.0, 5.0)]
        assert self.place(8.0, to_and_fro=way) == (2.0, 5.0)
        assert self.place(20.0, to_and_fro=way) == (2.0, 5.0)
        assert self.place(28.0, to_and_fro=way) == (1.0, 2.0)

    def test_round_and_round(self):
        # A triangle of 3, 4 and 5 m: after 16 s 8 m, 1 m into the way back, a fifth of it.
        x, y = self.place(16.0, waypoints=[(1.0, 5.0), (5.0, 5.0)])
        assert x == pytest.approx(4.2, abs=1e-7)
        assert y == pytest.approx(4.4, abs=1e-7)
