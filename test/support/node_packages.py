"""Node.js programs of test/web with the packages that they use."""
import pathlib
import shutil
import subprocess

import pytest
from programs import PATIENCE, in_package

CHROMIUM = ('chromium', 'chromium-browser', 'google-chrome')


def install_clients(folder):
    """Copies test/web into a folder and installs its packages there. Skips the test if that is not possible."""
    if shutil.which('npm') is None:
        pytest.skip('npm is not installed')
    for file in pathlib.Path(in_package('test', 'web')).iterdir():
        if file.is_file():
            shutil.copy(file, folder)
    done = subprocess.run(['npm', 'ci', '--no-audit', '--no-fund'], cwd=folder, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, timeout=5 * PATIENCE, check=False)
    if done.returncode != 0:
        pytest.skip(f'npm cannot install the packages of test/web: {done.stdout.decode()[-500:]}')


def find_chromium():
    """Returns the path of Chromium. Skips the test if there is none."""
    for name in CHROMIUM:
        path = shutil.which(name)
        if path is not None:
            return path
    pytest.skip('chromium is not installed')
    return None
