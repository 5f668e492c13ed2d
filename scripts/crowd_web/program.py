"""The program `web_server`: shows a crowd in a browser."""
import asyncio
import pathlib
import signal
import socket
import sys

from aiohttp import web
from crowd_drawing.errors import InputError
from crowd_drawing.files import find_scenario
from crowd_experiments.arguments import add_file, number_type, parser_of, whole
from crowd_experiments.tools import REPOSITORY
from crowd_web.access import Access, is_loopback, make_token
from crowd_web.server import PageSession, Server

PORT = 8080
PATIENCE = 2.0  # [s] with clients when the server ends
EXAMPLES = '''examples:
  web_server place_office                        without ROS; then open http://localhost:8080/
  web_server --ros                               a crowd that walks in ROS, as roslaunch social_crowd web.launch does
  web_server circle12 --host 0.0.0.0             for other machines: needs the token that it prints

With --ros it also speaks the protocols of Foxglove (at /) and rosbridge (at /rosbridge): docs/web.md.'''
port = number_type(int, lambda number: 0 <= number < 65536, 'a port from 0 to 65535')


def find_page():
    """Returns the folder of the page, in a clone or an installed package. Raises InputError."""
    folders = (REPOSITORY / 'web' / 'dist', REPOSITORY.parent / 'share' / 'social_crowd' / 'web' / 'dist')
    for folder in folders:
        if (folder / 'index.html').is_file():
            return folder
    raise InputError(f'{folders[0]}: has no page (index.html)')


def url_of(host, number, token):
    """Returns the address of the page for a browser."""
    if host in ('', '0.0.0.0', '::'):
        host = socket.gethostname()
    host = f'[{host}]' if ':' in host else host
    return f'http://{host}:{number}/' + ('' if token is None else f'?token={token}')


def report(_, context):
    """Says what went wrong outside of all sessions; rospy hides the log of asyncio."""
    print('web_server:', context['message'], repr(context.get('exception', '')), file=sys.stderr, flush=True)


async def serve(server, arguments, token, task):
    """Serves until SIGINT or SIGTERM, or until the task of the back end ends."""
    loop = asyncio.get_running_loop()
    loop.set_exception_handler(report)
    ended = asyncio.Event()
    for number in (signal.SIGINT, signal.SIGTERM):
        loop.add_signal_handler(number, ended.set)
    runner = web.AppRunner(server.application(), access_log=None)
    await runner.setup()
    tasks = [asyncio.ensure_future(awaited) for awaited in (task, ended.wait())]
    try:
        # A name of this machine may stand for several addresses, and a free port would be another one at each.
        host = '127.0.0.1' if arguments.host == 'localhost' else arguments.host
        site = web.TCPSite(runner, host, arguments.port, shutdown_timeout=PATIENCE)
        try:
            await site.start()
        except OSError as error:
            raise InputError(f'port {arguments.port} of {arguments.host}: {error.strerror or error}') from None
        number = runner.addresses[0][1]
        print(f'web_server: open {url_of(arguments.host, number, token)}', flush=True)
        done, _ = await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
        for task in done:
            task.result()
    finally:
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)
        await runner.cleanup()


async def run(arguments):
    """Makes the back end and serves it."""
    token = arguments.token
    if token is None and not is_loopback(arguments.host):
        token = make_token()
    if not arguments.ros:
        from crowd_web.python_source import PythonSource  # needs the C++ module
        source = PythonSource(str(find_scenario(arguments.scenario)), arguments.q_table, arguments.seed,
                              arguments.threads, arguments.recordings)
        await source.show_scene()
    server = Server(arguments.page or find_page(), Access(token, arguments.allow_origin))
    if arguments.ros:
        from crowd_web.ros_server import add_ros  # needs ROS
        source, task = await add_ros(server, arguments.recordings)
    else:
        task = source.run_forever()
    server.add('/ws', lambda client: PageSession(client, source))
    await serve(server, arguments, token, task)


def main():
    parser = parser_of('web_server', 'Shows a crowd in a browser.', EXAMPLES)
    add = parser.add_argument
    add('scenario', nargs='?', metavar='SCENARIO', help='a scenario file, or a name in config/scenarios; without ROS')
    add('--ros', action='store_true', help='show the crowd of the crowd_controller that runs in this ROS')
    add('--q-table', metavar='TABLE', help='Q-table file, or name (default: human for scenarios place_*, else '
        'anticipation)')
    add('--seed', type=whole, default=1, metavar='N', help='seed of the episodes (default: 1)')
    add('--threads', type=whole, default=1, metavar='N', help='that walk a large crowd; 0: one per processor '
        '(default: 1)')
    add_file(parser, '--recordings', metavar='FOLDER', help='recordings that pages may open')
    add('--host', default='localhost', metavar='HOST', help='address or name on which it listens; for any other than '
        'localhost clients need a token (default: localhost)')
    add('--port', type=port, default=PORT, metavar='N', help='0: a free one (default: %(default)d)')
    add('--token', metavar='TEXT', help='that clients must give (default: none on localhost, else a random one)')
    add('--allow-origin', action='append', default=[], metavar='ORIGIN', help='of pages of other servers that may '
        'connect, such as https://app.foxglove.dev; may be repeated')
    add_file(parser, '--page', metavar='FOLDER', help='serve these files in place of the page of the package')
    arguments = parser.parse_args([word for word in sys.argv[1:] if ':=' not in word])  # those are for rospy
    if arguments.ros == bool(arguments.scenario):
        parser.error('expected either a SCENARIO or --ros')
    if arguments.token is not None and len(arguments.token) < 8:
        parser.error('--token: expected at least 8 characters')
    for folder in (arguments.recordings, arguments.page):
        if folder is not None and not pathlib.Path(folder).is_dir():
            parser.error(f'{folder}: is not a folder')
    asyncio.run(run(arguments))
