"""Random and mutated frames for scripts/web_server."""
import json
import os
import random
import struct

from web_clients import BINARY, TEXT, Page, RawClient, framed, memory_of, run

FRAMES = int(os.environ.get('SOCIAL_CROWD_FUZZ_FRAMES', 3000))
GROWTH = 64  # [MB] by which they may let the server grow
# Path, subprotocol, and messages that fit; the first one is that of the page.
PROTOCOLS = [
    ('/ws', None, [
        {'command': 'pause'}, {'command': 'play'}, {'command': 'step', 'ticks': 1}, {'command': 'select', 'agent': 1},
        {'command': 'add_agent', 'position': [1, 2], 'goal': [3, 4]}, {'command': 'speed', 'factor': 2},
        {'command': 'set_goal', 'agent': 1, 'goal': [0, 0]}, {'command': 'recordings'},
        {'command': 'add_wall', 'from': [9, 9], 'to': [9, 8]}]),
    ('/', 'foxglove.websocket.v1', [
        {'op': 'subscribe', 'subscriptions': [{'id': 1, 'channelId': 2}]},
        {'op': 'getParameters', 'parameterNames': []},
        {'op': 'unsubscribe', 'subscriptionIds': [1]}, struct.pack('<BIII', 2, 3, 1, 4) + b'ros1' + b'\1']),
    ('/rosbridge', None, [
        {'op': 'subscribe', 'topic': '/agents', 'throttle_rate': 100}, {'op': 'unsubscribe', 'topic': '/agents'},
        {'op': 'call_service', 'service': '/crowd_controller/pause', 'args': {'data': False}, 'id': 'a'},
        {'op': 'call_service', 'service': '/crowd_controller/spawn_agent', 'args': {'pose': {'x': 1}}},
        {'op': 'call_service', 'service': '/rosapi/topics'}]),
]
VALUES = [b'null', b'1e999', b'-1', b'NaN', b'{}', b'[]', b'"\\ud800"', b'18446744073709551616', b'"%s"' % (b'x' * 300),
          b'true']


def send_nonsense(server, count, chance, protocols):
    """Sends a number of frames to these protocols in turn; connects again where the server has ended the connection."""
    clients = [None] * len(protocols)
    for i in range(count):
        at = i % len(protocols)
        path, protocol, messages = protocols[at]
        if clients[at] is None:
            clients[at] = RawClient(server, path, protocol)
        if not clients[at].send(nonsense(messages, chance)):
            clients[at].close()
            clients[at] = None
    for client in clients:
        if client:
            client.close()


def check_with_nonsense(server, protocols):
    """Sends FRAMES frames; the server does not grow, and then serves a page."""
    before = memory_of(server)
    send_nonsense(server, FRAMES, random.Random(39), protocols)
    growth = memory_of(server) - before
    print(f'{FRAMES} frames: the server has grown by {growth:.1f} MB')
    assert growth < GROWTH and server.is_running()

    async def test():
        async with Page(server) as page:
            await page.next('hello')
            await page.next('scene')
    run(test())
    assert 'Traceback' not in server.output()


def nonsense(messages, chance):
    """Returns a frame: a mutated message, random bytes in a frame, or random bytes in place of one."""
    message = chance.choice(messages)
    kind, data = chance.random(), bytearray(message if isinstance(message, bytes) else json.dumps(message).encode())
    if kind < 0.03:
        return chance.randbytes(chance.randrange(1, 200))
    if kind < 0.1:
        return framed(chance.randbytes(chance.randrange(200)), chance.randrange(16), chance.randbytes(4))
    if kind < 0.6:  # another value in its place
        parts = bytes(data).split(b': ')
        place = chance.randrange(len(parts))
        parts[place] = chance.choice(VALUES) + parts[place][-chance.randrange(1, 3):]
        data = bytearray(b': '.join(parts))
    elif kind < 0.9:
        for _ in range(chance.randrange(1, 4)):
            place = chance.randrange(len(data))
            data[place:place + chance.randrange(3)] = chance.randbytes(chance.randrange(3))
    return framed(bytes(data), chance.choice((TEXT, TEXT, TEXT, BINARY)), chance.randbytes(4))
