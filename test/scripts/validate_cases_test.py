"""research/validate: walls of plans and scenarios of the cases, worked out by hand."""
import math

import numpy
import pytest
from crowd_validation import crowds, movement, plan, program as cases, sweeps


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


class CasesTest:
    """Scenarios of the cases."""

    def test_names(self):
        names = [case.name for case in cases.ALL]
        assert len(set(names)) == len(names)
        assert not set(names) & set(cases.LEFT_OUT)

    def test_reaction_times(self):
        agents = movement.room(1)['agents']
        assert [agent['reaction_time'] for agent in agents] == [10, 20, 30, 40, 50, 60, 70, 80, 90, 100]
        # 8 + 5 + 8 m of walls, and 5 m with an exit of 1 m.
        assert total_length(movement.room(1)['walls']) == pytest.approx(25.0)

    def test_floors_of_sweeps(self):
        one, two = (sweeps.door(1, 1.2, 0.2, ways) for ways in (1, 2))
        assert total_length(one['walls']) == pytest.approx(12 - 1.2 + 2 * 24)  # the wall with the door, and two sides
        assert [agent['position'][0] < 0 for agent in one['agents']] == [True] * 40
        assert [agent['goal'][0] for agent in two['agents']] == [9.0] * 20 + [-9.0] * 20
        agents = sweeps.corridor(1, 3.0, 0.5, 0.25)['agents']  # 20 m long
        assert [agent['goal'][0] for agent in agents] == [24.0, -4.0] * 15

    def test_speed_ranges(self):
        assert movement.within(numpy.array([0.59, 1.6]), 0.58, 1.61)
        assert not movement.within(numpy.array([0.5, 1.6]), 0.58, 1.61)
        assert not movement.within(numpy.array([0.59, math.nan]), 0.58, 1.61)

    def test_exits_of_the_large_room(self):
        # The perimeter of 100 m without two or four metres of exits. The same people in both.
        four = crowds.large_room(3, {**crowds.UPPER, **crowds.LOWER})
        two = crowds.large_room(3, crowds.LOWER)
        assert total_length(four['walls']) == pytest.approx(96.0)
        assert total_length(two['walls']) == pytest.approx(98.0)
        assert [agent['position'] for agent in four['agents']] == [agent['position'] for agent in two['agents']]
        assert {tuple(agent['goal']) for agent in two['agents']} == {(4.5, -1.0), (25.5, -1.0)}
        for agent in four['agents']:
            x, y = agent['position']
            assert agent['goal'] == [4.5 if x < 15 else 25.5, -1.0 if y < 10 else 21.0]

    def test_rooms_and_assigned_exits(self):
        assigned = crowds.ASSIGNED
        assert len(assigned) == 23
        assert assigned.count(3) == 1
        assert sum(room in crowds.TO_MAIN_EXIT for room in assigned) == 15
        assert [agent['goal'] for agent in crowds.twelve_rooms(1)['agents']].count([6.6, 12.0]) == 15

    def test_two_bottlenecks(self):
        # Left wall 10 m, three walls with a gap of 1 m each, four long sides of 10 m, both sides of the corridor.
        assert total_length(crowds.two_rooms(1)['walls']) == pytest.approx(10 + 3 * 9 + 40 + 10)

    def test_as_far_from_both_exits(self):
        (first, _), (_, last) = crowds.EXITS.values()
        assert crowds.OUTSIDE[0] == (first[0] + last[0]) / 2.0

    def test_the_same_people_in_three_corridors(self):
        documents = [crowds.wide_corridor(2, 50.0), crowds.wide_corner(2), crowds.wide_corridor(2, 81.0)]
        for attribute in ('speed', 'radius'):
            values = [[agent[attribute] for agent in document['agents']] for document in documents]
            assert values[0] == values[1] == values[2]
        tops = [[top - agent['position'][1] for agent in document['agents']]
                for document, top in zip(documents, (50.0, 60.0, 81.0))]
        assert tops[0] == pytest.approx(tops[1], abs=0.001)
        assert tops[0] == pytest.approx(tops[2], abs=0.001)
