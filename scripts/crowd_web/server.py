"""The HTTP server: files of the page, and WebSockets of all protocols."""
import asyncio
import traceback

from aiohttp import web
from crowd_drawing.errors import InputError
from crowd_web.client import BROKEN, NOT_THE_PROTOCOL, Client
from crowd_web.page_commands import NotTheProtocol, arguments_of, message_of

MOST_CLIENTS = 32
MOST_BYTES = 64 * 1024  # of a message from a client
MOST_MESSAGES = 32  # from a client that wait
HEARTBEAT = 30.0  # [s] between two pings; a client that does not answer is gone


class PageSession:
    """A page at /ws."""

    def __init__(self, client, source):
        self.client, self.source = client, source

    async def begin(self):
        self.client.send(await self.source.hello())
        self.source.add(self.client)

    async def take(self, data):
        """Takes a message. Raises NotTheProtocol."""
        if not isinstance(data, str):
            raise NotTheProtocol('expected text')
        message, command = message_of(data, 'command')
        try:
            await self.source.run(self.client, command, arguments_of(command, message))
        except InputError as error:
            self.client.send({'type': 'error', 'command': command[:200], 'message': str(error)})

    def refuse(self, problem):
        """Says why the connection is closed."""
        self.client.send({'type': 'error', 'command': None, 'message': problem})

    def end(self):
        self.source.remove(self.client)


class Server:
    """Serves a folder, and a WebSocket for each protocol."""

    def __init__(self, folder, access):
        self.folder, self.access = folder, access
        self.sessions = {}  # function that makes a session of a client, by path and subprotocol
        self.clients = set()

    def add(self, path, make_session, protocol=None):
        """Serves WebSockets at a path, with a subprotocol or without one."""
        self.sessions[path, protocol] = make_session

    def application(self):
        """Returns the application of aiohttp."""
        application = web.Application(middlewares=[self.access.check], client_max_size=MOST_BYTES)
        for path in {path for path, _ in self.sessions} | {'/'}:
            application.router.add_get(path, self.answer)
        application.router.add_static('/', self.folder)
        application.on_shutdown.append(self.close_clients)
        return application

    async def answer(self, request):
        """Answers a request for a WebSocket, or for the page."""
        if request.headers.get('Upgrade', '').lower() == 'websocket':
            return await self.connect(request)
        if request.path == '/':
            return web.FileResponse(self.folder / 'index.html')
        raise web.HTTPUpgradeRequired(text='expected a WebSocket\n')

    async def connect(self, request):
        protocols = [name for path, name in self.sessions if path == request.path and name]
        offered = [name.strip() for name in request.headers.get('Sec-WebSocket-Protocol', '').split(',')]
        protocol = next((name for name in offered if name in protocols), None)
        if (request.path, protocol) not in self.sessions:
            raise web.HTTPBadRequest(text=f"expected one of the protocols {', '.join(protocols)}\n")
        if len(self.clients) >= MOST_CLIENTS:
            raise web.HTTPServiceUnavailable(text=f'there are {MOST_CLIENTS} clients already\n')
        socket = web.WebSocketResponse(protocols=protocols, max_msg_size=MOST_BYTES, heartbeat=HEARTBEAT,
                                       compress=False)
        client = Client(socket)
        self.clients.add(client)
        try:
            await socket.prepare(request)
            await self.serve(client, self.sessions[request.path, protocol](client))
        finally:
            self.clients.discard(client)
        return socket

    @staticmethod
    async def serve(client, session):
        """Talks to a client until one of both ends it."""
        arrived = asyncio.Queue(MOST_MESSAGES)
        writing, taking = map(asyncio.create_task, (client.write(), take_all(client, session, arrived)))
        try:
            async for message in client.socket:
                await arrived.put(message.data)
            if client.closing:
                await asyncio.wait([writing])  # until the client has heard why
        finally:
            session.end()
            writing.cancel()
            taking.cancel()
            await asyncio.gather(writing, taking, return_exceptions=True)

    async def close_clients(self, _):
        for client in list(self.clients):
            await client.socket.close(code=1001, message=b'the server ends')


async def take_all(client, session, arrived):
    """Gives the messages of a client to its session, one after the other."""
    try:
        await session.begin()
        while not client.closing:
            await session.take(await arrived.get())
    except NotTheProtocol as error:
        session.refuse(str(error))
        client.close(NOT_THE_PROTOCOL, 'not a message of the protocol')
    except Exception:
        traceback.print_exc()
        client.close(BROKEN, 'an error of the server')
