"""The command line of research/validate."""
import pathlib
import sys
import time

from crowd_experiments.arguments import add_file, add_tools, parser_of, positive
from crowd_experiments.interruption import EXIT_FAILED, EXIT_FINE, EXIT_INTERRUPTED, EXIT_USAGE
from crowd_experiments.pages import Chapter, fill_document
from crowd_experiments.runs import RunError, text_of
from crowd_experiments.tools import find_evaluation

from .crowds import rimea_10, rimea_11, rimea_12, rimea_14, rimea_15, rimea_9
from .evaluation import Case, Evaluation, load, store
from .movement import rimea_1, rimea_5, rimea_6, rimea_7
from .sweeps import sweep_corridors, sweep_densities, sweep_doors, sweep_radii

# In the order of the table. A new case is a function of an Evaluation that returns a Result, and a line here.
ALL = [Case(run.__name__, title, run) for title, run in (
    ('Walking speed in a corridor', rimea_1), ('Reaction times', rimea_5), ('Movement around a corner', rimea_6),
    ('Walking speeds by age', rimea_7), ('A crowd leaves a large room', rimea_9), ('Assigned exits', rimea_10),
    ('Choice of the exit', rimea_11), ('Two bottlenecks in a row', rimea_12), ('A short and a long way', rimea_14),
    ('A large crowd around a corner', rimea_15),
    ('Doors of all widths', sweep_doors), ('Corridors of all widths', sweep_corridors),
    ('Densities', sweep_densities), ('Sizes of people', sweep_radii))]
# Cases of the guideline that are not here, and why.
LEFT_OUT = {
    'rimea_2': 'walking up stairs: the floor is plane',
    'rimea_3': 'walking down stairs: the floor is plane',
    'rimea_4': 'the fundamental diagram is measured by a case of its own',
    'rimea_8': 'a parameter study in a building of several floors',
    'rimea_13': 'fundamental diagram on stairs: the floor is plane',
}
HEADER = ['case', 'title', 'measured', 'expected', 'passed']
DESCRIPTION = '''Runs the field's standard tests of pedestrian models with a learned crowd, and prints a table: what was
measured, what the guideline expects, and whether the test is passed.'''
EXAMPLES = '''examples:
  research/validate --list                                 the cases
  research/validate                                        all cases, with three seeds each
  research/validate rimea_1 rimea_6 --seeds 2              two cases
  research/validate --table                                the table of the results so far, without running anything
  research/validate --document research/docs/validation.md  all cases; updates the table and the pictures of the page
  research/validate --q-table my_table.txt --output mine   with another Q-table

A case generates its scenario files, runs `evaluate` once for each seed, measures the trajectories, and stores its
result and pictures in the output folder. Completed runs are kept unless the program, the Q-table or their scenario has
changed. Ctrl-C keeps the finished runs; the same command continues from there.'''


def main(words=None):
    parser = parser_of('validate', DESCRIPTION, EXAMPLES, '0 all chosen cases were run (passed or not), 1 a run '
                       'failed, 2 wrong usage, 130 interrupted.')
    parser.add_argument('cases', nargs='*', metavar='CASE', help='names of cases, see --list (default: all)')
    parser.add_argument('--list', action='store_true', help='list the cases, and those left out with the reason')
    parser.add_argument('--table', action='store_true', help='print the table of stored results; runs nothing')
    parser.add_argument('--seeds', type=positive, default=3, metavar='N', help='number of seeds (default: %(default)s)')
    add_file(parser, '--output', default=pathlib.Path('validation'), metavar='FOLDER',
             help='folder of scenarios, trajectories, results and pictures (default: %(default)s)')
    add_file(parser, '--document', metavar='FILE.md',
             help='also update the table of this document, and its pictures in images/')
    add_file(parser, '--q-table', help='Q-table (default: anticipation)')
    parser.add_argument('--processes', type=positive, default=1, metavar='N',
                        help='number of parallel runs (default: %(default)s)')
    add_tools(parser)
    arguments = parser.parse_args(words)
    names = [case.name for case in ALL]
    for name in (name for name in arguments.cases if name not in names):
        reason = f': {LEFT_OUT[name]}' if name in LEFT_OUT else ''
        print(f"validate: no case '{name}'{reason}; there are {', '.join(names)}", file=sys.stderr)
        return EXIT_USAGE
    if arguments.list:
        print('\n'.join([*(f'{case.name:15} {case.title}' for case in ALL),
                         *(f'{name:15} left out: {reason}' for name, reason in LEFT_OUT.items())]))
        return EXIT_FINE
    chosen = [case for case in ALL if case.name in arguments.cases or not arguments.cases]
    output = arguments.output.absolute()
    try:
        failed = [] if arguments.table else run_cases(chosen, arguments, output)
    except KeyboardInterrupt:
        print(f'Interrupted; the finished runs are kept in {output}, and the same command continues from there.')
        return EXIT_INTERRUPTED
    report(output, [case.name for case in chosen if case.name not in failed], arguments.document)
    return EXIT_FAILED if failed else EXIT_FINE


def run_cases(chosen, arguments, output):
    """Runs the cases, and stores their results. Returns the names of cases that could not be run."""
    evaluate, q_table = find_evaluation(arguments)
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
    tables = chapter_of(output, chosen).tables()
    if not tables:
        raise RunError(f'{output}: has no results of the chosen cases')
    for table in tables:
        table.print()
    if document:
        print('\n'.join(fill_document(document, [chapter_of(output, [case.name for case in ALL])])))


def chapter_of(output, names):
    """Returns tables and pictures of the stored results of these cases."""
    stored = [(case, load(output / case.name)) for case in ALL if case.name in names]
    stored = [(case, *found) for case, found in stored if found]
    chapter = Chapter('validation', 'Validation')
    for case, result, _ in stored:
        for picture in result.pictures:
            chapter.add_figure(picture, case.title)
    if stored:
        numbers = ' or '.join(map(str, sorted({seeds for _, _, seeds in stored})))
        chapter.add_table(f'Results: means over {numbers} seeds (lowest-highest)', HEADER, [
            [case.name, case.title, result.measured, result.expected, result.verdict()] for case, result, _ in stored],
            'results')
    remarks = [[case.name, result.remarks] for case, result, _ in stored if result.remarks]
    if remarks:
        chapter.add_table('Remarks', ['case', 'remark'], remarks, 'remarks')
    return chapter
