"""Fixtures of the tests of scripts and programs."""
import tempfile

import pytest
from programs import ProgramRunner


def pytest_addoption(parser):
    parser.addoption('--build', help='folder the package was built in; without it, nothing that installs it is tested')


@pytest.fixture
def runner():
    """Runs programs in a folder of the test's own, which goes with the test. A failed test shows what they printed."""
    with tempfile.TemporaryDirectory(prefix='social_crowd_') as folder:
        programs = ProgramRunner(folder)
        yield programs
        problems = programs.clean_up()
        print(programs.outputs())
        assert not problems
