"""research/validate: the command line, a case, and the table of stored results."""
import json
import os
import stat

import pytest
from crowd_validation import program as cases
from crowd_validation.evaluation import Result, load, store
from crowd_validation.program import chapter_of
from programs import assert_says, in_package, read_text, tools_folder, wait_for


class ResultsTest:
    """Stored results and their table."""

    def test_the_table(self, tmp_path):
        for name, passed in (('rimea_1', True), ('rimea_6', False), ('rimea_14', None)):
            (tmp_path / name).mkdir()
            store(tmp_path / name, Result('measured', 'expected', passed, 'a jam' if passed is False else ''), 2)
        assert load(tmp_path / 'rimea_5') is None
        assert load(tmp_path / 'rimea_6') == (Result('measured', 'expected', False, 'a jam'), 2)
        results, remarks = chapter_of(tmp_path, [case.name for case in cases.ALL]).tables()
        assert [(row[0], row[4]) for row in results.rows] == [('rimea_1', 'yes'), ('rimea_6', 'no'),
                                                              ('rimea_14', 'reported')]
        assert remarks.rows == [['rimea_6', 'a jam']]


class ValidateTest:
    """The program."""

    def validate(self, runner, *words):
        """Starts research/validate with results in the test's folder."""
        return runner.start('validate', [in_package('research', 'validate'), *words, '--tools', tools_folder(),
                                         '--output', runner.path('results')])

    def test_the_first_case(self, runner):
        document = runner.write('page.md', '<!-- table validation/results -->\n<!-- end -->\n'
                                           '![One person](images/rimea_1.png)\n')
        os.mkdir(runner.path('images'))
        first = self.validate(runner, 'rimea_1', '--seeds', '2', '--document', document)
        assert first.wait() == 0, first.output()
        assert_says(first.output(), '[1/1] rimea_1', 'passed: yes', 'for 40 m')
        with open(runner.path('results/rimea_1/result.json'), encoding='utf-8') as stream:
            result = json.load(stream)
        # 40 m at 1.33 m/s take 30.08 s, and no tick is wasted.
        assert float(result['measured'].split()[0]) == pytest.approx(40.0 / 1.33, abs=0.3)
        assert result['passed'] is True
        assert_says(read_text(document), '| rimea_1 | Walking speed in a corridor |', '| 26-34 s | yes |')
        assert os.path.getsize(runner.path('images/rimea_1.png')) > 1000
        again = self.validate(runner, '--table')
        assert again.wait() == 0, again.output()
        assert_says(again.output(), 'rimea_1', '26-34 s')
        assert '[1/1]' not in again.output()

    def test_the_list(self, runner):
        listing = self.validate(runner, '--list')
        assert listing.wait() == 0, listing.output()
        assert_says(listing.output(), 'rimea_1 ', 'rimea_15', 'rimea_13        left out: ')

    @pytest.mark.parametrize('words, said', [
        (['rimea_99'], "no case 'rimea_99'; there are rimea_1, "),
        (['rimea_2'], "no case 'rimea_2': walking up stairs"),
        (['rimea_1', '--seeds', '0'], 'expected a whole number from 1'),
        (['rimea_1', '--sedes', '2'], '--sedes'),
    ])
    def test_wrong_usage(self, runner, words, said):
        refused = self.validate(runner, *words)
        assert refused.wait() == 2, refused.output()
        assert_says(refused.output(), said)
        assert not os.path.exists(runner.path('results'))

    def test_a_missing_table(self, runner):
        refused = self.validate(runner, 'rimea_1', '--q-table', runner.path('nowhere.txt'))
        assert refused.wait() == 1, refused.output()
        assert_says(refused.output(), 'nowhere.txt: there is no such Q-table')

    def test_nothing_to_show(self, runner):
        refused = self.validate(runner, '--table')
        assert refused.wait() == 1, refused.output()
        assert_says(refused.output(), 'has no results')

    def test_interrupted(self, runner):
        running = self.validate(runner, 'rimea_11', '--seeds', '1')
        log = runner.path('results/rimea_11/runs/room_1/log.txt')
        wait_for(lambda: os.path.exists(log) and 'evaluate' in read_text(log), 'the first run')
        assert running.stop() == 130, running.output()
        assert_says(running.output(), 'Interrupted; the finished runs are kept in')
        assert not os.path.exists(runner.path('results/rimea_11/result.json'))

    def test_a_tool_that_fails(self, runner):
        for tool in ('train', 'evaluate'):
            runner.write(tool, '#!/bin/sh\necho the disk is on fire >&2\nexit 3\n')
            os.chmod(runner.path(tool), stat.S_IRWXU)
        failing = runner.start('validate', [in_package('research', 'validate'), 'rimea_1', '--tools', runner.folder,
                                            '--output', runner.path('results')])
        assert failing.wait() == 1
        assert_says(failing.output(), 'exit status 3', 'the disk is on fire')
