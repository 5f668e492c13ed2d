"""Walks an episode for a film."""
import pathlib
import subprocess
import sys

from crowd_drawing.files import HOMES, find_scenario
from crowd_experiments.runs import RunError
from crowd_recordings.shown import read_shown


def table_for(scenario):
    """Returns the Q-table file that demo.launch uses for a scenario: `human` for places, else `anticipation`."""
    name = 'human' if pathlib.Path(scenario).stem.startswith('place_') else 'anticipation'
    files = [home / 'config' / 'q_tables' / f'{name}.txt' for home in HOMES]
    return next((file for file in files if file.is_file()), files[0])


def walk(scenario, evaluate, table, seed, folder):
    """Walks one episode with the program `evaluate`. Returns the scene as it was drawn, and the Tracks by agent.

    Raises RunError with the output of the program."""
    file = pathlib.Path(find_scenario(scenario)).resolve()
    print(f'film: walking {file.stem}', file=sys.stderr, flush=True)
    command = [evaluate, '--q-table', table, '--episodes', 1, '--seed', seed, '--trajectories', folder, '--scenes',
               folder, file]
    done = subprocess.run(list(map(str, command)), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if done.returncode != 0:
        raise RunError(done.stdout.decode(errors='replace').strip())
    scene, tracks, _ = read_shown(folder / f'{file.stem}.csv', folder / file.name)
    return scene, tracks
