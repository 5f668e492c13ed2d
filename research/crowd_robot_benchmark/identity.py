"""What determines a row of the results, mostly as digests: the program, the Q-table, the scene, the controller, its
keys, seed and episode. Rows with the same digest are the same, bit for bit, on all machines with the same libraries."""
import hashlib
import json
import typing

from crowd_experiments.runs import RunError, output_of
from crowd_experiments.scenario_files import files_behind

FORMAT = 4  # of the results file
DIGITS = 16  # of a digest
VERSION = ('package', 'sources', 'compiler')  # words of `evaluate --version`


class Identity(typing.NamedTuple):
    """The columns of a row before its results."""
    hash: str  # of all others
    package: str  # version
    program: str  # digest of the sources of `evaluate`, as it says itself
    compiler: str  # its version and flags, the same
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


def version_of(evaluate):
    """Returns what the program says of what it was made of: VERSION. Raises RunError."""
    words = dict(line.partition(' ')[::2] for line in output_of([evaluate, '--version']).splitlines())
    missing = [name for name in VERSION if not words.get(name)]
    if missing:
        raise RunError(f'{evaluate} --version: expected a line with {", ".join(missing)}')
    return [words[name] for name in VERSION]


def scene_digest(file):
    """Returns a digest of a scenario file and of the files behind it. It does not depend on the folders that they are
    in."""
    return digest_of(*(one.read_bytes() for one in (file, *files_behind(file))))


class Inputs:
    """The digests of what is here now, computed once."""

    def __init__(self, suite):
        self.version = version_of(suite.evaluate)
        self.q_table = digest_of(suite.q_table.read_bytes())
        self.scenes = {name: scene_digest(file) for name, file in suite.scenes.items()}

    def identity(self, name, baseline, scene, seed, episode):
        """Returns the identity of an episode of a robot, which has a name in tables."""
        keys = json.dumps(baseline.keys, sort_keys=True)
        return Identity('', *self.version, self.q_table, self.scenes[scene], name, baseline.controller, keys,
                        str(seed), str(episode), scene).with_hash()
