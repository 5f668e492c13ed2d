"""Programs of which each call for files and each allocation fails once, and disks that lose power."""
import collections
import errno
import os
import re
import shutil
from concurrent.futures import ThreadPoolExecutor

import pytest
from calls import contents, run, target_of
from learning_files import checksum_of, config_text
from power_loss import states_after
from programs import NEAREST_TABLE, in_package, read_bytes, tools_folder

REASONS = (errno.EIO, errno.ENOSPC, errno.EDQUOT)
# Without these there is a result that is not complete, or may be lost: there is no success.
NEEDED = ('create', 'truncate', 'open', 'read', 'write', 'fsync', 'rename')
ALLOCATIONS = 30  # that fail in a test, one in each run
RESUMED = 15  # states of a disk from which a training goes on
CRASHES = ('Traceback', 'terminate', 'Aborted')
SCENE = '''name: hall
duration: 4
goal_tolerance: 0.3
map: map.yaml
agents: [{position: [1, 2], goal: [3, 2], speed: 1, radius: 0.2}]
robots: [{name: tug, position: [3, 1], goal: [1, 1], radius: 0.2, max_speed: 1}]
'''
MAP = '{image: map.pgm, resolution: 0.5, origin: [0, 0, 0], negate: 0, occupied_thresh: 0.65, free_thresh: 0.2}\n'
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
LOG = '''{"tick_duration": 0.1, "robots": [{"radius": 0.2}]}
{"tick": 0, "robots": [{"x": 0, "y": 0, "heading": 0}], "people": [{"id": 1, "x": 2, "y": 0, "radius": 0.2}]}
{"tick": 1, "robots": [{"x": 0.1, "y": 0, "heading": 0}], "people": [{"id": 1, "x": 1.9, "y": 0}]}
'''
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
        """Runs the command in a folder as it was before, and again if it was not done, and checks both."""
        folder = self.runner.path('_'.join(map(str, failing.values())))
        shutil.copytree(self.runner.path('before'), folder)
        done = run(folder, self.command, **failing)
        failed = next((call for call in done.calls if call.other == 'FAILS'), None)
        where = f'{done.status} {failing} {failed and failed[:2]}: {done.output}'
        files = contents(folder)
        left = [name for name in files if name not in self.after and target_of(name) != name]
        may_stay = failed and (failed.kind == 'unlink' or 'on' in failing)
        assert not left or may_stay or left == ['checkpoint.lock'], f'{where} {left}'
        for name in left:
            del files[name]
        if done.status == 0:
            assert files == self.after, where
            assert not failed or failing.get('error') == 0 or self.may_fail(failed, done.output), where
        else:
            assert done.status == 1 and not any(word in done.output for word in CRASHES), where
            if failed:
                assert os.strerror(failing['error']) in done.output, where
                assert 'on' in failing or os.path.basename(target_of(failed.path)) in done.output, where
        for name, (content, _) in files.items():
            assert self.is_whole(name, content), f'{where} {name}'
        if files != self.after:
            repeated = run(folder, self.resuming(files))
            assert (repeated.status, contents(folder)) == (0, self.after), f'{where} {repeated.output}'
        shutil.rmtree(folder)

    def fail_each(self, each):
        """Calls fail() with each of these, two at a time."""
        with ThreadPoolExecutor(2) as pool:
            for _ in pool.map(lambda failing: self.fail(**failing), each):
                pass

    def goes_on_from(self, state):
        """Runs the command from a state of the disk, as after a crash. Returns the contents of the files."""
        folder = self.runner.path('state')
        os.mkdir(folder)
        for name, content in state.items():
            with open(os.path.join(folder, name), 'wb') as stream:
                stream.write(content)
        done = run(folder, self.resuming(state))
        assert done.status == 0, done.output
        files = {name: content for name, (content, _) in contents(folder).items()}
        shutil.rmtree(folder)
        return files

    def resuming(self, files):
        """Returns the command that goes on from what there is."""
        return [*(word for word in self.command if word != '--resume'), *['--resume'] * ('checkpoint' in files)]

    def may_fail(self, call, output):
        """Whether a program may succeed without a call: nothing that is to be written is lost. What a program appends
        may be written when the file is closed."""
        if call.kind == 'close' and call.path in self.growing:
            return False
        return (call.kind not in NEEDED or call.path.endswith('.lock') or
                ('train: checkpoint: ' in output and '; the training goes on' in output))

    def is_whole(self, name, content):
        """Whether this is what a file was before, or a new version, complete unless the program appends to it."""
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
    case.write('config.yaml', config_text('walk.yaml', 2))
    case.write('walk.yaml', TRAINED)
    case.write('table', read_bytes(NEAREST_TABLE))
    return case


@pytest.fixture
def resume(runner, train):
    """A training of which one of two episodes is done."""
    done = run(train.first, [*train.command, '--episodes', '1'])
    assert done.status == 0, done.output
    train.command.append('--resume')
    return train


@pytest.fixture
def evaluate(runner):
    """An evaluation of robots and people on a map, with all files."""
    case = Case(runner, EVALUATE, ['record', 'robots', 'goals', 'jsonl', 'paths/hall.csv', 'states/hall.csv',
                                   'scenes/hall.yaml', 'series/hall.csv'])
    case.write('given', read_bytes(NEAREST_TABLE))
    case.write('hall.yaml', SCENE)
    case.write('map.yaml', MAP)
    case.write('map.pgm', b'P5 8 8 255\n' + b'\xff' * 64)
    case.write('csv', 'something else')
    return case


@pytest.fixture
def score(runner):
    """A log of a robot from which metrics are computed."""
    case = Case(runner, SCORE)
    case.write('given.jsonl', LOG)
    case.write('csv', 'something else')
    return case


@pytest.fixture
def convert(runner):
    """A script that replaces its output."""
    case = Case(runner, CONVERT)
    case.write('given.csv', 'instance,tick,agent,x,y\n0,0,0,1,2\n0,1,0,1,2\n')
    case.write('converted.txt', 'something else')
    return case


class CallsTest:
    """The program succeeds, or ends with an error that names file and reason; files are old or new."""

    @pytest.mark.parametrize('name', ['train', 'resume', 'evaluate', 'score', 'convert'])
    def test_each_call(self, request, name):
        """Each one fails, each read or write is done by half, and all fail from one on."""
        case = request.getfixturevalue(name)
        calls = case.finish().calls
        failing = [{'fail': number, 'error': REASONS[number % 3]} for number in range(1, len(calls) + 1)]
        failing += [{'fail': number, 'error': 0} for number, call in enumerate(calls, 1)
                    if call.kind in ('read', 'write')]
        failing += [{'on': 1, 'fail': number, 'error': errno.EIO} for number in range(1, len(calls) + 1, 5)]
        case.fail_each(failing)

    @pytest.mark.parametrize('name', ['train', 'resume', 'score'])
    def test_allocations(self, request, name):
        """Some at equal distances, and all from one on. There are no meshes: Recast crashes if its allocations fail."""
        case = request.getfixturevalue(name)
        count = case.finish().allocations
        numbers = range(1, count + 1, count // ALLOCATIONS)
        case.fail_each([{'allocation': number} for number in numbers])
        case.fail_each([{'on': 1, 'allocation': number} for number in numbers[::3]])


class PowerLossTest:
    """At any time there is the old table or a new one, and the training goes on from its checkpoint."""

    def test_training(self, train):
        calls = train.finish().calls
        before, after = ({name: content for name, (content, _) in files.items()}
                         for files in (train.before, train.after))
        versions = {name: {before.get(name), *train.versions[name]} for name in train.versions}

        def problems(state):
            """Returns the names of files that are neither old nor new, or of which a checkpoint has counted more."""
            bad = [name for name, known in versions.items() if state.get(name) not in known]
            for name, size in re.findall(rb'^--(\w+) (\d+)$', state.get('checkpoint', b''), re.MULTILINE):
                content = state.get(name.decode(), b'')
                if len(content) < int(size) or content[:int(size)] != after[name.decode()][:int(size)]:
                    bad.append(name.decode())
            return bad

        states = list(states_after(before, calls))
        assert len(states) > 100
        for state in states:
            assert not problems(state), problems(state)
        for state in states[::len(states) // RESUMED]:
            assert train.goes_on_from(state) == after
        # Without the calls that flush, there would be neither.
        unsafe = [call for call in calls if call.kind != 'fsync']
        found = {name for state in states_after(before, unsafe) for name in problems(state)}
        assert found == {*versions, 'record', 'log'}
