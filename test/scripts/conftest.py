"""Options and fixtures of the tests of scripts and programs."""
import functools
import signal
import tempfile
import time

import pytest
from network_hosts import Network, why_not
from programs import ProgramRunner

DEADLINE = pytest.StashKey()


def pytest_addoption(parser):
    parser.addoption('--build', help='build folder of the package; without it, installation is not tested')
    parser.addoption('--time-limit', type=float, help='time limit of all tests together [s]; later tests fail')


def pytest_configure(config):
    limit = config.getoption('--time-limit')
    config.stash[DEADLINE] = None if limit is None else time.monotonic() + limit


def fail_out_of_time(_signal, _frame):
    """Ends the current test."""
    pytest.fail('the time limit of all tests is exceeded')


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_call(item):
    deadline = item.config.stash[DEADLINE]
    if deadline is not None:
        signal.signal(signal.SIGALRM, fail_out_of_time)
        signal.setitimer(signal.ITIMER_REAL, max(deadline - time.monotonic(), 0.001))  # 0 would disable the timer
    yield
    signal.setitimer(signal.ITIMER_REAL, 0.0)


@pytest.fixture
def runner():
    """Runs programs in a temporary folder of the test. Their output is shown if the test fails."""
    with tempfile.TemporaryDirectory(prefix='social_crowd_') as folder:
        programs = ProgramRunner(folder)
        yield programs
        problems = programs.clean_up()
        print(programs.outputs(), end='')
        assert not problems


@functools.lru_cache(maxsize=None)
def reason_without_hosts():
    """Returns why there are no hosts in network namespaces here."""
    return why_not()


@pytest.fixture
def network(runner):
    """A switch for hosts in network namespaces. All programs on the hosts have ended when the test ends."""
    if reason_without_hosts():
        pytest.skip(reason_without_hosts())
    with Network({'ROS_HOME': runner.path('ros'), 'ROS_LOG_DIR': runner.path('ros/log')}) as hosts:
        yield hosts
        problems = runner.clean_up()  # before their hosts are removed
        assert not problems
