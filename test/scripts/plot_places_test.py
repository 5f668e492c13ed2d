"""scripts/plot_paths draws maps, areas, queues and gates, and people at a moment."""
import math
import subprocess

import numpy
import PIL.Image
import pytest
from crowd_drawing.errors import InputError
from crowd_drawing.files import FREE_COLOUR, OCCUPIED_COLOUR, UNKNOWN_COLOUR, is_open, read_map, read_scene
from programs import PATIENCE, assert_says, in_package, read_text

WALK = 'instance,tick,agent,x,y\n' + ''.join(f'0,{tick},{agent},{tick / 10},{agent}\n'
                                             for agent, ticks in enumerate((20, 5, 30)) for tick in range(ticks))
MAP = '''image: floor.png
resolution: 0.5
origin: [1, 2, %s]
occupied_thresh: 0.65
free_thresh: 0.196
negate: %s
'''
PLACE = '''name: place
duration: 10
goal_tolerance: 0.3
map: floor.yaml
agents:
  - {position: [1.5, 2.5], route: out, speed: 1, radius: 0.25}
sources:
  - {area: {box: [[1, 2], [2, 3]]}, rate: 1, route: out, speed: 1, radius: 0.2}
sinks:
  exit: {area: {ring: {centre: [2, 3], radius: [0, 0.5]}}}
queues:
  till: {head: [1.5, 2], direction: 90, spacing: 0.5, service: 3}
gates:
  door: {wall: [[1, 2], [1, 3]], open: [[1, 2]]}
routes:
  out: {waypoints: [{queue: till}, {sink: exit}]}
'''


def write_map(runner, yaw='0', negate='0'):
    """Writes a map of 3 x 2 pixels: occupied, unknown, free; free, free, occupied. Returns its YAML file."""
    pixels = numpy.array([[0, 205, 254], [254, 254, 0]], dtype=numpy.uint8)
    PIL.Image.fromarray(pixels).save(runner.path('floor.png'))
    return runner.write('floor.yaml', MAP % (yaw, negate))


class MapTest:
    """Maps of map_server."""

    def test_colours(self, runner):
        floor = read_map(write_map(runner))
        assert [tuple(pixel) for pixel in floor.pixels[0]] == [OCCUPIED_COLOUR, UNKNOWN_COLOUR, FREE_COLOUR]
        assert [tuple(pixel) for pixel in floor.pixels[1]] == [FREE_COLOUR, FREE_COLOUR, OCCUPIED_COLOUR]
        assert floor.size == [1.5, 1.0]

    def test_negated(self, runner):
        """Grey value 205 is dark at 205 / 255 = 0.80, so it is occupied."""
        floor = read_map(write_map(runner, negate='1'))
        assert [tuple(pixel) for pixel in floor.pixels[0]] == [FREE_COLOUR, OCCUPIED_COLOUR, OCCUPIED_COLOUR]

    def test_corners_of_a_turned_map(self, runner):
        """A quarter turn maps the x axis of the map to y and its y axis to -x."""
        corners = read_map(write_map(runner, yaw=str(math.pi / 2))).corners()
        expected = [(1, 2), (0, 2), (1, 3.5), (0, 3.5)]
        assert corners == [pytest.approx(corner) for corner in expected]

    @pytest.mark.parametrize('old, new, words', [
        ('resolution: 0.5', 'resolution: 0', 'expected a resolution above 0'),
        ('origin: [1, 2, 0]', 'origin: [1, 2]', 'an origin [x, y, yaw]'),
        ('free_thresh: 0.196\n', '', 'is not a map of map_server'),
        ('floor.png', 'floor.yaml', 'floor.yaml: is not an image'),
    ])
    def test_errors(self, runner, old, new, words):
        text = read_text(write_map(runner))
        assert old in text
        with pytest.raises(InputError, match='floor.yaml: ') as caught:
            read_map(runner.write('floor.yaml', text.replace(old, new)))
        assert_says(str(caught.value), words)


class PlaceTest:
    """Scenes with people who come and go."""

    def scene(self, runner):
        write_map(runner)
        return read_scene(runner.write('place.yaml', PLACE), 0)

    def test_reading(self, runner):
        scene = self.scene(runner)
        assert scene.population.queues == [((1.5, 2), (pytest.approx(1.5), 4))]  # head, and four steps of 0.5 m up
        assert scene.population.gates == [([(1, 2), (1, 3)], [[1, 2]])]
        assert scene.population.source_areas == [{'box': [[1, 2], [2, 3]]}]
        assert [scene.radius_of(agent) for agent in (0, 1, 7)] == [0.25, 0.2, 0.2]
        assert scene.map.size == [1.5, 1.0]

    @pytest.mark.parametrize('time, expected', [(0.9, False), (1.0, True), (1.9, True), (2.0, False), (5.0, True)])
    def test_gates(self, time, expected):
        assert is_open([[1, 2], [4, 6]], time) == expected
        assert is_open(True, time)
        assert not is_open(False, time)

    def draw(self, runner, *options):
        """Draws the recording. Returns the SVG file's text."""
        self.scene(runner)
        done = subprocess.run(
            [in_package('scripts', 'plot_paths'), '--trajectories', runner.write('walk.csv', WALK), '--scenario',
             runner.path('place.yaml'), '--output', runner.path('place.svg'), *options],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=PATIENCE, check=False)
        assert done.returncode == 0, done.stdout.decode()
        assert ('ends at 2.9 s' in done.stdout.decode()) == ('9' in options)
        return read_text(runner.path('place.svg'))

    def test_legend(self, runner):
        labels = [f'<!-- {label} -->' for label in ('people come', 'people leave', 'queue', 'gate (dotted: open)')]
        assert_says(self.draw(runner), '<!-- start -->', *labels)
        assert_says(self.draw(runner, '--moment', '1'), '<!-- person -->', '<!-- path of the last 10 s -->', *labels)

    @pytest.mark.parametrize('moment, bodies', [('0.3', 3), ('1', 2), ('2.5', 1), ('9', 0)])
    def test_only_those_in_the_world_have_bodies(self, runner, moment, bodies):
        """The walks end after 1.9, 0.4 and 2.9 s. Bodies are the only outlines of 0.4 points."""
        assert self.draw(runner, '--moment', moment).count('stroke-width: 0.4') == bodies
