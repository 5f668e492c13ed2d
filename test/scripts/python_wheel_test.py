"""The wheel: what is in it, and its use without ROS. Its C++ module is that of the build: a new one takes minutes."""
import base64
import csv
import hashlib
import io
import os
import pathlib
import subprocess
import sys
import zipfile

import pytest
import social_crowd._core
from programs import PACKAGE

sys.path.append(os.path.join(PACKAGE, 'python', 'wheel'))
import wheel_backend  # noqa: E402

MODULE = pathlib.Path(social_crowd._core.__file__)


@pytest.fixture(name='wheel')
def make_wheel(runner, monkeypatch):
    """A wheel with the module of the build."""
    monkeypatch.setattr(wheel_backend, 'build_module', lambda: [MODULE])
    return runner.path(wheel_backend.build_wheel(runner.folder))


class WheelTest:
    """Content and use of a wheel."""

    def test_content(self, wheel):
        version = wheel_backend.version_of_package()
        assert os.path.basename(wheel) == f'social_crowd-{version}-{wheel_backend.tag_of_python()}.whl'
        with zipfile.ZipFile(wheel) as archive:
            names = archive.namelist()
            info = f'social_crowd-{version}.dist-info'
            assert {f'social_crowd/{MODULE.name}', 'social_crowd/env.py', 'social_crowd/config/scenarios/circle6.yaml',
                    'social_crowd/config/q_tables/anticipation.txt', 'social_crowd/config/maps/office.yaml',
                    f'{info}/METADATA', f'{info}/WHEEL', f'{info}/LICENSE'} <= set(names)
            rows = {row[0]: row[1:] for row in csv.reader(io.StringIO(archive.read(f'{info}/RECORD').decode()))}
            assert set(rows) == set(names)
            for name, (checksum, size) in rows.items():
                if not name.endswith('RECORD'):
                    content = archive.read(name)
                    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).decode().rstrip('=')
                    assert (checksum, int(size)) == (f'sha256={digest}', len(content)), name

    def test_installed(self, runner, wheel):
        """pip installs it, and it is used from there."""
        site = runner.path('site')
        subprocess.run([sys.executable, '-m', 'pip', 'install', '--no-deps', '--no-index', '--target', site, wheel],
                       stdout=subprocess.DEVNULL, check=True)
        code = ('import social_crowd; env = social_crowd.Env("robot_circle_20"); env.reset(seed=1);'
                'env.step((1.0, 0.0)); print(social_crowd.__file__)')
        environment = {'PATH': os.environ['PATH'], 'PYTHONPATH': site,
                       'LD_LIBRARY_PATH': os.environ.get('LD_LIBRARY_PATH', '')}
        said = subprocess.run([sys.executable, '-c', code], env=environment, cwd=runner.folder, stdout=subprocess.PIPE,
                              check=True).stdout.decode()
        assert said.strip() == os.path.join(site, 'social_crowd', '__init__.py')

    def test_the_project_without_ros_can_be_configured(self, runner):
        subprocess.run(['cmake', '-S', os.path.join(PACKAGE, 'python', 'wheel'), '-B', runner.path('build'),
                        f'-DPYTHON_EXECUTABLE={sys.executable}'],
                       env={'PATH': os.environ['PATH']}, stdout=subprocess.DEVNULL, check=True)
