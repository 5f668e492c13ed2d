"""The core as WebAssembly beside the Python module: the same trajectories, and the messages of its worker."""
import base64
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess

import pytest
import social_crowd
from node_packages import find_chromium, install_clients
from programs import PATIENCE, in_package

SUPPORT = pathlib.Path(__file__).parent.parent / 'support'
# Of a scenario; docs/browser.md names a pass with all of them.
AGENT_TICKS, LEAST_TICKS = int(os.environ.get('SOCIAL_CROWD_AGENT_TICKS', 50000)), 5
FEW_AGENTS = 20  # fewer count as many, so that no scenario is walked longer than others
MAGIC = 0x57524331


@pytest.fixture(scope='module')
def web(request):
    """The folder of what `scripts/web build` has made."""
    build = request.config.getoption('--build')
    if build is None or not (pathlib.Path(build) / 'web/page/social_crowd.js').exists():
        pytest.skip('the page without a server is not built: scripts/web build')
    if shutil.which('node') is None:
        pytest.skip('node is not installed')
    return pathlib.Path(build).resolve() / 'web'


def run(script, file, given):
    """Returns what a program for node prints, as JSON."""
    done = subprocess.run(['node', SUPPORT / script, file, json.dumps(given)], stdout=subprocess.PIPE, check=True)
    return json.loads(done.stdout)


def table_of(scenario):
    return 'human' if scenario.startswith('place_') else 'anticipation'


def digests_of(walk):
    """Returns the digest of all agents after each tick, as wasm_walk.mjs does."""
    crowd = social_crowd.Crowd(walk['scenario'], walk['table'], seed=walk['seed'])
    digests, walked = [], 0
    while walked <= walk['agent_ticks'] or len(digests) <= walk['least_ticks']:
        shown = b''.join(array.tobytes() for array in (crowd.ids, crowd.statuses, crowd.positions, crowd.headings))
        digests.append(hashlib.sha256(shown).hexdigest()[:12])
        walked += max(len(crowd.ids), walk['few_agents'])
        if not crowd.step():
            break
    return digests


def talk(web, *commands):
    """Returns the answers of the worker to each command, the greeting first."""
    return run('wasm_protocol.cjs', web / 'page/social_crowd.js', commands)


def only(messages, kind):
    """Returns the message of a type, of which there must be one."""
    found = [message for message in messages if message['type'] == kind]
    assert len(found) == 1, messages
    return found[0]


def last_frame(messages):
    """Returns the last frame; how many come before it depends on the time that ticks take."""
    return [message for message in messages if message['type'] == 'frame'][-1]


class ScenariosTest:
    """All scenarios of the package."""

    def test_trajectories_are_the_same(self, web):
        walks = [{'scenario': scenario, 'table': table_of(scenario), 'seed': 7, 'agent_ticks': AGENT_TICKS,
                  'least_ticks': LEAST_TICKS, 'few_agents': FEW_AGENTS} for scenario in social_crowd.Scenario.names()]
        made = run('wasm_walk.mjs', web / 'module.js', walks)
        assert made['names'] == [walk['scenario'] for walk in walks]
        different = {}
        for walk, result in zip(walks, made['walks']):
            native = digests_of(walk)
            if native != result['digests']:
                same = [one == other for one, other in zip(native, result['digests'])]
                different[walk['scenario']] = same.index(False) if False in same else len(same)
        assert different == {}  # the first tick that differs, by scenario


def test_the_speed_of_1000_people(web):
    """Is measured and printed; what it is depends on the machine."""
    command = ['node', in_package('test/web/wasm_speed.mjs'), web / 'module.js', 'place_station', '1000', '1']
    said = subprocess.run(command, stdout=subprocess.PIPE, check=True, encoding='utf-8').stdout
    assert re.match(r'\d+ to \d+ people walk: [\d.]+ times real time, ', said)
    print(said)


def test_the_page_opens_as_a_file(web, tmp_path):
    chromium = find_chromium()
    install_clients(tmp_path)
    done = subprocess.run(['node', 'file_page.mjs', web / 'page/index.html'], cwd=tmp_path, stdout=subprocess.PIPE,
                          check=True, timeout=5 * PATIENCE, env={**os.environ, 'CHROMIUM': chromium})
    assert json.loads(done.stdout) == []


class WorkerTest:
    """The messages of the page's protocol."""

    def test_greeting(self, web):
        hello, scene, *others = talk(web)[0]
        assert hello['type'] == 'hello' and hello['protocol'] == 1 and hello['back_end'] == 'wasm'
        assert hello['scenarios'] == social_crowd.Scenario.names() and 'add_wall' in hello['commands']
        assert scene['type'] == 'scene' and scene['scenario'] == 'circle6' and len(scene['agents']) == 6
        frame, status = only(others, 'frame'), only(others, 'status')
        assert frame['magic'] == MAGIC and frame['count'] == 6 and frame['bytes'] == 24 + 6 * 21
        assert not status['playing'] and status['walking'] == 6

    def test_steps_walk_as_natively(self, web):
        crowd = social_crowd.Crowd('circle6', seed=5)
        for _ in range(4):
            crowd.step()
        *_, answer = talk(web, {'command': 'reset', 'seed': 5}, {'command': 'step', 'ticks': 4})
        frame = last_frame(answer)
        assert frame['tick'] == 4 and frame['time'] == crowd.time
        assert frame['x'] == pytest.approx(crowd.positions[0, 0], abs=1e-6)

    def test_it_plays_until_a_pause(self, web):
        *_, played, paused, later, stepped = talk(web, {'command': 'speed', 'factor': 20}, {'command': 'play'},
                                                  {'until': 40}, {'command': 'pause'}, {'later': True},
                                                  {'command': 'step'})
        assert last_frame(played)['tick'] >= 40
        assert not only(paused, 'status')['playing'] and later == []
        assert stepped[-1]['tick'] == only(paused, 'status')['tick'] + 1

    def test_changes_of_the_world(self, web):
        commands = [{'command': 'add_agent', 'position': [9, 9], 'goal': [-9, 9]},
                    {'command': 'set_goal', 'agent': 6, 'goal': [-8, 8]}, {'command': 'remove_agent', 'agent': 0},
                    {'command': 'add_obstacle', 'position': [7, 7], 'radius': 0.3},
                    {'command': 'add_wall', 'from': [-9, -9], 'to': [9, -9]}, {'command': 'remove_wall', 'wall': 0},
                    {'command': 'remove_obstacle', 'obstacle': 0}]
        _, added, sent, removed, obstacle, wall, no_wall, no_obstacle = talk(web, *commands)
        assert only(added, 'agents')['agents'] == [{'id': 6, 'radius': 0.25, 'goal': [-9, 9]}]
        assert only(added, 'frame')['count'] == 7
        assert only(sent, 'agents')['agents'][0]['goal'] == [-8, 8]
        assert only(removed, 'status')['walking'] == 6
        assert only(obstacle, 'scene')['obstacles'] == [{'id': 0, 'position': [7, 7], 'radius': 0.3}]
        assert only(wall, 'scene')['walls'] == [{'id': 0, 'from': [-9, -9], 'to': [9, -9]}]
        assert only(no_wall, 'scene')['walls'] == [] and only(no_obstacle, 'scene')['obstacles'] == []

    def test_the_mind_of_an_agent(self, web):
        mind = only(talk(web, {'command': 'select', 'agent': 2})[-1], 'mind')
        assert mind['agent'] == 2 and set(mind['neighbours']) <= {0, 1, 3, 4, 5}
        assert mind['actions'][mind['chosen']]['value'] == max(action['value'] for action in mind['actions'])

    def test_a_place_with_a_map(self, web):
        scene = only(talk(web, {'command': 'scenario', 'name': 'place_office'})[-1], 'scene')
        grid = scene['map']
        assert len(base64.b64decode(grid['cells'])) == grid['width'] * grid['height'] and scene['walls']

    def test_refused_commands_change_nothing(self, web):
        refused = [
            ({'command': 'fly'}, "unknown command 'fly'"),
            ({'command': 'toString'}, "unknown command 'toString'"),
            ({'command': 'play', 'at': 1}, "unknown key 'at'"),
            ({'command': 'speed'}, 'factor'),
            ({'command': 'speed', 'factor': 'fast'}, 'factor'),
            ({'command': 'add_wall', 'from': [0, 0], 'to': [1, None]}, 'to'),
            ({'command': 'scenario', 'name': 'nowhere'}, "no scenario 'nowhere'"),
            ({'command': 'remove_agent', 'agent': 77}, '77'),
            ({'command': 'add_agent', 'position': [4, 0], 'goal': [2, 2], 'radius': 1e9}, 'radius'),
            ({'command': 'add_agent', 'position': [4, 0], 'goal': [2, 2]}, 'the place is taken by agent 0'),
            ({}, 'unknown command'),
            (None, 'unknown command'),
        ]
        step = {'command': 'step', 'ticks': 3}
        _, *answers, last = talk(web, *[command for command, _ in refused], step)
        for (_, problem), answer in zip(refused, answers):
            assert len(answer) == 1 and problem in answer[0]['message'] and answer[0]['type'] == 'error'
        assert last_frame(last) == last_frame(talk(web, step)[-1])
