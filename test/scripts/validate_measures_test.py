"""research/validate: measures of trajectories made by hand, places and speeds of people, and texts of results."""
import math
import os
import pathlib
import random

import numpy
import pytest
from crowd_validation import crowds, measures, measures as texts, plan as people, sweeps
from crowd_validation.evaluation import Recording, read_tracks

NAN = [math.nan, math.nan]


def recording(tracks, walls=(), arrivals=None, speeds=None, radius=0.2):
    """Returns a Recording of tracks by agent, lists of places of the same length, with a tick of 0.1 s."""
    tracks = numpy.array(tracks, dtype=float).transpose(1, 0, 2)
    count = tracks.shape[1]
    return Recording(tracks, 0.1, list(walls), numpy.full(count, radius), numpy.full(count, 1.0)
                     if speeds is None else numpy.array(speeds, dtype=float),
                     numpy.array([math.inf] * count if arrivals is None else arrivals, dtype=float),
                     numpy.zeros(count, dtype=bool))


class MeasuresTest:
    """Measures of trajectories made by hand."""

    def test_flow_and_share_of_the_free_speed(self):
        # Through the door at x = 0 after 0.1 s, 0.2 s and 0.3 s; each walks 0.6 m in 0.3 s.
        tracks = [[[start + 0.2 * tick, 0.0] for tick in range(4)] for start in (-0.1, -0.3, -0.5)]
        walked = recording(tracks, arrivals=[0.3, 0.3, math.inf], speeds=[2.0, 4.0, 2.0])
        assert sweeps.flow(walked) == pytest.approx(2 / 0.2)
        assert sweeps.share(walked) == pytest.approx((1.0 + 0.5 + 0.0) / 3)
        assert sweeps.flow(recording(tracks[:2] + [[[-9.0, 0.0]] * 4])) == 0.0

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
        # 0.4 m apart they touch; 0.35 m apart they overlap by 0.05 m. Agents that have left do not overlap others.
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
        assert crowds.flow(walk, crowds.LOWER) == pytest.approx(1.0, abs=1e-9)
        stuck = numpy.where(numpy.arange(1000) < 800, walk.arrivals, math.inf)
        assert math.isinf(crowds.flow(recording([[[0, 0]]] * 1000, arrivals=stuck), crowds.LOWER))

    def test_tracks_are_stored_in_a_smaller_file(self, runner):
        file = runner.write('walk.csv', 'instance,tick,agent,x,y\n0,0,0,1.5,2\n0,0,1,3,4\n0,1,1,5,6\n')
        for _ in range(2):  # the second time from the smaller file
            tracks = read_tracks(pathlib.Path(file), 2)
            assert tracks.shape == (2, 2, 2)
            assert tracks[0, 0].tolist() == [1.5, 2.0]
            assert numpy.isnan(tracks[1, 0]).all()
            assert tracks[1, 1].tolist() == [5.0, 6.0]
        assert not os.path.exists(file)


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
