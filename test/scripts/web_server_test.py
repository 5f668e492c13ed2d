"""scripts/web_server without ROS: commands of the page, refusals, access, and clients that do not read."""
import json
import os
import pathlib
import subprocess
import time

import aiohttp
import numpy
import pytest
import social_crowd
from programs import CIRCLE6, PATIENCE, in_package, tools_folder, wait_for
from web_clients import BAD_COMMANDS, Page, memory_of, run, start_server, wait_for_url
from web_nonsense import PROTOCOLS, check_with_nonsense

GROWTH = 64  # [MB] by which slow clients may let the server grow
ANSWERS = 20


def uses_processor(process):
    """Returns whether a process uses processor time."""
    def ticks():
        fields = pathlib.Path(f'/proc/{process.process.pid}/stat').read_text(encoding='ascii').rsplit(')', 1)[1].split()
        return int(fields[11]) + int(fields[12])
    before = ticks()
    time.sleep(0.2)
    return ticks() > before


async def status_of(url, **options):
    """Returns status and cookies of the answer to a request."""
    async with aiohttp.ClientSession(cookie_jar=aiohttp.DummyCookieJar()) as session:
        async with session.get(url, **options) as answer:
            await answer.read()
            return answer.status, answer.cookies


class PythonBackEndTest:
    """A crowd of the Python module."""

    def test_first_messages_and_steps_are_those_of_the_crowd(self, runner):
        async def test(server):
            crowd = social_crowd.Crowd(CIRCLE6, 'anticipation', seed=7)
            async with Page(server) as page:
                hello = await page.next('hello')
                assert (hello['protocol'], hello['back_end']) == (1, 'python')
                assert 'place_office' in hello['scenarios'] and 'add_wall' in hello['commands']
                scene = await page.next('scene')
                assert scene['scenario'] == 'circle6' and scene['map'] is None and scene['tick_duration'] == 0.1
                assert [agent['id'] for agent in scene['agents']] == crowd.ids.tolist()
                x0, y0, x1, y1 = scene['bounds']
                assert (crowd.positions > (x0, y0)).all() and (crowd.positions < (x1, y1)).all()
                for tick in (0, 4):
                    for _ in range(tick):
                        crowd.step()
                    if tick:
                        await page.send('step', ticks=tick)
                    frame = await page.frame(lambda frame: frame.tick == tick)
                    assert numpy.array_equal(frame.x, crowd.positions[:, 0].astype('f4'))
                    assert numpy.array_equal(frame.heading, crowd.headings.astype('f4'))
                    assert frame.state.tolist() == crowd.statuses.tolist()
        run(test(start_server(runner, CIRCLE6, '--seed', 7)))

    def test_play_pause_speed_and_reset(self, runner):
        async def test(server):
            async with Page(server) as page:
                await page.send('speed', factor=0)
                await page.send('play')
                assert 'pause' in await page.refusal('step')
                await page.next('status', lambda status: status['over'])
                await page.send('reset', seed=3)
                status = await page.next('status', lambda status: status['tick'] == 0)
                assert (status['playing'], status['over'], status['walking']) == (False, False, 6)
                await page.send('play')
                await page.frame(lambda frame: frame.tick > 3)
                await page.send('pause')
                await page.next('status', lambda status: not status['playing'])
                await page.send('scenario', name='circle12')
                scene = await page.next('scene', lambda scene: scene['scenario'] == 'circle12')
                assert len(scene['agents']) == 12
        run(test(start_server(runner, CIRCLE6)))

    def test_it_walks_only_while_a_page_looks(self, runner):
        async def test(server):
            async with Page(server) as page:
                await page.send('speed', factor=0)
                await page.send('play')
                await page.frame(lambda frame: frame.tick > 5)
            wait_for(lambda: not uses_processor(server), 'the end of the walk')
            async with Page(server) as page:
                assert (await page.next('status'))['playing']
                tick = (await page.frame()).tick
                await page.frame(lambda frame: frame.tick > tick)
        run(test(start_server(runner, 'crowd_circle_1000')))

    def test_changes_of_the_world(self, runner):
        async def test(server):
            async with Page(server) as page:
                await page.next('scene')
                await page.send('add_agent', position=[0, 4.5], goal=[0, -4.5], radius=0.2)
                new, = (await page.next('agents'))['agents']
                assert new == {'id': 6, 'radius': 0.2, 'goal': [0, -4.5]}
                await page.send('set_goal', agent=6, goal=[1, 1])
                assert (await page.next('agents'))['agents'][0]['goal'] == [1, 1]
                await page.send('remove_agent', agent=6)
                await page.frame(lambda frame: len(frame.id) == 6 or frame.state[6] == 2)
                await page.send('add_wall', from_=[5, -1], to=[5, 1])
                wall, = (await page.next('scene', lambda scene: scene['walls']))['walls']
                assert (wall['from'], wall['to']) == ([5, -1], [5, 1])
                await page.send('remove_wall', wall=wall['id'])
                await page.next('scene', lambda scene: not scene['walls'])
                await page.send('add_obstacle', position=[6, 0], radius=0.4)
                scene = await page.next('scene', lambda scene: scene['obstacles'])
                assert scene['obstacles'] == [{'id': 0, 'position': [6, 0], 'radius': 0.4}]
                await page.send('remove_obstacle', obstacle=0)
                await page.next('scene', lambda scene: not scene['obstacles'])
                assert await page.refusal('add_agent', position=scene['agents'][0]['goal'], goal=[1e9, 0])
            async with Page(server) as page:  # one that comes later
                assert len((await page.next('scene'))['agents']) == (await page.frame()).id.size
        run(test(start_server(runner, CIRCLE6)))

    def test_the_mind_foretells_the_next_move(self, runner):
        async def test(server):
            async with Page(server) as page:
                before = await page.frame()
                await page.send('select', agent=2)
                mind = await page.next('mind')
                assert mind['agent'] == 2 and mind['tick'] == 0 and len(mind['neighbours']) > 0
                chosen = mind['actions'][mind['chosen']]
                assert chosen['visits'] > 0 and 0 <= chosen['speed'] < 2
                assert all(numpy.isfinite(action['value']) for action in mind['actions'])
                await page.send('step')
                after = await page.frame(lambda frame: frame.tick == 1)
                turned = after.heading[2] - before.heading[2] - chosen['direction']
                assert abs((turned + numpy.pi) % (2 * numpy.pi) - numpy.pi) < 1e-5 or after.speed[2] == 0
        run(test(start_server(runner, CIRCLE6)))

    def test_robots_and_recorded_people(self, runner):
        async def test(server):
            async with Page(server) as page:
                await page.send('scenario', name='recorded_street')
                await page.next('scene', lambda scene: scene['scenario'] == 'recorded_street')
                await page.send('step', ticks=3)
                assert (await page.next('obstacles'))['obstacles']
                await page.send('scenario', name='robot_circle_5')
                scene = await page.next('scene', lambda scene: scene['robots'])
                robot, = (await page.next('robots'))['robots']
                assert robot['name'] == scene['robots'][0]['name'] and len(robot['pose']) == 3
                assert any(robot['scan']['ranges'])  # of the people about it
        run(test(start_server(runner, CIRCLE6)))

    def test_recordings(self, runner):
        folder = in_package('config', 'recordings')

        async def test(server):
            async with Page(server) as page:
                await page.send('recordings')
                names = (await page.next('recordings'))['names']
                assert names == ['street.csv']
                await page.send('open_recording', name=names[0])
                recording = await page.next('recording')
                lines = recording['csv'].splitlines()
                assert lines[0] == 'instance,tick,agent,x,y' and len(lines) > 100 and recording['tick_duration'] > 0
        run(test(start_server(runner, CIRCLE6, '--recordings', folder)))


class RefusalTest:
    """Messages that are no commands change nothing."""

    def test_bad_commands(self, runner):
        async def test(server):
            async with Page(server) as page:
                before = await page.frame()
                for message, word in BAD_COMMANDS:
                    await page.socket.send_str(json.dumps(message))
                    error = await page.next('error')
                    assert error['command'] == message['command'] and word in error['message'], (message, error)
                await page.send('step')
                after = await page.frame(lambda frame: frame.tick > 0)
                assert after.tick == 1 and after.id.tolist() == before.id.tolist()
        run(test(start_server(runner, CIRCLE6)))

    @pytest.mark.parametrize('data', ['{', '[]', '{}', '{"command": 1}', '[' * 30000, b'{"command": "play"}'])
    def test_what_is_not_the_protocol_ends_the_connection(self, runner, data):
        async def test(server):
            async with Page(server) as page:
                await (page.socket.send_bytes if isinstance(data, bytes) else page.socket.send_str)(data)
                assert (await page.next('error'))['command'] is None
                with pytest.raises(ConnectionError, match='1008'):
                    await page.next('none')
        run(test(start_server(runner, CIRCLE6)))

    def test_long_messages_and_many_clients(self, runner):
        async def test(server):
            async with Page(server) as page:
                await page.socket.send_str(' ' * 70000)
                with pytest.raises(ConnectionError, match='1009'):
                    await page.next('none')
            pages = [Page(server) for _ in range(33)]
            for page in pages[:32]:
                await page.__aenter__()
            with pytest.raises(aiohttp.WSServerHandshakeError) as error:
                await pages[32].__aenter__()
            assert error.value.status == 503
            for page in pages[:32]:
                await page.__aexit__()
        run(test(start_server(runner, CIRCLE6)))


class AccessTest:
    """Who may connect."""

    def test_this_machine_only(self, runner):
        async def test(server):
            url = server.url
            assert (await status_of(url))[0] == 200
            assert (await status_of(url + '/..%2f..%2f..%2fetc/passwd'))[0] in (403, 404)
            assert (await status_of(url, headers={'Host': f'crowd.example:{server.port}'}))[0] == 403
            assert (await status_of(url, headers={'Origin': 'http://crowd.example'}))[0] == 403
            assert (await status_of(url, headers={'Origin': 'https://allowed.example'}))[0] == 200
            for origin, status in (('http://crowd.example', 403), ('null', 403), ('http://127.0.0.1', 403)):
                with pytest.raises(aiohttp.WSServerHandshakeError) as error:
                    await Page(server, origin=origin).__aenter__()
                assert error.value.status == status
            async with Page(server, origin=server.url) as page:
                await page.next('hello')
        server = start_server(runner, CIRCLE6, '--allow-origin', 'https://allowed.example')
        assert addresses_of(server.port) == {'0100007F'}  # 127.0.0.1
        run(test(server))

    def test_token_for_other_machines(self, runner):
        async def test(server):
            assert len(server.query) > 20
            for path in ('/', '/index.html', '/ws'):
                assert (await status_of(server.url + path))[0] == 403
                assert (await status_of(f'{server.url}{path}?token=wrong'))[0] == 403
            status, cookies = await status_of(server.url + '/' + server.query)
            assert status == 200
            cookie, = cookies.values()
            assert cookie['httponly'] and cookie['samesite'] == 'Strict'
            assert (await status_of(server.url + '/index.html', cookies={cookie.key: cookie.value}))[0] == 200
            with pytest.raises(aiohttp.WSServerHandshakeError):
                await Page(server).__aenter__()
            async with Page(server, server.query) as page:
                await page.next('hello')
        run(test(start_server(runner, CIRCLE6, '--host', '0.0.0.0')))

    @pytest.mark.parametrize('words, message', [
        ([], 'expected either'), (['--ros', 'circle6'], 'expected either'), (['circle6', '--port', '70000'], 'port'),
        (['circle6', '--token', 'short'], 'at least 8'), (['circle6', '--recordings', '/none'], 'not a folder'),
        (['circle6', '--host', '192.0.2.1'], 'of 192.0.2.1'), (['circle66'], "did you mean 'circle6'"),
        (['circle6', '--q-table', 'none'], 'no Q-table')])
    def test_wrong_words(self, words, message, tmp_path):
        (tmp_path / 'index.html').touch()
        done = subprocess.run([in_package('scripts', 'web_server'), *words, '--page', tmp_path], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, timeout=PATIENCE, check=False)
        assert done.returncode in (1, 2) and message in done.stdout.decode()


def addresses_of(port):
    """Returns the addresses on which somebody listens at a port, as the kernel writes them."""
    found = set()
    for file in ('/proc/net/tcp', '/proc/net/tcp6'):
        for line in pathlib.Path(file).read_text(encoding='ascii').splitlines()[1:]:
            address, number = line.split()[1].split(':')
            if int(number, 16) == port and line.split()[3] == '0A':
                found.add(address)
    return found


class SlowClientTest:
    """A client that does not read."""

    def test_frames_are_dropped_and_answers_are_not(self, runner):
        async def test(server):
            async with Page(server) as slow, Page(server) as fast:
                await slow.next('hello')
                await fast.send('speed', factor=3)  # the episode is longer than the test
                await fast.send('play')
                await fast.frame(lambda frame: frame.tick > 5)
                before = memory_of(server)
                for _ in range(ANSWERS):
                    await slow.send('recordings')
                sent = [(await fast.frame()).tick for _ in range(300)]
                assert memory_of(server) < before + GROWTH
                answers, ticks = 0, [0]
                while answers < ANSWERS or ticks[-1] < sent[-1]:
                    message = await slow.receive(lambda message: True)
                    if isinstance(message, dict):
                        answers += message['type'] == 'recordings'
                    else:
                        ticks.append(message.tick)
                assert answers == ANSWERS and ticks == sorted(ticks)
                assert len([tick for tick in ticks if sent[0] <= tick <= sent[-1]]) < len(sent)
        run(test(start_server(runner, 'crowd_circle_1000')))


class FuzzTest:
    """Random and mutated frames."""

    def test_the_server_survives_nonsense(self, runner):
        check_with_nonsense(start_server(runner, CIRCLE6), PROTOCOLS[:1])


class StartTest:
    """How it is started."""

    def test_evaluate(self, runner):
        evaluate = os.path.join(tools_folder(), 'evaluate')
        if not os.path.exists(in_package('web', 'dist', 'index.html')):
            pytest.skip('there is no page')
        server = wait_for_url(runner.start('evaluate', [
            evaluate, '--q-table', 'anticipation', '--seed', '7', '--web', '--web-port', '0', 'circle12']))

        async def test():
            async with Page(server) as page:
                assert len((await page.next('scene'))['agents']) == 12
        run(test())
