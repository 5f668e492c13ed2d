"""The program `export`: walks an episode or reads a recording, lets figures walk it, and writes their motion."""
import numpy
from crowd_drawing.errors import InputError, check_output, replaced
from crowd_experiments.arguments import add_file, at_least_zero, number_type, parser_of
from crowd_experiments.runs import ProgressBar
from crowd_recordings.formats import recorded_people
from crowd_recordings.source import add_source, check_source, read_source

from . import bvh, table
from .figures import Figures
from .gltf import Document
from .people import person_of
from .scenery import Scenery

LEAST_FRAMES, MOST_FRAMES = 2, 5_000_000  # of a person; of all, in 5 GB of memory
FARTHEST = 1e5  # [m]: places in glTF are 32-bit floats
rate = number_type(float, lambda number: 10 <= number <= 240, 'a number from 10 to 240')
EXAMPLES = '''Metres. glTF and BVH: y up; x, y of the map are x, -z. CSV: as the map, z up. docs/export.md has more.

examples:
  export place_corner --duration 20 --gltf corner.glb
  export place_station --start 20 --duration 60 --gltf station.glb --bvh people --csv people.csv
  export --trajectories obsmat.txt --duration 60 --gltf street.glb
  blender --python-expr "import bpy; bpy.ops.import_scene.gltf(filepath='corner.glb', import_shading='SMOOTH')"'''


def people_of(scene, tracks, start, duration, fps):
    """Returns the Persons who are there for some frames from a time on, and the times of all frames [s]."""
    everybody = [(f'person_{number}', number, track, scene.figure_of(number), False)
                 for number, track in tracks.items()]
    everybody += [(f'recorded_{number}', number, track, 'adult', True) for number, track, _ in recorded_people(scene)]
    ends = [track.times[-1] for _, _, track, *_ in everybody]
    ends += [robot['track'].times[-1] for robot in scene.robots if 'track' in robot]
    last = int(numpy.floor((min(start + duration, max(ends)) - start) * fps + 1e-6))
    if last < 1:
        raise InputError(f'--start: the recording ends at {max(ends):g} s, expected a time before, got {start:g}')
    if last * len(everybody) > MOST_FRAMES:
        raise InputError(f'{last} frames of {len(everybody)} people are too many, expected at most {MOST_FRAMES} in '
                         'all; give a shorter --duration, or a lower --fps')
    people, bar = [], ProgressBar(len(everybody), len(everybody), 'people')
    for name, number, track, figure, recorded in everybody:
        if numpy.abs(track.places).max() > FARTHEST:
            raise InputError(f'{name} is farther than {FARTHEST:g} m from the origin of the map')
        track = track._replace(times=track.times - start)
        first = max(0, int(numpy.ceil(track.times[0] * fps - 1e-6)))
        end = min(last, int(numpy.floor(track.times[-1] * fps + 1e-6)))
        if end - first + 1 >= LEAST_FRAMES:
            people.append(person_of(name, number, track, figure, recorded, numpy.arange(first, end + 1) / fps))
        bar.add(1)
    bar.end()
    if not people and not scene.robots:
        raise InputError(f'nobody is there for {LEAST_FRAMES} frames from {start:g} s on')
    return people, numpy.arange(last + 1) / fps


def write_gltf(file, scene, people, times, start, wall_height):
    """Writes a scene with its people. Returns the size of the file [bytes]."""
    document = Document('social_crowd')
    Scenery(document, times, wall_height).add(scene, people, start)
    figures = Figures(document, times[-1])
    for person in people:
        figures.add(person)
    with replaced(file) as part:
        return document.write(part)


def produce(arguments):
    """Reads or walks the episode, and writes what was asked for."""
    for file in filter(None, (arguments.gltf, arguments.csv)):
        check_output(file)
    if arguments.bvh:
        check_output(arguments.bvh / 'person_0.bvh' if arguments.bvh.is_dir() else arguments.bvh)
    scene, tracks = read_source(arguments, 'export')
    people, times = people_of(scene, tracks, arguments.start, arguments.duration, arguments.fps)
    print(f'{len(people)} people, {times[-1]:g} s, {arguments.fps:g} frames a second')
    if arguments.gltf:
        size = write_gltf(arguments.gltf, scene, people, times, arguments.start, arguments.wall_height)
        print(f'{arguments.gltf}: {size / 1e6:.2f} MB')
    if arguments.csv:
        with replaced(arguments.csv) as part:
            print(f'{arguments.csv}: {table.write(part, people)} rows')
    if arguments.bvh:
        arguments.bvh.mkdir(exist_ok=True)
        for person in people:
            with replaced(arguments.bvh / f'{person.name}.bvh') as part:
                bvh.write(part, person, arguments.fps)
        print(f'{arguments.bvh}: {len(people)} files')


def main(words=None):
    parser = parser_of('export', 'Exports a run as people who walk: glTF for Blender, game engines and web pages, BVH\n'
                       'for each person, and CSV. Needs neither a display nor ROS running.', EXAMPLES)
    add_source(parser)
    add_file(parser, '--gltf', help='FILE.glb: glTF 2.0 with people, walls, floor, obstacles and robots')
    add_file(parser, '--bvh', metavar='FOLDER', help='folder of a file PERSON.bvh for each person')
    add_file(parser, '--csv', help='FILE.csv: place, heading and feet of each person in each frame')
    parser.add_argument('--fps', type=rate, default=30.0, metavar='N',
                        help='frames in a second; glTF leaves out those that are not needed (default: %(default)g)')
    parser.add_argument('--wall-height', type=at_least_zero, default=1.0, metavar='M',
                        help='of walls [m] (default: %(default)g: one sees over them)')
    arguments = parser.parse_args(words)
    check_source(parser, arguments)
    if not (arguments.gltf or arguments.bvh or arguments.csv):
        parser.error('expected --gltf, --bvh or --csv')
    for name, file, ending in (('--gltf', arguments.gltf, '.glb'), ('--csv', arguments.csv, '.csv')):
        if file and file.suffix.lower() != ending:
            parser.error(f"{name}: expected a name with {ending}, got '{file}'")
    try:
        produce(arguments)
    except KeyboardInterrupt:
        raise KeyboardInterrupt(', files that were not complete are missing') from None
