"""A crowd, evaluations, trainings and Q-tables in Python, without ROS."""
import subprocess
import sys

import numpy
import pytest
import social_crowd
import yaml
from programs import ANTICIPATION_TABLE, page_examples
from social_crowd.inputs import as_scenario

WALKER = {'name': 'walker', 'duration': 20, 'goal_tolerance': 0.3,
          'agents': [{'position': [0, 0], 'goal': [10, 0], 'heading': 0, 'speed': 1, 'radius': 0.25}]}


def agents_at(*places, **keys):
    """Returns a scenario with agents at these places that walk to the far right."""
    return dict(WALKER, agents=[dict(WALKER['agents'][0], position=list(place), goal=[50, place[1]], **keys)
                                for place in places])


class ImportTest:
    """The package can be imported without ROS."""

    def test_rospy_is_not_imported(self):
        code = ('import sys, social_crowd; social_crowd.Crowd, social_crowd.Env, social_crowd.VecEnv, '
                'social_crowd.SB3VecEnv; print("rospy" in sys.modules)')
        assert subprocess.run([sys.executable, '-c', code], stdout=subprocess.PIPE, check=True).stdout == b'False\n'

    def test_messages_need_no_module(self):
        code = 'import sys, social_crowd.msg; print("social_crowd._core" in sys.modules, "numpy" in sys.modules)'
        assert subprocess.run([sys.executable, '-c', code], stdout=subprocess.PIPE,
                              check=True).stdout.startswith(b'False')

    def test_names(self):
        assert all(hasattr(social_crowd, name) for name in social_crowd.__all__)
        with pytest.raises(AttributeError, match='Crowds'):
            social_crowd.Crowds


class CrowdTest:
    """Crowd beside `evaluate`, and its arrays."""

    @pytest.mark.parametrize('scenario', ['circle12', 'place_corner', 'line6_mover'])
    def test_the_same_as_evaluate(self, scenario):
        evaluated = social_crowd.evaluate('anticipation', scenario, episodes=2, seed=5)
        for number, episode in enumerate(evaluated.episodes):
            crowd = social_crowd.Crowd(scenario, seed=5, episode=number)
            while crowd.step():
                pass
            result = crowd.result()
            by_agent = result.pop('by_agent')
            assert result == episode
            assert crowd.is_over and crowd.tick == episode['ticks']
            assert by_agent['arrived'].sum() == episode['arrived'] and by_agent['arrived'].dtype == bool

    def test_threads_change_nothing(self):
        def walk(threads):
            crowd = social_crowd.Crowd('crowd_random_200', seed=3, threads=threads)
            for _ in range(30):
                crowd.step()
            return crowd.positions.tobytes() + crowd.headings.tobytes() + crowd.velocities.tobytes()

        assert walk(1) == walk(2) == walk(0)

    def test_arrays_are_views(self):
        crowd = social_crowd.Crowd('circle6')
        positions = crowd.positions
        before = positions.copy()
        assert positions.shape == (6, 2) and positions.base is not None and not positions.flags.writeable
        assert numpy.shares_memory(positions, crowd.positions)
        crowd.step()
        assert not numpy.array_equal(positions, before)  # in place
        numpy.testing.assert_allclose(positions - before, crowd.velocities * crowd.tick_duration, atol=1e-12)
        del crowd
        assert positions.shape == (6, 2) and numpy.isfinite(positions).all()  # the memory is still there

    def test_numbers_of_agents(self):
        crowd = social_crowd.Crowd(agents_at((0, 0), (0, 3)))
        numpy.testing.assert_array_equal(crowd.positions, [[0, 0], [0, 3]])
        numpy.testing.assert_array_equal(crowd.goals, [[50, 0], [50, 3]])
        numpy.testing.assert_array_equal(crowd.radii, [0.25, 0.25])
        numpy.testing.assert_array_equal(crowd.max_speeds, [1, 1])
        numpy.testing.assert_array_equal(crowd.ids, [0, 1])
        old = crowd.positions
        assert crowd.spawn_agent((0, 6), (5, 6)) == 2
        assert crowd.positions.shape == (3, 2) and old.shape == (2, 2)
        numpy.testing.assert_array_equal(crowd.goals[2], [5, 6])
        crowd.set_goal(2, (-5, 6))
        numpy.testing.assert_array_equal(crowd.goals[2], [-5, 6])
        crowd.remove_agent(1)
        assert crowd.statuses[list(crowd.ids).index(1)] == 2 if 1 in crowd.ids else True

    def test_decisions_of_ones_own(self):
        crowd = social_crowd.Crowd(WALKER)
        assert crowd.step([0.0], [0.5])
        numpy.testing.assert_allclose(crowd.positions, [[0.05, 0.0]])
        assert crowd.step(numpy.array([numpy.pi / 2]), numpy.array([1.0]))
        numpy.testing.assert_allclose(crowd.positions, [[0.05, 0.1]])
        numpy.testing.assert_allclose(crowd.headings, [numpy.pi / 2])

    def test_perceptions(self):
        crowd = social_crowd.Crowd(agents_at((0, 0), (2, 0), (0, 3)))
        seen = crowd.perceptions()
        numpy.testing.assert_array_equal(seen.ids, [0, 1, 2])
        numpy.testing.assert_array_equal(seen.poses, [[0, 0, 0], [2, 0, 0], [0, 3, 0]])
        numpy.testing.assert_array_equal(seen.goals, [[50, 0], [48, 0], [50, 0]])
        numpy.testing.assert_array_equal(seen.neighbour_counts, [2, 2, 2])
        first = seen.first_neighbours[0]
        numpy.testing.assert_array_equal(seen.neighbour_x[first:first + 2], [2, 0])
        numpy.testing.assert_array_equal(seen.neighbour_y[first:first + 2], [0, 3])
        numpy.testing.assert_array_equal(seen.neighbour_radii[first:first + 2], [0.25, 0.25])
        numpy.testing.assert_array_equal(seen.walls, numpy.empty((0, 4)))
        kept = seen.goals
        crowd.step()
        numpy.testing.assert_array_equal(kept, [[50, 0], [48, 0], [50, 0]])  # those of that tick
        assert crowd.perceptions().goals[0, 0] < 50

    def test_robots(self):
        crowd = social_crowd.Crowd('robot_circle_5', seed=2)
        robot, = crowd.robots
        assert (robot['name'], robot['goal'], robot['arrived']) == ('robot', (0.0, 4.0), False)
        crowd.command_robot(0, 1.0)
        crowd.step()
        assert crowd.robots[0]['pose'][1] > robot['pose'][1]
        with pytest.raises(social_crowd.InputError, match='robot'):
            crowd.command_robot(1, 1.0)

    def test_scan(self):
        scenario = """
name: beside
duration: 9
goal_tolerance: 0.3
agents: [{position: [0, 1.5], goal: [0, 9], speed: 1, radius: 0.25}]
walls: [[[2, -5], [2, 5]]]
robots: [{name: tug, position: [0, 0], heading: 0, radius: 0.3, max_speed: 1, scan: {rays: 4}}]
"""
        crowd = social_crowd.Crowd(scenario)
        scan = crowd.scan()
        assert (scan['first_angle'], scan['increment']) == (-numpy.pi, numpy.pi / 2)
        numpy.testing.assert_array_equal(scan['ranges'], [numpy.inf, numpy.inf, 2, 1.25])  # ahead a wall, left a person
        crowd.add_wall((0.5, -1), (0.5, 1))
        assert crowd.scan()['ranges'][2] == 0.5
        with pytest.raises(social_crowd.InputError, match='there is no robot 1'):
            crowd.scan(1)

    def test_errors(self):
        with pytest.raises(social_crowd.InputError, match="no scenario 'circel6', did you mean 'circle6'"):
            social_crowd.Crowd('circel6')
        with pytest.raises(ValueError, match="no Q-table 'anticipatoin', did you mean 'anticipation'"):
            social_crowd.Crowd('circle6', 'anticipatoin')
        with pytest.raises(social_crowd.InputError, match='duration'):
            social_crowd.Crowd({'name': 'empty'})
        with pytest.raises(social_crowd.InputError, match='got int'):
            social_crowd.Crowd(6)
        with pytest.raises(social_crowd.InputError, match='cannot be written'):
            social_crowd.Crowd(dict(WALKER, duration=float('nan')))
        with pytest.raises(social_crowd.InputError, match='seed: expected a whole number, got 1.5'):
            social_crowd.Crowd('circle6', seed=1.5)
        with pytest.raises(social_crowd.InputError, match='seed: expected at least 0, got -1'):
            social_crowd.Crowd('circle6', seed=-1)
        crowd = social_crowd.Crowd(WALKER)
        for rotations, speeds in (([0.0, 0.0], [1.0]), ([0.0], [[1.0]]), ([numpy.nan], [1.0]), ([0.0], [1.5])):
            with pytest.raises(social_crowd.InputError):
                crowd.step(rotations, speeds)
        numpy.testing.assert_array_equal(crowd.positions, [[0, 0]])  # nothing has moved
        with pytest.raises(social_crowd.InputError, match='order: simultaneous'):
            social_crowd.Crowd('circle12').step([0.0], [1.0])
        assert issubclass(social_crowd.FileError, OSError)
        assert issubclass(social_crowd.InputError, social_crowd.CrowdError)


class ScenarioTest:
    """Scenarios as names, files, texts and dicts."""

    def test_all_of_them_are_the_same(self, runner):
        text = ('name: walker\nduration: 20\ngoal_tolerance: 0.3\n'
                'agents:\n  - {position: [0, 0], goal: [10, 0], heading: 0, speed: 1, radius: 0.25}\n')
        file = runner.write('walker.yaml', text)

        def walk(scenario):
            crowd = social_crowd.Crowd(scenario)
            for _ in range(10):
                crowd.step()
            return crowd.positions.tobytes()

        first = walk(text)
        with_numpy = dict(WALKER, agents=[dict(WALKER['agents'][0], position=numpy.zeros(2))])
        assert all(walk(other) == first for other in (file, WALKER, social_crowd.Scenario.load(file), with_numpy))

    def test_documents(self):
        scenario = as_scenario([WALKER, agents_at((0, 0), (0, 3))])
        assert len(scenario) == 2
        assert social_crowd.Crowd(scenario, episode=1).positions.shape == (2, 2)

    def test_names(self):
        assert 'robot_crossing' in social_crowd.Scenario.names()


class TablesTest:
    """Q-tables, evaluations and trainings."""

    def test_values(self, runner):
        table = social_crowd.QTable.load('anticipation')
        assert table.values.shape == table.visits.shape == (table.rows, table.actions)
        assert table.visits.sum() > 0 and 'anticipation' in table.model
        file = runner.path('copy.txt')
        table.save(file)
        again = social_crowd.QTable.load(file)
        numpy.testing.assert_array_equal(again.values, table.values)
        numpy.testing.assert_array_equal(again.visits, table.visits)
        with pytest.raises(social_crowd.FileError, match='nowhere'):
            table.save(runner.path('nowhere/table.txt'))

    def test_evaluate_as_the_program(self, runner):
        evaluated = social_crowd.evaluate('anticipation', 'robot_circle_5', episodes=3, seed=4, robot='reactive')
        runner.tool('evaluate', '--q-table', ANTICIPATION_TABLE, '--episodes', 3, '--seed', 4, '--robot', 'reactive',
                    '--robots-csv', runner.path('robots.csv'), 'robot_circle_5')
        with open(runner.path('robots.csv'), encoding='utf-8') as stream:
            names, *rows = [line.rstrip('\n').split(',') for line in stream]
        assert len(rows) == len(evaluated.episodes) == evaluated.means['episodes'] == 3
        for row, episode in zip(rows, evaluated.episodes):
            robot, = episode['robots']
            for name, text in zip(names, row):
                if name == 'navigation':
                    assert (robot[name], text) == ('none', 'none')
                elif name in robot and name != 'name':
                    numpy.testing.assert_equal(float(robot[name]), float(text), name)
        with pytest.raises(social_crowd.InputError, match='reactive'):
            social_crowd.evaluate('anticipation', 'robot_circle_5', robot='reactiv')

    def test_train(self, runner):
        config = runner.write('config.yaml', page_examples('learning.md')['least.yaml'])
        turns = []

        def on_turn(training, episodes):
            turns.append((training.episode, len(episodes), episodes[0]['decisions']))
            return len(turns) < 3

        table = social_crowd.train(config, seed=3, on_turn=on_turn)
        assert [episode for episode, *_ in turns] == [1, 2, 3]
        again = social_crowd.train(config, seed=3, episodes=3)
        numpy.testing.assert_array_equal(table.values, again.values)
        assert table.decisions == again.decisions > 0
        as_dict = yaml.safe_load(page_examples('learning.md')['least.yaml'])
        numpy.testing.assert_array_equal(social_crowd.train(as_dict, seed=3, episodes=3).values, table.values)
        more = social_crowd.train(config, seed=4, episodes=3, begin=table)
        assert more.visits.sum() > table.visits.sum()
        with pytest.raises(social_crowd.CrowdError):
            social_crowd.train(config, begin='anticipation')
        with pytest.raises(social_crowd.FileError):
            social_crowd.train(runner.path('absent.yaml'))
