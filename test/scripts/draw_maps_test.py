"""The package's maps are what scripts/draw_maps draws, and have the places that they are described with."""
import pathlib
import subprocess

import numpy
import PIL.Image
import pytest
import yaml
from crowd_maps.floor import FREE, OCCUPIED, UNKNOWN, Floor
from programs import PATIENCE, in_package, read_text

SIZES = {'office': (40, 25), 'station': (50, 30), 'supermarket': (30, 20)}  # of the floors [m]


def pixels_of(file):
    """Returns width, height and the pixels of a picture with 8-bit grey values."""
    with PIL.Image.open(file) as picture:
        assert picture.mode == 'L'
        return *picture.size, [bytes(row) for row in numpy.asarray(picture)]


def reachable(rows):
    """Returns the number of free pixels that are connected with the first free one."""
    free = {(x, y) for y, row in enumerate(rows) for x, value in enumerate(row) if value == FREE}
    todo = [min(free)]
    seen = set(todo)
    while todo:
        x, y = todo.pop()
        for near in ((x + 1, y), (x - 1, y), (x, y + 1), (x, y - 1)):
            if near in free and near not in seen:
                seen.add(near)
                todo.append(near)
    return len(seen), len(free)


class ShippedMapsTest:
    """config/maps."""

    def test_they_are_what_the_script_draws(self, runner):
        program = in_package('scripts', 'draw_maps')
        subprocess.run([program, '--output', runner.path('maps')], timeout=PATIENCE, check=True)
        drawn = sorted(file.name for file in pathlib.Path(runner.path('maps')).iterdir())
        assert drawn == sorted(file.name for file in pathlib.Path(in_package('config', 'maps')).iterdir())
        for name in SIZES:
            shipped = in_package('config', 'maps', name)
            assert read_text(runner.path(f'maps/{name}.yaml')) == read_text(f'{shipped}.yaml')
            # Pixels instead of bytes: versions of zlib may compress differently.
            assert pixels_of(runner.path(f'maps/{name}.png')) == pixels_of(f'{shipped}.png')

    def test_floors_of_ones_own(self, runner):
        """Those of research/crowded_robot are what the script draws, too."""
        folder = pathlib.Path(in_package('research', 'crowd_studies', 'crowded'))
        subprocess.run([in_package('scripts', 'draw_maps'), '--floors', folder / 'floors.yaml', '--output',
                        runner.path('maps')], timeout=PATIENCE, check=True)
        assert sorted(file.name for file in pathlib.Path(runner.path('maps')).iterdir()) == sorted(
            file.name for file in (folder / 'maps').iterdir())
        for name in ('hall', 'halls'):
            assert pixels_of(runner.path(f'maps/{name}.png')) == pixels_of(folder / 'maps' / f'{name}.png')

    @pytest.mark.parametrize('text', ['hall: {size: [3, 2]}', 'hall: {size: 3, drawn: []}', 'hall: [1]',
                                      'hall: {size: [3, 2], drawn: [{block: [1, 1]}]}'])
    def test_bad_floors_name_file_and_place(self, runner, text):
        file = pathlib.Path(runner.path('floors.yaml'))
        file.write_text(text, encoding='utf-8')
        done = subprocess.run([in_package('scripts', 'draw_maps'), '--floors', file, '--output', runner.path('maps')],
                              timeout=PATIENCE, check=False, capture_output=True, text=True)
        assert done.returncode == 1
        assert f'{file}: hall: expected size' in done.stderr
        assert not pathlib.Path(runner.path('maps')).exists()

    @pytest.mark.parametrize('name', SIZES)
    def test_size_and_origin(self, name):
        """A margin of 0.5 m surrounds the floor, whose lower left corner is the origin."""
        keys = yaml.safe_load(read_text(in_package('config', 'maps', f'{name}.yaml')))
        assert (keys['image'], keys['resolution'], keys['origin']) == (f'{name}.png', 0.05, [-0.5, -0.5, 0])
        width, height, rows = pixels_of(in_package('config', 'maps', f'{name}.png'))
        assert (width, height) == tuple(20 * (side + 1) for side in SIZES[name])
        assert {value for row in rows for value in row} == {FREE, OCCUPIED, UNKNOWN}

    @pytest.mark.parametrize('name', SIZES)
    def test_every_room_has_a_door(self, name):
        _, _, rows = pixels_of(in_package('config', 'maps', f'{name}.png'))
        connected, free = reachable(rows)
        assert connected == free


class FloorTest:
    """Cells of a floor."""

    def test_a_block_and_an_opening(self):
        """A floor of 1 x 0.5 m with margins of 0.5 m has 40 x 30 cells; a block of 0.1 x 0.05 m has 2 x 1."""
        floor = Floor(1, 0.5, wall=0.1)
        floor.block(0.2, 0.1, 0.3, 0.15)
        assert (len(floor.rows), len(floor.rows[0])) == (30, 40)
        assert floor.rows[12][13:17].tolist() == [FREE, OCCUPIED, OCCUPIED, FREE]
        assert floor.rows[11][14] == floor.rows[13][14] == FREE
        assert floor.rows[8][8] == floor.rows[15][9] == OCCUPIED  # outer wall
        assert floor.rows[7][8] == floor.rows[15][7] == UNKNOWN
        floor.opening(0.2, 0.1, 0.25, 0.15)
        assert floor.rows[12][13:17].tolist() == [FREE, FREE, OCCUPIED, FREE]

    def test_coordinates_are_borders_of_cells(self):
        with pytest.raises(ValueError, match='0.12 m is not a multiple of 0.05 m'):
            Floor(2, 2).block(0.12, 0.1, 0.5, 0.5)
