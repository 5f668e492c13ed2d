"""docs/places.md and the places that it describes: all people arrive without contacts."""
import csv
import glob
import os
import shutil

import pytest
from programs import ANTICIPATION_TABLE, assert_says, in_package, page_examples, page_text

FILES = sorted(glob.glob(in_package('config', 'scenarios', 'place_*.yaml')))
NAMES = [os.path.splitext(os.path.basename(file))[0] for file in FILES]
LARGEST_PICTURE = 150_000  # [bytes]


def walk(runner, scenario, episodes):
    """Runs a scenario. Returns a row of measures for each agent in each episode."""
    record = runner.path('record.csv')
    runner.tool('evaluate', '--q-table', ANTICIPATION_TABLE, '--episodes', episodes, '--record', record, scenario)
    with open(record, newline='', encoding='utf-8') as stream:
        return list(csv.DictReader(stream))


def assert_all_arrive(rows, people):
    """Checks that there are this many people, and that all of them arrive without touching anything."""
    assert len(rows) == people
    assert [row for row in rows if row['arrived'] != '1' or row['touched'] != '0' or row['blocked_moves'] != '0'] == []


class PageTest:
    """Every place has a section with a picture, and a row in the list of demos."""

    def test_there_are_eight_places(self):
        assert set(NAMES) == {'place_office', 'place_station', 'place_supermarket', 'place_bottleneck',
                              'place_two_way_door', 'place_corner', 'place_t_junction', 'place_museum'}

    @pytest.mark.parametrize('name', NAMES)
    def test_sections(self, name):
        launch = f'roslaunch social_crowd demo.launch scenario:={name}\n'
        assert_says(page_text('places.md'), f'(images/{name}.png)', f'    {launch}', f'[`{name}`](#')
        assert_says(page_text('demos.md'), f'(images/{name}.png)', launch.strip())

    @pytest.mark.parametrize('name', NAMES)
    def test_pictures_are_small(self, name):
        assert 0 < os.path.getsize(in_package('docs', 'images', f'{name}.png')) < LARGEST_PICTURE


class PlacesTest:
    """The shipped scenarios."""

    @pytest.mark.parametrize('name, people', [('place_bottleneck', 60), ('place_corner', 20),
                                              ('place_t_junction', 30), ('place_two_way_door', 24)])
    def test_all_arrive(self, runner, name, people):
        assert_all_arrive(walk(runner, in_package('config', 'scenarios', f'{name}.yaml'), 5), 5 * people)

    def test_groups_leave_the_museum(self, runner):
        rows = walk(runner, in_package('config', 'scenarios', 'place_museum.yaml'), 2)
        assert_all_arrive(rows, len(rows))
        assert len(rows) > 40

    @pytest.mark.parametrize('name', ['place_station', 'place_supermarket'])
    def test_all_agents_of_sources_leave(self, runner, name):
        rows = walk(runner, in_package('config', 'scenarios', f'{name}.yaml'), 2)
        assert len(rows) > 100
        assert_all_arrive(rows, len(rows))

    def test_the_office_keeps_walking(self, runner):
        """24 people walk between rooms, at least 50 m; visitors leave."""
        rows = walk(runner, in_package('config', 'scenarios', 'place_office.yaml'), 1)
        assert {row['touched'] for row in rows} == {'0'}
        assert min(float(row['path_length']) for row in rows[:24]) > 50
        assert len(rows) > 24
        assert {row['arrived'] for row in rows[24:]} == {'1'}

    def test_the_example_with_a_map(self, runner):
        """The page's scenario, on the map of the supermarket."""
        shutil.copy(in_package('config', 'maps', 'supermarket.yaml'), runner.path('my_map.yaml'))
        shutil.copy(in_package('config', 'maps', 'supermarket.png'), runner.folder)
        scenario = runner.write('my_place.yaml', page_examples('places.md')['my_place.yaml'])
        assert_all_arrive(walk(runner, scenario, 2), 2 * 30)
