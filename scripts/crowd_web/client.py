"""A connected client, to which messages are sent without waiting."""
import asyncio
import itertools
import json

WAITING_BYTES = 32 * 2**20  # that may wait for a client; one that has more to take is closed
TOO_SLOW, NOT_THE_PROTOCOL, BROKEN = 1013, 1008, 1011  # codes with which connections are closed


def as_json(message):
    """Returns a message as text. Raises ValueError for numbers that JSON does not have."""
    return json.dumps(message, allow_nan=False, separators=(',', ':'))


class Client:
    """Sends to one WebSocket. Messages of a stream that the client is too slow for are dropped, others never."""

    def __init__(self, socket):
        self.socket = socket
        self.waiting = {}  # messages by key, oldest first
        self.size = 0  # of these [bytes]
        self.numbers = itertools.count()
        self.arrived = asyncio.Event()
        self.closing = None  # code and reason, once it is to be closed

    def send(self, message):
        """Sends a dict as JSON."""
        self.send_data(as_json(message))

    def send_data(self, data):
        """Sends text or bytes."""
        self.put(next(self.numbers), data)

    def send_latest(self, stream, data, depth=1):
        """Sends a message of a stream, of which only the latest `depth` wait for a slow client."""
        if self.size + len(data) <= WAITING_BYTES:
            self.put((stream, next(self.numbers) if depth > 1 else 0), data)
            of_stream = [key for key in self.waiting if isinstance(key, tuple) and key[0] == stream]
            for key in of_stream[:-depth]:
                self.size -= len(self.waiting.pop(key))

    def forget(self, stream):
        """Drops what waits of a stream."""
        for key in [key for key in self.waiting if isinstance(key, tuple) and key[0] == stream]:
            self.size -= len(self.waiting.pop(key))

    def put(self, key, data):
        if self.closing:
            return
        self.size += len(data) - len(self.waiting.pop(key, ''))
        self.waiting[key] = data
        if self.size > WAITING_BYTES:
            self.close(TOO_SLOW, 'too slow')
        self.arrived.set()

    def close(self, code, reason):
        """Closes the connection, after what waits has been sent unless it is too slow."""
        self.closing = self.closing or (code, reason)
        if code == TOO_SLOW:
            self.waiting.clear()
        self.arrived.set()

    async def write(self):
        """Sends what waits until the connection is closed."""
        while not self.socket.closed:
            while self.waiting:
                data = self.waiting.pop(next(iter(self.waiting)))
                self.size -= len(data)
                await (self.socket.send_str if isinstance(data, str) else self.socket.send_bytes)(data)
            if self.closing:
                await self.socket.close(code=self.closing[0], message=self.closing[1].encode())
                return
            self.arrived.clear()
            await self.arrived.wait()
