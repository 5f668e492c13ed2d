"""What a film shows: a scene and the walks of its people, recorded before or walked for the film."""
import pathlib
import subprocess
import sys

from crowd_drawing.files import HOMES, find_scenario, read_scene, read_walks
from crowd_experiments.runs import RunError
from crowd_film.errors import FilmError
from crowd_film.tracks import track_of


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
    return load(folder / file.name, folder / f'{file.stem}.csv', None)


def load(scenario, trajectories, instance):
    """Reads a recording. Returns the scene of its instance, and the Tracks by agent. Raises InputError, OSError."""
    instance, walks = read_walks(trajectories, instance)
    scene = read_scene(find_scenario(scenario), instance)
    if max(walks) >= len(scene.agents) and not scene.population.source_areas:
        raise FilmError(f'{trajectories}: instance {instance} has an agent {max(walks)}, but {scene.place} has '
                        f'{len(scene.agents)} agents, counted from 0')
    return scene, {agent: track_of(walk, scene.tick) for agent, walk in sorted(walks.items())}
