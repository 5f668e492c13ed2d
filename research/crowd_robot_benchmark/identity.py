"""What determines a row of the results, as digests: the program, the Q-table, the scene, the controller, its keys, seed
and episode. Rows with the same digest are the same, bit for bit, on every machine."""
import hashlib
import json
import math
import re
import typing

from crowd_drawing.errors import InputError, read_documents
from crowd_experiments.tools import REPOSITORY

from .suite import files_named_in

FORMAT = 1  # of the results file
DIGITS = 16  # of a digest
# Sources of `evaluate`, which decide what an episode is; tests, nodes and messages do not.
SOURCES = ('CMakeLists.txt', 'include', 'src')
OTHER_SOURCES = ('nodes', 'ros', 'rviz', 'tools')  # folders of src/
SAMPLES, SPACING = 5000, 0.0007391  # arguments of functions
KINDS = 'kinds.yaml'  # kinds of people that scenes name


class Identity(typing.NamedTuple):
    """The columns of a row before its results."""
    hash: str  # of all others
    package: str  # version
    program: str  # digest of its sources
    math: str  # digest of what the functions of the C library give on this processor
    q_table: str
    scene: str  # digest of the scenario and all files that it names
    baseline: str  # name of the robot in tables
    controller: str  # of `evaluate --robot`
    keys: str  # JSON, of the robots
    seed: str
    episode: str
    scenario: str

    def computed_hash(self):
        return digest_of(json.dumps([FORMAT, *self[1:6], *self[7:]]).encode())

    def with_hash(self):
        return self._replace(hash=self.computed_hash())


def digest_of(*parts):
    """Returns a digest of byte strings, of which each counts with its length."""
    digest = hashlib.sha256()
    for part in parts:
        digest.update(len(part).to_bytes(8, 'big') + part)
    return digest.hexdigest()[:DIGITS]


def package_version():
    text = (REPOSITORY / 'package.xml').read_text(encoding='utf-8')
    return re.search(r'<version>(.*?)</version>', text)[1]


def program_digest():
    """Returns a digest of the names and contents of the sources."""
    files = []
    for name in SOURCES:
        path = REPOSITORY / name
        files += [path] if path.is_file() else [file for file in path.rglob('*') if file.is_file()]
    names = sorted((file.relative_to(REPOSITORY).as_posix(), file) for file in files if is_source(file))
    return digest_of(*(part for name, file in names for part in (name.encode(), file.read_bytes())))


def math_digest():
    """Returns a digest of values of functions of the C library, which has other code for processors without fused
    operations; it may differ in the last bit."""
    values = []
    for i in range(-SAMPLES, SAMPLES):
        x = i * SPACING
        values += [math.sin(x), math.cos(x), math.tan(x), math.exp(x), math.log(abs(x) + SPACING), math.atan2(x, x - 1),
                   abs(x)**SPACING, math.hypot(x, 1)]
    return digest_of(*(value.hex().encode() for value in values))


def is_source(file):
    parts = file.relative_to(REPOSITORY).parts
    return not (parts[0] == 'src' and parts[1] in OTHER_SOURCES) and file.suffix in ('.h', '.cpp', '.txt')


def scene_digest(file):
    """Returns a digest of a scenario file, of the files that it names, and of the kinds of people of the package. It
    does not depend on the folders that they are in."""
    document, = read_documents(file)
    named = [file.parent / entry[key] for entry, key in files_named_in(document)]
    if 'map' in document:
        described, = read_documents(file.parent / document['map'])
        named.append((file.parent / document['map']).parent / described['image'])
    kinds = next((folder / KINDS for folder in file.resolve().parents if (folder / KINDS).is_file()), None)
    if kinds is None:
        raise InputError(f'{file}: found no {KINDS} in the folders above it')
    return digest_of(*(one.read_bytes() for one in (file, *named, kinds)))


class Inputs:
    """The digests of what is here now, computed once."""

    def __init__(self, suite):
        self.package, self.program, self.math = package_version(), program_digest(), math_digest()
        self.q_table = digest_of(suite.q_table.read_bytes())
        self.scenes = {name: scene_digest(file) for name, file in suite.scenes.items()}

    def identity(self, name, baseline, scene, seed, episode):
        """Returns the identity of an episode of a robot, which has a name in tables."""
        keys = json.dumps(baseline.keys, sort_keys=True)
        return Identity('', self.package, self.program, self.math, self.q_table, self.scenes[scene], name,
                        baseline.controller, keys, str(seed), str(episode), scene).with_hash()
