#!/usr/bin/python3
"""What scripts/reproduce measures where the thesis only looks, on numbers worked out by hand."""
import math
import sys

import numpy

import support

sys.path.insert(0, support.in_package('scripts'))
from crowd_reproduction import measures  # noqa: E402
from crowd_reproduction.decisions import Sector, read_decisions, read_visits, sectors_of  # noqa: E402

NAN = math.nan


def places_of(*ticks):
    """An array (tick, agent, 2)."""
    return numpy.array(ticks, dtype=float)


class DecisionsTest(support.CrowdTestCase):
    """Reading what `evaluate --states` and `train` write."""

    def test_decisions(self):
        decisions = read_decisions(self.write(
            'states.csv', 'instance,tick,agent,x,y,heading,row,action,occupied\n'
                          '0,0,0,1.5,-2,90,11,6,\n0,0,1,2,0,-45,12,0,15:45:2\n'
                          '1,7,0,0,0,0,13,1,-22.5:22.5:1 22.5:67.5:2 292.5:337.5:2\n'))
        self.assertEqual(decisions['sectors'].tolist(), [0, 1, 3])
        self.assertEqual(decisions['row'].tolist(), [11, 12, 13])
        self.assertEqual(decisions['x'].tolist(), [1.5, 2.0, 0.0])
        self.assertEqual(decisions['tick'].tolist(), [0, 0, 7])
        self.assertEqual(sectors_of(decisions['occupied'][0]), [])
        self.assertEqual(sectors_of(decisions['occupied'][2]),
                         [Sector(-22.5, 22.5, 1), Sector(22.5, 67.5, 2), Sector(-67.5, -22.5, 2)])

    def test_another_file(self):
        with self.assertRaisesRegex(ValueError, 'expected the header instance,tick'):
            read_decisions(self.write('walks.csv', 'instance,tick,agent,x,y\n0,0,0,1,2\n'))

    def test_visits(self):
        visits = read_visits(self.write('table.txt', 'social_crowd Q-table 1\nrows: 5\nactions: 2\n---\n'
                                                     '1 10 0.5 3 -1.25\n4 0 0 7 2\nchecksum: 0123456789abcdef\n'))
        self.assertEqual(visits.tolist(), [0, 13, 0, 0, 7])


class GroupsTest(support.CrowdTestCase):
    """How near agents are to each other."""

    def test_nearest(self):
        # Three in a line at 0, 1 and 3 m; then the one in the middle is gone; then one is alone.
        places = places_of([[0, 0], [1, 0], [3, 0]], [[0, 0], [NAN, NAN], [3, 4]], [[0, 0], [NAN, NAN], [NAN, NAN]])
        found = measures.nearest_distances(places)
        self.assertEqual(found[0].tolist(), [1, 1, 2])
        self.assertEqual(found[1][[0, 2]].tolist(), [5, 5])
        self.assertTrue(math.isnan(found[1][1]))
        self.assertTrue(numpy.isnan(found[2]).all())

    def test_middle(self):
        # The middle of (0, 0), (2, 0), (1, 3) is (1, 1).
        found = measures.centre_distances(places_of([[0, 0], [2, 0], [1, 3]]))
        self.assertAlmostEqual(found[0], (math.sqrt(2) + math.sqrt(2) + 2) / 3)

    def test_while_all_are_there(self):
        places = places_of([[0, 0], [1, 0]], [[0, 0], [2, 0]], [[0, 0], [NAN, NAN]])
        self.assertEqual(len(measures.while_all_are_there(places)), 2)
        self.assertEqual(len(measures.while_all_are_there(places[:2])), 2)

    def test_passing(self):
        # An obstacle goes along y = 0 past two agents at (0, 1) and (9, 9); within 1.5 m where |x| <= sqrt(1.25).
        places = places_of(*[[[0, 1], [9, 9]]] * 7)
        obstacle = numpy.array([[x, 0.0] for x in range(-3, 5)])
        self.assertEqual(measures.passing(places, obstacle, 1.5), (2, 4))
        self.assertIsNone(measures.passing(places, obstacle, 0.5))

    def test_crossing(self):
        # Goes over the line at x = 0, back, and over it again between (-1, 4) and (3, 8): at a quarter, y = 5.
        walk = numpy.array([[-1, 0], [1, 0], [-1, 4], [3, 8]], dtype=float)
        self.assertEqual(measures.crossing(walk, 0.0), 5.0)
        self.assertIsNone(measures.crossing(walk, 3.5))


class SurroundedTest(support.CrowdTestCase):
    """What follows after decisions of one kind."""

    def test_within_next(self):
        flags = numpy.array([[0], [0], [0], [1], [0]], dtype=bool)
        self.assertEqual(measures.within_next(flags, 2)[:, 0].tolist(), [False, True, True, False, False])
        self.assertEqual(measures.within_next(flags, 9)[:, 0].tolist(), [True, True, True, False, False])

    def test_contact_and_collision(self):
        # Radius 0.25: bodies overlap below 0.5 m, a rim is within 0.5 m of the centre up to 0.75 m.
        distances = numpy.array([0.49, 0.4995, 0.5, 0.75, 0.76, NAN])
        self.assertEqual(measures.is_contact(distances).tolist(), [True, False, False, False, False, False])
        self.assertEqual(measures.is_collision(distances).tolist(), [True, True, True, True, False, False])

    def test_longest_run(self):
        flags = numpy.array([[1, 0], [1, 1], [0, 1], [1, 1], [1, 0]], dtype=bool)
        self.assertEqual(measures.longest_run(flags), 3)

    def decisions(self):
        """Two agents, four ticks: 2, 1, 0.7 and 0.4 m apart; agent 0 is surrounded at the first two. In a second
        instance agent 0 is alone and sees nothing."""
        lines = ['instance,tick,agent,x,y,heading,row,action,occupied']
        for tick, (x, sectors) in enumerate(((2, 7), (1, 8), (0.7, 1), (0.4, 1))):
            lines.append(f'0,{tick},0,0,0,0,{tick},0,' + ' '.join(['0:45:2'] * sectors))
            lines.append(f'0,{tick},1,{x},0,0,4,0,0:45:2')
        lines.append('1,0,0,0,0,0,0,0,')
        return read_decisions(self.write('states.csv', '\n'.join(lines) + '\n'))

    def test_surrounded(self):
        found = measures.surrounded(self.decisions(), {(0, 0)}, 7, 2)
        # Surrounded at ticks 0 and 1: a collision (0.7 m, tick 2) comes within two ticks of both, a contact (tick 3)
        # of the second only. Else: agent 1 at the same ticks; both at tick 2, then a contact and a collision; nothing
        # comes after tick 3.
        self.assertEqual(found.inside, measures.Outcome(decisions=2, contacts=1, collisions=2))
        self.assertEqual(found.outside, measures.Outcome(decisions=7, contacts=3, collisions=4))
        self.assertAlmostEqual(found.per_thousand(), 1000 * 2 / 9)
        self.assertEqual((found.agents, found.caught, found.caught_arrived, found.caught_touched, found.longest),
                         (3, 1, 1, 1, 2))

    def test_by_visits(self):
        # Agent 0 is on rows 0 to 3, agent 1 on row 4; the alone one on row 0 sees nothing.
        visits = numpy.array([0, 5, 10, 99, 0])
        never, some, many = measures.by_visits(self.decisions(), visits, [0, 1, 10], 1)
        self.assertEqual((never.decisions, some.decisions, many.decisions), (6, 1, 2))
        # Within one tick: a contact after tick 2, a collision after ticks 1 and 2.
        self.assertEqual((never.contacts, some.contacts, many.contacts), (1, 0, 1))
        self.assertEqual((never.collisions, some.collisions, many.collisions), (2, 1, 1))
        crowded = measures.by_visits(self.decisions(), visits, [0, 1, 10], 1, least_sectors=7)
        self.assertEqual([one.decisions for one in crowded], [1, 1, 0])


if __name__ == '__main__':
    support.run('reproduce_measures_test')
