#!/usr/bin/python3
"""scripts/reproduce: what it leaves and keeps, how it is interrupted; and the numbers that its tables are made of."""
import csv
import glob
import math
import os
import pathlib
import re
import stat
import statistics
import sys

import support
import yaml
from roslib.packages import find_node

SCRIPTS = support.in_package('scripts')
sys.path.insert(0, SCRIPTS)
from crowd_drawing.motion import place_of  # noqa: E402
from crowd_experiments.records import Spread, median, of_scenario, rates, read_csv  # noqa: E402
from crowd_experiments.runs import Run  # noqa: E402
from crowd_experiments.setting import Setting  # noqa: E402
from crowd_experiments.variations import changed, vary_recipe, vary_scenario  # noqa: E402

REWARDS = ('distance_gained', 'cosine_cubed')


class ReproduceTest(support.CrowdTestCase):
    """The program as a whole."""

    def reproduce(self, *words):
        """Starts scripts/reproduce with results in the test's folder."""
        tools = os.path.dirname(find_node('social_crowd', 'train')[0])
        return self.start('reproduce', [os.path.join(SCRIPTS, 'reproduce'), *words, '--tools', tools,
                                        '--results', self.path('results')])

    def stamps(self):
        """The runs that are complete."""
        return set(glob.glob(self.path('results/runs/*/*/done.txt')))

    def test_quick_from_end_to_end(self):
        first = self.reproduce('reward_evaluation', '--quick')
        self.assertEqual(first.wait(), 0, first.output())
        self.assertEqual(len(self.stamps()), 8)  # two rewards, two sets of parameters, two seeds
        page = support.read_text(self.path('results/index.html'))
        self.assertIn('4.1-4.12', page)
        self.assertIn('scripts/reproduce reward_evaluation', page)
        self.assertNotIn('<script', page)
        self.assertEqual(page.count('<img src="data:image/png;base64,'), 7)
        self.assertEqual(len(glob.glob(self.path('results/figures/*.png'))), 7)
        self.check_table()
        self.check_going_on()

    def check_table(self):
        """The success in the table is that in the records, worked out here once more."""
        table = support.read_text(self.path('results/tables/reward_evaluation.md'))
        for reward, name in zip(REWARDS, ('distance gained', 'cos³')):
            shares = [self.success_in(f'{reward}_better_{seed:02d}/demo.csv') for seed in (1, 2)]
            row = re.search(rf'^\| better parameters, demo, {name} \|.*$', table, re.MULTILINE)[0]
            self.assertIn(f'| {statistics.mean(shares):.2f} ± {statistics.stdev(shares):.2f} '
                          f'({min(shares):.2f}-{max(shares):.2f}) |', row)

    def success_in(self, record):
        """Percent of the episodes of a record in which the agent arrived."""
        with open(self.path(f'results/runs/reward_evaluation/{record}'), encoding='utf-8') as stream:
            rows = list(csv.DictReader(stream))
        self.assertEqual(len(rows), 20)
        return 100.0 * sum(row['arrived'] == '1' for row in rows) / len(rows)

    def check_going_on(self):
        """Runs that are done are kept; one that is not is done again."""
        os.remove(sorted(self.stamps())[0])
        again = self.reproduce('reward_evaluation', '--quick')
        self.assertEqual(again.wait(), 0, again.output())
        self.assertIn('8 runs, 7 of them done before', again.output())
        self.assertEqual(len(self.stamps()), 8)

    def test_interrupted(self):
        running = self.reproduce('ambiguity')
        support.wait_for(self.stamps, 'the first run')
        self.assertEqual(running.stop(), 130, running.output())
        done = re.search(r'Interrupted: (\d+) of 40 runs are done and stay', running.output())
        self.assertIsNotNone(done, running.output())
        self.assertEqual(len(self.stamps()), int(done[1]))

    def test_a_tool_that_fails(self):
        for tool in ('train', 'evaluate'):
            self.write(tool, '#!/bin/sh\necho the disk is on fire >&2\nexit 3\n')
            os.chmod(self.path(tool), stat.S_IRWXU)
        failing = self.start('reproduce', [os.path.join(SCRIPTS, 'reproduce'), 'sharing', '--quick', '--tools',
                                           self.folder, '--results', self.path('results')])
        self.assertEqual(failing.wait(), 1)
        self.assert_says(failing.output(), 'exit status 3', 'the disk is on fire')
        self.assertEqual(self.stamps(), set())

    def test_unknown_experiment(self):
        unknown = self.reproduce('alchemy')
        self.assertEqual(unknown.wait(), 2)
        self.assert_says(unknown.output(), 'alchemy', 'reward_evaluation')


class RecordsTest(support.CrowdTestCase):
    """What tables are made of, on numbers worked out by hand."""

    def test_spread(self):
        spread = Spread([1.0, 2.0, 6.0])
        self.assertEqual((spread.mean, spread.low, spread.high), (3.0, 1.0, 6.0))
        self.assertAlmostEqual(spread.deviation, math.sqrt((4.0 + 1.0 + 9.0) / 2))
        self.assertEqual(spread.text(1), '3.0 ± 2.6 (1.0-6.0)')
        self.assertEqual(Spread([4.0]).text(0), '4 ± 0 (4-4)')

    def test_spread_of_numbers_only(self):
        self.assertEqual(Spread.of_numbers([1.0, math.nan, 3.0]).mean, 2.0)
        self.assertEqual(Spread.of_numbers([math.nan]).text(), '-')

    def test_record(self):
        record = read_csv(self.write(
            'record.csv', 'episode,scenario,arrived,touched,collided,path_ratio\n'
                          '0,"a, b",1,0,1,1.5\n1,"a, b",0,0,1,nan\n2,c,1,1,1,1.25\n3,"a, b",1,1,1,2.5\n'))
        self.assertEqual(rates(record), (75.0, 50.0, 100.0))
        self.assertEqual(median(record['path_ratio']), 1.5)
        rows = of_scenario(record, 'a, b')
        self.assertEqual(list(rows), [True, True, False, True])
        success, contact, collision = rates(record, rows)
        self.assertAlmostEqual(success, 200.0 / 3.0)
        self.assertAlmostEqual(contact, 100.0 / 3.0)
        self.assertEqual(collision, 100.0)


class VariationsTest(support.CrowdTestCase):
    """Variations of shipped files."""

    def setting(self):
        """With a config/ of its own."""
        config, results = pathlib.Path(self.path('config')), pathlib.Path(self.path('results'))
        for folder in ('experiments', 'scenarios'):
            (config / folder).mkdir(parents=True, exist_ok=True)
        return Setting(pathlib.Path(), config, results)

    def test_changes_by_the_paths_of_keys(self):
        scene = {'agents': [{'speed': 1, 'heading': 0}, {'speed': 2}], 'order': 'sequential'}
        self.assertEqual(changed(scene, {'agents.*.heading': 'goal', 'agents.1.speed': [3, 4], 'order': None,
                                         'colour': None, 'learning.epsilon': 0.2}),
                         {'agents': [{'speed': 1, 'heading': 'goal'}, {'speed': [3, 4], 'heading': 'goal'}],
                          'learning': {'epsilon': 0.2}})
        self.assertEqual(scene['order'], 'sequential')  # is left as it was
        with self.assertRaises(ValueError):
            changed(scene, {'obstacles.*.radius': 0.2})

    def test_recipe(self):
        setting = self.setting()
        self.write('config/experiments/base.yaml', 'learning: {gamma: 0.1, epsilon: 0.1}\n'
                                                   'training: {scenarios: [../scenarios/a.yaml], episodes: 7}\n')
        changes = {'learning.epsilon': {'from': 1, 'to': 0}, 'training.episodes': 9}
        file = vary_recipe(setting, 'base', changes, 'varied')
        self.assertEqual(file, pathlib.Path(self.path('results/recipes/varied.yaml')))
        training = {'scenarios': [str(pathlib.Path(self.path('config/scenarios/a.yaml')).resolve())], 'episodes': 9}
        self.assertEqual(yaml.safe_load(support.read_text(file)),
                         {'learning': {'gamma': 0.1, 'epsilon': {'from': 1, 'to': 0}}, 'training': training})
        os.utime(file, (1, 1))
        vary_recipe(setting, 'base', changes, 'varied')
        self.assertEqual(os.stat(file).st_mtime, 1)  # it was as it should be
        other = vary_recipe(setting, file, {}, 'other', [pathlib.Path('/b.yaml')])
        self.assertEqual(yaml.safe_load(support.read_text(other))['training']['scenarios'], ['/b.yaml'])

    def test_scenario_with_all_its_documents(self):
        setting = self.setting()
        self.write('config/scenarios/two.yaml', 'name: one\nagents: [{speed: 1}]\n---\n'
                                                'name: two\nagents: [{speed: 2}]\n')
        file = vary_scenario(setting, 'two', {'agents.*.speed': 3}, 'fast')
        self.assertEqual(list(yaml.safe_load_all(support.read_text(file))),
                         [{'name': 'one', 'agents': [{'speed': 3}]}, {'name': 'two', 'agents': [{'speed': 3}]}])


class RunTest(support.CrowdTestCase):
    """When a run that was done before counts as done."""

    def test_stamp_changes_with_all_that_it_is_made_from(self):
        scenario = self.write('scenario.yaml', 'name: one\n')
        recipe = self.write('recipe.yaml', 'training: {scenarios: [scenario.yaml]}\n')

        def stamp(*words):
            return Run(pathlib.Path(self.folder), [['train', recipe, *words]]).stamp()

        stamps = [stamp('--seed', 1)]
        self.assertEqual(stamp('--seed', 1), stamps[0])
        stamps.append(stamp('--seed', 2))
        self.write('scenario.yaml', 'name: another\n')
        stamps.append(stamp('--seed', 1))
        self.write('recipe.yaml', 'training: {scenarios: [scenario.yaml], episodes: 7}\n')
        stamps.append(stamp('--seed', 1))
        os.remove(scenario)
        with self.assertRaises(OSError):
            stamp('--seed', 1)
        self.assertEqual(len(set(stamps)), 4)


class MotionTest(support.CrowdTestCase):
    """Where moving obstacles are drawn."""

    def place(self, time, **motion):
        """The place of an obstacle that starts at (1, 2)."""
        rest = {'position': (1.0, 2.0), 'velocity': (0.0, 0.0), 'to_and_fro': [], 'waypoints': [], 'speed': 0.5}
        return place_of(dict(rest, **motion), time)

    def test_at_rest_and_straight_on(self):
        self.assertEqual(self.place(9.0), (1.0, 2.0))
        self.assertEqual(self.place(4.0, velocity=(0.5, -1.0)), (3.0, -2.0))

    def test_to_and_fro(self):
        # 3 m along y and 4 m along x at 0.5 m/s: after 8 s 1 m of the second leg, after 20 s 10 m, that is 4 m back.
        way = [(1.0, 5.0), (5.0, 5.0)]
        self.assertEqual(self.place(8.0, to_and_fro=way), (2.0, 5.0))
        self.assertEqual(self.place(20.0, to_and_fro=way), (2.0, 5.0))
        self.assertEqual(self.place(28.0, to_and_fro=way), (1.0, 2.0))

    def test_round_and_round(self):
        # A triangle of 3, 4 and 5 m: after 16 s 8 m, 1 m into the way back, a fifth of it.
        x, y = self.place(16.0, waypoints=[(1.0, 5.0), (5.0, 5.0)])
        self.assertAlmostEqual(x, 4.2)
        self.assertAlmostEqual(y, 4.4)


if __name__ == '__main__':
    support.run('reproduce_test')
