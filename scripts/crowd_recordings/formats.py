"""Recorded crowds, and the formats of their files, which are recognised by the first line: CSV of `evaluate`, logs of
robots among people, JuPedSim's text format (`id frame x y [z ...]`, with comments that begin with #, as PedPy reads
it), and obsmat.txt of the ETH and UCY data sets (`frame person x z y vx vz vy`, annotated every 0.4 s); positions and
headings at any time."""
import argparse
import collections
import dataclasses
import math
import re
import typing

import numpy
from crowd_drawing.errors import InputError, check_output, opened, replaced
from crowd_drawing.files import DEFAULT_TICK, HEADER, Scene, collect, find_scenario, numbers_of, read_scene, read_walks
from crowd_experiments.arguments import above_zero, add_file, parser_of, whole
from crowd_recordings.robot_log import RobotLog, read_robot_log

COLUMNS, PERIOD = 8, 0.4  # of obsmat.txt; [s] between two annotated frames
OBSMAT_COLUMNS = 'frame, person, x, z, y, vx, vz and vy'
RATE = re.compile(r'framerate\s*:?\s*([-+.\deE]+)')
CENTIMETRES = re.compile(r'[xX]/cm|in cm')
JUPEDSIM_COLUMNS = 'id, frame, x and y'
# Head and line of a file of one instance, as evaluate or JuPedSim write it, by its ending. The numbers are read as the
# same bits.
WRITTEN = {'.csv': (','.join(HEADER) + '\n', '0,{frame},{person},{x!r},{y!r}\n'),
           '.txt': ('# description: social_crowd trajectories\n# framerate: {rate}\n# id frame x/m y/m z/m\n',
                    '{person} {frame} {x!r} {y!r} 0\n')}
EXAMPLES = '''examples:
  convert_trajectories recordings/circle6.csv --output circle6.txt      for PedPy and JuPedSim
  convert_trajectories obsmat.txt --output people.csv                   for plot_paths; film needs --frame-rate 2.5

A CSV file has no frame rate: give it with --frame-rate, unless it is 10 Hz (a tick of 0.1 s).'''
HEADING_SPAN = 0.3  # [s] of the motion that gives the heading; ticks alone are noisy
LEAST_MOTION = 0.02  # [m] within this span, below which the heading is unchanged


@dataclasses.dataclass(frozen=True)
class Recording:
    """The positions of people. `walks`: lists of (frame, x, y) [m] by the number of the person, frames ascending;
    `frame_duration`: time between two frames [s], None if the file does not contain it; `log`: the log that it is of,
    if there are robots."""
    walks: dict
    frame_duration: float = None
    log: RobotLog = None

    def at_rate(self, frame_rate):
        """Returns the same recording with a frame rate [Hz] in place of that of the file, if it is not None."""
        return self if frame_rate is None else dataclasses.replace(self, frame_duration=1 / frame_rate)


def read_obsmat(file, stream):
    """Reads a file. Returns a Recording whose frames are the annotated ones, counted from 0. Raises InputError."""
    rows = []
    for line, text in enumerate(stream, 1):
        if text.strip():
            words = text.split() if len(text.split()) == COLUMNS else []
            frame, person, x, y = numbers_of(file, line, words, (0, 1, 2, 4), OBSMAT_COLUMNS)
            rows.append((line, person, frame, x, y))
    walks = collect(file, rows)
    frames = sorted({frame for walk in walks.values() for frame, _, _ in walk})
    step = max(1, int(numpy.gcd.reduce(numpy.diff(frames))))  # of which all are multiples, counted from the first one
    steps = collections.Counter(there[0] - here[0] for walk in walks.values() for here, there in zip(walk, walk[1:]))
    annotated = steps.most_common(1)[0][0] if steps else step  # frames between two rows of a person
    return Recording({person: [((frame - frames[0]) // step, x, y) for frame, x, y in walk]
                      for person, walk in walks.items()}, PERIOD / (annotated / step))


def read_jupedsim(file, stream):
    frame_duration, scale, rows = None, 1.0, []
    for line, text in enumerate(stream, 1):
        if text.startswith('#'):
            match = RATE.search(text)
            if match and frame_duration is None:
                try:
                    frame_duration = 1 / above_zero(match[1])
                except argparse.ArgumentTypeError:
                    raise InputError(f"{file}:{line}: expected a frame rate above 0, got '{match[1]}'") from None
            scale = 0.01 if CENTIMETRES.search(text) else scale
        elif text.strip():
            person, frame, x, y = numbers_of(file, line, text.split(), (0, 1, 2, 3), JUPEDSIM_COLUMNS)
            rows.append((line, person, frame, scale * x, scale * y))
    return Recording(collect(file, rows), frame_duration)


def read_recording(file, instance=None):
    """Reads a Recording. `instance`: which episode of a CSV file or a log; None: the first. Raises InputError,
    OSError."""
    with opened(file) as stream:
        first = next((line for line in stream if line.strip()), '').strip()
        stream.seek(0)
        if first.startswith(HEADER[0]):
            return Recording(read_walks(file, instance)[1])
        if first.startswith('{'):
            log = read_robot_log(file, instance)
            return Recording(log.walks, log.header['tick_duration'], log)
        if instance not in (None, 0):
            raise InputError(f'{file}: has no instance {instance}, expected 0')
        columns = len(first.split())
        if first.startswith('#') or columns in (4, 5):
            return read_jupedsim(file, stream)
        if columns == COLUMNS:
            return read_obsmat(file, stream)
    raise InputError(f"{file}:1: is not a recording; expected the header {','.join(HEADER)}, a log of robots "
                     '(lines of JSON), the text format of JuPedSim (comments with #, then id frame x y z), or the 8 '
                     'columns of obsmat.txt')


def write_recording(file, recording):
    """Writes a recording in the format of the file's ending; the file appears when it is complete. Raises OSError."""
    head, line = WRITTEN[file.suffix.lower()]
    with replaced(file) as part, open(part, 'w', encoding='utf-8') as stream:
        stream.write(head.format(rate=round(1 / recording.frame_duration, 9)))
        for frame, person, x, y in sorted((frame, person, x, y) for person, walk in recording.walks.items()
                                          for frame, x, y in walk):
            stream.write(line.format(frame=frame, person=person, x=x, y=y))


def main(words=None):
    parser = parser_of('convert_trajectories',
                       "Converts recorded trajectories: CSV files of `evaluate --trajectories`, "
                       "JuPedSim's text format, and obsmat.txt of the ETH and UCY data sets (input only).", EXAMPLES)
    parser.add_argument('input', metavar='IN', help='a recording; its format is recognised')
    add_file(parser, '--output', required=True, metavar='OUT', help="OUT.csv, or OUT.txt in JuPedSim's format")
    parser.add_argument('--instance', type=whole, metavar='N', help='episode of a CSV file (default: the first)')
    parser.add_argument('--frame-rate', type=above_zero, metavar='HZ',
                        help='frames in a second, in place of that of IN (CSV: 10; obsmat.txt: 2.5)')
    arguments = parser.parse_args(words)
    if arguments.output.suffix.lower() not in WRITTEN:
        parser.error(f"--output: expected a name with {' or '.join(WRITTEN)}, got '{arguments.output}'")
    check_output(arguments.output)
    recording = read_recording(arguments.input, arguments.instance).at_rate(arguments.frame_rate)
    if recording.frame_duration is None:
        recording = recording.at_rate(1 / DEFAULT_TICK)
    write_recording(arguments.output, recording)
    rows = sum(map(len, recording.walks.values()))
    people = '1 person' if len(recording.walks) == 1 else f'{len(recording.walks)} people'
    print(f'{arguments.output}: {people}, {rows} positions, {1 / recording.frame_duration:g} frames a second')
    if arguments.output.suffix.lower() == '.csv' and not math.isclose(recording.frame_duration, DEFAULT_TICK):
        print(f'A CSV file has no frame rate: give --frame-rate {1 / recording.frame_duration:g} to programs that read '
              'it.')


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
    times, places = rows[:, 0] * tick, rows[:, 1:]
    # The heading is the direction of the recent motion [rad]; where an agent stands, its last heading.
    before = [numpy.interp(times - HEADING_SPAN, times, places[:, axis]) for axis in (0, 1)]
    motion = places - numpy.column_stack(before)
    moves = numpy.hypot(motion[:, 0], motion[:, 1]) >= LEAST_MOTION
    if not moves.any():
        return Track(times, places, numpy.zeros(len(times)))
    latest = numpy.maximum.accumulate(numpy.where(moves, numpy.arange(len(times)), -1))
    latest[latest < 0] = numpy.argmax(moves)  # before the first motion: its heading
    return Track(times, places, numpy.unwrap(numpy.arctan2(motion[latest, 1], motion[latest, 0])))


def robot_track(way, tick):
    """Returns the Track of a robot of a log: a list of (tick, x, y, heading) [m, rad]."""
    rows = numpy.array(way)
    return Track(rows[:, 0] * tick, rows[:, 1:3], numpy.unwrap(rows[:, 3]))


def part_of(track, entry):
    """Returns the part of a Track that an entry of Scene.recorded uses, at the times of the episode; None: none."""
    begin = max(entry.get('from', 0), track.times[0])
    end = min(entry.get('to', math.inf), track.times[-1])
    if begin > end:
        return None
    times = numpy.unique([begin, *track.times[(track.times > begin) & (track.times < end)], end])
    places = [track.place_at(time) for time in times] + numpy.array(entry['shift'])
    headings = numpy.array([track.heading_at(time) for time in times])
    return Track(times - entry.get('from', 0) + entry.get('offset', 0), places, headings)


def recorded_people(scene):
    """Returns (person, Track, radius) of the recorded people of a Scene, as `evaluate` lets them walk. Raises
    InputError, OSError."""
    people = []
    for entry in scene.recorded:
        frame_rate = entry.get('frame_rate')
        recording = read_recording(entry['file'], entry['instance']).at_rate(frame_rate)
        for person, walk in recording.walks.items():
            if entry['people'] is None or person in entry['people']:
                part = part_of(track_of(walk, recording.frame_duration or scene.tick), entry)
                people += [] if part is None else [(person, part, entry['radius'])]
    return people


def read_shown(trajectories, scenario=None, instance=None, frame_rate=None):
    """Reads a recording, and the scenario of its instance, if one is given. Returns the Scene, the Tracks by person,
    and the time between two frames [s].

    This time is that of the frame rate [Hz], else of the file, else a tick of the scenario. If a file that is not of
    `evaluate` has other people than the agents of the scenario, walls, map, obstacles and gates remain of it. The
    robots of a log have a key `track` each. Raises InputError, OSError."""
    recording = read_recording(trajectories, instance)
    log, last = recording.log, max(recording.walks, default=-1)
    drawn = Scene(log.document() if log else {}, trajectories)
    scene = read_scene(find_scenario(scenario), instance or 0) if scenario else drawn
    if log:
        scene.radii = log.radii
        scene.robots = [dict(robot, track=robot_track(way, recording.frame_duration))
                        for robot, way in zip(drawn.robots, log.robots)]
    elif recording.frame_duration is not None and last >= len(scene.agents):
        scene.agents = []
    recording = recording.at_rate(frame_rate)
    if scenario and scene.agents and last >= len(scene.agents) and not scene.population.source_areas:
        raise InputError(f'{trajectories}: has an agent {last}, but {scene.place} has {len(scene.agents)} agents, '
                         'counted from 0')
    duration = recording.frame_duration or scene.tick
    return scene, {person: track_of(walk, duration) for person, walk in recording.walks.items()}, duration
