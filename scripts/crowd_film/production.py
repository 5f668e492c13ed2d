"""Walks an episode for a film, and makes the film from a scene and its tracks."""
import dataclasses
import math
import os
import pathlib
import subprocess
import sys

from crowd_drawing.errors import InputError
from crowd_drawing.files import HOMES, find_scenario
from crowd_experiments.runs import ProgressBar, RunError
from crowd_film.frames import FramePainter
from crowd_film.pictures import write_gif, write_mp4, write_webp
from crowd_film.stage import LEAST_WIDTH, Stage
from crowd_recordings.shown import read_shown
from matplotlib import pyplot


def table_for(scenario):
    """Returns the Q-table file that demo.launch uses for a scenario: `human` for places, else `anticipation`."""
    name = 'human' if pathlib.Path(scenario).stem.startswith('place_') else 'anticipation'
    files = [home / 'config' / 'q_tables' / f'{name}.txt' for home in HOMES]
    return next((file for file in files if file.is_file()), files[0])


def walk(scenario, evaluate, table, seed, folder):
    """Walks one episode with `evaluate`. Returns the scene as drawn, and the Tracks by agent. Raises RunError."""
    file = pathlib.Path(find_scenario(scenario)).resolve()
    print(f'film: walking {file.stem}', file=sys.stderr, flush=True)
    command = [evaluate, '--q-table', table, '--episodes', 1, '--seed', seed, '--trajectories', folder, '--scenes',
               folder, file]
    done = subprocess.run(list(map(str, command)), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if done.returncode != 0:
        raise RunError(done.stdout.decode(errors='replace').strip())
    scene, tracks, _ = read_shown(folder / f'{file.stem}.csv', folder / file.name)
    return scene, tracks


WRITERS = {'.gif': write_gif, '.webp': write_webp, '.mp4': write_mp4}
SAMPLES = 6  # frames that determine the palette of a GIF
MEGABYTE = 1e6
MOST_GIGABYTES = 1.5  # of all frames of a WebP film, which are kept until the last one is drawn
SAFETY = 0.97  # of the size at the next attempt
SHRINKAGE = 0.7  # of the logarithm of the sides for that of the bytes; 0.5 would be that of an area


@dataclasses.dataclass(frozen=True)
class Settings:
    """How a film is made."""
    output: pathlib.Path
    title: str
    start: float = 0.0  # [s] simulated time of the first frame
    duration: float = math.inf  # [s] simulated
    speed: float = 4.0  # simulated seconds in a second of the film
    fps: float = 20.0  # frames in a second of the film
    size: int = 800  # [pixels] longer side
    max_megabytes: float = math.inf  # of a GIF or WebP
    view: tuple = None  # x0, y0, x1, y1 of the part that is shown [m]; None: everything


def frame_duration(settings):
    """Returns the duration of a frame [ms]. In GIFs it is a multiple of 10."""
    unit = 10 if settings.output.suffix.lower() == '.gif' else 1
    return max(unit, unit * round(1000 / settings.fps / unit))


def frame_times(settings, tracks):
    """Returns the simulated times of the frames [s], up to the time at which the last agent leaves."""
    step = frame_duration(settings) / 1000 * settings.speed
    end = min(settings.start + settings.duration, max(track.times[-1] for track in tracks.values()))
    if end < settings.start:
        raise InputError(f'--start: the recording ends at {end:g} s, got {settings.start:g}')
    frames = int((end - settings.start) / step + 1e-9) + 1
    if frames < 2:
        raise InputError(f'--speed: the film would have one frame, as the recording ends at {end:g} s; got '
                         f'{settings.speed:g}')
    return [settings.start + i * step for i in range(frames)]


def make(settings, scene, tracks):
    """Makes a film, again and smaller if it is larger than `max_megabytes`. Returns width, height, number of frames."""
    times = frame_times(settings, tracks)
    part = settings.output.with_name(f'.{settings.output.name}.part')
    size = settings.size
    try:
        while True:
            width, height = shoot(part, dataclasses.replace(settings, size=size), scene, tracks, times)
            megabytes = part.stat().st_size / MEGABYTE
            if megabytes <= settings.max_megabytes:
                break
            size = int(SAFETY * size * (settings.max_megabytes / megabytes)**SHRINKAGE)
            if size < LEAST_WIDTH:
                raise InputError(f'the film has {megabytes:.1f} MB with {width} x {height} pixels, more than '
                                 f'{settings.max_megabytes:g} MB; give a shorter --duration, a lower --fps, a higher '
                                 '--speed, or .webp')
            print(f'film: {megabytes:.1f} MB are too large; once more with {size} pixels', file=sys.stderr, flush=True)
        os.replace(part, settings.output)
    finally:
        part.unlink(missing_ok=True)
    return width, height, len(times)


def shoot(file, settings, scene, tracks, times):
    """Writes a film to a file. Returns its width and height [pixels]."""
    stage = Stage(scene, tracks, settings.title, settings.size, settings.view)
    gigabytes = 3 * stage.width * stage.height * len(times) / 1e9
    if settings.output.suffix.lower() == '.webp' and gigabytes > MOST_GIGABYTES:
        raise InputError(f'a WebP film of {len(times)} frames with {stage.width} x {stage.height} pixels would need '
                         f'{gigabytes:.1f} GB of memory, more than {MOST_GIGABYTES:g}; expected .gif or .mp4, or a '
                         'shorter --duration')
    painter = FramePainter(stage, scene, tracks)
    samples = [painter.draw(time) for time in times[::max(1, len(times) // SAMPLES)]]
    bar = ProgressBar(len(times), len(times), 'frames')
    writer = WRITERS[settings.output.suffix.lower()]
    try:
        writer(file, with_progress((painter.draw(time) for time in times), bar), samples, frame_duration(settings))
    finally:
        bar.end()
        pyplot.close(stage.figure)
    return stage.width, stage.height


def with_progress(frames, bar):
    """Yields the frames and shows their number."""
    for frame in frames:
        yield frame
        bar.add(1)
