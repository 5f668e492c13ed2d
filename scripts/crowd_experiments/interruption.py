"""Runs the main function of a program: signals, messages of errors, exit statuses."""
import csv
import importlib
import signal
import sys

from crowd_drawing.errors import InputError, problem_of

EXIT_FINE, EXIT_FAILED, EXIT_USAGE, EXIT_INTERRUPTED = 0, 1, 2, 130


def interrupt(_signal, _frame):
    raise KeyboardInterrupt


def run_program(name, module):
    """Runs main() of a module, whose import can be interrupted, too. Returns its exit status."""
    try:
        signal.signal(signal.SIGTERM, interrupt)
        return importlib.import_module(module).main() or EXIT_FINE
    except KeyboardInterrupt as stop:
        print(f'{name}: interrupted{"".join(stop.args)}', file=sys.stderr)
        return EXIT_INTERRUPTED
    except (InputError, OSError, ValueError, csv.Error) as error:
        print(f'{name}: {problem_of(error)}', file=sys.stderr)
        return EXIT_FAILED


def start(name, module):
    """Ends this process with the exit status of run_program()."""
    sys.exit(run_program(name, module))
