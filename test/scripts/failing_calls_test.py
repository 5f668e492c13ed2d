"""Programs of which each call for files and each allocation fails once, and disks that lose power."""
import collections
import errno
import os
import shutil
from concurrent.futures import ThreadPoolExecutor

import pytest
from calls import contents, run, target_of
from learning_files import checksum_of, config_text
from programs import NEAREST_TABLE, assert_says, in_package, read_bytes, tools_folder

REASONS = (errno.EIO, errno.ENOSPC, errno.EDQUOT)
# Without these there is a result that is not complete, or may be lost: there is no success.
NEEDED = ('create', 'truncate', 'open', 'read', 'write', 'fsync', 'rename')
CRASHES = ('Traceback', 'terminate', 'Aborted')
SCENE = '''name: hall
duration: 4
map: hall.yaml
agents: [{position: [1, 2], goal: [3, 2], speed: 1, radius: 0.2}]
robots: [{name: tug, position: [3, 1], goal: [1, 1], radius: 0.2, max_speed: 1}]
'''
MAP = '{image: hall.pgm, resolution: 0.5, origin: [0, 0, 0], negate: 0, occupied_thresh: 0.65, free_thresh: 0.2}\n'
TRAINED = '''name: walk
duration: 4
goal_tolerance: 0.3
agents: [{position: [0, 0], goal: [2, 0], speed: 1, radius: 0.2}]
obstacles: [{position: [1, 0.1], radius: 0.2}]
'''
TRAIN = ['train', 'config.yaml', '--output', 'table', '--record', 'record', '--log', 'log', '--save-every', '2',
        '--checkpoint', 'checkpoint', '--checkpoint-interval', '0']
EVALUATE = ['evaluate', '--q-table', 'given', '--robot', 'reactive', 'hall.yaml', '--csv', 'csv', '--record', 'record',
            '--robots-csv', 'robots', '--robot-goals', 'goals', '--robot-log', 'jsonl', '--trajectories', 'paths',
            '--states', 'states', '--scenes', 'scenes', '--robot-series', 'series']
SCORE = ['score_robots', 'given.jsonl', '--csv', 'csv', '--goals', 'goals', '--series', 'series']
CONVERT = ['convert_trajectories', 'given.csv', '--output', 'converted.txt']


class Case:
    """A command in a folder with its inputs."""

    def __init__(self, runner, words, growing=()):
        self.runner = runner
        folder = in_package('scripts') if words[0] == 'convert_trajectories' else tools_folder()
        self.command = [os.path.join(folder, words[0]), *words[1:]]
        self.growing = growing
        self.first = runner.path('first')
        os.mkdir(self.first)
        self.before = self.after = self.versions = {}

    def write(self, name, content):
        """Writes an input, or what an output is before."""
        file = os.path.join(self.first, name)
        with open(file, 'wb') as stream:
            stream.write(content if isinstance(content, bytes) else content.encode())
        os.chmod(file, 0o640)

    def finish(self):
        """Runs the command without failures. Returns its Done."""
        self.before = contents(self.first)
        shutil.copytree(self.first, self.runner.path('before'))
        done = run(self.first, self.command)
        assert done.status == 0, done.output
        self.after = contents(self.first)
        self.versions = versions_of(done.calls)
        return done

    def fail(self, **failing):
        """Runs the command in a folder as it was before, and again without failures, and checks both. Returns the Done
        of the first run."""
        folder = self.runner.path('_'.join(map(str, failing.values())))
        shutil.copytree(self.runner.path('before'), folder)
        done = run(folder, self.command, **failing)
        failed = next((call for call in done.calls if call.other == 'FAILS'), None)
        self.where = f'{failing} {failed and failed[:2]}: {done.output}'
        files = contents(folder)
        if done.status == 0:
            assert files == self.after, self.where
            assert failed is None or failed.kind not in NEEDED or failing.get('error') == 0, self.where
        else:
            assert done.status == 1 and not any(word in done.output for word in CRASHES), self.where
            if failed:
                assert_says(done.output, os.strerror(failing['error']), os.path.basename(target_of(failed.path)))
        left = [name for name in files if name not in self.after and target_of(name) != name]
        assert not left or (failed and failed.kind == 'unlink'), f'{self.where} {left}'
        for name in set(files) - set(left):
            assert self.is_whole(name, files[name][0]), f'{self.where} {name}'
        resuming = [*(word for word in self.command if word != '--resume'), *['--resume'] * ('checkpoint' in files)]
        repeated = run(folder, resuming)
        assert (repeated.status, contents(folder)) == (0, self.after), f'{self.where} {repeated.output}'
        shutil.rmtree(folder)
        return done

    def is_whole(self, name, content):
        """Whether this is what a file was before, or a new version that is complete, as far as it is written at once."""
        old, new = (files.get(name, (b'', 0))[0] for files in (self.before, self.after))
        if content in (old, new, *self.versions.get(name, ())):
            return True
        if name in self.growing:
            return new.startswith(content)
        text, _, checksum = content.decode().partition('checksum: ')
        return checksum == f'{checksum_of(text)}\n'  # what was learned before the failure


def versions_of(calls):
    """Returns the contents by which a file was replaced, by its name."""
    written, versions = collections.defaultdict(bytes), collections.defaultdict(list)
    for call in calls:
        if call.kind == 'write':
            written[call.path] += call.data
        elif call.kind == 'rename':
            versions[call.other].append(written[call.path])
    return versions


@pytest.fixture
def train(runner):
    """A training that replaces another table."""
    case = Case(runner, TRAIN, ['record', 'log'])
    case.write('config.yaml', config_text('walk.yaml', 4))
    case.write('walk.yaml', TRAINED)
    case.write('table', read_bytes(NEAREST_TABLE))
    return case


@pytest.fixture
def resume(runner, train):
    """A training of which two of four episodes are done."""
    done = run(train.first, [*train.command, '--episodes', '2'])
    assert done.status == 0, done.output
    train.command.append('--resume')
    return train


class Calls:
    def test_it(self, train):
        done = train.finish()
        print(len(done.calls), done.allocations)
