"""scripts/validate: plans worked out by hand, measures of trajectories made by hand, the command line, and a case."""
import json
import math
import os
import pathlib
import random
import stat

import numpy
import pytest
from crowd_validation import cases, measures, people, plan, texts
from crowd_validation.case import Result, load, store
from crowd_validation.cases import rimea_05, rimea_07, rimea_09, rimea_10, rimea_11, rimea_12, rimea_15
from crowd_validation.program import chapter_of
from crowd_validation.recording import Recording, read_tracks
from programs import assert_says, in_package, read_text, tools_folder, wait_for

NAN = [math.nan, math.nan]


def recording(tracks, walls=(), arrivals=None, speeds=None, radius=0.2):
    """Returns a Recording of tracks by agent, lists of places of the same length, with a tick of 0.1 s."""
    tracks = numpy.array(tracks, dtype=float).transpose(1, 0, 2)
    count = tracks.shape[1]
    return Recording(tracks, 0.1, list(walls), numpy.full(count, radius), numpy.full(count, 1.0)
                     if speeds is None else numpy.array(speeds, dtype=float),
                     numpy.array([math.inf] * count if arrivals is None else arrivals, dtype=float),
                     numpy.zeros(count, dtype=bool))


def total_length(walls):
    return sum(math.dist(*wall) for wall in walls)


class PlanTest:
    """Walls and documents."""

    def test_a_wall_with_gaps(self):
        assert plan.wall((0, 2), (10, 2), [(4, 5), (7, 8)]) == [[[0, 2], [4, 2]], [[5, 2], [7, 2]], [[8, 2], [10, 2]]]
        assert plan.wall((1, 0), (1, 3), [(0, 1)]) == [[[1, 1], [1, 3]]]  # a gap at the beginning leaves no empty wall
        assert plan.wall((0, 0), (3, 4), [(2, 3)]) == [[[0, 0], [1.2, 1.6]], [[1.8, 2.4], [3, 4]]]

    def test_polyline(self):
        assert plan.polyline((0, 0), (1, 0), (1, 2)) == [[[0, 0], [1, 0]], [[1, 0], [1, 2]]]


class PeopleTest:
    """Places and speeds."""

    @pytest.mark.parametrize('seed', range(20))
    def test_places_are_free_and_inside(self, seed):
        places = numpy.array(people.places(150, (1.0, 2.0), (8.0, 9.0), 0.2, random.Random(seed)))
        assert places.shape == (150, 2)
        assert (places >= numpy.array([1.2, 2.2]) - 1e-9).all(), seed
        assert (places <= numpy.array([7.8, 8.8]) + 1e-9).all(), seed
        distances = numpy.hypot(*(places[:, None] - places[None]).transpose(2, 0, 1))
        numpy.fill_diagonal(distances, math.inf)
        assert distances.min() >= 0.4 - 1e-9, seed

    def test_too_many_people(self):
        with pytest.raises(ValueError, match='100 people of radius 0.3 m do not fit into 5 x 5 m'):
            people.places(100, (0, 0), (5, 5), 0.3, random.Random(1))

    def test_speeds_of_adults(self):
        speeds = people.adult_speeds(300, random.Random(1))
        assert min(speeds) >= 0.58 and max(speeds) <= 1.61
        # A third of the people is in the narrow range of the middle group; of the young, 13 % are; of the old, none.
        assert 100 <= sum(1.41 <= speed <= 1.54 for speed in speeds) <= 125


class MeasuresTest:
    """Measures of trajectories made by hand."""

    def test_crossing_times(self):
        gate = [[1.0, 0.0], [1.0, 2.0]]
        times = measures.crossing_times(recording([[[0.0, 1.0], [0.8, 1.0], [1.2, 1.0]],  # half-way in the second step
                                                   [[0.0, 3.0], [0.8, 3.0], [1.2, 3.0]],  # passes beside the gate
                                                   [[0.0, 1.0], [1.0, 1.0], [1.5, 1.0]],  # ends a step on the gate
                                                   [[0.0, 1.0], [0.5, 1.0], NAN]]), gate)
        assert times[0] == pytest.approx(0.15, abs=1e-9)
        assert math.isinf(times[1])
        assert times[2] == pytest.approx(0.1, abs=1e-9)
        assert math.isinf(times[3])

    def test_through_walls(self):
        walls = [[[1.0, 0.0], [1.0, 2.0]], [[0.0, 0.0], [1.0, 0.0]]]
        assert measures.through_walls(recording([[[0.5, 1.0], [1.5, 1.0]], [[0.5, 2.5], [1.5, 2.5]],
                                                 [[0.5, 0.5], [0.5, -0.5]], [[0.2, 0.2], [0.8, 1.8]]], walls)) == 2

    def test_largest_overlap(self):
        # 0.4 m apart they touch; 0.35 m apart they overlap by 0.05 m. One that has left overlaps nobody.
        assert measures.largest_overlap(recording([[[0, 0], [0, 0]], [[0.4, 0], [1, 0]]])) == pytest.approx(0, abs=1e-9)
        assert measures.largest_overlap(recording([[[0, 0], [0, 0], [0, 0]], [[1, 0], [0.35, 0], NAN]])) == \
            pytest.approx(0.05, abs=1e-9)

    def test_starts(self):
        # Stands for two ticks, then walks; never walks.
        starts = measures.starts(recording([[[0, 0], [0, 0], [0, 0], [0.1, 0], [0.2, 0]], [[5, 5]] * 5]))
        assert starts[0] == pytest.approx(0.2, abs=1e-9)
        assert math.isinf(starts[1])

    def test_mean_speeds(self):
        # 0.15 m a tick; the second stops before the end of the stretch.
        speeds = measures.mean_speeds(recording([[[0.15 * i, 0] for i in range(21)],
                                                 [[0.15 * min(i, 10), 0] for i in range(21)]]), 0, 1.0, 2.0)
        assert speeds[0] == pytest.approx(1.5, abs=1e-9)
        assert math.isnan(speeds[1])

    def test_left_over(self):
        # One stands for the last ten seconds, one walks on, one has arrived.
        ticks = 121
        walk = recording([[[3.0, 3.0]] * ticks, [[0.1 * i, 0.0] for i in range(ticks)], [[0, 0], *[NAN] * (ticks - 1)]],
                         arrivals=[math.inf, math.inf, 0.1])
        places, standing = measures.left_over(walk)
        assert standing == 1
        assert places.tolist() == [[3.0, 3.0], [pytest.approx(12.0), 0.0]]
        text = texts.problems([walk], {'the door': (3.0, 2.0), 'the corner': (12.0, 1.0)})
        assert text == 'seed 1: 2 left (1 at the door, 1 at the corner), 1 of them stand'
        assert texts.problems([recording([[[0, 0]]], arrivals=[0.1])], {'the door': (0, 0)}) == ''

    def test_slow_people(self):
        # At 1 m/s: one walks at full speed, one at 0.4 m/s, one stands outside of the box.
        walk = recording([[[0.1 * i, 0] for i in range(31)], [[0.04 * i, 1] for i in range(31)], [[9, 9]] * 31])
        slow = measures.slow_people(walk, (0, 0), (5, 5))
        assert slow.tolist() == [0] * 10 + [1] * 21

    def test_sustained_peak(self):
        assert measures.sustained_peak(numpy.array([0, 5, 1, 3, 4, 3, 0]), 3) == 3
        assert measures.sustained_peak(numpy.array([0, 5, 1]), 1) == 5
        assert measures.sustained_peak(numpy.array([2, 5]), 10) == 2  # shorter than the period

    def test_flow(self):
        # 1,000 people leave one after the other every 0.5 s by two exits: one person per second and exit.
        walk = recording([[[0, 0]]] * 1000, arrivals=0.5 * numpy.arange(1000))
        assert rimea_09.flow(walk, rimea_09.LOWER) == pytest.approx(1.0, abs=1e-9)
        stuck = numpy.where(numpy.arange(1000) < 800, walk.arrivals, math.inf)
        assert math.isinf(rimea_09.flow(recording([[[0, 0]]] * 1000, arrivals=stuck), rimea_09.LOWER))

    def test_tracks_are_stored_in_a_smaller_file(self, runner):
        file = runner.write('walk.csv', 'instance,tick,agent,x,y\n0,0,0,1.5,2\n0,0,1,3,4\n0,1,1,5,6\n')
        for _ in range(2):  # the second time from the smaller file
            tracks = read_tracks(pathlib.Path(file), 2)
            assert tracks.shape == (2, 2, 2)
            assert tracks[0, 0].tolist() == [1.5, 2.0]
            assert numpy.isnan(tracks[1, 0]).all()
            assert tracks[1, 1].tolist() == [5.0, 6.0]
        assert not os.path.exists(file)


class TextsTest:
    """Texts of results."""

    def test_spread(self):
        assert texts.spread([30.0, 31.0, 32.0], 's') == '31.0 s (30.0-32.0)'
        assert texts.spread([30.0, 30.0], 's', 0) == '30 s'
        assert texts.spread([30.0, math.inf], 's', 0) == '30 s, never in 1 of 2 seeds'
        assert texts.spread([math.inf], 's') == 'never'

    def test_counts(self):
        assert texts.counts([20, 20]) == '20'
        assert texts.counts([20, 18, 19]) == '18-20'


class CasesTest:
    """Scenarios of the cases."""

    def test_names(self):
        names = [case.name for case in cases.ALL]
        assert len(set(names)) == len(names)
        assert not set(names) & set(cases.LEFT_OUT)

    def test_reaction_times(self):
        agents = rimea_05.document(1)['agents']
        assert [agent['reaction_time'] for agent in agents] == [10, 20, 30, 40, 50, 60, 70, 80, 90, 100]
        # 8 + 5 + 8 m of walls, and 5 m with an exit of 1 m.
        assert total_length(rimea_05.document(1)['walls']) == pytest.approx(25.0)

    def test_speed_ranges(self):
        assert rimea_07.within(numpy.array([0.59, 1.6]), 0.58, 1.61)
        assert not rimea_07.within(numpy.array([0.5, 1.6]), 0.58, 1.61)
        assert not rimea_07.within(numpy.array([0.59, math.nan]), 0.58, 1.61)

    def test_exits_of_the_large_room(self):
        # The perimeter of 100 m without two or four metres of exits. The same people in both.
        four = rimea_09.document(3, {**rimea_09.UPPER, **rimea_09.LOWER})
        two = rimea_09.document(3, rimea_09.LOWER)
        assert total_length(four['walls']) == pytest.approx(96.0)
        assert total_length(two['walls']) == pytest.approx(98.0)
        assert [agent['position'] for agent in four['agents']] == [agent['position'] for agent in two['agents']]
        assert {tuple(agent['goal']) for agent in two['agents']} == {(4.5, -1.0), (25.5, -1.0)}
        for agent in four['agents']:
            x, y = agent['position']
            assert agent['goal'] == [4.5 if x < 15 else 25.5, -1.0 if y < 10 else 21.0]

    def test_rooms_and_assigned_exits(self):
        assigned = rimea_10.assignments()
        assert len(assigned) == 23
        assert assigned.count(3) == 1
        assert sum(room in rimea_10.TO_MAIN_EXIT for room in assigned) == 15
        assert [agent['goal'] for agent in rimea_10.document(1)['agents']].count([6.6, 12.0]) == 15

    def test_two_bottlenecks(self):
        # Left wall 10 m, three walls with a gap of 1 m each, four long sides of 10 m, both sides of the corridor.
        assert total_length(rimea_12.document(1)['walls']) == pytest.approx(10 + 3 * 9 + 40 + 10)

    def test_as_far_from_both_exits(self):
        (first, _), (_, last) = rimea_11.EXITS.values()
        assert rimea_11.OUTSIDE[0] == (first[0] + last[0]) / 2.0

    def test_the_same_people_in_three_corridors(self):
        documents = [document(2) for document, _ in
                     (rimea_15.straight(rimea_15.SHORT), rimea_15.corner(), rimea_15.straight(rimea_15.LONG))]
        for attribute in ('speed', 'radius'):
            values = [[agent[attribute] for agent in document['agents']] for document in documents]
            assert values[0] == values[1] == values[2]
        tops = [[top - agent['position'][1] for agent in document['agents']]
                for document, top in zip(documents, (50.0, 60.0, 81.0))]
        assert tops[0] == pytest.approx(tops[1], abs=0.001)
        assert tops[0] == pytest.approx(tops[2], abs=0.001)


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
        """Starts scripts/validate with results in the test's folder."""
        return runner.start('validate', [in_package('scripts', 'validate'), *words, '--tools', tools_folder(),
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
        assert_says(listing.output(), 'rimea_1 ', 'rimea_15', 'rimea_13   left out: ')

    @pytest.mark.parametrize('words, said', [
        (['rimea_99'], "no case 'rimea_99'; there are rimea_1, "),
        (['rimea_2'], "no case 'rimea_2': walking up stairs"),
        (['rimea_1', '--seeds', '0'], 'expected a number above 0'),
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
        failing = runner.start('validate', [in_package('scripts', 'validate'), 'rimea_1', '--tools', runner.folder,
                                            '--output', runner.path('results')])
        assert failing.wait() == 1
        assert_says(failing.output(), 'exit status 3', 'the disk is on fire')
