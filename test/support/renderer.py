"""Mesa's software renderer, which crashes at some starts of RViz: how tests use it, and how a crash in it is known."""
import os
import re
import signal
import subprocess
import time

WRAPPERS = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'wrappers')  # has an `rviz` that starts it again
DRIVER = 'swrast_dri.so'
START = 30.0  # [s]; a later crash is no crash of a start
RESTARTED = "Mesa's software renderer has crashed; RViz is started again"  # for the output of tests
LOG_DELAY = 0.2  # [s] for the kernel to write its log


def variables():
    """Returns the environment in which programs draw in software, with an `rviz` that starts again after a crash."""
    # One thread: RViz crashed in a thread of Mesa's renderer.
    return {'LIBGL_ALWAYS_SOFTWARE': '1', 'LP_NUM_THREADS': '0', 'PATH': WRAPPERS + os.pathsep + os.environ['PATH']}


def is_crash(kernel_log, pid):
    """Returns whether a process crashed in the renderer, by a text of the kernel's log."""
    return re.search(rf'\[{pid}\]: segfault at .* in {re.escape(DRIVER)}\[', kernel_log) is not None


def kernel_log():
    """Returns the kernel's log; nothing if this user may not read it."""
    done = subprocess.run(['dmesg'], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=False)
    return done.stdout.decode(errors='replace')


def crashed_at_start(process, since):
    """Returns whether a process that has ended crashed in the renderer while it started.
    @param since its start, of time.monotonic()"""
    if process.returncode != -signal.SIGSEGV or time.monotonic() - since > START:
        return False
    time.sleep(LOG_DELAY)
    return is_crash(kernel_log(), process.pid)
