"""The program `film`: walks an episode, and makes the film from a scene and its tracks."""
import dataclasses
import math
import pathlib
import sys

from crowd_drawing.errors import InputError, check_output, replaced
from crowd_experiments.arguments import above_zero, add_file, parser_of, pixels
from crowd_experiments.runs import ProgressBar
from crowd_film.pictures import need_ffmpeg, write_gif, write_mp4, write_webp
from crowd_film.stage import FramePainter, LEAST_WIDTH, Stage
from crowd_recordings.source import add_source, check_source, read_source
from matplotlib import pyplot

WRITERS = {'.gif': write_gif, '.webp': write_webp, '.mp4': write_mp4}
SAMPLES = 6  # frames that determine the palette of a GIF
MEGABYTE = 1e6
MOST_GIGABYTES = 1.5  # of all frames of a WebP film, which are kept until the last one is drawn
SAFETY = 0.97  # of the size at the next attempt
SHRINKAGE = 0.7  # of the logarithm of the sides for that of the bytes; 0.5 would be that of an area
EXAMPLES = '''examples:
  film place_station --start 20 --duration 40 --output station.gif
  film place_office --speed 8 --max-size 3 --output office.webp
  film circle6 --trajectories recordings/circle6.csv --output circle6.mp4
  film --trajectories obsmat.txt --duration 60 --output people.gif
  film robot_door --robot learned --output robot.webp

One episode is walked with `evaluate`, or a recording of `evaluate --trajectories` is shown. MP4 needs ffmpeg.
Recordings of robots are those of `evaluate --robot-log`.'''


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


def frame_times(settings, tracks, robots=()):
    """Returns the simulated times of the frames [s], up to the end of the last Track."""
    step = frame_duration(settings) / 1000 * settings.speed
    end = min(settings.start + settings.duration, max(track.times[-1] for track in [*tracks.values(), *robots]))
    if end < settings.start:
        raise InputError(f'--start: the recording ends at {end:g} s, got {settings.start:g}')
    frames = int((end - settings.start) / step + 1e-9) + 1
    if frames < 2:
        raise InputError(f'--speed: the film would have one frame, as the recording ends at {end:g} s; got '
                         f'{settings.speed:g}')
    return [settings.start + i * step for i in range(frames)]


def make(settings, scene, tracks):
    """Makes a film, again and smaller if it is larger than `max_megabytes`. Returns width, height, number of frames."""
    times = frame_times(settings, tracks, [robot['track'] for robot in scene.robots if 'track' in robot])
    size = settings.size
    with replaced(settings.output) as part:
        while True:
            width, height = shoot(part, dataclasses.replace(settings, size=size), scene, tracks, times)
            megabytes = part.stat().st_size / MEGABYTE
            if megabytes <= settings.max_megabytes:
                return width, height, len(times)
            size = int(SAFETY * size * (settings.max_megabytes / megabytes)**SHRINKAGE)
            if size < LEAST_WIDTH:
                raise InputError(f'the film has {megabytes:.1f} MB with {width} x {height} pixels, more than '
                                 f'{settings.max_megabytes:g} MB; give a shorter --duration, a lower --fps, a higher '
                                 '--speed, or .webp')
            print(f'film: {megabytes:.1f} MB are too large; once more with {size} pixels', file=sys.stderr, flush=True)


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

    def frames():
        for time in times:
            yield painter.draw(time)
            bar.add(1)
    try:
        WRITERS[settings.output.suffix.lower()](file, frames(), samples, frame_duration(settings))
    finally:
        bar.end()
        pyplot.close(stage.figure)
    return stage.width, stage.height


def produce(arguments):
    """Reads or walks the episode, and makes the film."""
    check_output(arguments.output)
    if arguments.output.suffix.lower() == '.mp4':
        need_ffmpeg()
    scene, tracks = read_source(arguments, 'film')
    title = (scene.name or arguments.trajectories.stem) if arguments.title is None else arguments.title
    settings = Settings(arguments.output, title, arguments.start, arguments.duration, arguments.speed, arguments.fps,
                        arguments.size, arguments.max_size, arguments.view)
    width, height, frames = make(settings, scene, tracks)
    megabytes = arguments.output.stat().st_size / MEGABYTE
    print(f'{arguments.output}: {frames} frames of {width} x {height} pixels, {megabytes:.2f} MB')


def main(words=None):
    parser = parser_of('film', 'Makes a film of a scenario: GIF, WebP or MP4. Needs neither a display nor ROS running.',
                       EXAMPLES)
    add = parser.add_argument
    add_source(parser)
    add_file(parser, '--output', required=True, help='FILE.gif, FILE.webp or FILE.mp4')
    add('--speed', type=above_zero, default=Settings.speed, metavar='X',
        help='simulated seconds in a second of the film (default: %(default)g)')
    add('--fps', type=above_zero, default=Settings.fps, metavar='N',
        help='frames in a second of the film (default: %(default)g); a GIF has at most 100')
    add('--size', type=pixels, default=Settings.size, metavar='N', help='longer side [pixels] (default: %(default)d)')
    add('--view', type=float, nargs=4, metavar=('X0', 'Y0', 'X1', 'Y1'), help='part of the scene that is shown [m]')
    add('--max-size', type=above_zero, default=float('inf'), metavar='MB',
        help='greatest size of the file [MB]; a larger film is made again with fewer pixels')
    add('--title', help="title of the film (default: the scenario's name)")
    arguments = parser.parse_args(words)
    if arguments.view and not (arguments.view[0] < arguments.view[2] and arguments.view[1] < arguments.view[3]):
        parser.error('--view: expected X0 < X1 and Y0 < Y1')
    if arguments.output.suffix.lower() not in WRITERS:
        parser.error(f"--output: expected a name with {', '.join(WRITERS)}, got '{arguments.output}'")
    check_source(parser, arguments)
    try:
        produce(arguments)
    except KeyboardInterrupt:
        raise KeyboardInterrupt(', nothing was written') from None
