"""research/compare: measures of scenes made by hand, and a complete run."""
import glob
import math
import os
import pathlib
import re

import numpy
import pandas
import pytest
from crowd_comparison.avoidability import Contact, Recording
from crowd_comparison.experiments.benchmark import bar_rows
from crowd_comparison.experiments.lanes import lane_order, order_above_chance, order_over_time
from crowd_comparison.models import judged, largest_difference, not_slower, read_metrics, time_against
from crowd_drawing.files import Scene
from crowd_experiments.pages import Chapter, fill_document
from crowd_experiments.records import read_tracks
from crowd_experiments.runs import processor_seconds
from programs import assert_says, in_package, read_text, tools_folder

AGENT = '{position: [%g, %g], goal: [%g, %g], speed: 1.0, radius: 0.25}'
SCENARIO = '''name: {name}
duration: 20
goal_tolerance: 0.3
agents:
  - {agent}
'''
REFERENCE = '''model,parameters,scenario,instances,contact_pct,clean_pct,path_ratio,time_ratio,turn_rad_per_m
orca_best,a,near,1,0,100,1.0,{near},0.1
orca_best,b,far,1,0,100,1.0,{far},0.1
orca_fixed,a,near,1,0,100,1.0,1.5,0.1
orca_fixed,a,far,1,0,100,1.0,1.5,0.1
social_force,a,near,1,50,0,1.0,1.2,0.1
social_force,a,far,1,50,0,1.0,1.2,0.1
'''


class LaneOrderTest:
    """The order parameter, compared with values computed by hand."""

    def test_lanes_are_perfect(self):
        places = numpy.array([[-1, 1], [0, 1], [2, 1], [-2, -1], [0, -1], [1, -1.2]], dtype=float)
        order, chance = lane_order(places, [1, 1, 1, -1, -1, -1])
        assert order == 1.0
        assert chance == 0.5  # each walker has two others in its lane
        assert order_above_chance(places, [1, 1, 1, -1, -1, -1]) == 1.0

    def test_a_mixed_lane(self):
        # In one lane, one walker walks to the left and two to the right. For the latter, the others walk in both
        # directions: 0. For the former, both others walk in the opposite direction: ((0 - 2) / 2)^2 = 1.
        order, chance = lane_order(numpy.array([[0, 0], [1, 0], [2, 0]], dtype=float), [1, 1, -1])
        assert order == pytest.approx(1.0 / 3.0, abs=1e-7)
        assert chance == 0.5

    def test_distant_and_absent_walkers_are_ignored(self):
        # Too far to the side, outside the stretch, and absent.
        places = numpy.array([[0, 0], [1, 0.1], [1, 0.5], [50, 0], [math.nan, math.nan]])
        assert lane_order(places, [1, 1, -1, -1, -1]) == (1.0, 1.0)
        assert math.isnan(lane_order(places[2:], [1, -1, -1])[0])

    def test_few_walkers_are_no_order(self):
        places = numpy.array([[x, 1.0 if x > 0 else -1.0] for x in (-4, -3, -2, -1, 1, 2, 3, 4)])
        directions = [1] * 4 + [-1] * 4
        assert order_over_time(places[None], directions)[0] == 1.0
        assert math.isnan(order_over_time(places[None], [1] * 5 + [-1] * 3)[0])

    def test_random_directions_are_no_order(self):
        random = numpy.random.default_rng(1)
        track = numpy.stack([random.uniform(-5, 5, (400, 200)), random.uniform(-2, 2, (400, 200))], axis=2)
        directions = random.choice([-1, 1], 200)
        assert abs(numpy.mean(order_over_time(track, directions))) < 0.01


class AvoidabilityTest:
    """Contacts with moving obstacles, with trajectories made by hand: ticks of 0.1 s, radii of 0.25 and 0.5 m."""

    def recording(self, moving_obstacle, others=(), walls=(), ticks=60, start=(0.0, 0.0)):
        """Returns a Recording of an agent that stands at its start, other standing agents, and a moving obstacle."""
        places = [start, *others]
        agents = [{'position': list(place), 'goal': [9.0, 9.0], 'speed': 1.0, 'radius': 0.25} for place in places]
        walls = [list(map(list, wall)) for wall in walls]
        scene = Scene({'agents': agents, 'obstacles': [moving_obstacle], 'walls': walls}, '')
        return Recording(scene, numpy.broadcast_to(numpy.array(places, dtype=float), (ticks, len(places), 2)))

    def slow(self):
        """Returns an obstacle that moves from x = 2 m towards the agent at 0.5 m/s, and reaches 0.75 m after 2.5 s."""
        return {'position': [2.0, 0.0], 'radius': 0.5, 'velocity': [-0.5, 0.0]}

    def test_contacts_begin_where_bodies_overlap(self):
        # After 25 ticks the distance is 0, after 26 ticks the overlap is 0.05 m.
        assert self.recording(self.slow()).contacts() == [Contact(0, 0, 26)]

    def test_no_contact_with_static_obstacles_or_absent_agents(self):
        assert self.recording({'position': [0.5, 0.0], 'radius': 0.5}).contacts() == []
        recording = self.recording(self.slow())
        gone = recording.track.copy()
        gone[20:] = math.nan
        assert Recording(recording.scene, gone).contacts() == []

    def test_a_slow_moving_obstacle_can_be_avoided(self):
        recording = self.recording(self.slow())
        escape = recording.last_escape(recording.contacts()[0])
        assert escape is not None
        # Walking away from the obstacle at full speed avoids the contact even from the last tick.
        assert escape.tick == 25

    def test_a_fast_moving_obstacle_overruns_a_near_agent(self):
        # 12 m/s from a distance of 0.9 m: contact at the first tick, in which the agent can move at most 0.1 m.
        recording = self.recording({'position': [0.9, 0.0], 'radius': 0.5, 'velocity': [-12.0, 0.0]})
        contact, = recording.contacts()
        assert contact.tick == 1
        assert recording.last_escape(contact) is None
        assert recording.last_escape(contact, among_others=False) is None

    def test_hemmed_in_by_others(self):
        # Seven other agents surround it; the moving obstacle passes through them, but the agent cannot.
        angles = [2.0 * math.pi * i / 7.0 for i in range(7)]
        ring = [(0.58 * math.cos(angle), 0.58 * math.sin(angle)) for angle in angles]
        recording = self.recording(self.slow(), others=ring)
        contact = next(contact for contact in recording.contacts() if contact.agent == 0)
        assert recording.last_escape(contact) is None
        assert recording.last_escape(contact, among_others=False) is not None

    def test_walls_are_in_the_way(self):
        # A dead end, 0.6 m wide, which the moving obstacle blocks.
        box = [((-0.3, 0.3), (5.0, 0.3)), ((-0.3, -0.3), (5.0, -0.3)), ((-0.3, -0.3), (-0.3, 0.3))]
        recording = self.recording(self.slow(), walls=box)
        assert recording.last_escape(recording.contacts()[0]) is None

    def test_a_turn_shortly_before(self):
        # From x = 1.5 m to 2.4 m and back to 0 at 2 m/s: turns after 0.45 s and is at 0.75 m after 1.275 s.
        recording = self.recording({'position': [1.5, 0.0], 'radius': 0.5, 'to_and_fro': [[2.4, 0.0], [0.0, 0.0]],
                                    'speed': 2.0})
        assert recording.contacts()[0] == Contact(0, 0, 13)
        assert recording.had_turned(Contact(0, 0, 13))
        assert not self.recording(self.slow()).had_turned(Contact(0, 0, 26))


def table(rows):
    """Returns metrics, given by scenario."""
    return pandas.DataFrame.from_dict(rows, orient='index', dtype=float)


class BarsTest:
    """The requirements, and the seeds that meet them."""

    def figures(self, time, contact=0.0):
        row = {'contact_pct': contact, 'clean_pct': 100.0, 'path_ratio': 1.0, 'turn_rad_per_m': 0.1,
               'max_speed_ratio': 1.0}
        return table({'near': dict(row, time_ratio=time[0]), 'far': dict(row, time_ratio=time[1]),
                      'door12': dict(row, time_ratio=9.0, clean_pct=0.0)})

    def test_time_against_orca(self):
        orca = self.figures((1.0, 2.0))
        ours = self.figures((2.0, 1.0))
        assert list(judged(ours).index) == ['near', 'far']
        assert time_against(ours, orca) == pytest.approx(1.0, abs=1e-7)  # sqrt(2 / 1 * 1 / 2)
        assert time_against(self.figures((2.0, 4.0)), orca) == pytest.approx(2.0, abs=1e-7)
        assert not_slower(ours, orca) == 1

    def test_seeds_that_meet_the_bars(self):
        orca = self.figures((1.0, 1.0))
        rows = {row[0]: row for row in bar_rows(
            [self.figures((0.9, 0.9)), self.figures((1.2, 1.2), contact=0.5)], orca, [5, 70])}
        assert rows['time / ORCA, geometric mean'][1:] == ['≤ 1.000', '0.900', '1.200', '1 of 2', '≤ 0.900', '1 of 2']
        assert rows['contact %, worst scenario'][4] == '1 of 2'
        assert rows['clean %, worst scenario without door12'][4] == 'all seeds'
        assert rows['clean %, worst scenario'][6] == 'none'
        assert rows['training, processor time [s]'][3:5] == ['70.0', '1 of 2']

    def test_largest_difference(self):
        one = table({'near': {'a': 1.0, 'b': 2.0, 'c': 5.0}})
        assert largest_difference(one, table({'near': {'a': 1.25, 'b': 2.0}})) == 0.25


class DocumentTest:
    """Updating a document."""

    def test_tables_are_put_between_their_marks(self, runner):
        chapter = Chapter('lanes', 'Lanes')
        chapter.add_table('Order', ['', 'order'], [['a', '0.5']], 'order')
        file = runner.write('page.md', 'Before.\n<!-- table lanes/order -->\nold\n<!-- end -->\nBetween.\n'
                                       '<!-- table crowds/crowds -->\nkept\n<!-- end -->\n')
        messages = fill_document(file, [chapter])
        assert read_text(file) == ('Before.\n<!-- table lanes/order -->\n'
                                   '|  | order |\n|---|---|\n| a | 0.5 |\n<!-- end -->\n'
                                   'Between.\n<!-- table crowds/crowds -->\nkept\n<!-- end -->\n')
        assert len(messages) == 1
        assert_says(messages[0], 'crowds/crowds')

    def test_tracks(self, runner):
        tracks = read_tracks(runner.write('walks.csv', 'instance,tick,agent,x,y\n0,0,0,1,2\n0,0,1,3,4\n0,1,1,5,6\n'
                                                       '1,0,0,7,8\n'))
        assert tracks[0].shape == (2, 2, 2)
        assert numpy.isnan(tracks[0][1, 0]).all()
        assert list(tracks[0][1, 1]) == [5.0, 6.0]
        assert list(tracks[1][0, 0]) == [7.0, 8.0]


class CompareTest:
    """The complete program."""

    def compare(self, runner, *words):
        """Starts research/compare with results in the test's folder."""
        return runner.start('compare', [in_package('research', 'compare'), *words, '--quick',
                                        '--tools', tools_folder(), '--results', runner.path('results')])

    def write_benchmark(self, runner):
        """Writes a benchmark with two scenes of one agent, without a scorer. Returns its folder."""
        os.makedirs(runner.path('benchmark/scenarios'))
        for name, goal in (('near', 2.0), ('far', 4.0)):
            runner.write(f'benchmark/scenarios/{name}.yaml',
                         SCENARIO.format(name=name, agent=AGENT % (0.0, 0.0, goal, 0.0)))
        runner.write('benchmark/reference.csv', REFERENCE.format(near=1.1, far=1.1))
        return runner.path('benchmark')

    def test_with_a_benchmark(self, runner):
        document = runner.write('page.md', '<!-- table benchmark/time_ratio -->\n<!-- end -->\n')
        running = self.compare(runner, 'benchmark', '--benchmark', self.write_benchmark(runner), '--document', document)
        assert running.wait() == 0, running.output()
        assert_says(running.output(), 'time / ORCA', 'thesis set 2')
        figures = read_metrics(runner.path('results/runs/benchmark/thesis_nearest_01/metrics.csv'))
        assert set(figures.index) == {'near', 'far'}
        row = re.search(r'^\| near \| (\S+).*$', read_text(document), re.MULTILINE)
        assert row is not None, read_text(document)
        assert '| 1.100 | 1.500 | 1.200 |' in row[0]
        times = processor_seconds(pathlib.Path(runner.path('results/runs/benchmark/thesis_nearest_01')))
        assert len(times) == 2  # of train and evaluate
        again = self.compare(runner, 'benchmark', '--benchmark', runner.path('benchmark'))
        assert again.wait() == 0, again.output()
        assert '6 runs, 6 of them done before' in again.output()

    def test_without_a_benchmark(self, runner):
        running = self.compare(runner, 'all')
        assert running.wait() == 0, running.output()
        assert_says(running.output(), 'benchmark: left out', 'ablations: left out', 'Large crowds')
        page = read_text(runner.path('results/index.html'))
        assert 'Rex and Löwen' in page
        assert 'id="benchmark"' not in page
        assert len(glob.glob(runner.path('results/runs/*/*/done.txt'))) == 8

    def test_a_folder_without_a_benchmark(self, runner):
        failing = self.compare(runner, 'benchmark', '--benchmark', runner.folder)
        assert failing.wait() == 1
        assert_says(failing.output(), 'reference.csv')
