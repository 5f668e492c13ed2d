"""train: its log, and its plot in a terminal."""
import csv

import pytest
from learning_files import QTableFile
from terminals import run_in_terminal
from trainings import Training, config_of


class LogTest:
    """train --log."""

    def test_rows(self, runner):
        """The log agrees with the record, the table and the schedule of epsilon."""
        training = Training(runner, config_of(runner, 'crowd', 30), 'a', '--episodes', 30)
        status, output = training.run()
        assert status == 0, output
        with open(training.files['log'], newline='', encoding='utf-8') as stream:
            rows = list(csv.DictReader(stream))
        with open(training.files['record'], newline='', encoding='utf-8') as stream:
            agents = list(csv.DictReader(stream))
        assert [row['episode'] for row in rows] == [str(i) for i in range(30)]
        for row in rows:
            mine = [agent for agent in agents if agent['episode'] == row['episode']]
            assert (row['scenario'], row['agents']) == ('circle6', '6')
            for share, column in (('success', 'arrived'), ('contact', 'touched'), ('collision', 'collided')):
                assert float(row[share]) == sum(int(agent[column]) for agent in mine) / 6
            assert int(row['decisions']) == sum(int(agent['ticks']) for agent in mine)
            assert float(row['epsilon']) == pytest.approx(0.3 + int(row['episode']) / 4000 * (0.02 - 0.3))
            assert -25 < float(row['reward']) < 0  # `progress`: 0 is the best
        visited = [int(row['visited_rows']) for row in rows]
        assert visited == sorted(visited)
        table = QTableFile(training.files['output'])
        assert visited[-1] == table.header['visited_rows']
        assert sum(int(row['decisions']) for row in rows) == table.header['decisions']


class PlotTest:
    """train --plot, in a pseudo-terminal."""

    TITLES = ('success [%]', 'contact [%]', 'mean reward', 'visited rows', 'epsilon')

    def train(self, runner, columns, rows, episodes, typed=''):
        """Trains in a terminal. Returns exit status and the lines of the screen."""
        training = Training(runner, config_of(runner, 'traces', episodes), 'a', '--plot')
        status, screen = run_in_terminal(training.command, columns, rows, typed)
        print('\n'.join(screen.lines()))
        assert screen.x == 0  # what follows begins a line
        return status, screen.lines()

    @pytest.mark.parametrize('columns, rows, across', [(80, 24, 2), (120, 30, 3), (200, 50, 5)])
    def test_final_screen(self, runner, columns, rows, across):
        """Each panel is there once; below them the bar, and what the program prints at its end."""
        status, lines = self.train(runner, columns, rows, 600)
        assert status == 0
        text = '\n'.join(lines)
        first = next(line for line in lines if 'contact [%]' in line)
        assert [title in first for title in self.TITLES[1:]] == [i < across for i in range(1, 5)]
        for title in self.TITLES:
            assert text.count(title) == 1
        assert 'episodes 0 to 599, about ' in text
        bar = next(i for i, line in enumerate(lines) if line.startswith('episode [######'))
        assert lines[bar].startswith('episode [########################] 600/600  left 0:00  success')
        assert lines[bar + 1].startswith(f'{runner.path("a.output")}: 600 episodes, '[:columns])
        dots = sum('\u2801' <= character <= '\u28ff' for character in text)
        assert dots > 5 * 20

    def test_curves_go_on(self, runner):
        """After an interruption they have the episodes of the log."""
        training = Training(runner, config_of(runner, 'traces', 200), 'a')
        assert training.run([*training.resuming(), '--episodes', '100'])[0] == 0
        status, screen = run_in_terminal([*training.resuming(), '--plot'], 80, 24)
        assert status == 0
        assert 'episodes 0 to 199' in '\n'.join(screen.lines())

    def test_interruption(self, runner):
        """Ctrl-C leaves one picture, the bar and the last message."""
        status, lines = self.train(runner, 120, 40, 10**6, '\x03')
        assert status == 130
        text = '\n'.join(lines)
        assert [text.count(title) for title in self.TITLES] == [1] * 5
        assert [line.startswith('episode [') for line in lines].count(True) == 1
        assert '; interrupted' in text
        assert text.count('^C') <= 1
