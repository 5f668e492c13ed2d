"""Measures of research/reproduce, compared with numbers computed by hand."""
import math

import numpy
import pytest
from crowd_reproduction import measures
from crowd_reproduction.measures import Sector, sectors_of
from crowd_reproduction.results import read_decisions, visits_in

NAN = math.nan


def places_of(*ticks):
    """An array (tick, agent, 2)."""
    return numpy.array(ticks, dtype=float)


class DecisionsTest:
    """Reading the files of `evaluate --states` and `train`."""

    def test_decisions(self, runner):
        decisions = read_decisions(runner.write(
            'states.csv', 'instance,tick,agent,x,y,heading,row,action,occupied\n'
                          '0,0,0,1.5,-2,90,11,6,\n0,0,1,2,0,-45,12,0,15:45:2\n'
                          '1,7,0,0,0,0,13,1,-22.5:22.5:1 22.5:67.5:2 292.5:337.5:2\n'))
        assert decisions['sectors'].tolist() == [0, 1, 3]
        assert decisions['row'].tolist() == [11, 12, 13]
        assert decisions['x'].tolist() == [1.5, 2.0, 0.0]
        assert decisions['tick'].tolist() == [0, 0, 7]
        assert sectors_of(decisions['occupied'][0]) == []
        sectors = [Sector(-22.5, 22.5, 1), Sector(22.5, 67.5, 2), Sector(-67.5, -22.5, 2)]
        assert sectors_of(decisions['occupied'][2]) == sectors

    def test_another_file(self, runner):
        with pytest.raises(ValueError, match='expected the header instance,tick'):
            read_decisions(runner.write('walks.csv', 'instance,tick,agent,x,y\n0,0,0,1,2\n'))

    def test_visits(self, runner):
        visits = visits_in(runner.write('table.txt', 'social_crowd Q-table 1\nrows: 5\nactions: 2\n---\n'
                                                     '1 10 0.5 3 -1.25\n4 0 0 7 2\nchecksum: 0123456789abcdef\n'))
        assert visits.tolist() == [0, 13, 0, 0, 7]


class GroupsTest:
    """Distances between agents."""

    def test_nearest(self):
        # Three agents in a line at 0, 1 and 3 m; then without the one in the middle; then only one agent.
        places = places_of([[0, 0], [1, 0], [3, 0]], [[0, 0], [NAN, NAN], [3, 4]], [[0, 0], [NAN, NAN], [NAN, NAN]])
        found = measures.nearest_distances(places)
        assert found[0].tolist() == [1, 1, 2]
        assert found[1][[0, 2]].tolist() == [5, 5]
        assert math.isnan(found[1][1])
        assert numpy.isnan(found[2]).all()

    def test_middle(self):
        # The centroid of (0, 0), (2, 0), (1, 3) is (1, 1).
        found = measures.centre_distances(places_of([[0, 0], [2, 0], [1, 3]]))
        assert found[0] == pytest.approx((math.sqrt(2) + math.sqrt(2) + 2) / 3, abs=1e-7)

    def test_while_all_are_there(self):
        places = places_of([[0, 0], [1, 0]], [[0, 0], [2, 0]], [[0, 0], [NAN, NAN]])
        assert len(measures.while_all_are_there(places)) == 2
        assert len(measures.while_all_are_there(places[:2])) == 2

    def test_passing(self):
        # An obstacle moves along y = 0 past two agents at (0, 1) and (9, 9); within 1.5 m where |x| <= sqrt(1.25).
        places = places_of(*[[[0, 1], [9, 9]]] * 7)
        obstacle = numpy.array([[x, 0.0] for x in range(-3, 5)])
        assert measures.passing(places, obstacle, 1.5) == (2, 4)
        assert measures.passing(places, obstacle, 0.5) is None

    def test_first_ticks(self):
        # The first agent is 1 m from the middle at tick 1; the second one is never nearer than 2 m; the third leaves.
        places = places_of([(3, 0), (2, 0), (5, 0)], [(0, 1), (0, 2), (0.5, 0)], [(0, 0), (0, 3), (NAN, NAN)])
        first = measures.first_ticks(places, (0, 0), 1.0)
        assert first[[0, 2]].tolist() == [1, 1]
        assert math.isnan(first[1])

    def test_hidden_share(self):
        # Three discs of 0.25 m on a line: the middle one hides each end from the other end. The fourth disc, 0.6 m to
        # the side of the middle one, hides no disc, and none hides it.
        places = places_of([(-0.6, 0), (0, 0), (0.6, 0), (0, 0.6)])
        # Within 1 m of the centre: rims at most 1 m away, which all are. Each agent sees three, twelve in all; two of
        # them, both ends from the other end, are hidden.
        assert measures.hidden_share(places, 0.25, 1.0) == pytest.approx(100.0 * 2 / 12)
        assert measures.hidden_share(places[:, [0, 2]], 0.25, 1.0) == 0.0
        assert math.isnan(measures.hidden_share(places[:, :1], 0.25, 1.0))

    def test_two_together_hide_a_third(self):
        # Half angles of 20 degrees at -15 and +15 degrees cover 35 to each side; a gap between both does not.
        half = math.radians(20)
        covers = numpy.radians([-15.0, 15.0])
        assert measures.is_hidden(0.0, math.radians(35), covers, numpy.array([half, half]))
        assert not measures.is_hidden(0.0, math.radians(36), covers, numpy.array([half, half]))
        assert not measures.is_hidden(0.0, math.radians(10), numpy.radians([-15.0, 15.0]), numpy.radians([14.0, 14.0]))
        # Across the direction behind, where angles change from 180 to -180 degrees.
        assert measures.is_hidden(math.pi, math.radians(5), numpy.radians([-179.0]), numpy.radians([10.0]))

    def test_crossing(self):
        # Crosses the line at x = 0, returns, and crosses it again between (-1, 4) and (3, 8), at y = 5.
        walk = numpy.array([[-1, 0], [1, 0], [-1, 4], [3, 8]], dtype=float)
        assert measures.crossing(walk, 0.0) == 5.0
        assert measures.crossing(walk, 3.5) is None


class SurroundedTest:
    """Contacts and collisions after decisions of one kind."""

    def test_within_next(self):
        flags = numpy.array([[0], [0], [0], [1], [0]], dtype=bool)
        assert measures.within_next(flags, 2)[:, 0].tolist() == [False, True, True, False, False]
        assert measures.within_next(flags, 9)[:, 0].tolist() == [True, True, True, False, False]

    def test_contact_and_collision(self):
        # Radius 0.25: bodies overlap below 0.5 m, a rim is within 0.5 m of the centre up to 0.75 m.
        distances = numpy.array([0.49, 0.4995, 0.5, 0.75, 0.76, NAN])
        assert measures.is_contact(distances).tolist() == [True, False, False, False, False, False]
        assert measures.is_collision(distances).tolist() == [True, True, True, True, False, False]

    def test_longest_run(self):
        flags = numpy.array([[1, 0], [1, 1], [0, 1], [1, 1], [1, 0]], dtype=bool)
        assert measures.longest_run(flags) == 3

    def decisions(self, runner):
        """Returns decisions of two agents at four ticks, 2, 1, 0.7 and 0.4 m apart; agent 0 is surrounded at the first
        two ticks. In a second instance agent 0 is alone and perceives nothing."""
        lines = ['instance,tick,agent,x,y,heading,row,action,occupied']
        for tick, (x, sectors) in enumerate(((2, 7), (1, 8), (0.7, 1), (0.4, 1))):
            lines.append(f'0,{tick},0,0,0,0,{tick},0,' + ' '.join(['0:45:2'] * sectors))
            lines.append(f'0,{tick},1,{x},0,0,4,0,0:45:2')
        lines.append('1,0,0,0,0,0,0,0,')
        return read_decisions(runner.write('states.csv', '\n'.join(lines) + '\n'))

    def test_surrounded(self, runner):
        found = measures.surrounded(self.decisions(runner), {(0, 0)}, 7, 2)
        # Surrounded at ticks 0 and 1: a collision (0.7 m, tick 2) follows within two ticks of both, a contact (tick 3)
        # only within two ticks of the second. Other decisions: agent 1 at the same ticks; both agents at tick 2,
        # followed by a contact and a collision; both agents at tick 3, followed by nothing.
        assert found.inside == (2, 50.0, 100.0)
        assert found.outside == (7, pytest.approx(100 * 3 / 7, abs=1e-7), pytest.approx(100 * 4 / 7, abs=1e-7))
        assert found.per_thousand() == pytest.approx(1000 * 2 / 9, abs=1e-7)
        assert found.ever == pytest.approx(100 / 3, abs=1e-7)  # one of three agents
        assert (found.arrived, found.touched) == (100.0, 100.0)
        assert found.longest == 2

    def test_surrounded_beside_an_obstacle(self, runner):
        """An agent 2, 1, 0.62 and 1 m from the middle of an obstacle of 0.4 m: at tick 2 their bodies overlap."""
        lines = ['instance,tick,agent,x,y,heading,row,action,occupied',
                 *(f'0,{tick},0,{x},0,0,0,0,' + ' '.join(['0:45:2'] * 7) for tick, x in enumerate((2, 1, 0.62, 1)))]
        decisions = read_decisions(runner.write('states.csv', '\n'.join(lines) + '\n'))
        assert measures.surrounded(decisions, set(), 7, 2).inside == (4, 0.0, 0.0)
        assert measures.surrounded(decisions, set(), 7, 2, 0.4).inside == (4, 50.0, 50.0)
        assert measures.surrounded(decisions, set(), 7, 2, 0.3).inside == (4, 0.0, 50.0)

    def test_by_visits(self, runner):
        # Agent 0 has rows 0 to 3, agent 1 has row 4; the single agent of instance 1 has row 0 and perceives nothing.
        visits = numpy.array([0, 5, 10, 99, 0])
        found = measures.by_visits(self.decisions(runner), visits, [0, 1, 10], 1)
        assert found['decisions'].tolist() == [6, 1, 2]
        # Within one tick: a contact after tick 2, a collision after ticks 1 and 2.
        assert found['contact'].tolist() == [1, 0, 1]
        assert found['collision'].tolist() == [2, 1, 1]
        crowded = measures.by_visits(self.decisions(runner), visits, [0, 1, 10], 1, least_sectors=7)
        assert crowded['decisions'].tolist() == [1, 1, 0]
