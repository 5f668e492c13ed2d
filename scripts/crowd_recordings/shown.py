"""Positions and headings of recorded people at any time, and the scene that they were recorded in."""

import typing

import numpy
from crowd_drawing.errors import InputError
from crowd_drawing.files import Scene, find_scenario, read_scene
from crowd_recordings.formats import read_recording

HEADING_SPAN = 0.3  # [s] of the motion that gives the heading; ticks alone are noisy
LEAST_MOTION = 0.02  # [m] within this span, below which the heading is unchanged


class Track(typing.NamedTuple):
    """The recorded positions of an agent."""
    times: numpy.ndarray  # [s] ascending
    places: numpy.ndarray  # [m] one row x, y for each time
    headings: numpy.ndarray  # [rad] for each time, continuous

    def is_present(self, time):
        """Returns whether the agent is in the world at a time [s]."""
        return self.times[0] <= time <= self.times[-1]

    def place_at(self, time):
        """Returns x, y [m] at a time [s], or at the first or last time of the track."""
        return [float(numpy.interp(time, self.times, self.places[:, axis])) for axis in (0, 1)]

    def heading_at(self, time):
        """Returns the heading at a time [rad]."""
        return float(numpy.interp(time, self.times, self.headings))

    def trail(self, time, duration, points):
        """Returns the path of the last seconds before a time as `points` places, oldest first [m]."""
        times = numpy.linspace(max(self.times[0], time - duration), time, points)
        return numpy.column_stack([numpy.interp(times, self.times, self.places[:, axis]) for axis in (0, 1)])


def track_of(walk, tick):
    """Returns the Track of a walk: a list of (tick, x, y) [m], with the duration of a tick [s]."""
    rows = numpy.array(walk, dtype=float)
    times = rows[:, 0] * tick
    return Track(times, rows[:, 1:], headings_of(times, rows[:, 1:]))


def headings_of(times, places):
    """Returns the direction of the recent motion at each time [rad]; where an agent stands, its last heading."""
    before = [numpy.interp(times - HEADING_SPAN, times, places[:, axis]) for axis in (0, 1)]
    motion = places - numpy.column_stack(before)
    moves = numpy.hypot(motion[:, 0], motion[:, 1]) >= LEAST_MOTION
    if not moves.any():
        return numpy.zeros(len(times))
    latest = numpy.maximum.accumulate(numpy.where(moves, numpy.arange(len(times)), -1))
    latest[latest < 0] = numpy.argmax(moves)  # before the first motion: its heading
    return numpy.unwrap(numpy.arctan2(motion[latest, 1], motion[latest, 0]))


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
