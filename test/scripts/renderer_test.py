"""The `rviz` of the tests, which starts RViz again if Mesa's software renderer crashes at its start."""
import os
import subprocess

import pytest
from programs import PATIENCE, read_text
from renderer import is_crash, variables

CRASH = 'rviz[%s]: segfault at 7f7efa689fb0 ip 00007f7ef901f77e sp 00007ffc94cce940 error 4 in %s[61f77e,7f7ef8a90000]'
RVIZ = '#!/bin/bash\necho $$ $* >> starts\n'
# The last start is the one that crashed.
KERNEL_LOG = f"#!/bin/bash\nprintf '{CRASH}\\n' $(tail -n 1 starts | cut -d ' ' -f 1) "


@pytest.fixture(name='start')
def make_start(tmp_path):
    """Starts the `rviz` of the tests with substitutes for RViz and for the kernel's log."""
    def write(name, text):
        (tmp_path / name).write_text(text, encoding='utf-8')
        (tmp_path / name).chmod(0o755)

    def start(end, library):
        write('rviz', RVIZ + end)
        write('dmesg', KERNEL_LOG + library)
        path = variables()['PATH'].replace(os.pathsep, f'{os.pathsep}{tmp_path}{os.pathsep}', 1)
        done = subprocess.run(['rviz', '-d', 'some.rviz'], cwd=tmp_path, env=dict(os.environ, PATH=path),
                              stderr=subprocess.PIPE, timeout=PATIENCE, check=False)
        starts = read_text(tmp_path / 'starts').splitlines()
        assert all(line.endswith(' -d some.rviz') for line in starts)
        return done.returncode, len(starts), done.stderr.decode()
    return start


class RendererTest:
    """When RViz is started again."""

    def test_crash_in_the_renderer(self, start):
        status, starts, errors = start('[[ $(wc -l < starts) -gt 1 ]] || kill -SEGV $$', 'swrast_dri.so')
        assert (status, starts) == (0, 2)
        assert 'RViz is started again' in errors

    def test_two_crashes_in_the_renderer(self, start):
        assert start('kill -SEGV $$', 'swrast_dri.so')[:2] == (139, 2)

    def test_crash_elsewhere(self, start):
        assert start('kill -SEGV $$', 'libsocial_crowd_rviz.so')[:2] == (139, 1)

    @pytest.mark.parametrize('end, status', [('exit 0', 0), ('exit 3', 3), ('kill -ABRT $$', 134)])
    def test_other_ends(self, start, end, status):
        assert start(end, 'swrast_dri.so')[:2] == (status, 1)

    def test_crash_of_another_process(self):
        assert is_crash(CRASH % (17985, 'swrast_dri.so'), 17985)
        assert not is_crash(CRASH % (17985, 'swrast_dri.so'), 7985)
