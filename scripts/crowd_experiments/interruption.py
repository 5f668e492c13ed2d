"""Ends programs on Ctrl-C with a message in place of a traceback."""
import importlib
import signal
import sys

EXIT_INTERRUPTED = 130


def interrupt(_signal, _frame):
    """Handles SIGTERM as Ctrl-C."""
    raise KeyboardInterrupt


def run_program(name, module):
    """Runs main() of a module, whose import can be interrupted, too. Returns its exit status; 130 if interrupted."""
    try:
        signal.signal(signal.SIGTERM, interrupt)
        return importlib.import_module(module).main()
    except KeyboardInterrupt:
        print(f'{name}: interrupted', file=sys.stderr)
        return EXIT_INTERRUPTED
