"""Parts of the tables of research/reproduce: records, and the rules for judging claims and choices."""
import math
import pathlib

import numpy
import pandas
import pytest
from crowd_experiments.records import Spread, median, read_csv, read_visits, spread_text
from crowd_reproduction import claim, claims, declared, results, reward_judges, reward_measures
from crowd_reproduction.experiments import sensitivity
from crowd_experiments.variations import Setting, read_documents
from crowd_studies.program import Report
from programs import in_package


class RecordsTest:
    """Values in tables, compared with numbers computed by hand."""

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
        assert median(record['path_ratio']) == 1.5
        rows = pandas.DataFrame(record).assign(seed=1)
        assert results.rates_of(rows).loc[1].tolist() == [75.0, 100.0, 50.0]
        success, collision, contact = results.rates_of(rows[rows['scenario'] == 'a, b']).loc[1]
        assert success == pytest.approx(200.0 / 3.0, abs=1e-7)
        assert contact == pytest.approx(100.0 / 3.0, abs=1e-7)
        assert collision == 100.0

    def test_spread_reports_missing_numbers(self):
        assert spread_text([1.0, 2.0, 6.0], 1) == '3.0 ± 2.6 (1.0-6.0)'
        assert spread_text([1.0, math.inf, 3.0], 0) == '2 ± 1 (1-3); infinite in 1 of 3 seeds'
        assert spread_text([math.nan, math.nan]) == '-; none in 2 of 2 seeds'

    def test_visits(self, runner):
        file = runner.write('q_table.txt', 'a header\nrows: 3\n---\n0 5 0.25 7 -1e-3\n2 1 0.5 0 0\nchecksum: 12ab\n')
        assert read_visits(file) == {0: 12, 2: 1}

    def test_measures_of_an_episode(self):
        record = {'path_per_gain': numpy.array([1.5, math.nan, 4.0]), 'gain_per_tick': numpy.array([0.02, 0.0, 0.01]),
                  'path_ratio': numpy.array([1.4, 20.0, 3.0]), 'arrived': numpy.array([1.0, 0.0, 1.0])}
        assert reward_measures.path_per_gain(record) == 4.0  # median of 1.5, 4 and infinity
        assert reward_measures.shortfall(record) == pytest.approx(0.02, abs=1e-7)  # median of 0.01, 0.03 and 0.02
        assert reward_measures.path_ratio(record) == pytest.approx(2.2, abs=1e-7)
        assert reward_measures.breadth(numpy.arange(11.0), (10, 90)) == 8.0  # from 1 to 9
        assert reward_measures.breadth(numpy.array([1.0, math.inf]), (10, 90)) == math.inf

    def test_quarter(self):
        record = pandas.DataFrame({'arrived': [0, 1, 1, 1, 0, 0, 1, 1]})
        assert reward_judges.quarter(self.share_of_arrivals, False)(record) == 0.5
        assert reward_judges.quarter(self.share_of_arrivals, True)(record) == 1.0

    @staticmethod
    def share_of_arrivals(record):
        return record['arrived'].mean()

    def test_bends(self):
        # 1.2 m east in a zigzag, 0.6 m north, 0.6 m north-west; then the agent has left.
        steps = [(0.03, 0.01), (0.03, -0.01)] * 20 + [(0.0, 0.03)] * 20 + [(-0.03, 0.03)] * 20
        places = numpy.vstack([[0.0, 0.0], numpy.cumsum(steps, axis=0), [[math.nan, math.nan]] * 5])
        total, sharpest = reward_measures.bends(places)
        assert total == pytest.approx(90.0 + 45.0, abs=1e-7)
        assert sharpest == pytest.approx(90.0, abs=1e-7)

    def test_separation(self):
        def separated(*gains):
            return reward_judges.separated({'gain_per_tick': numpy.array(gains)})
        assert separated(0.001, 0.016, 0.0, 0.017)
        assert not separated(0.012, 0.016, 0.010, 0.014)
        # One of forty is less than LEAST_SIDE.
        assert not separated(0.0, *[0.016] * 39)
        assert separated(0.0, 0.0, *[0.016] * 38)
        # One of two hundred values in the gap is accepted, five are not.
        assert separated(*[0.0] * 20, 0.004, *[0.008] * 179)
        assert not separated(*[0.0] * 20, *[0.004] * 5, *[0.008] * 175)


class ClaimTest:
    """The rule for judging claims."""

    def test_the_mean_and_three_quarters_of_the_seeds(self):
        # 2.25 > 1, and the differences 2, 2, 2, -1 have the standard error 1.5 / 2; three of four.
        assert claim.decide_greater([3, 3, 3, 0], [1, 1, 1, 1]) == claim.CONFIRMED
        # Holds for the mean only: 4 > 1, the differences 8, 4, 0, 0 have the standard error sqrt(44 / 3) / 2 = 1.9.
        assert claim.decide_greater([9, 5, 1, 1], [1, 1, 1, 1]) == claim.PARTLY
        # The mean 1.75 > 1, but the standard error of the differences 5, 0, -1, -1 is 1.4.
        assert claim.decide_greater([6, 1, 0, 0], [1, 1, 1, 1]) == claim.NOT_CONFIRMED
        assert claim.decide_greater([2, 2, 2, 0], [1, 1, 1, 9]) == claim.PARTLY  # holds for the seeds only
        assert claim.decide_greater([1, 1], [1, 1]) == claim.NOT_CONFIRMED  # a tie
        assert claim.decide_greater([math.inf, math.inf], [1, 2]) == claim.CONFIRMED

    def test_conditions_and_numbers(self):
        assert claim.decide_each([0.0, 0.5, 0.9, 1.5], lambda rate: rate <= 1.0) == claim.CONFIRMED
        assert claim.decide_each([0.0, 0.0, 9.0], lambda rate: rate <= 1.0) == claim.NOT_CONFIRMED
        assert claim.decide_near([70.0, 80.0], 73.8) == claim.CONFIRMED
        assert claim.decide_near([76.0, 78.0], 73.8) == claim.PARTLY  # near, but outside the range
        assert claim.decide_near([0.0, 100.0], 73.8) == claim.PARTLY  # within the range, but not near
        assert claim.decide_near([90.0, 100.0], 73.8) == claim.NOT_CONFIRMED

    def test_parts(self):
        assert claim.decide_all(claim.NOT_CONFIRMED, claim.NOT_CONFIRMED) == claim.NOT_CONFIRMED
        assert claim.decide_all(claim.NOT_CONFIRMED, claim.CONFIRMED) == claim.PARTLY

    def test_tables_and_phrases(self):
        chapter = Report('claims', results.TEXTS, None)
        listed = [claim.Claim('4.1', 'it works', None), claim.Claim('4.2', 'it fits', None,
                                                                    {claim.NOT_CONFIRMED: 'another geometry'})]

        def judged(first, second):
            return [claim.Judgement('5 of 8', first, '5'), claim.Judgement('0 of 8', second, '0')]
        never = judged(claim.CONFIRMED, claim.NOT_CONFIRMED)
        found = dict.fromkeys(declared.READINGS, never)
        found['constant'] = judged(claim.PARTLY, claim.NOT_CONFIRMED)
        claims.add_claims(chapter, listed, found)
        tally, verdicts, measured = chapter.tables()
        assert tally.rows[0] == ['fading epsilon, uneven sectors', '1', '0', '1']
        assert tally.rows[3] == ['constant epsilon', '0', '1', '1']
        assert verdicts.rows == [['4.1', 'it works', 'confirmed', '5', 'partly: constant epsilon'],
                                 ['4.2', 'it fits', 'not confirmed', '0', 'the same']]
        assert measured.rows[1][2:5] == ['0 of 8', 'another geometry', 'not: 0']
        assert chapter.phrases == {
            'tally': 'Of 2 claims and expectations of the thesis: 1 confirmed, 0 partly confirmed, 1 not confirmed.',
            'never': '\n- it fits (4.2)\n'}

    def test_readings_without_runs(self):
        chapter = Report('claims', results.TEXTS, None)
        confirmed = claim.Judgement('5 of 8', claim.CONFIRMED, '5')
        denied = claim.Judgement('0 of 8', claim.NOT_CONFIRMED, '0')
        found = {'fading_uneven': [denied], 'fading': [None], 'uneven': [None], 'constant': [confirmed]}
        claims.add_claims(chapter, [claim.Claim('5.2', 'it helps', None)], found)
        tally, verdicts, measured = chapter.tables()
        assert not tally.rows
        assert verdicts.rows[0][4] == ('confirmed: constant epsilon. not measured: fading epsilon; constant epsilon, '
                                       'uneven sectors')
        assert measured.rows[0][4:] == ['not measured', 'not measured', 'confirmed: 5']
        assert chapter.phrases['never'] == '\n'

    def test_numbers(self):
        # 4 and 8: mean 6, standard deviation sqrt(8); differences 1, 3: sqrt(2); pairs without one are left out.
        assert claim.number_text([4.0, 8.0]) == '6.0 ± 2.8 %, 2 seeds'
        assert claim.difference_text('a', [4.0, 8.0, math.nan], 'b', [3.0, 5.0, 1.0], 1) == (
            'a 6.0, b 4.0 (± 1.4, 2 seeds)')
        assert claim.number_text([1.0, math.inf, 4.0, math.nan], 0, '') == 'median 4 (1-inf), 3 seeds'
        assert claim.difference_text('a', [4.0, math.inf, 6.0], 'b', [3.0, 5.0, 1.0], 0) == (
            'a 6, b 3 (medians, 3 seeds)')

    def test_versus(self):
        text = claim.versus('demo', [1, 4, 4], 'training', [2, 2, 2], 0)
        assert text == 'demo 3 ± 2 (1-4), training 2 ± 0 (2-2); demo greater in 2 of 3 seeds'


class SensitivityTest:
    """Effects of the choices."""

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
        assert text == ('Choices with an effect: epsilon (2 rates, by up to 20.2 points); radius (1 rate, by up to 1.5 '
                        'points). No effect found: order.')

    def test_spread_of_demo(self):
        text = sensitivity.swing_text({'distance_gained': [100.0, 0.0], 'cosine_cubed': [26.5, 80.0]})
        assert '(distance gained 0.0 to 100.0 %, cos³ 26.5 to 80.0 %). So 2 seeds' in text

    def test_names(self):
        assert len(declared.CHOICES) == 1 + sum(len(choice['others']) for choice in declared.DECLARED['choices'])
        assert 'sector_limits_of_set_1_degrees_22.5_67.5_112.5_180' in declared.CHOICES


class DeclaredRunsTest:
    """The commands of the runs in runs.yaml."""

    @pytest.fixture
    def setting(self, tmp_path):
        return Setting(pathlib.Path('/tools'), pathlib.Path(in_package('config')), tmp_path)

    def test_words(self, setting):
        def words(line, **keys):
            return [[*map(str, command)] for command in declared.commands_of(setting, line, {'seed': 3, **keys})]
        assert words('walk a.txt --episodes 50|2 ~nine')[0][:9] == [
            '/tools/evaluate', '--q-table', 'a.txt', '--threads', '1', '--seed', '1003', '--episodes', '50']
        assert len(words('walk a.txt --episodes 50|2 ~nine')[0]) == 9 + 9
        assert words('train @twins_{states} --seed {seed}', states='nearest', parameters='constant') == [
            ['/tools/train', in_package('research', 'experiments', 'twins_nearest_thesis.yaml'), '--seed', '3']]
        assert words({'when': {'seed': 1}, 'run': 'walk a.txt'}) == []
        tables = [command[2] for command in words({'each': {'n': '5 6|1'}, 'run': 'walk {n:02d}.txt'})]
        assert tables == ['05.txt', '06.txt']

    def test_variations_change_configuration_and_scenario(self, setting):
        command, = declared.commands_of(setting, 'train @reward_{reward}', {
            'seed': 1, 'variation': 'heading_at_the_start_goal', 'reward': 'cosine_cubed'})
        scenario, = read_documents(command[1])[0]['training']['scenarios']
        assert read_documents(scenario)[0]['agents'][0]['heading'] == 'goal'
        command, = declared.commands_of(setting, 'train @agent_single_occupancy', {'seed': 1, 'variation': 'stay_1'})
        assert read_documents(command[1])[0]['reward']['stay_cost'] == 1.0

    def config(self, setting, name, **keys):
        return read_documents(declared.config_file(setting, name, keys))[0]

    def test_readings(self, setting):
        sectors = [15, 45, 90, 180]
        lead = self.config(setting, 'agent_field_occupancy', states='occupancy')
        assert lead['state_set']['obstacle_sectors'] == sectors
        assert lead['learning']['epsilon'] == {'from': 0.3, 'to': 0.01, 'shape': 'exponential', 'episodes': 4000}
        other = self.config(declared.Reading.of(setting, 'uneven'), 'agent_field_occupancy', states='occupancy')
        assert other['state_set']['obstacle_sectors'] == sectors
        assert other['learning']['epsilon'] == 0.1
        # The sectors of set 1 are the same in all readings; a crowd that goes on learning keeps its small epsilon.
        assert declared.parameters_of(declared.Reading.of(setting, 'uneven'), {'states': 'nearest'}) == 'constant'
        assert declared.parameters_of(setting, {'reward': 'cosine_cubed'}) == 'fading'
        assert self.config(setting, 'sharing_crowd_nearest', states='nearest')['learning']['epsilon'] == 0.01
        # A choice replaces the value of the reading.
        keys = {'reward': 'cosine_cubed', 'variation': 'epsilon_in_training_0.1'}
        assert self.config(setting, 'reward_cosine_cubed', **keys)['learning']['epsilon'] == 0.1

    @pytest.mark.parametrize('states', declared.SETS)
    def test_the_measured_agent_is_the_one_that_ships(self, setting, states):
        for part, shipped in (('single', ''), ('field', '_field')):
            ours = self.config(setting, f'agent_{part}_{states}', states=states)
            theirs = read_documents(setting.learning(f'thesis_{states}{shipped}'))[0]
            assert theirs['training'].pop('seed') in setting.seeds(10)
            for config in (ours, theirs):
                config['training']['scenarios'] = [pathlib.Path(file).stem for file in config['training']['scenarios']]
            assert ours == theirs

    def test_every_run_has_its_own_folder(self, setting):
        runs = [run for group in declared.GROUPS for run in results.runs_of(setting, group)]
        assert len({run.folder for run in runs}) == len(runs)


class EpisodesTest:
    """Values for each seed, worked out by hand."""

    def test_rates_and_whole_episodes(self):
        rows = pandas.DataFrame({'seed': [1] * 4 + [2] * 4, 'episode': [0, 0, 1, 1] * 2, 'ticks': [5, 9, 3, 2] * 2,
                                 'arrived': [1, 1, 1, 0, 1, 1, 1, 1], 'collided': [0, 1, 0, 0, 0, 0, 0, 0],
                                 'touched': [0, 0, 0, 0, 1, 0, 0, 0]})
        rates = results.rates_of(rows)
        assert rates.loc[1].tolist() == [75.0, 25.0, 0.0]
        assert rates.loc[2].tolist() == [100.0, 0.0, 25.0]
        episodes = results.episodes_of(rows)
        assert episodes.loc[1, 0].to_dict() == {'arrived': 2, 'collided': 1, 'touched': 0, 'agents': 2, 'ticks': 9}
