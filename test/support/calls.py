"""Programs whose calls for files, or allocations, fail (failing_calls.cpp)."""
import collections
import os
import re
import subprocess

from programs import PATIENCE, read_text, tools_folder

LIBRARY = os.path.join(tools_folder(), 'libfailing_calls.so')
TEMPORARY = re.compile(r'\.social_crowd\.tmp[a-z0-9]{8}|^\.|\.part$|\.lock$| \(deleted\)$')

Call = collections.namedtuple('Call', 'kind path other data')
Done = collections.namedtuple('Done', 'status output calls allocations')


def run(folder, command, **failing):
    """Runs a command in a folder, given what is to fail by the names of variables without 'CALLS_'. Returns a Done,
    with paths from the folder on."""
    log = f'{folder}.calls'
    variables = {'folder': folder, 'log': log, **failing}
    environment = {**os.environ, 'LC_ALL': 'C', 'LD_PRELOAD': LIBRARY,
                   **{f'CALLS_{name.upper()}': str(value) for name, value in variables.items()}}
    done = subprocess.run(command, cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, timeout=PATIENCE, check=False)
    lines = [line.replace(folder, '').split('\t') for line in read_text(log).splitlines()]
    os.remove(log)
    calls = [Call(kind, within(path), within(other), bytes.fromhex(data)) for kind, path, other, data in lines]
    ended = calls and calls[-1].kind == 'allocations'  # not if it crashed
    return Done(done.returncode, done.stdout.decode(errors='replace'), calls[:-1] if ended else calls,
                int(calls[-1].other) if ended else None)


def within(path):
    """Returns a path from the folder on; empty for the folder."""
    return path[1:] if path.startswith('/') or path == '.' else path


def target_of(path):
    """Returns the file that a call is for: not the temporary one in its place, nor its lock."""
    return TEMPORARY.sub('', path)


def contents(folder):
    """Returns bytes and mode of all files in a folder by their names."""
    found = {}
    for place, _, names in os.walk(folder):
        for name in names:
            file = os.path.join(place, name)
            with open(file, 'rb') as stream:
                found[os.path.relpath(file, folder)] = stream.read(), os.stat(file).st_mode & 0o777
    return found
