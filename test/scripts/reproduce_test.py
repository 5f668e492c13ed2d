"""research/reproduce: results, continuation, interruption, and variations of shipped files."""
import csv
import glob
import os
import pathlib
import re
import stat
import statistics

import pytest
import yaml
from crowd_drawing.files import place_of
from crowd_experiments.pages import Chapter, fill_document, write_chapters
from crowd_experiments.runs import Run
from crowd_experiments.variations import Setting, changed, vary_config, vary_scenario
from crowd_reproduction import claim, claims, reward_judges
from programs import assert_says, in_package, read_text, tools_folder, wait_for

REWARDS = ('distance_gained', 'cosine_cubed')


class ReproduceTest:
    """The complete program."""

    def reproduce(self, runner, *words):
        """Starts research/reproduce with results in the test's folder."""
        return runner.start('reproduce', [in_package('research', 'reproduce'), *words, '--tools', tools_folder(),
                                          '--results', runner.path('results')])

    def stamps(self, runner):
        """Returns the stamps of the complete runs."""
        return set(glob.glob(runner.path('results/runs/*/*/done.txt')))

    def test_quick_from_end_to_end(self, runner):
        document = runner.write('page.md', '<!-- table reward_evaluation/more_training -->\n<!-- end -->\n')
        first = self.reproduce(runner, 'reward_evaluation', '--quick', '--document', document)
        assert first.wait() == 0, first.output()
        # Two rewards, two seeds, two readings: better parameters (as a third), longer training; directions with one
        # reward.
        assert len(self.stamps(runner)) == 4 * 3 + 4 * 2 + 2 * 2 * 2
        assert read_text(document).count(' training episodes, ') == 16
        page = read_text(runner.path('results/index.html'))
        assert '4.1-4.12' in page
        assert 'research/reproduce reward_evaluation' in page
        assert '<script' not in page
        figures = {'fig_4_01.png', *(f'fig_4_{number:02d}{parameters}.png' for number in range(2, 13)
                                     for parameters in ('', '_better'))}
        assert set(os.listdir(runner.path('results/figures'))) == figures
        assert page.count('<img src="data:image/png;base64,') == len(figures)
        self.check_table(runner)
        self.check_claims(runner)
        self.check_continuation(runner)

    def check_table(self, runner):
        """Compares the success in the table with values computed from the records."""
        table = read_text(runner.path('results/tables/reward_evaluation.md'))
        for reward, name in zip(REWARDS, ('distance gained', 'cos³')):
            shares = [self.success_in(runner, f'{reward}_better_{seed:02d}/demo.csv') for seed in (1, 2)]
            row = re.search(rf'^\| better parameters, demo, {name} \|.*$', table, re.MULTILINE)[0]
            assert (f'| {statistics.mean(shares):.2f} ± {statistics.stdev(shares):.2f} '
                    f'({min(shares):.2f}-{max(shares):.2f}) |') in row

    def success_in(self, runner, record):
        """Returns the share of the episodes of a record in which the agent arrived [%]."""
        with open(runner.path(f'results/runs/reward_evaluation/{record}'), encoding='utf-8') as stream:
            rows = list(csv.DictReader(stream))
        assert len(rows) == 20
        return 100.0 * sum(row['arrived'] == '1' for row in rows) / len(rows)

    def check_claims(self, runner):
        """Checks that each claim about the rewards is judged from the records."""
        setting = Setting(pathlib.Path(), pathlib.Path(in_package('config')),
                          pathlib.Path(runner.path('results')), quick=True)
        judged = [entry for entry in claims.DECLARED
                  if all(hasattr(reward_judges, judge) for judge, *_ in entry['judges'])]
        assert len(judged) > 30
        found = claims.judge(setting, claims.claims_of(judged))
        assert [len(of_reading) for of_reading in found.values()] == [len(judged)] * 4
        assert {one.verdict for of_reading in found.values() for one in of_reading} <= {
            claim.CONFIRMED, claim.PARTLY, claim.NOT_CONFIRMED}
        place, = [i for i, entry in enumerate(judged) if 'is inconclusive' in entry['says']]
        for reading in ('fading', 'constant'):
            arrivals = [self.success_in(runner, f'cosine_cubed_{reading}_{seed:02d}/demo.csv') for seed in (1, 2)]
            assert f'cos³ {statistics.mean(arrivals):.2f} ' in found[reading][place].measured

    def check_continuation(self, runner):
        """Complete runs are kept; an incomplete one is repeated."""
        os.remove(sorted(self.stamps(runner))[0])
        again = self.reproduce(runner, 'reward_evaluation', '--quick')
        assert again.wait() == 0, again.output()
        assert '28 runs, 27 of them done before' in again.output()
        assert len(self.stamps(runner)) == 28

    def test_interrupted(self, runner):
        running = self.reproduce(runner, 'ambiguity')
        wait_for(lambda: self.stamps(runner), 'the first run')
        assert running.stop() == 130, running.output()
        done = re.search(r'Interrupted: (\d+) of 128 runs are done and kept', running.output())
        assert done is not None, running.output()
        assert len(self.stamps(runner)) == int(done[1])

    def test_a_tool_that_fails(self, runner):
        for tool in ('train', 'evaluate'):
            runner.write(tool, '#!/bin/sh\necho the disk is on fire >&2\nexit 3\n')
            os.chmod(runner.path(tool), stat.S_IRWXU)
        failing = runner.start('reproduce', [in_package('research', 'reproduce'), 'sharing', '--quick',
                                             '--tools', runner.folder, '--results', runner.path('results')])
        assert failing.wait() == 1
        assert_says(failing.output(), 'exit status 3', 'the disk is on fire')
        assert self.stamps(runner) == set()

    def test_unknown_experiment(self, runner):
        unknown = self.reproduce(runner, 'alchemy')
        assert unknown.wait() == 2
        assert_says(unknown.output(), 'alchemy', 'reward_evaluation')


class PagesTest:
    """What is written into documents."""

    def test_phrases_and_tables(self, runner):
        chapter = Chapter('claims', 'Claims', phrases={'tally': 'Of 2 claims, 1 is confirmed.'})
        chapter.add_table('Verdicts', ['', 'verdict'], [['one', 'confirmed']], 'verdicts')
        document = runner.write('page.md', '# Page\n\n<!-- phrase claims/tally -->old<!-- end -->\n\n'
                                           '<!-- table claims/verdicts -->\nold\n<!-- end -->\n'
                                           '<!-- phrase claims/never -->kept<!-- end -->\n')
        missing = f'{document}: claims/never was not measured and is left unchanged'
        assert fill_document(document, [chapter]) == [missing]
        lines = read_text(document).splitlines()
        assert lines[2] == '<!-- phrase claims/tally -->Of 2 claims, 1 is confirmed.<!-- end -->'
        assert lines[5:8] == ['|  | verdict |', '|---|---|', '| one | confirmed |']
        assert lines[9] == '<!-- phrase claims/never -->kept<!-- end -->'

    def test_pages_of_chapters_with_the_pictures_that_are_there(self, tmp_path):
        pages, images = tmp_path / 'pages', tmp_path / 'pages' / 'images'
        images.mkdir(parents=True)
        chapter = Chapter('one', 'Chapter one', ['Text.'])
        for name in ('shown', 'other'):
            (tmp_path / f'{name}.png').write_text(name, encoding='utf-8')
            chapter.add_figure(tmp_path / f'{name}.png', f'Caption of {name}.')
        (images / 'shown.png').write_text('old', encoding='utf-8')
        write_chapters(pages, [chapter])
        assert read_text(pages / 'one.md') == (
            '# Chapter one\n\nText.\n\n![](images/shown.png)\n\nCaption of shown.\n')
        assert read_text(images / 'shown.png') == 'shown'
        assert not (images / 'other.png').exists()


class VariationsTest:
    """Variations of shipped files."""

    def setting(self, runner):
        """Returns a Setting with its own config/."""
        config, results = pathlib.Path(runner.path('config')), pathlib.Path(runner.path('results'))
        for folder in ('experiments', 'scenarios'):
            (config / folder).mkdir(parents=True, exist_ok=True)
        return Setting(pathlib.Path(), config, results, experiments=config / 'experiments')

    def test_changes_by_the_paths_of_keys(self):
        scene = {'agents': [{'speed': 1, 'heading': 0}, {'speed': 2}], 'order': 'sequential'}
        other = changed(scene, {'agents.*.heading': 'goal', 'agents.1.speed': [3, 4], 'order': None, 'colour': None,
                                'learning.epsilon': 0.2})
        assert other == {'agents': [{'speed': 1, 'heading': 'goal'}, {'speed': [3, 4], 'heading': 'goal'}],
                         'learning': {'epsilon': 0.2}}
        assert scene['order'] == 'sequential'  # is unchanged
        with pytest.raises(ValueError):
            changed(scene, {'obstacles.*.radius': 0.2})

    def test_config(self, runner):
        setting = self.setting(runner)
        runner.write('config/experiments/base.yaml', 'learning: {gamma: 0.1, epsilon: 0.1}\n'
                                                     'training: {scenarios: [../scenarios/a.yaml], episodes: 7}\n')
        changes = {'learning.epsilon': {'from': 1, 'to': 0}, 'training.episodes': 9}
        file = vary_config(setting, 'base', changes, 'varied')
        assert file == pathlib.Path(runner.path('results/configs/varied.yaml'))
        training = {'scenarios': [str(pathlib.Path(runner.path('config/scenarios/a.yaml')).resolve())], 'episodes': 9}
        learning = {'gamma': 0.1, 'epsilon': {'from': 1, 'to': 0}}
        assert yaml.safe_load(read_text(file)) == {'learning': learning, 'training': training}
        os.utime(file, (1, 1))
        vary_config(setting, 'base', changes, 'varied')
        assert os.stat(file).st_mtime == 1  # the file was already up to date
        other = vary_config(setting, file, {}, 'other', [pathlib.Path('/b.yaml')])
        assert yaml.safe_load(read_text(other))['training']['scenarios'] == ['/b.yaml']

    def test_scenario_with_all_its_documents(self, runner):
        setting = self.setting(runner)
        runner.write('config/scenarios/two.yaml', 'name: one\nagents: [{speed: 1}]\n---\n'
                                                  'name: two\nagents: [{speed: 2}]\n')
        file = vary_scenario(setting, 'two', {'agents.*.speed': 3}, 'fast')
        assert list(yaml.safe_load_all(read_text(file))) == [{'name': 'one', 'agents': [{'speed': 3}]},
                                                             {'name': 'two', 'agents': [{'speed': 3}]}]


class RunTest:
    """Conditions under which a previous run counts as done."""

    def test_stamp_depends_on_all_inputs(self, runner):
        scenario = runner.write('scenario.yaml', 'name: one\n')
        config = runner.write('config.yaml', 'training: {scenarios: [scenario.yaml]}\n')

        def stamp(*words):
            return Run(pathlib.Path(runner.folder), [['train', config, *words]]).stamp()

        stamps = [stamp('--seed', 1)]
        assert stamp('--seed', 1) == stamps[0]
        stamps.append(stamp('--seed', 2))
        runner.write('scenario.yaml', 'name: another\n')
        stamps.append(stamp('--seed', 1))
        runner.write('config.yaml', 'training: {scenarios: [scenario.yaml], episodes: 7}\n')
        stamps.append(stamp('--seed', 1))
        # What a scenario names, directly or not.
        named = {'hall.yaml': 'image: hall.png\n', 'hall.png': 'png', 'walks.csv': 'walks', 'own.yaml': 'child: {}\n'}
        for name, text in named.items():
            runner.write(name, text)
        runner.write('scenario.yaml', 'map: hall.yaml\nrecorded: [{file: walks.csv}]\nkinds: own.yaml\n')
        stamps.append(stamp('--seed', 1))
        for name, text in named.items():
            runner.write(name, text + '# changed\n')
            stamps.append(stamp('--seed', 1))
        os.remove(scenario)
        with pytest.raises(OSError):
            stamp('--seed', 1)
        assert len(set(stamps)) == 9


class MotionTest:
    """Positions of moving obstacles in drawings."""

    def place(self, time, **motion):
        """Returns the position of an obstacle that starts at (1, 2)."""
        rest = {'position': (1.0, 2.0), 'velocity': (0.0, 0.0), 'to_and_fro': [], 'waypoints': [], 'speed': 0.5}
        return place_of(dict(rest, **motion), time)

    def test_static_and_straight_on(self):
        assert self.place(9.0) == (1.0, 2.0)
        assert self.place(4.0, velocity=(0.5, -1.0)) == (3.0, -2.0)

    def test_to_and_fro(self):
        # 3 m along y and 4 m along x at 0.5 m/s: 1 m of the second leg after 8 s; 10 m after 20 s, which is 4 m back.
        path = [(1.0, 5.0), (5.0, 5.0)]
        assert self.place(8.0, to_and_fro=path) == (2.0, 5.0)
        assert self.place(20.0, to_and_fro=path) == (2.0, 5.0)
        assert self.place(28.0, to_and_fro=path) == (1.0, 2.0)

    def test_closed_path(self):
        # A triangle of 3, 4 and 5 m: 8 m after 16 s, which is 1 m (a fifth) of the third side.
        x, y = self.place(16.0, waypoints=[(1.0, 5.0), (5.0, 5.0)])
        assert x == pytest.approx(4.2, abs=1e-7)
        assert y == pytest.approx(4.4, abs=1e-7)
