"""Starts a program of this folder; its packages are here and in scripts/."""
import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / 'scripts'))
from crowd_experiments.interruption import start  # noqa: E402,F401
