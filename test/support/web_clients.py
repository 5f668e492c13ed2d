"""Clients of scripts/web_server for tests: a page, and raw connections that send any bytes."""
import asyncio
import base64
import json
import os
import re
import socket
import struct

import aiohttp
import numpy
from programs import PATIENCE, in_package, wait_for

HEAD = struct.Struct('<IIdII')
COLUMNS = (('id', '<u4'), ('x', '<f4'), ('y', '<f4'), ('heading', '<f4'), ('speed', '<f4'), ('state', 'u1'))
TEXT, BINARY = 1, 2  # operations of frames of a WebSocket


def start_server(runner, *words, environment=None):
    """Starts the server at a free port with a page of its own. Returns its Process with `url` and `port`."""
    folder = os.path.join(runner.folder, 'page')
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, 'index.html'), 'w', encoding='utf-8') as stream:
        stream.write('<!doctype html><title>test</title>')
    server = runner.start('web_server', [in_package('scripts', 'web_server'), '--port', '0', '--page', folder,
                                         *map(str, words)], environment)
    return wait_for_url(server)


def wait_for_url(server):
    """Waits until a server serves. Returns its Process with `url` and `port`."""
    def url():
        assert server.is_running(), server.output()
        return re.search(r'open http://([^:/]+):(\d+)/(\?token=\S+)?$', server.output(), re.MULTILINE)
    found = wait_for(url, 'the server')
    server.port, server.query = int(found[2]), found[3] or ''
    server.url = f'http://127.0.0.1:{server.port}'
    return server


def memory_of(process):
    """Returns the memory that a process has in use [MB]."""
    with open(f'/proc/{process.process.pid}/status', encoding='ascii') as stream:
        return int(re.search(r'VmRSS:\s+(\d+)', stream.read())[1]) / 1024


# Commands that all sources refuse, and a word of the message.
BAD_COMMANDS = [
    ({'command': 'dance'}, 'unknown command'),
    ({'command': 'step', 'ticks': 0}, 'ticks'),
    ({'command': 'step', 'ticks': 1.5}, 'ticks'),
    ({'command': 'step', 'ticks': True}, 'ticks'),
    ({'command': 'speed'}, 'factor: is missing'),
    ({'command': 'speed', 'factor': float('nan')}, 'factor'),
    ({'command': 'speed', 'factor': float('inf')}, 'factor'),
    ({'command': 'speed', 'factor': '1'}, 'factor'),
    ({'command': 'speed', 'factor': -1}, 'factor'),
    ({'command': 'play', 'now': 1}, 'unknown key'),
    ({'command': 'scenario', 'name': '../../etc/passwd'}, 'no scenario'),
    ({'command': 'scenario', 'name': ''}, 'name'),
    ({'command': 'add_wall', 'from': [0, 0], 'to': [1]}, 'to'),
    ({'command': 'remove_wall', 'wall': 10**30}, 'wall'),
    ({'command': 'add_agent', 'position': [0, 0], 'goal': [1, 10**400]}, 'goal'),
    ({'command': 'add_agent', 'position': [0, 0], 'goal': [1, 1], 'radius': 0}, 'radius'),
    ({'command': 'remove_agent', 'agent': 77}, '77'),
    ({'command': 'set_goal', 'agent': 0, 'goal': None}, 'goal'),
    ({'command': 'open_recording', 'name': '../circle6.yaml'}, 'no recording'),
    ({'command': 'select', 'agent': -1}, 'agent'),
]


class Frame:
    """A binary frame of the page's protocol: tick, time, and an array for each column."""

    def __init__(self, data):
        magic, self.tick, self.time, count, reserved = HEAD.unpack_from(data)
        assert (magic, reserved) == (0x57524331, 0)
        at = HEAD.size
        for name, dtype in COLUMNS:
            setattr(self, name, numpy.frombuffer(data, dtype, count, at))
            at += getattr(self, name).nbytes
        assert at == len(data)


class Page:
    """A page that is connected to a server: `async with Page(server) as page`."""

    def __init__(self, server, query='', **options):
        self.url, self.options = f'{server.url}/ws{query}', options

    async def __aenter__(self):
        self.session = aiohttp.ClientSession()
        try:
            self.socket = await self.session.ws_connect(self.url, max_msg_size=0, **self.options)
        except BaseException:
            await self.session.close()
            raise
        return self

    async def __aexit__(self, *_):
        await self.socket.close()
        await self.session.close()

    async def send(self, command, **keys):
        """Sends a command; keys of Python's words end with _."""
        await self.socket.send_str(json.dumps({'command': command, **{k.rstrip('_'): v for k, v in keys.items()}}))

    async def receive(self, fits):
        """Returns the next message (dict or Frame) that fits."""
        async def next_one():
            while True:
                message = await self.socket.receive()
                if message.type == aiohttp.WSMsgType.TEXT:
                    found = json.loads(message.data, parse_constant=lambda name: 1 / 0)  # not JSON
                elif message.type == aiohttp.WSMsgType.BINARY:
                    found = Frame(message.data)
                else:
                    is_close = message.type == aiohttp.WSMsgType.CLOSE
                    raise ConnectionError(f'closed: {message.data if is_close else self.socket.close_code}')
                if fits(found):
                    return found
        return await asyncio.wait_for(next_one(), PATIENCE)

    async def next(self, kind, fits=lambda message: True):
        """Returns the next text message of a type that fits."""
        return await self.receive(lambda message: isinstance(message, dict) and message['type'] == kind and
                                  fits(message))

    async def frame(self, fits=lambda frame: True):
        """Returns the next frame that fits."""
        return await self.receive(lambda message: isinstance(message, Frame) and fits(message))

    async def refusal(self, command, **keys):
        """Sends a command. Returns the message with which it is refused."""
        await self.send(command, **keys)
        error = await self.next('error')
        assert error['command'] == command
        return error['message']


def framed(data, operation, mask=b'\0\0\0\0'):
    """Returns a frame of a WebSocket with these bytes."""
    length = len(data)
    head = bytes([0x80 | operation, 0x80 | length]) if length < 126 else (
        struct.pack('!BBH', 0x80 | operation, 0x80 | 126, length) if length < 65536 else
        struct.pack('!BBQ', 0x80 | operation, 0x80 | 127, length))
    return head + mask + bytes(byte ^ mask[i % 4] for i, byte in enumerate(data)) if any(mask) else head + mask + data


class RawClient:
    """A connection after the handshake, through which any bytes are sent. What comes back is thrown away."""

    def __init__(self, server, path, protocol=None):
        self.socket = socket.create_connection(('127.0.0.1', server.port), PATIENCE)
        key = base64.b64encode(os.urandom(16)).decode()
        lines = [f'GET {path} HTTP/1.1', f'Host: 127.0.0.1:{server.port}', 'Upgrade: websocket', 'Connection: Upgrade',
                 f'Sec-WebSocket-Key: {key}', 'Sec-WebSocket-Version: 13']
        lines += [f'Sec-WebSocket-Protocol: {protocol}'] if protocol else []
        self.socket.sendall('\r\n'.join([*lines, '', '']).encode())
        assert b' 101 ' in self.socket.recv(65536).split(b'\r\n')[0]
        self.socket.setblocking(False)

    def send(self, data):
        """Sends bytes. Returns whether the connection is still open."""
        try:
            self.drain()
            self.socket.settimeout(PATIENCE)
            self.socket.sendall(data)
            self.socket.setblocking(False)
            return self.drain()
        except ConnectionError:
            return False

    def drain(self):
        """Throws away what has come. Returns whether the connection is still open."""
        try:
            while self.socket.recv(65536):
                pass
            return False
        except BlockingIOError:
            return True

    def close(self):
        self.socket.close()


def run(coroutine):
    """Runs a test that waits for messages."""
    return asyncio.run(asyncio.wait_for(coroutine, 4 * PATIENCE))
