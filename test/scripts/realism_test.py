"""scripts/realism: measures by hand, windows of recordings made by hand, and runs with the program evaluate."""
import os
import pathlib
import signal
import subprocess

import numpy
import pandas
import pytest
from crowd_drawing.errors import InputError
from crowd_realism import forecasts, measures, peers, people
from crowd_recordings.formats import Recording
from programs import PATIENCE, assert_says, in_package, tools_folder, wait_for

REALISM = in_package('scripts', 'realism')
NAN = numpy.nan


def walker(places):
    return people.Walker(people.STEP * numpy.arange(len(places)), numpy.array(places, dtype=float))


def line(start, velocity, steps, first=0):
    """Returns a walk of constant velocity [m per frame]."""
    return [(first + k, start[0] + k * velocity[0], start[1] + k * velocity[1]) for k in range(steps)]


def moment(seen, future):
    seen = numpy.array(seen, dtype=float)
    return people.Moment(seen, numpy.array(future, dtype=float), seen[:, -1])


def standing(x, y, steps):
    return [(x, y)] * steps


class FiguresTest:
    """Figures of walkers."""

    def test_a_right_angle(self):
        """2 m/s, 2 steps east, 2 steps north: a turn of 90 degrees in 4 steps of 0.8 m."""
        found = measures.figures_of([walker([(0, 0), (0.8, 0), (1.6, 0), (1.6, 0.8), (1.6, 1.6)])])
        assert found['speed'] == pytest.approx([2])
        assert found['path_ratio'] == pytest.approx([3.2 / (1.6 * 2**0.5)])
        assert found['turning'] == pytest.approx([numpy.pi / 2 / 2.4])  # of the three steps with one before
        change = 2 * 2**0.5 / 0.4
        assert found['acceleration'] == pytest.approx([change / 3**0.5])
        assert found['lateral'] == pytest.approx([2 / 0.4 / 3**0.5])
        assert found['stop_share'] == [0]
        assert len(found['nearest']) == 0

    def test_nearest_and_stops(self):
        found = measures.figures_of([walker(standing(0, 0, 5)), walker([(3, 4), (3, 4), (0, 2), (3, 4), (3, 4)])])
        assert found['nearest'] == pytest.approx([2, 2])
        assert found['stop_share'] == pytest.approx([1, 0.5])

    def test_ks_distance(self):
        assert measures.ks_distance([1, 2, 3, 4], [1, 2, 3, 4]) == 0
        assert measures.ks_distance([1, 2], [3, 4]) == 1
        assert measures.ks_distance([1, 2, 3, 4], [3, 4, 5, 6]) == pytest.approx(0.5)
        assert numpy.isnan(measures.ks_distance([], [1]))

    def test_noise(self):
        """Errors of 5 cm in the places of people who walk straight."""
        ways = [walker([(0.5 * k, i) for k in range(50)]) for i in range(40)]
        assert people.noise_of(ways) == 0
        assert people.noise_of(people.with_noise(ways, 0.05)) == pytest.approx(0.05, rel=0.05)


class ErrorsTest:
    """Metrics of TrajNet++."""

    def test_displacements(self):
        """The person walks 0.1 m a step; it is predicted to stand."""
        way = [(0.1 * k, 0) for k in range(1, 13)]
        found = measures.errors_of([moment([standing(0, 0, 8)], [way])], [numpy.zeros((1, 12, 2))])
        assert found == pytest.approx({'windows': 1, 'ADE': 0.65, 'FDE': 1.2, 'Col-I': 0, 'Col-II': 0})

    def test_collisions(self):
        """The predicted person crosses the predicted way of another one, who goes elsewhere, and not his true one."""
        crossing = [(0, k - 6) for k in range(12)]
        both = moment([standing(9, 9, 8), standing(0, 0, 8)], [standing(9, 9, 12), standing(5, 5, 12)])
        found = measures.errors_of([both], [numpy.array([crossing, standing(0, 0, 12)], dtype=float)])
        assert (found['windows'], found['Col-I'], found['Col-II']) == (2, 100, 0)
        found = measures.errors_of([both], [numpy.array([standing(5.19, 5, 12), standing(0, 0, 12)], dtype=float)])
        assert (found['Col-I'], found['Col-II']) == (0, 50)

    @pytest.mark.parametrize('away, touches', [(0.19, True), (0.21, False)])
    def test_people_touch_between_two_steps(self, away, touches):
        path, other = numpy.array([(0.0, 0.0), (1.0, 0.0)]), numpy.array([(1.0, away), (0.0, away)])
        assert measures.collides(path, other[None]) == touches

    def test_people_out_of_view_are_not_touched(self):
        path = numpy.array(standing(0, 0, 3), dtype=float)
        assert not measures.collides(path, numpy.array([[(NAN, NAN), (0, 0), (NAN, NAN)]]))
        assert measures.collides(path, numpy.array([[(NAN, NAN), (0, 0), (0, 0)]]))


class WindowsTest:
    """Windows of recordings."""

    @staticmethod
    def count(recording):
        return sum(moment.complete().sum() for moment in people.moments_of(recording))

    def test_consecutive_samples(self):
        """Of 22 samples there are 3 windows; a missing sample ends them, and 19 samples have none."""
        walks = {1: line((0, 0), (0.5, 0), 22), 2: line((0, 5), (0.5, 0), 19)}
        assert self.count(Recording(walks, 0.4)) == 3
        walks[3] = line((0, 9), (0.5, 0), 20) + line((9, 9), (0.5, 0), 20, 21)
        assert self.count(Recording(walks, 0.4)) == 5

    def test_frames_within_a_step(self):
        """80 frames of 0.1 s are 20 samples, as are 6.4 frames of 1/16 s in a step, interpolated."""
        assert self.count(Recording({0: line((0, 0), (0.1, 0), 80)}, 0.1)) == 1
        assert self.count(Recording({0: line((0, 0), (0.1, 0), 123)}, 1 / 16)) == 1

    def test_everybody_in_view_is_in_a_moment(self):
        walks = {1: line((0, 0), (0.5, 0), 20), 2: line((0, 5), (0.5, 0), 3, 6), 3: line((0, 9), (0.5, 0), 5, 7)}
        found, = people.moments_of(Recording(walks, 0.4))  # at frame 7, where person 3 has no step yet
        assert found.seen.shape == (2, 8, 2) and found.complete().tolist() == [True, False]
        assert numpy.isfinite(found.seen[1, :, 0]).sum() == 2
        assert found.future[0, 0] == pytest.approx((4, 0)) and found.ends[1] == pytest.approx((1, 5))

    def test_nobody(self):
        with pytest.raises(InputError, match='no window'):
            people.moments_of(Recording({1: line((0, 0), (0.5, 0), 19)}, 0.4))
        with pytest.raises(InputError, match='has 1 walkers'):
            people.walkers_of(Recording({1: line((0, 0), (0.5, 0), 19), 2: line((9, 9), (0, 0), 19)}, 0.4))


class ForecastsTest:
    """Estimates of the velocity; models without evaluate."""

    def test_errors_of_places_are_averaged(self):
        """Steps of 0.6 m and 0.2 m by turns, four and three: the mean of them all."""
        seen = numpy.array([[(0.4 * k + (0.1 if k % 2 else -0.1), 0) for k in range(8)]])
        assert forecasts.last_step(seen)[0] == pytest.approx((1.5, 0))
        assert forecasts.weighted_steps(seen)[0] == pytest.approx((7.5 / 7, 0))

    def test_a_turn_is_not_averaged(self):
        """Changes of velocity that keep their direction are motion, also with people in view for two steps only."""
        seen = numpy.array([[(0.02 * k * k, 0) for k in range(8)], [(NAN, NAN)] * 6 + [(1, 1), (1, 2)]])
        assert forecasts.weighted_steps(seen) == pytest.approx(forecasts.last_step(seen))

    def test_goals(self):
        one = moment([[(0.4 * k, 0) for k in range(8)]], [standing(0, 0, 12)])._replace(ends=numpy.array([[4.0, 0]]))
        ahead, true = (forecasts.task_of(one, 'last', 0.5, knows) for knows in (False, True))
        assert ahead.goals[0] == pytest.approx((2.8 + forecasts.FAR, 0))
        assert forecasts.walk_straight([ahead])[0][0, -1] == pytest.approx((2.8 + 2.4, 0))
        assert forecasts.walk_straight([true])[0][0, -1] == pytest.approx((4, 0))

    def test_social_force(self):
        """Alone it walks straight; two who meet go aside, mirrored."""
        task = forecasts.Task(*(numpy.array(rows, dtype=float) for rows in
                                ([(0, 0), (6, 0.1)], [(1, 0), (-1, 0)], [(100, 0), (-94, 0.1)])))
        alone = forecasts.Task(*(rows[:1] for rows in task))
        assert peers.social_force([alone], 0.1)[0][0, -1] == pytest.approx((4.8, 0))
        first, second = peers.social_force([task], 0.1)[0]
        assert first[-1, 1] < -0.05 and first + second == pytest.approx(numpy.tile([6, 0.1], (12, 1)))


CROWD = 'instance,tick,agent,x,y\n' + ''.join(
    f'0,{k},{agent},{x + 0.12 * k * way:.3f},{y}\n'
    for agent, (x, y, way) in enumerate([(0, 0, 1), (12, 0.8, -1), (0, 2, 1), (12, 4, -1)]) for k in range(101))


def realism(runner, *arguments, tools=None):
    """Runs the program in the test's folder. Returns exit status and output."""
    done = subprocess.run([REALISM, *map(str, arguments), '--tools', tools or tools_folder()], cwd=runner.folder,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=PATIENCE, check=False)
    return done.returncode, done.stdout.decode(errors='replace')


def fake_tools(runner, commands):
    """Makes a folder with programs that do this."""
    folder = pathlib.Path(runner.path('tools'))
    folder.mkdir()
    for name in ('train', 'evaluate'):
        (folder / name).write_text(f'#!/bin/sh\n{commands}\n')
        (folder / name).chmod(0o755)
    return folder


class ProgramTest:
    """The program, with a recording of people who walk straight at 1.2 m/s."""

    def test_all(self, runner):
        file = runner.write('crowd.csv', CROWD)
        status, output = realism(runner, file, '--csv', 'a.csv', '--json', 'a.json', '--plot', 'a.png',
                                 '--trajectories', 'simulated.csv')
        assert status == 0, output
        table = pandas.read_csv(runner.path('a.csv'), index_col='figure')
        assert list(table.index) == list(measures.FIGURES)
        assert table.loc['speed', 'recorded 50 %'] == pytest.approx(1.2)
        assert table.loc['speed', 'simulated 50 %'] == pytest.approx(1.2, abs=0.1)
        assert table.loc['turning', 'recorded 90 %'] == pytest.approx(0, abs=1e-6)
        assert ((table['KS'] >= 0) & (table['KS'] <= 1)).all()
        assert pandas.read_json(runner.path('a.json')).shape == pandas.read_csv(runner.path('a.csv')).shape
        assert os.path.getsize(runner.path('a.png')) > 10000
        status, output = realism(runner, 'simulated.csv')  # is a recording, too
        assert status == 0, output

    def test_people_without_company(self, runner):
        """Two walkers who are not there at the same time have no nearest other one."""
        walks = [f'0,{k + 200 * agent},{agent},{0.12 * k:.2f},0\n' for agent in (0, 1) for k in range(101)]
        file = runner.write('crowd.csv', CROWD.splitlines()[0] + '\n' + ''.join(walks))
        status, output = realism(runner, file, '--csv', 'a.csv', '--plot', 'a.png')
        assert status == 0, output
        assert numpy.isnan(pandas.read_csv(runner.path('a.csv'), index_col='figure').loc['nearest', 'KS'])

    def test_one(self, runner):
        file = runner.write('crowd.csv', CROWD)
        status, output = realism(runner, file, '--replace', 'one', '--free-speed', 1, '--csv', 'a.csv',
                                 '--plot', 'a.png')
        assert status == 0, output
        table = pandas.read_csv(runner.path('a.csv')).set_index(['model', 'velocity', 'goal'])
        assert (table['windows'] == 4 * (26 - 19)).all()
        for key in (('constant velocity', 'last', 'ahead'), ('constant velocity', 'weighted', 'true')):
            assert table.loc[key, 'ADE'] == pytest.approx(0, abs=0.003), key
        assert table.loc[('human, no gait', 'last', 'ahead'), 'ADE'] < 0.1
        assert table.loc[('human', 'last', 'ahead'), 'ADE'] < 0.6
        assert table.loc[('human', 'last', 'ahead'), 'Col-I'] == 0
        assert os.path.getsize(runner.path('a.png')) > 10000

    def test_bad_input(self, runner):
        file = runner.write('crowd.csv', CROWD)
        lonely = runner.write('one.csv', CROWD.split('0,0,1,')[0])
        for arguments, said in (((runner.path('none.csv'),), 'none.csv: No such file'), ((lonely,), 'has 1 walkers'),
                                ((runner.write('bad.csv', 'a,b\n'),), 'bad.csv:1: is not a recording'),
                                ((file, '--q-table', 'humane'), 'humane: No such file'),
                                ((file, '--instance', 3), 'has no instance 3'),
                                ((file, '--plot', 'no/a.png'), 'there is no folder')):
            status, output = realism(runner, *arguments)
            assert status == 1, output
            assert_says(output, 'realism: ', said)
            assert 'Traceback' not in output
        status, output = realism(runner, file, '--replace', 'one', '--trajectories', 'a.csv')
        assert status == 2, output

    def test_evaluate_fails(self, runner):
        tools = fake_tools(runner, 'echo it is broken >&2; exit 1')
        for replace in ('all', 'one'):
            status, output = realism(runner, runner.write('crowd.csv', CROWD), '--replace', replace, tools=tools)
            assert status == 1, output
            assert_says(output, 'crowd.csv: evaluate: it is broken')

    def test_interrupted(self, runner):
        tools = fake_tools(runner, f'touch {runner.path("began")}; exec sleep 1000')
        process = runner.start('realism', [REALISM, runner.write('crowd.csv', CROWD), '--tools', tools, '--csv',
                                           runner.path('a.csv')])
        process_began = pathlib.Path(runner.path('began'))
        wait_for(process_began.exists, 'evaluate')
        process.signal(signal.SIGTERM)
        assert process.wait(20) == 130, process.output()
        assert not os.path.exists(runner.path('a.csv'))
