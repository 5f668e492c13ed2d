"""Valgrind's callgrind, which counts instructions."""
import shutil

from crowd_experiments.runs import RunError

# Counts instructions within the functions of --toggle-collect= and the functions that they call.
COLLECT = ['valgrind', '--tool=callgrind', '--collect-atstart=no', '--quiet']


def has_valgrind():
    return shutil.which('valgrind') is not None


def require_valgrind():
    if not has_valgrind():
        raise RunError('there is no valgrind, see scripts/install_dependencies')
