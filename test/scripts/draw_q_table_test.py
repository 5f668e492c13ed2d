"""scripts/draw_q_table: heat maps of Q-tables, and the meaning of their rows."""
import os
import subprocess

import PIL.Image
import numpy
import pytest
from crowd_drawing.errors import InputError
from crowd_tables import table as state_sets
from crowd_tables.program import arranged, explanation
from crowd_tables.table import action_names, greedy_actions, read_table, row_values, row_visits
from learning_files import QTableFile, q_table_text
from programs import ANTICIPATION_TABLE, NEAREST_TABLE, OCCUPANCY_TABLE, PATIENCE, assert_says, in_package, read_text
from roslib.packages import find_node

HEADER = '''social_crowd Q-table 1
state_set: %s
action_set: {type: kings_moves, rotations: 4, stay: true}
reward: {goal: cosine_cubed, obstacle_cost: 10}
rows: %d
actions: 5
visited_rows: 0
---
checksum: 0
'''


def draw(runner, *arguments):
    """Runs the program in the test's folder. Returns exit status and output."""
    command = [in_package('scripts', 'draw_q_table'), '--tools', os.path.dirname(train()), *map(str, arguments)]
    done = subprocess.run(command, cwd=runner.folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          timeout=PATIENCE, check=False)
    return done.returncode, done.stdout.decode(errors='replace')


def train():
    """Returns the program that describes rows."""
    return find_node('social_crowd', 'train')[0]


def meaning_of(table):
    """Returns the meaning of the rows of a Table."""
    return state_sets.meaning_of(table, train())


def meaning(runner, state_set, rows):
    """Returns the meaning of the rows of a table without visits."""
    return meaning_of(read_table(runner.write('table.txt', HEADER % (state_set, rows))))


class MeaningTest:
    """Rows by the formulas of docs/state_sets.md, worked out by hand."""

    def test_nearest_obstacle(self, runner):
        """Rows 0-7: no obstacle. Then 16 rows for each goal sector: 8 obstacle sectors with 2 distances each. 136 is
        arrival."""
        found = meaning(runner, '{type: nearest_obstacle, goal_sectors: 8}', 137)
        assert found.describe(1) == 'goal: ahead left; nearest obstacle: none'
        assert found.describe(8) == 'goal: ahead; nearest obstacle: left 0-15°, up to 0.5 m'
        assert found.describe(8 + 2 * 16 + 2 * 5 + 1) == 'goal: left; nearest obstacle: right 15-45°, up to 1 m'
        assert found.describe(136) == 'arrival'

    def test_occupancy(self, runner):
        """Row = goal * 3^4 + 27 ahead + 9 left + 3 behind + right with four sectors."""
        found = meaning(runner, '{type: occupancy, sectors: 4, collision_radius: 0.4, vision_radius: 2}', 4 * 81 + 1)
        assert found.describe(2 * 81 + 27 + 2 * 3) == \
            'goal: -180°; body 0°: up to 0.4 m; body 90°: empty; body -180°: up to 2 m; body -90°: empty'
        assert found.describe(4 * 81) == 'arrival'

    def test_condensed_occupancy(self, runner):
        """Row = goal * 2 * 2^8 + near * 2^8 + sum of occupied[i] * 2^(7 - i)."""
        found = meaning(runner, '{type: condensed_occupancy}', 4097)
        text = found.describe(7 * 512 + 256 + 128 + 1)
        assert_says(text, 'goal: ahead right', 'any body within 0.5 m: yes', 'body ahead: yes', 'body ahead right: yes',
                    'body left: no')

    def test_anticipation(self):
        """Row 6136 of a table with the default limits has the digits 7, 3, 5, 3, 0, 0; no limit is left out."""
        found = meaning_of(read_table(ANTICIPATION_TABLE))
        assert found.digits[6136].tolist() == [7, 3, 5, 3, 0, 0]
        assert_says(found.describe(6136), 'reciprocal time to collision: ≥ 6 s', 'static bodies: ≥ 4.5 s',
                    'turn: < 4°', 'approach of another agent: < 1.2 of the maximum speed')
        assert_says(found.describe(6143), 'turn: ≥ 45°', '≥ 1.2')
        assert_says(found.describe(0), 'reciprocal time to collision: < 0.5 s', 'fraction of the move: < 0.05')

    def test_quantities_that_are_not_used(self, runner):
        found = meaning(runner, '{type: anticipation, reciprocal_times: [1], turns: [90], constant_velocity_times: [], '
                        'static_times: [], admissible_fractions: [], oncoming: []}', 4)
        assert_says(found.describe(1), 'reciprocal time to collision: < 1 s', 'turn: ≥ 90°',
                    'static bodies: any')

    def test_rows_of_decisions(self, runner):
        """The program `evaluate` finds the rows that this module explains: without anybody near, agents that head for
        their goals are in a row with the goal ahead and without an obstacle."""
        runner.tool('evaluate', '--q-table', NEAREST_TABLE, '--states', runner.folder, 'circle6')
        found = meaning_of(read_table(NEAREST_TABLE))
        decisions = [line.split(',') for line in read_text(runner.path('circle6.csv')).splitlines()[1:]]
        alone = [found.describe(int(decision[6])) for decision in decisions if not decision[8]]
        near = [(found.describe(int(decision[6])), decision[8].split(':')) for decision in decisions if decision[8]]
        assert alone and near
        assert all(text.endswith('nearest obstacle: none') for text in alone)
        for text, (begin, end, distance) in near:
            side, low, high = ('left', begin, end) if float(begin) >= 0 else ('right', end[1:] or '0', begin[1:])
            radius = {'1': 0.5, '2': 1}[distance]
            assert_says(text, f'{side} {abs(float(low)):g}-{abs(float(high)):g}°, up to {radius:g} m')


class TableTest:
    """Reading tables, and a number for each row."""

    def table(self, runner):
        """Row 0: action 2 visited 3 times with -1, action 5 once with -2. Row 20: action 0 with 4. Row 30: nothing."""
        rows = {0: {2: (3, -1.0), 5: (1, -2.0)}, 20: {0: (2, 4.0)}}
        return read_table(runner.write('table.txt', q_table_text(rows)))

    def test_values(self, runner):
        table = self.table(runner)
        assert (row_visits(table)[0], row_visits(table)[20], row_visits(table).sum()) == (4, 2, 6)
        highest, mean = row_values(table, 'nearest_obstacle'), row_values(table, 'anticipation')
        assert (highest[0], highest[20], mean[0], mean[20]) == (-1, 4, -1.25, 4)
        assert numpy.isnan(highest[30]) and numpy.isnan(mean[30])
        assert greedy_actions(table)[[0, 20]].tolist() == [0, 0]  # the first action without a visit has the value 0

    def test_places_in_the_picture(self, runner):
        """Row 20 is the goal ahead and obstacle class 13 of 17: column 0, line 13."""
        table = self.table(runner)
        pictures = arranged(meaning_of(table), row_values(table, 'nearest_obstacle'))
        assert pictures.shape == (1, 17, 8)
        assert numpy.argwhere(numpy.isfinite(pictures)).tolist() == [[0, 0, 0], [0, 13, 0]]

    @pytest.mark.parametrize('file', [NEAREST_TABLE, OCCUPANCY_TABLE, ANTICIPATION_TABLE])
    def test_shipped_tables(self, file):
        """Every row but that of arrival is in the picture once."""
        table, expected = read_table(file), QTableFile(file)
        found = meaning_of(table)
        assert table.visits.sum() == expected.visits()
        row = max(expected.rows)
        assert list(zip(table.visits[row], table.values[row])) == expected.rows[row]
        numbers = arranged(found, numpy.arange(table.header['rows'], dtype=float)).ravel()
        placed = numbers[numpy.isfinite(numbers)]
        assert sorted(placed) == list(range(table.header['rows'] - len(found.extra)))
        assert_says(explanation(found), 'From top to bottom: ', 'From left to right: ')

    def test_actions(self, runner):
        assert action_names(self.table(runner))[:2] == ['ahead', 'turn by +45°']
        stay = read_table(runner.write('t.txt', HEADER % ('{type: occupancy}', 52489)))
        assert action_names(stay) == ['ahead', 'turn by +90°', 'turn by -180°', 'turn by -90°', 'stay']
        names = action_names(read_table(ANTICIPATION_TABLE))
        assert names[:3] == ['0° from the goal', 'left 10° from the goal', 'right 10° from the goal']
        assert (names[13], names[14], names[-1]) == ('180° from the goal', '0° from the goal, slow', 'stay')

    @pytest.mark.parametrize('rotations', ['0', 'many'])
    def test_actions_that_are_none(self, runner, rotations):
        text = (HEADER % ('{type: occupancy}', 52489)).replace('rotations: 4', f'rotations: {rotations}')
        with pytest.raises(InputError, match='t.txt: action_set: '):
            action_names(read_table(runner.write('t.txt', text)))

    @pytest.mark.parametrize('old, new, words', [
        ('social_crowd Q-table 1', 'instance,tick', ["t.txt:1: is not a Q-table; expected 'social_crowd Q-table 1'"]),
        ('rows: 137\n', '', ['t.txt: the header has no rows']),
        ('rows: 137', 'rows: 140', ['t.txt: rows: expected 137', 'got 140']),
        ('rows: 137', 'rows: many', ["t.txt: rows: expected a whole number, got 'many'"]),
        ('type: nearest_obstacle', 'type: nearest', ["state_set: type: expected nearest_obstacle", "got 'nearest'"]),
        ('state_set: {', 'state_set: occupancy # {', ["state_set: expected a map, got 'occupancy'"]),
        ('action_set: {', 'action_set: kings_moves # {', ["action_set: expected a map, got 'kings_moves'"]),
        ('rows: 137', 'rows: 1000000000000', ['rows: expected at most 100000000 values, got 1000000000000 rows']),
        ('\n0 0 0', '\n0 none 0', ['t.txt:15: expected a row from 0 to 136, with visits and value of 8 actions']),
        ('\n20 ', '\n200 ', ['t.txt:16: expected a row from 0 to 136']),
        ('visited_rows: 2', 'visited_rows: 3', ['t.txt:17: expected a row from 0']),
    ])
    def test_errors(self, runner, old, new, words):
        self.table(runner)
        text = read_text(runner.path('table.txt'))
        assert old in text
        with pytest.raises(InputError) as caught:
            meaning_of(read_table(runner.write('t.txt', text.replace(old, new, 1))))
        assert_says(str(caught.value), *words)


class ProgramTest:
    """The program."""

    @pytest.mark.parametrize('file, words', [(NEAREST_TABLE, '136 of 137 rows visited'),
                                             (OCCUPANCY_TABLE, '13156 of 52489 rows visited'),
                                             (ANTICIPATION_TABLE, 'of 6144 rows visited')])
    def test_pictures(self, runner, file, words):
        status, output = draw(runner, file, '--output', 'table.png')
        assert status == 0, output
        assert_says(output, 'table.png: ', words)
        with PIL.Image.open(runner.path('table.png')) as picture:
            colours = picture.convert('RGB').getcolors(10**6)
        assert len(colours) > 200  # of values and visits

    def test_an_empty_table(self, runner):
        runner.write('table.txt', q_table_text({}))
        status, output = draw(runner, 'table.txt', '--output', 'table.svg')
        assert status == 0, output
        assert_says(output, '0 of 137 rows visited, 0 visits')
        assert_says(read_text(runner.path('table.svg')), '<!-- nearest obstacle -->')

    def test_a_row(self, runner):
        runner.write('table.txt', q_table_text({8: {1: (3, -1.5)}}))
        status, output = draw(runner, 'table.txt', '--row', 8)
        assert status == 0, output
        lines = output.splitlines()
        assert lines[0] == 'row 8: goal: ahead; nearest obstacle: left 0-15°, up to 0.5 m'
        assert lines[2].split() == ['turn', 'by', '+45°', '3', 'visits', 'value', '-1.5']
        assert lines[1].split() == ['ahead', '0', 'visits']
        assert os.listdir(runner.folder) == ['table.txt']

    @pytest.mark.parametrize('status, arguments, words', [
        (2, [NEAREST_TABLE], ['expected --output or --row']),
        (2, [NEAREST_TABLE, '--row', '-1'], ['--row', 'a whole number from 0']),
        (1, [NEAREST_TABLE, '--row', '137'], ['--row: expected 0 to 136, got 137']),
        (1, ['none.txt', '--output', 'a.png'], ['none.txt: No such file']),
        (2, [NEAREST_TABLE, '--output', 'a.xyz'], ['xyz', 'png']),
        (1, [NEAREST_TABLE, '--output', 'none/a.png'], ['none/a.png: cannot be written: there is no folder /']),
    ])
    def test_errors(self, runner, status, arguments, words):
        got, output = draw(runner, *arguments)
        assert got == status, output
        assert_says(output, *words)
        assert 'Traceback' not in output
        assert os.listdir(runner.folder) == []
