#!/usr/bin/python3
"""The map of a scenario, on the topic `map` and in the markers."""
import support
from controlling import ControllerTestCase
from nav_msgs.msg import OccupancyGrid
from picturing import Picture

# Rows from the top; 0 is a wall. The cells are 1 m wide.
IMAGE = 'P2 4 3 255\n0 0 0 0\n255 255 255 255\n0 255 255 255\n'
MAP = 'image: floor.pgm\nresolution: 1\norigin: [10, 20, 0]\noccupied_thresh: 0.65\nfree_thresh: 0.2\nnegate: 0\n'
WITH_MAP = """
name: floor
duration: 60
goal_tolerance: 0.3
map: floor.yaml
agents:
  - {position: [11.5, 21.5], goal: [13.5, 21.5], speed: 0.5, radius: 0.2}
"""


class MapsTest(ControllerTestCase):

    def test_map_is_drawn_and_goes_with_its_scenario(self):
        maps = self.listen('map', OccupancyGrid)
        self.write('floor.pgm', IMAGE)
        self.write('floor.yaml', MAP)
        with_map = self.write('with_map.yaml', WITH_MAP)
        picture = Picture(f'{self.namespace}/markers')
        self.addCleanup(picture.close)
        self.start_node('crowd_markers', 'crowd_markers', {})
        self.start_learner()
        self.start_controller(with_map, paused=True)
        self.assertEqual(list(maps.wait().data), [100, 0, 0, 0, 0, 0, 0, 0, 100, 100, 100, 100])
        support.wait_for(lambda: picture.points('map'), 'the map in the markers')
        corners = set(picture.points('map'))
        self.assertEqual(corners, {(10, 20), (11, 20), (11, 21), (10, 21), (10, 22), (14, 22), (14, 23), (10, 23)})

        self.do('load_scenario', scenario='circle6')
        maps.wait(lambda message: (message.info.width, len(message.data)) == (0, 0), 'without cells')
        support.wait_for(lambda: not picture.points('map'), 'no map in the markers')
        self.do('load_scenario', scenario=with_map)
        support.wait_for(lambda: set(picture.points('map')) == corners, 'the map again')


if __name__ == '__main__':
    support.run('maps_test')
