"""scripts/pedsim_import converts scenes of pedsim_ros."""
import csv
import glob
import os
import subprocess

import pytest
import yaml
from programs import ANTICIPATION_TABLE, PACKAGE, PATIENCE, assert_says, in_package, read_text

SCENES = sorted(glob.glob(os.path.join(PACKAGE, '..', 'shared', 'data', 'pedsim', '*.xml')))

HALL = '''<?xml version="1.0" encoding="UTF-8"?>
<scenario>
  <obstacle x1="0" y1="0" x2="20" y2="0"/>
  <obstacle x1="0" y1="0.5" x2="0" y2="10.25"/>
  <waypoint id="west" x="2" y="5" r="1.5"/>
  <waypoint id="east" x="18" y="5" r="2" b="0"/>
  <waypoint id="way out" x="19" y="1" r="1" b="2"/>
  <queue id="till" x="10" y="5" direction="0"/>
  <attraction id="shop" x="5" y="9" width="2" height="1" strength="3"/>
  <agent x="4" y="5" n="3" dx="2" dy="4" type="0">
    <addwaypoint id="west"/>
    <addwaypoint id="east"/>
  </agent>
  <agent x="6" y="5" n="1" dx="0" dy="0" type="3">
    <addqueue id="till"/>
    <addwaypoint id="way out"/>
    <addwaypoint id="east"/>
  </agent>
  <agent x="7" y="7" n="1" dx="0" dy="0" type="2"><addwaypoint id="west"/></agent>
  <agent x="9" y="9" n="1" dx="0" dy="0" type="1"/>
  <source x="12" y="3" n="2" dx="3" dy="1" type="0">
    <addwaypoint id="west"/>
    <addwaypoint id="way out"/>
  </source>
</scenario>
'''


def convert(runner, text, *options):
    """Converts a scene. Returns exit status, messages, and the text of the scenario file, empty if there is none."""
    scene = runner.write('hall.xml', text)
    output = runner.path('hall.yaml')
    done = subprocess.run([in_package('scripts', 'pedsim_import'), scene, '--output', output, *options],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=PATIENCE, check=False)
    return done.returncode, done.stdout.decode(), read_text(output) if os.path.exists(output) else ''


def scenario_of(runner, text, *options):
    """Converts a valid scene. Returns the scenario."""
    status, messages, scenario = convert(runner, text, *options)
    assert status == 0, messages
    return yaml.safe_load(scenario)


class ConversionTest:
    """What is carried over."""

    def test_head(self, runner):
        scenario = scenario_of(runner, HALL, '--duration', '120')
        assert scenario['name'] == 'hall'
        assert scenario['duration'] == 120
        assert scenario['walls'] == [[[0, 0], [20, 0]], [[0, 0.5], [0, 10.25]]]

    def test_people(self, runner):
        """Boxes are about the middle. Speeds: mean 1.34 and deviation 0.26 m/s, elders 0.9, robots 1.6."""
        people = scenario_of(runner, HALL)['agents']
        assert people[0] == {'count': 3, 'position': {'box': [[3, 3], [5, 7]]}, 'route': 'route_1',
                             'speed': [0.89, 1.79], 'radius': 0.2}
        assert people[1] == {'position': [6, 5], 'route': 'route_2', 'speed': 0.9, 'radius': 0.2}
        assert people[2] == {'position': [7, 7], 'route': 'route_3', 'speed': 1.6, 'radius': 0.4}
        assert people[3]['position'] == {'box': [[10.5, 2.5], [13.5, 3.5]]}  # at the start, of the source
        assert len(people) == 4

    def test_people_without_waypoints_are_obstacles(self, runner):
        assert scenario_of(runner, HALL)['obstacles'] == [{'position': [9, 9], 'radius': 0.2}]

    def test_routes(self, runner):
        """A route repeats, or ends at its first sink."""
        scenario = scenario_of(runner, HALL)
        west = {'place': {'ring': {'centre': [2, 5], 'radius': [0, 1.5]}}}
        east = {'place': {'ring': {'centre': [18, 5], 'radius': [0, 2]}}}
        assert scenario['routes'] == {
            'route_1': {'repeat': True, 'waypoints': [west, east]},
            'route_2': {'repeat': False, 'waypoints': [{'queue': 'till'}, {'sink': 'way out'}]},
            'route_3': {'repeat': True, 'waypoints': [west]},
            'route_4': {'repeat': False, 'waypoints': [west, {'sink': 'way out'}]},
        }
        assert scenario['sinks'] == {'way out': {'area': {'ring': {'centre': [19, 1], 'radius': [0, 1]}}}}

    def test_equal_routes_are_one(self, runner):
        agent = '<agent x="4" y="{}" n="1" type="0"><addwaypoint id="w"/></agent>'
        scene = f'<scenario><waypoint id="w" x="0" y="0" r="1"/>{agent.format(1)}{agent.format(2)}</scenario>'
        scenario = scenario_of(runner, scene)
        assert [entry['route'] for entry in scenario['agents']] == ['route_1', 'route_1']
        assert list(scenario['routes']) == ['route_1']

    def test_queues(self, runner):
        """In pedsim_ros people in line look in the direction, so the line extends in the opposite one."""
        assert scenario_of(runner, HALL)['queues'] == {
            'till': {'head': [10, 5], 'direction': 180, 'spacing': 0.5, 'service': [0.2, 1.8]}}

    def test_attractions(self, runner):
        """1 - exp(-0.02 x 3 x 7 / 1.34) = 0.269; the mean of 0 to 66.7 s is that of 0.03 losses a second."""
        assert scenario_of(runner, HALL)['attractions'] == {
            'shop': {'area': {'box': [[4, 8.5], [6, 9.5]]}, 'radius': 7, 'share': 0.269, 'wait': [0, 66.7]}}

    def test_sources(self, runner):
        """Two people each 5 s, 10 s, from the end of the first period on."""
        for options, period in ((), 5), (('--spawn-period', '10'), 10):
            source, = scenario_of(runner, HALL, *options)['sources']
            assert source == {'area': {'box': [[10.5, 2.5], [13.5, 3.5]]}, 'rate': 2 / period, 'interval': 'regular',
                              'from': period, 'route': 'route_4', 'speed': [0.89, 1.79], 'radius': 0.2}

    def test_crowded_boxes_are_enlarged(self, runner):
        """Twenty discs of 0.2 m with 0.05 m between them at 40 %: 20 pi 0.225^2 / 0.4 = 7.95 m2, 2.82 m a side."""
        scene = HALL.replace('n="3" dx="2" dy="4"', 'n="20" dx="1" dy="1"')
        status, messages, scenario = convert(runner, scene)
        assert status == 0
        assert yaml.safe_load(scenario)['agents'][0]['position'] == {'box': [[2.55, 3.55], [5.45, 6.45]]}
        assert_says(messages, 'hall.xml:10: agent: 20 bodies do not fit into 1 x 1 m; enlarged to 2.9 x 2.9 m')

    def test_boxes_of_several_agents(self, runner):
        """40 and half of 20, of 0.2 m, in 4 x 4 m: 50 pi 0.225^2 / 0.4 = 19.88 m2, 4.46 m a side; there are 4.4."""
        agent = '<agent x="{}" y="0" n="{}" dx="4" dy="4"><addwaypoint id="w"/></agent>'
        scene = '<scenario><waypoint id="w" x="0" y="9" r="1"/>{}{}</scenario>'
        for count, side in ((40, 4.5), (38, 4)):
            scenario = scenario_of(runner, scene.format(agent.format(0, count), agent.format(2, 20)))
            assert scenario['agents'][0]['position'] == {'box': [[-side / 2, -side / 2], [side / 2, side / 2]]}

    @pytest.mark.parametrize('name', ['yes', '7', 'a: b', '# "x"', 'Grüße'])
    def test_names(self, runner, name):
        quoted = name.replace('"', '&quot;')
        scenario = scenario_of(runner, HALL.replace('id="till"', f'id="{quoted}"'))
        assert list(scenario['queues']) == [name]
        assert scenario['routes']['route_2']['waypoints'][0] == {'queue': name}


class WalkTest:
    """The program evaluate walks converted scenes."""

    def test_people_come_and_leave(self, runner):
        """Two people come each 5 s; people of the first half minute have left after two minutes."""
        status, messages, _ = convert(runner, HALL, '--duration', '120')
        assert status == 0, messages
        record = runner.path('record.csv')
        runner.tool('evaluate', '--q-table', ANTICIPATION_TABLE, '--record', record, runner.path('hall.yaml'))
        with open(record, newline='', encoding='utf-8') as stream:
            people = list(csv.DictReader(stream))
        assert len(people) > 40
        assert [person['agent'] for person in people[7:17] if person['arrived'] != '1'] == []
        assert {person['touched'] for person in people} == {'0'}


class NotesTest:
    """What is not carried over is listed, on the screen and in the file."""

    NOTES = [
        (9, 'attraction shop: people stop there once, and only if they see it'),
        (14, "agent: the waypoints after the sink 'way out' are not carried over"),
        (19, "agent: a robot is a person here, with the size and speed of pedsim_ros's SOCIAL_DRIVE"),
        (20, 'agent: without waypoints it stands still: carried over as an obstacle'),
        (21, 'source: people come one by one, not 2 at once each 5 s'),
    ]

    def test_both_lists(self, runner):
        _, messages, scenario = convert(runner, HALL)
        assert messages.splitlines() == [f"{runner.path('hall.xml')}:{line}: {note}" for line, note in self.NOTES]
        comments = [line for line in scenario.splitlines() if line.startswith('#')]
        assert comments[2:] == [f'#   line {line}: {note}' for line, note in self.NOTES]

    def test_nothing_to_list(self, runner):
        scene = ('<scenario><waypoint id="w" x="0" y="0" r="1"/><agent x="4" y="1" n="1"><addwaypoint id="w"/></agent>'
                 '</scenario>')
        status, messages, scenario = convert(runner, scene)
        assert (status, messages) == (0, '')
        assert 'Not carried over' not in scenario

    @pytest.mark.parametrize('element, words', [
        ('<obstacle x1="1" y1="1" x2="1" y2="1"/>', 'obstacle: not carried over: it has no length'),
        ('<robot/>', 'robot: not carried over: unknown'),
        ('<attraction id="info" x="1" y="1" width="2" height="1" strength="0"/>',
         'attraction info: not carried over: its strength is 0'),
        ('<waypoint id="in" x="1" y="1" r="1" b="1"/>', 'waypoint in: b=1 (source) not carried over'),
        ('<agent x="1" y="1" n="0"/>', 'agent: not carried over: n is 0'),
        ('<source x="1" y="1" n="5"/>', 'source: not carried over: it has no waypoints'),
    ])
    def test_further_elements(self, runner, element, words):
        status, messages, _ = convert(runner, HALL.replace('  <attraction', f'  {element}\n  <attraction'))
        assert status == 0
        assert_says(messages, f'hall.xml:9: {words}')


class ErrorsTest:
    """A scene with an error is refused with file and line, and nothing is written."""

    @pytest.mark.parametrize('old, new, words', [
        ('</agent>', '</agents>', 'hall.xml:13: not XML: mismatched tag'),
        ('<scenario>', '<launch>', 'hall.xml:25: not XML: mismatched tag'),
        ('x1="0" y1="0" x2="20"', 'y1="0" x2="20"', "hall.xml:3: obstacle: the attribute 'x1' is missing"),
        ('x="2" y="5" r="1.5"', 'x="2" y="5"', "hall.xml:5: waypoint: the attribute 'r' is missing"),
        ('id="west" x="2"', 'x="2"', "hall.xml:5: waypoint: the attribute 'id' is missing"),
        ('x="2" y="5"', 'x="two" y="5"', "hall.xml:5: waypoint: x: expected a number, got 'two'"),
        ('x="2" y="5"', 'x="inf" y="5"', "hall.xml:5: waypoint: x: expected a number, got 'inf'"),
        ('r="1.5"', 'r="-1"', "hall.xml:5: waypoint: r: expected a number of 0 or more, got '-1'"),
        ('b="2"', 'b="3"', 'hall.xml:7: waypoint: b: expected 0 (simple), 1 (source) or 2 (sink), got 3'),
        ('id="east" x="18"', 'id="west" x="18"', "hall.xml:6: waypoint: the id 'west' is used in line 5 already"),
        ('strength="3"', 'strength="-1"',
         "hall.xml:9: attraction: strength: expected a number of 0 or more, got '-1'"),
        ('width="2" ', '', "hall.xml:9: attraction: the attribute 'width' is missing"),
        ('n="3"', 'n="1.5"', "hall.xml:10: agent: n: expected a whole number, got '1.5'"),
        ('type="3"', 'type="9"',
         'hall.xml:14: agent: type: expected one of 0 (adult), 1 (child), 2 (robot), 3 (elder), got 9'),
        ('<addwaypoint id="east"/>', '<addwaypoint id="eats"/>',
         "hall.xml:12: addwaypoint: there is no waypoint 'eats', did you mean 'east'?"),
        ('<addqueue id="till"/>', '<addqueue id="west"/>', "hall.xml:15: addqueue: there is no queue 'west'"),
        ('<addqueue id="till"/>', '<addqueue/>', "hall.xml:15: addqueue: the attribute 'id' is missing"),
        ('  <attraction', '  <addwaypoint id="west"/>\n  <attraction',
         'hall.xml:9: addwaypoint: expected within an agent or a source'),
    ])
    def test_errors(self, runner, old, new, words):
        assert old in HALL
        status, messages, scenario = convert(runner, HALL.replace(old, new, 1))
        assert status == 1
        assert_says(messages, 'pedsim_import: ', words)
        assert scenario == ''

    @pytest.mark.parametrize('text, words', [
        ('', 'hall.xml:1: not XML: no element found'),
        ('<launch/>', "hall.xml:1: launch: expected a scene of pedsim_ros, whose root is 'scenario'"),
        ('<scenario>\n</scenario>', 'hall.xml:1: scenario: expected at least one agent or source'),
    ])
    def test_no_scene(self, runner, text, words):
        status, messages, scenario = convert(runner, text)
        assert status == 1
        assert_says(messages, words)
        assert scenario == ''

    def test_unknown_waypoints_may_be_skipped(self, runner):
        scene = HALL.replace('<addwaypoint id="east"/>', '<addwaypoint id="eats"/>', 1)
        status, messages, scenario = convert(runner, scene, '--skip-unknown')
        assert status == 0
        assert_says(messages, 'hall.xml:12: addwaypoint eats: not carried over: the scene does not define it')
        assert len(yaml.safe_load(scenario)['routes']['route_1']['waypoints']) == 1

    def test_a_missing_file(self, runner):
        done = subprocess.run([in_package('scripts', 'pedsim_import'), runner.path('none.xml'), '--output', 'x.yaml'],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=PATIENCE, check=False)
        assert done.returncode == 1
        assert_says(done.stdout.decode(), 'none.xml: No such file or directory')


@pytest.mark.skipif(not SCENES, reason='the scenes of pedsim_ros are absent')
class ScenesTest:
    """The scenes that pedsim_ros ships."""

    @pytest.mark.parametrize('scene', SCENES, ids=[os.path.basename(scene) for scene in SCENES])
    def test_all_are_converted(self, runner, scene):
        text = read_text(scene)
        scenario = scenario_of(runner, text, '--skip-unknown')
        assert scenario['agents']
        assert all(entry['route'] in scenario['routes'] for entry in scenario['agents'])
