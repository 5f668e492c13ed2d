"""research/crowded_robot: its scenarios, and what it measures of a log."""
import json

import numpy
import pytest
from crowd_drawing.errors import read_documents
from crowd_experiments.runs import LOG, Run, RunError
from crowd_studies import crowded_robot
from programs import ANTICIPATION_TABLE, assert_says


class DocumentTest:
    """The table of a document is there before anything is driven."""

    def test_a_table_that_the_document_has_not(self, tmp_path):
        page = tmp_path / 'page.md'
        page.write_text('<!-- table crowded/move_base -->\n<!-- end -->\n', encoding='utf-8')
        output = tmp_path / 'results'
        with pytest.raises(RunError) as refused:
            crowded_robot.main(['--robot', 'move_base_people', '--document', str(page), '--output', str(output)])
        assert_says(str(refused.value), 'page.md: has the tables crowded/move_base; to get this one, add the lines '
                    '<!-- table crowded/move_base_people -->')
        assert not output.exists()
        page.write_text('', encoding='utf-8')
        with pytest.raises(RunError, match='has no tables; '):
            crowded_robot.main(['--document', str(page), '--output', str(output)])

    def test_the_table_is_filled(self, monkeypatch, tmp_path):
        """With rows of runs that are not driven here."""
        monkeypatch.setattr(crowded_robot, 'execute_left', lambda runs, processes: None)
        monkeypatch.setattr(crowded_robot, 'row_of', lambda run, scene, seed: [scene, str(seed), *7 * ['-']])
        page = tmp_path / 'page.md'
        page.write_text('<!-- table crowded/move_base_people -->\n<!-- end -->\n', encoding='utf-8')
        crowded_robot.main(['--robot', 'move_base_people', '--seeds', '4', '--document', str(page)])
        rows = [f"| {scene} | 4 {7 * '| - '}|\n" for scene in crowded_robot.SCENES]
        assert ''.join([*rows, '<!-- end -->']) in page.read_text(encoding='utf-8')


class MeasuresTest:
    """Numbers that are worked out by hand."""

    def test_encounters(self):
        """Two times within 1 m; a third one in which the person stands; a fourth one ends with the log."""
        rims = numpy.array([2.0, 0.9, 0.5, 0.2, 1.5, 0.7, 1.2, 0.1, 3.0, 0.4])
        walks = numpy.array([True, True, True, False, True, True, True, False, True, True])
        assert crowded_robot.encounters_of(rims, walks) == [0.5, 0.7, 0.4]
        assert crowded_robot.encounters_of(rims, walks & False) == []

    @pytest.mark.parametrize('flags, longest', [([], 0), ([0, 0], 0), ([1, 1, 0, 1], 2), ([0, 1, 0, 1, 1, 1], 3)])
    def test_longest(self, flags, longest):
        assert crowded_robot.longest_true(numpy.array(flags, dtype=bool)) == longest

    def test_a_walk(self, tmp_path):
        """The robot drives to the first of two goals in 2 ticks and stands for 2; the person comes to 0.4 m."""
        robot = {'name': 'robot', 'radius': 0.25, 'goals': [[2, 0], [9, 0]], 'goal_tolerance': 0.3}
        lines = [{'tick_duration': 0.5, 'robots': [robot]}]
        for tick, (x, y) in enumerate(((0, 5), (1, 3), (2, 2), (2, 0.9), (2, 1.5))):
            person = {'id': 7, 'x': 2, 'y': y}
            lines.append({'tick': tick, 'robots': [{'x': x, 'y': 0, 'heading': 0}],
                          'people': [{**person, 'radius': 0.25} if tick == 0 else person]})
        file = tmp_path / 'log.jsonl'
        file.write_text(''.join(json.dumps(line) + '\n' for line in lines), encoding='utf-8')
        walk = crowded_robot.read_walk(file)
        assert (walk.goals, walk.reached, walk.stands, walk.longest) == (2, 1, 0.5, 1.0)
        assert walk.clearances == pytest.approx([0.4])

    @pytest.mark.parametrize('scene', crowded_robot.SCENES)
    def test_a_run(self, runner, tmp_path, scene):
        """Of a robot that stands, as a run of drive_robots leaves it."""
        document, = read_documents(crowded_robot.FLOORS / f'{scene}.yaml')
        assert (document['name'], len(document['robots'][0]['goals'])) == (scene, 10)
        short = {**document, 'duration': 1, 'map': str(crowded_robot.FLOORS / document['map'])}
        logs = tmp_path / crowded_robot.LOGS
        logs.mkdir()
        runner.tool('evaluate', '--q-table', ANTICIPATION_TABLE, '--robot', 'none', '--robots-csv',
                    tmp_path / crowded_robot.RECORD, '--robot-log', logs / f'{scene}.jsonl',
                    runner.write(f'{scene}.yaml', json.dumps(short)))
        (tmp_path / LOG).write_text('DWA planner failed to produce path.\n' * 3, encoding='utf-8')
        row = crowded_robot.row_of(Run(tmp_path, []), scene, 4)
        assert row[:5] == [crowded_robot.SCENES[scene], '4', '0 of 10', '-', '100, 1']
        assert (row[6], row[8], len(row)) == ('0', '3', len(crowded_robot.HEADER))
