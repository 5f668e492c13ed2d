"""Checks the configurations of a sweep before its runs begin."""
import pathlib
import subprocess
import sys
import tempfile

from crowd_drawing.errors import InputError


def check_configurations(sweep, setting, members):
    """Trains one episode with each combination that has runs to do. Raises InputError with the keys of the sweep if a
    configuration is refused."""
    if sweep.config is None:
        return
    first = {member.label: member for member in reversed(members) if not member.run.is_done()}
    with tempfile.TemporaryDirectory(prefix='social_crowd_') as folder:
        for i, (label, member) in enumerate(sorted(first.items(), key=lambda item: members.index(item[1])), 1):
            print(f'sweep: checking configuration {i} of {len(first)}', file=sys.stderr, flush=True)
            config = member.run.commands[0][1]
            command = [setting.tool('train'), config, '--episodes', 1, '--threads', 1, '--output',
                       pathlib.Path(folder, 'table.txt')]
            done = subprocess.run(list(map(str, command)), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                  stderr=subprocess.PIPE, check=False)
            if done.returncode != 0:
                message = done.stderr.decode(errors='replace').strip().splitlines()[-1:] or ['no message']
                cause = message[0].replace('train: ', '', 1).replace(f'{config}: ', '', 1)
                raise InputError(f'{sweep.file}: {label}: the configuration is refused: {cause}')
