"""Pictures of the page in a browser, which shows crowds of web_server."""
import contextlib
import pathlib
import shutil
import subprocess
import tempfile

import PIL.Image
from crowd_drawing.files import find_scenario
from crowd_experiments.runs import RunError, output_of
from crowd_experiments.tools import REPOSITORY
from crowd_launching.program import end_all

CLIENTS = REPOSITORY / 'test' / 'web'
SERVER = REPOSITORY / 'scripts' / 'web_server'
COLOURS, NO_DITHER = 255, 0
# Scenario, time of the picture [s], and what is evaluated in the page before.
PICTURES = {
    'web_6': ('circle6', 5, 'socialCrowd.select(1)'),
    'web_200': ('crowd_random_200', 8, 'null'),
    'web_1000': ('crowd_random_1000', 8, 'null'),
    'web_10000': ('crowd_random_10000', 8, 'null'),
}


def large_scenario(folder):
    """Writes crowd_random_1000 with ten times as many people on as much more room. Returns the file."""
    text = pathlib.Path(find_scenario('crowd_random_1000')).read_text(encoding='utf-8')
    file = folder / 'crowd_random_10000.yaml'
    file.write_text(text.replace('1000', '10000').replace('29', '92'), encoding='utf-8')
    return file


@contextlib.contextmanager
def served(scenario):
    """Serves a crowd without ROS. Its value is the address of the page."""
    server = subprocess.Popen([SERVER, scenario, '--port', '0'], stdout=subprocess.PIPE)
    try:
        line = server.stdout.readline().decode()
        if 'open ' not in line:
            raise RunError(f'web_server ended: {line}')
        yield line.partition('open ')[2].strip()
    finally:
        end_all([server], 30.0)


def take(clients, scenario, seconds, expression, file):
    """Takes a picture, of few colours, so that its file is small."""
    with served(scenario) as address:
        output_of(['node', 'page_picture.mjs', address, file.resolve(), seconds, expression], cwd=clients)
    with PIL.Image.open(file) as picture:
        few = picture.convert('RGB').quantize(COLOURS, dither=NO_DITHER)
    few.save(file, optimize=True)


def web(folder):
    """Takes pictures of crowds in a browser, with the packages of test/web. Yields their files."""
    if shutil.which('npm') is None:
        raise RunError('pictures of the page need the program npm')
    with tempfile.TemporaryDirectory(prefix='social_crowd_screenshots_') as work:
        clients = pathlib.Path(work) / 'web'
        shutil.copytree(CLIENTS, clients, ignore=shutil.ignore_patterns('node_modules'))
        output_of(['npm', 'ci', '--no-audit', '--no-fund'], cwd=clients)
        large = large_scenario(pathlib.Path(work))
        for name, (scenario, seconds, expression) in PICTURES.items():
            file = folder / f'{name}.png'
            take(clients, large if scenario == large.stem else scenario, seconds, expression, file)
            yield file
