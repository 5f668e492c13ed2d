"""The page in web/, in Chromium without a display, against web_server, with ROS and without."""
import filecmp
import json
import os
import pathlib
import shutil
import subprocess

import pytest
from node_packages import find_chromium, install_clients
from programs import CIRCLE6, PATIENCE, in_package
from ros_crowds import Ros
from web_clients import start_server

CHECKS = ['ticks_move', 'pause_stops_them_and_step_makes_one', 'a_click_adds_a_person',
          'a_person_is_selected_gets_a_goal_and_is_removed', 'walls_and_obstacles', 'an_error_is_shown_and_goes_away',
          'the_recent_past', 'a_recording_is_scrubbed', 'keys_and_layers', 'another_scenario',
          'no_errors_in_the_console']
PAGE = pathlib.Path(in_package('web'))
BUILT = ['index.html', 'main.js', 'style.css', 'wasm_worker.js']


@pytest.fixture(scope='module')
def clients(tmp_path_factory):
    """A folder with the programs of test/web and their packages."""
    find_chromium()
    folder = tmp_path_factory.mktemp('clients')
    install_clients(folder)
    return folder


def check_page(clients, address):
    """Returns the result of each check of page_checks.mjs by its name."""
    done = subprocess.run(['node', 'page_checks.mjs', address], cwd=clients, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, timeout=20 * PATIENCE, check=False,
                          env={**os.environ, 'CHROMIUM': find_chromium()})
    assert done.returncode == 0, done.stderr.decode()
    return json.loads(done.stdout)


def test_without_ros(runner, clients):
    server = start_server(runner, CIRCLE6, '--page', PAGE / 'dist')
    assert check_page(clients, server.url) == dict.fromkeys(CHECKS, 'ok')


def test_with_ros(runner, clients):
    ros = Ros(runner)
    ros.start_crowd()
    server = start_server(runner, '--ros', '--page', PAGE / 'dist', environment=ros.environment)
    assert check_page(clients, server.url) == dict.fromkeys(CHECKS, 'ok')


def test_the_built_page_is_that_of_its_sources(tmp_path):
    """What ships is committed; the same sources give the same bytes."""
    if shutil.which('npm') is None:
        pytest.skip('npm is not installed')
    shutil.copytree(PAGE, tmp_path / 'web', ignore=shutil.ignore_patterns('node_modules', 'dist'))
    installed = subprocess.run(['npm', 'ci', '--no-audit', '--no-fund'], cwd=tmp_path / 'web', stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, timeout=5 * PATIENCE, check=False)
    if installed.returncode != 0:
        pytest.skip(f'npm cannot install the packages of web: {installed.stdout.decode()[-500:]}')
    for step in ('check', 'build'):
        done = subprocess.run(['npm', 'run', step], cwd=tmp_path / 'web', stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, timeout=5 * PATIENCE, check=False)
        assert done.returncode == 0, done.stdout.decode()
    made = tmp_path / 'web/dist'
    assert sorted(file.name for file in made.iterdir()) == BUILT
    for name in BUILT:
        assert filecmp.cmp(made / name, PAGE / 'dist' / name, shallow=False), name
