"""scripts/web_server with ROS: the page, clients of Foxglove and rosbridge, and frames of nonsense for all of them.
Each test has a ROS master of its own."""
import json
import os
import subprocess

import pytest
from crowd_launching.program import free_port
from node_packages import install_clients
from programs import PATIENCE, Launch, in_package, wait_for
from ros_crowds import Ros, environment_of
from web_clients import BAD_COMMANDS, Page, run, start_server, wait_for_url
from web_nonsense import PROTOCOLS, check_with_nonsense

# Episodes of a few seconds in a building, so that clients see maps and results.
SCENARIO = '''
name: rooms
duration: 3
goal_tolerance: 0.3
map: %s
agents:
  - {count: 5, position: {map: free}, goal: {map: free}, speed: 1, radius: 0.2}
robots:
  - {name: robot, position: [22, 8], goal: [28, 8], radius: 0.25, max_speed: 1}
'''


@pytest.fixture
def rooms(runner):
    """The file of SCENARIO."""
    return runner.write('rooms.yaml', SCENARIO % in_package('config', 'maps', 'office.yaml'))


@pytest.fixture
def ros(runner):
    return Ros(runner)


@pytest.fixture(scope='session')
def node_clients(tmp_path_factory):
    """A folder with the clients of test/web and the packages that they use."""
    folder = tmp_path_factory.mktemp('web')
    install_clients(folder)
    return folder


def run_client(folder, *words):
    """Runs a client of Node.js. Returns what it prints."""
    done = subprocess.run(['node', *map(str, words)], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          timeout=2 * PATIENCE, check=False)
    assert done.returncode == 0, done.stderr.decode()
    return json.loads(done.stdout)


def check_map_and_results(messages):
    """Checks what a client got of a map and of the results of an episode."""
    info, cells = messages['/map']['info'], messages['/map']['data']
    cells = list(cells.values()) if isinstance(cells, dict) else cells  # typed arrays of JavaScript in JSON
    assert len(cells) == info['width'] * info['height'] > 1000 and {0, 100} <= set(cells)
    results = messages['/episode_results']
    assert results['scenario'] == 'rooms' and len(results['agents']) == 5


class RosBackEndTest:
    """The crowd of a crowd_controller."""

    def test_commands(self, runner, ros):
        async def test(server):
            async with Page(server) as page:
                hello = await page.next('hello')
                assert hello['back_end'] == 'ros' and 'circle12' in hello['scenarios']
                scene = await page.next('scene')
                assert scene['scenario'] == 'circle6' and len(scene['agents']) == 6
                await page.frame(lambda frame: frame.tick > 0)
                await page.send('select', agent=1)
                mind = await page.next('mind')
                assert mind['agent'] == 1 and mind['actions'][mind['chosen']]['visits'] > 0 and mind['neighbours']
                await page.send('pause')
                paused = await page.next('status', lambda status: not status['playing'])
                await page.send('step', ticks=3)
                frame = await page.frame(lambda frame: frame.tick == paused['tick'] + 3)
                assert len(frame.id) == 6
                await page.send('add_agent', position=[0, 7], goal=[0, -7], radius=0.2, max_speed=1)
                assert (await page.next('agents'))['agents'] == [{'id': 6, 'radius': 0.2, 'goal': [0, -7]}]
                await page.send('add_wall', from_=[8, -1], to=[8, 1])
                wall, = (await page.next('scene', lambda scene: scene['walls']))['walls']
                assert (wall['from'], wall['to']) == ([8, -1], [8, 1])
                await page.send('remove_wall', wall=wall['id'])
                await page.next('scene', lambda scene: not scene['walls'])
                await page.send('speed', factor=3)
                await page.next('status', lambda status: status['speed'] == 3)
                for message, word in BAD_COMMANDS:
                    await page.socket.send_str(json.dumps(message))
                    error = await page.next('error')
                    assert error['command'] == message['command'] and word in error['message'], (message, error)
                await page.send('scenario', name='circle12')
                assert len((await page.next('scene', lambda scene: scene['scenario'] == 'circle12'))['agents']) == 12
                await page.send('reset', seed=4)
                await page.send('play')
                await page.frame(lambda frame: frame.tick > 2)
        ros.start_crowd()
        run(test(start_server(runner, '--ros', environment=ros.environment)))

    def test_a_page_that_comes_in_a_pause(self, runner, ros):
        async def test(server):
            async with Page(server) as page:
                await page.frame(lambda frame: frame.tick > 5)
                await page.send('pause')
                await page.next('status', lambda status: not status['playing'])
                tick = ros.pause()  # the status may be that in the middle of the last tick
            wait_for(lambda: not ros.topics_of('/web_server'), 'the end of the subscriptions')
            async with Page(server) as page:
                await page.next('scene')
                assert (await page.frame()).tick == tick
        ros.start_crowd()
        run(test(start_server(runner, '--ros', environment=ros.environment)))

    def test_it_listens_only_while_there_is_a_client(self, runner, ros):
        async def test(server):
            assert not ros.topics_of('/web_server')
            async with Page(server) as page:
                await page.frame()
                assert '/agents' in ros.topics_of('/web_server')
                assert '/decision_values' not in ros.topics_of('/web_server')
            wait_for(lambda: not ros.topics_of('/web_server'), 'the end of the subscriptions')
        ros.start_crowd()
        run(test(start_server(runner, '--ros', environment=ros.environment)))

    def test_client_of_foxglove(self, runner, ros, rooms, node_clients):
        ros.start_crowd(rooms)
        ros.start_node('crowd_markers')
        server = start_server(runner, '--ros', environment=ros.environment)
        wait_for(lambda: '/markers' in dict(ros.master.getTopicTypes()), 'the markers')
        topics = ['/agents', '/markers', '/scenario', '/walls', '/robots', '/controller_status', '/agent_poses', '/tf',
                  '/scan', '/odom', '/map', '/episode_results']
        seen = run_client(node_clients, 'foxglove_client.mjs', f'ws://127.0.0.1:{server.port}/', *topics)
        assert seen['info']['supportedEncodings'] == ['ros1']
        assert seen['types']['/agent_poses'] == 'geometry_msgs/PoseArray'
        assert seen['types']['/scan'] == 'sensor_msgs/LaserScan'
        assert [agent['agent'] for agent in seen['messages']['/agents']['agents']] == [0, 1, 2, 3, 4]
        assert len(seen['messages']['/agent_poses']['poses']) == 5
        assert seen['messages']['/scenario']['name'] == 'rooms'
        assert seen['types']['/map'] == 'nav_msgs/OccupancyGrid'
        check_map_and_results(seen['messages'])
        paused, refused, misfit = seen['calls']
        assert paused['success'] is True and refused['success'] is False
        assert 'does not fit' in misfit['failure']
        wait_for(lambda: not ros.topics_of('/web_server'), 'the end of the subscriptions')

    def test_client_of_rosbridge(self, runner, ros, rooms, node_clients):
        ros.start_crowd(rooms)
        server = start_server(runner, '--ros', environment=ros.environment)
        words = ['/agents', 'social_crowd/AgentStates', '/scan', 'sensor_msgs/LaserScan', '/learner_status',
                 'social_crowd/LearnerStatus', '/robots', 'social_crowd/RobotStates', '/map', 'nav_msgs/OccupancyGrid',
                 '/episode_results', 'social_crowd/EpisodeResult']
        seen = run_client(node_clients, 'rosbridge_client.mjs', f'ws://127.0.0.1:{server.port}/rosbridge', *words)
        assert '/agents' in seen['topics']['topics']
        assert len(seen['messages']['/agents']['agents']) == 5
        check_map_and_results(seen['messages'])
        assert None in seen['messages']['/scan']['ranges']  # infinite: nothing was seen
        paused, spawned, misfit, other = seen['calls']
        assert paused['success'] is True and spawned['success'] is True and spawned['agent'] == 5
        assert 'position' in misfit['failure'] and 'no service' in other['failure']


class LaunchTest:
    """web.launch"""

    def test_it_shows_a_crowd(self, runner):
        if not os.path.exists(in_package('web', 'dist', 'index.html')):
            pytest.skip('there is no page')
        port = free_port()
        server = wait_for_url(runner.start('roslaunch', [
            'roslaunch', '-p', str(port), 'social_crowd', 'web.launch', 'scenario:=circle12', 'port:=0'],
            environment_of(runner, port), Launch))

        async def test():
            async with Page(server) as page:
                assert (await page.next('hello'))['back_end'] == 'ros'
                assert (await page.next('scene'))['scenario'] == 'circle12'
                await page.frame(lambda frame: frame.tick > 2)
        run(test())


class FuzzTest:
    """Random and mutated frames."""

    def test_the_server_survives_nonsense(self, runner, ros):
        ros.start_crowd()
        server = start_server(runner, '--ros', environment=ros.environment)
        check_with_nonsense(server, PROTOCOLS)
