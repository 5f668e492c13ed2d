"""A recording together with the scene that it was made in."""
from crowd_drawing.errors import InputError
from crowd_drawing.files import Scene, find_scenario, read_scene
from crowd_recordings.formats import read_recording
from crowd_recordings.tracks import track_of


def read_shown(trajectories, scenario=None, instance=None, frame_rate=None):
    """Reads a recording, and the scenario of its instance, if one is given. Returns the Scene, the Tracks by person,
    and the time between two frames [s].

    This time is that of the frame rate [Hz], else of the file, else a tick of the scenario. If a file that is not of
    `evaluate` has other people than the agents of the scenario, walls, map, obstacles and gates remain of it. Raises
    InputError, OSError."""
    recording = read_recording(trajectories, instance)
    scene = read_scene(find_scenario(scenario), instance or 0) if scenario else Scene({}, trajectories)
    last = max(recording.walks)
    if recording.frame_duration is not None and last >= len(scene.agents):
        scene.agents = []
    recording = recording.at_rate(frame_rate)
    if scenario and scene.agents and last >= len(scene.agents) and not scene.population.source_areas:
        raise InputError(f'{trajectories}: has an agent {last}, but {scene.place} has {len(scene.agents)} agents, '
                         'counted from 0')
    duration = recording.frame_duration or scene.tick
    return scene, {person: track_of(walk, duration) for person, walk in recording.walks.items()}, duration
