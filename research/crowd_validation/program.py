"""The command line of research/validate."""
import argparse
import pathlib
import signal
import sys
import time

from crowd_experiments.pages import Chapter, fill_document
from crowd_experiments.arguments import positive
from crowd_experiments.interruption import EXIT_FAILED, EXIT_FINE, EXIT_INTERRUPTED, interrupt
from crowd_experiments.tools import find_config, find_tools
from crowd_experiments.progress import text_of
from crowd_experiments.runs import RunError

from . import cases
from .case import load, store
from .evaluation import Evaluation

HEADER = ['case', 'title', 'measured', 'expected', 'passed']
EXIT_USAGE = 2
EXAMPLES = '''examples:
  research/validate --list                                 the cases
  research/validate                                        all cases, with three seeds each
  research/validate rimea_1 rimea_6 --seeds 2              two cases
  research/validate --table                                the table of the results so far, without running anything
  research/validate --document research/docs/validation.md  all cases; updates the table and the pictures of the page
  research/validate --q-table my_table.txt --output mine   with another Q-table

A case generates its scenario files, runs `evaluate` once for each seed, measures the trajectories, and stores its
result and pictures in the output folder. Completed runs are kept unless the program, the Q-table or their scenario has
changed. Ctrl-C keeps the finished runs; the same command continues from there.

Exit status: 0 all chosen cases were run (passed or not), 1 a run failed, 2 wrong usage, 130 interrupted.'''


def parser():
    """Returns the parser of the command line."""
    found = argparse.ArgumentParser(
        prog='validate', formatter_class=argparse.RawDescriptionHelpFormatter, epilog=EXAMPLES,
        description="Runs the field's standard tests of pedestrian models with a learned crowd, and prints a table: "
                    'what was\nmeasured, what the guideline expects, and whether the test is passed.')
    found.add_argument('cases', nargs='*', metavar='CASE', help='names of cases, see --list (default: all)')
    found.add_argument('--list', action='store_true', help='list the cases, and those left out with the reason')
    found.add_argument('--table', action='store_true', help='print the table of stored results; runs nothing')
    found.add_argument('--seeds', type=positive, default=3, metavar='N', help='number of seeds (default: %(default)s)')
    found.add_argument('--output', type=pathlib.Path, default=pathlib.Path('validation'), metavar='FOLDER',
                       help='folder of scenarios, trajectories, results and pictures (default: %(default)s)')
    found.add_argument('--document', type=pathlib.Path, metavar='FILE.md',
                       help='also update the table of this document, and its pictures in images/')
    found.add_argument('--q-table', type=pathlib.Path, metavar='FILE', help='Q-table (default: anticipation)')
    found.add_argument('--processes', type=positive, default=1, metavar='N',
                       help='number of parallel runs (default: %(default)s)')
    found.add_argument('--tools', type=pathlib.Path, metavar='FOLDER',
                       help='folder of train and evaluate (default: the folder of this program; if they are not there, '
                            'the package is built)')
    return found


def main(words=None):
    """Runs the program with command line words. Returns the exit status."""
    arguments = parser().parse_args(words)
    signal.signal(signal.SIGTERM, interrupt)
    names = [case.name for case in cases.ALL]
    for name in arguments.cases:
        if name not in names:
            reason = f': {cases.LEFT_OUT[name]}' if name in cases.LEFT_OUT else ''
            print(f"validate: no case '{name}'{reason}; there are {', '.join(names)}", file=sys.stderr)
            return EXIT_USAGE
    if arguments.list:
        list_cases()
        return EXIT_FINE
    chosen = [case for case in cases.ALL if case.name in arguments.cases or not arguments.cases]
    output = arguments.output.absolute()
    try:
        failed = [] if arguments.table else run_cases(chosen, arguments, output)
        report(output, [case.name for case in chosen if case.name not in failed], arguments.document)
    except KeyboardInterrupt:
        print(f'Interrupted; the finished runs are kept in {output}, and the same command continues from there.')
        return EXIT_INTERRUPTED
    except (RunError, OSError) as error:
        print(f'validate: {error}', file=sys.stderr)
        return EXIT_FAILED
    return EXIT_FAILED if failed else EXIT_FINE


def list_cases():
    """Prints the cases and the cases that are left out."""
    for case in cases.ALL:
        print(f'{case.name:10} {case.title}')
    for name, reason in cases.LEFT_OUT.items():
        print(f'{name:10} left out: {reason}')


def run_cases(chosen, arguments, output):
    """Runs the cases one after the other, and stores their results. Returns the names of cases that could not be
    run."""
    q_table = (arguments.q_table or find_config() / 'q_tables' / 'anticipation.txt').absolute()
    if not q_table.is_file():
        raise RunError(f'{q_table}: there is no such Q-table')
    evaluate = find_tools(arguments.tools) / 'evaluate'
    failed = []
    for number, case in enumerate(chosen, 1):
        print(f'[{number}/{len(chosen)}] {case.name}: {case.title}', file=sys.stderr, flush=True)
        start = time.monotonic()
        folder = output / case.name
        folder.mkdir(parents=True, exist_ok=True)
        try:
            result = case.run(Evaluation(evaluate, q_table, folder, arguments.seeds, arguments.processes))
        except RunError as error:
            print(f'validate: {case.name}: {error}', file=sys.stderr)
            failed.append(case.name)
            continue
        store(folder, result, arguments.seeds)
        print(f'    passed: {result.verdict()}, took {text_of(time.monotonic() - start)}', file=sys.stderr, flush=True)
    return failed


def report(output, chosen, document):
    """Prints the table of the chosen cases, and updates the document with all stored results."""
    chapter = chapter_of(output, [case.name for case in cases.ALL])
    table = chapter_of(output, chosen).tables()
    if not table:
        raise RunError(f'{output}: has no results of the chosen cases')
    for part in table:
        part.print()
    if document:
        for message in fill_document(document, [chapter]):
            print(message)


def chapter_of(output, names):
    """Returns the stored results of these cases: a table of results, a table of remarks and pictures. Cases without
    a stored result are skipped."""
    stored = [(case, load(output / case.name)) for case in cases.ALL if case.name in names]
    rows, remarks, seeds = [], [], set()
    chapter = Chapter('validation', 'Validation')
    for case, found in stored:
        if found is None:
            continue
        result, number = found
        seeds.add(number)
        rows.append([case.name, case.title, result.measured, result.expected, result.verdict()])
        if result.remarks:
            remarks.append([case.name, result.remarks])
        for picture in result.pictures:
            chapter.add_figure(picture, case.title)
    if rows:
        numbers = ' or '.join(map(str, sorted(seeds)))
        chapter.add_table(f'Results: means over {numbers} seeds (lowest-highest)', HEADER, rows, 'results')
    if remarks:
        chapter.add_table('Remarks', ['case', 'remark'], remarks, 'remarks')
    return chapter
