"""Scripts find train and evaluate, and build them only where that is needed."""
import os
import pathlib
import shutil
import subprocess

import pytest
from crowd_experiments import tools
from programs import in_package


@pytest.fixture
def clone(tmp_path, monkeypatch):
    """A clone without a build folder; scripts/build writes the file `built` and the programs."""
    for name in tools.SOURCES:
        path = tmp_path / name
        if '.' in name:
            path.write_text('', encoding='utf-8')
        else:
            path.mkdir()
    (tmp_path / 'scripts').mkdir()
    script = tmp_path / 'scripts' / 'build'
    script.write_text(f'#!/bin/sh\necho done >> {tmp_path}/built\n', encoding='utf-8')
    script.chmod(0o755)
    monkeypatch.setattr(tools, 'REPOSITORY', tmp_path)
    monkeypatch.delenv('SOCIAL_CROWD_BUILD', raising=False)
    monkeypatch.delenv('CMAKE_PREFIX_PATH', raising=False)
    return tmp_path


def make_programs(prefix):
    """Makes programs in a devel folder. Returns their folder."""
    folder = tools.programs_in(prefix)
    folder.mkdir(parents=True)
    for name in tools.TOOLS:
        (folder / name).touch(0o755)
    return folder


def find(clone):
    """Returns the folder of the programs, and how often the package was built."""
    folder = tools.find_tools(None)
    built = clone / 'built'
    return folder, len(built.read_text(encoding='utf-8').splitlines()) if built.exists() else 0


class FindToolsTest:
    """find_tools()."""

    def test_a_clone_is_built_once(self, clone):
        folder, builds = find(clone)
        assert (folder, builds) == (clone / '.build' / 'devel' / 'lib' / 'social_crowd', 1)
        make_programs(clone / '.build' / 'devel')
        (clone / '.build' / tools.BUILT).touch()
        assert find(clone) == (folder, 1)

    def test_a_changed_source_is_built(self, clone):
        make_programs(clone / '.build' / 'devel')
        (clone / '.build' / tools.BUILT).touch()
        source = clone / 'src' / 'new.cpp'
        source.touch()
        later = os.stat(clone / '.build' / tools.BUILT).st_mtime + 1
        os.utime(source, (later, later))
        assert find(clone)[1] == 1

    def test_a_source_that_was_changed_during_the_build(self, clone):
        """scripts/build leaves the time at which it began."""
        shutil.copy(in_package('scripts', 'build'), clone / 'scripts')
        source = clone / 'src' / 'new.cpp'
        steps = {'cmake': f'[ "$1" != --build ] || touch {source}', '../scripts/install_dependencies': ':'}
        for name, text in steps.items():
            program = clone / 'bin' / name
            program.parent.mkdir(exist_ok=True)
            program.write_text(f'#!/bin/sh\n{text}\n', encoding='utf-8')
            program.chmod(0o755)
        build = clone / 'scripts' / 'build'
        # The script puts Debian's programs first.
        build.write_text(build.read_text(encoding='utf-8').replace('PATH=/usr/bin:', f'PATH={clone}/bin:/usr/bin:'),
                         encoding='utf-8')
        subprocess.run([build], check=True, timeout=30)
        assert (clone / '.build' / tools.BUILT).exists()
        assert not tools.is_current(clone / '.build')
        source.unlink()
        later = os.stat(clone / 'src').st_mtime + 1
        os.utime(clone / '.build' / tools.BUILT, (later, later))
        assert tools.is_current(clone / '.build')

    def test_a_link_to_nothing(self, clone):
        """Editors lock files with such links."""
        make_programs(clone / '.build' / 'devel')
        (clone / 'src' / '.#a.cpp').symlink_to('user@machine')
        (clone / '.build' / tools.BUILT).touch()
        assert find(clone)[1] == 0

    def test_a_sourced_workspace_is_not_built_again(self, clone, monkeypatch):
        devel = pathlib.Path(clone, 'workspace', 'devel')
        folder = make_programs(devel)
        (devel / '.catkin').write_text(f'/elsewhere;{clone.parent}', encoding='utf-8')
        monkeypatch.setenv('CMAKE_PREFIX_PATH', f'/nowhere:{devel}')
        assert find(clone) == (folder, 0)

    def test_a_workspace_with_another_copy(self, clone, monkeypatch):
        """Its programs are not those of this clone."""
        devel = pathlib.Path(clone, 'workspace', 'devel')
        make_programs(devel)
        (devel / '.catkin').write_text('/elsewhere', encoding='utf-8')
        monkeypatch.setenv('CMAKE_PREFIX_PATH', str(devel))
        assert find(clone)[1] == 1
